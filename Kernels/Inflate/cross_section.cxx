#include "Inflate/cross_section.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double plateau = 0.5;

double circle(double u)
{
  return std::sqrt(u * (2.0 - u));
}

} // namespace

CrossSection CrossSection::parse(const std::string& text)
{
  CrossSection section;
  if (text.empty() || text == "circle")
  {
    return section;
  }
  if (text == "linear" || text == "step")
  {
    section.Kind = text == "linear" ? Shape::Linear : Shape::Step;
    return section;
  }
  section.Kind = Shape::Curve;
  section.Curve = Graph::parse(text, "0 0, 0.3 0.8, 1 1");
  const std::vector<Vector2>& points = section.Curve->points();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double y = points[i].y();
    if (i == 0 ? y != 0.0 : !(y > 0.0 && y <= 1.0))
    {
      throw Error(Failure::BadStroke,
        "Point %1 of the profile %2.",
        i,
        (i == 0 ? "is not \"0 0\": the surface would be open at its rim"
                : "has a y that is not above 0 and at most 1; its height is a parameter of its own"));
    }
  }
  return section;
}

double CrossSection::operator()(double u) const
{
  u = std::clamp(u, 0.0, 1.0);
  switch (this->Kind)
  {
    case Shape::Circle:
      return circle(u);
    case Shape::Linear:
      return u;
    case Shape::Step:
      return circle(std::min(1.0, u / plateau));
    case Shape::Curve:
      break;
  }
  return (*this->Curve)(u);
}

} // namespace oversketch
