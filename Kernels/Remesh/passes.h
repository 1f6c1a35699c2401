// The passes of incremental remeshing: one kind of move over all edges of a patch, and folds taken out.
#ifndef oversketch_kernels_remesh_passes_h
#define oversketch_kernels_remesh_passes_h

#include "Mesh/context.h"
#include "Remesh/patch.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace oversketch
{

struct Steps // the passes of one remeshing, for progress and cancelling
{
  static constexpr int movesBetweenChecks = 4096; // two looks at whether to stop

  const Context& context;
  double done = 0.0, each = 0.0;
  int moves = 0;
  int mostTriangles = std::numeric_limits<int>::max(); // of the patch, gone ones too: then nothing is split

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

// Flips by angle until no edge is left that this helps, and only where an angle opposite the edge is over 90
// degrees: in the plane no other flip makes the smallest angle larger. queue: the half-edges to begin with.
// An edge is flipped only where allowed(h); then flipped(h) is called for the one that it became.
template <typename Allowed, typename Flipped>
int flipByAngle(Patch& patch, std::vector<int>& queue, const Allowed& allowed, const Flipped& flipped)
{
  const auto isWide = [&patch](int h, const Vector3& a, const Vector3& b)
  {
    const Vector3& apex = patch.point(patch.origin(previousHalfEdge(h)));
    return (a - apex).dot(b - apex) < 0.0;
  };
  int made = 0;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const int h = queue[i], g = patch.inner(h) && patch.aliveTriangle(h / 3) ? patch.twin(h) : -1;
    if (g < 0)
    {
      continue;
    }
    const Vector3 &a = patch.point(patch.origin(h)), &b = patch.point(patch.target(h));
    if ((isWide(h, a, b) || isWide(g, a, b)) && allowed(h) && patch.flippable(h, true))
    {
      patch.flip(h);
      int now = -1;
      for (const int t : { h / 3, g / 3 })
      {
        for (int rim = 3 * t; rim < 3 * t + 3; ++rim)
        {
          const int other = patch.twin(rim) / 3;
          if (patch.inner(rim) && (other == h / 3 || other == g / 3))
          {
            now = rim;
          }
          else
          {
            queue.push_back(rim);
          }
        }
      }
      flipped(now);
      ++made;
    }
  }
  return made;
}
// Begins with all edges.
int flipByAngle(Patch& patch, Steps& steps);

// Moves vertices at folded edges (normals over 100 degrees apart) towards the mean of their neighbours where
// less is folded round them then and no triangle becomes a needle; one after the other, in rounds, until none
// helps. A vertex on the border of the patch or of a chart stays; places on the surface stay, too. Where
// nothing is folded nothing moves.
void unfold(Patch& patch, const Context& context);

} // namespace oversketch
#endif
