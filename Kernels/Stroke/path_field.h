// Part of a picture in which ways along its edges are looked for.
#ifndef oversketch_kernels_stroke_path_field_h
#define oversketch_kernels_stroke_path_field_h

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

// Direction of the edge through a pixel [rad], at right angles to the gradient; NaN where there is none.
inline double tangentOf(const EdgeFeatures& features, std::size_t pixel)
{
  const float gx = features.gx[pixel], gy = features.gy[pixel];
  return gx == 0.0f && gy == 0.0f ? std::numeric_limits<double>::quiet_NaN()
                                  : std::atan2(-static_cast<double>(gx), static_cast<double>(gy));
}

// Where a pixel's state is in the field; -1 beside it.
inline int indexOf(const PathField& field, const Pixel& pixel)
{
  const int x = pixel[0] - field.x0, y = pixel[1] - field.y0;
  return x < 0 || y < 0 || x >= field.width || y >= field.height ? -1 : y * field.width + x;
}

} // namespace oversketch
#endif
