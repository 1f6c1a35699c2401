#include "step_order.h"

#include <algorithm>

namespace oversketch_session
{

std::vector<Node> moved(std::vector<Node> nodes, std::size_t from, std::size_t to)
{
  const auto at = [&](std::size_t i) { return nodes.begin() + static_cast<std::ptrdiff_t>(i); };
  from < to ? std::rotate(at(from), at(from + 1), at(to + 1)) : std::rotate(at(to), at(from), at(from + 1));
  return nodes;
}

OrderFault faultOfMove(const Model& model, std::size_t from, std::size_t to)
{
  const std::vector<Node>& before = model.nodes;
  const std::vector<Node> after = moved(before, from, to);
  if (!model.mesh && !before.empty() && after.front().id != before.front().id)
  {
    return { rowOf(before, after.front().id), 0 };
  }
  for (std::size_t i = 0; i < after.size(); ++i)
  {
    for (const auto& named : after[i].step->inputs)
    {
      const auto* output = std::get_if<StepOutput>(&named.second);
      const int needed = output ? rowOf(after, output->step) : -1;
      const int was = output ? rowOf(before, output->step) : -1;
      const int step = rowOf(before, after[i].id);
      // A fault that was there before, in a model that was read so, is not this move's.
      if (needed >= static_cast<int>(i) && was < step)
      {
        return { step, was };
      }
    }
  }
  return {};
}

} // namespace oversketch_session
