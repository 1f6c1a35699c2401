#include "vtkOversketchHandleSection.h"

#include "vtkOversketchBindings.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace oversketch
{

double SectionLengthOf(vtkPolyData* handles)
{
  vtkDataArray* array = handles->GetFieldData()->GetArray("SectionLength");
  const double length = array && array->GetNumberOfValues() == 1 ? array->GetComponent(0, 0)
                                                                 : std::numeric_limits<double>::quiet_NaN();
  if (!(length >= 0.0))
  {
    throw Error(Failure::MissingArray,
      "The handles have no field array SectionLength of one value, the length of the matched section: make "
      "them with vtkOversketchTargets, or turn LimitRunaway, ReachEnds, ConfineToSection and IgnoreNoise off "
      "and "
      "leave {Reach} at 0.");
  }
  return length;
}

Section SectionOf(vtkPolyData* handles, const MeshData& mesh, double margin, bool reachEnds, bool moved)
{
  const int vertexCount = mesh.Surface().vertexCount();
  const vtkIdType count = handles->GetNumberOfPoints();
  if (count == 0)
  {
    throw Error(Failure::BadRegion, "There are no handles to grow a region from; match a stroke first.");
  }
  const std::string remedy = "take them from vtkOversketchTargets";
  vtkPointData* data = handles->GetPointData();
  const std::vector<Binding> bindings = ReadBindings(handles, vertexCount, "handles", remedy);
  vtkDataArray* positions = RequireArray(data, "RelativePosition", 1, count, "handles", remedy);
  std::vector<double> moves(static_cast<std::size_t>(count), 0.0);
  double moving = 0.0;
  Section section;
  if (moved)
  {
    vtkDataArray* targets = RequireArray(data, "UnmergedTarget", 3, count, "handles", remedy);
    for (vtkIdType h = 0; h < count; ++h)
    {
      Vector3 place, target;
      handles->GetPoint(h, place.data());
      targets->GetTuple(h, target.data());
      moves[h] = (target - place).norm();
      const Binding& binding = bindings[static_cast<std::size_t>(h)];
      Vector3 outwards = Vector3::Zero();
      for (int k = 0; k < 3; ++k)
      {
        outwards += binding.weights[k] * mesh.Normals()[static_cast<std::size_t>(binding.vertices[k])];
      }
      section.depth = std::max(section.depth, (place - target).dot(outwards.normalized()));
    }
    section.movement = *std::max_element(moves.begin(), moves.end());
    // Less is a hand that follows the outline.
    moving = std::max(0.05 * section.movement, 0.001 * SectionLengthOf(handles));
  }
  const auto add = [&](vtkIdType h, std::vector<int>& list)
  {
    const Binding& binding = bindings[static_cast<std::size_t>(h)];
    for (int k = 0; k < 3; ++k)
    {
      if (binding.weights[k] > 0.0)
      {
        list.push_back(binding.vertices[k]);
      }
    }
  };
  vtkIdType first = -1, last = -1; // seeds by position
  for (vtkIdType h = 0; h < count; ++h)
  {
    const double position = positions->GetComponent(h, 0);
    if (position >= margin && position <= 1.0 - margin)
    {
      add(h, section.seeds);
      first = first < 0 || position < positions->GetComponent(first, 0) ? h : first;
      last = last < 0 || position > positions->GetComponent(last, 0) ? h : last;
    }
    else if (reachEnds && moves[h] > moving)
    {
      add(h, section.ends[position < margin ? 0 : 1]);
    }
  }
  if (first >= 0)
  {
    add(first, section.ends[0]);
    add(last, section.ends[1]);
  }
  const auto farthest = [&](bool end)
  {
    vtkIdType found = 0;
    for (vtkIdType h = 1; h < count; ++h)
    {
      const bool beyond = end ? positions->GetComponent(h, 0) > positions->GetComponent(found, 0)
                              : positions->GetComponent(h, 0) < positions->GetComponent(found, 0);
      found = beyond ? h : found;
    }
    Vector3 place;
    handles->GetPoint(found, place.data());
    return place;
  };
  section.chord = (farthest(true) - farthest(false)).norm();
  for (std::vector<int>* list : { &section.seeds, &section.ends[0], &section.ends[1] })
  {
    sortUnique(*list);
  }
  return section;
}

namespace
{

// The length that half of the section reaches [model length].
double HalfReachOf(const Section& section, double length)
{
  const double straight = length > 0.0 ? std::min(section.chord / length, 1.0) : 1.0;
  return (0.5 - 0.25 * straight) * length;
}

} // namespace

bool OfLimb(const Section& section, double length, double diameter)
{
  return diameter <= 1.25 * HalfReachOf(section, length);
}

double NearOf(const Section& section, double length, double diameter)
{
  const double near = HalfReachOf(section, length), radius = 0.5 * diameter;
  // No steeper than the stroke's own flanks are; and so far that what is beside it does not become the
  // outline.
  const double beside = 1.5 * radius * std::acos(std::clamp(1.0 - section.depth / radius, -1.0, 1.0));
  return std::max({ near, 1.25 * section.movement, beside });
}

} // namespace oversketch
