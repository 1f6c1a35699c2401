#include "Region/flow.h"

#include <algorithm>

namespace oversketch
{

// Push and relabel, the highest node first, with gaps and heights found anew now and then (Cherkassky and
// Goldberg 1997); only its first half, which tells the cut. It goes from the sink to the source: what the
// narrow part between them holds back then stays on the wide side. The benchmark "junction flow" sets it beside
// Boost's two flows.
class Preflow
{
public:
  explicit Preflow(const FlowGraph& graph)
    : count(static_cast<int>(graph.source.size()))
    , nodes(graph.source.size() + 1)
    , arcs(2 * graph.edges.size())
    , unreached(count + 1)
    , active(unreached, -1)
    , standing(unreached, -1)
    , crowd(unreached, 0)
  {
    for (const FlowGraph::Edge& edge : graph.edges)
    {
      for (const int end : edge.ends)
      {
        ++this->nodes[end + 1].firstArc;
      }
    }
    for (int v = 0; v < this->count; ++v)
    {
      this->nodes[v + 1].firstArc += this->nodes[v].firstArc;
      this->nodes[v].current = this->nodes[v].firstArc;
      const double through = std::min(graph.source[v], graph.sink[v]);
      this->nodes[v].excess = graph.sink[v] - through;
      this->nodes[v].room = graph.source[v] - through;
    }
    for (const FlowGraph::Edge& edge : graph.edges)
    {
      const int a = this->nodes[edge.ends[0]].current++, b = this->nodes[edge.ends[1]].current++;
      this->arcs[a] = { edge.ends[1], b, edge.capacity };
      this->arcs[b] = { edge.ends[0], a, edge.capacity };
    }
    this->places.reserve(2 * this->nodes.size());
    this->queue.reserve(this->nodes.size());
  }

  void run()
  {
    this->measureHeights();
    while (this->top > 0)
    {
      const int v = this->active[this->top];
      if (v < 0)
      {
        --this->top;
        continue;
      }
      this->active[this->top] = this->nodes[v].nextActive;
      if (this->nodes[v].height == this->top)
      {
        this->discharge(v);
      }
      if (this->work > patience * this->count)
      {
        this->measureHeights();
      }
    }
    this->measureHeights();
  }

  bool reachesSource(int v) const { return this->nodes[v].height < this->unreached; }

private:
  static constexpr long patience = 12; // arcs looked at per node before heights are found anew

  struct Node
  {
    double excess = 0.0, room = 0.0; // to be passed on; that the source still takes
    int height = 0;                  // at most the number of arcs to the source
    int current = 0, firstArc = 0;
    int nextActive = -1; // of the same height
  };
  struct Arc
  {
    int to, back;
    double capacity; // that is left
  };
  struct Standing
  {
    int node, next;
  };

  void activate(int v)
  {
    Node& node = this->nodes[v];
    node.nextActive = this->active[node.height];
    this->active[node.height] = v;
    this->top = std::max(this->top, node.height);
  }

  void raise(int v, int height)
  {
    this->nodes[v].height = height;
    this->nodes[v].current = this->nodes[v].firstArc;
    ++this->crowd[height];
    this->places.push_back({ v, this->standing[height] });
    this->standing[height] = static_cast<int>(this->places.size()) - 1;
    this->tallest = std::max(this->tallest, height);
  }

  // Numbers of arcs to the source, by breadth.
  void measureHeights()
  {
    std::fill(this->active.begin(), this->active.end(), -1);
    std::fill(this->standing.begin(), this->standing.end(), -1);
    std::fill(this->crowd.begin(), this->crowd.end(), 0);
    this->places.clear();
    this->queue.clear();
    this->top = this->tallest = 0;
    this->work = 0;
    const auto reach = [this](int v, int height)
    {
      this->raise(v, height);
      this->queue.push_back(v);
      if (this->nodes[v].excess > 0.0)
      {
        this->activate(v);
      }
    };
    for (int v = 0; v < this->count; ++v)
    {
      this->nodes[v].height = this->unreached;
    }
    for (int v = 0; v < this->count; ++v)
    {
      if (this->nodes[v].room > 0.0)
      {
        reach(v, 1);
      }
    }
    std::size_t looked = 0;
    while (looked < this->queue.size()) // it grows
    {
      const int v = this->queue[looked++];
      for (int a = this->nodes[v].firstArc; a < this->nodes[v + 1].firstArc; ++a)
      {
        const Arc& arc = this->arcs[a];
        if (this->nodes[arc.to].height == this->unreached && this->arcs[arc.back].capacity > 0.0)
        {
          reach(arc.to, this->nodes[v].height + 1);
        }
      }
    }
  }

  // Passes on what a node has, until it has none or is as high as its lowest neighbour beyond it.
  void discharge(int v)
  {
    Node& node = this->nodes[v];
    const int end = this->nodes[v + 1].firstArc;
    if (node.height == 1)
    {
      const double moved = std::min(node.excess, node.room);
      node.excess -= moved;
      node.room -= moved;
    }
    for (; node.excess > 0.0 && node.current < end; ++node.current)
    {
      Arc& arc = this->arcs[node.current];
      Node& other = this->nodes[arc.to];
      ++this->work;
      if (arc.capacity > 0.0 && other.height == node.height - 1)
      {
        const double moved = std::min(node.excess, arc.capacity);
        if (other.excess == 0.0)
        {
          this->activate(arc.to);
        }
        other.excess += moved;
        arc.capacity -= moved;
        this->arcs[arc.back].capacity += moved;
        node.excess -= moved;
        if (node.excess == 0.0)
        {
          return; // the arc may take more yet
        }
      }
    }
    if (node.excess > 0.0)
    {
      this->relabel(v);
    }
  }

  void relabel(int v)
  {
    Node& node = this->nodes[v];
    const int end = this->nodes[v + 1].firstArc, old = node.height;
    this->work += end - node.firstArc;
    if (--this->crowd[old] == 0)
    {
      this->closeGap(old);
      node.height = this->unreached;
      return;
    }
    int lowest = this->unreached;
    for (int a = node.firstArc; a < end; ++a)
    {
      if (this->arcs[a].capacity > 0.0)
      {
        lowest = std::min(lowest, this->nodes[this->arcs[a].to].height);
      }
    }
    if (lowest + 1 >= this->unreached)
    {
      node.height = this->unreached;
      return;
    }
    this->raise(v, lowest + 1);
    this->activate(v);
  }

  // Nobody stands at a height: from above it nothing comes down to the source.
  void closeGap(int height)
  {
    for (int h = height + 1; h <= this->tallest; ++h)
    {
      for (int i = this->standing[h]; i >= 0; i = this->places[i].next)
      {
        if (this->nodes[this->places[i].node].height == h)
        {
          this->nodes[this->places[i].node].height = this->unreached;
        }
      }
      this->standing[h] = -1;
      this->crowd[h] = 0;
    }
    this->tallest = height;
  }

  int count;
  std::vector<Node> nodes; // one more at the end
  std::vector<Arc> arcs;   // node by node
  int unreached;           // a height: the source is out of reach
  std::vector<int> active; // by height: the first node with excess, with others behind it
  int top = 0;             // the highest of them, or higher
  // By height: who stands there or once did, and how many do.
  std::vector<int> standing;
  std::vector<Standing> places;
  std::vector<int> crowd;
  int tallest = 0;
  std::vector<int> queue;
  long work = 0;
};

std::vector<char> FlowGraph::sourceSide() const
{
  Preflow preflow(*this);
  preflow.run();
  std::vector<char> side(this->source.size());
  for (std::size_t v = 0; v < side.size(); ++v)
  {
    side[v] = preflow.reachesSource(static_cast<int>(v));
  }
  return side;
}

} // namespace oversketch
