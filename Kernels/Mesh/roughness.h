// How sharply neighbouring triangles of a part of a mesh meet: what a remeshing must not make worse.
#ifndef oversketch_kernels_mesh_roughness_h
#define oversketch_kernels_mesh_roughness_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

struct Roughness
{
  double meanAngle = 0.0;  // between the normals of two neighbours, over all edges of the part [degrees]
  double sharpShare = 0.0; // edges over sharpAngle by length, of all edges of the part, 0 to 1
};

constexpr double sharpAngle = 40.0; // degrees

// More than 1.25 times plus 1 degree of the other's mean angle, or over 0.01 more of sharp length.
bool rougher(const Roughness& one, const Roughness& other);

// Looks at the edges with an end in the region (one byte per vertex) and two triangles of positive area; zero
// where there is none. Edges with one triangle or more than two count for nothing; winding does not matter.
// Summed in the order of the edges.
Roughness roughness(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& region,
  const Context& context = Context());

} // namespace oversketch
#endif
