// Curves that were drawn over a model, where they lie on it: what is seen of them from elsewhere, and of a
// curve of which a part was drawn anew.
#ifndef oversketch_widgets_edit_drawn_curve_h
#define oversketch_widgets_edit_drawn_curve_h

#include "Mesh/view.h"
#include "Ray/surface_rays.h"
#include "Stroke/polyline.h"
#include "seen_line.h"

#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

class vtkPolyData;

namespace oversketch
{

// The model, to be asked by lines of sight; null for one without triangles. Throws Error(BadMesh).
std::shared_ptr<const SurfaceRays> raysOf(vtkPolyData* mesh);

// The places of the world that samples [px] are seen at: on the model, beside it as deep as the nearest
// sample that is on it, and without a model as deep as `depth` (View::depth).
std::vector<Vector3> laidOn(const SurfaceRays* model,
  const View& view,
  const Polyline& samples,
  double depth);

// A curve of which a stroke, laid alike, replaces a part as seen in the stroke's view; the curve itself where
// it is not wholly before the eye. What the system makes of both is by the same rules.
std::vector<Vector3> redrawn(const std::vector<Vector3>& curve,
  bool closed,
  const View& view,
  const Polyline& samples,
  const std::vector<Vector3>& laid);

// Segments in a view [px], those that are wholly before the eye.
std::vector<Polyline> segmentsIn(const View& view, const std::vector<std::array<Vector3, 2>>& segments);

// The share of a line's length at each of its points, 0 to 1.
std::vector<double> sharesOf(const std::vector<Vector3>& line);
Vector3 placeAt(const std::vector<Vector3>& line, const std::vector<double>& shares, double share);
// The share whose place is seen nearest to a place of the picture; absent where none is seen.
std::optional<double> nearestShare(const View& view,
  const std::vector<Vector3>& line,
  const std::vector<double>& shares,
  const Vector2& place);

// The first polyline of a polydata, of none no points; without its third coordinates; and into one.
std::vector<Vector3> firstLineOf(vtkPolyData* lines);
Polyline flat(const std::vector<Vector3>& line);
void putLine(vtkPolyData* into, const std::vector<Vector3>& line, bool closed = false);

// The strokes of a polydata, each by itself, with its own points and arrays; of null none.
std::vector<vtkSmartPointer<vtkPolyData>> strokesOf(vtkPolyData* all);

} // namespace oversketch
#endif
