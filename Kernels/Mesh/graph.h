// A profile written as points that straight lines join: a function on the unit interval.
#ifndef oversketch_kernels_mesh_graph_h
#define oversketch_kernels_mesh_graph_h

#include "Mesh/mesh.h"

#include <string>
#include <vector>

namespace oversketch
{

class Graph
{
public:
  // From "x y, x y, ..." with x rising from 0 to 1. Two points at one x, a cliff, are refused: so near to
  // each other as is wanted does the same. Throws Error(BadStroke) that names the point and gives the
  // example.
  static Graph parse(const std::string& text, const std::string& example);

  // x in [0, 1]; beyond, the line of that end is followed on.
  double operator()(double x) const;

  const std::vector<Vector2>& points() const { return this->Points; }

private:
  std::vector<Vector2> Points;
};

} // namespace oversketch
#endif
