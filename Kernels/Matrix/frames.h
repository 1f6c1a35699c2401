// Frames along a curve on a surface: where it goes, what is beside it and what is outward.
#ifndef oversketch_kernels_matrix_frames_h
#define oversketch_kernels_matrix_frames_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// Right-handed and orthonormal: side = outward x along.
struct CurveFrame
{
  Vector3 origin, along, side, outward;
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 6.1. There a plane is
// fitted to the curve's points, whose normal is carried along the curve: planesAt. Departures: the fit solves
// z = ax + by + c, which no plane parallel to z has; here the normal is the direction in which the points
// extend least. The planes' printed vectors mix components up; here they follow from the curve's tangent.
//
// A fitted plane of a straight curve on a ball lies beside the surface's normal, and an axis carried along an
// S leaves it by 40 degrees. So at() asks the surface: of 101 places at equal lengths the tangents are
// smoothed 20 times by (1/4, 1/2, 1/4), its normals 40 times and made perpendicular to the tangents.
class CurveFrames
{
public:
  // Takes each point of the curve and the surface's normal there. Throws Error(Failure::BadStroke) for a
  // curve of fewer than two distinct points or one that is not finite.
  CurveFrames(const std::vector<Vector3>& points, const std::vector<Vector3>& normals);

  // t: share of the curve's length, clamped to [0, 1]. Throw Error(Failure::BadStroke) where the curve turns
  // back on itself or runs along the normal.
  CurveFrame at(double t) const;
  // outward: the fitted plane's normal, the same for every t, its largest component positive; of a straight
  // curve (the second extent below a thousandth of the first) the tangent x the mean of the surface's
  // normals.
  CurveFrame planesAt(double t) const;
  double length() const { return this->Lengths.back(); }

private:
  Vector3 originAt(double t) const;

  std::vector<Vector3> Points;
  std::vector<double> Lengths;            // from the first point to each
  std::vector<Vector3> Tangents, Normals; // smooth, at equal lengths
  Vector3 Outward;                        // of planesAt
};

} // namespace oversketch
#endif
