#include "Stroke/chaikin.h"

namespace oversketch
{

std::vector<Blend> chaikinPass(int count, bool closed)
{
  std::vector<Blend> places;
  const int segments = closed ? count : count - 1;
  if (count < 2)
  {
    places.assign(static_cast<std::size_t>(count), Blend::point(0));
    return places;
  }
  for (int i = 0; i < segments; ++i)
  {
    const int next = (i + 1) % count;
    places.push_back({ i, next, 0.25 });
    places.push_back({ i, next, 0.75 });
  }
  if (!closed)
  {
    places.front() = Blend::point(0);
    places.back() = Blend::point(count - 1);
  }
  return places;
}

bool comesBack(const Polyline& samples, double gap)
{
  if (samples.size() < 3)
  {
    return false;
  }
  const double between = (samples.back() - samples.front()).norm();
  return between < gap && between < 0.5 * arcLengths(samples).back();
}

} // namespace oversketch
