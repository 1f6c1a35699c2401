// Layers of grey between a reference curve and the boundary round it, and the handles that pull at them.
#ifndef oversketch_kernels_shading_layers_h
#define oversketch_kernels_shading_layers_h

#include <utility>
#include <vector>

namespace oversketch
{

// Where a handle was placed, and where it is dragged to: both a share s of the way from the reference curve,
// 0, to the boundary, 1. `rest` is asked of Layers::restOf when the handle is placed; `place` is kept as the
// hand left it, beyond its neighbours too: pulled back, all is as it was.
struct LayerHandle
{
  double rest = 0.0, place = 0.0;
};

enum class Falloff
{
  Smooth, // 1 - (10 s^3 - 15 s^4 + 6 s^5), without a jump of slope or curvature at either curve
  Linear  // 1 - s, as published
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.2 and 5.3: equal
// layers, white at the reference curve and black at the boundary; a handle holds what it was placed on, and
// what is between it and its neighbours follows it. The thesis does not say how: here as a rubber band does,
// phi, which is linear between handles and takes 0 to 0, 1 to 1 and a handle's rest to its place.
//
// Departures: a vertex's weight is that of where it was, phi^-1(s), by a monotone cubic (Fritsch and Carlson,
// "Monotone Piecewise Cubic Interpolation") in place of the linear phi^-1, whose kink at a handle is an edge
// in the surface; and falls smoothly. Beyond an end of the reference curve s grows as a root of the distance,
// so that only a power of s above 2 leaves no point there. Falloff::Linear is as published.
//
// A place on which several layers have come together has the outermost one's value. Throws
// Error(Failure::BadStroke) for fewer than 2 levels or more than 256, and for a handle that is not finite or
// whose rest is not at least 1e-3 away from 0, 1 and the others' rests.
class Layers
{
public:
  // A handle does not pass its neighbours: it is held at those that come before it in the list, which is that
  // in which they were dragged.
  explicit Layers(int levels = 5, const std::vector<LayerHandle>& handles = {});

  // Outer boundaries of all levels but the last, ascending; a level between equal ones has vanished.
  const std::vector<double>& boundaries() const { return this->Boundaries; }
  // phi and phi^-1, linear.
  double placeOf(double rest) const;
  double restOf(double s) const;
  // 1 at the reference curve, 0 at the boundary.
  double weight(double s, Falloff falloff = Falloff::Smooth) const;
  // 0 to levels - 1, and its grey: 255, 191, 128, 64, 0 of five.
  int level(double s) const;
  int grey(int level) const;
  // The handles where they are held, in the order of the list.
  std::vector<LayerHandle> held() const;

private:
  // Place now, and the two where it was: the same but where layers have vanished.
  struct Knot
  {
    double place, before, after;
    double slopeBefore = 1.0, slopeAfter = 1.0; // of phi^-1
  };
  std::pair<const Knot&, const Knot&> aboutPlace(double place) const; // below the last one's
  double smoothRestOf(double s) const;
  void findSlopes();

  int Levels;
  std::vector<LayerHandle> Handles; // held, in the list's order
  std::vector<LayerHandle> Band;    // by rest, with both ends
  std::vector<Knot> Knots;          // by place
  std::vector<double> Boundaries;
};

// The list for dragging one of its handles: all are where they are held, and it comes last.
std::vector<LayerHandle> grasped(const std::vector<LayerHandle>& handles, int which);

} // namespace oversketch
#endif
