#include "Planar/splits.h"

#include <algorithm>

namespace oversketch
{

void addSplits(std::vector<StrokeSplit>& splits, const std::vector<StrokeSplit>& more)
{
  const std::vector<StrokeSplit> before = splits;
  for (StrokeSplit split : more)
  {
    for (const StrokeSplit& old : before)
    {
      if (old.stroke == split.stroke && old.start < split.end && split.start < old.end)
      {
        split.halvings = std::max(split.halvings, old.halvings + 1);
      }
    }
    splits.push_back(split);
  }
}

} // namespace oversketch
