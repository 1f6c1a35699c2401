#include "Inflate/tunnel.h"

#include "Inflate/solid.h"
#include "Mesh/context.h"
#include "Planar/trim.h"

#include <algorithm>
#include <utility>

namespace oversketch
{
namespace
{

using Edge = std::pair<int, int>;

// Edges that the removal opens, of both sides.
std::vector<BorderEdge> openedBy(const Solid& before, const Solid& after)
{
  const int count = static_cast<int>(before.points.size());
  std::vector<Edge> known;
  for (const BorderEdge& edge : borderOf(cornersOf(before.faces), count))
  {
    known.emplace_back(edge.from, edge.to);
  }
  std::vector<BorderEdge> opened;
  for (const BorderEdge& edge : borderOf(cornersOf(after.faces), count))
  {
    if (!std::binary_search(known.begin(), known.end(), Edge(edge.from, edge.to)))
    {
      opened.push_back(edge);
    }
  }
  return opened;
}

// Points of the back, one for each of the front, over the same point of the drawing's mesh.
std::vector<int> twinsOf(const Solid& solid)
{
  int planar = -1;
  for (const SolidPoint& point : solid.points)
  {
    planar = std::max(planar, point.planar);
  }
  std::vector<int> back(planar + 1, -1), twins(solid.points.size(), -1);
  for (std::size_t i = 0; i < solid.points.size(); ++i)
  {
    const SolidPoint& point = solid.points[i];
    if (point.planar < 0)
    {
      throw Error(Failure::BadMesh, "Point %1 is of no point of the planar mesh (PlanarId).", i);
    }
    if (point.side < 0)
    {
      back[point.planar] = static_cast<int>(i);
    }
  }
  for (std::size_t i = 0; i < solid.points.size(); ++i)
  {
    twins[i] = solid.points[i].side > 0 ? back[solid.points[i].planar] : -1;
  }
  return twins;
}

// The front's part of what was opened, when the back's is the same.
std::vector<BorderEdge> frontOf(const Solid& solid,
  const std::vector<BorderEdge>& opened,
  const std::vector<int>& twins)
{
  std::vector<BorderEdge> front;
  std::vector<Edge> back, expected;
  for (const BorderEdge& edge : opened)
  {
    if (solid.faces[edge.face].side < 0)
    {
      back.emplace_back(edge.from, edge.to);
      continue;
    }
    if (twins[edge.from] < 0 || twins[edge.to] < 0)
    {
      throw Error(Failure::BadMesh,
        "The tunnel reaches a rim at point %1; its stroke must stay inside the object.",
        edge.from);
    }
    front.push_back(edge);
    expected.emplace_back(twins[edge.to], twins[edge.from]);
  }
  std::sort(expected.begin(), expected.end());
  std::sort(back.begin(), back.end());
  if (back != expected)
  {
    throw Error(Failure::BadMesh,
      "The tunnel takes other faces of the front than of the back; PlanarId, Side and RegionId must be those "
      "of the step that made the surface.");
  }
  return front;
}

} // namespace

std::vector<char> regionsInTunnels(const Classification& classification,
  const std::vector<Treatment>& treatments)
{
  // What lies in one goes with it: it would hang on nothing.
  const std::vector<Region>& regions = classification.regions;
  std::vector<char> gone(regions.size(), 0);
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    for (int around = static_cast<int>(r); regions[around].parent >= 0; around = regions[around].parent)
    {
      gone[r] = gone[r] || treatments[regions[around].stroke] == Treatment::Tunnel;
    }
  }
  return gone;
}

Solid tunnel(const Solid& solid, const std::vector<char>& removed, bool wall)
{
  Solid result;
  result.points = solid.points;
  for (std::size_t f = 0; f < solid.faces.size(); ++f)
  {
    if (!removed[f])
    {
      result.faces.push_back(solid.faces[f]);
    }
  }
  if (result.faces.empty() && !solid.faces.empty())
  {
    throw Error(Failure::BadMesh, "The tunnels take the whole surface; choose strokes inside its boundary.");
  }
  const std::vector<int> twins = twinsOf(result);
  const std::vector<BorderEdge> front = frontOf(result, openedBy(solid, result), twins);
  if (wall && !front.empty())
  {
    std::vector<char> isBase;
    for (const SolidPoint& point : result.points)
    {
      isBase.push_back(point.isBase);
    }
    addWall(result, front, twins, edgesBetweenBasePoints(front, isBase));
  }
  dropUnusedPoints(result);
  return result;
}

} // namespace oversketch
