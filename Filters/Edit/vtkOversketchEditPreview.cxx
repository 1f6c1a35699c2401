#include "vtkOversketchEditPreview.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSources.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

namespace oversketch
{

namespace
{

Vector3 TupleOf(vtkDataArray* array, vtkIdType i)
{
  Vector3 value;
  array->GetTuple(i, value.data());
  return value;
}

} // namespace

void EditPreview::Provide(const Weld& welding,
  vtkPolyData* plain,
  vtkPolyData* start,
  vtkPolyData* rest,
  const Context& context)
{
  vtkDataArray* region = rest->GetPointData()->GetArray("EditRegion");
  vtkDataArray* normals = rest->GetPointData()->GetNormals();
  const StepKey key({ MeshKey(rest, { region, normals, rest->GetPointData()->GetArray("Place") }) }, {});
  if (!this->VertexOf.empty() && this->Seen == key)
  {
    return;
  }
  this->VertexOf.clear();
  vtkNew<vtkPolyData> sourced;
  sourced->ShallowCopy(rest);
  AddSources(start, sourced, context);
  vtkNew<vtkPolyData> made;
  const std::vector<int> vertices = welding.Transfer(plain, { sourced.Get() }, made);
  this->Rest->Initialize();
  this->Rest->ShallowCopy(made);
  this->Rest->GetFieldData()->AddArray(rest->GetFieldData()->GetArray("MeanEdge"));
  this->RestNormals = normals;
  this->Live.clear();
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (region->GetComponent(vertices[i], 0) > 0.0)
    {
      this->Live.push_back(static_cast<vtkIdType>(i));
    }
  }
  this->Points = nullptr;
  this->VertexOf = vertices;
  this->Seen = key;
}

void EditPreview::Write(vtkPolyData* moved, vtkPolyData* edited)
{
  vtkDataArray* restNormals = this->Rest->GetPointData()->GetNormals();
  vtkDataArray* now = moved->GetPointData()->GetNormals();
  if (!this->Points || edited->GetPoints() != this->Points ||
      edited->GetPointData()->GetNormals() != this->Normals)
  {
    edited->Initialize();
    edited->ShallowCopy(this->Rest);
    this->Points = vtkSmartPointer<vtkPoints>::New();
    this->Points->SetDataType(this->Rest->GetPoints()->GetDataType());
    this->Points->DeepCopy(this->Rest->GetPoints());
    edited->SetPoints(this->Points);
    if (restNormals)
    {
      this->Normals = vtkSmartPointer<vtkDataArray>::Take(restNormals->NewInstance());
      this->Normals->DeepCopy(restNormals);
    }
    else
    {
      this->Normals = vtkSmartPointer<vtkFloatArray>::New();
      this->Normals->SetName("Normals");
      this->Normals->SetNumberOfComponents(3);
      this->Normals->SetNumberOfTuples(this->Points->GetNumberOfPoints());
      for (std::size_t i = 0; i < this->VertexOf.size(); ++i)
      {
        this->Normals->SetTuple(static_cast<vtkIdType>(i), this->VertexOf[i], this->RestNormals);
      }
    }
    edited->GetPointData()->SetNormals(this->Normals);
  }
  std::vector<char> changed(
    this->Rest->GetCellData()->GetNormals() ? this->VertexOf.size() : std::size_t(0), 0);
  for (const vtkIdType i : this->Live)
  {
    const int vertex = this->VertexOf[static_cast<std::size_t>(i)];
    double place[3];
    moved->GetPoint(vertex, place);
    this->Points->SetPoint(i, place);
    if (!changed.empty())
    {
      const Vector3 rest(this->Rest->GetPoint(i));
      changed[static_cast<std::size_t>(i)] = rest != Vector3(this->Points->GetPoint(i));
    }
    const Vector3 normal = TupleOf(now, vertex), before = TupleOf(this->RestNormals, vertex);
    if (!restNormals)
    {
      this->Normals->SetTuple(i, normal.data());
    }
    else if (normal == before)
    {
      this->Normals->SetTuple(i, i, restNormals);
    }
    else
    {
      this->Normals->SetTuple(i, Turned(TupleOf(restNormals, i), before, normal).normalized().eval().data());
    }
  }
  if (!changed.empty())
  {
    edited->GetCellData()->SetNormals(this->Rest->GetCellData()->GetNormals());
    RefreshCellNormals(edited, changed);
  }
  this->Points->Modified();
  this->Normals->Modified();
  edited->Modified();
}

} // namespace oversketch
