/**
 * Which arrays are interpolated where new points are made. For use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchMixable_h
#define vtkOversketchMixable_h

#include "OversketchFiltersCoreModule.h" // For export macro

class vtkAbstractArray;

namespace oversketch
{

/**
 * Whether an array's numbers mean something between two elements: real ones, and whole ones that are a colour
 * or a measure, which are then rounded. Ids and labels alone do not, and keep the value of one element: bits,
 * characters, whole numbers of eight bytes, and those of one component whose name has one of the words id,
 * index, label, region, part, group, material, segment, class, cluster, chart, flag, mask, seed, object,
 * kind, type, face, cell, vertex, point, source, treatment, mark, node, side, in any spelling: "RegionId",
 * "point_labels".
 */
OVERSKETCHFILTERSCORE_EXPORT bool IsMixable(vtkAbstractArray* array);

} // namespace oversketch
#endif
