// A region follows a profile that was drawn anew.
#ifndef oversketch_kernels_section_follow_h
#define oversketch_kernels_section_follow_h

#include "Matrix/frames.h"
#include "Section/profile.h"

#include <vector>

namespace oversketch
{

struct Context;

// Vertices that may move, and where each is in its region.
struct RegionPlaces
{
  std::vector<int> vertices;
  std::vector<double> distance;  // share of the way from the reference curve to the boundary
  std::vector<double> parameter; // share of the reference curve's length
  std::vector<double> side;      // 1 on the side of the frames' `side`, -1 on the other
};

// How much of each vertex's displacement is that of the side of 1; the rest is the other side's. On either
// side 1 and 0; round an end of the curve, for vertices to which that is the nearest place of it, (1 + cos a)
// / 2, a being the angle to the frame's side in the tangent plane there.
std::vector<double> sideShares(const std::vector<Vector3>& points,
  const RegionPlaces& region,
  const std::vector<Vector3>& curve,
  const CurveFrames& frames,
  const Context& context);

// Part that moves with the plane: all of the curve, or with handles what lies between the plane and its
// neighbours among them, evenly less towards those.
class PlaneReach
{
public:
  // plane, handles: shares of the curve's length; handles in any order.
  PlaneReach(double plane, const std::vector<double>& handles);
  double at(double t) const;
  double plane() const { return this->Plane; }

private:
  double Plane, Before, After; // neighbours, or an infinity where there is none
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 6.3, which leaves it to
// chapter 8, where nothing is said of it; "the percentage of the deformation [...] is determined by the
// grayscale texture" would never let the mesh match the profile off the curve. Here a vertex moves by
// reach.at(parameter) times the displacement of its own share of the way, which is carried from the profile's
// frame to the curve's at the vertex; of a translation that is the chapter's exponential. `weights`: a
// further factor of each vertex, or empty. What the plane cuts takes the plane's own frame, though the place
// of the curve that it lies beside is another one where the surface turns or narrows along it: else the
// section of what comes of it is not the one that was drawn. Over a quarter of the curve's length off the
// plane that goes over to the frame of the place beside.
//
// flat: the profile's frame, see FlatProfile::toWorld; plane: the frame that it was cut in. One displacement
// of each vertex of the region, exactly zero where the profiles are one. Throws Error(Failure::Cancelled).
std::vector<Vector3> profileMoves(const std::vector<Vector3>& points,
  const RegionPlaces& region,
  const std::vector<double>& shares,
  const ProfileChange& change,
  const Matrix4& flat,
  const CurveFrame& plane,
  const CurveFrames& frames,
  const PlaneReach& reach,
  const std::vector<double>& weights,
  const Context& context);

} // namespace oversketch
#endif
