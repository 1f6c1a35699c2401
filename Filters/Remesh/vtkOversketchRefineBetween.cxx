#include "vtkOversketchRefineBetween.h"

#include "Remesh/refine_between.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

using namespace oversketch;

namespace
{

std::vector<RunOnMesh> readRuns(vtkPolyData* curves, int triangles, const std::string& holder)
{
  const std::string remedy = "take it from vtkOversketchProjectCurve on this mesh";
  if (curves->GetNumberOfLines() != curves->GetNumberOfCells())
  {
    throw Error(
      Failure::BadStroke, "The " + holder + " must be polylines and no other cells: " + remedy + ".");
  }
  vtkDataArray* cells =
    RequireArray(curves->GetPointData(), "MeshCell", 1, curves->GetNumberOfPoints(), holder, remedy);
  std::vector<RunOnMesh> runs;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < curves->GetNumberOfLines(); ++cell)
  {
    curves->GetLines()->GetCellAtId(cell, ids);
    RunOnMesh run;
    for (const vtkIdType id : *ids)
    {
      const double triangle = id >= 0 && id < curves->GetNumberOfPoints() ? cells->GetComponent(id, 0) : -1.0;
      if (!(triangle >= 0.0 && triangle < triangles))
      {
        throw Error(Failure::BadStroke, "Polyline %1 of the %2 leaves the mesh: %3.", cell, holder, remedy);
      }
      run.points.emplace_back(curves->GetPoint(id));
      run.triangles.push_back(static_cast<int>(triangle));
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

void writeRefined(const Refined& refined, vtkPolyData* input, vtkPolyData* output)
{
  const auto mixed = [&](vtkIdType point) -> const Mix&
  { return refined.origins[static_cast<std::size_t>(point)]; };
  WriteCarried(
    refined.mesh, { refined.pointSources, mixed, "Region" }, refined.triangleSources, input, output);
  output->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("EdgeLength", refined.sizes));
}

} // namespace

vtkStandardNewMacro(vtkOversketchRefineBetween);

vtkOversketchRefineBetween::vtkOversketchRefineBetween()
{
  this->SetNumberOfInputPorts(3);
  DeclareInput(this, 1, { Port::Optional });
  DeclareInput(this, 2, { Port::Optional });
}

void vtkOversketchRefineBetween::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* line = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* ring = vtkPolyData::GetData(inputs[2]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const auto isDrawn = [](vtkPolyData* curve) { return curve && curve->GetNumberOfPoints() > 0; };
  if (!(this->Edges > 0.0) || !isDrawn(line) || !isDrawn(ring))
  {
    output->ShallowCopy(mesh);
    return;
  }
  RequirePolygonsOnly(mesh); // the key does not see other cells
  this->Kept<KeptOutput>().Provide(
    StepKey({ WholeKey(mesh), WholeKey(line), WholeKey(ring) }, { this->Edges }),
    output,
    [&](vtkPolyData* result)
    {
      const auto data = SharedMesh(mesh);
      const int triangles = data->Surface().triangleCount();
      const RefineInput input{ data->Surface(),
        readRuns(line, triangles, "reference curve"),
        readRuns(ring, triangles, "boundary curve"),
        this->Edges,
        FieldValue(
          mesh, "MeanEdge", "mesh", "pass the mesh through vtkOversketchMeanEdge when it is loaded") };
      const auto refined = refineBetween(input, ContextOf(this));
      if (refined)
      {
        writeRefined(*refined, mesh, result);
      }
      else
      {
        result->ShallowCopy(mesh);
      }
    });
}

void vtkOversketchRefineBetween::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Edges: " << this->Edges << "\n";
}
