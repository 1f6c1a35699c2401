// The search for the cheapest ways over the pixels of a field. Private to this folder.
#ifndef oversketch_kernels_stroke_path_search_h
#define oversketch_kernels_stroke_path_search_h

#include "Mesh/context.h"
#include "Stroke/path_field.h"
#include "Stroke/place_queue.h"

#include <array>
#include <utility>

namespace oversketch
{

struct PathWeights
{
  static constexpr double straightAngle = 3.14159265358979323846;
  static constexpr double edge = 0.43, turn = 0.43, gradient = 0.14;
};

// The cheapest ways to some pixels of a field, the targets, from others.
class PathTree
{
public:
  struct Start
  {
    Pixel pixel;
    double cost; // of the way there
  };
  // Cost to a target: infinite where no way leads.
  double cost(const Pixel& target) const;
  // From a start to a target; empty where no way leads.
  std::vector<Pixel> pathTo(const Pixel& target) const;

private:
  friend class PathSearch;
  int numberOf(const Pixel& pixel) const;

  int X0 = 0, Y0 = 0, Width = 0;             // of the field with a frame of one pixel
  std::vector<std::pair<int, double>> Costs; // of the targets, by their numbers
  std::vector<std::uint8_t> Back; // the number of the last step to a pixel; that of steps where a way begins
};

// Makes such trees, one after the other, in the same memory.
class PathSearch
{
public:
  PathSearch();
  ~PathSearch();
  PathSearch(const PathSearch&) = delete;
  PathSearch& operator=(const PathSearch&) = delete;

  // The ways of least cost over eight neighbours. A step from p to q costs 0.43 fZ(q) + 0.43 fD(p, q) + 0.14
  // fG(q), and what the field says besides: fZ is 0 on an edge that counts, else 1; fG = 1 - g / g_max, over
  // sqrt(2) on a step along an axis; fD = (acos dp + acos dq) / pi, dp and dq the unit step times the edge's
  // tangents at p and q, both turned about where dp is negative. (Weights are OpenCV's, the paper gives
  // none.) Of equally cheap ways to a pixel the one found first stays; of places equally far the lower is
  // left first. Looks until all of the targets that can be reached are. Pixels that are not the field's are
  // left out.
  PathTree operator()(const EdgeFeatures& features,
    const PathField& field,
    const std::vector<PathTree::Start>& starts,
    const std::vector<Pixel>& targets,
    const Context& context);

private:
  struct Cell;
  struct Slack;
  // Makes the cells; how much a step costs at most.
  double fill(const EdgeFeatures& features, const PathField& field);
  // Goes a step on from a place, every way.
  void leave(const PlaceQueue::Place& place, int across);

  const std::array<double, 8> Angles; // of the steps
  std::vector<Cell> Cells;
  std::vector<Slack> Slacks; // of the cells
  PlaceQueue Queue;
};

} // namespace oversketch
#endif
