// The places that a search for cheapest ways has still to leave. Private to this folder.
#ifndef oversketch_place_queue_h
#define oversketch_place_queue_h

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace oversketch
{

// Gives out places by what they cost, cheapest first, of equally cheap ones the lower number. Buckets of
// equal ranges of costs (Dial's), of which the one in turn alone is kept in order, a heap of a few: so costs
// need not be rounded. Emptied and filled again it takes no new memory.
class PlaceQueue
{
public:
  struct Place
  {
    double cost;
    int number;
    bool operator>(const Place& other) const
    {
      return this->cost != other.cost ? this->cost > other.cost : this->number > other.number;
    }
  };

  // The queue begins with these. No place that is pushed will cost more than `step` above the last one given
  // out, or less than it.
  void begin(const std::vector<Place>& places, double step)
  {
    this->Waiting = places;
    std::sort(this->Waiting.begin(), this->Waiting.end(), std::greater<>());
    this->Scale = (Count - 6) / std::max(step, 1e-300);
    this->Base = this->Waiting.empty() ? 0.0 : this->Waiting.back().cost;
    this->Now = -1;
    this->Current.clear();
    this->Links.clear();
    this->Free = -1;
    this->First.fill(-1);
    this->lookAhead();
  }

  void push(const Place& place)
  {
    const std::int64_t bucket = this->bucketOf(place.cost);
    if (bucket == this->Now)
    {
      this->Current.push_back(place);
      std::push_heap(this->Current.begin(), this->Current.end(), std::greater<>());
      return;
    }
    int link = this->Free;
    if (link < 0)
    {
      link = static_cast<int>(this->Links.size());
      this->Links.emplace_back();
    }
    else
    {
      this->Free = this->Links[link].next;
    }
    const int slot = static_cast<int>(bucket % Count);
    this->Links[link] = { place, this->First[slot] };
    this->First[slot] = link;
  }

  // False when none is left.
  bool pop(Place& place)
  {
    if (!this->Current.empty())
    {
      place = this->Current.front();
      if (this->Current.size() > 1)
      {
        std::pop_heap(this->Current.begin(), this->Current.end(), std::greater<>());
      }
      this->Current.pop_back();
      return true;
    }
    return this->advance(place);
  }

private:
  static constexpr int Count = 256;
  static constexpr std::int64_t Never = std::numeric_limits<std::int64_t>::max() / 4;

  struct Link
  {
    Place place;
    int next;
  };

  std::int64_t bucketOf(double cost) const
  {
    return static_cast<std::int64_t>((cost - this->Base) * this->Scale);
  }

  void free(int link)
  {
    this->Links[link].next = this->Free;
    this->Free = link;
  }

  // Makes the next bucket with places the one in turn, and gives out its first.
  bool advance(Place& place)
  {
    int further = 1;
    while (further < Count && this->First[(this->Now + further) % Count] < 0)
    {
      ++further;
    }
    const std::int64_t pushed = this->Now + (further < Count ? further : Never);
    this->Now = std::min(pushed, this->Next);
    if (this->Now >= Never)
    {
      return false;
    }
    const int slot = static_cast<int>(this->Now % Count);
    int link = this->First[slot];
    this->First[slot] = -1;
    if (this->Now != this->Next && this->Links[link].next < 0) // one alone, as most are
    {
      place = this->Links[link].place;
      this->free(link);
      return true;
    }
    while (link >= 0)
    {
      this->Current.push_back(this->Links[link].place);
      const int next = this->Links[link].next;
      this->free(link);
      link = next;
    }
    while (this->Now == this->Next)
    {
      this->Current.push_back(this->Waiting.back());
      this->Waiting.pop_back();
      this->lookAhead();
    }
    std::make_heap(this->Current.begin(), this->Current.end(), std::greater<>());
    return this->pop(place);
  }

  void lookAhead() { this->Next = this->Waiting.empty() ? Never : this->bucketOf(this->Waiting.back().cost); }

  std::vector<Place> Waiting;     // what it began with, the last one first
  std::vector<Place> Current;     // a heap: the bucket in turn
  std::vector<Link> Links;        // of the other buckets' lists
  std::array<int, Count> First{}; // of each bucket's list; -1: empty
  double Base = 0.0, Scale = 1.0;
  std::int64_t Now = -1;     // the bucket in turn, counted from that of the first cost
  std::int64_t Next = Never; // that of the first one that waits
  int Free = -1;             // links that can be used again
};

} // namespace oversketch
#endif
