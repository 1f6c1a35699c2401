// The coarse mesh of a drawing: the constrained Delaunay triangulation of its polylines.
#ifndef oversketch_kernels_planar_triangulate_h
#define oversketch_kernels_planar_triangulate_h

#include "Mesh/context.h"
#include "Planar/planar_mesh.h"
#include "Planar/stroke_line.h"

namespace oversketch
{

// Source: image-assisted modelling, section 7. Vertices are those of the polylines and the darts; the
// polylines' segments are edges. Faces outside objects are left out, and those of holes with all that lies in
// them. A face's region is found from the closed polylines by walking in from outside: crossing one leads
// from the region round it to the one it bounds, and back; open ones separate nothing. Where open ones divide
// a region nevertheless, since both ends are on its rim or on each other, its parts are regions
// (planar_mesh.h), in the order of their first faces. Every other triangle is Delaunay, ties decided as
// delaunay.h says, so mesh and numbering are the same whatever the lines' order: points ascend by (x, y),
// faces start at their least corner and ascend, edges ascend by stroke and length. Each face is its own base,
// each point one of the base.
//
// Points where lines meet are one point, of the line whose kind comes first: object's boundary, hole's,
// tunnel's, feature. A dart that is a line's vertex is none.
//
// Throws Error(Failure::BadStroke), naming the strokes, for lines that meet between their vertices, run over
// each other or lie on the wrong side of another one, and for a closed one of fewer than three vertices or on
// one line.
PlanarMesh triangulate(const std::vector<StrokeLine>& lines,
  const std::vector<Vector2>& darts,
  const Context& context);

} // namespace oversketch
#endif
