#include "vtkOversketchTrimHoles.h"

#include "Planar/trim.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchPlanarTools.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchTrimHoles);

vtkOversketchTrimHoles::vtkOversketchTrimHoles()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

void vtkOversketchTrimHoles::SetEdgesData(vtkPolyData* edges)
{
  this->SetInputData(1, edges);
}

void vtkOversketchTrimHoles::SetCurvesData(vtkPolyData* curves)
{
  this->SetInputData(2, curves);
}

int vtkOversketchTrimHoles::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* faces = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* edges = vtkPolyData::GetData(inputs[1]);
      vtkPolyData* curves = vtkPolyData::GetData(inputs[2]);
      if (faces->GetNumberOfPoints() == 0)
      {
        return;
      }
      const std::vector<char> gone = regionsInHoles(ClassificationOf(curves), TreatmentsOf(curves));
      vtkPolyData* leftFaces = vtkPolyData::GetData(outputs, 0);
      vtkPolyData* leftEdges = vtkPolyData::GetData(outputs, 1);
      if (std::find(gone.begin(), gone.end(), 1) == gone.end())
      {
        leftFaces->ShallowCopy(faces);
        leftEdges->ShallowCopy(edges);
        return;
      }
      const PlanarMesh left = withoutRegions(PlanarMeshOf(faces, edges), gone);
      WritePlanarMesh(left, leftFaces);
      WriteStrokeEdges(left, leftFaces, leftEdges);
      leftFaces->GetFieldData()->PassData(faces->GetFieldData());
      leftEdges->GetFieldData()->PassData(edges->GetFieldData());
    });
}

void vtkOversketchTrimHoles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
