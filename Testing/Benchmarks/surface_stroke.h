// A wave over the bunny's side, of the length and radius that system D's own measurements have: the same
// picture for every size of the model. Header-only.
#ifndef oversketch_testing_benchmarks_surface_stroke_h
#define oversketch_testing_benchmarks_surface_stroke_h

#include "bunny_stroke.h"

#include "Harness/polydata.h"

#include <cmath>

namespace oversketch_bench
{

// In bunnyView(), so many pixels higher.
inline vtkSmartPointer<vtkPolyData> surfaceStroke(double pixels = 0.0)
{
  std::vector<Vector2> samples;
  for (int i = 0; i <= 120; ++i)
  {
    const double s = i / 120.0;
    samples.emplace_back(320.0 + 170.0 * s, 250.0 + pixels + 25.0 * std::sin(15.0 * s));
  }
  return oversketch_test::toStroke(samples, bunnyView());
}

} // namespace oversketch_bench
#endif
