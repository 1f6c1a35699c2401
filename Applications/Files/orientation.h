// How the rows of a picture's file lie on a screen: 1 to 8, as Exif and TIFF count.
#ifndef oversketch_applications_files_orientation_h
#define oversketch_applications_files_orientation_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace oversketch_files
{

// What the Exif data of a JPEG, PNG or WebP file says, or the tag of a TIFF's first picture (BigTIFF, too);
// 1, upright, where nothing is said or what is said makes no sense.
int orientationOf(const std::string& bytes);

// The picture turned upright, the same one where it is. Rows lie from the bottom, as VTK has them.
vtkSmartPointer<vtkImageData> turnedUpright(vtkImageData* image, int orientation);

} // namespace oversketch_files
#endif
