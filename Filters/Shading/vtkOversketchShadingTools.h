/**
 * Tools that the filters of this room share: a mesh with its region, arrays of images. Free
 * functions, for use in the .cxx of filters; not wrapped. README.md of this folder lists the arrays.
 */
#ifndef vtkOversketchShadingTools_h
#define vtkOversketchShadingTools_h

#include "Mesh/mesh.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkInformation;
class vtkInformationVector;
class vtkPolyData;

namespace oversketch
{

// The triangles inside the boundary by themselves.
struct InsidePatch
{
  Mesh Patch;
  std::vector<int> Vertices; // of the mesh, ascending; vertex i of the patch is Vertices[i]
  std::vector<int> Numbers;  // of the patch by vertices of the mesh, -1 elsewhere
};

// Inside are the triangles that cell array EditRegion gives 2; without it those with a corner strictly
// inside, which are all but such as have every corner on the boundary. withRing: and every triangle that
// shares a vertex with them. Throws what MeshOf and ReadEditRegion do, Error(BadRegion) where no vertex is
// strictly inside.
InsidePatch InsideOf(vtkPolyData* mesh, bool withRing);

// Key of what InsideOf reads of the mesh, and ReadChain of a patch.
MeshKey InsideKey(vtkPolyData* mesh);

// Array DiscCoords of a mesh. Throws Error(MissingArray) without it, Error(BadMesh) naming a vertex of the
// region whose coordinates are not finite.
std::vector<Vector2> DiscCoordsOf(vtkPolyData* mesh, const std::vector<char>& labels);

// Key that tells arrays apart, whatever they belong to; null for an absent one.
MeshKey ArraysKey(const std::vector<vtkDataArray*>& arrays);

// Both sides of an image in samples. Throws Error(BadStroke) for one without samples or of several slices;
// `which` names it.
std::pair<int, int> SidesOf(vtkImageData* image, const std::string& which);

// For the RequestUpdateExtent of a filter that reads all of an image on a port, whatever is asked of its own
// outputs; it may be absent.
void RequestWholeImage(vtkInformationVector* input);

// Gives an image of size x size samples its place: the square from -1 to 1, over the disc.
void LayOnDisc(vtkImageData* image, int size);

// For RequestInformation: extent, place and scalars' type of such an image, of one component.
void DescribeDiscImage(vtkInformation* output, int size, int scalarType);

} // namespace oversketch
#endif
