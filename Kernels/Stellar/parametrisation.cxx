#include "Stellar/parametrisation.h"

#include "Mesh/context.h"

#include <algorithm>
#include <numeric>
#include <string>

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

std::vector<SourceRoot> sourceRoots(const std::vector<int>& faces,
  const BaseMesh& base,
  const Mesh& simplified)
{
  std::vector<SourceRoot> roots;
  roots.reserve(base.rootTriangle.size());
  for (std::size_t r = 0; r < base.rootTriangle.size(); ++r)
  {
    const Triangle& corners = simplified.triangles[base.rootTriangle[r]];
    SourceRoot root{ faces[base.rootTriangle[r]], {} };
    for (int k = 0; k < 3; ++k) // what is none of the corners is the middle
    {
      root.corners[k] =
        static_cast<int>(std::find(corners.begin(), corners.end(), base.rootCorners[r][k]) - corners.begin());
    }
    roots.push_back(root);
  }
  return roots;
}

SurfacePoint OriginalSurface::at(const SourcePlace& place) const
{
  if (place.root < 0 || place.root >= static_cast<int>(this->roots.size()))
  {
    throw Error(Failure::BadMesh,
      "The source has no root %1 (field array SourceRoots); take the source that was made with the mesh.",
      place.root);
  }
  const SourceRoot& root = this->roots[place.root];
  Vector3 weights = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    weights += place.weights[k] * (root.corners[k] < 3 ? Vector3(Vector3::Unit(root.corners[k]))
                                                       : Vector3(Vector3::Constant(1.0 / 3.0)));
  }
  return this->records.original(root.face, weights);
}

Source sourceOf(const std::shared_ptr<const OriginalSurface>& surface)
{
  return [surface](const SourcePlace& place)
  {
    const SurfacePoint at = surface->at(place);
    const Triangle& t = surface->records.faces[at.triangle];
    const std::vector<Vector3>& points = surface->records.points;
    return Vector3(
      at.weights[0] * points[t[0]] + at.weights[1] * points[t[1]] + at.weights[2] * points[t[2]]);
  };
}

namespace
{

void refuse(bool bad, const std::string& what)
{
  if (bad)
  {
    throw Error(Failure::BadMesh,
      "%1 of the source; its records were changed or cut short. take it as it was made.",
      what);
  }
}

bool holds(const std::vector<std::pair<int, Vector2>>& flat, const Triangle& t)
{
  return std::all_of(t.begin(),
    t.end(),
    [&](int v)
    { return std::any_of(flat.begin(), flat.end(), [v](const auto& f) { return f.first == v; }); });
}

} // namespace

Parametrisation readRecords(const Mesh& original,
  const std::vector<Triangle>& made,
  const std::vector<std::array<int, 3>>& counts,
  const std::vector<int>& oldFaces,
  const std::vector<int>& flatVertex,
  const std::vector<Vector2>& flat)
{
  const auto points = static_cast<int>(original.points.size());
  Parametrisation result(original);
  std::size_t nextFlat = 0, nextOld = 0, nextNew = 0;
  std::vector<std::pair<int, Vector2>> laid;
  std::vector<int> old;
  for (std::size_t r = 0; r < counts.size(); ++r)
  {
    const std::string record = " of record " + std::to_string(r);
    const auto& [flatCount, oldCount, newCount] = counts[r];
    // A star that was flattened has four or five vertices and up to four faces.
    refuse(flatCount < 4 || flatCount > 5 || oldCount < 2 || oldCount > 4 || newCount < 1 || newCount > 2,
      "SourceRecords" + record);
    refuse(nextFlat + flatCount > flat.size() || flat.size() != flatVertex.size(), "SourceFlat" + record);
    refuse(nextOld + oldCount > oldFaces.size(), "SourceOldFaces" + record);
    refuse(nextNew + newCount > made.size(), "SourceFaces" + record);
    laid.clear();
    for (int i = 0; i < flatCount; ++i, ++nextFlat)
    {
      refuse(flatVertex[nextFlat] < 0 || flatVertex[nextFlat] >= points, "SourceFlatPoints" + record);
      refuse(!flat[nextFlat].allFinite(), "SourceFlat" + record);
      laid.emplace_back(flatVertex[nextFlat], flat[nextFlat]);
    }
    old.clear();
    for (int i = 0; i < oldCount; ++i, ++nextOld)
    {
      const int f = oldFaces[nextOld];
      refuse(f < 0 || f >= static_cast<int>(result.faces.size()) || result.goneBy[f] >= 0 ||
               !holds(laid, result.faces[f]),
        "SourceOldFaces" + record);
      old.push_back(f);
    }
    const std::vector<Triangle> faces(made.begin() + static_cast<std::ptrdiff_t>(nextNew),
      made.begin() + static_cast<std::ptrdiff_t>(nextNew + newCount));
    nextNew += newCount;
    int removed = -1; // the vertex that no new face has
    for (const auto& vertex : laid)
    {
      if (std::none_of(faces.begin(),
            faces.end(),
            [&](const Triangle& t) { return std::find(t.begin(), t.end(), vertex.first) != t.end(); }))
      {
        removed = vertex.first;
      }
    }
    refuse(!std::all_of(faces.begin(), faces.end(), [&](const Triangle& t) { return holds(laid, t); }),
      "SourceFaces" + record);
    result.add(old, laid, faces, removed);
  }
  refuse(nextFlat != flat.size(), "SourceFlat");
  refuse(nextOld != oldFaces.size(), "SourceOldFaces");
  refuse(nextNew != made.size(), "SourceFaces");
  return result;
}

void checkRoots(const OriginalSurface& surface)
{
  for (std::size_t r = 0; r < surface.roots.size(); ++r)
  {
    const SourceRoot& root = surface.roots[r];
    refuse(root.face < 0 || root.face >= static_cast<int>(surface.records.faces.size()) ||
             surface.records.goneBy[root.face] >= 0 ||
             std::any_of(root.corners.begin(), root.corners.end(), [](int k) { return k < 0 || k > 3; }),
      "SourceRoots of base triangle " + std::to_string(r));
  }
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
