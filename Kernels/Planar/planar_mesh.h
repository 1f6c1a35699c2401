// A drawing's mesh in the plane, and what ties it to the strokes: the values that its construction,
// refinement and inflation hand on. Source: image-assisted modelling, section 0.
#ifndef oversketch_kernels_planar_planar_mesh_h
#define oversketch_kernels_planar_planar_mesh_h

#include "Stroke/polyline.h"

#include <array>
#include <vector>

namespace oversketch
{

enum class BoundaryKind : int
{
  Interior = 0,
  Object = 1, // on the boundary of an object
  Hole = 2,   // on that of a hole
  Feature = 3,
  TunnelRim = 4
};

// Whether the surface is sealed there.
inline bool isRim(BoundaryKind kind)
{
  return kind == BoundaryKind::Object || kind == BoundaryKind::Hole;
}

// A point of the mesh.
struct PlanarPoint
{
  Vector2 place = Vector2::Zero(); // world
  BoundaryKind kind = BoundaryKind::Interior;
  int stroke = -1;     // that it lies on, of two the rim's; -1 on none
  double param = 0.0;  // where on it: arc length from its first sample [world]
  bool isBase = false; // a point of the coarse mesh
};

// Parts of a region that open strokes divide, from rim to rim, have regions of their own: the first part
// keeps the region's number, part k has k times this more. More regions are on no raster.
constexpr int regionStride = 1 << 20;

// The region that closed strokes bound, of a part of it.
inline int wholeRegion(int region)
{
  return region < 0 ? region : region % regionStride;
}

// A triangle, corner[3] < 0, or a quad; counter-clockwise.
struct PlanarFace
{
  std::array<int, 4> corners{ -1, -1, -1, -1 };
  int region = -1, object = -1;
  int base = -1; // the face of the coarse mesh that it is a part of

  int count() const { return this->corners[3] < 0 ? 3 : 4; }
};

// An edge that lies on a stroke: S(start) at `from`, S(end) at `to`, start < end. A closed stroke's first
// sample need not be a vertex: on the edge over it `end` is the whole length plus the param of `to`, so
// lengths are taken modulo the whole one. At an end that joins another stroke the point's place is not S's.
// Two points of one stroke that a chord joins have no edge.
struct StrokeEdge
{
  int from = -1, to = -1;
  int stroke = -1;
  double start = 0.0, end = 0.0;
};

struct PlanarMesh
{
  std::vector<PlanarPoint> points;
  std::vector<PlanarFace> faces;
  std::vector<StrokeEdge> edges;
};

// A part of a stroke between two arc lengths, whose approximation is to be made finer: `halvings` times so
// far.
struct StrokeSplit
{
  int stroke = -1;
  double start = 0.0, end = 0.0;
  int halvings = 1;
};

// A sample of another stroke that an open stroke's end lies at in the mesh, because it was drawn up to there.
struct StrokeJoin
{
  int stroke = -1, sample = -1;
};

// The approximation of a stroke: numbers of samples of it, ascending, those of an open one its ends too.
struct StrokePolyline
{
  int stroke = -1;
  bool closed = false;
  std::vector<int> samples;
  std::array<StrokeJoin, 2> joins; // of an open one's first and last sample; stroke -1: it lies where drawn
};

} // namespace oversketch
#endif
