// What --picture draws.
#ifndef oversketch_command_picture_h
#define oversketch_command_picture_h

#include <string>

class vtkOversketchOneStroke;
class vtkPolyData;

namespace oversketch_command
{

// Throws Failed where there is no display to render with (VTK would end the program).
void requireDisplay();

// The result as the stroke's view shows it, in the stroke's viewport size: the region orange, the rest light
// grey, the section of the silhouette that was matched blue, the stroke red (the colours of the paper's
// figures).
void writePicture(vtkOversketchOneStroke* system, vtkPolyData* stroke, const std::string& path);

} // namespace oversketch_command
#endif
