// How far inside its object's rim each pixel is, and how thick the object is there.
#ifndef oversketch_kernels_raster_distance_maps_h
#define oversketch_kernels_raster_distance_maps_h

#include "Mesh/context.h"
#include "Raster/classify.h"

namespace oversketch
{

// A closed stroke that lies on an object's rim: its boundary, or that of a hole in it.
struct Rim
{
  Polyline points; // world; the first is not repeated
  int object = 0;
};

// Fate of the inside of a closed feature.
enum class Treatment : int
{
  Fill = 0,
  Hole = 1,  // cut out before the surface is made
  Tunnel = 2 // cut out of the surface
};

// Regions, each with 1 where its stroke is a hole. What lies in one and is none is an island.
std::vector<char> regionsInHoles(const Classification& classification,
  const std::vector<Treatment>& treatments);

// The rims of a drawing, in the strokes' order: boundaries of objects, those of holes in what is no hole
// already, and those of islands, which lie in a hole and are none. treatments: of each stroke; those of
// boundaries and open features do not matter.
std::vector<Rim> rimsOf(const Classification& classification,
  const std::vector<DrawnStroke>& strokes,
  const std::vector<Treatment>& treatments);

enum class ThicknessMode
{
  Local, // D is T at the ridge that the steepest way up leads to
  Global // D is the object's greatest T
};

struct DistanceMaps
{
  Frame frame;
  std::vector<int> object;            // of each sample; -1 outside, and the object on its rim's pixels
  std::vector<float> distance;        // T [px]: to the nearest pixel of a rim, 0 on it and outside
  std::vector<float> thickness;       // D [px], LocalMax; 0 where T is
  std::vector<std::uint8_t> skeleton; // 1 on the ridge
  // Neighbour, of each sample inside that is not on the ridge, that the steepest way up leads to, an index
  // into these; -1 elsewhere.
  std::vector<int> uphill;
};

// Source: image-assisted modelling, section 11. T is exact and Euclidean, between the centres of samples, in
// the areas between an object's rims (even-odd). A sample inside belongs to the ridge when no neighbour's T
// is higher, or when T >= 3 px and the steepest way to one of its eight neighbours rises by less than 0.75
// per px. D >= T everywhere. Features and tunnels are no rims.
//
// T is OpenCV's distanceTransform with DIST_MASK_PRECISE and without labels: asking for those makes it fall
// back to its mask of 5. Throws Error(Failure::BadStroke) for a rim of fewer than three points or one that
// leaves the canvas, Error(Failure::Unexpected) when OpenCV fails. The same for any number of threads.
DistanceMaps distanceMaps(const Frame& frame,
  const std::vector<Rim>& rims,
  ThicknessMode mode,
  const Context& context);

// The first half of it, T and the objects alone, and the second, for benchmarks.
DistanceMaps distanceTo(const Frame& frame, const std::vector<Rim>& rims, const Context& context);
void findThickness(DistanceMaps& maps, ThicknessMode mode, const Context& context);

// The greatest T of each object.
std::vector<float> greatestDistances(const DistanceMaps& maps);

} // namespace oversketch
#endif
