// Colours of points and of faces, as every format's reader and writer takes them: bytes or, where those would
// not be what a file says, floats from 0 to 1; three components or, with opacity, four.
#ifndef oversketch_applications_files_colours_h
#define oversketch_applications_files_colours_h

#include "vtkPolyData.h"

#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;

namespace oversketch_files
{

// The colours that a format can hold; null if there are none.
vtkDataArray* coloursOf(vtkPolyData* mesh);
vtkDataArray* faceColoursOf(vtkPolyData* mesh);

// A component as a byte, or from 0 to 1; opaque where it has no fourth one.
unsigned char colourByte(vtkDataArray* colours, vtkIdType at, int component);
double colourShare(vtkDataArray* colours, vtkIdType at, int component);
// Whether they are bytes.
bool areBytes(vtkDataArray* colours);

// The array where it has so many components or more, and so many tuples; else null.
vtkDataArray* usable(vtkDataArray* array, int components, vtkIdType count);

// Makes values from 0 to 1, so many components each, the colours of those points or faces.
void setColours(vtkDataSetAttributes* data, const std::vector<double>& values, int components);

} // namespace oversketch_files
#endif
