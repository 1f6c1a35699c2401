#include "Remesh/patch.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

// An edge of the shape: over 50 degrees, more than between the sides of a tube of eight, and no fold.
bool sharp(const Vector3& a, const Vector3& b)
{
  constexpr double limit = 0.4131759; // square of the cosine of 50 degrees
  const double dot = a.dot(b);
  return dot * std::abs(dot) < limit * (a.squaredNorm() * b.squaredNorm()) && !folded(a, b);
}

} // namespace

Patch::Patch(const Surface& surface,
  const std::vector<char>& active,
  const std::vector<double>& sizes,
  const std::vector<int>& protectedVertices,
  const std::vector<std::array<int, 2>>& protectedEdges,
  bool keepSmooth)
  : Original(surface)
  , InputSizes(sizes)
  , KeepSmooth(keepSmooth)
  , Points(surface.mesh().points)
  , Places(Points.size())
  , Sizes(sizes)
  , Fixed(Points.size(), 0)
  , Border(Points.size(), 0)
  , MergedInto(Points.size())
  , Out(Points.size(), -1)
  , Valence(Points.size(), 0)
  , Listed(Points.size(), -1)
  , Active(active)
  , Charts(surface.charts())
  , Twin(surface.twins())
  , Kept(Twin.size(), 0)
{
  // Splitting may well double the patch.
  const std::size_t room = 2 * this->Active.size(), places = 2 * this->Points.size();
  this->Origin.reserve(3 * room);
  this->Twin.reserve(3 * room);
  this->Kept.reserve(3 * room);
  this->Active.reserve(room);
  this->Points.reserve(places);
  this->Places.reserve(places);
  for (const Triangle& t : surface.mesh().triangles)
  {
    this->Origin.insert(this->Origin.end(), t.begin(), t.end());
  }
  for (int t = 0; t < this->triangleCount(); ++t)
  {
    for (int k = 0; active[t] && k < 3; ++k)
    {
      const int v = this->Origin[3 * t + k];
      this->Out[v] = 3 * t + k;
      SurfacePoint at{ t, { 0.0, 0.0, 0.0 } };
      at.weights[k] = 1.0;
      this->Places[v] = at;
      if (this->Twin[3 * t + k] == borderEdge)
      {
        this->Border[v] = this->Border[this->target(3 * t + k)] = 1;
      }
    }
  }
  const auto eachCorner = [this](auto&& visit)
  {
    for (int t = 0; t < this->triangleCount(); ++t)
    {
      const Triangle c = this->triangle(t);
      for (int k = 0; k < 3; ++k)
      {
        if (this->Out[c[k]] >= 0 && (k < 1 || c[k] != c[0]) && (k < 2 || c[k] != c[1]))
        {
          visit(c[k], t);
        }
      }
    }
  };
  eachCorner([this](int v, int) { ++this->Valence[v]; });
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    this->MergedInto[v] = v;
    if (this->Out[v] < 0)
    {
      this->Fixed[v] = 1;
    }
    else if (!this->isDisc(v))
    {
      this->Fixed[v] = 1;
      this->Listed[v] = static_cast<int>(this->Lists.size());
      this->Lists.emplace_back();
    }
  }
  eachCorner([this](int v, int t) { this->attach(v, t); });
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    this->Valence[v] += this->Border[v];
  }
  for (int h = 0; h < static_cast<int>(this->Twin.size()); ++h)
  {
    const int twin = this->Twin[h];
    if (twin >= 0 && (this->chart(h / 3) != this->chart(twin / 3) ||
                       (keepSmooth && h < twin && sharp(this->cross(h / 3), this->cross(twin / 3)))))
    {
      this->protect(h);
    }
  }
  for (const int v : protectedVertices)
  {
    this->Fixed[v] = 1;
  }
  for (const std::array<int, 2>& e : protectedEdges)
  {
    this->Fixed[e[0]] = this->Fixed[e[1]] = 1;
    const int h = this->find(e[0], e[1]);
    if (h >= 0)
    {
      this->protect(h);
    }
  }
}

void Patch::protect(int h)
{
  this->Fixed[this->origin(h)] = this->Fixed[this->target(h)] = 1;
  this->Kept[h] = 1;
  if (this->inner(h))
  {
    this->Kept[this->Twin[h]] = 1;
  }
}

// One closed fan of triangles of the patch, wound alike.
bool Patch::isDisc(int v) const
{
  int h = this->Out[v];
  for (int steps = 1; steps <= this->Valence[v]; ++steps)
  {
    h = this->Twin[previousHalfEdge(h)];
    if (h < 0)
    {
      return false;
    }
    if (h == this->Out[v])
    {
      return steps == this->Valence[v];
    }
  }
  return false;
}

// Keeps a triangle in the list of a vertex that has one.
void Patch::attach(int v, int t)
{
  if (this->Listed[v] >= 0)
  {
    this->Lists[this->Listed[v]].push_back(t);
  }
}

void Patch::detach(int v, int t)
{
  if (this->Listed[v] >= 0)
  {
    std::vector<int>& list = this->Lists[this->Listed[v]];
    list.erase(std::find(list.begin(), list.end(), t));
  }
}

int Patch::addVertex(const SurfacePoint& at, const Vector3& position, bool fixedVertex, bool border)
{
  const int v = this->vertexCount();
  this->Points.push_back(position);
  this->Places.push_back(at);
  this->Sizes.push_back(this->sizeAt(at));
  this->Fixed.push_back(fixedVertex);
  this->Border.push_back(border);
  this->MergedInto.push_back(v);
  this->Out.push_back(-1);
  this->Valence.push_back(border);
  this->Listed.push_back(-1);
  if (border)
  {
    this->Listed.back() = static_cast<int>(this->Lists.size());
    this->Lists.emplace_back();
  }
  return v;
}

int Patch::addTriangle(int chart)
{
  this->Active.push_back(1);
  if (!this->Charts.empty())
  {
    this->Charts.push_back(chart);
  }
  this->Origin.resize(this->Origin.size() + 3);
  this->Twin.resize(this->Twin.size() + 3, borderEdge);
  this->Kept.resize(this->Kept.size() + 3, 0);
  return this->triangleCount() - 1;
}

double Patch::sizeAt(const SurfacePoint& at) const
{
  const Triangle& t = this->Original.mesh().triangles[at.triangle];
  return at.weights[0] * this->InputSizes[t[0]] + at.weights[1] * this->InputSizes[t[1]] +
         at.weights[2] * this->InputSizes[t[2]];
}

} // namespace oversketch
