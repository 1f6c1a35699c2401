// Ways over a mesh from one vertex to another: along a plane, across its triangles, or over its edges. Not
// installed.
#ifndef oversketch_kernels_remesh_curve_walk_h
#define oversketch_kernels_remesh_curve_walk_h

#include "Remesh/curve_mesh.h"

#include <functional>
#include <optional>
#include <vector>

namespace oversketch
{

// A vertex (b is -1), or the place (1 - s) a + s b on an edge.
struct WayStep
{
  int a = -1, b = -1;
  double s = 0.0;
};

struct Way
{
  std::vector<WayStep> steps; // between the two ends
  double length = 0.0;
};

struct WalkRules
{
  // The plane holds the place where the walk is, the goal, and this direction there; the one through the
  // start is kept where `fixedPlane`.
  std::function<Vector3(const Vector3& at)> direction;
  bool fixedPlane = false;
  // Where to start; from then on straight on. Zero: always towards the goal.
  Vector3 start = Vector3::Zero();
  bool avoidCurves = false; // meet no vertex and no edge of a curve
  double snap = 0.2;        // a crossing within this share of an edge's end is the vertex there,
  double snapLength = 0.0;  // if that is no farther than this
  double longest = 0.0;     // give up beyond
};

// The way from a vertex to another along the plane, none where it does not arrive. The mesh stays as it is.
std::optional<Way> walkPlane(const CurveMesh& mesh, int from, int to, const WalkRules& rules);

// The shortest way over edges that is no longer than `longest` and meets no curve.
std::optional<Way> walkEdges(const CurveMesh& mesh, int from, int to, double longest);

// The shorter way along the mesh's border, no longer than `longest`, that meets no curve; begun and ended
// over an edge where a vertex is beside the border. None where one is not, or they are on two borders.
std::optional<Way> walkBorder(const CurveMesh& mesh, int from, int to, double longest);

// Makes the places of a way vertices, which are given back; each two in succession are joined by an edge.
std::vector<int> makeWay(CurveMesh& mesh, const Way& way);

} // namespace oversketch
#endif
