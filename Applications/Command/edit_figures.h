// What --report tells of an edit.
#ifndef oversketch_applications_command_edit_figures_h
#define oversketch_applications_command_edit_figures_h

#include "vtk_jsoncpp_fwd.h"

class vtkOversketchEdit;

namespace oversketch_command
{

// Of the last run, which must have gone well: gaps that curves were led over, points moved, edges folded and
// their share of the region's; Euler numbers before and after; the region's size; at the curves the smallest
// angles [degrees], whether they are simple, how many segments are no edges, how far line and ring lie off
// their strokes [px], of the ring what share is seen; the largest step of the place along the line over an
// edge; p95 over p5 of the disc's areas by the surface's, also of a disc that is not balanced, and how many
// of its triangles are turned over; how the slope of weights jumps at line and ring, over the mean slope;
// angles of the region's triangles and between them, at rest, moved, and of new triangles; of a profile how
// far the new section is from it [mean edges].
void addEditFigures(vtkOversketchEdit* edit, Json::Value& json);

} // namespace oversketch_command
#endif
