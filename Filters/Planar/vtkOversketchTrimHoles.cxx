#include "vtkOversketchTrimHoles.h"

#include "Planar/trim.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPlanarTools.h"

#include "vtkFieldData.h"
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

void vtkOversketchTrimHoles::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* faces = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* edges = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* curves = vtkPolyData::GetData(inputs[2]);
  const std::vector<char> gone = regionsInHoles(ClassificationOf(curves), TreatmentsOf(curves));
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  if (std::find(gone.begin(), gone.end(), 1) == gone.end())
  {
    output->ShallowCopy(faces);
    this->GetEdgesOutput()->ShallowCopy(edges);
    return;
  }
  this->Kept<KeptOutput>().Provide(
    StepKey({ PlanarKey(faces), PlanarKey(edges) }, std::vector<double>(gone.begin(), gone.end())),
    { output, this->GetEdgesOutput() },
    [&](const KeptOutput::Outputs& results)
    {
      const PlanarMesh left = withoutRegions(PlanarMeshOf(faces, edges), gone);
      WritePlanarMesh(left, results[0]);
      WriteStrokeEdges(left, results[0], results[1]);
    });
  output->GetFieldData()->PassData(faces->GetFieldData());
  this->GetEdgesOutput()->GetFieldData()->PassData(edges->GetFieldData());
}
