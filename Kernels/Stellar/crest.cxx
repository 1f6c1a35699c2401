#include "Stellar/crest.h"

#include "Mesh/nearest.h"

#include <cmath>
#include <limits>

namespace oversketch
{

namespace
{

constexpr int stepsPerRadius = 20;
constexpr int mostPlaces = 100000; // of one curve; longer ones are looked at less often

// A place on a face, and how far it is from where it was sought.
struct Near
{
  int face = -1;
  Vector3 weights = Vector3::Zero();
  double distance = std::numeric_limits<double>::infinity();
};

Near nearIn(const Forest& forest, int f, const Vector3& at)
{
  const int* v = forest.faces[f].v;
  const Vector3 &a = forest.vertices[v[0]].position, &b = forest.vertices[v[1]].position,
                &c = forest.vertices[v[2]].position;
  const auto [wa, wb, wc] = closestWeights(a, b, c, at);
  const Vector3 w(wa, wb, wc);
  return { f, w, (w[0] * a + w[1] * b + w[2] * c - at).norm() };
}

// From face to face, over the edge or the corner that is nearest, while that comes nearer.
Near walk(const Forest& forest, Near from, const Vector3& at)
{
  for (bool better = true; better;)
  {
    better = false;
    const Near last = from;
    const auto look = [&](int g)
    {
      const Near near = nearIn(forest, g, at);
      if (near.distance < from.distance)
      {
        from = near;
        better = true;
      }
    };
    const Forest::Face& face = forest.faces[last.face];
    for (int k = 0; k < 3; ++k)
    {
      if (last.weights[k] == 1.0)
      {
        forest.star(face.v[k], [&](int g, int) { look(g); });
      }
      else if (last.weights[k] == 0.0 && face.n[k] >= 0)
      {
        look(face.n[k]);
      }
    }
  }
  return from;
}

} // namespace

std::vector<Binding> crestPlaces(const Forest& forest,
  const FeatureCurve& curve,
  double radius,
  const std::vector<int>& passed)
{
  std::vector<Binding> places;
  const double margin = curve.closed ? 0.0 : radius, length = curve.length - 2.0 * margin;
  if (!(length > 0.0) || passed.empty())
  {
    return places;
  }
  const double wanted = length * stepsPerRadius / radius;
  const int count = wanted < mostPlaces ? static_cast<int>(wanted) + 1 : mostPlaces;
  Near near;
  for (int i = 0; i < count; ++i)
  {
    const Vector3 at = curve.position(margin + (i + 0.5) * length / count);
    if (near.face < 0)
    {
      for (const int f : passed)
      {
        const Near other = nearIn(forest, f, at);
        near = other.distance < near.distance ? other : near;
      }
    }
    near = walk(forest, nearIn(forest, near.face, at), at);
    const int* v = forest.faces[near.face].v;
    places.push_back({ { v[0], v[1], v[2] }, { near.weights[0], near.weights[1], near.weights[2] } });
  }
  return places;
}

} // namespace oversketch
