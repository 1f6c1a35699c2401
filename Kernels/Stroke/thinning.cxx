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

} // namespace oversketch
