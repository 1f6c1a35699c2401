#include "Remesh/cutout.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

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

// Axes (rows) that turn with the points: those of their spread, each towards where they reach farther. Of a
// body that is the same on both sides one axis tells no sides apart: the evenest follows from the others.
Eigen::Matrix3d axesOf(const std::vector<Vector3>& points)
{
  Vector3 mean = Vector3::Zero();
  for (const Vector3& p : points)
  {
    mean += p / static_cast<double>(points.size());
  }
  Eigen::Matrix3d spreads = Eigen::Matrix3d::Zero();
  for (const Vector3& p : points)
  {
    spreads += (p - mean) * (p - mean).transpose();
  }
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spreads).eigenvectors().transpose();
  Vector3 skew = Vector3::Zero(), size = Vector3::Zero();
  for (const Vector3& p : points)
  {
    const Vector3 along = axes * (p - mean), cubes = along.array().cube();
    skew += cubes;
    size += cubes.cwiseAbs();
  }
  Vector3::Index evenest = 0;
  (skew.array().abs() / size.array().max(std::numeric_limits<double>::min())).minCoeff(&evenest);
  for (int k = 0; k < 3; ++k)
  {
    axes.row(k) *= skew[k] < 0.0 ? -1.0 : 1.0;
  }
  const auto k = static_cast<int>(evenest);
  axes.row(k) = axes.row((k + 1) % 3).cross(axes.row((k + 2) % 3));
  return axes;
}

// The points from 0 to nearly 1 in a cube along these axes. What lies in its middle is in no middle of cells,
// where rounding would decide.
std::vector<Vector3> inCube(std::vector<Vector3> points, const std::vector<char>& measured)
{
  constexpr double beside = 0.0137, room = 1.0371;
  const auto scale = [&](std::vector<Vector3>& of)
  {
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (std::size_t i = 0; i < of.size(); ++i)
    {
      low = measured[i] ? low.cwiseMin(of[i]) : low;
      high = measured[i] ? high.cwiseMax(of[i]) : high;
    }
    const double extent = (high - low).maxCoeff();
    for (Vector3& p : of)
    {
      p = extent > 0.0 ? Vector3((p - low) / extent) : Vector3::Zero();
    }
  };
  scale(points);
  std::vector<Vector3> chosen;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (measured[i])
    {
      chosen.push_back(points[i]);
    }
  }
  const Eigen::Matrix3d axes = axesOf(chosen);
  for (Vector3& p : points)
  {
    p = axes * p;
  }
  scale(points);
  for (Vector3& p : points)
  {
    p = (p + Vector3::Constant(beside)) / room;
  }
  return points;
}

} // namespace

Cutout::Cutout(const Mesh& whole, const std::vector<char>& wholeActive)
  : vertexOf(whole.points.size(), -1)
{
  std::vector<char> inside(whole.points.size(), 0);
  for (int t = 0; t < whole.triangleCount(); ++t)
  {
    for (int k = 0; wholeActive[t] && k < 3; ++k)
    {
      inside[whole.triangles[t][k]] = 1;
    }
  }
  std::vector<int> chosen;
  std::vector<char> near(whole.points.size(), 0); // corners of these
  for (int t = 0; t < whole.triangleCount(); ++t)
  {
    const Triangle& c = whole.triangles[t];
    if (inside[c[0]] || inside[c[1]] || inside[c[2]])
    {
      chosen.push_back(t);
      near[c[0]] = near[c[1]] = near[c[2]] = 1;
    }
  }
  std::vector<int> number(whole.points.size());
  std::vector<Vector3> points;
  std::vector<char> measured;
  for (int v = 0; v < whole.vertexCount(); ++v)
  {
    if (near[v])
    {
      number[v] = static_cast<int>(points.size());
      points.push_back(whole.points[v]);
      measured.push_back(inside[v]);
    }
  }
  // Cells along a Z curve.
  const std::vector<Vector3> places = inCube(std::move(points), measured);
  const auto placeOf = [&](int t, int corner) -> const Vector3&
  { return places[number[whole.triangles[t][corner]]]; };
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
      const double x = placeOf(t, 0)[k] * cells;
      cell |= spreads[static_cast<int>(std::clamp(x, 0.0, cells - 1.0))] << k;
    }
    return cell;
  };
  std::vector<std::uint32_t> cellOfChosen;
  cellOfChosen.reserve(chosen.size());
  std::vector<int> offsets(std::size_t(cells) * cells * cells + 1, 0);
  for (const int t : chosen)
  {
    cellOfChosen.push_back(cellOf(t));
    ++offsets[cellOfChosen.back() + 1];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  this->triangles.resize(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    this->triangles[offsets[cellOfChosen[i]]++] = chosen[i];
  }
  // Within a cell by where they lie, on a slant that puts no two symmetrical ones beside each other:
  // remeshing is the same in whatever order the triangles come.
  const Vector3 slant(0.5317, 0.7366, 0.4179);
  const auto earlier = [&](int t, int u)
  {
    const auto key = [&](int of)
    { return std::make_tuple(slant.dot(placeOf(of, 0)), slant.dot(placeOf(of, 1)), of); };
    return key(t) < key(u);
  };
  for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell)
  {
    const int begin = cell > 0 ? offsets[cell - 1] : 0;
    std::sort(this->triangles.begin() + begin, this->triangles.begin() + offsets[cell], earlier);
  }
  // Vertices as the triangles meet them.
  this->active = valuesAt(wholeActive, this->triangles);
  this->mesh.triangles = valuesAt(whole.triangles, this->triangles);
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
  this->mesh.points = valuesAt(whole.points, this->vertices);
}

} // namespace oversketch
