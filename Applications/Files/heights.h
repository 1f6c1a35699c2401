// Grids of heights: TIFF, GeoTIFF and BigTIFF, PNG and PGM of 8 or 16 bits, ESRI ASCII grid (.asc), VTK image
// data (.vti).
#ifndef oversketch_applications_files_heights_h
#define oversketch_applications_files_heights_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace oversketch_files
{

// The extensions, for messages.
extern const char* const heightsExtensions;
bool isHeightsExtension(const std::string& extension);

// The extension without its dot that such bytes have ("png", "tif", "pgm", "asc", "vti"), "" for others.
std::string heightsFormatOf(const std::string& bytes);

// One slice with scalars of one number or a colour each, rows from the bottom. Spacing and origin, which is
// the place of the lower left sample on its map, are as the file tells them, else 1 and 0. Samples that are
// missing (NODATA) are not a number. Of a TIFF the colours count, or its first band, by the scale and offset
// that it names. Throws Failed, naming the file: bytes of another kind, damaged ones, a grid that is turned
// against its map, more than 16384 samples a side, or more of them than so few bytes can tell.
vtkSmartPointer<vtkImageData> parseHeights(const std::string& name, const std::string& bytes);

// Of a .vti file.
vtkSmartPointer<vtkImageData> readVti(const std::string& name, const std::string& bytes);

} // namespace oversketch_files
#endif
