#include "Planar/guard.h"

#include "Mesh/shape.h"

#include <algorithm>

namespace oversketch
{

namespace
{

constexpr int passesWithoutRing = 6;
constexpr double leastWeight = 0.1;

// The faces that share a point with one of these, ascending.
std::vector<int> withTheirRing(const PlanarMesh& mesh, const Lists& at, const std::vector<int>& faces)
{
  std::vector<int> ring;
  for (const int f : faces)
  {
    const PlanarFace& face = mesh.faces[f];
    for (int i = 0; i < face.count(); ++i)
    {
      ring.insert(ring.end(), at.begin(face.corners[i]), at.end(face.corners[i]));
    }
  }
  sortUnique(ring);
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
  sortUnique(points);
  return points;
}

// Where a point is, `placeOf` says.
template <typename PlaceOf>
bool isInvertedAt(const PlaceOf& placeOf, const PlanarFace& face, double least)
{
  const int count = face.count();
  if (count == 3)
  {
    return !(
      signedArea(placeOf(face.corners[0]), placeOf(face.corners[1]), placeOf(face.corners[2])) > least);
  }
  const auto place = [&](int i) -> const Vector2& { return placeOf(face.corners[i % count]); };
  for (int i = 0; i < count; ++i)
  {
    if (!(signedArea(place(i), place(i + 1), place(i + 2)) > least))
    {
      return true;
    }
  }
  return false;
}

template <typename PlaceOf>
std::vector<int> invertedAt(const PlaceOf& placeOf,
  const std::vector<PlanarFace>& all,
  double least,
  const Context& context)
{
  std::vector<char> inverted(all.size());
  context.each(
    static_cast<int>(all.size()), [&](int f) { inverted[f] = isInvertedAt(placeOf, all[f], least); });
  return marked(inverted);
}

} // namespace

std::vector<int> invertedFaces(const PlanarMesh& mesh, double least, const Context& context)
{
  return invertedAt(
    [&](int p) -> const Vector2& { return mesh.points[p].place; }, mesh.faces, least, context);
}

std::vector<int> keepUpright(SubdividedMesh& level,
  double least,
  const std::set<int>& given,
  const Context& context)
{
  std::vector<PlanarPoint>& points = level.mesh.points;
  const auto isGiven = [&](int f) { return given.count(level.mesh.faces[f].base) > 0; };
  std::vector<int> bad =
    invertedAt([&](int p) -> const Vector2& { return level.smooth[p]; }, level.mesh.faces, least, context);
  if (std::all_of(bad.begin(), bad.end(), isGiven))
  {
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      points[p].place = level.smooth[p];
    }
    return {};
  }
  Lists facesAtPoint; // once it is asked for
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
    if (pass > 1)
    {
      bad = invertedFaces(level.mesh, least, context);
    }
    bad.erase(std::remove_if(bad.begin(), bad.end(), isGiven), bad.end());
    if (movable(level.mesh, bad, weights).empty())
    {
      return bad;
    }
    if (pass == passesWithoutRing + 1)
    {
      facesAtPoint = facesAtPoints(level.mesh);
    }
    const std::vector<int> around =
      pass > passesWithoutRing ? withTheirRing(level.mesh, facesAtPoint, bad) : bad;
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
