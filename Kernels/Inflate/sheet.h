// The borders of a sheet of triangles and quads.
#ifndef oversketch_kernels_inflate_sheet_h
#define oversketch_kernels_inflate_sheet_h

#include <array>
#include <vector>

namespace oversketch
{

// An edge with one face, which lies on its left.
struct BorderEdge
{
  int from = -1, to = -1;
  int face = -1;
};

using Corners = std::array<int, 4>; // of a face; corner[3] < 0 of a triangle

template <typename Face>
std::vector<Corners> cornersOf(const std::vector<Face>& faces)
{
  return mapped(faces, &Face::corners);
}

// The border edges, ascending by `from`, of which each is there once. Throws Error(Failure::BadMesh), naming
// points, for a corner that is no point, an edge with more than two faces or two that are not turned the same
// way, and a point where two borders meet.
std::vector<BorderEdge> borderOf(const std::vector<Corners>& faces, int pointCount);

// The edges of a border between two of its points of the coarse mesh, the same everywhere: 2^k after k
// refinements. Throws Error(Failure::BadMesh) where they are not, naming the point.
int edgesBetweenBasePoints(const std::vector<BorderEdge>& border, const std::vector<char>& isBase);

} // namespace oversketch
#endif
