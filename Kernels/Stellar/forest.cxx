#include "Stellar/forest.h"

#include "Mesh/context.h"
#include "Stellar/staying.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace oversketch
{

Forest Forest::roomyCopy(std::size_t splits) const
{
  Forest copy;
  copy.faces.reserve(this->faces.size() + 2 * splits);
  copy.vertices.reserve(this->vertices.size() + splits);
  copy = *this; // keeps what was reserved
  return copy;
}

int Forest::firstFace(int v) const
{
  const int start = this->vertices[v].face;
  if (this->closed)
  {
    return start;
  }
  for (int f = start; f >= 0;)
  {
    const int before = this->faces[f].n[(this->corner(f, v) + 2) % 3];
    if (before < 0)
    {
      return f;
    }
    if (before == start)
    {
      return start;
    }
    f = before;
  }
  return -1;
}

bool Forest::onBoundary(int v) const
{
  const int first = this->firstFace(v);
  return first >= 0 && this->faces[first].n[(this->corner(first, v) + 2) % 3] < 0;
}

int Forest::faceWithEdge(int a, int b) const
{
  int found = -1;
  this->star(a,
    [&](int f, int i)
    {
      const Face& face = this->faces[f];
      if (face.v[(i + 1) % 3] == b || (face.v[(i + 2) % 3] == b && found < 0))
      {
        found = f;
      }
    });
  return found;
}

int Forest::newFace()
{
  if (this->FreeFaces.empty())
  {
    this->faces.emplace_back();
    return static_cast<int>(this->faces.size()) - 1;
  }
  const int f = this->FreeFaces.back();
  this->FreeFaces.pop_back();
  return f;
}

int Forest::newVertex()
{
  if (this->FreeVertices.empty())
  {
    this->vertices.emplace_back();
    if (!this->displacement.empty())
    {
      this->displacement.emplace_back(Vector3::Zero());
    }
    if (!this->feature.empty())
    {
      this->feature.push_back(0.0);
    }
    return static_cast<int>(this->vertices.size()) - 1;
  }
  const int v = this->FreeVertices.back();
  this->FreeVertices.pop_back();
  this->vertices[v] = Vertex();
  return v;
}

void Forest::replaceNeighbour(int f, int before, int after)
{
  if (f >= 0)
  {
    int* n = this->faces[f].n;
    n[n[0] == before ? 0 : n[1] == before ? 1 : 2] = after;
  }
}

int Forest::split(int f, const MidpointRule& rule, std::vector<Birth>* births)
{
  const int g = this->faces[f].n[0];
  assert(g < 0 || this->faces[g].n[0] == f);
  const int m = this->newVertex();
  const int f1 = this->newFace(), g1 = g < 0 ? -1 : this->newFace();
  const int a = this->faces[f].v[1], c = this->faces[f].v[2];
  const auto halve = [&](int child0, int child1, int twin0, int twin1)
  {
    Face& first = this->faces[child0];
    Face& second = this->faces[child1];
    const Face parent = first;
    second = { 2 * parent.path + 1,
      { m, parent.v[2], parent.v[0] },
      { parent.n[1], child0, twin0 },
      parent.root,
      static_cast<std::uint8_t>(parent.gen + 1) };
    first = { 2 * parent.path,
      { m, parent.v[0], parent.v[1] },
      { parent.n[2], twin1, child1 },
      parent.root,
      second.gen };
    this->replaceNeighbour(parent.n[1], child0, child1);
    if (births)
    {
      births->push_back({ child0, child1, m, parent.v[0] });
    }
  };
  halve(f, f1, g, g1);
  if (g >= 0)
  {
    halve(g, g1, f, f1);
  }
  Vertex& vertex = this->vertices[m];
  vertex.level = this->faces[f].gen;
  vertex.parents[0] = a;
  vertex.parents[1] = c;
  vertex.face = f;
  this->vertices[a].face = f;
  this->vertices[c].face = f1;
  this->putVertex(m, rule);
  return m;
}

// Where a new vertex lies, and what else it has from its parents.
void Forest::putVertex(int m, const MidpointRule& rule)
{
  Vertex& vertex = this->vertices[m];
  const int ia = vertex.parents[0], ic = vertex.parents[1];
  const Vertex &a = this->vertices[ia], &c = this->vertices[ic];
  vertex.position = 0.5 * a.position + 0.5 * c.position;
  if (this->hasBaseNormals)
  {
    const Vector3 sum = a.baseNormal + c.baseNormal;
    const double length = sum.norm();
    vertex.baseNormal = length > 0.0 ? Vector3(sum / length) : a.baseNormal;
  }
  if (!this->displacement.empty())
  {
    this->displacement[m] = 0.5 * (this->displacement[ia] + this->displacement[ic]);
  }
  if (!this->feature.empty())
  {
    this->feature[m] = 0.5 * (this->feature[ia] + this->feature[ic]);
  }
  if (rule.staying && rule.staying->at(*this, ia) && rule.staying->at(*this, ic))
  {
    return;
  }
  if (rule.curves && a.curveId >= 0 && a.curveId == c.curveId)
  {
    const FeatureCurve& curve = (*rule.curves)[a.curveId];
    const double apart = curve.apart(a.curveParam, c.curveParam);
    // Three corners of a triangle may be on the curve: the edge from the first to the last only cuts its bend
    // short, and its middle has no business near the one between (ours).
    bool shortcut = false;
    this->link(m,
      [&](int w)
      {
        const Vertex& other = this->vertices[w];
        shortcut = shortcut || (w != ia && w != ic && other.curveId == a.curveId &&
                                 curve.apart(a.curveParam, other.curveParam) +
                                     curve.apart(other.curveParam, c.curveParam) <=
                                   (1.0 + 1e-9) * apart);
      });
    if (!shortcut && apart <= 2.0 * (a.position - c.position).norm())
    {
      vertex.curveId = a.curveId;
      vertex.curveParam = curve.between(a.curveParam, c.curveParam);
      vertex.position = curve.position(vertex.curveParam);
      vertex.moved = Placed;
      return;
    }
  }
  const auto onSource = [&](int v)
  {
    const SourcePlace at = this->place(v);
    return (rule.source(at) - at.position).norm() <= rule.sourceTolerance;
  };
  if (rule.source && onSource(ia) && onSource(ic))
  {
    vertex.position = rule.source(this->place(m));
  }
}

int Forest::refine(int f, const MidpointRule& rule, std::vector<Birth>* births)
{
  std::array<int, maximumDepth + 4> stack{};
  int depth = 0;
  stack[0] = f;
  for (;;)
  {
    const int top = stack[depth], g = this->faces[top].n[0];
    if (g >= 0 && this->faces[g].n[0] != top)
    {
      assert(depth + 1 < static_cast<int>(stack.size()) && this->faces[g].gen < this->faces[top].gen);
      stack[++depth] = g;
      continue;
    }
    if (this->faces[top].path >> maximumDepth)
    {
      throw Error(Failure::BadMesh,
        "A triangle of root %1 was split %2 times, which is the limit; refine less deeply.",
        this->faces[top].root,
        maximumDepth);
    }
    const int m = this->split(top, rule, births);
    if (depth-- == 0)
    {
      return m;
    }
  }
}

int Forest::refineEdge(int a, int b, const MidpointRule& rule, std::vector<Birth>* births)
{
  for (int f = this->faceWithEdge(a, b); f >= 0; f = this->faceWithEdge(a, b))
  {
    const int apex = this->faces[f].v[0];
    const int m = this->refine(f, rule, births);
    if (apex != a && apex != b)
    {
      return m;
    }
  }
  return -1;
}

bool Forest::weldable(int w) const
{
  const Vertex& vertex = this->vertices[w];
  if (vertex.level == unusedLevel || vertex.parents[0] < 0)
  {
    return false;
  }
  bool fine = true;
  this->star(w, [&](int f, int) { fine = fine && this->faces[f].v[0] == w; });
  return fine;
}

// Puts the parent of two siblings back into child 0's slot, all but its n[0].
int Forest::restore(int child0)
{
  Face& face = this->faces[child0];
  const int child1 = face.n[2];
  const Face second = this->faces[child1];
  face = { face.path / 2,
    { face.v[1], face.v[2], second.v[1] },
    { -1, second.n[0], face.n[0] },
    face.root,
    static_cast<std::uint8_t>(face.gen - 1) };
  this->replaceNeighbour(second.n[0], child1, child0);
  for (int v : face.v)
  {
    this->vertices[v].face = child0;
  }
  this->faces[child1] = Face();
  this->FreeFaces.push_back(child1);
  return child0;
}

void Forest::weld(int w)
{
  assert(this->weldable(w));
  int firsts[2] = { -1, -1 }, count = 0;
  this->star(w,
    [&](int f, int)
    {
      if (this->faces[f].path % 2 == 0)
      {
        firsts[count++] = f;
      }
    });
  this->restore(firsts[0]);
  if (firsts[1] >= 0)
  {
    this->restore(firsts[1]);
    this->faces[firsts[0]].n[0] = firsts[1];
    this->faces[firsts[1]].n[0] = firsts[0];
  }
  this->vertices[w] = Vertex();
  this->vertices[w].level = unusedLevel;
  this->FreeVertices.push_back(w);
}

void Forest::rootWeights(int f, Vector3 weights[3]) const
{
  for (int i = 0; i < 3; ++i)
  {
    weights[i] = Vector3::Unit(i);
  }
  const std::uint64_t path = this->faces[f].path;
  for (int depth = 63 - __builtin_clzll(path); depth-- > 0;)
  {
    const Vector3 p = weights[0], a = weights[1], c = weights[2];
    const bool second = (path >> depth) & 1u;
    weights[0] = 0.5 * (a + c);
    weights[1] = second ? c : p;
    weights[2] = second ? p : a;
  }
}

SourcePlace Forest::place(int v) const
{
  int lowest = -1;
  this->star(v,
    [&](int f, int)
    {
      if (lowest < 0 || this->faces[f].root < this->faces[lowest].root)
      {
        lowest = f;
      }
    });
  if (lowest < 0)
  {
    return { -1, Vector3::Zero(), this->vertices[v].position };
  }
  Vector3 weights[3];
  this->rootWeights(lowest, weights);
  return { this->faces[lowest].root, weights[this->corner(lowest, v)], this->vertices[v].position };
}

Forest::FacePlace Forest::inStar(int v, const Vector3& place) const
{
  FacePlace best;
  double most = -std::numeric_limits<double>::infinity(); // the least weight
  this->star(v,
    [&](int f, int)
    {
      const Vector3& p = this->cornerOf(f, 0);
      const Vector3 x = this->cornerOf(f, 1) - p, y = this->cornerOf(f, 2) - p, up = x.cross(y);
      const double squared = up.squaredNorm();
      if (squared > 0.0)
      {
        const double wx = (place - p).cross(y).dot(up) / squared, wy = x.cross(place - p).dot(up) / squared;
        const Vector3 weights(1.0 - wx - wy, wx, wy);
        if (weights.minCoeff() > most)
        {
          most = weights.minCoeff();
          best = { f, weights };
        }
      }
    });
  return best;
}

Vector3 Forest::facetNormal(int f) const
{
  const Vector3& p = this->cornerOf(f, 0);
  const Vector3 n = (this->cornerOf(f, 1) - p).cross(this->cornerOf(f, 2) - p);
  const double length = n.norm();
  return length > 0.0 ? Vector3(n / length) : Vector3::Zero();
}

Vector3 Forest::vertexNormal(int v) const
{
  const Vector3& at = this->vertices[v].position;
  Vector3 sum = Vector3::Zero();
  this->star(v,
    [&](int f, int i)
    {
      const Face& face = this->faces[f];
      const Vector3 x = this->vertices[face.v[(i + 1) % 3]].position - at,
                    y = this->vertices[face.v[(i + 2) % 3]].position - at, n = x.cross(y);
      const double length = n.norm();
      if (length > 0.0)
      {
        sum += std::atan2(length, x.dot(y)) / length * n;
      }
    });
  const double length = sum.norm();
  return length > 0.0 ? Vector3(sum / length) : Vector3::Zero();
}

double Forest::diagonal() const
{
  Eigen::AlignedBox3d box;
  for (const Vertex& v : this->vertices)
  {
    if (v.face >= 0)
    {
      box.extend(v.position);
    }
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

std::string Forest::broken() const
{
  const auto at = [](const char* what, int id)
  { return std::string(what) + " " + std::to_string(id) + ": "; };
  std::vector<int> corners(this->vertices.size(), 0);
  for (int f = 0; f < static_cast<int>(this->faces.size()); ++f)
  {
    const Face& face = this->faces[f];
    if (face.root < 0)
    {
      continue;
    }
    int level[3];
    for (int i = 0; i < 3; ++i)
    {
      ++corners[face.v[i]];
      level[i] = this->vertices[face.v[i]].level;
      const int g = face.n[i], a = face.v[(i + 1) % 3], c = face.v[(i + 2) % 3];
      if (g < 0)
      {
        continue;
      }
      const Face& other = this->faces[g];
      const int j = other.n[0] == f ? 0 : other.n[1] == f ? 1 : 2;
      if (other.root < 0 || other.n[j] != f || other.v[(j + 1) % 3] != c || other.v[(j + 2) % 3] != a)
      {
        return at("face", f) + "a neighbour does not share its edge";
      }
      if (std::abs(int(other.gen) - int(face.gen)) > 1)
      {
        return at("face", f) + "generations of neighbours differ by more than one";
      }
      // The generation of an edge is the same from both sides.
      if (face.gen + (i > 0) != other.gen + (j > 0))
      {
        return at("face", f) + "an edge has two generations";
      }
    }
    if (face.gen != std::max({ level[0], level[1], level[2] }))
    {
      return at("face", f) + "its generation is not its highest level";
    }
    if (face.gen > 0 && (level[0] <= level[1] || level[0] <= level[2]))
    {
      return at("face", f) + "its first corner is not the newest alone";
    }
    if (face.gen > 0 && 1 + std::max(level[1], level[2]) != face.gen)
    {
      return at("face", f) + "its refinement edge has another generation";
    }
  }
  for (int v = 0; v < static_cast<int>(this->vertices.size()); ++v)
  {
    const Vertex& vertex = this->vertices[v];
    if (vertex.level == unusedLevel || (vertex.face < 0 && corners[v] == 0))
    {
      if (corners[v])
      {
        return at("vertex", v) + "is unused and has faces";
      }
      continue;
    }
    if (vertex.face < 0 || !this->isFace(vertex.face) ||
        this->faces[vertex.face].v[this->corner(vertex.face, v)] != v)
    {
      return at("vertex", v) + "its face is not of its star";
    }
    int count = 0;
    this->star(v, [&](int, int) { ++count; });
    if (count != corners[v])
    {
      return at("vertex", v) + "its star is in several pieces";
    }
  }
  return {};
}

void needBaseNormals(Forest& forest, const Context& context)
{
  if (forest.hasBaseNormals)
  {
    return;
  }
  context.eachUntilCancelled(static_cast<int>(forest.vertices.size()),
    [&](int v)
    {
      if (forest.isVertex(v))
      {
        forest.vertices[v].baseNormal = forest.vertexNormal(v);
      }
    });
  context.checkpoint(1.0);
  forest.hasBaseNormals = true;
}

} // namespace oversketch
