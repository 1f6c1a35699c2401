// What of a mesh wears one picture: all of it, or each part of one that vtkOversketchAssemble made.
#ifndef oversketch_applications_files_pieces_h
#define oversketch_applications_files_pieces_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <set>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;

namespace oversketch_files
{

struct Piece
{
  std::string name;                  // of its material, "part0"; empty where the mesh is of one piece
  std::string picture;               // the bytes of its picture (texture.h), "" for none
  vtkSmartPointer<vtkPolyData> mesh; // its polygons and the points that they have, in their order
};

// The parts of a mesh with the cell array PartId, by their numbers, where a field array Part0.Texture,
// Part1.Texture, … holds a picture for one of them and there are texture coordinates; any other mesh whole,
// with its own picture.
std::vector<Piece> piecesOf(vtkPolyData* mesh);

// The numbers of a mesh's parts (cell array PartId), ascending; none where it does not say.
std::vector<int> partsOf(vtkPolyData* mesh);
// One of them as a mesh of its own, with its picture; all but some, with all points, each at its place.
vtkSmartPointer<vtkPolyData> partAlone(vtkPolyData* mesh, int part);
vtkSmartPointer<vtkPolyData> withoutParts(vtkPolyData* mesh, const std::set<int>& parts);

// The bytes of the pictures that a mesh wears, as a whole and its parts, each once.
std::set<std::string> picturesOf(vtkPolyData* mesh);

// Dresses a mesh: `worn` is, of each polygon, a number in `pictures`, the bytes of one or "" for none. Where
// all wear the same it is the mesh's own; else those that wear the same become a part, numbered in the order
// of their first polygons.
void wearPictures(vtkPolyData* mesh, const std::vector<int>& worn, const std::vector<std::string>& pictures);

// Whether a point has no place on a picture: at (-1, -1), with which readers mark such points, or a hair off
// where new points were made between them.
bool isNowhere(vtkDataArray* coordinates, vtkIdType point);

// The arrays that say so: the mesh's picture, or PartId and the parts' pictures; none where no piece has one.
std::vector<vtkAbstractArray*> pictureArrays(vtkPolyData* mesh);

} // namespace oversketch_files
#endif
