#include "Inflate/swap_edges.h"

#include "Mesh/shape.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double leastGain = 1.0;  // px
constexpr double narrow = 0.25;    // of 30 degrees
constexpr double leastArea = 1e-3; // px^2

// A triangle's edge.
struct Side
{
  std::pair<int, int> ends; // ascending
  int face;
};

bool byEnds(const Side& a, const Side& b)
{
  return a.ends < b.ends;
}

// Ascending by (ends, face).
std::vector<Side> sidesOf(const PlanarMesh& mesh)
{
  std::vector<Side> sides;
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f)
  {
    const PlanarFace& face = mesh.faces[f];
    for (int k = 0; k < 3 && face.count() == 3; ++k)
    {
      sides.push_back({ std::minmax(face.corners[k], face.corners[(k + 1) % 3]), f });
    }
  }
  std::stable_sort(sides.begin(), sides.end(), byEnds);
  return sides;
}

class Swaps
{
public:
  Swaps(PlanarMesh& mesh,
    const std::vector<double>& heights,
    const HeightMaps& maps,
    const CrossSection& section,
    double factor)
    : Mesh(mesh)
    , Reader(maps)
    , Section(section)
    , Raster(maps.distance.frame)
    , Factor(factor)
  {
    for (std::size_t i = 0; i < heights.size(); ++i)
    {
      this->Places.emplace_back(mesh.points[i].place[0], mesh.points[i].place[1], heights[i]);
    }
  }

  // Swaps edges of which each face and each end of a new edge has one at most.
  int pass(const Context& context)
  {
    this->Sides = sidesOf(this->Mesh);
    std::vector<char> swaps(this->Sides.size(), 0);
    context.each(static_cast<int>(swaps.size()),
      [&](int i) { swaps[i] = this->isShared(i) && this->gains(this->around(i)); });
    context.checkpoint(1.0);
    std::vector<char> changed(this->Mesh.faces.size(), 0), ended(this->Mesh.points.size(), 0);
    int count = 0;
    for (std::size_t i = 0; i < swaps.size(); ++i)
    {
      if (!swaps[i])
      {
        continue;
      }
      const Quad quad = this->around(i);
      if (changed[quad.left] || changed[quad.right] || ended[quad.c] || ended[quad.d])
      {
        continue;
      }
      changed[quad.left] = changed[quad.right] = ended[quad.c] = ended[quad.d] = 1;
      this->Mesh.faces[quad.left].corners = { quad.a, quad.d, quad.c, -1 };
      this->Mesh.faces[quad.right].corners = { quad.d, quad.b, quad.c, -1 };
      ++count;
    }
    return count;
  }

private:
  // Triangles a b c to the left of an edge and b a d to its right.
  struct Quad
  {
    int a, b, c, d, left, right;
  };

  // Whether side i is the first of an edge's two.
  bool isShared(std::size_t i) const
  {
    const auto joins = [&](std::size_t k)
    { return k < this->Sides.size() && this->Sides[k].ends == this->Sides[i].ends; };
    return joins(i + 1) && !joins(i + 2) && !joins(i - 1);
  }

  Quad around(std::size_t i) const
  {
    const auto [a, b] = this->Sides[i].ends;
    Quad quad{ a, b, -1, -1, this->Sides[i].face, this->Sides[i + 1].face };
    const auto next = [&](int f, int point)
    {
      const auto& corners = this->Mesh.faces[f].corners;
      const auto at = std::find(corners.begin(), corners.begin() + 3, point) - corners.begin();
      return corners[(at + 1) % 3];
    };
    if (next(quad.left, a) != b)
    {
      std::swap(quad.left, quad.right);
    }
    quad.c = next(quad.left, b);
    quad.d = next(quad.right, a);
    return quad;
  }

  // How far an edge's middle lies off the surface [px].
  double offSurface(int p, int q, int object) const
  {
    const Vector3 middle = 0.5 * (this->Places[p] + this->Places[q]);
    const double height = this->Reader.height(this->Raster.toPixels(middle.head<2>()), object, this->Section);
    return std::abs(this->Factor * height - middle[2] / this->Raster.spacing);
  }

  bool gains(const Quad& quad) const
  {
    const auto [a, b, c, d, left, right] = quad;
    const PlanarFace &f = this->Mesh.faces[left], &g = this->Mesh.faces[right];
    const auto kind = [&](int p) { return this->Mesh.points[p].kind; };
    const auto onStroke = [&](int p) { return kind(p) != BoundaryKind::Interior; };
    if (f.region != g.region || f.object != g.object || (onStroke(a) && onStroke(b)) ||
        (isRim(kind(c)) && isRim(kind(d))) ||
        !(this->offSurface(a, b, f.object) - this->offSurface(c, d, f.object) > leastGain))
    {
      return false;
    }
    const auto area = [&](int p, int q, int r) {
      return signedArea(this->Mesh.points[p].place, this->Mesh.points[q].place, this->Mesh.points[r].place);
    };
    const double least = leastArea * this->Raster.spacing * this->Raster.spacing;
    const auto shape = [&](int p, int q, int r)
    { return narrowness(this->Places[p], this->Places[q], this->Places[r]); };
    // Where faces overlap, c and d may be joined already.
    return area(a, d, c) > least && area(d, b, c) > least &&
           std::min(shape(a, d, c), shape(d, b, c)) >= std::min({ narrow, shape(a, b, c), shape(b, a, d) }) &&
           !std::binary_search(this->Sides.begin(), this->Sides.end(), Side{ std::minmax(c, d), 0 }, byEnds);
  }

  PlanarMesh& Mesh;
  MapReader Reader;
  const CrossSection& Section;
  const Frame& Raster;
  double Factor;
  std::vector<Vector3> Places;
  std::vector<Side> Sides;
};

} // namespace

int swapEdges(PlanarMesh& mesh,
  const std::vector<double>& heights,
  const HeightMaps& maps,
  const CrossSection& section,
  double factor,
  const Context& context)
{
  Swaps swaps(mesh, heights, maps, section, factor);
  int count = 0;
  // The sum of what edges lie off the surface falls by each, so there is an end to it.
  for (int now = 1; now > 0; count += now)
  {
    now = swaps.pass(context);
  }
  return count;
}

} // namespace oversketch
