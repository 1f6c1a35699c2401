// Memory of an evaluator: numbers of outcomes, and the outcomes up to its budget.
#include "evaluator.h"

#include <algorithm>
#include <tuple>

namespace oversketch_session
{

bool Evaluator::Place::operator<(const Place& other) const
{
  if (this->made.owner_before(other.made) || other.made.owner_before(this->made))
  {
    return this->made.owner_before(other.made);
  }
  return std::tie(this->inputs, this->backend) < std::tie(other.inputs, other.backend);
}

std::size_t Evaluator::bytesOf(const Outcome& outcome)
{
  if (!outcome.failure.empty())
  {
    return 0; // a mesh passed by is another outcome's
  }
  std::size_t kilobytes = outcome.mesh->GetActualMemorySize();
  for (const auto& port : outcome.outputs)
  {
    kilobytes += port.second->GetActualMemorySize();
  }
  std::size_t bytes = 0;
  if (outcome.details)
  {
    kilobytes += outcome.details->region->GetActualMemorySize();
    const auto& following = outcome.details->following;
    bytes = following ? following->points.size() * (sizeof(vtkIdType) + sizeof(following->moves[0])) : 0;
  }
  return 1024 * kilobytes + bytes;
}

std::uint64_t Evaluator::numberOf(const Place& place)
{
  const auto [at, isNew] = this->Numbers.insert({ place, this->Last + 1 });
  if (isNew)
  {
    this->Outcomes[++this->Last].place = place;
  }
  this->Outcomes.at(at->second).used = this->RunCount;
  return at->second;
}

void Evaluator::forget()
{
  for (auto it = this->Outcomes.begin(); it != this->Outcomes.end();)
  {
    const Place& place = it->second.place;
    const bool canComeAgain =
      !place.made.expired() && std::all_of(place.inputs.begin(),
                                 place.inputs.end(),
                                 [this](std::uint64_t number) { return this->Outcomes.count(number) > 0; });
    if (!canComeAgain)
    {
      this->Numbers.erase(place);
    }
    it = canComeAgain ? std::next(it) : this->Outcomes.erase(it);
  }
  for (auto it = this->Pictures.begin(); it != this->Pictures.end();)
  {
    it = it->first.expired() ? this->Pictures.erase(it) : std::next(it);
  }
}

void Evaluator::giveUp()
{
  std::size_t sum = 0;
  std::vector<Kept*> others; // than those in use
  for (auto& named : this->Outcomes)
  {
    sum += named.second.bytes;
    if (named.second.outcome && named.second.used != this->RunCount)
    {
      others.push_back(&named.second);
    }
  }
  std::sort(others.begin(), others.end(), [](const Kept* a, const Kept* b) { return a->used < b->used; });
  for (auto it = others.begin(); it != others.end() && sum > this->Budget; ++it)
  {
    sum -= (*it)->bytes;
    (*it)->outcome.reset();
    (*it)->bytes = 0;
  }
}

} // namespace oversketch_session
