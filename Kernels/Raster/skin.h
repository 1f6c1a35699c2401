// The colours that a model of a picture wears: opaque, and led on past what it covers of the picture.
#ifndef oversketch_kernels_raster_skin_h
#define oversketch_kernels_raster_skin_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace oversketch
{

// Rows from the bottom, 1 to 4 samples a pixel: grey, grey and alpha, colour, colour and alpha.
struct PictureSamples
{
  const std::uint8_t* samples = nullptr;
  int width = 0, height = 0, components = 0;

  bool hasAlpha() const { return this->components % 2 == 0; }
  // Without alpha.
  int colours() const { return this->components - (this->hasAlpha() ? 1 : 0); }
  // Alpha of a pixel; 255 without.
  int alpha(std::size_t pixel) const
  {
    const auto each = static_cast<std::size_t>(this->components);
    return this->hasAlpha() ? this->samples[pixel * each + each - 1] : 255;
  }
};

using PictureTriangle = std::array<Vector2, 3>; // px from the lower left corner of the picture

// The picture without alpha, where the colour of a pixel is its own in the inside of what the triangles
// cover, and else that of the nearest such pixel: up to a 64th of the longest side off, and wherever the
// picture is transparent. An outline drawn by hand runs beside the thing's own, and textures are read
// between pixels, so the inside begins a 300th of the longest side from the border, in thinner parts in
// their middle; transparent pixels are never of it. Where nothing is, all keep their colours.
std::vector<std::uint8_t> skinOf(const PictureSamples& picture,
  const std::vector<PictureTriangle>& covered,
  const Context& context);

// The skin whose inside is filled from its rim, for a back that nobody drew: what lies deeper below the
// border than a fortieth of the longest side of what is covered has colours that go on from there, evener the
// deeper it is. Thinner parts, and the rim but for its outmost fifth, keep their colours without details,
// which would be streaks down a steep side. What is not covered is as in skinOf.
//
// Source: Bertalmio, Bertozzi, Sapiro, Navier-Stokes, fluid dynamics, and image and video inpainting, CVPR
// 2001, by OpenCV, on at most 256 px. Its fronts that meet far from the rim leave an edge there, and pixels of
// the rim rays, so the inside is blurred in addition, by what is covered alone. OpenCV's other method, after
// Telea, drifts away from an even colour.
std::vector<std::uint8_t> rimSkinOf(const PictureSamples& picture,
  const std::vector<PictureTriangle>& covered,
  const Context& context);

// The picture without alpha, all of it worn. What was cut away, and the half-transparent pixels along its
// rim, have the colour of the nearest pixel that is opaque: neither a smooth nor a small picture of the
// texture shows what is under them. Without an opaque pixel all keep their colours.
std::vector<std::uint8_t> opaqueOf(const PictureSamples& picture, const Context& context);

} // namespace oversketch
#endif
