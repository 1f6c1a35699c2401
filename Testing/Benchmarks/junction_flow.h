// The least cut at a junction as a flow between a source and a sink, and who finds it.
#ifndef oversketch_junction_flow_h
#define oversketch_junction_flow_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch_bench
{

using namespace oversketch;

// What each node may take from the source and give to the sink, and links that carry as much either way. All
// capacities are whole numbers.
struct Network
{
  struct Link
  {
    int a, b;
    double capacity;
  };
  std::vector<double> source, sink;
  std::vector<Link> links;

  // Of the cut between those nodes with 1 and the others.
  double cost(const std::vector<char>& side) const;
};

// The band round the region's border, a node a triangle, with the capacities of cutAtJunction.
Network junctionNetwork(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const std::vector<double>& diameter,
  const std::vector<char>& isSeed,
  const std::vector<char>& region);

// 1 for the nodes on the source's side of a least cut; each makes the graph that it needs.
std::vector<char> oursOf(const Network& network);
std::vector<char> boykovKolmogorovOf(const Network& network);
std::vector<char> pushRelabelOf(const Network& network);

} // namespace oversketch_bench
#endif
