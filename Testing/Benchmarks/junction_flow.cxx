#include "junction_flow.h"

#include "Region/cut.h"
#include "Region/flow.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/push_relabel_max_flow.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace oversketch_bench
{

namespace
{

// The network with source and sink as its last two nodes, as Boost's flows want it: every arc has a reverse
// one. In rows, Boost's quickest form.
class BoostNetwork
{
public:
  using Graph = boost::compressed_sparse_row_graph<boost::directedS,
    boost::no_property,
    boost::no_property,
    boost::no_property,
    int,
    int>;
  using Arc = boost::graph_traits<Graph>::edge_descriptor;

  explicit BoostNetwork(const Network& network)
    : count(static_cast<int>(network.source.size()))
  {
    std::vector<int> first(count + 3, 0);
    const auto each = [&](const auto& pair)
    {
      for (const Network::Link& link : network.links)
      {
        pair(link.a, link.b, link.capacity, link.capacity);
      }
      for (int v = 0; v < count; ++v)
      {
        if (network.source[v] > 0.0)
        {
          pair(count, v, network.source[v], 0.0);
        }
        if (network.sink[v] > 0.0)
        {
          pair(v, count + 1, network.sink[v], 0.0);
        }
      }
    };
    int arcs = 0;
    each(
      [&](int a, int b, double, double)
      {
        ++first[a + 1];
        ++first[b + 1];
        arcs += 2;
      });
    for (int v = 0; v < count + 2; ++v)
    {
      first[v + 1] += first[v];
    }
    std::vector<std::pair<int, int>> ends(arcs);
    this->capacity.resize(arcs);
    this->residual.resize(arcs);
    this->reverse.resize(arcs);
    each(
      [&](int a, int b, double there, double back)
      {
        const int i = first[a]++, j = first[b]++;
        ends[i] = { a, b };
        ends[j] = { b, a };
        this->capacity[i] = static_cast<std::int64_t>(there);
        this->capacity[j] = static_cast<std::int64_t>(back);
        this->reverse[i] = Arc(b, j);
        this->reverse[j] = Arc(a, i);
      });
    this->graph = Graph(boost::edges_are_sorted, ends.begin(), ends.end(), count + 2, arcs);
  }

  // A property of the arcs for Boost.
  template <typename T>
  auto map(std::vector<T>& values)
  {
    return boost::make_iterator_property_map(values.begin(), boost::get(boost::edge_index, this->graph));
  }

  // The nodes that the source reaches by arcs that can take more.
  std::vector<char> sourceSide() const
  {
    std::vector<char> side(count + 2, 0);
    std::vector<int> queue(1, count);
    side[count] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      for (auto [arc, end] = boost::out_edges(queue[i], this->graph); arc != end; ++arc)
      {
        const int to = static_cast<int>(boost::target(*arc, this->graph));
        if (!side[to] && this->residual[boost::get(boost::edge_index, this->graph, *arc)] > 0)
        {
          side[to] = 1;
          queue.push_back(to);
        }
      }
    }
    side.resize(count);
    return side;
  }

  int count;
  Graph graph;
  std::vector<std::int64_t> capacity, residual;
  std::vector<Arc> reverse;
};

} // namespace

double Network::cost(const std::vector<char>& side) const
{
  double sum = 0.0;
  for (std::size_t v = 0; v < side.size(); ++v)
  {
    sum += side[v] ? this->sink[v] : this->source[v];
  }
  for (const Link& link : this->links)
  {
    sum += side[link.a] != side[link.b] ? link.capacity : 0.0;
  }
  return sum;
}

Network junctionNetwork(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const std::vector<double>& diameter,
  const std::vector<char>& isSeed,
  const std::vector<char>& region)
{
  std::vector<int> border;
  std::vector<double> thickness;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Lists& around = adjacency.vertexVertices;
    if (region[v] && std::any_of(around.begin(v), around.end(v), [&](int n) { return !region[n]; }))
    {
      border.push_back(v);
      thickness.push_back(diameter[v]);
    }
  }
  std::nth_element(thickness.begin(), thickness.begin() + thickness.size() / 2, thickness.end());
  const CutOptions options;
  const double width = options.band * thickness[thickness.size() / 2];
  const std::vector<double> distance = edgeDistances(mesh, adjacency, border, width);

  Network network;
  const double scale = 1e9 / boundingDiagonal(mesh);
  std::vector<int> node(mesh.triangles.size(), -1);
  const auto corners = [&](int t, const auto& has)
  { return std::count_if(mesh.triangles[t].begin(), mesh.triangles[t].end(), has); };
  const auto selected = [&](int t) { return corners(t, [&](int v) { return region[v] != 0; }); };
  const auto inside = [&](int t)
  { return corners(t, [&](int v) { return isSeed[v] != 0; }) > 0 || selected(t) == 3; };
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const bool near = corners(t, [&](int v) { return std::isfinite(distance[v]); }) > 0;
    if (near && corners(t, [&](int v) { return isSeed[v] != 0; }) == 0)
    {
      node[t] = static_cast<int>(network.source.size());
      const auto [a, b, c] = mesh.triangles[t];
      const double area =
        0.5 * (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
      const double cost = std::round(scale * options.faithful * area / width);
      network.source.push_back(selected(t) == 3 ? cost : 0.0);
      network.sink.push_back(selected(t) == 0 ? cost : 0.0);
    }
  }
  const auto centre = [&](int t) -> Vector3
  {
    const auto [a, b, c] = mesh.triangles[t];
    return (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
  };
  const auto normal = [&](int t) -> Vector3
  {
    const auto [a, b, c] = mesh.triangles[t];
    return (normals[a] + normals[b] + normals[c]).stableNormalized();
  };
  for (const MeshEdge& edge : adjacency.edges)
  {
    const int a = adjacency.edgeTriangles[edge.firstTriangle],
              b = adjacency.edgeTriangles[edge.firstTriangle + edge.triangleCount - 1];
    if (node[a] == node[b]) // a border, or both outside the band
    {
      continue;
    }
    const Vector3 step = centre(b) - centre(a);
    const double curvature = (normal(b) - normal(a)).dot(step) / step.squaredNorm(); // < 0: concave
    const double cost = std::round(scale * (mesh.points[edge.v0] - mesh.points[edge.v1]).norm() /
                                   (1.0 + width * std::max(0.0, -curvature)));
    if (node[a] >= 0 && node[b] >= 0)
    {
      network.links.push_back({ node[a], node[b], cost });
    }
    else
    {
      (inside(node[a] >= 0 ? b : a) ? network.source : network.sink)[std::max(node[a], node[b])] += cost;
    }
  }
  return network;
}

std::vector<char> oursOf(const Network& network)
{
  FlowGraph graph(static_cast<int>(network.source.size()));
  graph.source = network.source;
  graph.sink = network.sink;
  for (const Network::Link& link : network.links)
  {
    graph.addEdge(link.a, link.b, link.capacity);
  }
  return graph.sourceSide();
}

std::vector<char> boykovKolmogorovOf(const Network& network)
{
  BoostNetwork made(network);
  std::vector<BoostNetwork::Arc> predecessor(made.count + 2);
  std::vector<boost::default_color_type> colour(made.count + 2);
  std::vector<int> distance(made.count + 2);
  const auto index = boost::get(boost::vertex_index, made.graph);
  boost::boykov_kolmogorov_max_flow(made.graph,
    made.map(made.capacity),
    made.map(made.residual),
    made.map(made.reverse),
    boost::make_iterator_property_map(predecessor.begin(), index),
    boost::make_iterator_property_map(colour.begin(), index),
    boost::make_iterator_property_map(distance.begin(), index),
    index,
    made.count,
    made.count + 1);
  return made.sourceSide();
}

std::vector<char> pushRelabelOf(const Network& network)
{
  BoostNetwork made(network);
  boost::push_relabel_max_flow(made.graph,
    made.count,
    made.count + 1,
    made.map(made.capacity),
    made.map(made.residual),
    made.map(made.reverse),
    boost::get(boost::vertex_index, made.graph));
  return made.sourceSide();
}

} // namespace oversketch_bench
