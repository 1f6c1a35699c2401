// A mesh while curves are made edges of it: splits, flips and collapses, where new vertices come from, and
// curves that are kept when their edges are split.
#ifndef oversketch_kernels_remesh_curve_mesh_h
#define oversketch_kernels_remesh_curve_mesh_h

#include "Mesh/mesh.h"
#include "Mesh/place.h"

#include <unordered_map>
#include <vector>

namespace oversketch
{

// A curve of mesh vertices; where it is embedded, each two in succession are an edge.
struct MeshCurve
{
  std::vector<int> vertices;      // none of them twice
  std::vector<double> parameters; // one per vertex, strictly increasing, 0 to 1
  bool closed = false;            // the first vertex is not repeated

  int count() const { return static_cast<int>(this->vertices.size()); }
  int segments() const { return this->count() - !this->closed; }
  int next(int i) const { return (i + 1) % this->count(); }
};

// Edges are found from their vertices, so that borders and edges of more than two triangles are legal.
// Triangles keep their winding.
class CurveMesh
{
public:
  explicit CurveMesh(const Mesh& mesh);

  const std::vector<Vector3>& points() const { return this->Points; }
  const Vector3& point(int v) const { return this->Points[v]; }
  const std::vector<Triangle>& triangles() const { return this->Triangles; }
  const Triangle& triangle(int t) const { return this->Triangles[t]; }
  const std::vector<int>& around(int v) const; // triangles, in no order
  double diagonal() const { return this->Diagonal; }
  bool inserted(int v) const { return v >= this->InputCount; }
  // Whether a vertex was of no triangle from the start.
  bool loose(int v) const { return !this->inserted(v) && this->InputAround.size(v) == 0; }
  bool alive(int t) const { return this->Triangles[t][0] >= 0; }

  // The input vertices that a vertex is a mean of; itself, of those that were there.
  Mix origin(int v) const;
  // The input triangle that a triangle comes from.
  int source(int t) const { return this->Sources[t]; }
  // The triangles that an input triangle has become by splits; asked for before any flip or collapse.
  std::vector<int> piecesOf(int inputTriangle) const;

  // Triangles with both vertices, ascending.
  std::vector<int> trianglesAt(int a, int b) const;
  bool joined(int a, int b) const;
  std::vector<int> neighbours(int v) const; // ascending
  // The corner of a triangle that is neither of two others.
  int opposite(int t, int a, int b) const;
  Vector3 cross(int t) const; // twice the area times the normal

  // A vertex inside a triangle, by the weights of its corners.
  int splitTriangle(int t, const std::array<double, 3>& weights);
  // A vertex on an edge, (1 - s) a + s b; added to the curves that have this edge.
  int splitEdge(int a, int b, double s);
  // Input vertices whose triangles are only split, a byte each; empty: none.
  std::vector<char> left;
  bool isLeft(int v) const { return v >= 0 && v < static_cast<int>(this->left.size()) && this->left[v] != 0; }
  // The edge of two triangles turns into the other diagonal.
  void flip(int a, int b);
  // `from` becomes `to`; the triangles at their edge go, and `from` leaves its curves.
  void collapse(int from, int to);

  // Curves that edges are kept for; vertices of `marks` above 0 are on one, or will be.
  std::vector<MeshCurve> curves;
  std::vector<int> marks; // per vertex
  bool onCurve(int v) const { return this->marks[v] > 0; }
  // Whether two vertices follow each other on a curve.
  bool curveEdge(int a, int b) const;
  // Marks the vertices of the curves, and no others.
  void markCurves();

private:
  int addPoint(const Vector3& point, Mix origin);
  int addTriangle(const Triangle& t, int source);
  void replace(int t, int from, int to);
  void detach(int v, int t);
  std::vector<int>& listOf(int v);

  std::vector<Vector3> Points;
  std::vector<Triangle> Triangles; // -1 for those that are gone
  Lists InputAround;
  // Triangles of inserted vertices, and of those of the input that were asked for: a curve comes to few of
  // them.
  mutable std::unordered_map<int, std::vector<int>> Around;
  std::vector<Mix> Origins; // of inserted vertices
  std::vector<int> Sources;
  std::unordered_map<int, std::vector<int>> Pieces; // of input triangles that were split, beside themselves
  int InputCount, InputTriangles;
  double Diagonal;
};

// Cuts out what lies between two visits of a vertex, of a closed path the shorter part.
void cutLoops(MeshCurve& path, const CurveMesh& mesh);

} // namespace oversketch
#endif
