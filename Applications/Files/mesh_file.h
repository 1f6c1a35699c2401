// Mesh files by extension: OBJ, PLY, STL, OFF, VTP, glTF (.gltf, .glb); written alone, 3MF; and
// stroke files (.vtp).
#ifndef oversketch_applications_files_mesh_file_h
#define oversketch_applications_files_mesh_file_h

#include "colours.h"
#include "files.h"
#include "pieces.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>

namespace oversketch_files
{

// The extensions that are read and those that are written, for messages.
extern const char *const meshExtensions, *const writtenExtensions;
bool isMeshExtension(const std::string& extension);
bool isWrittenExtension(const std::string& extension);

// A mesh of triangles that is sound in itself: points are finite, ids in range, arrays complete. Other
// polygons are triangulated, lines and vertices dropped, which the notes say. Throws Failed; VTK's readers do
// not report a truncated file, so what they read is checked.
vtkSmartPointer<vtkPolyData> readMesh(const std::string& path, Notes& notes);

// The polylines of a stroke file with their arrays, checked like a mesh. What makes it a stroke, its view, is
// for the filters to judge.
vtkSmartPointer<vtkPolyData> readStroke(const std::string& path);

// The same from the bytes of a .vtp file; the name is for messages.
vtkSmartPointer<vtkPolyData> parseMesh(const std::string& name, const std::string& bytes);
vtkSmartPointer<vtkPolyData> parseStroke(const std::string& name, const std::string& bytes);
// The bytes of a .vtp file that keeps every bit of the data; equal data gives equal bytes.
std::string bytesOf(vtkPolyData* data);

// Writes the mesh whole or not at all; the notes say what the format drops. It is read back before it
// appears, so that no file is left that cannot be read; 3MF, of which there is no reader, is not.
void writeMesh(vtkPolyData* mesh, const std::string& path, Notes& notes);
// The same as one of several files, which appear together.
void writeMesh(vtkPolyData* mesh, const std::string& path, Notes& notes, NewFiles& files);

// The single formats, used by the above. They throw Failed.
vtkSmartPointer<vtkPolyData> readVtp(const std::string& name, const std::string& bytes);
// With all properties as arrays, and the pictures that its header names.
vtkSmartPointer<vtkPolyData> readPly(const std::string& path, Notes& notes);
vtkSmartPointer<vtkPolyData> readStl(const std::string& path, Notes& notes);
vtkSmartPointer<vtkPolyData> readOff(const std::string& path, Notes& notes);
// Which face wears which material (field array MaterialNames, cell array MaterialIds), the names of the
// libraries (field array MaterialLibraries), one array of texture coordinates (-1, -1 at points without), and
// the picture.
vtkSmartPointer<vtkPolyData> readObj(const std::string& path, Notes& notes);
// Makes the pictures of pieces beside a mesh file of that path; returns the name of each piece's, "" for one
// without. Replaces no other file.
std::vector<std::string> writePictures(const std::vector<Piece>& pieces,
  const std::string& path,
  NewFiles& files);
// Makes them and a library with a material for each piece, "texture" for one without a name, beside
// an OBJ file of that path; returns the library's name. Replaces no other file.
std::string writeObjMaterials(const std::vector<Piece>& pieces, const std::string& path, NewFiles& files);
// With the picture of the base colour (texture.h) where all parts share one; the notes name what is not kept.
vtkSmartPointer<vtkPolyData> readGltf(const std::string& path, Notes& notes);
void writeOff(vtkPolyData* mesh, const std::string& path);
// Of triangles.
void writeStl(vtkPolyData* mesh, const std::string& path);
// Whether an STL file keeps these colours, or null, as they are.
bool fitsStl(vtkDataArray* faceColours);
// Its header names these pictures; `worn` is which of them each face wears, -1 for none, empty for the first.
void writePly(vtkPolyData* mesh,
  const std::string& path,
  const std::vector<std::string>& pictures,
  const std::vector<int>& worn);
// The arrays of points and faces that it writes.
std::set<vtkAbstractArray*> keptByPly(vtkPolyData* mesh);
// With the materials of that library, as writeObjMaterials names them, unless it is empty; else with those of
// the file that the mesh was read from.
void writeObj(const std::vector<Piece>& pieces, const std::string& path, const std::string& library);
// One mesh of that name, with a primitive for each piece, that with a material where it has a picture or a
// name.
void writeGltf(const std::vector<Piece>& pieces,
  const std::string& name,
  const std::string& path,
  bool binary);

// Takes triangles; each part (cell array PartId) is an object, whose vertices are the mesh's points as they
// are.
void write3mf(vtkPolyData* mesh, const std::string& path);

// Number of triangles that the polygons of a mesh make.
vtkIdType trianglesIn(vtkPolyData* mesh);
// The mesh with each quad cut along the diagonal whose triangles face more alike, of two the first. Unlike
// vtkTriangleFilter it leaves none out: narrow ones are faces of a closed surface, too. Other polygons and
// all arrays stay as they are.
vtkSmartPointer<vtkPolyData> withoutQuads(vtkPolyData* mesh);

// How far apart numbers of single precision lie where a mesh of such points is [the mesh's units], as words
// with the share of the mesh's size; "" up to 1e-4 of that, and for other points.
std::string singleSteps(vtkPolyData* mesh);
// The middle of meshes that lie so far from the origin that single precision would round them by more than
// 1e-6 of their size; zeros for others.
std::array<double, 3> nearOrigin(const std::vector<Piece>& pieces);

} // namespace oversketch_files
#endif
