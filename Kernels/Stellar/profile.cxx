#include "Stellar/profile.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>
#include <locale>
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
  const auto refuse = [](std::size_t point, const std::string& why)
  {
    throw Error(Failure::BadStroke,
      "Point " + std::to_string(point) + " of the profile " + why +
        "; write \"x y, x y, ...\" with x rising from 0 to 1, for instance \"0 1, 0.5 0.8, 1 0\".");
  };
  Profile profile;
  std::istringstream points(text);
  for (std::string part; std::getline(points, part, ',');)
  {
    const std::size_t at = profile.Points.size();
    std::istringstream numbers(part);
    numbers.imbue(std::locale::classic());
    Vector2 point;
    if (!(numbers >> point.x() >> point.y()) || !(numbers >> std::ws).eof() || !point.allFinite())
    {
      refuse(at, "is not two numbers");
    }
    if (at == 0 ? point.x() != 0.0 : !(point.x() > profile.Points.back().x()))
    {
      refuse(at, at == 0 ? "is not at x = 0" : "has an x that is not above the one before");
    }
    profile.Points.push_back(point);
  }
  if (profile.Points.size() < 2 || profile.Points.back().x() != 1.0)
  {
    refuse(profile.Points.empty() ? 0 : profile.Points.size() - 1, "is the last one, and not at x = 1");
  }
  return profile;
}

double Profile::operator()(double x) const
{
  if (!(x < 1.0))
  {
    return 0.0;
  }
  if (this->Points.empty())
  {
    return std::pow(1.0 - x, this->Sharpness);
  }
  const auto next = std::upper_bound(this->Points.begin() + 1,
    this->Points.end() - 1,
    x,
    [](double value, const Vector2& point) { return value < point.x(); });
  const Vector2 &a = *(next - 1), &b = *next;
  return a.y() + (b.y() - a.y()) * ((x - a.x()) / (b.x() - a.x()));
}

} // namespace oversketch
