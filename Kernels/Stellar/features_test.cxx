// Snapping and displacing on real meshes, one after the other.
#include "Harness/face_quality.h"
#include "Harness/feature_shapes.h"
#include "Mesh/nearest.h"
#include "Stellar/displace.h"
#include "Stellar/snap.h"

#include <gtest/gtest.h>

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

// Within half of the model's size.
std::vector<Vector2> strokeNamed(const std::string& name)
{
  std::vector<Vector2> stroke;
  for (int i = 0; i <= 400; ++i)
  {
    const double t = i / 400.0, a = 6.0 * pi * t;
    if (name == "line")
      stroke.emplace_back(-0.5 + t, 0.3 * t - 0.1);
    else if (name == "sine")
      stroke.emplace_back(-0.5 + t, 0.1 * std::sin(4.0 * pi * t));
    else if (name == "spiral")
      stroke.emplace_back((0.03 + 0.25 * t) * std::cos(a), (0.03 + 0.25 * t) * std::sin(a));
    else
      stroke.emplace_back(0.3 * std::sin(a / 3.0), 0.2 * std::sin(2.0 * a / 3.0)); // an eight
  }
  return stroke;
}

struct Crest
{
  double mean = 1.0, least = 1.0;
};

// The feature value under the curves, r / 20 apart and r from the ends, interpolated in the nearest face of
// the mesh as it was before it was raised.
Crest crestOf(const Forest& raised, const std::vector<Vector3>& before, const FeatureCurves& curves, double r)
{
  std::vector<int> faces;
  for (int f = 0; f < static_cast<int>(raised.faces.size()); ++f)
    if (raised.isFace(f))
      for (const int v : raised.faces[f].v)
        if (raised.feature[v] > 0.0)
        {
          faces.push_back(f);
          break;
        }
  double sum = 0.0;
  int count = 0;
  Crest crest;
  for (const FeatureCurve& curve : curves)
    for (double t = r; t < curve.length - r; t += r / 20.0)
    {
      const Vector3 p = curve.position(t);
      double least = std::numeric_limits<double>::infinity(), value = 0.0;
      for (const int f : faces)
      {
        const int* v = raised.faces[f].v;
        if ((before[v[0]] - p).squaredNorm() > r * r)
          continue;
        const auto w = closestWeights(before[v[0]], before[v[1]], before[v[2]], p);
        const double d = (w[0] * before[v[0]] + w[1] * before[v[1]] + w[2] * before[v[2]] - p).squaredNorm();
        if (d < least)
        {
          least = d;
          value = w[0] * raised.feature[v[0]] + w[1] * raised.feature[v[1]] + w[2] * raised.feature[v[2]];
        }
      }
      sum += value;
      ++count;
      crest.least = std::min(crest.least, value);
    }
  crest.mean = count ? sum / count : 1.0;
  return crest;
}

} // namespace

TEST(D9_1, RealMeshesAreFollowedToo)
{
  int cases = 0, crossings = 0, residual = 0, added = 0, faces = 0;
  double mean = 1.0, least = 1.0, angle = 60.0;
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
    Forest base = baseOf(mesh);
    needBaseNormals(base, Context());
    const double r = 0.03 * base.diagonal();
    for (const char* stroke : { "line", "sine", "spiral", "crossing" })
    {
      SCOPED_TRACE(std::string(name) + ' ' + stroke);
      FeatureCurves curves = drawnOn(mesh, strokeNamed(stroke));
      if (std::string(stroke) == "crossing")
      {
        const FeatureCurves second = drawnOn(mesh, strokeNamed("line"));
        curves.insert(curves.end(), second.begin(), second.end());
      }
      Forest forest = base;
      refineNear(forest, curves, r, r / 4.0);
      const Forest refined = forest;
      const FaceQuality before = faceQuality(forest);
      const SnapReport report = snap(forest, curves, {}, {}, Context());
      const FaceQuality after = faceQuality(forest);
      EXPECT_EQ(forest.broken(), "");
      EXPECT_LE(report.residual, 0.01 * report.crossings);
      EXPECT_LE(report.facesAdded, 0.03 * refined.faceCount());
      EXPECT_EQ(after.degenerate, before.degenerate);
      EXPECT_GE(after.smallestAngle, std::min(4.5, before.smallestAngle));
      if (report.facesAdded == 0)
      {
        EXPECT_EQ(flippedFaces(forest, positionsOf(refined), positionsOf(forest)), 0);
      }
      const std::vector<Vector3> snapped = positionsOf(forest);
      DisplaceOptions options;
      options.radius = r;
      options.height = 0.5 * r;
      displace(forest, curves, options, Context());
      const Crest crest = crestOf(forest, snapped, curves, r);
      EXPECT_GE(crest.mean, 0.99);
      EXPECT_GE(crest.least, 0.85);
      ++cases;
      crossings += report.crossings;
      residual += report.residual;
      added += report.facesAdded;
      faces += refined.faceCount();
      mean = std::min(mean, crest.mean);
      least = std::min(least, crest.least);
      angle = std::min(angle, after.smallestAngle);
    }
  }
  std::ostringstream text;
  text << cases << " strokes on real meshes: " << residual << " of " << crossings << " crossings left, "
       << added << " faces added to " << faces << ", smallest angle " << angle << ", crest " << mean << " / "
       << least;
  fact("D9_1", text.str());
}
