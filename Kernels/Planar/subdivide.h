// One level of subdivision of a planar mesh, with its edges on strokes snapped onto these.
#ifndef oversketch_kernels_planar_subdivide_h
#define oversketch_kernels_planar_subdivide_h

#include "Mesh/context.h"
#include "Planar/face_edges.h"
#include "Raster/classify.h"

namespace oversketch
{

// A stroke by arc length from its first sample [world].
class StrokeByLength
{
public:
  explicit StrokeByLength(const DrawnStroke& stroke);
  bool closed() const { return this->Stroke.closed; }
  double length() const { return this->Lengths.empty() ? 0.0 : this->Lengths.back(); }
  // Length on a closed one modulo the whole length, in [0, length).
  double wrapped(double length) const;
  Vector2 at(double length) const;
  // How far samples of the part from `start` to `end` lie from the segment that stands for it, at most.
  double farthest(double start, double end, const Vector2& a, const Vector2& b) const;
  // An open one's first or last sample moves; lengths stay.
  void moveEnd(bool last, const Vector2& place);

private:
  DrawnStroke Stroke;
  std::vector<double> Lengths;
};

struct SubdivisionRule
{
  bool quads = false; // Catmull-Clark's, else Loop's, of triangles alone
  double share = 0.3; // of the snap of a feature's points that their free neighbours get
  // Kind of each stroke's points.
  std::vector<BoundaryKind> kinds;
};

struct SubdividedMesh
{
  PlanarMesh mesh; // points of strokes on these; others in the middle of edges and faces, old ones unmoved
  FaceEdges links; // where the subdivision goes on
  Polyline smooth; // where the subdivision's masks and the snap have each point; those of strokes on these
  std::vector<char> free; // on no stroke
};

// Source: image-assisted modelling, sections 9 and 10; Loop's masks are those of his interior points, beta =
// (1/n) (5/8 - (3/8 + 1/4 cos(2 pi / n))^2), Catmull and Clark's likewise. A new point on a stroke's edge
// goes to S((start + end) / 2), an old one stays; with masks and strokes every border edge has, no border
// mask is needed.
//
// The snap of a feature's point, from where the mask would have it, old points' too, is shared: a point on no
// stroke moves by `share` times the mean snap of those of its neighbours that lie on features. Points of rims
// and those on the mesh's border share nothing.
//
// Points of the mesh keep their numbers; then one for each edge, in order, then, with quads, one for each
// face. Faces of a face follow each other, each starts at a corner of it, with triangles the inner one is the
// last. An edge on a stroke becomes two. Regions, objects and bases are inherited. The same for any number of
// threads. `goesOn`: another level follows, which needs the links.
SubdividedMesh subdivide(const PlanarMesh& mesh,
  const FaceEdges& links,
  const std::vector<StrokeByLength>& curves,
  const SubdivisionRule& rule,
  bool goesOn,
  const Context& context);

} // namespace oversketch
#endif
