// Vertices of a 4-8 mesh that no step moves.
#ifndef oversketch_kernels_stellar_staying_h
#define oversketch_kernels_stellar_staying_h

#include "Stellar/forest.h"

#include <vector>

namespace oversketch
{

// Vertices that stay: some that a canonical forest had, and those that are born between two of them since.
struct Staying
{
  std::vector<char> first = {}; // per vertex that it had; empty: none stays

  bool at(const Forest& forest, int v) const
  {
    if (this->first.empty() || v < static_cast<int>(this->first.size()))
    {
      return !this->first.empty() && this->first[v] != 0;
    }
    const int* ends = forest.vertices[v].parents;
    return ends[0] >= 0 && this->at(forest, ends[0]) && this->at(forest, ends[1]);
  }
};

} // namespace oversketch
#endif
