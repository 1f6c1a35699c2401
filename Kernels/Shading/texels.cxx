#include "Shading/texels.h"

#include "Mesh/context.h"
#include "Mesh/shape.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

// The rows, or columns, whose centres lie between two places of the disc.
std::pair<int, int> rowsWithin(double low, double high, int size)
{
  const double first = std::ceil(0.5 * ((low + 1.0) * size - 1.0) - 1e-9);
  const double last = std::floor(0.5 * ((high + 1.0) * size - 1.0) + 1e-9);
  return { static_cast<int>(std::max(first, 0.0)), static_cast<int>(std::min(last, size - 1.0)) };
}

} // namespace

Vector2 discPlace(int i, int j, int size)
{
  return { (2.0 * i + 1.0) / size - 1.0, (2.0 * j + 1.0) / size - 1.0 };
}

std::vector<double> onTexels(const std::vector<Vector2>& disc,
  const std::vector<Triangle>& triangles,
  const std::vector<double>& values,
  int size,
  double outside,
  const Context& context)
{
  std::vector<double> texels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), outside);
  // Triangles that may reach each row, ascending.
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(size));
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& c = triangles[t];
    const auto [low, high] = std::minmax({ disc[c[0]][1], disc[c[1]][1], disc[c[2]][1] });
    const auto [bottom, top] = rowsWithin(low, high, size);
    for (int j = bottom; j <= top; ++j)
    {
      rows[j].push_back(static_cast<int>(t));
    }
  }
  context.eachUntilCancelled(size,
    [&](int j)
    {
      for (const int t : rows[j])
      {
        const Triangle& c = triangles[t];
        const Vector2 &a = disc[c[0]], &b = disc[c[1]], &p = disc[c[2]];
        const Vector2 u = b - a, v = p - a;
        const double area = cross(u, v);
        if (!(area > 0.0))
        {
          continue;
        }
        const auto [low, high] = std::minmax({ a[0], b[0], p[0] });
        const auto [left, right] = rowsWithin(low, high, size);
        for (int i = left; i <= right; ++i)
        {
          const Vector2 d = discPlace(i, j, size) - a;
          const double second = cross(d, v) / area, third = cross(u, d) / area, first = 1.0 - second - third;
          // On an edge, by rounding, neither neighbour may have the texel: both do, with the same value.
          if (std::min({ first, second, third }) >= -1e-9)
          {
            texels[static_cast<std::size_t>(j) * size + i] =
              first * values[c[0]] + second * values[c[1]] + third * values[c[2]];
          }
        }
      }
    });
  context.checkpoint(0.0);
  return texels;
}

TexelMix texelsRound(const Vector2& uv, int width, int height)
{
  const auto along = [](double share, int count)
  {
    const double place = std::clamp(share * count - 0.5, 0.0, count - 1.0);
    const int low = std::min(static_cast<int>(place), std::max(count - 2, 0));
    return std::make_tuple(low, std::min(low + 1, count - 1), place - low);
  };
  const auto [left, right, x] = along(uv[0], width);
  const auto [bottom, top, y] = along(uv[1], height);
  const auto index = [width = width](int i, int j)
  { return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i); };
  return { { index(left, bottom), index(right, bottom), index(left, top), index(right, top) }, x, y };
}

AreaMask::AreaMask(const std::vector<char>& selected, int size, double feather, const Context& context)
  : Size(size)
  , Feather(0.5 * feather * size)
  , Depths(selected.size(), -0.5f)
{
  // Exact: first along each row, then over the rows that are near enough to count.
  const int reach = static_cast<int>(std::ceil(this->Feather)) + 1;
  std::vector<int> across(selected.size(), 0);
  context.eachUntilCancelled(size,
    [&](int j)
    {
      const std::size_t row = static_cast<std::size_t>(j) * size;
      for (int i = 0, run = 0; i < size; ++i)
      {
        run = selected[row + i] ? run + 1 : 0;
        across[row + i] = run;
      }
      for (int i = size - 1, run = 0; i >= 0; --i)
      {
        run = selected[row + i] ? run + 1 : 0;
        across[row + i] = std::min(across[row + i], run);
      }
    });
  context.eachUntilCancelled(size,
    [&](int j)
    {
      for (int i = 0; i < size; ++i)
      {
        const std::size_t at = static_cast<std::size_t>(j) * size + i;
        if (!selected[at])
        {
          continue;
        }
        double least = static_cast<double>(across[at]) * across[at];
        for (int dy = 1; dy <= reach && dy * dy < least; ++dy)
        {
          for (const int other : { j - dy, j + dy })
          {
            const double x =
              other >= 0 && other < size ? across[static_cast<std::size_t>(other) * size + i] : 0;
            least = std::min(least, x * x + dy * dy);
          }
        }
        this->Depths[at] = static_cast<float>(std::min(std::sqrt(least) - 0.5, this->Feather + 0.5));
      }
    });
  context.checkpoint(0.0);
}

std::size_t AreaMask::texelAt(const Vector2& uv) const
{
  const auto along = [this](double share)
  { return static_cast<std::size_t>(std::clamp(std::floor(share * this->Size), 0.0, this->Size - 1.0)); };
  return along(uv[1]) * static_cast<std::size_t>(this->Size) + along(uv[0]);
}

double AreaMask::share(const Vector2& uv) const
{
  if (!this->selects(uv))
  {
    return 0.0;
  }
  if (this->Feather <= 0.0)
  {
    return 1.0;
  }
  const TexelMix mix = texelsRound(uv, this->Size, this->Size);
  double depths[4];
  for (int k = 0; k < 4; ++k)
  {
    depths[k] = static_cast<double>(this->Depths[mix.texels[k]]);
  }
  const double depth = mix.of(depths);
  const double t = std::clamp(depth / this->Feather, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

ShadedPlaces shadedPlaces(const std::vector<Vector2>& disc,
  const std::vector<Triangle>& triangles,
  const std::vector<double>& shares,
  const std::vector<char>& inside,
  int size,
  const Context& context)
{
  ShadedPlaces places;
  for (std::size_t v = 0; v < disc.size(); ++v)
  {
    if (inside[v])
    {
      places.vertices.push_back(static_cast<int>(v));
      places.shares.push_back(shares[v]);
      places.uv.emplace_back(0.5 * (disc[v] + Vector2::Ones()));
    }
  }
  const std::vector<double> texels = onTexels(disc, triangles, shares, size, -1.0, context);
  for (std::size_t i = 0; i < texels.size(); ++i)
  {
    if (texels[i] >= 0.0)
    {
      const int column = static_cast<int>(i) % size, row = static_cast<int>(i) / size;
      places.texels.push_back(static_cast<int>(i));
      places.steps.push_back(static_cast<std::uint16_t>(std::lround(std::min(texels[i], 1.0) * shadeSteps)));
      places.uv.emplace_back((column + 0.5) / size, (row + 0.5) / size);
    }
  }
  return places;
}

AreaShares areaShares(const AreaMask& mask, const ShadedPlaces& places, const Context& context)
{
  AreaShares result;
  result.shares.resize(places.uv.size());
  result.selects.resize(places.uv.size());
  context.each(static_cast<int>(places.uv.size()),
    [&](int i)
    {
      result.shares[i] = static_cast<float>(mask.share(places.uv[i]));
      result.selects[i] = mask.selects(places.uv[i]);
    });
  return result;
}

Shading::Shading(const Layers& whole, const std::vector<ShadedArea>& areas, Falloff falloff)
  : Whole(whole)
  , Areas(areas)
  , Fall(falloff)
{
}

std::vector<double> Shading::weights(const ShadedPlaces& places, const Context& context) const
{
  std::vector<double> result(places.vertices.size());
  context.each(static_cast<int>(result.size()),
    [&](int i)
    {
      const double s = places.shares[i];
      double weight = this->Whole.weight(s, this->Fall);
      for (const ShadedArea& area : this->Areas)
      {
        const double share = static_cast<double>(area.where->shares[i]);
        if (share > 0.0)
        {
          weight = (1.0 - share) * weight + share * area.layers.weight(s, this->Fall);
        }
      }
      result[i] = weight;
    });
  return result;
}

Shading::Table Shading::tableOf(const Layers& layers, const Context& context) const
{
  Table table{ std::vector<float>(shadeSteps + 1), std::vector<unsigned char>(shadeSteps + 1) };
  context.each(shadeSteps + 1,
    [&](int i)
    {
      const double s = static_cast<double>(i) / shadeSteps;
      table.weights[i] = static_cast<float>(layers.weight(s, this->Fall));
      table.greys[i] = static_cast<unsigned char>(layers.grey(layers.level(s)));
    });
  return table;
}

void Shading::paint(const ShadedPlaces& places,
  float* weights,
  unsigned char* greys,
  const Context& context) const
{
  const Table whole = this->tableOf(this->Whole, context);
  const auto tables =
    mapped(this->Areas, [&](const ShadedArea& area) { return this->tableOf(area.layers, context); });
  const std::size_t vertices = places.vertices.size();
  context.each(static_cast<int>(places.texels.size()),
    [&](int i)
    {
      const int texel = places.texels[i];
      const int step = places.steps[i];
      float weight = whole.weights[step];
      unsigned char grey = whole.greys[step];
      for (std::size_t k = 0; k < tables.size(); ++k)
      {
        const AreaShares& area = *this->Areas[k].where;
        weight += area.shares[vertices + i] * (tables[k].weights[step] - weight);
        grey = area.selects[vertices + i] ? tables[k].greys[step] : grey;
      }
      weights[texel] = weight;
      greys[texel] = grey;
    });
  context.checkpoint(1.0);
}

} // namespace oversketch
