// The parts of edit_benchmark, and the sphere with a region that most of them work on.
#ifndef oversketch_testing_benchmarks_edit_jobs_h
#define oversketch_testing_benchmarks_edit_jobs_h

#include "benchmark_frame.h"

#include "Harness/shapes.h"

#include <cmath>
#include <string>
#include <vector>

namespace oversketch_bench
{

void addMoves();        // a handle's drag, a plane that slides
void addExponentials(); // of a region's vertices
void addShading();      // disc, distances, grey model, layers
void addDistances();    // beside the exact ones
void addTriangles();    // new triangles after an edit

// Of a sphere of 163,842 vertices the region above a height, of 10,000 vertices or 50,000.
inline double regionHeight(const std::string& size)
{
  return size == "10k" ? 0.878 : 0.39;
}

inline const Mesh& sphereOfRegions()
{
  static const Mesh made = oversketch_test::icosphere(7);
  return made;
}

// The sphere from above, 540 px across in a viewport of 800 x 600.
inline View viewFromAbove()
{
  return oversketch_test::orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 270.0);
}

// Strokes in that view: a line over the pole, and a ring at a height.
inline std::vector<Vector2> lineFromAbove(double height)
{
  std::vector<Vector2> samples;
  const double reach = 0.6 * 270.0 * std::sqrt(1.0 - height * height);
  for (int i = 0; i <= 60; ++i)
  {
    samples.emplace_back(400.0 + reach * (i / 30.0 - 1.0), 300.0);
  }
  return samples;
}
inline std::vector<Vector2> ringFromAbove(double height)
{
  std::vector<Vector2> samples;
  const double radius = 270.0 * std::sqrt(1.0 - height * height);
  for (int i = 0; i < 240; ++i)
  {
    const double turn = 2.0 * oversketch_test::pi * i / 240.0;
    samples.emplace_back(400.0 + radius * std::cos(turn), 300.0 + radius * std::sin(turn));
  }
  return samples;
}

} // namespace oversketch_bench
#endif
