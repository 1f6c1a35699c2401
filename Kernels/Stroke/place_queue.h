// The places that a search for cheapest ways has still to leave. Private to this folder.
#ifndef oversketch_kernels_stroke_place_queue_h
#define oversketch_kernels_stroke_place_queue_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace oversketch
{

// Gives out places by what they cost, cheapest first, of equally cheap ones the lower number. Buckets of
// equal ranges of costs (Dial's), of which the one in turn alone is kept in order, a heap of a few: so costs
// need not be rounded. A bit for each bucket says whether it holds any. Emptied and filled again it takes no
// new memory.
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
    this->Filled.fill(0);
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
    const std::size_t slot = static_cast<std::size_t>(bucket) % Count, word = slot / 64;
    const std::uint64_t bit = std::uint64_t{ 1 } << slot % 64;
    this->Links[link] = { place, (this->Filled[word] & bit) != 0 ? this->First[slot] : -1 };
    this->Filled[word] |= bit;
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
  static constexpr int Count = 1024, Words = Count / 64;
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

  // The first bucket after the one in turn that was pushed to.
  std::int64_t pushedNext() const
  {
    const std::size_t begin = static_cast<std::size_t>(this->Now + 1) % Count;
    std::size_t word = begin / 64;
    std::uint64_t bits = this->Filled[word] & (~std::uint64_t{ 0 } << begin % 64);
    for (int looked = 0; bits == 0; ++looked)
    {
      if (looked == Words)
      {
        return Never;
      }
      word = (word + 1) % Words;
      bits = this->Filled[word];
    }
    const std::size_t slot = 64 * word + static_cast<std::size_t>(__builtin_ctzll(bits));
    return this->Now + 1 + static_cast<std::int64_t>((slot - begin) % Count);
  }

  // Makes the next bucket with places the one in turn, and gives out its first.
  bool advance(Place& place)
  {
    this->Now = std::min(this->pushedNext(), this->Next);
    if (this->Now >= Never)
    {
      return false;
    }
    const std::size_t slot = static_cast<std::size_t>(this->Now) % Count;
    const std::uint64_t bit = std::uint64_t{ 1 } << slot % 64;
    int link = (this->Filled[slot / 64] & bit) != 0 ? this->First[slot] : -1;
    this->Filled[slot / 64] &= ~bit;
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
  std::array<int, Count> First{}; // of the lists of the buckets that are filled
  std::array<std::uint64_t, Words> Filled{};
  double Base = 0.0, Scale = 1.0;
  std::int64_t Now = -1;     // the bucket in turn, counted from that of the first cost
  std::int64_t Next = Never; // that of the first one that waits
  int Free = -1;             // links that can be used again
};

} // namespace oversketch
#endif
