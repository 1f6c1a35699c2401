// The disc as a square picture: values on its texels, and the layers of areas that were selected on it.
#ifndef oversketch_kernels_shading_texels_h
#define oversketch_kernels_shading_texels_h

#include "Shading/layers.h"

#include "Mesh/mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace oversketch
{

struct Context;

// Texel (i, j) of size x size, rows from the bottom, has its centre at (2 i + 1, 2 j + 1) / size - (1, 1) of
// the disc: x and y from -1 to 1 are u and v from 0 to 1 over the whole picture.
Vector2 discPlace(int i, int j, int size);

// The value at each texel's centre, linear over the disc's triangles; `outside` where there is none.
std::vector<double> onTexels(const std::vector<Vector2>& disc,
  const std::vector<Triangle>& triangles,
  const std::vector<double>& values,
  int size,
  double outside,
  const Context& context);

// The four texels round a place (u, v), those of the rim beyond it, and how to mix them.
struct TexelMix
{
  std::array<std::size_t, 4> texels;
  double x, y; // from the first to the second and from the third to the fourth; from those to these

  // Bilinear; of four equal values, that value.
  template <typename Value>
  double of(const Value& values) const
  {
    const double low = values[0] + this->x * (values[1] - values[0]),
                 high = values[2] + this->x * (values[3] - values[2]);
    return low + this->y * (high - low);
  }
};
TexelMix texelsRound(const Vector2& uv, int width, int height);

// Pixels that were selected on the disc, and how far inside their border they are.
class AreaMask
{
public:
  // `selected`: size x size, not 0 where it is; `feather`: of the disc's radius, 0 to 1.
  AreaMask(const std::vector<char>& selected, int size, double feather, const Context& context);

  bool selects(const Vector2& uv) const { return this->Depths[this->texelAt(uv)] > 0.0f; }
  // Share that an area's own layers have at a place: 0 where it is not selected, from the border on within
  // the feather up to 1, smoothly, so that no cliff stands there.
  double share(const Vector2& uv) const;

private:
  std::size_t texelAt(const Vector2& uv) const;

  int Size;
  double Feather;            // [texels]
  std::vector<float> Depths; // from the border [texels], at most the feather; -0.5 where it is not selected
};

// Places that are shaded: the disc's vertices that are strictly inside, and the texels that lie on it.
struct ShadedPlaces
{
  std::vector<int> vertices;        // of the disc
  std::vector<double> shares;       // of each of these: of the way from the reference curve to the boundary
  std::vector<int> texels;          // of size x size, row by row
  std::vector<std::uint16_t> steps; // of each of these: its share in steps of 1 / shadeSteps
  std::vector<Vector2> uv;          // of the vertices, then of the texels
};
ShadedPlaces shadedPlaces(const std::vector<Vector2>& disc,
  const std::vector<Triangle>& triangles,
  const std::vector<double>& shares,
  const std::vector<char>& inside,
  int size,
  const Context& context);

// Far finer than a texel, so that of a picture each step is weighed once and no texel by itself.
constexpr int shadeSteps = 8192;

// An area at each place, as AreaMask has it, in the order of ShadedPlaces::uv.
struct AreaShares
{
  std::vector<float> shares;
  std::vector<char> selects;
};
AreaShares areaShares(const AreaMask& mask, const ShadedPlaces& places, const Context& context);

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.2 to 5.4: weights and
// greys by the layers of the whole disc and of areas on it, of which the last one wins. Departure: an area's
// weights blend with those round it, as AreaMask has it; greys do not.
struct ShadedArea
{
  Layers layers;
  const AreaShares* where;
};
class Shading
{
public:
  Shading(const Layers& whole, const std::vector<ShadedArea>& areas, Falloff falloff);

  // Weight of each vertex, exact.
  std::vector<double> weights(const ShadedPlaces& places, const Context& context) const;
  // Into images of size x size; what is beside the disc is left as it is.
  void paint(const ShadedPlaces& places, float* weights, unsigned char* greys, const Context& context) const;

private:
  struct Table
  {
    std::vector<float> weights;
    std::vector<unsigned char> greys;
  };
  Table tableOf(const Layers& layers, const Context& context) const;

  const Layers& Whole;
  const std::vector<ShadedArea>& Areas;
  Falloff Fall;
};

} // namespace oversketch
#endif
