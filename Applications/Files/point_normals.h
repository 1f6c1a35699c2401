// Normals for what is drawn, here or by who reads a file.
#ifndef oversketch_applications_files_point_normals_h
#define oversketch_applications_files_point_normals_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace oversketch_files
{

// A mesh with point normals, computed where it has none: the same at all points of one place, which a reader
// split for texture coordinates.
vtkSmartPointer<vtkPolyData> withPointNormals(vtkPolyData* mesh);

} // namespace oversketch_files
#endif
