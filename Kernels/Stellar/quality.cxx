#include "Stellar/quality.h"

#include <algorithm>
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
        const int* v = forest.faces[f].v;
        least = std::min(least,
          narrowness(
            forest.vertices[v[0]].position, forest.vertices[v[1]].position, forest.vertices[v[2]].position));
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

} // namespace oversketch
