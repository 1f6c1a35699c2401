#include "Planar/guard.h"

#include <algorithm>

namespace oversketch
{

namespace
{

constexpr int passesWithoutRing = 6;
constexpr double leastWeight = 0.1;

// The faces that share a point with one of these, ascending.
std::vector<int> withTheirRing(const SubdividedMesh& level, const std::vector<int>& faces)
{
  std::vector<int> ring;
  for (const int f : faces)
  {
    const PlanarFace& face = level.mesh.faces[f];
    for (int i = 0; i < face.count(); ++i)
    {
      const Lists& at = level.links.facesAtPoint;
      ring.insert(ring.end(), at.begin(face.corners[i]), at.end(face.corners[i]));
    }
  }
  std::sort(ring.begin(), ring.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return ring;
}

// The points of these faces whose weight is not 0, ascending.
std::vector<int> movable(const PlanarMesh& mesh,
  const std::vector<int>& faces,
  const std::vector<double>& weights)
{
  std::vector<int> points;
  for (const int f : faces)
  {
    const PlanarFace& face = mesh.faces[f];
    std::copy_if(face.corners.begin(),
      face.corners.begin() + face.count(),
      std::back_inserter(points),
      [&](int p) { return weights[p] > 0.0; });
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

} // namespace

bool isInverted(const PlanarMesh& mesh, const PlanarFace& face, double least)
{
  const int count = face.count();
  const auto place = [&](int i) -> const Vector2& { return mesh.points[face.corners[i % count]].place; };
  for (int i = 0; i < (count == 4 ? 4 : 1); ++i)
  {
    if (!(signedArea(place(i), place(i + 1), place(i + 2)) > least))
    {
      return true;
    }
  }
  return false;
}

std::vector<int> invertedFaces(const PlanarMesh& mesh, double least, const Context& context)
{
  const int count = static_cast<int>(mesh.faces.size());
  std::vector<char> inverted(mesh.faces.size());
  context.parallelFor(count,
    [&](int begin, int end)
    {
      for (int f = begin; f < end; ++f)
      {
        inverted[f] = isInverted(mesh, mesh.faces[f], least);
      }
    });
  std::vector<int> faces;
  for (int f = 0; f < count; ++f)
  {
    if (inverted[f])
    {
      faces.push_back(f);
    }
  }
  return faces;
}

std::vector<int> keepUpright(SubdividedMesh& level,
  double least,
  const std::set<int>& given,
  const Context& context)
{
  std::vector<PlanarPoint>& points = level.mesh.points;
  Polyline linear(points.size());
  std::vector<double> weights(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    linear[p] = points[p].place;
    points[p].place = level.smooth[p];
    weights[p] = level.free[p] ? 1.0 : 0.0;
  }
  for (int pass = 1;; ++pass)
  {
    std::vector<int> bad = invertedFaces(level.mesh, least, context);
    const auto isGiven = [&](int f) { return given.count(level.mesh.faces[f].base) > 0; };
    bad.erase(std::remove_if(bad.begin(), bad.end(), isGiven), bad.end());
    if (movable(level.mesh, bad, weights).empty())
    {
      return bad;
    }
    const std::vector<int> around = pass > passesWithoutRing ? withTheirRing(level, bad) : bad;
    for (const int p : movable(level.mesh, around, weights))
    {
      const double w = 0.5 * weights[p];
      weights[p] = w < leastWeight ? 0.0 : w;
      points[p].place = w < leastWeight ? linear[p] : Vector2(w * level.smooth[p] + (1.0 - w) * linear[p]);
    }
    if (context.cancelled())
    {
      throw Error(Failure::Cancelled, "cancelled");
    }
  }
}

} // namespace oversketch
