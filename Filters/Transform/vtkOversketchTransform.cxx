#include "vtkOversketchTransform.h"

#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchJoinedParts.h"
#include "vtkOversketchMaskArray.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <regex>
#include <string>
#include <vector>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchTransform);

namespace
{

// What is placed, or its copy, ascending.
struct Chosen
{
  std::vector<vtkIdType> points, faces;
};

Chosen chosenOf(vtkPolyData* mesh, vtkIntArray* numbers, int part)
{
  if (part >= 0 && JoinedParts(mesh).count(part) > 0)
  {
    throw Error(Failure::BadMesh,
      "Part %1 is joined with others; place the whole mesh ({Part -1}), or switch the joining off.",
      part);
  }
  Chosen chosen;
  const vtkIdType count = mesh->GetNumberOfPoints();
  std::vector<char> own(static_cast<std::size_t>(count), part < 0), others(own.size(), 0);
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    const bool isOwn = part < 0 || (numbers ? numbers->GetValue(f) : 0) == part;
    if (isOwn)
    {
      chosen.faces.push_back(f);
    }
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(f, corners, ids);
    for (vtkIdType k = 0; k < corners; ++k)
    {
      if (ids[k] < 0 || ids[k] >= count)
      {
        throw Error(Failure::BadMesh, "Face %1 names point %2, and there are %3 points.", f, ids[k], count);
      }
      (isOwn ? own : others)[ids[k]] = 1;
    }
  }
  if (part >= 0 && chosen.faces.empty())
  {
    throw Error(Failure::BadMesh,
      "The mesh has no part %1; the highest number is %2, and {Part -1} is all of it.",
      part,
      HighestPart(numbers));
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (own[i] && others[i])
    {
      throw Error(Failure::BadMesh,
        "Point %1 is of part %2 and of another one, so that neither can be placed alone; place all of the "
        "mesh, {Part -1}.",
        i,
        part);
    }
    if (own[i] && !Vector3(mesh->GetPoint(i)).allFinite())
    {
      throw Error(Failure::BadMesh, "Point %1 is not finite; repair or remove it.", i);
    }
    if (own[i])
    {
      chosen.points.push_back(i);
    }
  }
  return chosen;
}

// An array of three components, changed at some places.
template <typename Change>
vtkSmartPointer<vtkDataArray> changed(vtkDataArray* array,
  const std::vector<vtkIdType>& at,
  const Context& context,
  const Change& change)
{
  const auto own = vtk::TakeSmartPointer(array->NewInstance());
  own->DeepCopy(array);
  context.each(static_cast<int>(at.size()),
    [&](int i)
    {
      Vector3 tuple;
      own->GetTuple(at[i], tuple.data());
      tuple = change(tuple);
      own->SetTuple(at[i], tuple.data());
    });
  return own;
}

void transform(vtkPolyData* mesh, const Chosen& chosen, vtkTransform* transform, const Context& context)
{
  using Rows = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  const Eigen::Affine3d by(Eigen::Map<const Rows>(transform->GetMatrix()->GetData()));
  const Eigen::Matrix3d turn = by.linear().inverse().transpose();
  vtkNew<vtkPoints> points;
  points->SetData(changed(mesh->GetPoints()->GetData(),
    chosen.points,
    context,
    [&by](const Vector3& at) -> Vector3 { return by * at; }));
  mesh->SetPoints(points);
  if (!(ReachOf(mesh) <= LargestCoordinate))
  {
    throw Error(Failure::BadMesh, "The mesh would lie beyond 1e12; give a smaller {Move} or {Scale}.");
  }
  for (const bool ofPoints : { true, false })
  {
    vtkDataSetAttributes* data =
      ofPoints ? static_cast<vtkDataSetAttributes*>(mesh->GetPointData()) : mesh->GetCellData();
    vtkDataArray* normals = data->GetNormals();
    if (normals && normals->GetNumberOfComponents() == 3 &&
        normals->GetNumberOfTuples() == (ofPoints ? mesh->GetNumberOfPoints() : mesh->GetNumberOfPolys()))
    {
      data->SetNormals(changed(normals,
        ofPoints ? chosen.points : chosen.faces,
        context,
        [&turn](const Vector3& normal) -> Vector3 { return (turn * normal).normalized(); }));
    }
  }
}

// Field arrays of parts, such as Part0.Texture, once more for their copies, whose numbers are so much higher.
void repeatFields(vtkFieldData* fields, int part, int by)
{
  if (vtkDataArray* joined = part < 0 ? fields->GetArray("Joined") : nullptr)
  {
    const auto copy = vtk::TakeSmartPointer(joined->NewInstance());
    copy->DeepCopy(joined);
    for (vtkIdType i = 0; i < joined->GetNumberOfTuples(); ++i)
    {
      copy->InsertNextTuple1(joined->GetComponent(i, 0) + by);
    }
    fields->AddArray(copy);
  }
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
      copy->SetName(("Part" + std::to_string(std::stoi(match[1]) + by) + "." + match[2].str()).c_str());
      fields->AddArray(copy);
    }
  }
}

// Adds the chosen elements of a mesh once more, their faces the other way round. Returns the new ones.
Chosen repeat(vtkPolyData* mesh, const Chosen& chosen, int part)
{
  const auto addAgain = [](vtkIdType count, const std::vector<vtkIdType>& once, std::vector<vtkIdType>& added)
  {
    std::vector<vtkIdType> sources(static_cast<std::size_t>(count));
    std::iota(sources.begin(), sources.end(), vtkIdType{ 0 });
    sources.insert(sources.end(), once.begin(), once.end());
    added.resize(once.size());
    std::iota(added.begin(), added.end(), count);
    return sources;
  };
  Chosen copy;
  const auto points = addAgain(mesh->GetNumberOfPoints(), chosen.points, copy.points),
             faces = addAgain(mesh->GetNumberOfPolys(), chosen.faces, copy.faces);
  std::vector<vtkIdType> copyOf(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < copy.points.size(); ++i)
  {
    copyOf[chosen.points[i]] = copy.points[i];
  }
  vtkNew<vtkCellArray> polys;
  polys->DeepCopy(mesh->GetPolys());
  vtkIntArray* numbers = PartNumbers(mesh);
  const int by = HighestPart(numbers) + 1 - std::max(part, 0);
  const auto parts = NewArray<vtkIntArray>("PartId", 1, faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const int own = numbers ? numbers->GetValue(faces[f]) : 0;
    const bool isNew = static_cast<vtkIdType>(f) >= mesh->GetNumberOfPolys();
    parts->SetValue(static_cast<vtkIdType>(f), own + (isNew ? by : 0));
    if (isNew)
    {
      vtkIdType corners = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetPolys()->GetCellAtId(faces[f], corners, ids);
      polys->InsertNextCell(static_cast<int>(corners));
      for (vtkIdType k = 0; k < corners; ++k)
      {
        polys->InsertCellPoint(copyOf[ids[(corners - k) % corners]]); // the first one stays
      }
    }
  }
  vtkNew<vtkPolyData> all;
  vtkNew<vtkPoints> places;
  places->SetData(CarriedArray(mesh->GetPoints()->GetData(), points));
  all->SetPoints(places);
  all->SetPolys(polys);
  CopyElements(mesh->GetPointData(), points, all->GetPointData());
  CopyElements(mesh->GetCellData(), faces, all->GetCellData());
  all->GetCellData()->AddArray(parts);
  all->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  repeatFields(all->GetFieldData(), part, by);
  mesh->ShallowCopy(all);
  return copy;
}

} // namespace

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

void vtkOversketchTransform::Compose(const double move[3],
  const double turn[3],
  const double scale[3],
  const double middle[3],
  vtkTransform* transform)
{
  transform->Identity();
  transform->PreMultiply();
  transform->Translate(move);
  transform->Translate(middle);
  transform->RotateZ(turn[2]);
  transform->RotateX(turn[0]);
  transform->RotateY(turn[1]);
  transform->Scale(scale);
  transform->Translate(-middle[0], -middle[1], -middle[2]);
}

int vtkOversketchTransform::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  this->Found.clear();
  return this->RunOnMesh(inputs,
    outputs,
    [&](vtkPolyData* mesh, vtkPolyData* output)
    {
      this->RequireValues();
      RequirePolygonsOnly(mesh);
      const Context context = ContextOf(this);
      context.checkpoint(0.0);
      const Chosen chosen = chosenOf(mesh, PartNumbers(mesh), this->Part);
      context.checkpoint(0.4);
      output->ShallowCopy(mesh);
      vtkNew<vtkFieldData> fields; // the mesh's own is shared
      fields->ShallowCopy(mesh->GetFieldData());
      output->SetFieldData(fields);
      vtkBoundingBox box;
      for (const vtkIdType i : chosen.points)
      {
        box.AddPoint(mesh->GetPoint(i));
      }
      double middle[3];
      box.GetCenter(middle);
      vtkNew<vtkTransform> by;
      Compose(this->Move, this->Turn, this->Scale, middle, by);
      const bool rests = Vector3(this->Move).isZero(0.0) && Vector3(this->Turn).isZero(0.0) &&
                         Vector3(this->Scale) == Vector3::Ones();
      Chosen moving = chosen;
      const std::vector<char> masked = MaskedPointsOf(mesh);
      const auto stays = [&masked](vtkIdType i) { return !masked.empty() && masked[i] != 0; };
      moving.points.erase(
        std::remove_if(moving.points.begin(), moving.points.end(), stays), moving.points.end());
      if (!rests)
      {
        transform(output, moving, by, context);
        DropHierarchy(output);
      }
      context.checkpoint(0.6);
      if (this->Copy == CopyMirrored)
      {
        const Chosen copy = repeat(output, chosen, this->Part);
        double across[3] = { 1.0, 1.0, 1.0 }, there[3] = { 0.0, 0.0, 0.0 };
        across[this->MirrorAxis] = -1.0;
        there[this->MirrorAxis] = 2.0 * this->MirrorOffset;
        by->Identity();
        by->Translate(there);
        by->Scale(across);
        transform(output, copy, by, context);
        DropHierarchy(output);
      }
      const auto moved = static_cast<vtkIdType>(moving.points.size()),
                 copied = static_cast<vtkIdType>(this->Copy == CopyMirrored ? chosen.points.size() : 0);
      this->Found = { { "moved", moved }, { "copied", copied } };
    });
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
