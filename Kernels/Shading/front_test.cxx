// The front over a surface beside distances that are known.
#include "Shading/fields.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace oversketch;

namespace
{

// A square of [-1, 1]^2 whose inner vertices lie off the grid, but for the rows y = 0 and columns x = 0.5
// that stay straight; and a chain on y = 0.
struct Sheet
{
  static constexpr double halfCurve = 0.3;
  Mesh mesh;
  std::vector<int> chain;
  double edge;

  explicit Sheet(int side)
    : edge(2.0 / side)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> off(-0.3 * this->edge, 0.3 * this->edge);
    for (int j = 0; j <= side; ++j)
    {
      for (int i = 0; i <= side; ++i)
      {
        const bool onRow = 2 * j == side, onColumn = 4 * i == 3 * side;
        const bool inside = i > 0 && i < side && j > 0 && j < side;
        const double dx = off(random), dy = off(random);
        this->mesh.points.emplace_back(-1.0 + i * this->edge + (inside && !onColumn ? dx : 0.0),
          -1.0 + j * this->edge + (inside && !onRow ? dy : 0.0),
          0.0);
        if (onRow && std::abs(-1.0 + i * this->edge) < halfCurve)
        {
          this->chain.push_back(this->mesh.vertexCount() - 1);
        }
        if (i < side && j < side)
        {
          const int a = j * (side + 1) + i, b = a + 1, c = b + side + 1, d = a + side + 1;
          this->mesh.triangles.push_back({ a, b, (i + j) % 2 ? d : c });
          this->mesh.triangles.push_back({ (i + j) % 2 ? b : a, c, d });
        }
      }
    }
  }
  std::vector<double> distances() const
  {
    return chainDistances(this->mesh, buildAdjacency(this->mesh), this->chain, false, false, {}).distance;
  }
  double exact(int v) const
  {
    const Vector3 &p = this->mesh.points[v], &a = this->mesh.points[this->chain.front()],
                  &b = this->mesh.points[this->chain.back()];
    return std::hypot(p[1], std::max({ 0.0, a[0] - p[0], p[0] - b[0] }));
  }
};

// How far off they are where that is most, where they are at least two edges.
double worst(const Sheet& sheet, const std::vector<double>& distances, double within)
{
  double most = 0.0;
  for (int v = 0; v < sheet.mesh.vertexCount(); ++v)
  {
    const double exact = sheet.exact(v);
    if (exact >= 2.0 * sheet.edge && std::abs(sheet.mesh.points[v][0]) <= within)
    {
      most = std::max(most, std::abs(distances[v] - exact) / exact);
    }
  }
  return most;
}

} // namespace

TEST(Front, BesideAStraightCurveAndRoundItsEnds)
{
  const Sheet sheet(40);
  const std::vector<double> distances = sheet.distances();
  EXPECT_LT(worst(sheet, distances, 0.5 * Sheet::halfCurve), 0.003);
  EXPECT_LT(worst(sheet, distances, 1.0), 0.01);
}

// What a fold does not change: the surface is as long as before, only space is shorter.
TEST(Front, AFoldChangesNoDistance)
{
  const Sheet flat(40);
  Sheet folded = flat;
  for (Vector3& p : folded.mesh.points)
  {
    if (p[0] > 0.5)
    {
      p = { 0.5, p[1], p[0] - 0.5 };
    }
  }
  EXPECT_LT(worst(flat, folded.distances(), 1.0), 0.01);
}

// Two fronts that meet: round a cylinder from a line along it, which a straight one would cut through.
TEST(Front, TwoFrontsMeetBehindACylinder)
{
  constexpr int round = 48, along = 30;
  Mesh mesh;
  std::vector<int> chain;
  for (int j = 0; j <= along; ++j)
  {
    for (int i = 0; i < round; ++i)
    {
      const double angle = 2.0 * oversketch_test::pi * i / round;
      mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0.1 * j);
      if (j < along)
      {
        const int a = j * round + i, b = j * round + (i + 1) % round;
        mesh.triangles.push_back({ a, b, b + round });
        mesh.triangles.push_back({ a, b + round, a + round });
      }
    }
    chain.push_back(j * round);
  }
  const std::vector<double> distances =
    chainDistances(mesh, buildAdjacency(mesh), chain, false, false, {}).distance;
  const double chord = 2.0 * std::sin(oversketch_test::pi / round);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const int turn = std::min(v % round, round - v % round);
    EXPECT_NEAR(distances[v], turn * chord, 1e-9);
  }
}
