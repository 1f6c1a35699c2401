// Where the handles of a part's box are seen, and where a drag of one puts the part.
#ifndef oversketch_applications_studio_tools_part_drag_h
#define oversketch_applications_studio_tools_part_drag_h

#include "step.h"

#include "Mesh/view.h"

#include <array>

namespace oversketch_studio
{

enum class PartHandle
{
  LeftBottom,
  RightBottom,
  RightTop,
  LeftTop,
  Middle, // moves it in its plane
  Depth   // along z
};

// Places in display coordinates, in the order of the handles. That of the depth lies on the z axis through
// the middle, so many px from it; where the view looks along that axis, down and to the left, which then
// stands for nearer. False where a part of the box is behind the eye.
bool seeHandles(const oversketch::View& view,
  const oversketch_session::PartPlace& place,
  double distance,
  std::array<oversketch::Vector2, 6>& seen);

// Where a part comes to that was at `from` when its handle was taken at `start`. A corner keeps the opposite
// one where it is, and the box's proportions unless it is `free`; no box turns over or vanishes.
oversketch_session::PartPlace dragged(const oversketch::View& view,
  const oversketch_session::PartPlace& from,
  PartHandle handle,
  const oversketch::Vector2& start,
  const oversketch::Vector2& now,
  bool free);

} // namespace oversketch_studio
#endif
