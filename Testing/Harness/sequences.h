// Random sequences of events: which a test runs, and the memory that they leave in use. Header-only.
#ifndef oversketch_testing_harness_sequences_h
#define oversketch_testing_harness_sequences_h

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include <malloc.h>
#if defined(__SANITIZE_ADDRESS__)
// GCC ships no header of it.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes(); // NOLINT
#endif

namespace oversketch_test
{

// Each sequence is made of its number alone.
struct Sequences
{
  unsigned first, count;
  unsigned end() const { return this->first + this->count; }
  // Whether their sums tell anything.
  bool areMany() const { return this->count >= 10; }
};

// The first of so many things that a usual run makes, of all that a full run makes: OVERSKETCH_SEED, a number
// of the day, moves on through them; 0 without it.
inline unsigned firstOfTheDay(unsigned usual, unsigned all)
{
  const char* seed = std::getenv("OVERSKETCH_SEED");
  return seed ? static_cast<unsigned>(std::strtoul(seed, nullptr, 10)) % (all / usual) * usual : 0;
}

// Whether one of many is the day's, one in so many of them; each is in a full run, OVERSKETCH_FULL, and
// without a seed.
inline bool isOfTheDay(std::size_t which, std::size_t oneIn)
{
  const char* seed = std::getenv("OVERSKETCH_SEED");
  return !seed || std::getenv("OVERSKETCH_FULL") || (which + std::strtoul(seed, nullptr, 10)) % oneIn == 0;
}

// OVERSKETCH_SEQUENCES asks for another number of them than that of the usual run, OVERSKETCH_FIRST_SEQUENCE
// for others than the first, so that many can be shared out and one be seen again.
inline Sequences sequencesAsked(unsigned usual)
{
  const auto asked = [](const char* name, unsigned otherwise)
  {
    const char* value = std::getenv(name);
    return value ? static_cast<unsigned>(std::strtoul(value, nullptr, 10)) : otherwise;
  };
  return { asked("OVERSKETCH_FIRST_SEQUENCE", firstOfTheDay(usual, 1000)),
    asked("OVERSKETCH_SEQUENCES", usual) };
}

// MiB that the process holds, without what the allocator keeps for later.
inline double residentMemory()
{
  malloc_trim(0);
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind("VmRSS:", 0) == 0)
    {
      return std::stod(line.substr(6)) / 1024.0;
    }
  }
  return 0.0;
}

// MiB that were asked for and not given back, large blocks as well: which of them lie outside of the heap
// changes as the program goes, so that the heap alone would seem to grow.
inline double memoryInUse()
{
#if defined(__SANITIZE_ADDRESS__)
  return static_cast<double>(__sanitizer_get_current_allocated_bytes()) / 1048576.0;
#else
  const auto now = mallinfo2();
  return static_cast<double>(now.uordblks + now.hblkhd) / 1048576.0;
#endif
}

// Memory in use as each sequence begins, when nothing of those before it should be left: the mean over the
// first half, of which a fifth is left out while things are made once, and over the second half.
class MemoryLevel
{
public:
  explicit MemoryLevel(const Sequences& sequences)
    : Numbers(sequences)
  {
  }
  void before(unsigned sequence)
  {
    const unsigned done = sequence - this->Numbers.first, half = this->Numbers.count / 2;
    const unsigned fifth = half / 5;
    if (done >= half)
    {
      this->Late += memoryInUse() / (this->Numbers.count - half);
    }
    else if (done >= fifth)
    {
      this->Early += memoryInUse() / (half - fifth);
    }
    if (done == fifth)
    {
      this->ResidentEarly = residentMemory();
    }
  }
  // MiB from the first half to the second beyond what is known to stay of each sequence; 0 of few sequences.
  double growth(double known = 0.0) const
  {
    const unsigned half = this->Numbers.count / 2;
    const unsigned fifth = half / 5;
    const double apart = 0.5 * (this->Numbers.count - fifth); // the middles of both
    return this->Numbers.count < 20 ? 0.0 : this->Late - this->Early - known * apart;
  }
  // MiB that may be in use more: what is made once, at a rare event, weighs on few sequences (1.2 were seen
  // of a hundred).
  double allowed() const { return this->Numbers.count < 500 ? 2.0 : 1.0; }
  void print() const
  {
    std::cout << "sequences " << this->Numbers.first << " to " << this->Numbers.end() - 1
              << " of 200 events; memory in use " << this->Early << " MiB, later " << this->Late
              << " MiB; resident " << this->ResidentEarly << " MiB, later " << residentMemory() << " MiB"
              << std::endl;
  }

private:
  Sequences Numbers;
  double Early = 0.0, Late = 0.0, ResidentEarly = 0.0;
};

} // namespace oversketch_test
#endif
