/**
 * The mask that a mesh carries: which of its points no step moves. For use in the .cxx of filters; not
 * wrapped.
 */
#ifndef vtkOversketchMaskArray_h
#define vtkOversketchMaskArray_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include "vtkOversketchFilterTools.h" // for MeshKey

#include <vector>

class vtkPolyData;

namespace oversketch
{

/**
 * Name of the point array.
 */
inline constexpr const char* maskName = "Mask";

/**
 * The mask of each point [0: free, to 1: no step moves it]; empty where the mesh has no mask or all of it is
 * free. A value within 1e-6 of 1, such as interpolation makes of ones, is 1. Throws Error(MissingArray) where
 * the array is not one finite number a point.
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<double> MaskOf(vtkPolyData* mesh);

/**
 * 1 for each point that no step moves; empty where there is none.
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<char> MaskedPointsOf(vtkPolyData* mesh);

/**
 * Key of a mesh and its mask.
 */
OVERSKETCHFILTERSCORE_EXPORT MeshKey MaskKey(vtkPolyData* mesh);

/**
 * Gives the mesh that mask; takes it away where that is empty.
 */
OVERSKETCHFILTERSCORE_EXPORT void PutMask(const std::vector<double>& mask, vtkPolyData* mesh);

} // namespace oversketch
#endif
