#include "vtkOversketchStellarCarry.h"

#include "Mesh/nearest.h"
#include "Mesh/rotation.h"
#include "Stellar/leaves.h"
#include "vtkOversketchMixable.h"
#include "vtkOversketchRuns.h"
#include "vtkOversketchStellarTools.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace oversketch
{

namespace
{

vtkSmartPointer<vtkDataArray> LikeArray(vtkDataArray* array, std::size_t tuples)
{
  auto result = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  result->SetName(array->GetName());
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  result->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  result->CopyComponentNames(array);
  return result;
}

bool Identity(const std::vector<int>& from)
{
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    if (from[i] != static_cast<int>(i))
    {
      return false;
    }
  }
  return true;
}

void Normalise(vtkDataArray* values, vtkIdType tuple)
{
  Vector3 n;
  values->GetTuple(tuple, n.data());
  if (n.norm() > 0.0)
  {
    n.normalize();
    values->SetTuple(tuple, n.data());
  }
}

// One tuple between some of `source`.
void Mix(vtkDataArray* to,
  vtkIdType tuple,
  const Binding& between,
  vtkDataArray* source,
  bool mixes,
  bool normals)
{
  const auto greatest = std::max_element(between.weights.begin(), between.weights.end());
  if (!mixes || *greatest == 1.0)
  {
    to->SetTuple(tuple, between.vertices[greatest - between.weights.begin()], source);
    return;
  }
  for (int c = 0; c < to->GetNumberOfComponents(); ++c)
  {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      sum +=
        between.weights[k] == 0.0 ? 0.0 : between.weights[k] * source->GetComponent(between.vertices[k], c);
    }
    to->SetComponent(tuple, c, sum);
  }
  if (normals)
  {
    Normalise(to, tuple);
  }
}

// The place nearest to p in the star of a vertex.
Binding PlaceInStar(const Forest& forest, int v, const Vector3& p)
{
  Binding best = Binding::vertex(v);
  double least = std::numeric_limits<double>::infinity();
  forest.star(v,
    [&](int f, int)
    {
      const int* corners = forest.faces[f].v;
      const Vector3 &a = forest.vertices[corners[0]].position, &b = forest.vertices[corners[1]].position,
                    &c = forest.vertices[corners[2]].position;
      const std::array<double, 3> w = closestWeights(a, b, c, p);
      const double distance = (w[0] * a + w[1] * b + w[2] * c - p).squaredNorm();
      if (distance < least)
      {
        least = distance;
        best = { { corners[0], corners[1], corners[2] }, w };
      }
    });
  return best;
}

// Both orders are by level and parents, so what both have comes in one order in both.
void FindPoints(const Forest& before, const Forest& after, Origins& origins)
{
  const auto key = [&before](std::size_t k)
  {
    const Forest::Vertex& v = before.vertices[k];
    return std::make_tuple(v.level, v.parents[0], v.parents[1]);
  };
  origins.pointFrom.resize(after.vertices.size(), -1);
  std::size_t next = 0;
  for (std::size_t i = 0; i < after.vertices.size(); ++i)
  {
    const Forest::Vertex& vertex = after.vertices[i];
    if (vertex.parents[0] < 0)
    {
      origins.pointFrom[i] = static_cast<int>(next++);
      continue;
    }
    const int low = origins.pointFrom[vertex.parents[0]], high = origins.pointFrom[vertex.parents[1]];
    if (low >= 0 && high >= 0)
    {
      const auto wanted = std::make_tuple(vertex.level, low, high);
      while (next < before.vertices.size() && key(next) < wanted)
      {
        ++next;
      }
      if (next < before.vertices.size() && key(next) == wanted)
      {
        origins.pointFrom[i] = static_cast<int>(next++);
        continue;
      }
    }
    origins.born.emplace_back(static_cast<int>(i), Binding::edge(vertex.parents[0], vertex.parents[1], 0.5));
  }
}

} // namespace

Origins originsOf(const Forest& before, const Forest& after, bool slides)
{
  Origins origins;
  const std::size_t count = after.vertices.size();
  // A step splits or welds, so what has as many points and cells has the same.
  if (before.vertices.size() == count && before.faces.size() == after.faces.size())
  {
    origins.pointFrom.resize(count);
    std::iota(origins.pointFrom.begin(), origins.pointFrom.end(), 0);
    origins.cellFrom.resize(after.faces.size());
    std::iota(origins.cellFrom.begin(), origins.cellFrom.end(), 0);
  }
  else
  {
    FindPoints(before, after, origins);
    origins.cellFrom = facesUnder(before, after);
  }
  const auto moved = [&](std::size_t i)
  {
    const int from = origins.pointFrom[i];
    return from >= 0 && before.vertices[from].position != after.vertices[i].position;
  };
  for (std::size_t i = 0; slides && i < count; ++i)
  {
    if (moved(i))
    {
      origins.slid.emplace_back(
        static_cast<int>(i), PlaceInStar(before, origins.pointFrom[i], after.vertices[i].position));
    }
  }
  return origins;
}

Turns turnsOf(const Forest& before, const Forest& after)
{
  Turns turned;
  std::vector<char> moved(after.vertices.size()), near(after.vertices.size(), 0);
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    moved[i] = before.vertices[i].position != after.vertices[i].position;
  }
  for (const Forest::Face& face : after.faces)
  {
    if (moved[face.v[0]] || moved[face.v[1]] || moved[face.v[2]])
    {
      near[face.v[0]] = near[face.v[1]] = near[face.v[2]] = 1;
    }
  }
  for (int i = 0; i < static_cast<int>(near.size()); ++i)
  {
    if (near[i])
    {
      const Vector3 was = before.vertexNormal(i), is = after.vertexNormal(i);
      if (was.norm() > 0.0 && is.norm() > 0.0 && was != is)
      {
        turned.emplace_back(i, rotationBetween(was, is));
      }
    }
  }
  return turned;
}

void CarriedArrays::NeedOrigins()
{
  if (this->Find)
  {
    this->From = this->Find();
    this->Find = nullptr;
    this->SamePoints = this->From.slid.empty() && Identity(this->From.pointFrom);
    this->SameCells = Identity(this->From.cellFrom);
  }
}

vtkSmartPointer<vtkDataArray> CarriedArrays::CarryPoints(vtkDataArray* array, bool normals) const
{
  const bool turns = normals && array->GetNumberOfComponents() == 3 && !this->Turned.empty();
  if (this->SamePoints && !turns &&
      array->GetNumberOfTuples() == static_cast<vtkIdType>(this->From.pointFrom.size()))
  {
    return array;
  }
  const bool mixes = IsMixable(array);
  const bool whole = mixes && array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
  auto carried = LikeArray(array, this->From.pointFrom.size());
  const vtkSmartPointer<vtkDataArray> result = carried;
  if (whole) // means of means are rounded once
  {
    carried = vtkSmartPointer<vtkDoubleArray>::New();
    carried->SetNumberOfComponents(array->GetNumberOfComponents());
    carried->SetNumberOfTuples(result->GetNumberOfTuples());
  }
  EachRun(
    this->From.pointFrom,
    [&](vtkIdType first, vtkIdType count, vtkIdType source)
    { carried->InsertTuples(first, count, source, array); },
    [](vtkIdType) {});
  for (const auto& [point, between] : this->From.slid)
  {
    Mix(carried, point, between, array, mixes, normals);
  }
  for (const auto& [point, between] : this->From.born)
  {
    Mix(carried, point, between, carried, mixes, normals);
  }
  for (vtkIdType i = 0; whole && i < result->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < result->GetNumberOfComponents(); ++c)
    {
      result->SetComponent(i, c, std::round(carried->GetComponent(i, c)));
    }
  }
  for (std::size_t i = 0; turns && i < this->Turned.size(); ++i)
  {
    const auto& [point, turn] = this->Turned[i];
    Vector3 n;
    carried->GetTuple(point, n.data());
    n = turn * n;
    carried->SetTuple(point, n.data());
  }
  return result;
}

vtkSmartPointer<vtkDataArray> CarriedArrays::CarryCells(vtkDataArray* array) const
{
  if (this->SameCells && array->GetNumberOfTuples() == static_cast<vtkIdType>(this->From.cellFrom.size()))
  {
    return array;
  }
  auto carried = LikeArray(array, this->From.cellFrom.size());
  EachRun(
    this->From.cellFrom,
    [&](vtkIdType first, vtkIdType count, vtkIdType source)
    { carried->InsertTuples(first, count, source, array); },
    [](vtkIdType) {});
  return carried;
}

void CarriedArrays::Carry(vtkPolyData* input, vtkPolyData* output)
{
  std::vector<Item> items;
  for (const bool points : { true, false })
  {
    vtkDataSetAttributes* from = points ? static_cast<vtkDataSetAttributes*>(input->GetPointData())
                                        : static_cast<vtkDataSetAttributes*>(input->GetCellData());
    vtkDataSetAttributes* to = points ? static_cast<vtkDataSetAttributes*>(output->GetPointData())
                                      : static_cast<vtkDataSetAttributes*>(output->GetCellData());
    for (int i = 0; i < from->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = from->GetArray(i);
      const int attribute = from->IsArrayAnAttribute(i);
      const vtkIdType tuples = points ? input->GetNumberOfPoints() : input->GetNumberOfCells();
      if (!array || array->GetNumberOfTuples() != tuples || IsStellarArray(array->GetName()) ||
          attribute == vtkDataSetAttributes::GLOBALIDS || attribute == vtkDataSetAttributes::PEDIGREEIDS)
      {
        continue;
      }
      const bool normals = points && attribute == vtkDataSetAttributes::NORMALS;
      Item item{ array, array->GetMTime(), points, normals, nullptr };
      for (const Item& known : this->Items)
      {
        if (known.Source == item.Source && known.Time == item.Time && known.Points == points &&
            known.Normals == normals)
        {
          item.Result = known.Result;
        }
      }
      if (!item.Result)
      {
        this->NeedOrigins();
        item.Result = points ? this->CarryPoints(array, normals) : this->CarryCells(array);
      }
      items.push_back(item);
      const int index = to->AddArray(item.Result);
      if (attribute >= 0)
      {
        to->SetActiveAttribute(index, attribute);
      }
    }
  }
  this->Items = std::move(items);
  for (int i = 0; i < input->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = input->GetFieldData()->GetAbstractArray(i);
    if (!IsStellarArray(array->GetName()))
    {
      output->GetFieldData()->AddArray(array);
    }
  }
}

} // namespace oversketch
