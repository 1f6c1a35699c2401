/**
 * The mesh of a drawing in the plane and what ties it to the strokes, from polydata and back. Free functions,
 * for use in the .cxx of filters; not wrapped. README.md of this folder lists the arrays.
 */
#ifndef vtkOversketchPlanarTools_h
#define vtkOversketchPlanarTools_h

#include "OversketchFiltersPlanarModule.h" // For export macro

#include "Planar/planar_mesh.h"
#include "Planar/stroke_line.h"
#include "vtkOversketchFilterTools.h"

#include <vector>

class vtkPolyData;

namespace oversketch
{

/**
 * The mesh of faces, point i and face i of it; with its edges on strokes where they are given. Throws
 * Error(MissingArray) for an absent array, Error(BadMesh) naming the cell or point for faces that are neither
 * triangles nor quads, edges that are not lines of two points, ids out of range, points that are not finite
 * and a BoundaryKind that is none.
 */
OVERSKETCHFILTERSPLANAR_EXPORT PlanarMesh PlanarMeshOf(vtkPolyData* faces, vtkPolyData* edges = nullptr);

/**
 * Writes points, faces and their arrays.
 */
OVERSKETCHFILTERSPLANAR_EXPORT void WritePlanarMesh(const PlanarMesh& mesh, vtkPolyData* faces);

/**
 * Writes the edges on strokes and their arrays, between the points of faces, which WritePlanarMesh wrote.
 */
OVERSKETCHFILTERSPLANAR_EXPORT void WriteStrokeEdges(const PlanarMesh& mesh,
  vtkPolyData* faces,
  vtkPolyData* edges);

/**
 * Key that tells meshes, edges on strokes, polylines and splits apart: points, cells, all point and cell
 * arrays.
 */
OVERSKETCHFILTERSPLANAR_EXPORT MeshKey PlanarKey(vtkPolyData* data);

/**
 * The strokes' polylines that vtkOversketchPolyline wrote. Throws Error(MissingArray) for an absent array,
 * Error(BadStroke) naming the cell for one that is no polyline, is too short, has a point that is not finite,
 * ArcLength that does not ascend, or a Role or Treatment that is none.
 */
OVERSKETCHFILTERSPLANAR_EXPORT std::vector<StrokeLine> StrokeLinesOf(vtkPolyData* polylines);

/**
 * Writes polylines with their arrays.
 */
OVERSKETCHFILTERSPLANAR_EXPORT void WriteStrokeLines(const std::vector<StrokeLine>& lines,
  vtkPolyData* polylines);

/**
 * Parts of strokes to be approximated closer, one per cell. Throws Error(MissingArray) for an absent array,
 * Error(BadStroke) for values that are not finite or halvings outside 0 to 64.
 */
OVERSKETCHFILTERSPLANAR_EXPORT std::vector<StrokeSplit> SplitsOf(vtkPolyData* splits);

/**
 * Writes them, each as a line between its ends on its stroke.
 */
OVERSKETCHFILTERSPLANAR_EXPORT void WriteSplits(const std::vector<StrokeSplit>& splits,
  const std::vector<DrawnStroke>& strokes,
  vtkPolyData* output);

} // namespace oversketch
#endif
