#include "Remesh/patch.h"

#include <algorithm>

namespace oversketch
{

namespace
{

bool contains(const Triangle& t, int v)
{
  return t[0] == v || t[1] == v || t[2] == v;
}

} // namespace

Patch::Patch(const Surface& surface,
  const std::vector<char>& active,
  const std::vector<double>& sizes,
  const std::vector<int>& protectedVertices,
  const std::vector<std::array<int, 2>>& protectedEdges)
  : surface_(surface)
  , inputSizes_(sizes)
  , points_(surface.mesh().points)
  , places_(points_.size())
  , sizes_(sizes)
  , fixed_(points_.size(), 0)
  , border_(points_.size(), 0)
  , mergedInto_(points_.size())
  , triangles_(surface.mesh().triangles)
  , active_(active)
  , charts_(triangles_.size())
  , rings_(points_.size())
{
  std::vector<char> inside(this->points_.size(), 0);
  for (int t = 0; t < this->triangleCount(); ++t)
  {
    this->charts_[t] = surface.chart(t);
    for (int k = 0; active[t] && k < 3; ++k)
    {
      inside[this->triangles_[t][k]] = 1;
      SurfacePoint at{ t, { 0.0, 0.0, 0.0 } };
      at.weights[k] = 1.0;
      this->places_[this->triangles_[t][k]] = at;
    }
  }
  for (int t = 0; t < this->triangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = this->triangles_[t][k];
      if (inside[v] && (this->rings_[v].empty() || this->rings_[v].back() != t))
      {
        this->rings_[v].push_back(t);
      }
    }
  }
  const auto protect = [this](int a, int b)
  {
    this->protectedEdges_.insert(std::minmax(a, b));
    this->fixed_[a] = this->fixed_[b] = 1;
  };
  for (const std::array<int, 2>& e : protectedEdges)
  {
    protect(e[0], e[1]);
  }
  for (const int v : protectedVertices)
  {
    this->fixed_[v] = 1;
  }
  for (const std::array<int, 2>& e : this->edges())
  {
    Faces faces;
    bool border = false;
    const bool free = this->facesOf(e[0], e[1], faces, border);
    if (free && !border && this->charts_[faces[0]] != this->charts_[faces[1]])
    {
      protect(e[0], e[1]);
    }
    if (free && border)
    {
      this->border_[e[0]] = this->border_[e[1]] = 1;
    }
  }
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    this->mergedInto_[v] = v;
    if (!inside[v] || !this->discAt(v))
    {
      this->fixed_[v] = 1;
    }
  }
}

bool Patch::protectedEdge(int a, int b) const
{
  return this->fixed_[a] && this->fixed_[b] && this->protectedEdges_.count(std::minmax(a, b)) > 0;
}

// The triangles of an edge that may change: two alive ones wound alike (the first runs a to b), or the only
// one.
bool Patch::facesOf(int a, int b, Faces& faces, bool& border) const
{
  int count = 0;
  int forward = 0;
  for (const int t : this->rings_[a])
  {
    const Triangle& v = this->triangles_[t];
    if (!contains(v, b))
    {
      continue;
    }
    if (count == 2 || !this->active_[t])
    {
      return false;
    }
    const bool along = (v[0] == a && v[1] == b) || (v[1] == a && v[2] == b) || (v[2] == a && v[0] == b);
    forward += along ? 1 : 0;
    faces[count++] = t;
    if (count == 2 && along)
    {
      std::swap(faces[0], faces[1]);
    }
  }
  border = count == 1;
  return border || (count == 2 && forward == 1);
}

bool Patch::inner(int a, int b) const
{
  Faces faces;
  bool border = false;
  return this->facesOf(a, b, faces, border) && !border;
}

bool Patch::splittable(int a, int b) const
{
  Faces faces;
  bool border = false;
  return this->facesOf(a, b, faces, border);
}

int Patch::opposite(int t, int a, int b) const
{
  const Triangle& v = this->triangles_[t];
  return v[0] != a && v[0] != b ? v[0] : v[1] != a && v[1] != b ? v[1] : v[2];
}

// One closed fan of alive triangles, wound alike.
bool Patch::discAt(int v) const
{
  const std::vector<int>& ring = this->rings_[v];
  Faces faces;
  bool border = false;
  for (const int t : ring)
  {
    for (const int w : this->triangles_[t])
    {
      if (!this->active_[t] || (w != v && (!this->facesOf(v, w, faces, border) || border)))
      {
        return false;
      }
    }
  }
  std::size_t steps = 0;
  int t = ring.empty() ? -1 : ring[0];
  while (t >= 0 && steps < ring.size())
  {
    // The corner before v in t leads to the next triangle around v.
    const Triangle& c = this->triangles_[t];
    const int before = c[0] == v ? c[2] : c[1] == v ? c[0] : c[1];
    this->facesOf(v, before, faces, border);
    t = faces[0];
    ++steps;
    if (t == ring[0])
    {
      break;
    }
  }
  return !ring.empty() && steps == ring.size();
}

std::vector<std::array<int, 2>> Patch::edges() const
{
  // Upper ends bucketed by lower end, then sorted per bucket: several times quicker than sorting pairs.
  std::vector<int> offsets(this->points_.size() + 1, 0);
  const auto eachSide = [this](auto&& visit)
  {
    for (int t = 0; t < this->triangleCount(); ++t)
    {
      for (int k = 0; this->active_[t] && k < 3; ++k)
      {
        const int a = this->triangles_[t][k];
        const int b = this->triangles_[t][(k + 1) % 3];
        visit(std::min(a, b), std::max(a, b));
      }
    }
  };
  eachSide([&](int a, int) { ++offsets[a + 1]; });
  for (std::size_t i = 1; i < offsets.size(); ++i)
  {
    offsets[i] += offsets[i - 1];
  }
  std::vector<int> upper(offsets.back());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  eachSide([&](int a, int b) { upper[next[a]++] = b; });
  std::vector<std::array<int, 2>> result;
  result.reserve(upper.size() / 2 + 1);
  for (int a = 0; a < this->vertexCount(); ++a)
  {
    const auto begin = upper.begin() + offsets[a], end = upper.begin() + offsets[a + 1];
    std::sort(begin, end);
    const auto last = std::unique(begin, end);
    for (auto b = begin; b != last; ++b)
    {
      result.push_back({ a, *b });
    }
  }
  return result;
}

int Patch::valence(int v) const
{
  return static_cast<int>(this->rings_[v].size()) + this->border_[v];
}

double Patch::sizeAt(const SurfacePoint& at) const
{
  const Triangle& t = this->surface_.mesh().triangles[at.triangle];
  return at.weights[0] * this->inputSizes_[t[0]] + at.weights[1] * this->inputSizes_[t[1]] +
         at.weights[2] * this->inputSizes_[t[2]];
}

} // namespace oversketch
