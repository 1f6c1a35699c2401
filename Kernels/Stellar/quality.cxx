#include "Stellar/quality.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr double cornerCosine = 0.70710678118654752440; // a boundary that turns by more stays

} // namespace

double squaredSine(double degrees)
{
  const double sine = std::sin(degrees * degree);
  return sine * sine;
}

bool mayMove(const Forest& forest,
  int v,
  const Vector3& to,
  double minimumAngle,
  const std::vector<Vector3>* first)
{
  const Vector3& from = forest.vertices[v].position;
  const auto was = [&](int w) -> const Vector3& { return first ? (*first)[w] : forest.vertices[w].position; };
  double after = 1.0;
  bool turned = false;
  forest.star(v,
    [&](int f, int i)
    {
      const Forest::Face& face = forest.faces[f];
      const int second = face.v[(i + 1) % 3], third = face.v[(i + 2) % 3];
      const Vector3 &b = forest.vertices[second].position, &c = forest.vertices[third].position;
      const Vector3 old = (was(second) - was(v)).cross(was(third) - was(v));
      turned = turned || (!old.isZero(0.0) && !(old.dot((b - to).cross(c - to)) > 0.0));
      after = std::min(after, narrowness(to, b, c));
    });
  if (turned || after >= squaredSine(minimumAngle))
  {
    return !turned;
  }
  double before = 1.0;
  forest.star(v,
    [&](int f, int i)
    {
      const Forest::Face& face = forest.faces[f];
      before = std::min(before,
        narrowness(from,
          forest.vertices[face.v[(i + 1) % 3]].position,
          forest.vertices[face.v[(i + 2) % 3]].position));
    });
  return after >= before;
}

bool keepsToLines(const Forest& forest, int v, int towards, const std::vector<int>& parts)
{
  if (!forest.onBoundary(v) && !forest.onSeam(v, parts))
  {
    return true;
  }
  std::vector<int> ways; // the other ends of its edges on the boundary and on seams
  forest.star(v,
    [&](int f, int i)
    {
      const Forest::Face& face = forest.faces[f];
      if (face.n[(i + 2) % 3] < 0 || forest.isSeam(f, (i + 2) % 3, parts))
      {
        ways.push_back(face.v[(i + 1) % 3]);
      }
      if (face.n[(i + 1) % 3] < 0) // the last face's other edge
      {
        ways.push_back(face.v[(i + 2) % 3]);
      }
    });
  if (ways.size() != 2 || (towards != ways[0] && towards != ways[1]))
  {
    return false;
  }
  const Vector3 in = forest.vertices[v].position - forest.vertices[ways[0]].position;
  const Vector3 out = forest.vertices[ways[1]].position - forest.vertices[v].position;
  return in.dot(out) >= cornerCosine * in.norm() * out.norm();
}

double narrowestOf(const Forest& forest, const std::vector<Forest::Birth>& births)
{
  double least = 1.0;
  for (const Forest::Birth& birth : births)
  {
    for (const int f : { birth.parent, birth.child })
    {
      if (forest.isFace(f))
      {
        least =
          std::min(least, narrowness(forest.cornerOf(f, 0), forest.cornerOf(f, 1), forest.cornerOf(f, 2)));
      }
    }
  }
  return least;
}

void weldBack(Forest& forest, const std::vector<Forest::Birth>& births)
{
  for (auto birth = births.rbegin(); birth != births.rend(); ++birth)
  {
    if (forest.isVertex(birth->vertex)) // not gone with its twin
    {
      forest.weld(birth->vertex);
    }
  }
}

namespace
{

// Whether a triangle comes nearer to a curve than the radius: sure of all that does, by mistake also of some
// that are farther by an eighth of the radius, or a sixty-fourth of themselves.
bool comesNear(const CurveSearch& search,
  int curve,
  double radius,
  const std::array<Vector3, 3>& t,
  int halvings = 6)
{
  const Vector3 middle = (t[0] + t[1] + t[2]) / 3.0;
  double reach = 0.0;
  for (const Vector3& corner : t)
  {
    reach = std::max(reach, (corner - middle).norm());
  }
  const double distance = search.nearest(curve, middle, radius + reach).distance;
  if (!(distance < radius + reach) || distance < radius || reach < 0.125 * radius || halvings == 0)
  {
    return distance < radius + reach;
  }
  const std::array<Vector3, 3> half{ (t[1] + t[2]) / 2.0, (t[2] + t[0]) / 2.0, (t[0] + t[1]) / 2.0 };
  for (int k = 0; k < 3; ++k)
  {
    if (comesNear(search, curve, radius, { t[k], half[(k + 2) % 3], half[(k + 1) % 3] }, halvings - 1))
    {
      return true;
    }
  }
  return comesNear(search, curve, radius, half, halvings - 1);
}

} // namespace

CurveNeighbourhood neighbourhoodOf(const Mesh& mesh,
  const FeatureCurves& curves,
  double radius,
  const Context& context)
{
  const double thin = squaredSine(15.0);
  const CurveSearch search(curves);
  const auto radii = mapped(curves, [&](const FeatureCurve& curve) { return curve.radius.value_or(radius); });
  std::vector<char> near(mesh.triangles.size(), 0);
  std::vector<double> edges(near.size(), 0.0), weights = edges, ofThin = edges;
  context.eachUntilCancelled(mesh.triangleCount(),
    [&](int f)
    {
      const Triangle& v = mesh.triangles[f];
      const std::array<Vector3, 3> t{ mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]] };
      Eigen::AlignedBox3d box;
      for (const Vector3& corner : t)
      {
        box.extend(corner);
      }
      for (std::size_t k = 0; k < radii.size() && !near[f]; ++k)
      {
        const int curve = static_cast<int>(k);
        if (box.exteriorDistance(search.box(curve)) < radii[k] && comesNear(search, curve, radii[k], t))
        {
          const double longest = std::sqrt(std::max(
            { (t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm() }));
          near[f] = 1;
          edges[f] = longest;
          weights[f] = longest > 0.25 * radii[k] ? longest : 0.0;
          ofThin[f] = narrowness(t[0], t[1], t[2]) < thin ? weights[f] : 0.0;
        }
      }
    });
  context.checkpoint(1.0);
  CurveNeighbourhood found;
  found.vertices.assign(mesh.points.size(), 0);
  double all = 0.0, some = 0.0, length = 0.0;
  int count = 0;
  std::vector<char> touched(mesh.points.size(), 0);
  for (int f = 0; f < mesh.triangleCount(); ++f)
  {
    all += weights[f];
    some += ofThin[f];
    length += edges[f];
    count += near[f];
    for (const int v : mesh.triangles[f])
    {
      touched[v] |= near[f];
    }
  }
  for (const Triangle& t : mesh.triangles)
  {
    if (touched[t[0]] || touched[t[1]] || touched[t[2]])
    {
      found.vertices[t[0]] = found.vertices[t[1]] = found.vertices[t[2]] = 1;
    }
  }
  found.meanEdge = count > 0 ? length / count : 0.0;
  found.thinShare = all > 0.0 ? some / all : 0.0;
  return found;
}

} // namespace oversketch
