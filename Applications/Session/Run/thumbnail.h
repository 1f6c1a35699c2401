// A small picture of a model after a step: as it was seen when the step was drawn, what moved in orange, the
// stroke in red. Painted here, as the worker's thread has no window, and VTK draws into no picture without
// one.
#ifndef oversketch_applications_session_run_thumbnail_h
#define oversketch_applications_session_run_thumbnail_h

#include "vtkPolyData.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace oversketch_session
{

struct Thumbnail
{
  static constexpr int width = 128, height = 96; // px

  std::vector<std::uint8_t> pixels; // rows from above; red, green, blue, opacity, not premultiplied
};

// The whole mesh, whatever part of it the view showed. `moved`: a part of the mesh; `stroke`: in pixels, with
// its view; either may be null, without a stroke it is seen from the front. Null when cancelled, which is
// asked now and then.
std::shared_ptr<const Thumbnail> thumbnailOf(vtkPolyData* mesh,
  vtkPolyData* moved,
  vtkPolyData* stroke,
  const std::function<bool()>& cancelled);

} // namespace oversketch_session
#endif
