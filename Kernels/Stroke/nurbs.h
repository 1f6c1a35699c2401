// Splines over the samples of a stroke.
#ifndef oversketch_kernels_stroke_nurbs_h
#define oversketch_kernels_stroke_nurbs_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace oversketch
{

// A place on a spline: a mean of control points.
struct SplinePlace
{
  int count = 0;
  std::array<int, 4> points{};
  std::array<double, 4> weights{};

  template <typename Value>
  Value of(const std::vector<Value>& values) const
  {
    Value sum = this->weights[0] * values[this->points[0]];
    for (int i = 1; i < this->count; ++i)
    {
      sum += this->weights[i] * values[this->points[i]];
    }
    return sum;
  }
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 3.2 and 4.1: C(t) = sum
// of b_i(t) g_i, t in [0, 1], the stroke's samples being the control points g_i, so that the curve lies
// within their hull. Degree and knots are not told: here degree 3, less for fewer than 4 points, equal knots
// and weights 1; an open curve begins and ends at its first and last point.
//
// Departure: a closed curve (its first point not repeated) is periodic, with t = i / count nearest to point
// i; to repeat the first point of an open one, as published, leaves a corner.
class Nurbs
{
public:
  // Throws Error(Failure::BadStroke) for fewer than 2 points, of a closed curve 3.
  explicit Nurbs(int count, bool closed = false);

  int degree() const { return this->Degree; }
  // t is clamped to [0, 1].
  SplinePlace at(double t) const;
  // The parameters at which point i counts most: equally spaced of a closed curve, Greville's of an open one.
  double parameterOf(int i) const;

  // Control points of the curve that has values, one row of each point, at these parameters ("fitted", as
  // Sec. 4.1 has it).
  Eigen::MatrixXd interpolating(const Eigen::MatrixXd& values) const;

private:
  int Count, Degree;
  bool Closed;
};

} // namespace oversketch
#endif
