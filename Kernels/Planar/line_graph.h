// Lines that share places: edges between these, the faces they enclose, and what bounds them.
#ifndef oversketch_kernels_planar_line_graph_h
#define oversketch_kernels_planar_line_graph_h

#include "Stroke/meetings.h"

namespace oversketch
{

double apart(const GridPlace& a, const GridPlace& b);

// A line from place to place, numbers of them; a closed one does not repeat the first.
struct PlacePath
{
  std::vector<int> at;
  bool closed = false;

  int segments() const { return static_cast<int>(this->at.size()) - (this->closed ? 0 : 1); }
  int from(int segment) const { return this->at[segment]; }
  int to(int segment) const { return this->at[(segment + 1) % this->at.size()]; }
  double length(const std::vector<GridPlace>& places) const;
};

// Graph of lines that meet in common places alone. An edge that several lines have is one.
class LineGraph
{
public:
  LineGraph(const std::vector<GridPlace>& places, const std::vector<PlacePath>& paths);

  // -1 where there is none, or it has been taken away.
  int edgeBetween(int a, int b) const;
  int degree(int place) const { return static_cast<int>(this->Around[place].size()); }
  std::array<int, 2> ends(int edge) const { return this->Edges[edge]; }
  int other(int edge, int place) const
  {
    return this->Edges[edge][0] == place ? this->Edges[edge][1] : this->Edges[edge][0];
  }
  int edgeCount() const { return static_cast<int>(this->Edges.size()); }
  double length(const std::vector<int>& edges) const;
  bool has(int edge) const { return !this->Gone[edge]; }
  void remove(int edge);

  // From an edge, away from `place`, through places where two edges meet: all edges up to one where another
  // number does, or all round.
  std::vector<int> chain(int edge, int place) const;

  // A walk round a face, which lies on its left: places in order, and twice what they enclose, negative on
  // the outside of what hangs together.
  struct Walk
  {
    std::vector<int> places, edges; // edges[i] leads to the next place
    double area = 0.0;
  };
  // Over all edges, or without those of which `left` says so; with each edge's walks, from the first of its
  // ends to the second and back.
  std::vector<Walk> walks(const std::vector<char>& left, std::vector<std::array<int, 2>>& ofEdge) const;

private:
  const std::vector<GridPlace>& Places;
  std::vector<std::array<int, 2>> Edges; // the lesser place first
  std::vector<char> Gone;
  std::vector<std::vector<int>> Around; // of each place, edges that are there, in order of the edges' numbers
};

} // namespace oversketch
#endif
