// The least cut of a graph between a source and a sink. A part of the junction cut.
#ifndef oversketch_flow_h
#define oversketch_flow_h

#include <array>
#include <vector>

namespace oversketch
{

// Nodes, edges between them that carry as much either way, and what each node may take from the source and
// give to the sink. Capacities are whole numbers whose sums stay below 2^53, so that all of it is exact.
class FlowGraph
{
public:
  explicit FlowGraph(int nodes)
    : source(nodes, 0.0)
    , sink(nodes, 0.0)
  {
  }

  void addEdge(int a, int b, double capacity) { this->edges.push_back({ { a, b }, capacity }); }

  // 1 for the nodes on the source's side of the least cut, of several such cuts the one with the fewest.
  std::vector<char> sourceSide() const;

  std::vector<double> source, sink; // capacities, by node

private:
  struct Edge
  {
    std::array<int, 2> ends;
    double capacity;
  };
  std::vector<Edge> edges;

  friend class Preflow;
};

} // namespace oversketch
#endif
