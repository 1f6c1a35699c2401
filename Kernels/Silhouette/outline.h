// The outline of a mesh's picture: the loops round the pixels it covers, and the silhouette attached to them
// (amendment to SEED, Sec. 3.3). Pure image-plane geometry; depth comes with the silhouette points.
#ifndef oversketch_kernels_silhouette_outline_h
#define oversketch_kernels_silhouette_outline_h

#include "Mesh/context.h"
#include "Mesh/view.h"
#include "Silhouette/curves.h"
#include "Stroke/polyline.h"

#include <optional>
#include <vector>

namespace oversketch
{

// A rectangle of pixels. Pixel (i, j) covers [i, i + 1) x [j, j + 1) of display space.
struct PixelWindow
{
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelWindow& o) const
  {
    return this->x == o.x && this->y == o.y && this->width == o.width && this->height == o.height;
  }
};

// The pixels the mesh's picture may touch, at most 4096 a side: of a larger picture the part round the stroke
// (or round the viewport, without a stroke). Triangles with a corner at or behind the eye have no picture.
PixelWindow outlineWindow(const Mesh& mesh,
  const View& view,
  const Polyline& stroke,
  const Context& context = {});

// The pixels within `margin` px of the stroke's box, at most 4096 a side round its middle: who asks for the
// outline near the stroke only need not look at the whole picture.
PixelWindow strokeWindow(const Polyline& stroke, double margin);

struct OutlineLoop
{
  Polyline points;    // covered pixels on the left; the first is not repeated at the end
  bool closed = true; // false where the window cuts the loop
  bool hole = false;  // a closed loop round pixels the mesh does not cover
  std::vector<Binding>
    edges; // per point, the mesh edge whose picture it lies on and where; vertices -1: none
};

// Boundary loops of the pixels whose centre a triangle covers, outer loops and holes, in the order of their
// lowest row. Which pixels are covered decides only how the loop runs; its points lie exactly where the
// boundary of the covered area crosses the lines between pixel centres, so the loop has no stairs and no
// bias. Pixels that touch at a corner are joined.
std::vector<OutlineLoop> traceOutline(const Mesh& mesh,
  const View& view,
  const PixelWindow& window,
  const Context& context = {});

// The outline of a mesh for who asks of it how far it is from a stroke. Traced when it is first asked for,
// and once for all who ask; the mesh must live as long. Not for several threads at a time.
class StrokeOutline
{
public:
  StrokeOutline(const Mesh& mesh, const View& view, Polyline stroke, Context context = {});

  static constexpr double margin = 50.0; // px; no outline that is nearer than this lies outside nearby()
  const Polyline& stroke() const { return this->Stroke; }
  // Loops in the window of this margin round the stroke; all of them.
  const std::vector<OutlineLoop>& nearby() const;
  const std::vector<OutlineLoop>& whole() const;

private:
  const Mesh* Model;
  View Seen;
  Polyline Stroke;
  Context Caller;
  mutable std::optional<std::vector<OutlineLoop>> Nearby, Whole;
};

// The places on each of them that are nearest to a point.
std::vector<NearestPlace> nearestPlaces(const std::vector<OutlineLoop>& loops);

// Each point replaced by the (1, 4, 6, 4, 1) / 16 mean of its neighbours along the loop; open ends stay.
Polyline smoothLoop(const Polyline& points, bool closed);

} // namespace oversketch
#endif
