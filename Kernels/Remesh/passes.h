// The passes of incremental remeshing: one kind of move over all edges of a patch.
#ifndef oversketch_passes_h
#define oversketch_passes_h

#include "Mesh/context.h"
#include "Remesh/patch.h"

#include <algorithm>

namespace oversketch
{

struct Steps // the passes of one remeshing, for progress and cancelling
{
  static constexpr int movesBetweenChecks = 4096; // two looks at whether to stop

  const Context& context;
  double done = 0.0, each = 0.0;
  int moves = 0;

  void tick()
  {
    if (++this->moves % movesBetweenChecks == 0)
    {
      this->context.checkpoint(std::min(1.0, this->done));
    }
  }
  void next()
  {
    this->done += this->each;
    this->context.checkpoint(std::min(1.0, this->done));
  }
};

// Lengths are in target lengths, see Patch::relativeSquared. Each returns how many moves it has made.
// Splits the edges over `longest`, the longest first, and those that come of it.
int splitAll(Patch& patch, double longest, Steps& steps);
// Collapses the edges under `shortest`, the shortest first, where none over `longest` comes of it.
int collapseAll(Patch& patch, double shortest, double longest, Steps& steps);
int flipAll(Patch& patch, bool byAngle, Steps& steps);

} // namespace oversketch
#endif
