#include "vtkOversketchCorrection.h"

#include "Silhouette/targets.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

using namespace oversketch;

namespace
{

// A copy of one of the handles' arrays, to be lengthened.
template <class Array>
vtkSmartPointer<Array> Longer(vtkPolyData* handles, const char* name, int components)
{
  vtkDataArray* from = RequireArray(handles->GetPointData(),
    name,
    components,
    handles->GetNumberOfPoints(),
    "handles",
    "vtkOversketchTargets makes it");
  auto copy = vtkSmartPointer<Array>::New();
  copy->DeepCopy(from);
  copy->SetName(name);
  return copy;
}

} // namespace

vtkStandardNewMacro(vtkOversketchCorrection);

vtkOversketchCorrection::vtkOversketchCorrection()
{
  this->SetNumberOfInputPorts(4);
}

void vtkOversketchCorrection::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* handles = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* stroke = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* deformed = vtkPolyData::GetData(inputs[2]);
  vtkPolyData* before = vtkPolyData::GetData(inputs[3]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (deformed->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (before->GetNumberOfPoints() != deformed->GetNumberOfPoints())
  {
    throw Error(Failure::BadMesh,
      "The meshes before and after deforming (ports 3 and 2) differ in their number of points; give the "
      "mesh that vtkOversketchLaplacianDeform read.");
  }
  const View view = ViewOf(stroke);
  const Polyline samples = StrokeOf(stroke);
  const std::shared_ptr<const MeshData> data = SharedMesh(deformed);
  const Mesh& mesh = data->Surface();
  const std::vector<char> chosen = LabelsOf(RequireArray(deformed->GetPointData(),
    "Region",
    1,
    deformed->GetNumberOfPoints(),
    "mesh",
    "vtkOversketchLaplacianDeform passes it on"));
  auto ids = Longer<vtkIdTypeArray>(handles, "HandleId", 1);
  std::vector<Binding> bindings =
    ReadBindings(handles, mesh.vertexCount(), "handles", "vtkOversketchTargets makes it");
  auto targets = Longer<vtkDoubleArray>(handles, "Target", 3);
  auto unmerged = Longer<vtkDoubleArray>(handles, "UnmergedTarget", 3);
  auto relative = Longer<vtkDoubleArray>(handles, "RelativePosition", 1);
  auto ratios = Longer<vtkDoubleArray>(handles, "MergeRatio", 1);

  const std::vector<OutlineCorrection> corrections =
    correctOutline(mesh, chosen, samples, view, this->Omega, this->Tolerance, this->Reach, ContextOf(this));
  if (corrections.empty())
  {
    output->ShallowCopy(handles);
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(handles->GetPoints());
  for (const OutlineCorrection& correction : corrections)
  {
    ids->InsertNextValue(points->InsertNextPoint(before->GetPoint(correction.vertex)));
    bindings.push_back(Binding::vertex(correction.vertex));
    targets->InsertNextTuple(correction.target.data());
    unmerged->InsertNextTuple(correction.target.data());
    relative->InsertNextValue(correction.relative);
    ratios->InsertNextValue(1.0);
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    cells->InsertNextCell(1, &i);
  }
  output->SetPoints(points);
  output->SetVerts(cells);
  output->GetPointData()->AddArray(ids);
  WriteBindings(bindings, output);
  for (vtkDataArray* array : { targets, unmerged, relative, ratios })
  {
    output->GetPointData()->AddArray(array);
  }
  output->GetFieldData()->PassData(handles->GetFieldData());
}

void vtkOversketchCorrection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Omega: " << this->Omega << '\n';
  os << indent << "Tolerance: " << this->Tolerance << '\n';
  os << indent << "Reach: " << this->Reach << '\n';
}
