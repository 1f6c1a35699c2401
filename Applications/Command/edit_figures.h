// What --report tells of an edit.
#ifndef oversketch_command_edit_figures_h
#define oversketch_command_edit_figures_h

#include "vtk_jsoncpp_fwd.h"

class vtkOversketchEdit;

namespace oversketch_command
{

// Of the last run, which must have gone well: gaps that curves were led over, points moved, edges folded; the
// region's size; at the curves the smallest angles [degrees] and how far the line lies off its stroke [px];
// the largest step of the place along the line over an edge; p95 over p5 of the disc's areas by the
// surface's; how the slope of weights jumps at line and ring, over the mean slope; angles of the region's
// triangles and between them, at rest, moved, and of new triangles; of a profile how far the new section is
// from it [mean edges].
void addEditFigures(vtkOversketchEdit* edit, Json::Value& json);

} // namespace oversketch_command
#endif
