// Walls of a mesh that vtkOversketchPrintCheck looked at, as colours.
#ifndef oversketch_applications_files_print_colours_h
#define oversketch_applications_files_print_colours_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace oversketch_files
{

// Formats that keep colours of faces, for messages.
extern const char* const faceColourExtensions;

// The surface without its picture and colours, with cell arrays Wall, Faulty, and RGB: red where a wall has
// no thickness, yellow at `wall` [length of the mesh], pale from there on, blue from twice as thick on; grey
// where there is none to measure, black where a face is faulty. Red and blue are told apart by the colour
// blind (ColorBrewer's RdYlBu).
vtkSmartPointer<vtkPolyData> colouredByWall(vtkPolyData* checked, double wall);

} // namespace oversketch_files
#endif
