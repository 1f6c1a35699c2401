// Attaching the visible silhouette to the outline of a mesh's picture (amendment to SEED, Sec. 3.3).
#ifndef oversketch_kernels_silhouette_attach_h
#define oversketch_kernels_silhouette_attach_h

#include "Silhouette/outline.h"

#include <vector>

namespace oversketch
{

// A visible silhouette curve in the image plane.
struct VisibleCurve
{
  Polyline display;
  std::vector<double>
    reach; // px per point: it is attached no farther than this; empty for no limit of its own
  bool closed = false;
};

// A point of an outline: a loop point, or the place where a silhouette point is attached.
struct OutlineStation
{
  Vector2 display;                  // on the smoothed loop
  Vector2 offset = Vector2::Zero(); // own picture minus display; interpolated between bound points elsewhere
  int curve = -1, point = -1;       // the attached silhouette point, -1 for a loop point
  Binding edge; // of a loop point that stands for a mesh edge; vertices -1: hangs on nothing
  bool bound() const { return this->curve >= 0 || this->edge.vertices[0] >= 0; }
};

// Inserts the silhouette points that lie within attachDistance px of a (smoothed) loop in their order along
// it. A curve that leaves the loop sideways, or runs back along it, is not attached where it does. With
// bindEdges, the middle of every mesh edge that forms the loop is bound too where nothing else is within
// attachDistance along it: at creases and borders, and on coarse meshes, the silhouette of interpolated
// normals leaves the outline. Result i belongs to loop i.
std::vector<std::vector<OutlineStation>> attachSilhouette(const std::vector<OutlineLoop>& loops,
  const std::vector<VisibleCurve>& curves,
  double attachDistance,
  bool bindEdges);

} // namespace oversketch
#endif
