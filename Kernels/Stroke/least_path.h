// The cheapest way along a picture's edges between two pixels.
#ifndef oversketch_kernels_stroke_least_path_h
#define oversketch_kernels_stroke_least_path_h

#include "Mesh/context.h"
#include "Stroke/edges.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace oversketch
{

using Pixel = Eigen::Vector2i;

// A rectangle of the picture in which paths are looked for.
struct PathField
{
  enum State : std::uint8_t
  {
    Outside = 0, // no path goes there
    Plain = 1,
    Edge = 2 // an edge that counts
  };
  int x0 = 0, y0 = 0, width = 0, height = 0;
  std::vector<std::uint8_t> states; // of its pixels, row by row
  std::vector<float> extra;         // what a px of way to each costs besides; empty: nothing
};

// The whole picture, every edge counting.
PathField wholeField(const EdgeFeatures& features);

// The path of least cost over eight neighbours between two pixels of the field, both among its pixels; empty
// where the field does not join them. A step from p to q costs 0.43 fZ(q) + 0.43 fD(p, q) + 0.14 fG(q): fZ is
// 0 on an edge that counts, else 1; fG = 1 - g / g_max, over sqrt(2) on a step along an axis; fD = (acos dp +
// acos dq) / pi, dp and dq the unit step times the edge's tangents at p and q, both turned about where dp is
// negative. (Weights are OpenCV's, the paper gives none.) Of equally cheap ways to a pixel the one found
// first stays; of places equally far the lower is left first.
std::vector<Pixel> leastPath(const EdgeFeatures& features,
  const PathField& field,
  const Pixel& from,
  const Pixel& to,
  const Context& context);

// Cost of a given path, by its formula.
double pathCost(const EdgeFeatures& features, const PathField& field, const std::vector<Pixel>& path);

// Direction of the edge through a pixel [rad], at right angles to the gradient; NaN where there is none.
inline double tangentOf(const EdgeFeatures& features, std::size_t pixel)
{
  const float gx = features.gx[pixel], gy = features.gy[pixel];
  return gx == 0.0f && gy == 0.0f ? std::numeric_limits<double>::quiet_NaN()
                                  : std::atan2(-static_cast<double>(gx), static_cast<double>(gy));
}

// Where a pixel's state is in the field; -1 beside it.
int indexOf(const PathField& field, const Pixel& pixel);

} // namespace oversketch
#endif
