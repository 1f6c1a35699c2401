#include "vtkOversketchTransform.h"

#include "Matrix/pose.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <numeric>
#include <regex>
#include <string>
#include <vector>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchTransform);

namespace
{

constexpr int mostParts = 1000000;

// The number of each face's part; null where the mesh is one.
vtkIntArray* numbersOf(vtkPolyData* mesh)
{
  vtkAbstractArray* array = mesh->GetCellData()->GetAbstractArray("PartId");
  auto* numbers = vtkIntArray::SafeDownCast(array);
  if (array && (!numbers || numbers->GetNumberOfComponents() != 1 ||
                 numbers->GetNumberOfTuples() != mesh->GetNumberOfPolys()))
  {
    throw Error(Failure::BadMesh, "Cell array PartId must hold one int a face.");
  }
  for (vtkIdType f = 0; numbers && f < numbers->GetNumberOfTuples(); ++f)
  {
    if (const int number = numbers->GetValue(f); number < 0 || number > mostParts)
    {
      throw Error(Failure::BadMesh, "Cell array PartId holds %1; parts are counted from 0.", number);
    }
  }
  return numbers;
}

int highestOf(vtkIntArray* numbers)
{
  return numbers && numbers->GetNumberOfTuples() > 0 ? static_cast<int>(numbers->GetRange(0)[1]) : 0;
}

// The things that are placed.
struct Chosen
{
  std::vector<char> points, faces; // 1 where they are
  Eigen::AlignedBox3d box;
};

Chosen chosenOf(vtkPolyData* mesh, vtkIntArray* numbers, int part, const Context& context)
{
  Chosen chosen;
  const vtkIdType count = mesh->GetNumberOfPoints(), faces = mesh->GetNumberOfPolys();
  chosen.points.assign(static_cast<std::size_t>(count), part < 0);
  chosen.faces.assign(static_cast<std::size_t>(faces), part < 0);
  const auto isOf = [&](vtkIdType face)
  { return part < 0 || (numbers ? numbers->GetValue(face) : 0) == part; };
  bool isThere = part < 0;
  for (const bool marks : { true, false }) // its own faces first
  {
    context.checkpoint(marks ? 0.0 : 0.2);
    for (vtkIdType f = 0; f < faces; ++f)
    {
      if (isOf(f) != marks)
      {
        continue;
      }
      isThere = isThere || marks;
      chosen.faces[f] = marks;
      vtkIdType corners = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetPolys()->GetCellAtId(f, corners, ids);
      for (vtkIdType k = 0; k < corners; ++k)
      {
        if (ids[k] < 0 || ids[k] >= count)
        {
          throw Error(Failure::BadMesh, "Face %1 names point %2, and there are %3 points.", f, ids[k], count);
        }
        char& point = chosen.points[ids[k]];
        if (!marks && point)
        {
          throw Error(Failure::BadMesh,
            "Point %1 is of part %2 and of another one, so that neither can be placed alone; place all of "
            "the "
            "mesh, {Part -1}.",
            ids[k],
            part);
        }
        point = point || marks;
      }
    }
  }
  if (!isThere)
  {
    throw Error(Failure::BadMesh,
      "The mesh has no part %1; the highest number is %2, and {Part -1} is all of it.",
      part,
      highestOf(numbers));
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Vector3 place(mesh->GetPoint(i));
    if (chosen.points[i] && !place.allFinite())
    {
      throw Error(Failure::BadMesh, "Point %1 is not finite; repair or remove it.", i);
    }
    if (chosen.points[i])
    {
      chosen.box.extend(place);
    }
  }
  return chosen;
}

bool areNormals(vtkDataArray* normals, std::size_t count)
{
  return normals && normals->GetNumberOfComponents() == 3 &&
         normals->GetNumberOfTuples() == static_cast<vtkIdType>(count);
}

// Changes each chosen tuple of three.
template <typename Change>
void changeTuples(vtkDataArray* tuples,
  const std::vector<char>& chosen,
  const Context& context,
  const Change& change)
{
  context.each(static_cast<int>(chosen.size()),
    [&](int i)
    {
      if (chosen[i])
      {
        Vector3 tuple;
        tuples->GetTuple(i, tuple.data());
        tuple = change(tuple);
        tuples->SetTuple(i, tuple.data());
      }
    });
}

template <typename Change>
void changeNormals(vtkDataSetAttributes* data,
  const std::vector<char>& chosen,
  const Context& context,
  const Change& change)
{
  if (areNormals(data->GetNormals(), chosen.size()))
  {
    const auto normals = vtk::TakeSmartPointer(data->GetNormals()->NewInstance());
    normals->DeepCopy(data->GetNormals());
    changeTuples(normals, chosen, context, change);
    data->SetNormals(normals);
  }
}

void place(vtkPolyData* output, const Chosen& chosen, const Pose& pose, const Context& context)
{
  const Eigen::Affine3d transform = pose.about(chosen.box.center());
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 at = transform * chosen.box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    if (!(at.cwiseAbs().maxCoeff() <= LargestCoordinate))
    {
      throw Error(Failure::BadMesh, "The mesh would lie beyond 1e12; give a smaller {Move} or {Scale}.");
    }
  }
  vtkPoints* before = output->GetPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(before->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT);
  points->DeepCopy(before);
  changeTuples(points->GetData(),
    chosen.points,
    context,
    [&transform](const Vector3& at) -> Vector3 { return transform * at; });
  output->SetPoints(points);
  const Eigen::Matrix3d turn = transform.linear().inverse().transpose();
  const auto turned = [&turn](const Vector3& normal) -> Vector3 { return (turn * normal).normalized(); };
  changeNormals(output->GetPointData(), chosen.points, context, turned);
  changeNormals(output->GetCellData(), chosen.faces, context, turned);
}

// All elements in their order, then the chosen ones once more.
std::vector<vtkIdType> repeated(const std::vector<char>& chosen)
{
  std::vector<vtkIdType> sources(chosen.size());
  std::iota(sources.begin(), sources.end(), vtkIdType{ 0 });
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    if (chosen[i])
    {
      sources.push_back(static_cast<vtkIdType>(i));
    }
  }
  return sources;
}

// Marks of those that are there once more.
std::vector<char> copiesOf(const std::vector<char>& chosen, std::size_t count)
{
  std::vector<char> copies(count, 1);
  std::fill_n(copies.begin(), chosen.size(), char{ 0 });
  return copies;
}

// The copied faces the other way round, from the same corner on.
vtkSmartPointer<vtkCellArray> withReversed(vtkCellArray* polys,
  const std::vector<vtkIdType>& points,
  const std::vector<vtkIdType>& faces,
  std::size_t pointCount)
{
  std::vector<vtkIdType> copy(pointCount, 0);
  for (std::size_t i = pointCount; i < points.size(); ++i)
  {
    copy[points[i]] = static_cast<vtkIdType>(i);
  }
  auto all = vtkSmartPointer<vtkCellArray>::New();
  all->DeepCopy(polys);
  for (std::size_t i = polys->GetNumberOfCells(); i < faces.size(); ++i)
  {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    polys->GetCellAtId(faces[i], corners, ids);
    all->InsertNextCell(static_cast<int>(corners));
    for (vtkIdType k = 0; k < corners; ++k)
    {
      all->InsertCellPoint(copy[ids[(corners - k) % corners]]);
    }
  }
  return all;
}

// Field arrays of parts, such as Part0.Texture, once more under the numbers of their copies.
void repeatFields(vtkFieldData* fields, int part, int first)
{
  static const std::regex ofPart("Part(\\d{1,6})\\.(.*)");
  for (int i = fields->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    vtkAbstractArray* array = fields->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    std::smatch match;
    if (std::regex_match(name, match, ofPart) && (part < 0 || std::stoi(match[1]) == part))
    {
      const auto copy = vtk::TakeSmartPointer(array->NewInstance());
      copy->DeepCopy(array);
      copy->SetName(
        ("Part" + std::to_string(first + (part < 0 ? std::stoi(match[1]) : 0)) + "." + match[2].str())
          .c_str());
      fields->AddArray(copy);
    }
  }
}

void addMirrored(vtkPolyData* output,
  const Chosen& chosen,
  int part,
  int axis,
  double offset,
  const Context& context)
{
  vtkIntArray* numbers = numbersOf(output);
  const int first = highestOf(numbers) + 1;
  const std::vector<vtkIdType> points = repeated(chosen.points), faces = repeated(chosen.faces);
  vtkNew<vtkPolyData> all;
  vtkNew<vtkPoints> places;
  places->SetData(CarriedArray(output->GetPoints()->GetData(), points));
  all->SetPoints(places);
  all->SetPolys(withReversed(output->GetPolys(), points, faces, chosen.points.size()));
  CopyElements(output->GetPointData(), points, all->GetPointData());
  CopyElements(output->GetCellData(), faces, all->GetCellData());
  context.checkpoint(0.7);
  const std::vector<char> newPoints = copiesOf(chosen.points, points.size()),
                          newFaces = copiesOf(chosen.faces, faces.size());
  changeTuples(places->GetData(),
    newPoints,
    context,
    [=](Vector3 at)
    {
      at[axis] = 2.0 * offset - at[axis];
      return at;
    });
  const auto mirrored = [=](Vector3 normal)
  {
    normal[axis] = -normal[axis];
    return normal;
  };
  changeNormals(all->GetPointData(), newPoints, context, mirrored);
  changeNormals(all->GetCellData(), newFaces, context, mirrored);
  const auto parts = NewArray<vtkIntArray>("PartId", 1, faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const int own = numbers ? numbers->GetValue(faces[f]) : 0;
    parts->SetValue(static_cast<vtkIdType>(f), !newFaces[f] ? own : first + (part < 0 ? own : 0));
  }
  all->GetCellData()->AddArray(parts);
  all->GetFieldData()->ShallowCopy(output->GetFieldData());
  repeatFields(all->GetFieldData(), part, first);
  output->ShallowCopy(all);
}

} // namespace

vtkOversketchTransform::vtkOversketchTransform() = default;

vtkOversketchTransform::~vtkOversketchTransform() = default;

void vtkOversketchTransform::RequireValues()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    RequireFinite(this->Move[axis], "Move");
    RequireFinite(this->Turn[axis], "Turn");
    RequireFinite(this->Scale[axis], "Scale");
    if (!(this->Scale[axis] > 0.0))
    {
      throw Error(Failure::BadStroke, "{Scale} has the factor %1; give factors above 0.", this->Scale[axis]);
    }
  }
  RequireFinite(this->MirrorOffset, "MirrorOffset");
}

int vtkOversketchTransform::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  this->Found.clear();
  this->Made = nullptr;
  return this->RunSystem(
    [&]
    {
      vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      if (mesh->GetNumberOfPoints() == 0)
      {
        return;
      }
      this->RequireValues();
      RequirePolygonsOnly(mesh);
      const Context context = ContextOf(this);
      const Chosen chosen = chosenOf(mesh, numbersOf(mesh), this->Part, context);
      context.checkpoint(0.4);
      const Pose pose{ Vector3(this->Move), Vector3(this->Turn), Vector3(this->Scale) };
      output->ShallowCopy(mesh);
      if (!pose.isRest())
      {
        place(output, chosen, pose, context);
      }
      context.checkpoint(0.6);
      if (this->Copy == CopyMirrored)
      {
        addMirrored(output, chosen, this->Part, this->MirrorAxis, this->MirrorOffset, context);
      }
      if (!pose.isRest() || this->Copy == CopyMirrored)
      {
        vtkNew<vtkFieldData> fields; // the mesh's own is shared
        fields->ShallowCopy(output->GetFieldData());
        output->SetFieldData(fields);
        DropHierarchy(output);
      }
      const auto moved = static_cast<vtkIdType>(std::count(chosen.points.begin(), chosen.points.end(), 1));
      this->Found = { { "moved", moved }, { "copied", this->Copy == CopyMirrored ? moved : vtkIdType{ 0 } } };
      this->Moved = chosen.points;
      this->Moved.resize(static_cast<std::size_t>(output->GetNumberOfPoints()), 1);
      this->Made = vtkSmartPointer<vtkPolyData>::New();
      this->Made->ShallowCopy(output);
    });
}

void vtkOversketchTransform::GetRegion(vtkPolyData* region)
{
  region->Initialize();
  if (this->Made && this->Made->GetPolys()->IsHomogeneous() == 3)
  {
    PutTriangles(this->Made, this->Moved, 3, region);
  }
}

void vtkOversketchTransform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double values[3])
  { os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << "\n"; };
  print("Move", this->Move);
  print("Turn", this->Turn);
  print("Scale", this->Scale);
  os << indent << "Part: " << this->Part << "\n";
  os << indent << "Copy: " << (this->Copy == CopyOff ? "Off" : "Mirrored") << "\n";
  os << indent << "MirrorAxis: " << this->MirrorAxis << "\n";
  os << indent << "MirrorOffset: " << this->MirrorOffset << "\n";
}
