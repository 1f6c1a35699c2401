#include "Planar/subdivide.h"

#include "Mesh/nearest.h"
#include "Planar/face_edges.h"
#include "Planar/pieces.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr double fullTurn = 6.283185307179586;

// Input of the steps of a level.
struct Level
{
  const PlanarMesh& mesh;
  const FaceEdges& links;
  const Context& context;

  int pointCount() const { return static_cast<int>(this->mesh.points.size()); }
  int edgeCount() const { return static_cast<int>(this->links.edges.size()); }
  int faceCount() const { return static_cast<int>(this->mesh.faces.size()); }
  const Vector2& place(int point) const { return this->mesh.points[point].place; }

  int edgePoint(int edge) const { return this->pointCount() + edge; }
  int facePoint(int face) const { return this->pointCount() + this->edgeCount() + face; }

  Vector2 middleOf(const FaceEdge& edge) const
  {
    return 0.5 * (this->place(edge.from) + this->place(edge.to));
  }

  Vector2 centreOf(const PlanarFace& face) const
  {
    Vector2 sum = Vector2::Zero();
    for (int i = 0; i < face.count(); ++i)
    {
      sum += this->place(face.corners[i]);
    }
    return sum / face.count();
  }
};

std::vector<PlanarPoint> linearPoints(const Level& level,
  const std::vector<StrokeByLength>& curves,
  const SubdivisionRule& rule)
{
  std::vector<PlanarPoint> points;
  points.reserve(level.pointCount() + level.edgeCount() + (rule.quads ? level.faceCount() : 0));
  points = level.mesh.points;
  points.resize(points.capacity());
  level.context.each(level.edgeCount(),
    [&](int e)
    {
      const FaceEdge& edge = level.links.edges[e];
      PlanarPoint& point = points[level.edgePoint(e)];
      if (edge.stroke < 0)
      {
        point.place = level.middleOf(edge);
        return;
      }
      const StrokeEdge& tie = level.mesh.edges[edge.stroke];
      point.stroke = tie.stroke;
      point.kind = rule.kinds[tie.stroke];
      point.param = curves[tie.stroke].wrapped(0.5 * (tie.start + tie.end));
      point.place = curves[tie.stroke].at(point.param);
    });
  if (rule.quads)
  {
    level.context.each(level.faceCount(),
      [&](int f) { points[level.facePoint(f)].place = level.centreOf(level.mesh.faces[f]); });
  }
  return points;
}

PlanarMesh linearMesh(const Level& level,
  const std::vector<StrokeByLength>& curves,
  const SubdivisionRule& rule)
{
  PlanarMesh made;
  made.points = linearPoints(level, curves, rule);
  made.faces.reserve(4 * level.mesh.faces.size());
  for (int f = 0; f < level.faceCount(); ++f)
  {
    PlanarFace child = level.mesh.faces[f];
    const PlanarFace face = child;
    const int count = face.count();
    std::array<int, 4> middles{ -1, -1, -1, -1 };
    for (int i = 0; i < count; ++i)
    {
      middles[i] = level.edgePoint(level.links.ofFace[f][i]);
    }
    for (int i = 0; i < count; ++i)
    {
      const int before = middles[(i + count - 1) % count];
      child.corners = rule.quads
                        ? std::array<int, 4>{ face.corners[i], middles[i], level.facePoint(f), before }
                        : std::array<int, 4>{ face.corners[i], middles[i], before, -1 };
      made.faces.push_back(child);
    }
    if (!rule.quads)
    {
      child.corners = middles;
      made.faces.push_back(child);
    }
  }
  made.edges.resize(2 * level.mesh.edges.size());
  for (int e = 0; e < level.edgeCount(); ++e)
  {
    if (level.links.edges[e].stroke < 0)
    {
      continue;
    }
    const int number = level.links.edges[e].stroke;
    const StrokeEdge& whole = level.mesh.edges[number];
    const double middle = 0.5 * (whole.start + whole.end);
    made.edges[2 * number] = { whole.from, level.edgePoint(e), whole.stroke, whole.start, middle };
    // Beyond a closed stroke's first sample lengths begin anew.
    const double start = curves[whole.stroke].wrapped(middle);
    made.edges[2 * number + 1] = { level.edgePoint(e),
      whole.to,
      whole.stroke,
      start,
      start < middle ? curves[whole.stroke].wrapped(whole.end) : whole.end };
  }
  return made;
}

double betaOf(int n)
{
  const double inner = 0.375 + 0.25 * std::cos(fullTurn / n);
  return (0.625 - inner * inner) / n;
}

// Where the masks have a point of the mesh that is not on its border; `usual` is the weight where six meet,
// as at all points that a level makes.
Vector2 loopPlace(const Level& level, double usual, int point)
{
  const Lists& at = level.links.atPoint;
  const int n = at.size(point);
  const double beta = n == 6 ? usual : betaOf(n);
  Vector2 sum = Vector2::Zero();
  for (const int e : at[point])
  {
    sum += level.place(level.links.edges[e].other(point));
  }
  return (1.0 - n * beta) * level.place(point) + beta * sum;
}

Vector2 catmullClarkPlace(const Level& level, const Polyline& smooth, int point)
{
  const Lists& edges = level.links.atPoint;
  const Lists& faces = level.links.facesAtPoint;
  const int n = edges.size(point);
  Vector2 faceSum = Vector2::Zero(), edgeSum = Vector2::Zero();
  for (const int f : faces[point])
  {
    faceSum += smooth[level.facePoint(f)];
  }
  for (const int e : edges[point])
  {
    edgeSum += level.middleOf(level.links.edges[e]);
  }
  return (faceSum / n + 2.0 * edgeSum / n + (n - 3) * level.place(point)) / n;
}

// And a new point of an edge with two faces.
Vector2 loopMiddle(const Level& level, const FaceEdge& edge)
{
  Vector2 across = Vector2::Zero();
  for (const int f : edge.faces)
  {
    const std::array<int, 4>& corners = level.mesh.faces[f].corners;
    across += level.place(corners[0] + corners[1] + corners[2] - edge.from - edge.to);
  }
  return 0.375 * (level.place(edge.from) + level.place(edge.to)) + 0.125 * across;
}

Vector2 catmullClarkMiddle(const Level& level, const Polyline& smooth, const FaceEdge& edge)
{
  return 0.25 * (level.place(edge.from) + level.place(edge.to) + smooth[level.facePoint(edge.faces[0])] +
                  smooth[level.facePoint(edge.faces[1])]);
}

bool onBorder(const FaceEdges& links, int point)
{
  for (const int e : links.atPoint[point])
  {
    if (links.edges[e].faces[1] < 0)
    {
      return true;
    }
  }
  return links.atPoint.size(point) == 0;
}

// Whether a point of the next level lies on the border.
bool isOnBorder(const Level& level, int point)
{
  const int e = point - level.pointCount();
  return e < 0 ? onBorder(level.links, point) : e < level.edgeCount() && level.links.edges[e].faces[1] < 0;
}

// Where the masks alone have the points; those of the mesh's border, which have none, and of rims where
// `linear` has them.
Polyline maskPlaces(const Level& level, const PlanarMesh& linear, bool quads)
{
  Polyline smooth(linear.points.size());
  const double usual = betaOf(6);
  for (int f = 0; quads && f < level.faceCount(); ++f)
  {
    smooth[level.facePoint(f)] = linear.points[level.facePoint(f)].place;
  }
  level.context.each(level.edgeCount(),
    [&](int e)
    {
      const FaceEdge& edge = level.links.edges[e];
      const int p = level.edgePoint(e);
      if (edge.faces[1] < 0 || isRim(linear.points[p].kind))
      {
        smooth[p] = linear.points[p].place;
      }
      else
      {
        smooth[p] = quads ? catmullClarkMiddle(level, smooth, edge) : loopMiddle(level, edge);
      }
    });
  level.context.each(level.pointCount(),
    [&](int p)
    {
      if (isRim(level.mesh.points[p].kind) || onBorder(level.links, p))
      {
        smooth[p] = linear.points[p].place;
      }
      else
      {
        smooth[p] = quads ? catmullClarkPlace(level, smooth, p) : loopPlace(level, usual, p);
      }
    });
  return smooth;
}

} // namespace

StrokeByLength::StrokeByLength(const DrawnStroke& stroke)
  : Stroke(stroke)
  , Lengths(arcLengths(stroke.points, stroke.closed))
{
}

void StrokeByLength::moveEnd(bool last, const Vector2& place)
{
  (last ? this->Stroke.points.back() : this->Stroke.points.front()) = place;
}

double StrokeByLength::wrapped(double length) const
{
  return this->closed() && length >= this->length() ? length - this->length() : length;
}

Vector2 StrokeByLength::at(double length) const
{
  const int count = static_cast<int>(this->Stroke.points.size());
  return placeAt(this->Lengths, count, this->wrapped(length)).of(this->Stroke.points);
}

double StrokeByLength::farthest(double start, double end, const Vector2& a, const Vector2& b) const
{
  double most = 0.0;
  for (const double turn : { 0.0, this->closed() ? this->length() : end })
  {
    auto at = std::upper_bound(this->Lengths.begin(), this->Lengths.end(), start - turn);
    for (; at != this->Lengths.end() && *at < end - turn; ++at)
    {
      const std::size_t sample = (at - this->Lengths.begin()) % this->Stroke.points.size();
      most = std::max(most, distanceToSegment(this->Stroke.points[sample], a, b));
    }
  }
  return most;
}

SubdividedMesh subdivide(const PlanarMesh& mesh,
  const FaceEdges& links,
  const std::vector<StrokeByLength>& curves,
  const SubdivisionRule& rule,
  bool goesOn,
  const Context& context)
{
  const Level level{ mesh, links, context };
  SubdividedMesh made;
  made.mesh = linearMesh(level, curves, rule);
  if (rule.quads)
  {
    made.links = faceEdges(made.mesh);
  }
  else
  {
    requireFinite(made.mesh);
    made.links = goesOn ? dividedEdges(mesh, links, made.mesh) : FaceEdges();
  }
  made.smooth = maskPlaces(level, made.mesh, rule.quads);
  const std::vector<PlanarPoint>& points = made.mesh.points;
  const int count = static_cast<int>(points.size());
  made.free.resize(points.size());
  level.context.each(count, [&](int p) { made.free[p] = points[p].stroke < 0; });
  if (std::all_of(rule.kinds.begin(), rule.kinds.end(), isRim))
  {
    return made; // of rims no mask has moved a point
  }
  // Ways of features' points, from where the masks would have them to where the strokes do.
  Polyline snaps;
  std::vector<char> snapped;
  for (int p = 0; p < count; ++p)
  {
    if (made.free[p])
    {
      continue;
    }
    if (rule.share != 0.0 && !isRim(points[p].kind) && !isOnBorder(level, p))
    {
      snaps.resize(points.size(), Vector2::Zero());
      snapped.resize(points.size(), 0);
      snaps[p] = points[p].place - made.smooth[p];
      snapped[p] = 1;
    }
    made.smooth[p] = points[p].place;
  }
  if (snapped.empty())
  {
    return made;
  }
  level.context.each(count,
    [&](int p)
    {
      if (!made.free[p])
      {
        return;
      }
      Vector2 sum = Vector2::Zero();
      int number = 0;
      const auto take = [&](int q)
      {
        if (snapped[q])
        {
          sum += snaps[q];
          ++number;
        }
      };
      if (rule.quads)
      {
        for (const int e : made.links.atPoint[p])
        {
          take(made.links.edges[e].other(p));
        }
      }
      else
      {
        forDividedNeighbours(links, level.pointCount(), p, take);
      }
      if (number > 0)
      {
        made.smooth[p] += rule.share / number * sum;
      }
    });
  return made;
}

} // namespace oversketch
