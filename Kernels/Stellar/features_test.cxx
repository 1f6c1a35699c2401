// Snapping and displacing on real meshes, one after the other.
#include "Stellar/displace.h"
#include "Stellar/feature_shapes.h"
#include "Stellar/quality.h"
#include "Stellar/smooth.h"
#include "Stellar/snap.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A curve of the plane z = 0, in units of the model's half size, seen along -z: on the nearest face that it
// meets, cut where it meets none.
FeatureCurves drawnOn(const Mesh& mesh, const std::vector<Vector2>& stroke)
{
  Eigen::AlignedBox3d box;
  for (const Vector3& p : mesh.points)
    box.extend(p);
  const Vector3 middle = box.center();
  const double size = 0.5 * box.diagonal().norm();
  FeatureCurves curves;
  std::vector<Vector3> points, normals;
  const auto cut = [&]
  {
    if (points.size() > 1)
    {
      curves.push_back(featureCurve(points));
      curves.back().normals = normals;
    }
    points.clear();
    normals.clear();
  };
  for (const Vector2& at : stroke)
  {
    const double x = middle.x() + size * at.x(), y = middle.y() + size * at.y();
    double best = -std::numeric_limits<double>::infinity();
    int hit = -1;
    for (int i = 0; i < mesh.triangleCount(); ++i)
    {
      const Triangle& t = mesh.triangles[i];
      const Vector3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
      const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
      const double v = ((x - a.x()) * (c.y() - a.y()) - (y - a.y()) * (c.x() - a.x())) / area;
      const double w = ((b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x())) / area;
      const double z = a.z() + v * (b.z() - a.z()) + w * (c.z() - a.z());
      if (v >= 0.0 && w >= 0.0 && v + w <= 1.0 && z > best)
      {
        best = z;
        hit = i;
      }
    }
    if (hit < 0 || (!points.empty() && (Vector3(x, y, best) - points.back()).norm() > 0.02 * size))
      cut();
    if (hit >= 0)
    {
      points.emplace_back(x, y, best);
      normals.push_back(facetNormal(mesh, hit));
    }
  }
  cut();
  return curves;
}

std::vector<Vector2> strokeNamed(const std::string& name)
{
  std::vector<Vector2> stroke;
  for (int i = 0; i <= 400; ++i)
  {
    const double t = i / 400.0;
    const double a = 6.0 * pi * t;
    stroke.push_back(name == "line" ? Vector2(-0.5 + t, 0.3 * t - 0.1)
                     : name == "sine"
                       ? Vector2(-0.5 + t, 0.1 * std::sin(4.0 * pi * t))
                       : Vector2((0.03 + 0.25 * t) * std::cos(a), (0.03 + 0.25 * t) * std::sin(a)));
  }
  return stroke;
}

}

TEST(Features, RealMeshesAreNotHarmed)
{
  for (const char* name : { "bunny_5k.obj",
         "armadillo_29k.obj",
         "spot_5k9.obj",
         "cat.off",
         "hand_closed.obj",
         "torus.obj",
         "skull_genus2.off",
         "hand_open_wrist.off" })
  {
    const Mesh mesh = sharedMesh(name);
    if (mesh.points.empty())
    {
      GTEST_SKIP() << "the shared meshes are not there";
    }
    const Forest base = baseOf(mesh);
    const double r = 0.03 * base.diagonal();
    for (const char* stroke : { "line", "sine", "spiral" })
    {
      const FeatureCurves curves = drawnOn(mesh, strokeNamed(stroke));
      Forest forest = base;
      needBaseNormals(forest, Context());
      refineNear(forest, curves, r, r / 4);
      const FaceQuality before = faceQuality(forest, Context());
      const std::vector<Vector3> old = positionsOf(forest);
      const auto t0 = std::chrono::steady_clock::now();
      const SnapReport report = snap(forest, curves, {}, {}, Context());
      const auto t1 = std::chrono::steady_clock::now();
      const FaceQuality after = faceQuality(forest, Context());
      DisplaceOptions options;
      options.radius = r;
      options.height = r / 2;
      const auto t2 = std::chrono::steady_clock::now();
      const DisplaceReport raised = displace(forest, curves, options, Context());
      const auto t3 = std::chrono::steady_clock::now();
      std::cout << name << " " << stroke << ": curves " << curves.size() << " faces " << base.faceCount()
                << " -> " << old.size() * 2 << " crossings " << report.crossings << " residual "
                << report.residual << " added " << report.facesAdded << " refused " << report.refused
                << " snapped " << report.snapped << " angle " << before.smallestAngle << " -> "
                << after.smallestAngle << " degenerate " << before.degenerate << " -> " << after.degenerate
                << " flipped by displace " << raised.flipped << " moved " << raised.moved << " snap ms "
                << std::chrono::duration<double, std::milli>(t1 - t0).count() << " displace ms "
                << std::chrono::duration<double, std::milli>(t3 - t2).count() << std::endl;
    }
  }
}
