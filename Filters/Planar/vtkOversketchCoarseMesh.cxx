#include "vtkOversketchCoarseMesh.h"

#include "vtkOversketchFilterTools.h"

#include "Planar/coarse_faces.h"
#include "Planar/triangulate.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPlanarTools.h"

#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cmath>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchCoarseMesh);

namespace
{

std::vector<Vector2> dartsOf(vtkPolyData* darts)
{
  std::vector<Vector2> places;
  for (vtkIdType i = 0; darts && i < darts->GetNumberOfPoints(); ++i)
  {
    double place[3];
    darts->GetPoint(i, place);
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
    {
      throw Error(Failure::BadStroke, "Dart %1 is not finite; take the darts from vtkOversketchDarts.", i);
    }
    places.emplace_back(place[0], place[1]);
  }
  return places;
}

} // namespace

vtkOversketchCoarseMesh::vtkOversketchCoarseMesh()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  DeclareInput(this, 1, { Port::Optional });
}

void vtkOversketchCoarseMesh::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* polylines = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* darts = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  std::vector<MeshKey> read{ PlanarKey(polylines) };
  if (darts)
  {
    read.emplace_back(darts);
  }
  vtkPolyData* edges = vtkPolyData::GetData(outputs, 1);
  this->Kept<KeptOutput>().Provide(
    StepKey(read, { static_cast<double>(this->TerminalRule), this->Relax ? 1.0 : 0.0 }),
    { output, edges },
    [&](const KeptOutput::Outputs& results)
    {
      ++this->MeshCount;
      PlanarMesh mesh = triangulate(StrokeLinesOf(polylines), dartsOf(darts), ContextOf(this));
      if (this->TerminalRule != NONE)
      {
        mesh = repairTerminals(mesh,
          this->TerminalRule == TWO_BOUNDARY_EDGES ? oversketch::TerminalRule::TwoBoundaryEdges
                                                   : oversketch::TerminalRule::ThreeBoundaryVertices);
      }
      mesh = this->Relax ? relaxed(mesh) : mesh;
      WritePlanarMesh(mesh, results[0]);
      WriteStrokeEdges(mesh, results[0], results[1]);
    });
  output->GetFieldData()->PassData(polylines->GetFieldData());
  edges->GetFieldData()->PassData(polylines->GetFieldData());
}

void vtkOversketchCoarseMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TerminalRule: " << this->TerminalRule << "\n";
  os << indent << "Relax: " << this->Relax << "\n";
  os << indent << "MeshCount: " << this->MeshCount << "\n";
}
