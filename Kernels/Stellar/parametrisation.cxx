#include "Stellar/parametrisation.h"

#include <algorithm>
#include <numeric>

namespace oversketch
{

Parametrisation::Parametrisation(const Mesh& original)
  : points(original.points)
  , faces(original.triangles)
  , madeBy(original.triangles.size(), -1)
  , goneBy(original.triangles.size(), -1)
  , removedBy(original.points.size(), -1)
{
}

int Parametrisation::add(const std::vector<int>& old,
  const std::vector<std::pair<int, Vector2>>& flattened,
  const std::vector<Triangle>& made,
  int removed)
{
  const int record = static_cast<int>(this->records.size()), first = static_cast<int>(this->faces.size());
  this->records.push_back({ static_cast<int>(this->flat.size()),
    static_cast<int>(flattened.size()),
    static_cast<int>(this->oldFaces.size()),
    static_cast<int>(old.size()),
    first,
    static_cast<int>(made.size()) });
  for (const auto& [vertex, at] : flattened)
  {
    this->flatVertex.push_back(vertex);
    this->flat.push_back(at);
  }
  for (int f : old)
  {
    this->oldFaces.push_back(f);
    this->goneBy[f] = record;
  }
  for (const Triangle& t : made)
  {
    this->faces.push_back(t);
    this->madeBy.push_back(record);
    this->goneBy.push_back(-1);
  }
  if (removed >= 0)
  {
    this->removedBy[removed] = record;
  }
  return first;
}

Vector2 Parametrisation::flatOf(const Record& record, int vertex) const
{
  const auto begin = this->flatVertex.begin() + record.firstFlat;
  return this->flat[std::find(begin, begin + record.flatCount, vertex) - this->flatVertex.begin()];
}

Vector2 Parametrisation::flatten(const Record& record, int face, const Vector3& weights) const
{
  const Triangle& t = this->faces[face];
  return weights[0] * this->flatOf(record, t[0]) + weights[1] * this->flatOf(record, t[1]) +
         weights[2] * this->flatOf(record, t[2]);
}

// The face that holds q, or by rounding misses it least, and the weights of its corners there.
std::pair<int, Vector3> Parametrisation::containing(const Record& record,
  const int* candidates,
  int count,
  const Vector2& q) const
{
  std::pair<int, Vector3> best{ -1, Vector3::Zero() };
  double inside = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const Triangle& t = this->faces[candidates[i]];
    const Vector2 p = this->flatOf(record, t[0]), x = this->flatOf(record, t[1]) - p,
                  y = this->flatOf(record, t[2]) - p, d = q - p;
    const double area = x[0] * y[1] - x[1] * y[0];
    const double b = (d[0] * y[1] - d[1] * y[0]) / area, c = (x[0] * d[1] - x[1] * d[0]) / area;
    const Vector3 weights(1.0 - b - c, b, c);
    if (best.first < 0 || weights.minCoeff() > inside)
    {
      best = { candidates[i], weights };
      inside = weights.minCoeff();
    }
  }
  best.second = best.second.cwiseMax(0.0);
  best.second /= best.second.sum();
  return best;
}

SurfacePoint Parametrisation::original(int face, const Vector3& weights) const
{
  std::pair<int, Vector3> at{ face, weights };
  while (this->madeBy[at.first] >= 0)
  {
    const Record& record = this->records[this->madeBy[at.first]];
    at = this->containing(record,
      this->oldFaces.data() + record.firstOld,
      record.oldCount,
      this->flatten(record, at.first, at.second));
  }
  return { at.first, { at.second[0], at.second[1], at.second[2] } };
}

Vector3 Parametrisation::sample(int face, const Vector3& weights) const
{
  const SurfacePoint at = this->original(face, weights);
  const Triangle& t = this->faces[at.triangle];
  return at.weights[0] * this->points[t[0]] + at.weights[1] * this->points[t[1]] +
         at.weights[2] * this->points[t[2]];
}

std::pair<int, Vector3> Parametrisation::place(int point) const
{
  std::pair<int, Vector3> at{ -1, Vector3::Zero() };
  int by = this->removedBy[point];
  if (by < 0)
  {
    for (int f = static_cast<int>(this->faces.size()) - 1; f >= 0 && at.first < 0; --f)
    {
      const Triangle& t = this->faces[f];
      const auto corner = std::find(t.begin(), t.end(), point);
      if (this->goneBy[f] < 0 && corner != t.end())
      {
        at = { f, Vector3::Unit(corner - t.begin()) };
      }
    }
    return at;
  }
  Vector2 q = this->flatOf(this->records[by], point);
  for (;;)
  {
    const Record& record = this->records[by];
    std::vector<int> made(record.newCount);
    std::iota(made.begin(), made.end(), record.firstNew);
    at = this->containing(record, made.data(), record.newCount, q);
    by = this->goneBy[at.first];
    if (by < 0)
    {
      return at;
    }
    q = this->flatten(this->records[by], at.first, at.second);
  }
}

Source sourceOf(const Parametrisation& original,
  const std::vector<int>& faces,
  const BaseMesh& base,
  const Mesh& simplified)
{
  return [&original, &faces, &base, &simplified](const SourcePlace& at)
  {
    // Weights of the root's corners as weights of its triangle's; a corner that is none of these is the
    // middle.
    const int triangle = base.rootTriangle[at.root];
    const Triangle &corners = simplified.triangles[triangle], &root = base.rootCorners[at.root];
    Vector3 weights = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      const auto found = std::find(corners.begin(), corners.end(), root[k]);
      weights += at.weights[k] * (found != corners.end() ? Vector3(Vector3::Unit(found - corners.begin()))
                                                         : Vector3::Constant(1.0 / 3.0));
    }
    return original.sample(faces[triangle], weights);
  };
}

void putOnSource(Forest& forest, const Source& source)
{
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    if (forest.isVertex(v) && forest.vertices[v].level > 0)
    {
      forest.vertices[v].position = source(forest.place(v));
    }
  }
}

} // namespace oversketch
