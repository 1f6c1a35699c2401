#include "Remesh/curve_mesh.h"

#include <algorithm>
#include <cstddef>

namespace oversketch
{

CurveMesh::CurveMesh(const Mesh& mesh)
  : marks(mesh.points.size(), 0)
  , Points(mesh.points)
  , Triangles(mesh.triangles)
  , InputAround(trianglesAround(mesh))
  , Sources(mesh.triangles.size())
  , InputCount(mesh.vertexCount())
  , InputTriangles(mesh.triangleCount())
  , Diagonal(boundingDiagonal(mesh))
{
  for (int t = 0; t < this->InputTriangles; ++t)
  {
    this->Sources[t] = t;
  }
}

const std::vector<int>& CurveMesh::around(int v) const
{
  const auto [known, isNew] = this->Around.try_emplace(v);
  if (isNew && !this->inserted(v))
  {
    known->second.assign(this->InputAround.begin(v), this->InputAround.end(v));
  }
  return known->second;
}

std::vector<int>& CurveMesh::listOf(int v)
{
  this->around(v);
  return this->Around.at(v);
}

Mix CurveMesh::origin(int v) const
{
  return this->inserted(v) ? this->Origins[v - this->InputCount] : Mix{ { v, 1.0 } };
}

std::vector<int> CurveMesh::piecesOf(int inputTriangle) const
{
  std::vector<int> pieces{ inputTriangle };
  const auto more = this->Pieces.find(inputTriangle);
  if (more != this->Pieces.end())
  {
    pieces.insert(pieces.end(), more->second.begin(), more->second.end());
  }
  return pieces;
}

std::vector<int> CurveMesh::trianglesAt(int a, int b) const
{
  std::vector<int> found;
  for (const int t : this->around(a))
  {
    if (cornerOf(this->Triangles[t], b) >= 0)
    {
      found.push_back(t);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool CurveMesh::joined(int a, int b) const
{
  const std::vector<int>& around = this->around(a);
  return std::any_of(
    around.begin(), around.end(), [&](int t) { return cornerOf(this->Triangles[t], b) >= 0; });
}

std::vector<int> CurveMesh::neighbours(int v) const
{
  std::vector<int> found;
  for (const int t : this->around(v))
  {
    for (const int w : this->Triangles[t])
    {
      if (w != v)
      {
        found.push_back(w);
      }
    }
  }
  sortUnique(found);
  return found;
}

int CurveMesh::opposite(int t, int a, int b) const
{
  for (const int v : this->Triangles[t])
  {
    if (v != a && v != b)
    {
      return v;
    }
  }
  return -1; // a triangle with a vertex twice
}

Vector3 CurveMesh::cross(int t) const
{
  const Triangle& corners = this->Triangles[t];
  const Vector3& a = this->Points[corners[0]];
  return (this->Points[corners[1]] - a).cross(this->Points[corners[2]] - a);
}

int CurveMesh::addPoint(const Vector3& point, Mix origin)
{
  this->Points.push_back(point);
  this->Origins.push_back(normalisedMix(std::move(origin)));
  this->marks.push_back(0);
  return static_cast<int>(this->Points.size()) - 1;
}

int CurveMesh::addTriangle(const Triangle& t, int source)
{
  const int id = static_cast<int>(this->Triangles.size());
  this->Triangles.push_back(t);
  this->Sources.push_back(source);
  this->Pieces[source].push_back(id);
  for (const int v : t)
  {
    this->listOf(v).push_back(id);
  }
  return id;
}

void CurveMesh::detach(int v, int t)
{
  std::vector<int>& around = this->listOf(v);
  around.erase(std::remove(around.begin(), around.end(), t), around.end());
}

void CurveMesh::replace(int t, int from, int to)
{
  Triangle& corners = this->Triangles[t];
  std::replace(corners.begin(), corners.end(), from, to);
  this->detach(from, t);
  this->listOf(to).push_back(t);
}

int CurveMesh::splitTriangle(int t, const std::array<double, 3>& weights)
{
  const Triangle corners = this->Triangles[t];
  Vector3 place = Vector3::Zero();
  Mix mix;
  for (int k = 0; k < 3; ++k)
  {
    place += weights[k] * this->Points[corners[k]];
    for (const auto& part : this->origin(corners[k]))
    {
      mix.emplace_back(part.first, weights[k] * part.second);
    }
  }
  const int m = this->addPoint(place, std::move(mix));
  this->replace(t, corners[0], m);
  this->addTriangle({ corners[0], m, corners[2] }, this->Sources[t]);
  this->addTriangle({ corners[0], corners[1], m }, this->Sources[t]);
  return m;
}

int CurveMesh::splitEdge(int a, int b, double s)
{
  Mix mix;
  for (const auto& part : this->origin(a))
  {
    mix.emplace_back(part.first, (1.0 - s) * part.second);
  }
  for (const auto& part : this->origin(b))
  {
    mix.emplace_back(part.first, s * part.second);
  }
  const int m = this->addPoint((1.0 - s) * this->Points[a] + s * this->Points[b], std::move(mix));
  for (const int t : this->trianglesAt(a, b))
  {
    Triangle other = this->Triangles[t];
    std::replace(other.begin(), other.end(), a, m);
    this->replace(t, b, m);
    this->addTriangle(other, this->Sources[t]);
  }
  if (this->onCurve(a) && this->onCurve(b))
  {
    for (MeshCurve& curve : this->curves)
    {
      for (int i = 0; i < curve.segments(); ++i)
      {
        const int j = curve.next(i);
        const bool forwards = curve.vertices[i] == a && curve.vertices[j] == b;
        if (forwards || (curve.vertices[i] == b && curve.vertices[j] == a))
        {
          // The last segment of a closed curve runs up to 1 + the first parameter.
          const double from = curve.parameters[i], to = curve.parameters[j] + (j <= i ? 1.0 : 0.0);
          const double along = from + (forwards ? s : 1.0 - s) * (to - from);
          curve.vertices.insert(curve.vertices.begin() + i + 1, m);
          curve.parameters.insert(curve.parameters.begin() + i + 1, along);
          ++this->marks[m];
          break;
        }
      }
    }
  }
  return m;
}

void CurveMesh::flip(int a, int b)
{
  const std::vector<int> both = this->trianglesAt(a, b);
  const int c = this->opposite(both[0], a, b), d = this->opposite(both[1], a, b);
  this->replace(both[0], b, d);
  this->replace(both[1], a, c);
}

void CurveMesh::collapse(int from, int to)
{
  for (const int t : this->trianglesAt(from, to))
  {
    for (const int v : Triangle(this->Triangles[t]))
    {
      this->detach(v, t);
    }
    this->Triangles[t] = { -1, -1, -1 };
  }
  for (const int t : std::vector<int>(this->around(from)))
  {
    this->replace(t, from, to);
  }
  for (MeshCurve& curve : this->curves)
  {
    const auto at = std::find(curve.vertices.begin(), curve.vertices.end(), from);
    if (at != curve.vertices.end())
    {
      curve.parameters.erase(curve.parameters.begin() + (at - curve.vertices.begin()));
      curve.vertices.erase(at);
    }
  }
  this->marks[from] = 0;
}

bool CurveMesh::curveEdge(int a, int b) const
{
  if (!this->onCurve(a) || !this->onCurve(b))
  {
    return false;
  }
  for (const MeshCurve& curve : this->curves)
  {
    for (int i = 0; i < curve.segments(); ++i)
    {
      const int v = curve.vertices[i], w = curve.vertices[curve.next(i)];
      if ((v == a && w == b) || (v == b && w == a))
      {
        return true;
      }
    }
  }
  return false;
}

void CurveMesh::markCurves()
{
  std::fill(this->marks.begin(), this->marks.end(), 0);
  for (const MeshCurve& curve : this->curves)
  {
    for (const int v : curve.vertices)
    {
      ++this->marks[v];
    }
  }
}

void cutLoops(MeshCurve& path, const CurveMesh& mesh)
{
  const auto lengthBetween = [&](std::size_t begin, std::size_t end)
  {
    double length = 0.0;
    for (std::size_t i = begin; i < end; ++i)
    {
      const int next = path.vertices[(i + 1) % path.vertices.size()];
      length += (mesh.point(next) - mesh.point(path.vertices[i])).norm();
    }
    return length;
  };
  std::unordered_map<int, std::size_t> places;
  for (std::size_t i = 0; i < path.vertices.size(); ++i)
  {
    const auto visited = places.find(path.vertices[i]);
    if (visited == places.end())
    {
      places.emplace(path.vertices[i], i);
      continue;
    }
    const std::size_t first = visited->second;
    const double loop = lengthBetween(first, i);
    const double rest = path.closed ? lengthBetween(0, path.vertices.size()) - loop : loop;
    if (loop > rest)
    {
      path.vertices.assign(path.vertices.begin() + static_cast<std::ptrdiff_t>(first),
        path.vertices.begin() + static_cast<std::ptrdiff_t>(i));
      path.parameters.assign(path.parameters.begin() + static_cast<std::ptrdiff_t>(first),
        path.parameters.begin() + static_cast<std::ptrdiff_t>(i));
      return;
    }
    for (std::size_t k = first + 1; k < i; ++k)
    {
      places.erase(path.vertices[k]);
    }
    path.vertices.erase(path.vertices.begin() + static_cast<std::ptrdiff_t>(first),
      path.vertices.begin() + static_cast<std::ptrdiff_t>(i));
    path.parameters.erase(path.parameters.begin() + static_cast<std::ptrdiff_t>(first),
      path.parameters.begin() + static_cast<std::ptrdiff_t>(i));
    i = first;
  }
}

} // namespace oversketch
