#include "vtkOversketchTargets.h"

#include "Silhouette/targets.h"
#include "vtkOversketchCurveTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace oversketch;

// Keeps the mesh's adjacency between strokes.
struct vtkOversketchTargets::Cache
{
  std::shared_ptr<const MeshData> Data;
};

namespace
{

std::vector<SectionPoint> ReadSection(vtkPolyData* input, const Mesh& mesh, const View& view)
{
  const CurveSet set = ReadCurves(input, mesh.vertexCount(), "section", Unbound::Allowed);
  if (set.Curves.size() != 1 || set.Curves[0].closed)
  {
    throw Error(Failure::BadMesh,
      "The section must be exactly one open polyline; connect the output of vtkOversketchMatch.");
  }
  vtkPointData* pointData = input->GetPointData();
  const auto optional = [&](const char* name)
  {
    return OptionalArray(
      pointData, name, 2, input->GetNumberOfPoints(), "section", "vtkOversketchMatch makes it");
  };
  vtkDataArray* displays = optional("Display");
  vtkDataArray* offsets = optional("Offset");
  vtkNew<vtkIdList> ids;
  input->GetLines()->GetCellAtId(0, ids);
  std::vector<SectionPoint> section;
  for (const CurvePoint& p : set.Curves[0].points)
  {
    SectionPoint q;
    q.binding = p.binding;
    q.position = p.position;
    if (!view.inFront(q.position))
    {
      throw Error(
        Failure::NoMatch, "The section reaches behind the eye of the stroke's view; match the stroke again.");
    }
    const vtkIdType id = ids->GetId(static_cast<vtkIdType>(section.size()));
    if (offsets)
    {
      offsets->GetTuple(id, q.offset.data());
    }
    q.display = view.toDisplay(q.position).head<2>() - q.offset;
    if (displays)
    {
      displays->GetTuple(id, q.display.data());
    }
    if (!q.display.allFinite() || !q.offset.allFinite())
    {
      throw Error(Failure::BadMesh,
        "Array Display or Offset of the section holds a value that is not finite; match the stroke again.");
    }
    section.push_back(q);
  }
  return section;
}

} // namespace

vtkStandardNewMacro(vtkOversketchTargets);

vtkOversketchTargets::vtkOversketchTargets()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(3);
}

vtkOversketchTargets::~vtkOversketchTargets() = default;

void vtkOversketchTargets::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* meshData = vtkPolyData::GetData(inputs[2]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (meshData->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkPolyData* stroke = vtkPolyData::GetData(inputs[1]);
  const View view = ViewOf(stroke);
  const Polyline samples = StrokeOf(stroke);
  this->Internals->Data = SharedMesh(meshData);
  const MeshData& mesh = *this->Internals->Data;
  const std::vector<SectionPoint> section = ReadSection(input, mesh.Surface(), view);
  std::vector<Handle> handles = mapTargets(section, samples, view, this->Omega);
  if (this->SingleLayer)
  {
    handles = keepOneLayer(handles, section, mesh.Surface(), mesh.Neighbours(), view);
    if (handles.size() < 2)
    {
      throw Error(Failure::NoMatch,
        "Fewer than two control points of the section lie on one layer of the mesh; {SingleLayer off} "
        "or draw "
        "along another outline.");
    }
  }

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  const auto handleIds = NewArray<vtkIdTypeArray>("HandleId");
  const auto targets = NewArray<vtkDoubleArray>("Target", 3);
  const auto unmerged = NewArray<vtkDoubleArray>("UnmergedTarget", 3);
  const auto relative = NewArray<vtkDoubleArray>("RelativePosition");
  const auto ratios = NewArray<vtkDoubleArray>("MergeRatio");
  std::vector<Binding> bindings;
  std::vector<Vector3> present, wanted;
  for (const Handle& handle : handles)
  {
    const SectionPoint& q = section[handle.point];
    const vtkIdType id = points->InsertNextPoint(q.position.data());
    vertices->InsertNextCell(1, &id);
    handleIds->InsertNextValue(id);
    bindings.push_back(q.binding);
    targets->InsertNextTuple(handle.target.data());
    unmerged->InsertNextTuple(handle.unmerged.data());
    relative->InsertNextValue(handle.relative);
    ratios->InsertNextValue(oversketch::mergeRatio(handle.relative, this->Omega));
    present.push_back(q.position);
    wanted.push_back(handle.target);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->AddArray(handleIds);
  WriteBindings(bindings, output);
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ targets, unmerged, relative, ratios })
  {
    output->GetPointData()->AddArray(array);
  }
  for (const auto& [name, value] :
    { std::pair("SectionLength", curveLength(present)), std::pair("TargetLength", curveLength(wanted)) })
  {
    output->GetFieldData()->AddArray(OneValue<vtkDoubleArray>(name, value));
  }
}

void vtkOversketchTargets::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Omega: " << this->Omega << '\n';
  os << indent << "SingleLayer: " << (this->SingleLayer ? "on" : "off") << '\n';
}
