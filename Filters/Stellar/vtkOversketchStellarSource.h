// Source of a base mesh, a height image or a finer surface, as polydata with field arrays, for the
// filters of this module. Not installed.
#ifndef vtkOversketchStellarSource_h
#define vtkOversketchStellarSource_h

#include "Image/heights.h"
#include "Stellar/parametrisation.h"
#include "vtkOversketchFilterTools.h"

#include <memory>

class vtkImageData;
class vtkPolyData;

namespace oversketch
{

struct CurveStep;

// Gray of an image with one slice: its scalars, of colours the luminance. Throws Error(BadMesh).
HeightImage HeightsOf(vtkImageData* image);

// `rules` with all its numbers set, see vtkOversketchTerrain for the arrays.
void WriteTerrain(const HeightImage& image, const TerrainRules& rules, vtkPolyData* source);

// `mesh`: the original, whose points and polygons `source` shares. See vtkOversketchStellarBase for the
// arrays. Holds what is returned, SharedSource finds it.
std::shared_ptr<const Source> WriteSurface(const std::shared_ptr<const OriginalSurface>& surface,
  vtkPolyData* mesh,
  vtkPolyData* source);

// Where the surface is over a place of a forest; null for no source, or an empty one. Throws
// Error(MissingArray or BadMesh) naming the array that is absent or was changed.
std::shared_ptr<const Source> SharedSource(vtkPolyData* source);

// Key of a step's source: that of port 2, or what its mesh carries.
MeshKey SourceKey(const CurveStep& step);

// Source of a step, empty for none; `held` keeps it for who asks next. Where no point of the forest's base
// lies on it, one that the mesh carries is none, since the mesh was moved, and another throws Error(BadMesh).
Source SourceOf(const CurveStep& step, const Forest& forest, std::shared_ptr<const Source>& held);

} // namespace oversketch
#endif
