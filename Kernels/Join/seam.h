// The crease between joined bodies rounded into a seam.
#ifndef oversketch_kernels_join_seam_h
#define oversketch_kernels_join_seam_h

#include "Join/unite.h"
#include "Mesh/place.h"

#include <array>
#include <vector>

namespace oversketch
{

// A body whose triangles' corners lie on whatever triangles they do, of one chart.
struct Joined
{
  Mesh mesh;
  // For each triangle: the input's one under its middle, and where its corners on the input stand, -1 of a
  // whole one.
  std::vector<int> source, cut;
  std::vector<std::array<SurfacePoint, 3>> corners;
  // Bend of the seam's sharpest edge [degrees], but for those at edges of the parts that bend by
  // over 11.
  double sharpest = 0.0;
  int rounds = 0; // in which it was made finer

  std::array<SurfacePoint, 3> cornersOf(int triangle) const
  {
    return this->cut[triangle] < 0 ? wholeTriangle(this->source[triangle])
                                   : this->corners[this->cut[triangle]];
  }
};

// The input, of which the body was made.
struct JoinInput
{
  const Mesh& mesh;
  const std::vector<int>& parts;  // per triangle, from 0
  const std::vector<int>& charts; // per triangle, those of different parts are different
};

constexpr int bridgePart = -1; // of a bar between two parts, which the seam may take wholly

// Rounds the edges between triangles of different parts: points nearer to them than half the width [model
// length] come to lie where the surface bends as little as it can and goes on as beyond (thin plate, M.
// Botsch, L. Kobbelt, "An intuitive framework for real-time freeform modeling", 2004, Sec. 3). Triangles
// there are as large as those of the parts, at most an eighth of the width; smaller, to a half in each of up
// to two rounds, while more than one such edge in 500 bends by over 11 degrees. Beyond, points keep their
// bits, triangles that reach into the seam are divided.
//
// Throws Error(BadRegion) where the seam would reach all over what is left of a part, with the widest one
// that would do; Error(SolveFailed), Error(Cancelled).
Joined roundSeam(const JoinInput& input, const United& united, double width, const Context& context);

// Joins without a seam.
Joined asJoined(United united);

} // namespace oversketch
#endif
