#include "Remesh/patch.h"

#include <algorithm>

namespace oversketch
{

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
  , out_(points_.size(), -1)
  , valence_(points_.size(), 0)
  , listed_(points_.size(), -1)
  , active_(active)
  , charts_(surface.charts())
  , twin_(surface.twins())
  , kept_(twin_.size(), 0)
{
  // Splitting may well double the patch.
  const std::size_t room = 2 * this->active_.size();
  this->origin_.reserve(3 * room);
  for (const Triangle& t : surface.mesh().triangles)
  {
    this->origin_.insert(this->origin_.end(), t.begin(), t.end());
  }
  for (int t = 0; t < this->triangleCount(); ++t)
  {
    for (int k = 0; active[t] && k < 3; ++k)
    {
      const int v = this->origin_[3 * t + k];
      this->out_[v] = 3 * t + k;
      SurfacePoint at{ t, { 0.0, 0.0, 0.0 } };
      at.weights[k] = 1.0;
      this->places_[v] = at;
      if (this->twin_[3 * t + k] == borderEdge)
      {
        this->border_[v] = this->border_[this->target(3 * t + k)] = 1;
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
        if (this->out_[c[k]] >= 0 && (k < 1 || c[k] != c[0]) && (k < 2 || c[k] != c[1]))
        {
          visit(c[k], t);
        }
      }
    }
  };
  eachCorner([this](int v, int) { ++this->valence_[v]; });
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    this->mergedInto_[v] = v;
    if (this->out_[v] < 0)
    {
      this->fixed_[v] = 1;
    }
    else if (!this->isDisc(v))
    {
      this->fixed_[v] = 1;
      this->listed_[v] = static_cast<int>(this->lists_.size());
      this->lists_.emplace_back();
    }
  }
  eachCorner([this](int v, int t) { this->attach(v, t); });
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    this->valence_[v] += this->border_[v];
  }
  for (int h = 0; h < static_cast<int>(this->twin_.size()); ++h)
  {
    if (this->inner(h) && this->chart(h / 3) != this->chart(this->twin_[h] / 3))
    {
      this->protect(h);
    }
  }
  for (const int v : protectedVertices)
  {
    this->fixed_[v] = 1;
  }
  for (const std::array<int, 2>& e : protectedEdges)
  {
    this->fixed_[e[0]] = this->fixed_[e[1]] = 1;
    const int h = this->find(e[0], e[1]);
    if (h >= 0)
    {
      this->protect(h);
    }
  }
}

void Patch::protect(int h)
{
  this->fixed_[this->origin(h)] = this->fixed_[this->target(h)] = 1;
  this->kept_[h] = 1;
  if (this->inner(h))
  {
    this->kept_[this->twin_[h]] = 1;
  }
}

// One closed fan of triangles of the patch, wound alike.
bool Patch::isDisc(int v) const
{
  int h = this->out_[v];
  for (int steps = 1; steps <= this->valence_[v]; ++steps)
  {
    h = this->twin_[previousHalfEdge(h)];
    if (h < 0)
    {
      return false;
    }
    if (h == this->out_[v])
    {
      return steps == this->valence_[v];
    }
  }
  return false;
}

// Keeps a triangle in the list of a vertex that has one.
void Patch::attach(int v, int t)
{
  if (this->listed_[v] >= 0)
  {
    this->lists_[this->listed_[v]].push_back(t);
  }
}

void Patch::detach(int v, int t)
{
  if (this->listed_[v] >= 0)
  {
    std::vector<int>& list = this->lists_[this->listed_[v]];
    list.erase(std::find(list.begin(), list.end(), t));
  }
}

int Patch::addVertex(const SurfacePoint& at, bool fixedVertex, bool border)
{
  const int v = this->vertexCount();
  this->points_.push_back(positionOf(this->surface_.mesh(), at));
  this->places_.push_back(at);
  this->sizes_.push_back(this->sizeAt(at));
  this->fixed_.push_back(fixedVertex);
  this->border_.push_back(border);
  this->mergedInto_.push_back(v);
  this->out_.push_back(-1);
  this->valence_.push_back(border);
  this->listed_.push_back(-1);
  if (border)
  {
    this->listed_.back() = static_cast<int>(this->lists_.size());
    this->lists_.emplace_back();
  }
  return v;
}

int Patch::addTriangle(int chart)
{
  this->active_.push_back(1);
  if (!this->charts_.empty())
  {
    this->charts_.push_back(chart);
  }
  this->origin_.resize(this->origin_.size() + 3);
  this->twin_.resize(this->twin_.size() + 3, borderEdge);
  this->kept_.resize(this->kept_.size() + 3, 0);
  return this->triangleCount() - 1;
}

double Patch::sizeAt(const SurfacePoint& at) const
{
  const Triangle& t = this->surface_.mesh().triangles[at.triangle];
  return at.weights[0] * this->inputSizes_[t[0]] + at.weights[1] * this->inputSizes_[t[1]] +
         at.weights[2] * this->inputSizes_[t[2]];
}

} // namespace oversketch
