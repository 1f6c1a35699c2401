#include "Remesh/cutout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace oversketch
{

namespace
{

constexpr int bits = 6; // per axis, of a cell's place on the curve

// The bits of x, two places apart.
std::uint32_t spread(std::uint32_t x)
{
  std::uint32_t result = 0;
  for (int i = 0; i < bits; ++i)
  {
    result |= (x >> i & 1u) << (3 * i);
  }
  return result;
}

} // namespace

Cutout::Cutout(const Mesh& whole, const std::vector<char>& wholeActive)
  : vertexOf(whole.points.size(), -1)
{
  std::vector<char> inside(whole.points.size(), 0);
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (int t = 0; t < whole.triangleCount(); ++t)
  {
    for (int k = 0; wholeActive[t] && k < 3; ++k)
    {
      const int v = whole.triangles[t][k];
      inside[v] = 1;
      low = low.cwiseMin(whole.points[v]);
      high = high.cwiseMax(whole.points[v]);
    }
  }
  // Cells along a Z curve: triangles are put into their cell in their order.
  const double extent = (high - low).maxCoeff();
  constexpr int cells = 1 << bits;
  std::array<std::uint32_t, cells> spreads;
  for (int i = 0; i < cells; ++i)
  {
    spreads[i] = spread(static_cast<std::uint32_t>(i));
  }
  const auto cellOf = [&](int t)
  {
    std::uint32_t cell = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double x =
        extent > 0.0 ? (whole.points[whole.triangles[t][0]][k] - low[k]) / extent * cells : 0.0;
      cell |= spreads[static_cast<int>(std::clamp(x, 0.0, cells - 1.0))] << k;
    }
    return cell;
  };
  std::vector<int> chosen;
  std::vector<std::uint32_t> cellOfChosen;
  std::vector<int> offsets(std::size_t(cells) * cells * cells + 1, 0);
  for (int t = 0; t < whole.triangleCount(); ++t)
  {
    const Triangle& c = whole.triangles[t];
    if (inside[c[0]] || inside[c[1]] || inside[c[2]])
    {
      chosen.push_back(t);
      cellOfChosen.push_back(cellOf(t));
      ++offsets[cellOfChosen.back() + 1];
    }
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  this->triangles.resize(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    this->triangles[offsets[cellOfChosen[i]]++] = chosen[i];
  }
  // Vertices as the triangles meet them.
  this->active = taken(wholeActive, this->triangles);
  this->mesh.triangles = taken(whole.triangles, this->triangles);
  for (Triangle& t : this->mesh.triangles)
  {
    for (int& v : t)
    {
      if (this->vertexOf[v] < 0)
      {
        this->vertexOf[v] = static_cast<int>(this->vertices.size());
        this->vertices.push_back(v);
      }
      v = this->vertexOf[v];
    }
  }
  this->mesh.points = taken(whole.points, this->vertices);
}

} // namespace oversketch
