// Facts of editors.md, section 13, flatten and texture: the fields.
#include "Shading/fields.h"

#include "Harness/threads.h"
#include "Mesh/context.h"
#include "Shading/layers.h"
#include "Shading/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A patch with its reference curve.
struct Drawn
{
  Mesh patch;
  std::vector<int> reference;
};

// |x| <= 10, |y| <= 1, the curve on y = 0, |x| <= 8.
Drawn strip(int along, int across)
{
  Drawn drawn{ gridSurface(along,
                 across,
                 false,
                 false,
                 [](double u, double v) { return Vector3(20.0 * u - 10.0, 2.0 * v - 1.0, 0.0); }),
    {} };
  for (int i = along / 10; i <= along - along / 10; ++i)
  {
    drawn.reference.push_back(across / 2 * (along + 1) + i);
  }
  return drawn;
}

// A hill of side x side quads with uneven triangles, an S over its top.
Drawn hill(int side)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> value(-0.25, 0.25);
  Drawn drawn;
  drawn.patch = gridSurface(side,
    side,
    false,
    false,
    [&](double u, double v)
    {
      const double x = 2.0 * u - 1.0 + 2.0 * value(random) / side,
                   y = 2.0 * v - 1.0 + 2.0 * value(random) / side;
      return Vector3(x, y, 0.8 * std::exp(-2.0 * (x * x + y * y)));
    });
  const int margin = side / 4;
  for (int i = margin; i <= side - margin; ++i)
  {
    drawn.reference.push_back(side / 2 * (side + 1) + i);
  }
  return drawn;
}

// Three quarters of a circle on a sphere of 20,000 triangles, down to 100 degrees from the pole.
Drawn hook()
{
  const int rings = 50, sectors = 200;
  Drawn drawn;
  drawn.patch.points.emplace_back(0, 0, 1);
  for (int r = 1; r <= rings; ++r)
  {
    const double down = r * 100.0 / rings * pi / 180.0;
    for (int s = 0; s < sectors; ++s)
    {
      const double round = 2.0 * pi * s / sectors;
      drawn.patch.points.emplace_back(
        std::sin(down) * std::cos(round), std::sin(down) * std::sin(round), std::cos(down));
    }
  }
  const auto id = [=](int r, int s) { return r == 0 ? 0 : 1 + (r - 1) * sectors + s % sectors; };
  for (int r = 0; r < rings; ++r)
  {
    for (int s = 0; s < sectors; ++s)
    {
      drawn.patch.triangles.push_back({ id(r, s), id(r + 1, s), id(r + 1, s + 1) });
      if (r > 0)
      {
        drawn.patch.triangles.push_back({ id(r, s), id(r + 1, s + 1), id(r, s + 1) });
      }
    }
  }
  for (int s = 0; s <= 3 * sectors / 4; ++s)
  {
    drawn.reference.push_back(id(rings / 2, s));
  }
  return drawn;
}

std::vector<double> weightsOf(const CurveFields& fields, Falloff falloff)
{
  const Layers layers;
  std::vector<double> weights;
  for (const double s : fields.share)
  {
    weights.push_back(layers.weight(s, falloff));
  }
  return weights;
}

// Of a value, how steeply it rises from an edge into a triangle; and its gradient.
Vector3 gradient(const Mesh& mesh, const Triangle& t, const std::vector<double>& w)
{
  const Vector3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
  const Vector3 n = (b - a).cross(c - a);
  return (w[t[0]] * n.cross(c - b) + w[t[1]] * n.cross(a - c) + w[t[2]] * n.cross(b - a)) / n.squaredNorm();
}

// Medians of the slope's jump over the edges of both curves, over the mean slope of the patch.
std::pair<double, double> slopeJumps(const Drawn& drawn, const std::vector<double>& w)
{
  const Adjacency adjacency = buildAdjacency(drawn.patch);
  double slope = 0.0, area = 0.0;
  for (const Triangle& t : drawn.patch.triangles)
  {
    const std::vector<Vector3>& p = drawn.patch.points;
    const double a = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
    slope += a * gradient(drawn.patch, t, w).norm();
    area += a;
  }
  const auto jump = [&](int edge)
  {
    const MeshEdge& e = adjacency.edges[edge];
    double sum = 0.0;
    for (const int* t = adjacency.trianglesBegin(edge); t != adjacency.trianglesEnd(edge); ++t)
    {
      const Triangle& c = drawn.patch.triangles[*t];
      const int v = c[0] != e.v0 && c[0] != e.v1 ? c[0] : c[1] != e.v0 && c[1] != e.v1 ? c[1] : c[2];
      const Vector3 along = (drawn.patch.points[e.v1] - drawn.patch.points[e.v0]).normalized();
      const Vector3 away = drawn.patch.points[v] - drawn.patch.points[e.v0];
      sum += gradient(drawn.patch, c, w).dot((away - away.dot(along) * along).normalized());
    }
    return std::abs(sum) / (slope / area);
  };
  std::vector<double> inner, outer;
  for (std::size_t i = 1; i < drawn.reference.size(); ++i)
  {
    inner.push_back(jump(adjacency.findEdge(drawn.reference[i - 1], drawn.reference[i])));
  }
  for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
  {
    if (adjacency.edges[e].triangleCount == 1)
    {
      outer.push_back(jump(e));
    }
  }
  std::sort(inner.begin(), inner.end());
  std::sort(outer.begin(), outer.end());
  return { inner[inner.size() / 2], outer[outer.size() / 2] };
}

double largestStep(const Drawn& drawn, const std::vector<double>& values)
{
  double largest = 0.0;
  for (const MeshEdge& e : buildAdjacency(drawn.patch).edges)
  {
    largest = std::max(largest, std::abs(values[e.v0] - values[e.v1]));
  }
  return largest;
}

} // namespace

TEST(B6_2, AStripFallsEvenly)
{
  const Drawn drawn = strip(200, 20);
  double worst[2] = {}, smooth = 0.0;
  for (const bool filtered : { false, true })
  {
    FieldRules rules;
    rules.straight = true;
    rules.smoothing = filtered ? 0.15 : 0.0;
    const CurveFields fields = curveFields(drawn.patch, drawn.reference, rules, {});
    const std::vector<double> linear = weightsOf(fields, Falloff::Linear),
                              cubic = weightsOf(fields, Falloff::Smooth);
    for (int v = 0; v < drawn.patch.vertexCount(); ++v)
    {
      const Vector3& p = drawn.patch.points[v];
      const double y = std::abs(p[1]);
      if (std::abs(p[0]) <= 5.0)
      {
        worst[filtered] = std::max(worst[filtered], std::abs(linear[v] - (1.0 - y)));
        smooth = std::max(smooth, std::abs(cubic[v] - (1.0 - 3.0 * y * y + 2.0 * y * y * y)));
        if (std::abs(y - 0.5) < 1e-9)
        {
          // On the border of nothing: half way is within the third of five levels.
          EXPECT_EQ(Layers().grey(Layers().level(fields.share[v])), 128);
        }
      }
    }
  }
  EXPECT_LT(worst[0], 1e-9);
  EXPECT_LT(worst[1], 1e-6);
  EXPECT_LT(smooth, 2e-6);
  fact("B6_2",
    "strip, straight distances: w = 1 - abs(y) within " + std::to_string(worst[0] * 1e9) + "e-9, smoothed " +
      std::to_string(worst[1] * 1e9) + "e-9, and 1 - 3 y^2 + 2 abs(y)^3; half way is grey 128");
}

TEST(B6_4, NoEdgeAlongTheCurves)
{
  std::string said;
  for (const int side : { 36, 72 })
  {
    const Drawn drawn = hill(side);
    const CurveFields fields = curveFields(drawn.patch, drawn.reference, {}, {});
    FieldRules published;
    published.smoothing = 0.0;
    const CurveFields rough = curveFields(drawn.patch, drawn.reference, published, {});
    const std::vector<double> w = weightsOf(fields, Falloff::Smooth),
                              linear = weightsOf(rough, Falloff::Linear);
    for (std::size_t v = 0; v < w.size(); ++v)
    {
      EXPECT_GE(fields.share[v], 0.0);
      EXPECT_LE(fields.share[v], 1.0);
    }
    for (const int v : drawn.reference)
    {
      EXPECT_EQ(w[v], 1.0);
      EXPECT_EQ(linear[v], 1.0);
    }
    for (int v = 0; v < drawn.patch.vertexCount(); ++v)
    {
      const Vector3& p = drawn.patch.points[v];
      if (v % (side + 1) == 0 || v <= side)
      {
        EXPECT_EQ(w[v], 0.0) << p;
      }
    }
    const auto [inner, outer] = slopeJumps(drawn, w);
    const auto [innerLinear, outerLinear] = slopeJumps(drawn, linear);
    EXPECT_GE(innerLinear, 1.8);
    EXPECT_LE(innerLinear, 2.7);
    EXPECT_GE(outerLinear, 0.85);
    EXPECT_LE(outerLinear, 1.1);
    const bool many = drawn.patch.vertexCount() >= 4000;
    EXPECT_LE(inner, many ? 0.4 : 1.1);
    EXPECT_LE(outer, many ? 0.15 : 0.3);
    said += (said.empty() ? "" : "; ") + std::to_string(drawn.patch.vertexCount()) +
            " vertices: slope jump at the line " + std::to_string(innerLinear) + " to " +
            std::to_string(inner) + ", at the ring " + std::to_string(outerLinear) + " to " +
            std::to_string(outer);
  }
  fact("B6_4", said);
}

TEST(B6_5, TheParameterIsNotTorn)
{
  const Drawn drawn = hook();
  FieldRules published;
  published.parameterSmoothing = 0.0;
  const CurveFields torn = curveFields(drawn.patch, drawn.reference, published, {}),
                    fields = curveFields(drawn.patch, drawn.reference, {}, {});
  const double before = largestStep(drawn, torn.parameter), after = largestStep(drawn, fields.parameter);
  EXPECT_GE(before, 0.9);
  EXPECT_LE(after, 0.25);
  for (std::size_t i = 0; i < drawn.reference.size(); ++i)
  {
    EXPECT_NEAR(fields.parameter[drawn.reference[i]],
      static_cast<double>(i) / static_cast<double>(drawn.reference.size() - 1),
      1e-9);
  }
  fact("B6_5",
    "three quarters of a circle on a sphere: largest step of the parameter over an edge " +
      std::to_string(before) + " as published, " + std::to_string(after) + " smoothed");
}

TEST(Fields, DistancesOnASphere)
{
  // From a parallel of the hook's sphere, closed: the angle from it.
  const Drawn drawn = hook();
  const Adjacency adjacency = buildAdjacency(drawn.patch);
  std::vector<int> parallel;
  for (int s = 0; s < 200; ++s)
  {
    parallel.push_back(1 + 24 * 200 + s);
  }
  const ChainDistances found = chainDistances(drawn.patch, adjacency, parallel, true, false, {});
  double worst = 0.0;
  for (int v = 0; v < drawn.patch.vertexCount(); ++v)
  {
    const double down = std::acos(std::clamp(drawn.patch.points[v][2], -1.0, 1.0));
    const double exact = std::abs(down - 50.0 * pi / 180.0);
    worst = std::max(worst, std::abs(found.distance[v] - exact));
  }
  EXPECT_LT(worst, 0.01);
  // Through space it is shorter.
  const ChainDistances chords = chainDistances(drawn.patch, adjacency, parallel, true, true, {});
  for (int v = 0; v < drawn.patch.vertexCount(); ++v)
  {
    EXPECT_LE(chords.distance[v], found.distance[v]);
  }
  EXPECT_NEAR(chords.distance[0], 2.0 * std::sin(25.0 * pi / 180.0), 1e-3);
}

TEST(Fields, ThreadsChangeNoBit)
{
  const Drawn drawn = hill(40);
  const CurveFields one = curveFields(drawn.patch, drawn.reference, {}, {}),
                    two = curveFields(drawn.patch, drawn.reference, {}, twoThreads());
  EXPECT_EQ(one.share, two.share);
  EXPECT_EQ(one.parameter, two.parameter);
  Context stop;
  stop.cancelled = [] { return true; };
  EXPECT_THROW(curveFields(drawn.patch, drawn.reference, {}, stop), Error);
}

TEST(Fields, ReferencesThatAreNone)
{
  const Drawn drawn = strip(40, 4);
  const auto refused = [&](const std::vector<int>& reference)
  {
    try
    {
      curveFields(drawn.patch, reference, {}, {});
      return false;
    }
    catch (const Error& error)
    {
      return error.failure() == Failure::BadStroke;
    }
  };
  const int a = drawn.reference[3], b = drawn.reference[4], far = drawn.reference[9];
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused({ a }));
  EXPECT_TRUE(refused({ a, far }));
  EXPECT_TRUE(refused({ a, -1 }));
  EXPECT_TRUE(refused({ a, 100000 }));
  EXPECT_TRUE(refused({ 0, 1 })); // on the boundary
  EXPECT_FALSE(refused({ a, b }));
}
