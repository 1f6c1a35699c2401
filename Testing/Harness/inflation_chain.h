// From rims to the surface, for tests. Header-only.
#ifndef oversketch_testing_harness_inflation_chain_h
#define oversketch_testing_harness_inflation_chain_h

#include "Harness/drawn_meshes.h"
#include "Inflate/heights.h"
#include "Inflate/solid.h"
#include "Mesh/context.h"
#include "Raster/grid_smoothing.h"

namespace oversketch_test
{

// A drawing's maps and what is made of them, by the defaults or as published.
struct Chain
{
  explicit Chain(const std::vector<Rim>& rims, bool published = false)
    : maps(
        oversketch::distanceMaps(pixelFrame(), rims, oversketch::ThicknessMode::Local, oversketch::Context()))
    , grid(maps, 2, oversketch::Context())
    , smoothed(!published)
    , thickness(grid.thickness(published ? 0.0 : 0.5, oversketch::Context()))
  {
  }

  // The heights' maps as `use` is called with them.
  template <typename Use>
  auto withMaps(const oversketch::Context& context, const Use& use)
  {
    using oversketch::Inflation;
    const double smoothing = this->smoothed ? this->section.smoothing() : 0.0;
    if (!this->poisson && smoothing == 0.0)
    {
      return use(oversketch::HeightMaps{ this->maps, this->thickness, this->thickness, Inflation::Section });
    }
    const std::vector<float> ratio =
      this->poisson
        ? this->grid.poissonRatio(context)
        : this->grid.profileRatio(oversketch::roundSquares(this->maps, context), smoothing, context);
    const std::vector<float> round = oversketch::roundThickness(this->maps, ratio);
    return use(oversketch::HeightMaps{ this->maps, round, ratio, Inflation::Ratio });
  }

  std::vector<double> heights(const PlanarMesh& mesh, const oversketch::Context& context = {})
  {
    return this->withMaps(context,
      [&](const oversketch::HeightMaps& use)
      { return oversketch::heightsOf(mesh, use, this->section, this->factor, context); });
  }

  oversketch::Solid solid(const PlanarMesh& mesh) { return oversketch::inflate(mesh, this->heights(mesh)); }

  oversketch::DistanceMaps maps;
  oversketch::GridSmoothing grid;
  bool smoothed;
  std::vector<float> thickness;
  oversketch::CrossSection section;
  bool poisson = false;
  double factor = 1.0;
};

} // namespace oversketch_test
#endif
