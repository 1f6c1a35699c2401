/**
 * The arrays by which a mesh is a 4-8 mesh (Filters/Stellar/README.md), for steps that make triangles of
 * their own: there the arrays would tell of others. For use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchHierarchy_h
#define vtkOversketchHierarchy_h

#include "OversketchFiltersCoreModule.h" // For export macro

class vtkPolyData;

namespace oversketch
{

inline constexpr const char* stellarCellArrays[] = { "StellarRoot", "StellarPath", "StellarGen" };
inline constexpr const char* stellarPointArrays[] = { "StellarMoved",
  "CurveId",
  "CurveParam",
  "BaseNormal",
  "Displacement",
  "Feature" };
inline constexpr const char* stellarFieldArrays[] = { "StellarVersion", "CurveDigest" };

/**
 * Whether an array is one of them, by its name.
 */
OVERSKETCHFILTERSCORE_EXPORT bool IsStellarArray(const char* name);

/**
 * Takes them away.
 */
OVERSKETCHFILTERSCORE_EXPORT void RemoveStellarArrays(vtkPolyData* mesh);

/**
 * The same, of a mesh that has the cells' arrays; others may mean something else by these names.
 */
OVERSKETCHFILTERSCORE_EXPORT void DropHierarchy(vtkPolyData* mesh);

} // namespace oversketch
#endif
