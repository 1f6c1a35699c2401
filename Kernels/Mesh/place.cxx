#include "Mesh/place.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

Mix normalisedMix(Mix mix)
{
  std::sort(mix.begin(), mix.end());
  Mix merged;
  merged.reserve(mix.size());
  for (const auto& entry : mix)
  {
    if (!merged.empty() && merged.back().first == entry.first)
    {
      merged.back().second += entry.second;
    }
    else
    {
      merged.push_back(entry);
    }
  }
  merged.erase(
    std::remove_if(
      merged.begin(), merged.end(), [](const auto& entry) { return std::abs(entry.second) < 1e-12; }),
    merged.end());
  return merged;
}

bool sameMix(const Mix& a, const Mix& b)
{
  return a.size() == b.size() && std::equal(a.begin(),
                                   a.end(),
                                   b.begin(),
                                   [](const auto& x, const auto& y)
                                   { return x.first == y.first && std::abs(x.second - y.second) < 1e-9; });
}

} // namespace oversketch
