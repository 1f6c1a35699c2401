#include "Silhouette/relocation.h"
#include "Silhouette/snake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace oversketch;

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr double epsilon = 0.2;

// A snaxel on an edge of about unit length between two neighbours, near a contour seen from above.
struct Case
{
  Vector3 ends[2], normals[2];
  CurvePoint before, at, after;
  double low, high;

  explicit Case(std::mt19937& random)
  {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto near = [&](double x, double y, double z, double spread)
    {
      return Vector3(x + spread * (unit(random) - 0.5),
        y + spread * (unit(random) - 0.5),
        z + spread * (unit(random) - 0.5));
    };
    this->ends[0] = near(0, 0, -0.5, 0.4);
    this->ends[1] = near(0, 0, 0.5, 0.4);
    for (Vector3& n : this->normals)
    {
      n = near(1, 0, 0, 0.5).normalized();
    }
    this->before.position = near(0, -1, 0, 0.8);
    this->after.position = near(0, 1, 0, 0.8);
    this->low = unit(random) < 0.5 ? 0.0 : 0.4 * unit(random);
    this->high = unit(random) < 0.5 ? 1.0 : 0.6 + 0.4 * unit(random);
    const double t = unit(random);
    this->at = this->pointAt(this->low + t * (this->high - this->low));
  }

  CurvePoint pointAt(double t) const
  {
    CurvePoint p;
    p.position = (1.0 - t) * this->ends[0] + t * this->ends[1];
    p.normal = ((1.0 - t) * this->normals[0] + t * this->normals[1]).normalized();
    return p;
  }

  void put(Relocations& relocations, int lane) const
  {
    relocations.before.set(lane, this->before.position);
    relocations.after.set(lane, this->after.position);
    relocations.at.set(lane, this->at.position);
    relocations.normal.set(lane, this->at.normal);
    for (int k = 0; k < 2; ++k)
    {
      relocations.ends[k].set(lane, this->ends[k]);
      relocations.endNormals[k].set(lane, this->normals[k]);
    }
    relocations.low[lane] = this->low;
    relocations.high[lane] = this->high;
  }
};

} // namespace

TEST(Relocations, GoWhereTheCurveIsStraightOrSayThatTheyDoNotKnow)
{
  std::mt19937 random(7);
  const Vector3 up(0, 0, 1);
  int moves = 0, stays = 0;
  for (int round = 0; round < 500; ++round)
  {
    std::vector<Case> cases;
    Relocations relocations;
    for (int lane = 0; lane < Relocations::lanes; ++lane)
    {
      cases.emplace_back(random);
      cases.back().put(relocations, lane);
    }
    relocations.find(Triple(up), 0.0, epsilon);
    for (int lane = 0; lane < Relocations::lanes; ++lane)
    {
      const Case& c = cases[lane];
      const double bend = pi - smoothness(c.before, c.at, c.after);
      if (relocations.found.verdict[lane] == Relocations::Moves)
      {
        ++moves;
        const double t = 1.0 - relocations.found.weight[lane];
        EXPECT_GE(t, c.low);
        EXPECT_LE(t, c.high);
        CurvePoint there = c.pointAt(t);
        const Triple p = relocations.found.position[lane], n = relocations.found.normal[lane];
        EXPECT_LT((Vector3(p.x, p.y, p.z) - there.position).norm(), 1e-14);
        EXPECT_LT((Vector3(n.x, n.y, n.z) - there.normal).norm(), 1e-14);
        EXPECT_LT(pi - smoothness(c.before, there, c.after), 2e-7);
        EXPECT_LT(std::abs(there.normal.dot(up)), epsilon);
        EXPECT_GT(bend, 1e-4);
      }
      else if (relocations.found.verdict[lane] == Relocations::Stays)
      {
        ++stays;
        EXPECT_LT(bend, 1e-4);
      }
    }
    // A snaxel that has moved stays: its place is straight.
    for (int lane = 0; lane < Relocations::lanes; ++lane)
    {
      if (relocations.found.verdict[lane] == Relocations::Moves)
      {
        cases[lane].at = cases[lane].pointAt(1.0 - relocations.found.weight[lane]);
      }
      cases[lane].put(relocations, lane);
    }
    const Relocations::Found first = relocations.found;
    relocations.find(Triple(up), 0.0, epsilon);
    for (int lane = 0; lane < Relocations::lanes; ++lane)
    {
      if (first.verdict[lane] == Relocations::Moves)
      {
        EXPECT_EQ(relocations.found.verdict[lane], Relocations::Stays);
        ++stays;
      }
    }
  }
  EXPECT_GT(moves, 500);
  EXPECT_GE(stays, moves);
}

TEST(Relocations, ASearchFindsTheStraightestPlace)
{
  std::mt19937 random(8);
  for (int round = 0; round < 2000; ++round)
  {
    const Case c(random);
    const Triple p0(c.ends[0]), n0(c.normals[0]);
    const EdgeSmoothness energy(Triple(c.before.position) - p0,
      Triple(c.after.position) - p0,
      Triple(c.ends[1]) - p0,
      n0,
      Triple(c.normals[1]) - n0);
    const double best = searchStraightest(energy, c.low, c.high);
    ASSERT_GE(best, c.low);
    ASSERT_LE(best, c.high);
    const double reached = smoothness(c.before, c.pointAt(best), c.after);
    for (int k = 0; k <= 1000; ++k)
    {
      const double t = c.low + 0.001 * k * (c.high - c.low);
      EXPECT_GE(reached, smoothness(c.before, c.pointAt(t), c.after) - 1e-3);
    }
  }
}
