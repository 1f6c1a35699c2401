// A cross-section as a flat profile that can be drawn anew, and what a new one does to each place of it.
#ifndef oversketch_kernels_section_profile_h
#define oversketch_kernels_section_profile_h

#include "Matrix/frames.h"
#include "Matrix/logarithm.h"
#include "Stroke/nurbs.h"
#include "Stroke/polyline.h"

#include <vector>

namespace oversketch
{

struct FlatProfile
{
  Polyline points;                       // begins at (0, 0), its longer side is 1
  std::vector<double> t;                 // share of its length, 0 to 1, strictly ascending
  std::vector<double> beside;            // where on the way from the curve to the boundary, see ProfileChange
  Matrix4 toWorld = Matrix4::Identity(); // of (x, y, 0)
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 6.2: the section's
// points are fitted by a spline and rescaled to between 0 and 1. Here: first even, twice as many, since
// triangles cut it into steps of any length; then they are the spline's control points (Nurbs). x runs from
// its first point to its last, y towards the surface's outside, both scaled alike.
//
// Weights that the spline gives its control points depend on their number alone, which sections by a plane
// that slides mostly share: they are kept from one to the next.
class ProfileFit
{
public:
  // beside: one value of each point. Throws Error(Failure::BadStroke) for a section whose ends meet, or of no
  // length.
  FlatProfile flat(const std::vector<Vector3>& section,
    const std::vector<double>& beside,
    const Vector3& normal,
    const Vector3& outward);

private:
  std::vector<SplinePlace> Places; // of as many points
};

// The thesis says nothing of how a new profile deforms the mesh but that it will match. Here each sample p of
// the old one has a partner q, the place of the new one that came from the same share of the length; beside
// is the vertex's share of the way from the reference curve (0) to the boundary (1), negative on the other
// side of the curve; the displacement q - p is read by it.
class ProfileChange
{
public:
  // middle: the reference curve's place, flat. From there outwards `beside` must grow on either side; what
  // comes after it falls by over 0.02, where the section has met another arm of the curve, is left out, and
  // displacements run out evenly to the boundary. drawn, source: the new profile and the t from which each
  // of its points came, not falling. Its ends are drawn to those of the old one over a tenth of the length.
  //
  // Throws Error(Failure::BadStroke) naming the point for a new profile of fewer than two points, one that is
  // not finite, or whose sources fall or are outside [0, 1].
  ProfileChange(const FlatProfile& profile,
    const Vector2& middle,
    const Polyline& drawn,
    const std::vector<double>& source);

  // Flat; zero from -1 and 1 on.
  Vector2 at(double beside) const;
  // The new profile as the surface can have it, of each sample of the old one: what a cross-section of the
  // deformed mesh is to be compared with.
  const Polyline& target() const { return this->Target; }

private:
  Polyline Target;
  std::vector<double> Beside; // ascending
  std::vector<Vector2> Displacements;
};

} // namespace oversketch
#endif
