#include "Planar/refine.h"

#include "Mesh/shape.h"
#include "Planar/face_edges.h"
#include "Planar/guard.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace oversketch
{

namespace
{

constexpr double leastArea = 1e-12;  // of the canvas's longest side, squared
constexpr double lengthSlack = 1e-9; // of a stroke's whole: lengths may have been summed in another order
// How far samples may lie from the refined edges, of the canvas's longest side: as far as those of a round
// curve may from its approximation, which each level brings four times nearer, and 4 px of 1024 in any case.
constexpr double roundCurve = 0.05, nearEnough = 0.004;
constexpr double largeFace = 0.0625; // side of a square, of the canvas's longest side
constexpr int mostLevels = 10;
constexpr double mostFaces = 1 << 24;
constexpr double enoughFaces = 1 << 20; // where the sketch says the levels

void checkOptions(const PlanarRefineOptions& options)
{
  if (options.levels < 0 || options.levels > mostLevels)
  {
    throw Error(Failure::BadStroke, "levels is %1: set it to 0 to %2", options.levels, mostLevels);
  }
  if (!(options.snapShare >= 0.0 && options.snapShare <= 1.0))
  {
    throw Error(Failure::BadStroke, "the snap's share is %1: set it to 0 to 1", options.snapShare);
  }
  if (!(options.canvasSide > 0.0) || !std::isfinite(options.canvasSide))
  {
    throw Error(Failure::BadStroke,
      "the canvas's longest side is %1: give it one that is positive",
      options.canvasSide);
  }
}

void checkStrokes(const PlanarMesh& mesh, const std::vector<StrokeByLength>& curves)
{
  const int count = static_cast<int>(curves.size());
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (mesh.points[p].stroke >= count)
    {
      throw Error(Failure::BadMesh,
        "point %1 lies on stroke %2 of %3: give the curves that the mesh was made of",
        p,
        mesh.points[p].stroke,
        count);
    }
  }
  for (const StrokeEdge& edge : mesh.edges)
  {
    const bool known = edge.stroke >= 0 && edge.stroke < count;
    const double length = known ? curves[edge.stroke].length() : 0.0;
    const double most = known && curves[edge.stroke].closed() ? edge.start + length : length;
    const double slack = lengthSlack * length;
    if (!known || !(edge.start >= -slack && edge.start < edge.end && edge.start < length + slack) ||
        !(edge.end <= most + slack))
    {
      throw Error(Failure::BadMesh,
        "the edge of points %1 and %2 is no part of stroke %3, from %4 to %5: give the curves that the mesh "
        "was made of",
        edge.from,
        edge.to,
        edge.stroke,
        edge.start,
        edge.end);
    }
  }
}

void checkSize(const PlanarMesh& mesh, const PlanarRefineOptions& options)
{
  const double faces = static_cast<double>(mesh.faces.size()) * std::pow(4.0, options.levels);
  if (faces > mostFaces)
  {
    throw Error(Failure::BadMesh,
      "the refined mesh would have %1 faces: ask for fewer levels",
      static_cast<long long>(faces));
  }
}

// Where an open stroke's end joins another stroke, its last piece goes there: else the points on that would
// not lie between its ends, and strokes between neighbouring samples would not be straight.
void joinEnds(const PlanarMesh& mesh, std::vector<StrokeByLength>& curves)
{
  for (const StrokeEdge& edge : mesh.edges)
  {
    StrokeByLength& curve = curves[edge.stroke];
    const double slack = lengthSlack * curve.length();
    if (!curve.closed() && edge.start <= slack)
    {
      curve.moveEnd(false, mesh.points[edge.from].place);
    }
    if (!curve.closed() && edge.end >= curve.length() - slack)
    {
      curve.moveEnd(true, mesh.points[edge.to].place);
    }
  }
}

bool hasQuad(const PlanarMesh& mesh)
{
  return std::any_of(
    mesh.faces.begin(), mesh.faces.end(), [](const PlanarFace& face) { return face.count() == 4; });
}

// Kinds of the points on each stroke; those of a stroke that has none of its own, between two rims, lie on a
// feature.
std::vector<BoundaryKind> kindsOf(const PlanarMesh& mesh, std::size_t strokes)
{
  std::vector<BoundaryKind> kinds(strokes, BoundaryKind::Feature);
  for (const PlanarPoint& point : mesh.points)
  {
    if (point.stroke >= 0)
    {
      kinds[point.stroke] = point.kind;
    }
  }
  return kinds;
}

// Parts of strokes: number, from, to.
using Parts = std::set<std::tuple<int, double, double>>;

std::vector<StrokeSplit> splitsOf(const Parts& parts)
{
  std::vector<StrokeSplit> splits;
  for (const auto& [stroke, start, end] : parts)
  {
    splits.push_back({ stroke, start, end, 1 });
  }
  return splits;
}

// The parts of strokes at the mesh's faces of these bases.
std::vector<StrokeSplit> splitsAt(const PlanarMesh& mesh, const FaceEdges& links, const std::set<int>& bases)
{
  Parts parts;
  const auto take = [&](int e)
  {
    if (links.edges[e].stroke >= 0)
    {
      const StrokeEdge& tie = mesh.edges[links.edges[e].stroke];
      parts.emplace(tie.stroke, tie.start, tie.end);
      return true;
    }
    return false;
  };
  for (const int base : bases)
  {
    bool found = false;
    int at = -1;
    for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f)
    {
      if (mesh.faces[f].base == base)
      {
        at = f;
        const std::array<int, 4>& edges = links.ofFace[f];
        found = std::count_if(edges.begin(), edges.begin() + mesh.faces[f].count(), take) > 0 || found;
      }
    }
    const PlanarFace& face = mesh.faces[at];
    for (int i = 0; i < face.count() && !found; ++i)
    {
      const Lists& edges = links.atPoint;
      found = std::count_if(edges.begin(face.corners[i]), edges.end(face.corners[i]), take) > 0;
    }
    if (!found)
    {
      throw Error(Failure::BadMesh,
        "face %1 covers next to nothing, or turns clockwise, away from all strokes: take the mesh as the "
        "filters of the drawing's triangles make it",
        at);
    }
  }
  return splitsOf(parts);
}

// The parts of strokes, by the coarse mesh's edges, that have samples beside the refined edges.
std::vector<StrokeSplit> missed(const PlanarMesh& coarse,
  const PlanarMesh& fine,
  const std::vector<StrokeByLength>& curves,
  double most)
{
  std::set<std::tuple<int, double, double>> ends; // of coarse edges: where they end, and begin
  for (const StrokeEdge& edge : coarse.edges)
  {
    ends.emplace(edge.stroke, edge.end, edge.start);
  }
  Parts parts;
  for (const StrokeEdge& edge : fine.edges)
  {
    const Vector2 &a = fine.points[edge.from].place, &b = fine.points[edge.to].place;
    if (curves[edge.stroke].farthest(edge.start, edge.end, a, b) > most)
    {
      const double middle = 0.5 * (edge.start + edge.end);
      auto of = ends.lower_bound({ edge.stroke, middle, 0.0 });
      if (of == ends.end() || std::get<0>(*of) != edge.stroke ||
          std::get<2>(*of) > middle) // of the edge over the stroke's first sample
      {
        of = ends.lower_bound({ edge.stroke, middle + curves[edge.stroke].length(), 0.0 });
      }
      parts.emplace(edge.stroke, std::get<2>(*of), std::get<1>(*of));
    }
  }
  return splitsOf(parts);
}

} // namespace

int levelsOfSketch(const PlanarMesh& mesh, double canvasSide)
{
  double longest = 0.0;
  for (const FaceEdge& edge : faceEdges(mesh).edges)
  {
    const double along = edge.stroke < 0 ? 0.0 : mesh.edges[edge.stroke].end - mesh.edges[edge.stroke].start;
    longest =
      std::max({ longest, along, (mesh.points[edge.from].place - mesh.points[edge.to].place).norm() });
  }
  int levels = 0;
  double faces = 4.0 * static_cast<double>(mesh.faces.size());
  for (; longest >= 0.02 * canvasSide && levels < mostLevels && faces <= enoughFaces; ++levels)
  {
    longest *= 0.5;
    faces *= 4.0;
  }
  return levels;
}

bool hasLargeFaces(const PlanarMesh& mesh, double canvasSide)
{
  double area = 0.0;
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 1; k + 1 < face.count(); ++k)
    {
      area += signedArea(mesh.points[face.corners[0]].place,
        mesh.points[face.corners[k]].place,
        mesh.points[face.corners[k + 1]].place);
    }
  }
  return area > std::pow(largeFace * canvasSide, 2) * static_cast<double>(mesh.faces.size());
}

PlanarRefineResult refinePlanar(const PlanarMesh& mesh,
  const std::vector<DrawnStroke>& strokes,
  const PlanarRefineOptions& options,
  const Context& context)
{
  checkOptions(options);
  std::vector<StrokeByLength> curves(strokes.begin(), strokes.end());
  checkStrokes(mesh, curves);
  checkSize(mesh, options);
  const SubdivisionRule rule{
    options.quads || hasQuad(mesh), options.snapShare, kindsOf(mesh, strokes.size())
  };
  // Parts of a face that lie in the middle of it are a quarter of it, a triangle's first corners of quads a
  // twelfth: what is no longer inverted stays so at the levels to come.
  const auto leastAt = [&](int level)
  {
    const double first = rule.quads && level == 0 && options.levels > 0 ? 3.0 : 1.0;
    return first * leastArea * options.canvasSide * options.canvasSide *
           std::pow(4.0, options.levels - level);
  };

  PlanarRefineResult result;
  const FaceEdges links = faceEdges(mesh);
  joinEnds(mesh, curves);
  std::set<int> given; // bases that faces stay inverted in
  const auto give = [&](const PlanarMesh& at, const std::vector<int>& bad)
  {
    for (const int f : bad)
    {
      given.insert(at.faces[f].base);
    }
    result.inverted += static_cast<int>(bad.size());
  };
  SubdividedMesh level;
  level.mesh = options.levels == 0 ? splitChords(mesh) : mesh;
  level.links = links;
  if (options.guard)
  {
    give(level.mesh, invertedFaces(level.mesh, leastAt(0), context));
  }
  for (int k = 0; k < options.levels; ++k)
  {
    context.checkpoint(static_cast<double>(k) / options.levels);
    level = subdivide(level.mesh, level.links, curves, rule, k + 1 < options.levels, context);
    if (options.guard)
    {
      give(level.mesh, keepUpright(level, leastAt(k + 1), given, context));
      continue;
    }
    for (std::size_t p = 0; p < level.mesh.points.size(); ++p)
    {
      level.mesh.points[p].place = level.smooth[p];
    }
  }
  if (!given.empty())
  {
    result.splits = splitsAt(mesh, links, given);
    return result;
  }
  if (options.guard)
  {
    const double share = std::max(nearEnough, roundCurve / std::pow(4.0, options.levels));
    result.splits = missed(mesh, level.mesh, curves, share * options.canvasSide);
    if (!result.splits.empty())
    {
      return result;
    }
  }
  result.mesh = std::move(level.mesh);
  if (!options.guard) // else there is none
  {
    result.inverted = static_cast<int>(invertedFaces(result.mesh, leastAt(options.levels), context).size());
  }
  return result;
}

void addSplits(std::vector<StrokeSplit>& splits, const std::vector<StrokeSplit>& more)
{
  const std::vector<StrokeSplit> before = splits;
  for (StrokeSplit split : more)
  {
    for (const StrokeSplit& old : before)
    {
      if (old.stroke == split.stroke && old.start < split.end && split.start < old.end)
      {
        split.halvings = std::max(split.halvings, old.halvings + 1);
      }
    }
    splits.push_back(split);
  }
}

namespace
{

// Cuts the corner after each of these new points, in the middle of a face's edges, off: what is left has as
// many corners as the face. A new point's other edges end inside the face's own edges or at a corner across:
// no chord is among them.
void cutFace(const PlanarFace& face, const std::array<int, 4>& middles, std::vector<PlanarFace>& faces)
{
  std::vector<int> around;
  for (int i = 0; i < face.count(); ++i)
  {
    around.push_back(face.corners[i]);
    if (middles[i] >= 0)
    {
      around.push_back(middles[i]);
    }
  }
  PlanarFace part = face;
  for (int i = 0; i < face.count(); ++i)
  {
    if (middles[i] < 0)
    {
      continue;
    }
    const int count = static_cast<int>(around.size());
    const int at = static_cast<int>(std::find(around.begin(), around.end(), middles[i]) - around.begin());
    const int corner = (at + 1) % count;
    part.corners = { middles[i], around[corner], around[(at + 2) % count], -1 };
    faces.push_back(part);
    around.erase(around.begin() + corner);
  }
  part.corners = { -1, -1, -1, -1 };
  std::copy(around.begin(), around.end(), part.corners.begin());
  faces.push_back(part);
}

} // namespace

PlanarMesh splitChords(const PlanarMesh& mesh)
{
  const FaceEdges links = faceEdges(mesh);
  PlanarMesh made;
  made.points = mesh.points;
  made.edges = mesh.edges;
  std::vector<int> middles(links.edges.size(), -1);
  for (std::size_t e = 0; e < links.edges.size(); ++e)
  {
    const FaceEdge& edge = links.edges[e];
    const PlanarPoint &from = mesh.points[edge.from], &to = mesh.points[edge.to];
    if (edge.stroke < 0 && isRim(from.kind) && isRim(to.kind))
    {
      middles[e] = static_cast<int>(made.points.size());
      PlanarPoint middle;
      middle.place = 0.5 * (from.place + to.place);
      middle.isBase = true;
      made.points.push_back(middle);
    }
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    std::array<int, 4> ofFace{ -1, -1, -1, -1 };
    for (int i = 0; i < mesh.faces[f].count(); ++i)
    {
      ofFace[i] = middles[links.ofFace[f][i]];
    }
    cutFace(mesh.faces[f], ofFace, made.faces);
  }
  return made;
}

} // namespace oversketch
