// Quads as pairs of triangles, for formats and filters that know no others.
#ifndef oversketch_applications_files_quads_h
#define oversketch_applications_files_quads_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace oversketch_files
{

// How many triangles the polygons of a mesh make.
vtkIdType trianglesIn(vtkPolyData* mesh);

// The mesh with each quad cut along the diagonal whose triangles face more alike, of two the first. Unlike
// vtkTriangleFilter it leaves none out: narrow ones are faces of a closed surface, too. Other polygons and
// all arrays stay as they are.
vtkSmartPointer<vtkPolyData> withoutQuads(vtkPolyData* mesh);

} // namespace oversketch_files
#endif
