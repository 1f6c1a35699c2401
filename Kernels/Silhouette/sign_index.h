// Where the sign of g(v) = n_v . d(v) changes over a mesh, for one view after another.
#ifndef oversketch_sign_index_h
#define oversketch_sign_index_h

#include "Mesh/mesh.h"
#include "Mesh/view.h"

#include <cstdint>
#include <vector>

namespace oversketch
{

// g of a vertex. Its sign is counted as + for g >= 0.
inline double silhouetteValue(const Mesh& mesh,
  const std::vector<Vector3>& normals,
  const View& view,
  int vertex)
{
  return normals[vertex].dot(view.towardsViewer(mesh.points[vertex]));
}

// The edges whose ends have g of different sign, and between which two numbers the largest |g| of all
// vertices lies.
struct SignChanges
{
  std::vector<std::uint64_t> edges; // edge e is bit e % 64 of word e / 64
  double least = 0.0, most = 0.0;

  bool at(int edge) const { return this->edges[edge >> 6] >> (edge & 63) & 1; }
};

// The plain way: every vertex and every edge is looked at. least = most.
SignChanges findSignChanges(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const View& view);

// The same for many views of one mesh, looking only at parts that the silhouette may cross. g is linear in
// (n_v, -n_v . p_v), so a box round these four numbers over a clump of neighbouring vertices bounds it; in
// the clumps that are left, g in single precision decides where it is beyond its own error, and the exact one
// elsewhere: the edges found are those of the plain way, bit for bit. Made in about the time of the
// adjacency; mesh and normals must outlive it and stay as they are. About 30 bytes a triangle.
class SignIndex
{
public:
  SignIndex(const Mesh& mesh, const Adjacency& adjacency, const std::vector<Vector3>& normals);

  // Into `changes`, whose words are all 0 or which is new.
  void find(const View& view, SignChanges& changes) const;

private:
  struct Clump
  {
    int firstVertex, firstFan;
  };
  // Edges from a vertex to higher ones, whose ids follow each other as those vertices do.
  struct Fan
  {
    std::uint64_t others; // local numbers
    int firstEdge;
    int vertex; // local number
  };

  class ClumpMaker;

  // Has the memory bring a clump's numbers: clumps apart in memory are no pattern that it sees by itself.
  void fetch(int clump) const;

  const Mesh& mesh;
  const Adjacency& adjacency;
  const std::vector<Vector3>& normals;
  Vector3 centre = Vector3::Zero(); // of the box of the points; they are taken from here
  double reach = 0.0;               // largest |n . (p - centre)|
  double extent = 0.0;              // largest coordinate, for the error of the exact g itself
  std::vector<Clump> clumps;        // one more at the end
  std::vector<float> boxes;         // middle and half extent: eight rows of one number a clump
  std::vector<int> vertices;        // of the clumps, ascending in each
  std::vector<float> values;        // n and -n . (p - centre): per clump four rows of one number a vertex
  std::vector<Fan> fans;
};

} // namespace oversketch
#endif
