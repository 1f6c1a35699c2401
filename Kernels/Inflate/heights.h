// How far the points of a drawing's mesh are pushed out of its plane.
#ifndef oversketch_kernels_inflate_heights_h
#define oversketch_kernels_inflate_heights_h

#include "Inflate/cross_section.h"
#include "Planar/planar_mesh.h"
#include "Raster/distance_maps.h"

#include <vector>

namespace oversketch
{

enum class Inflation
{
  Section, // by the cross-section and the thickness
  Ratio    // by the solution of an equation: GridSmoothing's profileRatio or poissonRatio
};

// Maps that heights are read from, and values, kept by reference.
struct HeightMaps
{
  const DistanceMaps& distance;        // T
  const std::vector<float>& thickness; // D' [px] of samples; of Ratio roundThickness's
  const std::vector<float>& ratio;     // squares of heights over T [px] of samples; of Ratio alone
  Inflation mode = Inflation::Section;
};

// q = (D' f(d / D'))^2 [px^2] of each sample, d = min(T, D').
std::vector<float> sectionSquares(const DistanceMaps& maps,
  const std::vector<float>& thickness,
  const CrossSection& section,
  const Context& context);

// q of the circle: that of the greatest of all balls above each sample that lie inside, a ball at each
// sample, as large as its T; and at least d (2 D - d). Balls do not stop where the nearest place on the
// ridge is another one, and what a hand's tremor adds to the ridge lies inside larger ones.
std::vector<float> roundSquares(const DistanceMaps& maps, const Context& context);

// Radius at each sample [px] of the circle that stands upright on the rim and has the height there: with q
// its square, (q / T + T) / 2; 0 where T is.
std::vector<float> roundThickness(const DistanceMaps& maps, const std::vector<float>& ratio);

// The maps at places between samples [px].
class MapReader
{
public:
  explicit MapReader(const HeightMaps& maps)
    : Maps(maps)
  {
  }

  // T, bilinearly.
  double distance(const Vector2& place) const;
  // Its gradient.
  Vector2 slope(const Vector2& place) const;
  // Values that mean nothing where T is 0, bilinearly: there those of the object's nearest inner sample count
  // (of any object for -1), 0 when none is within 16 px.
  double inner(const std::vector<float>& values, const Vector2& place, int object) const;
  // The height [px] of k_z = 1 off the rim, see heightsOf.
  double height(const Vector2& place, int object, const CrossSection& section) const;

private:
  struct Cell;
  Cell cellOf(const Vector2& place) const;
  float valueAt(const std::vector<float>& values, int x, int y, int object) const;

  const HeightMaps& Maps;
};

// Object of each point's faces, the last one's; -1 without faces.
std::vector<int> objectsOf(const PlanarMesh& mesh);

// Heights [world] of the mesh's points. Source: image-assisted modelling, section 12:
// s k_z D' f(d / D') with s the raster's spacing, d = min(T, D'), D' at the point; of a ratio: s k_z
// sqrt(ratio T). Points of a rim stay at 0, by their kind and not by d = 0. At others d is at least 0.25 px
// and, which the paper leaves open, the ratio at least 1e-4 px, so that front and back never meet. `factor`,
// k_z, is above 0. Throws Error(Failure::BadStroke) for another factor, Error(Failure::BadMesh) naming a
// point outside the maps. The same for any number of threads.
std::vector<double> heightsOf(const PlanarMesh& mesh,
  const HeightMaps& maps,
  const CrossSection& section,
  double factor,
  const Context& context);

} // namespace oversketch
#endif
