// The lines that a person new to it is shown, each to be followed exactly.
#ifndef oversketch_applications_studio_window_hint_line_h
#define oversketch_applications_studio_window_hint_line_h

#include "Stroke/polyline.h"

namespace oversketch_studio
{

// Up one side of the limb that ends at the highest of the points, over a tip that stands further out, and
// down the other side; lengths in pixels of `ratio` each. Empty where there are no points.
oversketch::Polyline hintLine(const oversketch::Polyline& picture, double ratio);

// The shape of a tool's hint: that limb; a line on the body; a ring round that line.
enum class HintShape
{
  Limb,
  Line,
  Ring
};
oversketch::Polyline hintLine(HintShape shape, const oversketch::Polyline& picture, double ratio);

} // namespace oversketch_studio
#endif
