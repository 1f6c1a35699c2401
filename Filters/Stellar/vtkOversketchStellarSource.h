// The height image that a terrain was made of, as field arrays, for the filters of this module. Not
// installed.
#ifndef vtkOversketchStellarSource_h
#define vtkOversketchStellarSource_h

#include "Image/heights.h"
#include "Stellar/forest.h"

class vtkImageData;
class vtkPolyData;

namespace oversketch
{

// Gray of an image with one slice: its scalars, of colours the luminance. Throws Error(BadMesh).
HeightImage HeightsOf(vtkImageData* image);

// `rules` with all its numbers set, see vtkOversketchTerrain for the arrays.
void WriteTerrain(const HeightImage& image, const TerrainRules& rules, vtkPolyData* source);

// Where the surface is over a place; empty where there are no such arrays. Throws Error(MissingArray or
// BadMesh) where one is absent or of a wrong shape.
Source TerrainSource(vtkPolyData* source);

} // namespace oversketch
#endif
