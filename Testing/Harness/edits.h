// A line and a ring over the middle of a model. Header-only.
#ifndef oversketch_testing_harness_edits_h
#define oversketch_testing_harness_edits_h

#include "Harness/polydata.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace oversketch_test
{

// The model from the front, upright, its box 500 px wide or high in a viewport of 800 x 600.
inline View frontOf(vtkPolyData* mesh)
{
  double box[6];
  mesh->GetBounds(box);
  const double size = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
  Eigen::Matrix4d eye = Eigen::Matrix4d::Identity(), p = Eigen::Matrix4d::Identity();
  eye.topRightCorner<3, 1>() = -0.5 * Vector3(box[0] + box[1], box[2] + box[3], box[4] + box[5]);
  eye(2, 3) -= 2.0 * size;
  p(0, 0) = 1000.0 / size / 800.0;
  p(1, 1) = 1000.0 / size / 600.0;
  p(2, 2) = -0.25 / size;
  return View(eye, p, 800, 600);
}

// A gentle S through the middle of the viewport, `length` px long.
inline std::vector<Vector2> lineOver(double length = 60.0, double rise = 0.0)
{
  std::vector<Vector2> samples;
  for (int i = 0; i <= 40; ++i)
  {
    const double s = i / 40.0 - 0.5;
    samples.emplace_back(400.0 + length * s, 300.0 + rise + 6.0 * std::sin(6.0 * s));
  }
  return samples;
}

inline std::vector<Vector2> ringOver(double radius = 55.0, double rise = 0.0)
{
  std::vector<Vector2> samples;
  for (int i = 0; i < 90; ++i)
  {
    const double a = 2.0 * pi * i / 90.0;
    samples.emplace_back(400.0 + 1.2 * radius * std::cos(a), 300.0 + rise + radius * std::sin(a));
  }
  return samples;
}

} // namespace oversketch_test
#endif
