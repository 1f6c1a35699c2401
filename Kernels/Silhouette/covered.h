// The pixels of a mesh's picture, line by line: what its triangles cover of each, exactly.
#ifndef oversketch_kernels_silhouette_covered_h
#define oversketch_kernels_silhouette_covered_h

#include "Mesh/mesh.h"
#include "Mesh/view.h"
#include "Silhouette/outline.h"

#include <vector>

namespace oversketch
{

// The vertices seen in the image plane.
struct PicturePoints
{
  const Mesh& model;
  const View& from;
  std::vector<Vector2> points; // those that are seen
  std::vector<char> seen;      // per point: not behind the eye

  PicturePoints(const Mesh& mesh, const View& view, const Context& context);
  bool sees(const Triangle& t) const { return this->seen[t[0]] && this->seen[t[1]] && this->seen[t[2]]; }
  // A point's weight on screen: 1 orthographic, 1 / distance perspective.
  double nearness(int v) const
  {
    return this->from.perspective() ? -1.0 / this->from.toDisplay(this->model.points[v])[2] : 1.0;
  }
};

// Triangles seen in the image plane, those left out that reach behind the eye or lie outside the window.
struct MeshPicture : PicturePoints
{
  std::vector<Triangle> triangles;

  MeshPicture(const Mesh& mesh, const View& view, const PixelWindow& window, const Context& context);
};

// An end of a covered interval, on the mesh edge that makes it.
struct CoveredEnd
{
  double at = 0.0;
  int v0 = -1, v1 = -1;
  double t = 0.0; // on screen, from v0 to v1

  Binding binding(const PicturePoints& picture) const;
};

struct CoveredInterval
{
  CoveredEnd low, high;
};

// Intervals that the triangles cover of every pixel row (axis 1) or column (axis 0) of the window, measured
// along the line through the pixel centres: disjoint intervals in ascending order.
std::vector<std::vector<CoveredInterval>> coveredIntervals(const PicturePoints& picture,
  const std::vector<Triangle>& triangles,
  int axis,
  const PixelWindow& window,
  const Context& context);

constexpr int trianglesOfPart = 8192;

// Threads take parts of a mesh's triangles: how many there are.
inline int partCount(const Mesh& mesh)
{
  return (mesh.triangleCount() + trianglesOfPart - 1) / trianglesOfPart;
}

// Calls visit(part, triangle) for all triangles of the mesh, those of a part in their order.
template <typename Visit>
void eachTriangle(const Mesh& mesh, const Context& context, const Visit& visit)
{
  context.each(partCount(mesh),
    [&](int part)
    {
      const int last = std::min((part + 1) * trianglesOfPart, mesh.triangleCount());
      for (int t = part * trianglesOfPart; t < last; ++t)
      {
        visit(part, mesh.triangles[t]);
      }
    });
}

} // namespace oversketch
#endif
