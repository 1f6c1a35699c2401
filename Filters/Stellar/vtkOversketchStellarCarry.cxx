#include "vtkOversketchStellarCarry.h"

#include "Mesh/nearest.h"
#include "Mesh/rotation.h"
#include "Stellar/leaves.h"
#include "vtkOversketchCarriedArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
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

void StellarCarry::NeedOrigins()
{
  if (this->Find)
  {
    this->From = this->Find();
    this->Find = nullptr;
    this->SamePoints = this->From.slid.empty() && Identity(this->From.pointFrom);
    this->SameCells = Identity(this->From.cellFrom);
  }
}

vtkSmartPointer<vtkDataArray> StellarCarry::CarryPoints(vtkDataArray* array, bool normals) const
{
  const bool turns = normals && array->GetNumberOfComponents() == 3 && !this->Turned.empty();
  if (this->SamePoints && !turns &&
      array->GetNumberOfTuples() == static_cast<vtkIdType>(this->From.pointFrom.size()))
  {
    return array;
  }
  const bool mixes = IsMixable(array);
  const bool whole = mixes && array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
  vtkSmartPointer<vtkDataArray> source = array;
  if (whole) // means of means are rounded once
  {
    source = vtkSmartPointer<vtkDoubleArray>::New();
    source->DeepCopy(array);
  }
  const auto carried = CarriedArray(source.Get(), this->From.pointFrom);
  TupleMixer mixer(mixes, mixes && normals);
  const auto put = [&](const std::pair<int, Binding>& point, vtkDataArray* from)
  {
    const auto& [vertices, weights] = point.second;
    const auto greatest = std::max_element(weights.begin(), weights.end());
    if (*greatest == 1.0)
    {
      carried->SetTuple(point.first, vertices[greatest - weights.begin()], from);
      return;
    }
    Mix mix;
    for (int k = 0; k < 3; ++k)
    {
      if (weights[k] != 0.0)
      {
        mix.emplace_back(vertices[k], weights[k]);
      }
    }
    mixer.Put(carried, point.first, mix, from);
  };
  for (const auto& slid : this->From.slid)
  {
    put(slid, source);
  }
  for (const auto& born : this->From.born)
  {
    put(born, carried);
  }
  if (whole)
  {
    auto rounded = LikeArray(array, this->From.pointFrom.size());
    for (vtkIdType i = 0; i < rounded->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < rounded->GetNumberOfComponents(); ++c)
      {
        rounded->SetComponent(i, c, std::round(carried->GetComponent(i, c)));
      }
    }
    return rounded;
  }
  for (std::size_t i = 0; turns && i < this->Turned.size(); ++i)
  {
    const auto& [point, turn] = this->Turned[i];
    Vector3 n;
    carried->GetTuple(point, n.data());
    n = turn * n;
    carried->SetTuple(point, n.data());
  }
  return carried;
}

vtkSmartPointer<vtkDataArray> StellarCarry::CarryCells(vtkDataArray* array) const
{
  const bool same =
    this->SameCells && array->GetNumberOfTuples() == static_cast<vtkIdType>(this->From.cellFrom.size());
  return same ? vtkSmartPointer<vtkDataArray>(array) : CarriedArray(array, this->From.cellFrom);
}

void StellarCarry::Carry(vtkPolyData* input, vtkPolyData* output)
{
  const auto carry = [this](
                       vtkDataSetAttributes* from, vtkIdType count, bool points, vtkDataSetAttributes* to)
  {
    CarryArrays(from,
      to,
      [&](vtkAbstractArray* array, bool normals) -> vtkSmartPointer<vtkAbstractArray>
      {
        auto* numbers = vtkDataArray::SafeDownCast(array);
        if (!numbers || numbers->GetNumberOfTuples() != count || IsStellarArray(numbers->GetName()) ||
            numbers == from->GetPedigreeIds())
        {
          return nullptr;
        }
        return this->Kept.Provide(numbers,
          !points   ? 0
          : normals ? 2
                    : 1,
          [&]
          {
            this->NeedOrigins();
            return points ? this->CarryPoints(numbers, normals) : this->CarryCells(numbers);
          });
      });
  };
  carry(input->GetPointData(), input->GetNumberOfPoints(), true, output->GetPointData());
  carry(input->GetCellData(), input->GetNumberOfCells(), false, output->GetCellData());
  this->Kept.EndRun();
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
