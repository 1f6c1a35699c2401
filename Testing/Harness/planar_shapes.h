// Drawings on the unit canvas that the planar kernels' tests share. Header-only.
#ifndef oversketch_testing_harness_planar_shapes_h
#define oversketch_testing_harness_planar_shapes_h

#include "Planar/approximate.h"
#include "Planar/stroke_line.h"
#include "Stroke/resample.h"

#include "Harness/drawing_shapes.h"
#include "Harness/shapes.h"

#include <functional>
#include <random>

namespace oversketch_test
{

constexpr double sampleGap = 0.005; // h on the unit canvas

inline oversketch::DrawnStroke evenStroke(const oversketch::Polyline& points, bool closed)
{
  oversketch::DrawnStroke stroke;
  stroke.closed = closed;
  for (const oversketch::Blend& place : oversketch::resampled(points, sampleGap, closed))
  {
    stroke.points.push_back(place.of(points));
  }
  return stroke;
}

// A closed curve in polar coordinates round (x, y), its samples about h apart.
inline oversketch::DrawnStroke polarStroke(double x,
  double y,
  const std::function<double(double)>& radius,
  double start = 0.0)
{
  oversketch::Polyline points;
  for (int i = 0; i < 4000; ++i)
  {
    const double angle = start + turn * i / 4000;
    points.emplace_back(x + radius(angle) * std::cos(angle), y + radius(angle) * std::sin(angle));
  }
  return evenStroke(points, true);
}

inline oversketch::DrawnStroke circleStroke(double x, double y, double radius, double start = 0.0)
{
  oversketch::Polyline points;
  const int count = static_cast<int>(std::ceil(turn * radius / sampleGap));
  for (int i = 0; i < count; ++i)
  {
    const double angle = start + turn * i / count;
    points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  return { points, true };
}

// A regular polygon whose corners are samples.
inline oversketch::DrawnStroke polygonStroke(double x, double y, double radius, int sides, double start = 0.3)
{
  oversketch::Polyline points;
  for (int i = 0; i < sides; ++i)
  {
    points.emplace_back(
      x + radius * std::cos(start + turn * i / sides), y + radius * std::sin(start + turn * i / sides));
  }
  return evenStroke(points, true);
}

// From (low, low) to (high, high); sample 0 is a corner.
inline oversketch::DrawnStroke squareStroke(double low, double high)
{
  return evenStroke({ { low, low }, { high, low }, { high, high }, { low, high } }, true);
}

// Strokes with all that the planar steps read of them. Throws where a stroke is rejected.
struct UnitDrawing
{
  std::vector<oversketch::DrawnStroke> strokes;
  std::vector<oversketch::Treatment> treatments;
  oversketch::Classification classes;
  oversketch::DistanceMaps maps;

  explicit UnitDrawing(std::vector<oversketch::DrawnStroke> drawn,
    std::vector<oversketch::Treatment> treated = {})
    : strokes(std::move(drawn))
    , treatments(std::move(treated))
  {
    using namespace oversketch;
    this->treatments.resize(this->strokes.size(), Treatment::Fill);
    const Frame frame = frameOf(Canvas());
    this->classes = classify(frame, this->strokes, 0.05, Context());
    for (std::size_t i = 0; i < this->strokes.size(); ++i)
    {
      const Message text = rejectionText(this->classes, static_cast<int>(i), this->strokes);
      if (!text.empty())
      {
        throw Error(Failure::BadStroke, text);
      }
    }
    this->maps = distanceMaps(
      frame, rimsOf(this->classes, this->strokes, this->treatments), ThicknessMode::Local, Context());
  }
  std::vector<oversketch::StrokePolyline> polylines(const oversketch::ApproximationRules& rules = {},
    const std::vector<oversketch::StrokeSplit>& splits = {}) const
  {
    return oversketch::approximate(this->strokes,
      this->classes.strokes,
      this->treatments,
      this->maps,
      splits,
      1.0,
      rules,
      oversketch::Context());
  }
  std::vector<oversketch::StrokeLine> lines(const oversketch::ApproximationRules& rules = {}) const
  {
    return oversketch::strokeLines(
      this->polylines(rules), this->strokes, this->classes.strokes, this->treatments);
  }
};

} // namespace oversketch_test
#endif
