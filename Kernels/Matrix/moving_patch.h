// The part of a mesh that changes its shape while some of its vertices move.
#ifndef oversketch_kernels_matrix_moving_patch_h
#define oversketch_kernels_matrix_moving_patch_h

#include "Mesh/mesh.h"

#include <array>
#include <utility>
#include <vector>

namespace oversketch
{

struct Context;

class MovingPatch
{
public:
  MovingPatch() = default;
  // moving: vertices that will move, ascending.
  MovingPatch(const Mesh& mesh, const Adjacency& adjacency, const std::vector<int>& moving);

  const std::vector<int>& moving() const { return this->Moving; }
  const std::vector<Vector3>& rest() const { return this->Rest; } // their places when it was made

  enum class Normals
  {
    None,
    OfVertices,
    OfFaces,
    OfBoth
  };
  // The changes of a mesh when its vertices move: normals by vertex and by face, ascending. They are those
  // of vertexNormals and facetNormal but for rounding; many triangles are measured side by side.
  struct Shape
  {
    std::vector<std::pair<int, Vector3>> vertexNormals, faceNormals;
    int foldedEdges = 0; // whose faces' normals are over 120 degrees apart, and were not before they moved
  };
  // places: of moving(). Throws Error(Failure::Cancelled).
  Shape shapeAt(const std::vector<Vector3>& places, Normals normals, const Context& context);

private:
  // Normals of the near faces, and the angles at their corners.
  struct Measures
  {
    std::vector<Vector3> normals;
    std::vector<std::array<double, 3>> angles;
  };
  const Measures& measured(const Context& context);

  Mesh Near; // all faces round those that change, with their vertices numbered anew
  Measures Measured;
  std::vector<int> Moving;
  std::vector<Vector3> Rest;
  std::vector<int> Faces, Touched;                          // faces that change, and their vertices
  std::vector<int> MovingPlaces, FacePlaces, TouchedPlaces; // in Near
  Lists Corners;                          // of each touched vertex: corner k of near face t is 3 t + k
  std::vector<std::array<int, 2>> Joints; // near faces at an edge of one that changes, not folded before
};

} // namespace oversketch
#endif
