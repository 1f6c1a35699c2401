// New triangles for a region that an edit has moved.
#ifndef oversketch_kernels_remesh_retriangulate_h
#define oversketch_kernels_remesh_retriangulate_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Mesh/place.h"

#include <functional>
#include <vector>

namespace oversketch
{

// Where an edit moves places of the surface before it: point i with its values, as many of each as the input
// says. What becomes of a place depends on it and its values alone; what has not moved keeps its bits. Called
// from several threads.
using Movement =
  std::function<std::vector<Vector3>(const std::vector<Vector3>& points, const std::vector<double>& values)>;

// The motion of an edit.
struct Motion
{
  int channels = 0;           // values of a vertex
  std::vector<double> values; // of each vertex
  Movement movement;
};

struct RetriangulateInput
{
  const Mesh& rest;                     // before the edit
  const std::vector<Vector3>& moved;    // where its vertices are after it
  std::vector<char> region;             // per vertex: 2 strictly inside, others keep their place
  std::vector<std::vector<int>> curves; // vertices joined by edges; they stay, and so do the edges
  double meanEdge = 0.0;                // of the mesh as it was loaded [model length]
  bool asFloats = false;                // what comes out is stored in them: places differ there, too
  std::vector<double> sizes = {};       // per vertex the mean edge to be there instead; none: that everywhere
  std::vector<char> left = {};          // per vertex: faces at such a one do not change; empty: none
};

// A vertex of a curve: the curve's point `from`, or t of the way to the one after it.
struct CurveVertex
{
  int vertex = -1;
  int from = 0;
  double t = 0.0;
};

struct Retriangulated
{
  Mesh mesh;
  // Points of the input that are left come first, in their order, then new ones; triangles alike.
  std::vector<int> pointSource;    // the input point it is, or -1 for one that moved or is new
  std::vector<Mix> mixes;          // of input points, of those alone, in their order
  std::vector<int> triangleSource; // the input triangle it is, or under its middle
  std::vector<std::vector<CurveVertex>> curves;
  int splits = 0, collapses = 0, flips = 0;
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 3.4 and 8.1: edges much
// longer than the mean edge are split, much shorter ones collapsed, and edges swapped where it helps; how
// much, by the curvature round them. The thesis gives no numbers. Here an edge is split over 1.5 g and
// collapsed under 0.5 g mean edges, g = 0.35 / (curvature * mean edge) between 0.25 and 1.5, the largest
// curvature of a vertex as the mesh comes; swapped where that makes the smallest angle larger; five rounds at
// most. Only faces with a vertex strictly inside change. Moves are those of Patch, whose tests are stricter:
// an edge beside one that cannot be split is not halved for ever, and normals turn by 60 degrees at most.
// Looks only at the faces of `rest`.
// Throws Error(Failure::BadRegion) for a mean edge that is not positive, Error(Failure::Torn) where the edit
// stretches the region to what would take over 250,000 triangles and 16 times those that it has,
// Error(Failure::Cancelled).
Retriangulated retriangulateByCurvature(const RetriangulateInput& input, const Context& context);

// Replaces that rule, with the mean edge that is to be there: a rule of curvature finds it in the noise of an
// unchanged region too, and puts new vertices onto the facets of a surface that was stretched. Here edges are
// split before the edit, so that the edit moves their halves to where they belong: in up to six rounds each
// edge that it makes longer than 4/3 mean edges and than it was, or that is over 0.35 mean edges long and
// whose middle it carries away from the edge by over 0.03 of its length, the longest first and one of a face
// in a round, and none where that would leave more edges folded than there are; after each, edges are swapped
// where the smallest angle of the moved faces grows. Faces that
// were split, or of which an edge's length changes by over 1 %, are then remeshed as the edit leaves them: in
// three rounds edges over 4/3 mean edges are split, those under 0.35 collapsed, others swapped so that more
// vertices have six, and vertices relaxed in the tangent plane and back to the surface; then edges are
// swapped by angles, and those that this leaves over 4/3 mean edges split. Without a motion nothing changes.
// No two vertices come out at one place, by either rule, unless the edit has put both there and they cannot
// leave.
Retriangulated retriangulateEdit(const RetriangulateInput& input,
  const Motion& motion,
  const Context& context);

// The motion between two meshes with the same triangles, for who does not know what moved the vertices:
// within a triangle, halfway from the mean of its corners' displacements to that of the displacements which
// the corners expect there, by their own and its slope along the surface (least squares over their
// neighbours). That is T. Boubekeur and M. Alexa, "Phong Tessellation", 2008, of displacements in place of
// positions: at the middle of an edge it is the cubic with the slopes of both ends, at vertices the
// displacement itself.
Motion motionBetween(const Mesh& rest,
  const Adjacency& adjacency,
  const std::vector<Vector3>& moved,
  const Context& context);

} // namespace oversketch
#endif
