// The least cut of a graph between a source and a sink. A part of the junction cut.
#ifndef oversketch_kernels_region_flow_h
#define oversketch_kernels_region_flow_h

#include <vector>

namespace oversketch
{

// Nodes, what each may take from the source and give to the sink, and links between them that carry as much
// either way. Capacities are whole numbers whose sums stay below 2^53, so that all of it is exact.
struct FlowNetwork
{
  struct Link
  {
    int a, b;
    double capacity;
  };

  std::vector<double> source, sink; // by node
  std::vector<Link> links;
};

// 1 for the nodes on the source's side of the least cut, of several such cuts the one with the fewest.
std::vector<char> leastCut(const FlowNetwork& network);

} // namespace oversketch
#endif
