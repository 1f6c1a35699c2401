// A picture that somebody gives, to draw over it or to paint with: of any usual kind, upright.
#ifndef oversketch_applications_files_upright_picture_h
#define oversketch_applications_files_upright_picture_h

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

} // namespace oversketch_files
#endif
