#include "Stroke/thinning.h"

namespace oversketch
{

std::vector<int> thinStroke(const Polyline& samples, double spacing, bool closed)
{
  std::vector<int> kept;
  const int count = static_cast<int>(samples.size());
  for (int i = 0; i < count; ++i)
  {
    if (kept.empty() || (samples[i] - samples[kept.back()]).norm() >= spacing)
    {
      kept.push_back(i);
    }
  }
  if (!closed && !kept.empty() && kept.back() != count - 1)
  {
    kept.push_back(count - 1);
  }
  return kept;
}

std::vector<int> thinEvenly(const Polyline& samples, double spacing, bool closed)
{
  std::vector<int> kept = thinStroke(samples, spacing, true);
  const int last = static_cast<int>(samples.size()) - 1;
  while (closed && kept.size() > 1 && (samples[kept.back()] - samples.front()).norm() < spacing)
  {
    kept.pop_back();
  }
  if (!closed && !kept.empty() && kept.back() != last)
  {
    if (kept.size() > 1)
    {
      kept.pop_back();
    }
    kept.push_back(last);
  }
  return kept;
}

} // namespace oversketch
