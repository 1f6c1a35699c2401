// The picture that --picture draws, and the film of --turntable.
#ifndef oversketch_applications_command_picture_h
#define oversketch_applications_command_picture_h

#include "files.h"
#include "systems.h"

#include <string>

class vtkOversketchSystem;
class vtkPolyData;

namespace oversketch_command
{

// Throws Failed where there is no display to render with (VTK would end the program).
void requireDisplay();

// The result as the first stroke's view shows it, in its viewport size: the part that moved orange, the rest
// light grey, what the stroke took hold of blue, strokes of this view red, those that carve yellow, new
// outlines of an augmentation green (the colours of the papers' figures). One of the files.
void writePicture(const oversketch_session::SystemRow& row,
  vtkOversketchSystem* system,
  vtkPolyData* strokes,
  const std::string& path,
  oversketch_files::NewFiles& files);

// A film of the result, as the first stroke's view shows it but for strokes and lines, while the eye goes
// round it once, counter-clockwise seen from above, about the axis through its middle that is up in that
// view, y or z: 72 frames, the first of which is that view. Throws Failed where the path's ending is no
// format of films.
void writeTurntable(vtkOversketchSystem* system,
  vtkPolyData* strokes,
  const std::string& path,
  oversketch_files::NewFiles& files);

} // namespace oversketch_command
#endif
