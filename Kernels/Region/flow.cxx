#include "Region/flow.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <cstdint>
#include <utility>

namespace oversketch
{

namespace
{

using Rows = boost::compressed_sparse_row_graph<boost::directedS,
  boost::no_property,
  boost::no_property,
  boost::no_property,
  int,
  int>;
using Arc = boost::graph_traits<Rows>::edge_descriptor;

// The network as Boost's flow wants it: source and sink are its last two nodes, every arc has a reverse one.
class Flow
{
public:
  explicit Flow(const FlowNetwork& network)
    : Count(static_cast<int>(network.source.size()))
  {
    std::vector<int> first(this->Count + 3, 0); // arc of each node
    this->eachPair(network,
      [&](int a, int b, double, double)
      {
        ++first[a + 1];
        ++first[b + 1];
      });
    for (int v = 0; v < this->Count + 2; ++v)
    {
      first[v + 1] += first[v];
    }
    const int arcs = first.back();
    std::vector<std::pair<int, int>> ends(arcs);
    this->Capacity.resize(arcs);
    this->Residual.resize(arcs);
    this->Reverse.resize(arcs);
    this->eachPair(network,
      [&](int a, int b, double there, double back)
      {
        const int i = first[a]++, j = first[b]++;
        ends[i] = { a, b };
        ends[j] = { b, a };
        this->Capacity[i] = static_cast<std::int64_t>(there);
        this->Capacity[j] = static_cast<std::int64_t>(back);
        this->Reverse[i] = Arc(b, j);
        this->Reverse[j] = Arc(a, i);
      });
    this->Graph = Rows(boost::edges_are_sorted, ends.begin(), ends.end(), this->Count + 2, arcs);
  }

  // A property of the arcs for Boost.
  template <typename T>
  auto ofArcs(std::vector<T>& values)
  {
    return boost::make_iterator_property_map(values.begin(), boost::get(boost::edge_index, this->Graph));
  }

  void run()
  {
    std::vector<Arc> predecessor(this->Count + 2);
    std::vector<boost::default_color_type> colour(this->Count + 2);
    std::vector<int> distance(this->Count + 2);
    const auto index = boost::get(boost::vertex_index, this->Graph);
    boost::boykov_kolmogorov_max_flow(this->Graph,
      this->ofArcs(this->Capacity),
      this->ofArcs(this->Residual),
      this->ofArcs(this->Reverse),
      boost::make_iterator_property_map(predecessor.begin(), index),
      boost::make_iterator_property_map(colour.begin(), index),
      boost::make_iterator_property_map(distance.begin(), index),
      index,
      this->Count,
      this->Count + 1);
  }

  // The nodes that the source reaches by arcs that can take more: they are on its side of every least cut.
  std::vector<char> sourceSide() const
  {
    std::vector<char> side(this->Count + 2, 0);
    std::vector<int> queue(1, this->Count);
    side[this->Count] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      for (auto [arc, end] = boost::out_edges(queue[i], this->Graph); arc != end; ++arc)
      {
        const int to = static_cast<int>(boost::target(*arc, this->Graph));
        if (!side[to] && this->Residual[boost::get(boost::edge_index, this->Graph, *arc)] > 0)
        {
          side[to] = 1;
          queue.push_back(to);
        }
      }
    }
    side.resize(this->Count);
    return side;
  }

private:
  // Two arcs each, with their capacities there and back.
  template <typename Visit>
  void eachPair(const FlowNetwork& network, const Visit& visit) const
  {
    for (const FlowNetwork::Link& link : network.links)
    {
      visit(link.a, link.b, link.capacity, link.capacity);
    }
    for (int v = 0; v < this->Count; ++v)
    {
      if (network.source[v] > 0.0)
      {
        visit(this->Count, v, network.source[v], 0.0);
      }
      if (network.sink[v] > 0.0)
      {
        visit(v, this->Count + 1, network.sink[v], 0.0);
      }
    }
  }

  int Count;
  Rows Graph;
  std::vector<std::int64_t> Capacity, Residual;
  std::vector<Arc> Reverse;
};

} // namespace

std::vector<char> leastCut(const FlowNetwork& network)
{
  Flow flow(network);
  flow.run();
  return flow.sourceSide();
}

} // namespace oversketch
