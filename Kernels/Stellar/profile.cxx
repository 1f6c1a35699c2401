#include "Stellar/profile.h"

#include "Mesh/context.h"

#include <cmath>
#include <sstream>

namespace oversketch
{

Profile::Profile(double sharpness)
  : Sharpness(sharpness)
{
  if (!(sharpness >= 0.0) || !std::isfinite(sharpness))
  {
    std::ostringstream message;
    message << "The sharpness is " << sharpness << "; it must be a number that is not negative.";
    throw Error(Failure::BadStroke, message.str());
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
