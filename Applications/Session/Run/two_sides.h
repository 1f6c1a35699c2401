// A step on two sides of a plane: what it is given there, and what it does, put together.
#ifndef oversketch_applications_session_run_two_sides_h
#define oversketch_applications_session_run_two_sides_h

#include "outcome.h"

#include <memory>
#include <optional>
#include <string>

namespace oversketch_session
{

// The strokes, and then each once more as if it had been drawn in the mirror: x counted from the other side
// of the picture, the view reflected, so that it stays right-handed. Where the strokes carry no sound views
// they come back alone: the system says what is wrong with them.
vtkSmartPointer<vtkPolyData> withReflections(vtkPolyData* strokes, const MirrorPlane& plane);

// True of a line, where a step took hold, that is its own mirror image as far as one can mean it: without a
// tenth of its length at either end, which rests on the body, it has points on both sides of the plane, or
// none beside it. Nearer than the tolerance [length] is in the plane.
bool crossesMirrorPlane(vtkPolyData* hold, const MirrorPlane& plane, double tolerance);
// By the tolerance within which points of the mesh have partners.
bool crossesMirrorPlane(vtkPolyData* hold, const MirrorPlane& plane, vtkPolyData* mesh);

// The mesh with its points where either of two results has moved them; other arrays are those of the first,
// but normals. Null where both moved a point, or their triangles are not those of the mesh.
vtkSmartPointer<vtkPolyData> joined(vtkPolyData* mesh, vtkPolyData* first, vtkPolyData* second);

// True where the run in the mirror took hold on the side that the stroke was drawn on, seen in the mirror on
// the other one: of the very place again, such as of a limb beside the plane that is seen along its axis.
bool isSamePlace(const std::optional<Section>& drawn,
  const std::optional<Section>& inMirror,
  const MirrorPlane& plane);

// "mirrored to x < 0", of what was drawn on the other side.
std::string mirroredTo(const std::optional<Section>& drawn, const MirrorPlane& plane);

// The result on one side: a mesh with all its points, those of the other side in any place.
struct Side
{
  vtkSmartPointer<vtkPolyData> mesh;
  std::shared_ptr<const Details> details;
};
// The details of what both made: points follow the side that put them where they are. Without a following
// where a side has none.
std::shared_ptr<const Details> joined(vtkPolyData* made, const Side& first, const Side& second);

} // namespace oversketch_session
#endif
