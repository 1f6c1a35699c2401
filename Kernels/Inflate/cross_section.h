// How high the surface stands over a place of its object: the cross-section that the user chooses.
#ifndef oversketch_kernels_inflate_cross_section_h
#define oversketch_kernels_inflate_cross_section_h

#include "Mesh/graph.h"

#include <optional>
#include <string>

namespace oversketch
{

// Source: image-assisted modelling, section 12: a share f(u) of the thickness, by u = distance to the rim /
// thickness there, both in [0, 1]. f(0) = 0 always, so that the surface is sealed; f > 0 beyond, so that its
// two sides never meet. The paper names the circle; its further examples are in a figure that is not in its
// text.
class CrossSection
{
public:
  // "circle" or an empty text: f = sqrt(u (2 - u)); "linear": u; "step": a plateau from u = 0.5 on, a quarter
  // of an ellipse before it; or a curve on the unit square, "0 0, x y, ..., 1 y", see Graph. Throws
  // Error(Failure::BadStroke) that names the point.
  static CrossSection parse(const std::string& text);

  double operator()(double u) const;

  bool isCircle() const { return this->Kind == Shape::Circle; }
  // It begins upright, so that points evenly apart in the plane are far apart on the surface beside the rim.
  bool isUpright() const { return this->Kind == Shape::Circle || this->Kind == Shape::Step; }

  // ProfileSmoothing where none is asked for: 0.3 for the circle; others have creases that are meant.
  double smoothing() const { return this->isCircle() ? 0.3 : 0.0; }

private:
  enum class Shape
  {
    Circle,
    Linear,
    Step,
    Curve
  };
  Shape Kind = Shape::Circle;
  std::optional<Graph> Curve;
};

} // namespace oversketch
#endif
