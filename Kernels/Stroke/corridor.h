// A drawn stroke over a picture's edges, and the paths along them beside it. Private to this folder.
#ifndef oversketch_kernels_stroke_corridor_h
#define oversketch_kernels_stroke_corridor_h

#include "Stroke/livewire.h"

namespace oversketch
{

// A stroke as the livewire walks it: opened at its start where it is closed.
struct DrawnOver
{
  static constexpr double leastRadius = 3.0; // px: the narrowest corridor

  const EdgeFeatures& features;
  const LivewireRules& rules;
  Polyline points;
  bool closed;
  double radius;

  int count() const { return static_cast<int>(this->points.size()); }
  // Angle of the stroke at a sample.
  double chord(int sample) const;
  // Whether the edge pixel at (x, y) runs along the stroke, whose angle is given.
  bool counts(int x, int y, double angle) const;
  // The strongest edge that counts within the radius of a seed, of equally strong ones the nearest; else the
  // pixel it lies on.
  Pixel seedPixel(int sample) const;
  // The pixels across the stroke at a sample, within the radius; none beside the picture.
  std::vector<Pixel> section(int sample) const;
  // The pixels within the radius of a part of the stroke.
  PathField corridor(int from, int to) const;
};

// Paths, one for each part of the stroke, empty where there is none, and of each of its pixels whether an
// edge that counts is beside it.
struct PartPaths
{
  std::vector<std::vector<Pixel>> pixels;
  std::vector<std::vector<std::uint8_t>> strong;
};
// The parts lie between the samples `ends`.
PartPaths pathsBetweenSeeds(const DrawnOver& drawn, const std::vector<int>& ends, const Context& context);
PartPaths pathsTogether(const DrawnOver& drawn, const std::vector<int>& ends, const Context& context);

} // namespace oversketch
#endif
