#include "Stellar/profile.h"

#include "Mesh/context.h"

#include <cmath>

namespace oversketch
{

Profile::Profile(double sharpness)
  : Sharpness(sharpness)
{
  if (!(sharpness >= 0.0) || !std::isfinite(sharpness))
  {
    throw Error(
      Failure::BadStroke, "The sharpness is %1; it must be a number that is not negative.", sharpness);
  }
}

Profile Profile::polyline(const std::string& text)
{
  Profile profile;
  profile.Line = Graph::parse(text, "0 1, 0.5 0.8, 1 0");
  return profile;
}

double Profile::operator()(double x) const
{
  if (!(x < 1.0))
  {
    return 0.0;
  }
  return this->Line ? (*this->Line)(x) : std::pow(1.0 - x, this->Sharpness);
}

} // namespace oversketch
