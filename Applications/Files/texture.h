// The picture that a mesh wears: it travels with the mesh, through filters and sessions, as a field array.
#ifndef oversketch_applications_files_texture_h
#define oversketch_applications_files_texture_h

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace oversketch_files
{

// Field array of unsigned char, one component: the bytes of a PNG or JPEG file, as they were read. It belongs
// to the active texture coordinates, which count v from the picture's lower edge, and repeats beyond [0, 1].
extern const char* const textureArray;

// The bytes, "" where the mesh has none. Of a part of an assembled mesh (pieces.h) with what its array's name
// begins with, "Part2.".
std::string textureOf(vtkPolyData* mesh, const std::string& prefix = {});
void setTexture(vtkPolyData* mesh, const std::string& bytes, const std::string& prefix = {});

// "png", "jpeg", or "" for other bytes.
std::string pictureFormatOf(const std::string& bytes);
// The picture; null where it cannot be read, is wider or higher than 16384 pixels, or says to be larger than
// so few bytes can make it.
vtkSmartPointer<vtkImageData> pictureOf(const std::string& bytes);
// The bytes of one that the mesh file of the path names; "" where it cannot be read, which a note says.
std::string pictureIn(const std::string& file,
  const std::string& name,
  const std::string& path,
  std::vector<std::string>& notes);
// What such bytes are, for messages: "no PNG or JPEG picture, …".
extern const char* const notAPicture;

} // namespace oversketch_files
#endif
