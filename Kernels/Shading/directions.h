// Directions at the vertices of a mesh, as angles over their triangles.
#ifndef oversketch_kernels_shading_directions_h
#define oversketch_kernels_shading_directions_h

#include "Mesh/mesh.h"

#include <array>
#include <vector>

namespace oversketch
{

struct Context;

// Refers to the mesh and its adjacency, which must outlive it.
class Directions
{
public:
  // Throws Error(Failure::Cancelled).
  Directions(const Mesh& mesh, const Adjacency& adjacency, const Context& context);

  // Direction of the edge from corner k of a triangle to the next corner, and to the one before.
  double next(int t, int k) const { return this->First[t][k]; }
  double previous(int t, int k) const { return this->First[t][k] + this->Corner[t][k]; }
  double toward(int vertex, int neighbour) const;
  // The angle between two, the shorter way round.
  double between(int vertex, double a, double b) const;
  int corner(int t, int vertex) const { return cornerOf(this->Surface.triangles[t], vertex); }

private:
  // One triangle after the other round a vertex, from the border's where there is one.
  void order(int vertex);

  const Mesh& Surface;
  const Adjacency& Links;
  std::vector<std::array<double, 3>> First, Corner; // by triangle and corner
  std::vector<double> Round;                        // all of it; 0 where it does not close
};

} // namespace oversketch
#endif
