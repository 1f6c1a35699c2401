// Where the shipped drawings are drawn on, in a session through all four systems. Header-only.
#ifndef oversketch_testing_chain_chain_plans_h
#define oversketch_testing_chain_chain_plans_h

#include "Harness/shapes.h"

#include <vector>

namespace oversketch_test
{

// Places are pixels of the picture, from its lower left corner, which are units of the model.
struct DrawnChain
{
  const char* name;
  // The limb: the outline so far to both sides of what is nearest to the tip goes by the pull.
  Vector2 tip, pull;
  double reach;
  // The edit: a line through that middle, in that direction as long as it; half axes of the ring, the first
  // along it.
  Vector2 middle, along, ring;
  double rise; // of the cross-section, as a share of its width
  std::vector<Vector2> vein;
  double radius, height;
  // Where the drawing's first stroke changes, by how much, and how far to both sides.
  Vector2 outline, push;
  double outlineReach;
};

inline const std::vector<DrawnChain>& drawnChains()
{
  static const std::vector<DrawnChain> chains = {
    { "fish",
      { 965, 520 },
      { 16, 40 },
      120,
      { 292, 262 },
      { 50, -30 },
      { 66, 58 },
      0.42,
      { { 380, 392 }, { 450, 398 }, { 560, 380 }, { 680, 344 }, { 760, 334 } },
      14,
      9,
      { 380, 60 },
      { 0, -16 },
      70 },
    { "leaf",
      { 78, 196 },
      { -30, -12 },
      80,
      { 480, 312 },
      { 96, 28 },
      { 80, 50 },
      0.3,
      { { 220, 240 }, { 340, 275 }, { 460, 312 }, { 570, 346 }, { 720, 388 } },
      10,
      7,
      { 520, 508 },
      { 4, 18 },
      60 },
    { "heron",
      { 697, 412 },
      { 42, -24 },
      90,
      { 470, 545 },
      { 70, -40 },
      { 70, 55 },
      0.3,
      { { 400, 560 }, { 440, 600 }, { 490, 560 }, { 560, 520 } },
      9,
      6,
      { 330, 560 },
      { -12, -8 },
      60 },
  };
  return chains;
}

} // namespace oversketch_test
#endif
