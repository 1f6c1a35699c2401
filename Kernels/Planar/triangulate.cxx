#include "Planar/triangulate.h"

#include "Planar/delaunay.h"
#include "Planar/trim.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace oversketch
{
namespace
{

bool comesBefore(const Vector2& a, const Vector2& b)
{
  return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
}

// holes: the regions that are.
BoundaryKind kindOf(const StrokeLine& line, const std::set<int>& holes)
{
  const bool closed = line.role == Role::ClosedFeature;
  const bool island = closed && line.treatment != Treatment::Hole && holes.count(line.region) > 0;
  if (line.role == Role::Boundary || island)
  {
    return BoundaryKind::Object;
  }
  return closed && line.treatment == Treatment::Hole     ? BoundaryKind::Hole
         : closed && line.treatment == Treatment::Tunnel ? BoundaryKind::TunnelRim
                                                         : BoundaryKind::Feature;
}

// Decides which of two lines a point on both belongs to.
bool ownsBefore(BoundaryKind a, BoundaryKind b)
{
  const auto rank = [](BoundaryKind kind)
  { return kind == BoundaryKind::Feature ? 9 : static_cast<int>(kind); };
  return b == BoundaryKind::Interior || rank(a) < rank(b);
}

// Points, edges of strokes and constraints, all faces still to come.
struct Sketch
{
  PlanarMesh mesh; // edges[i] is constraint i
  std::vector<Constraint> constraints;
  std::vector<int> lineOf; // of each constraint
};

Sketch sketchOf(const std::vector<StrokeLine>& lines, const std::vector<Vector2>& darts)
{
  Polyline places;
  for (const StrokeLine& line : lines)
  {
    if (line.closed && line.places.size() < 3)
    {
      throw Error(Failure::BadStroke, "stroke %1 is closed round nothing; draw a rounder one", line.stroke);
    }
    places.insert(places.end(), line.places.begin(), line.places.end());
  }
  places.insert(places.end(), darts.begin(), darts.end());
  std::sort(places.begin(), places.end(), comesBefore);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  Sketch sketch;
  sketch.mesh.points.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    sketch.mesh.points[i].place = places[i];
    sketch.mesh.points[i].isBase = true;
  }
  std::set<int> holes;
  for (const StrokeLine& line : lines)
  {
    if (line.role == Role::ClosedFeature && line.treatment == Treatment::Hole)
    {
      holes.insert(line.childRegion);
    }
  }
  for (std::size_t l = 0; l < lines.size(); ++l)
  {
    const StrokeLine& line = lines[l];
    const BoundaryKind kind = kindOf(line, holes);
    std::vector<int> numbers;
    for (std::size_t i = 0; i < line.places.size(); ++i)
    {
      const int number = static_cast<int>(
        std::lower_bound(places.begin(), places.end(), line.places[i], comesBefore) - places.begin());
      numbers.push_back(number);
      PlanarPoint& point = sketch.mesh.points[number];
      if (ownsBefore(kind, point.kind))
      {
        point.kind = kind;
        point.stroke = line.stroke;
        point.param = line.params[i];
      }
    }
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      const bool last = i + 1 == numbers.size();
      if (last && !line.closed)
      {
        break;
      }
      const int to = last ? numbers[0] : numbers[i + 1];
      const double end = last ? line.length + line.params[0] : line.params[i + 1];
      sketch.mesh.edges.push_back({ numbers[i], to, line.stroke, line.params[i], end });
      sketch.constraints.push_back({ numbers[i], to, line.stroke });
      sketch.lineOf.push_back(static_cast<int>(l));
    }
  }
  return sketch;
}

[[noreturn]] void wrongSide(const StrokeLine& line, const Vector2& place)
{
  throw Error(Failure::BadStroke,
    "{stroke %1} is not where its region is, near {(%2, %3)}; take polylines of strokes that do not meet",
    line.stroke,
    place[0],
    place[1]);
}

// Region of each face; -1 outside.
std::vector<int> regionsOf(const std::vector<DelaunayFace>& faces,
  const Sketch& sketch,
  const std::vector<StrokeLine>& lines)
{
  constexpr int unknown = -2;
  std::vector<int> regions(faces.size(), unknown), pending;
  // Finds what lies beyond an edge of a face, or of the hull, seen from a region.
  const auto beyond = [&](int constraint, int region)
  {
    const StrokeLine& line = lines[sketch.lineOf[constraint]];
    if (!line.closed)
    {
      return region;
    }
    const bool boundary = line.role == Role::Boundary;
    const int outer = boundary ? -1 : line.region, inner = boundary ? line.region : line.childRegion;
    if (region != outer && region != inner)
    {
      wrongSide(line, sketch.mesh.points[sketch.constraints[constraint].from].place);
    }
    return region == outer ? inner : outer;
  };
  const auto reach = [&](int face, int constraint, int from)
  {
    const int region = constraint < 0 ? from : beyond(constraint, from);
    if (regions[face] == unknown)
    {
      regions[face] = region;
      pending.push_back(face);
    }
    else if (regions[face] != region)
    {
      wrongSide(
        lines[sketch.lineOf[std::max(constraint, 0)]], sketch.mesh.points[faces[face].corners[0]].place);
    }
  };
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (faces[f].across[k] < 0)
      {
        reach(static_cast<int>(f), faces[f].constraints[k], -1);
      }
    }
  }
  while (!pending.empty())
  {
    const int from = pending.back();
    pending.pop_back();
    const DelaunayFace& face = faces[from];
    for (int k = 0; k < 3; ++k)
    {
      if (face.across[k] >= 0)
      {
        reach(face.across[k], face.constraints[k], regions[from]);
      }
    }
  }
  return regions;
}

// Tells parts of regions apart that no way joins that crosses no line.
void divideRegions(const std::vector<DelaunayFace>& faces, std::vector<int>& regions)
{
  std::map<int, int> parts; // of each region, so far
  std::vector<char> done(faces.size(), 0);
  std::vector<int> pending;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (done[f] || regions[f] < 0)
    {
      continue;
    }
    const int whole = regions[f], part = parts[whole]++;
    if (whole >= regionStride || part >= std::numeric_limits<int>::max() / regionStride)
    {
      throw Error(Failure::BadStroke, "the strokes divide the drawing into too many regions; draw fewer");
    }
    done[f] = 1;
    pending = { static_cast<int>(f) };
    while (!pending.empty())
    {
      const int at = pending.back();
      pending.pop_back();
      regions[at] = whole + part * regionStride;
      for (int k = 0; k < 3; ++k)
      {
        const int next = faces[at].across[k];
        if (next >= 0 && faces[at].constraints[k] < 0 && !done[next])
        {
          done[next] = 1;
          pending.push_back(next);
        }
      }
    }
  }
}

// Object of each region, -1 where the region is a hole.
std::map<int, int> objectsOf(const std::vector<StrokeLine>& lines)
{
  std::map<int, int> objects;
  for (const StrokeLine& line : lines)
  {
    if (line.role == Role::Boundary)
    {
      objects[line.region] = line.object;
    }
    else if (line.role == Role::ClosedFeature)
    {
      objects[line.childRegion] = line.treatment == Treatment::Hole ? -1 : line.object;
    }
  }
  return objects;
}

} // namespace

PlanarMesh triangulate(const std::vector<StrokeLine>& lines,
  const std::vector<Vector2>& darts,
  const Context& context)
{
  Sketch sketch = sketchOf(lines, darts);
  PlanarMesh mesh = sketch.mesh;
  Polyline places;
  for (const PlanarPoint& point : mesh.points)
  {
    places.push_back(point.place);
  }
  const std::vector<DelaunayFace> faces = constrainedDelaunay(places, sketch.constraints, context);
  std::vector<int> regions = regionsOf(faces, sketch, lines);
  divideRegions(faces, regions);
  const std::map<int, int> objects = objectsOf(lines);
  std::vector<char> kept(sketch.constraints.size(), 0);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const auto object = objects.find(wholeRegion(regions[f]));
    if (object == objects.end() || object->second < 0)
    {
      continue;
    }
    PlanarFace face;
    std::copy(faces[f].corners.begin(), faces[f].corners.end(), face.corners.begin());
    face.region = regions[f];
    face.object = object->second;
    face.base = static_cast<int>(mesh.faces.size());
    mesh.faces.push_back(face);
    for (const int constraint : faces[f].constraints)
    {
      if (constraint >= 0)
      {
        kept[constraint] = 1;
      }
    }
  }
  // What is left out lies in a hole; anything else is no drawing's.
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    const StrokeLine& line = lines[sketch.lineOf[i]];
    const auto object = objects.find(line.region);
    const bool inHole = object != objects.end() && object->second < 0;
    if (!kept[i] && !inHole)
    {
      wrongSide(line, places[sketch.constraints[i].from]);
    }
  }
  compact(mesh, kept);
  std::sort(mesh.edges.begin(),
    mesh.edges.end(),
    [](const StrokeEdge& a, const StrokeEdge& b)
    { return a.stroke != b.stroke ? a.stroke < b.stroke : a.start < b.start; });
  return mesh;
}

} // namespace oversketch
