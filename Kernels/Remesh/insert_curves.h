// Curves on a mesh become chains of its edges.
#ifndef oversketch_kernels_remesh_insert_curves_h
#define oversketch_kernels_remesh_insert_curves_h

#include "Mesh/context.h"
#include "Mesh/place.h"
#include "Mesh/view.h"
#include "Remesh/curve_mesh.h"

#include <vector>

namespace oversketch
{

// A run of a curve: places on the input mesh, and where on the curve they are, rising.
struct CurveRun
{
  std::vector<SurfacePoint> places;
  std::vector<double> parameters;
  bool closed = false; // the first place is not repeated
};

struct NewCurve
{
  std::vector<CurveRun> runs; // in the order of the curve; of an open curve one
  bool closed = false;        // the last run goes on to the first
  int number = 0;             // in messages
  const View* view = nullptr; // that it was drawn in
};

// As published snap and clean are off, and join is on in place of bridge.
struct InsertRules
{
  bool snap = true;   // to vertices and edges that are near
  bool embed = true;  // segments become edges
  bool bridge = true; // what misses or is hidden is walked over; off: a closed curve with gaps is refused
  bool clean = true;  // narrow triangles at the curves
  enum class Gap
  {
    Viewer, // in the plane through the eye off from the viewer, then on as the curve comes
    Onward, // the other way round
    Across  // as Onward, in the plane across the first stored curve: round the limb that this lies along
  };
  Gap gap = Gap::Viewer; // what is tried first over a gap
  bool join = false;     // without bridges: runs are joined by segments like all others
  // Per vertex: cleaning changes no triangle of such a one; empty: none.
  std::vector<char> left = {};
};

struct InsertedCurves
{
  Mesh mesh;                     // input vertices that are left in their order, then new ones
  std::vector<int> pointSources; // the input vertex, or -1
  std::vector<Mix> origins;      // of each vertex that is new, input vertices and weights
  std::vector<int> triangleSources;
  std::vector<MeshCurve> curves, stored; // with the result's vertices
  int bridges = 0;                       // gaps walked over
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 4.1: points of a curve
// are made vertices: a triangle becomes three, on an edge two become four. How the text does not say.
//
// Departures, since the literal rule leaves needles and curves that nothing can stop at:
// - a place takes a vertex nearer than a quarter of min(mean edge of its triangle, 10 px), and goes to an
//   edge nearer than 0.15 of the height over it, at most 1.5 px; not to vertices and edges of curves;
// - each segment is walked along the plane through the eye, from vertex to vertex, the plane taken anew at
//   each crossing; a crossing within 0.2 of an edge's end, at most half the segment away, is that vertex.
//   Where that meets a curve, or gets nowhere, the plane of the surface's normals and the shortest way over
//   edges are tried;
// - over a gap of a closed curve leads the first of five ways that meets no curve: along the mesh's border,
//   where the curve leaves an open mesh over it; along the plane of both ends and the eye, off from the
//   viewer and straight on; or on as the curve comes; along the plane of both ends and the mean of their
//   normals; over edges; each no longer than four gaps and 0.3 of the mesh's diagonal;
// - what lies between two visits of a vertex is cut out, of a closed curve the shorter part; where that went
//   through triangles that the rest does not touch, the rest alone is inserted, so that they stay whole;
// - a new vertex on an edge of a curve that is stored belongs to that curve, else a region would leak there;
// - narrow triangles at the curves are cleaned, see cleanAlongCurves.
//
// Parameters of an open curve go from 0 to 1; those of a closed one begin with 0 and stay under 1. `stored`
// are embedded curves of the input. Throws Error(Failure::BadStroke) for a closed curve that does not close,
// and for one of which nothing is left.
InsertedCurves insertCurves(const Mesh& mesh,
  const std::vector<NewCurve>& curves,
  const std::vector<MeshCurve>& stored,
  const InsertRules& rules,
  const Context& context = Context());

// Raises the angles of triangles at the curves that are under 24 degrees, in at most twelve rounds: of the
// flips that are possible, and of the collapses that remove one under 20 degrees, as these take vertices
// from coarse meshes, the one that raises the smallest angle that it touches most. Normals turn by at most
// 15 degrees. Not touched are what lies more than 1.9 mean edges from curves, edges and ends of curves,
// border vertices, and vertices on edges over 25 degrees; of a curve, vertices that were inserted go along
// it, if it moves by at most a tenth of the new segment.
void cleanAlongCurves(CurveMesh& mesh, const Context& context = Context());

// A mesh as it was changed; of its curves the first `storedCount` were stored.
InsertedCurves resultOf(const CurveMesh& mesh, std::size_t storedCount);

} // namespace oversketch
#endif
