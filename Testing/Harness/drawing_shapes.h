// Strokes and measures that the raster's tests share. Header-only.
#ifndef oversketch_testing_harness_drawing_shapes_h
#define oversketch_testing_harness_drawing_shapes_h

#include "Harness/threads.h"
#include "Raster/distance_maps.h"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace oversketch_test
{

constexpr double turn = 6.283185307179586;

// One px is one world unit; the sample (i, j) lies at (i, j) where the frame is used as it is.
inline oversketch::Frame pixelFrame(int width = 1028, int height = 1028)
{
  return { oversketch::Vector2::Zero(), 1.0, width, height };
}

inline oversketch::Polyline ringAt(double x, double y, double radius, int count = 0)
{
  oversketch::Polyline points;
  const int steps = count > 0 ? count : std::max(12, static_cast<int>(turn * radius / 5.0));
  for (int i = 0; i < steps; ++i)
  {
    const double angle = turn * i / steps;
    points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  return points;
}

inline oversketch::DrawnStroke closedStroke(oversketch::Polyline points)
{
  return { std::move(points), true };
}

inline oversketch::DrawnStroke openStroke(oversketch::Polyline points)
{
  return { std::move(points), false };
}

inline std::string digits(double value, int count = 3)
{
  std::ostringstream text;
  text << std::setprecision(count) << value;
  return text.str();
}

} // namespace oversketch_test
#endif
