// A picture that somebody gives, to draw over it or to paint with: of any usual kind, upright.
#ifndef oversketch_applications_files_upright_picture_h
#define oversketch_applications_files_upright_picture_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace oversketch_files
{

// The extensions, for messages and dialogs.
extern const char* const pictureExtensions;
// What other bytes are, for messages: "no PNG, JPEG, …".
extern const char* const notAnUprightPicture;

// The bytes of a PNG or JPEG file (texture.h) whose rows lie as any viewer shows the picture: a mesh wears
// it, and programs that show meshes do not look at Exif data. The same bytes where they are such a file; a
// JPEG that lies on its side is written anew with a quality of 95, all else as PNG of 8 bits, with its
// transparency. "" where WebP, BMP or TIFF cannot be read; other bytes come back.
std::string uprightPicture(const std::string& bytes);

// How the rows of a picture's file lie on a screen, 1 to 8, as Exif and TIFF count: what the Exif data of a
// JPEG, PNG or WebP file says, or the tag of a TIFF's first picture (BigTIFF, too); 1, upright, where nothing
// is said or what is said makes no sense.
int orientationOf(const std::string& bytes);

// The picture turned upright, the same one where it is. Rows lie from the bottom, as VTK has them.
vtkSmartPointer<vtkImageData> turnedUpright(vtkImageData* image, int orientation);

} // namespace oversketch_files
#endif
