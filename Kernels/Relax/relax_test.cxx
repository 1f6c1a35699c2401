// Relaxing along a curve: the law of what goes and what stays, noise on a sphere, limbs, borders and edges.
#include "Relax/relax.h"

#include "Harness/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace oversketch;
using oversketch_test::fact;
using oversketch_test::pi;

namespace
{

// A line on a mesh: each place goes to the nearest middle of a triangle.
FeatureCurve lineOn(const Mesh& mesh, const std::vector<Vector3>& places)
{
  FeatureCurve curve;
  for (const Vector3& place : places)
  {
    int nearest = 0;
    Vector3 at = Vector3::Constant(1e9);
    for (int t = 0; t < mesh.triangleCount(); ++t)
    {
      const Triangle& c = mesh.triangles[t];
      const Vector3 middle = (mesh.points[c[0]] + mesh.points[c[1]] + mesh.points[c[2]]) / 3.0;
      if ((middle - place).squaredNorm() < (at - place).squaredNorm())
      {
        at = middle;
        nearest = t;
      }
    }
    curve.points.push_back(at);
    curve.normals.push_back(facetNormal(mesh, nearest));
    curve.cells.push_back(nearest);
  }
  curve.measure();
  return curve;
}

std::vector<Vector3> arc(double from, double to, double radius)
{
  std::vector<Vector3> places;
  for (int i = 0; i <= 40; ++i)
  {
    const double angle = from + (to - from) * i / 40.0;
    places.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return places;
}

Mesh moved(const Mesh& mesh, const RelaxBand& band)
{
  Mesh result = mesh;
  const std::vector<Vector3> places = relaxed(band);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    result.points[band.part.vertices[i]] = places[i];
  }
  return result;
}

double volume(const Mesh& mesh)
{
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    sum += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6.0;
  }
  return sum;
}

// An icosphere with noise along its normals, of a mean square of `share`^2.
Mesh roughSphere(int levels, double share)
{
  Mesh mesh = oversketch_test::icosphere(levels);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-std::sqrt(3.0) * share, std::sqrt(3.0) * share);
  for (Vector3& p : mesh.points)
  {
    p *= 1.0 + noise(random);
  }
  return mesh;
}

// Root of the mean square of what lies above and below the unit sphere, of points with a share of the way.
double roughnessOf(const Mesh& mesh, const RelaxBand& band, double share = 0.0)
{
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < band.part.vertices.size(); ++i)
  {
    if (band.share[i] > share)
    {
      const double off = mesh.points[band.part.vertices[i]].norm() - 1.0;
      sum += off * off;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

} // namespace

// By the energy's own first variation a wave of number k keeps 1 / (1 + (k scale)^4) of its height.
TEST(Relax, AWaveKeepsWhatTheEnergyLeavesOfIt)
{
  constexpr int columns = 240, rows = 120;
  constexpr double scale = 6.0, height = 0.01; // of edges
  for (const double length : { 15.0, 30.0, 60.0 })
  {
    const double k = 2.0 * pi / length;
    const Mesh mesh = oversketch_test::gridSurface(columns,
      rows,
      false,
      false,
      [&](double u, double v)
      {
        const double x = columns * u - 0.5 * rows * v, y = 0.5 * std::sqrt(3.0) * rows * v;
        return Vector3(x, y, height * std::cos(k * x));
      });
    std::vector<char> inside(mesh.points.size(), 0);
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      const int i = v % (columns + 1), j = v / (columns + 1);
      inside[v] = i > 0 && i < columns && j > 0 && j < rows;
    }
    RelaxBand band{ MeshPart(mesh, inside), {}, {}, {} };
    band.weight.assign(band.part.vertices.size(), 1.0);
    band.share.assign(band.part.vertices.size(), 1.0);
    band.scale.assign(band.part.vertices.size(), scale);
    const Mesh result = moved(mesh, band);
    // Along the middle row, eight scales off its ends; the rim's hold has died away there.
    double sum = 0.0, squares = 0.0;
    for (int i = 60; i <= 180; ++i)
    {
      const Vector3& p = result.points[(rows / 2) * (columns + 1) + i];
      sum += p[2] * std::cos(k * p[0]);
      squares += height * std::pow(std::cos(k * p[0]), 2);
    }
    const double expected = 1.0 / (1.0 + std::pow(k * scale, 4));
    EXPECT_NEAR(sum / squares, expected, 0.02) << "a wave " << length << " edges long";
  }
}

TEST(Relax, NoiseOnASphereGoesAndAllElseStays)
{
  for (const int levels : { 4, 5, 6 })
  {
    const Mesh mesh = roughSphere(levels, 0.02);
    RelaxOptions options;
    options.radius = 0.25;
    const RelaxBand band = relaxBand(mesh, { lineOn(mesh, arc(0.0, 1.5, 1.0)) }, options);
    const Mesh result = moved(mesh, band);
    const auto kept = [&](double share)
    { return roughnessOf(result, band, share) / roughnessOf(mesh, band, share); };
    fact("relax noise kept, icosphere " + std::to_string(levels),
      std::to_string(kept(0.999)) + ", with the rim where it fades " + std::to_string(kept(0.0)));
    EXPECT_LT(kept(0.999), 1.0 / 3.0);
    EXPECT_LT(kept(0.0), 0.45);
    EXPECT_NEAR(volume(result), volume(mesh), 0.005 * volume(mesh));
    std::vector<char> may(mesh.points.size(), 0);
    for (std::size_t i = 0; i < band.part.vertices.size(); ++i)
    {
      may[band.part.vertices[i]] = band.share[i] > 0.0;
    }
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      ASSERT_TRUE(may[v] || result.points[v] == mesh.points[v]) << v;
      ASSERT_TRUE(!may[v] || result.points[v] != mesh.points[v]) << v;
    }
    // All that lie well within reach are in the band: no spike stays.
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      const double angle = std::atan2(mesh.points[v][1], mesh.points[v][0]);
      const bool inReach =
        angle > 0.1 && angle < 1.4 && std::abs(mesh.points[v][2]) < 0.2 && mesh.points[v].norm() > 0.5;
      EXPECT_TRUE(may[v] || !inReach) << v;
    }
  }
}

TEST(Relax, ASmoothSurfaceStaysWhereItIs)
{
  const Mesh mesh = oversketch_test::icosphere(5);
  RelaxOptions options;
  options.radius = 0.2;
  const RelaxBand band = relaxBand(mesh, { lineOn(mesh, arc(0.0, 1.5, 1.0)) }, options);
  EXPECT_LT(roughnessOf(moved(mesh, band), band), 0.001);
}

TEST(Relax, ALineThatWasRaisedIsGoneInOnePass)
{
  Mesh mesh = oversketch_test::icosphere(6);
  constexpr double radius = 0.1, height = 0.05;
  for (Vector3& p : mesh.points)
  {
    const double away = std::asin(std::clamp(p[2], -1.0, 1.0));
    if (p[0] > 0.0 && std::abs(away) < radius)
    {
      p *= 1.0 + height * std::pow(1.0 - std::abs(away) / radius, 2);
    }
  }
  RelaxOptions options;
  options.radius = radius;
  const RelaxBand band = relaxBand(mesh, { lineOn(mesh, arc(-0.8, 0.8, 1.0)) }, options);
  const Mesh result = moved(mesh, band);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Vector3& p = result.points[v];
    if (p[0] > 0.8 && std::abs(p[2]) < radius)
    {
      EXPECT_LT(p.norm() - 1.0, 0.1 * height) << v;
    }
  }
}

TEST(Relax, ALimbThinnerThanTheBandKeepsItsGirth)
{
  const double thickness = 0.1;
  const Mesh mesh = oversketch_test::cylinder(thickness, 3.0, 40, 200);
  std::vector<Vector3> places;
  for (int i = 0; i <= 60; ++i)
  {
    places.emplace_back(thickness, 0.0, 1.0 + i / 60.0);
  }
  FeatureCurve curve = lineOn(mesh, places);
  curve.room.assign(curve.points.size(), { 2.0 * thickness, 1e9 });
  RelaxOptions options;
  options.radius = 3.0 * thickness;
  const RelaxBand band = relaxBand(mesh, { curve }, options);
  const Mesh result = moved(mesh, band);
  double least = 1.0, most = 0.0;
  for (const Vector3& p : result.points)
  {
    least = std::min(least, p.head<2>().norm() / thickness);
    most = std::max(most, p.head<2>().norm() / thickness);
  }
  EXPECT_GT(least, 0.9);
  EXPECT_LT(most, 1.05);
}

TEST(Relax, TheOtherSideOfAThinSheetStays)
{
  // Two sheets back to back, joined nowhere: only the one that carries the line moves.
  const auto sheet = [](double z)
  {
    return oversketch_test::gridSurface(40,
      40,
      false,
      false,
      [z](double u, double v) { return Vector3(u, v, z + 0.003 * std::sin(60.0 * u) * std::sin(50.0 * v)); });
  };
  const Mesh upper = sheet(0.0);
  const Mesh mesh = oversketch_test::joined(upper, sheet(0.0), { 0.0, 0.0, -0.01 });
  std::vector<Vector3> places;
  for (int i = 0; i <= 20; ++i)
  {
    places.emplace_back(0.3 + 0.02 * i, 0.5, 0.01);
  }
  RelaxOptions options;
  options.radius = 0.1;
  const RelaxBand band = relaxBand(mesh, { lineOn(mesh, places) }, options);
  ASSERT_FALSE(marked(band.part.region).empty());
  for (const int i : marked(band.part.region))
  {
    EXPECT_LT(band.part.vertices[i], upper.vertexCount());
  }
}

TEST(Relax, BordersStayAndEdgesWhereThatIsAsked)
{
  // A roof of 60 degrees: its ridge and its border.
  const Mesh mesh = oversketch_test::gridSurface(40,
    40,
    false,
    false,
    [](double u, double v)
    { return Vector3(u, v, 0.5 * std::sqrt(3.0) - std::sqrt(3.0) * std::abs(u - 0.5)); });
  std::vector<Vector3> places;
  for (int i = 0; i <= 20; ++i)
  {
    places.emplace_back(0.5, i / 20.0, 0.87);
  }
  RelaxOptions options;
  options.radius = 0.2;
  const FeatureCurves curves{ lineOn(mesh, places) };
  const auto ridgeOf = [&](double angle)
  {
    options.featureAngle = angle;
    const Mesh result = moved(mesh, relaxBand(mesh, curves, options));
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      const Vector3& p = mesh.points[v];
      if (p[0] == 0.0 || p[0] == 1.0 || p[1] == 0.0 || p[1] == 1.0)
      {
        EXPECT_EQ(result.points[v], p) << v;
      }
    }
    return result.points[20 * 41 + 20][2];
  };
  const double top = mesh.points[20 * 41 + 20][2];
  EXPECT_LT(ridgeOf(180.0), top - 0.01);
  EXPECT_EQ(ridgeOf(30.0), top);
}

TEST(Relax, StrengthAndPressureAreSharesOfTheWay)
{
  const Mesh mesh = roughSphere(4, 0.02);
  FeatureCurve curve = lineOn(mesh, arc(0.0, 1.5, 1.0));
  RelaxOptions options;
  options.radius = 0.25;
  const Mesh whole = moved(mesh, relaxBand(mesh, { curve }, options));
  options.strength = 0.25;
  const Mesh quarter = moved(mesh, relaxBand(mesh, { curve }, options));
  options.strength = 1.0;
  curve.pressure.assign(curve.points.size(), 0.25);
  const Mesh pressed = moved(mesh, relaxBand(mesh, { curve }, options));
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Vector3 expected = mesh.points[v] + 0.25 * (whole.points[v] - mesh.points[v]);
    EXPECT_LT((quarter.points[v] - expected).norm(), 1e-14);
    EXPECT_LT((pressed.points[v] - expected).norm(), 1e-14);
  }
}

// Two lines of unlike pressure that meet, as branches of a drawing do.
TEST(Relax, WhereLinesMeetNoTriangleTurnsOver)
{
  const Mesh mesh = roughSphere(6, 0.003);
  FeatureCurve hard = lineOn(mesh, arc(-0.8, 0.0, 1.0)), soft = lineOn(mesh, arc(0.0, 0.8, 1.0));
  hard.pressure.assign(hard.points.size(), 0.9);
  soft.pressure.assign(soft.points.size(), 0.1);
  RelaxOptions options;
  options.radius = 0.2;
  const Mesh result = moved(mesh, relaxBand(mesh, { hard, soft }, options));
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    EXPECT_GT(facetNormal(mesh, t).dot(facetNormal(result, t)), 0.5) << t;
  }
}

TEST(Relax, FarFromTheOriginAndOfAnySizeItIsTheSame)
{
  const Mesh mesh = roughSphere(4, 0.02);
  RelaxOptions options;
  options.radius = 0.25;
  const FeatureCurve curve = lineOn(mesh, arc(0.0, 1.5, 1.0));
  const Mesh here = moved(mesh, relaxBand(mesh, { curve }, options));
  const double size = 1000.0;
  const Vector3 shift(2e5, -1e5, 3e5);
  Mesh there = mesh;
  for (Vector3& p : there.points)
  {
    p = size * p + shift;
  }
  FeatureCurve far = curve;
  for (Vector3& p : far.points)
  {
    p = size * p + shift;
  }
  far.measure();
  options.radius *= size;
  const Mesh result = moved(there, relaxBand(there, { far }, options));
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_LT(((result.points[v] - shift) / size - here.points[v]).norm(), 1e-9) << v;
  }
}

TEST(Relax, WhatIsNoBandIsRefused)
{
  const Mesh mesh = oversketch_test::icosphere(3);
  FeatureCurve curve = lineOn(mesh, arc(0.0, 1.5, 1.0));
  RelaxOptions options;
  EXPECT_THROW(relaxBand(mesh, { curve }, options), Error); // no radius
  options.radius = 0.3;
  curve.cells.clear();
  EXPECT_THROW(relaxBand(mesh, { curve }, options), Error);
}
