#include "ShapeDiameterTools.h"

#include <algorithm>
#include <sstream>

using namespace oversketch_test;

namespace
{

// All rays of a mesh, before their summary.
std::vector<ConeHit> coneHits(const Mesh& mesh, const std::vector<Vector3>& normals, double angle)
{
  ShapeDiameterOptions options;
  options.coneAngle = angle;
  std::vector<ConeHit> hits;
  computeShapeDiameter(mesh, buildAdjacency(mesh), normals, options, Context(), &hits);
  return hits;
}

// Weighted mean length of the rays of the vertices that are chosen, all of which must have hit.
template <typename Chosen>
double meanLength(const Mesh& mesh,
  const std::vector<ConeHit>& hits,
  const std::vector<double>& weights,
  const Chosen& chosen,
  double* worst = nullptr,
  double expected = 0.0)
{
  double total = 0.0;
  int vertices = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (chosen(mesh.points[v]))
    {
      double sum = 0.0, weight = 0.0;
      for (int k = 0; k < 32; ++k)
      {
        EXPECT_GE(hits[32 * v + k].triangle, 0);
        sum += weights[k] * hits[32 * v + k].length;
        weight += weights[k];
      }
      total += sum / weight;
      ++vertices;
      if (worst)
      {
        *worst = std::max(*worst, std::abs(sum / weight / expected - 1.0));
      }
    }
  }
  EXPECT_GT(vertices, 0);
  return total / vertices;
}

std::vector<double> inverseAngles(double angle)
{
  std::vector<double> weights;
  for (const Vector3& d : coneDirections(32, angle))
  {
    weights.push_back(1.0 / std::acos(d[2]));
  }
  return weights;
}

// A closed slab of thickness h around z = 0, its sides far away, a grid of n x n on top and bottom.
Mesh slab(double half, double h, int n)
{
  Mesh mesh = gridSurface(n,
    n,
    false,
    false,
    [=](double u, double v) { return Vector3(half * (2 * u - 1), half * (2 * v - 1), h / 2); });
  const int top = mesh.vertexCount();
  for (int i = 0; i < top; ++i)
  {
    mesh.points.emplace_back(mesh.points[i][0], mesh.points[i][1], -h / 2);
  }
  const int triangles = mesh.triangleCount();
  for (int i = 0; i < triangles; ++i)
  {
    const Triangle t = mesh.triangles[i];
    mesh.triangles.push_back({ t[0] + top, t[2] + top, t[1] + top });
  }
  return mesh;
}

std::string text(double x)
{
  std::ostringstream stream;
  stream << x;
  return stream.str();
}

} // namespace

TEST(A6_1, MeanRayInALongCylinderIsTwoRadii)
{
  const double R = 0.7, length = 12.0 * R;
  const Mesh mesh = cylinder(R, length, 360, 60);
  std::vector<Vector3> normals;
  for (const Vector3& p : mesh.points)
  {
    normals.push_back(Vector3(p[0], p[1], 0.0).normalized());
  }
  const auto middle = [&](const Vector3& p) { return p[2] > 3.5 * R && p[2] < length - 3.5 * R; };
  double worst60 = 0.0;
  const double at60 =
    meanLength(mesh, coneHits(mesh, normals, 60.0), std::vector<double>(32, 1.0), middle, &worst60, 2.0 * R);
  EXPECT_NEAR(at60 / R, 2.0, 0.006);
  EXPECT_LT(worst60, 0.004); // a single vertex's cone may be turned unfavourably
  // Any cone, any weights that depend on the angle alone; wider cones and uneven weights are sampled more
  // coarsely.
  double worst120 = 0.0, worstWeighted = 0.0;
  meanLength(mesh, coneHits(mesh, normals, 120.0), std::vector<double>(32, 1.0), middle, &worst120, 2.0 * R);
  meanLength(mesh, coneHits(mesh, normals, 60.0), inverseAngles(60.0), middle, &worstWeighted, 2.0 * R);
  EXPECT_LT(worst120, 0.03);
  EXPECT_LT(worstWeighted, 0.02);
  fact("A6_1",
    "cylinder, 60 degrees, 32 rays: mean ray " + text(at60 / R) + " R, worst vertex " + text(100 * worst60) +
      " % off; 120 degrees " + text(100 * worst120) + " %, inverse-angle weights " +
      text(100 * worstWeighted) + " %");
}

TEST(A6_2, SphereAndSlabPinTheFullOpening)
{
  std::string figures;
  const Mesh sphere = icosphere(5, 2.0);
  const auto sphereData = toPolyData(sphere);
  for (const double angle : { 60.0, 120.0 })
  {
    const double c = std::cos(angle * pi / 360.0);
    for (const int backend : backends)
    {
      for (const double d : diameters(sphereData, backend, angle))
      {
        // Lengths are spread evenly, so dropping outliers takes as much from both ends.
        ASSERT_NEAR(d / 2.0, 1.0 + c, 0.01);
      }
    }
    const auto values = diameters(sphereData, Filter::Host, angle);
    double mean = 0.0;
    for (const double d : values)
    {
      mean += d / 2.0 / static_cast<double>(values.size());
    }
    EXPECT_NEAR(mean, 1.0 + c, 0.002);
    figures += "sphere " + text(angle) + " deg " + text(mean) + " R (law " + text(1.0 + c) + "); ";

    const double h = 0.3;
    const Mesh plate = slab(3.0, h, 30);
    const double slabMean = meanLength(plate,
      coneHits(plate, vertexNormals(plate), angle),
      std::vector<double>(32, 1.0),
      [](const Vector3& p) { return p.head<2>().cwiseAbs().maxCoeff() < 2.0; });
    const double law = -std::log(c) / (1.0 - c);
    EXPECT_NEAR(slabMean / h, law, 0.002 * law);
    figures += "slab " + text(angle) + " deg " + text(slabMean / h) + " h (law " + text(law) + "); ";
  }
  fact("A6_2", figures.substr(0, figures.size() - 2));
}

TEST(A6_3, ScalesWithTheModelAndIgnoresWhereItStands)
{
  const Mesh mesh = torus(1.0, 0.37, 80, 40);
  const auto moved = [&](double scale, const Vector3& shift)
  {
    Mesh copy = mesh;
    for (Vector3& p : copy.points)
    {
      p = scale * p + shift;
    }
    return toPolyData(copy);
  };
  double scaled = 0.0, shifted = 0.0, far = 0.0;
  for (const int backend : backends)
  {
    const auto values = diameters(toPolyData(mesh), backend);
    const auto compare = [&](const std::vector<double>& others, double scale, double& worst)
    {
      ASSERT_EQ(others.size(), values.size());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        worst = std::max(worst, std::abs(others[i] / (scale * values[i]) - 1.0));
      }
    };
    for (const double scale : { 1e-7, 0.3, 25.4, 1e9 })
    {
      compare(diameters(moved(scale, Vector3::Zero()), backend), scale, scaled);
    }
    compare(diameters(moved(1.0, Vector3(3, -5, 2)), backend), 1.0, shifted);
    compare(diameters(moved(1.0, Vector3(5e6, -3e6, 1e6)), backend), 1.0, far);
  }
  EXPECT_LT(scaled, 1e-9);
  EXPECT_LT(shifted, 1e-9);
  EXPECT_LT(far, 1e-6); // the coordinates themselves are rounded to 1e-9 there
  fact("A6_3",
    "scales 1e-7 to 1e9: within " + text(scaled) + "; moved by 6 lengths: " + text(shifted) +
      ", by 6e6: " + text(far));
}

TEST(A6_4, BackendsAgreeOnRealMeshes)
{
  if (!Device::instance())
  {
    GTEST_SKIP() << "no OpenCL device";
  }
  std::string figures;
  for (const char* name : { "bunny_5k.obj", "man.ply", "koala.stl", "knot_trefoil.ply", "spot_5k9.obj" })
  {
    const auto mesh = read(name);
    if (!mesh)
    {
      std::cout << name << " is absent: set OVERSKETCH_DATA\n";
      continue;
    }
    const auto device = diameters(mesh, Filter::OpenCL);
    const auto embree = diameters(mesh, Filter::Host);
    double worst = 0.0;
    for (std::size_t i = 0; i < device.size(); ++i)
    {
      worst = std::max(worst, std::abs(device[i] - embree[i]) / embree[i]);
    }
    EXPECT_LT(worst, 1e-4) << name;
    figures += std::string(name) + ' ' + text(worst) + "; ";
  }
  if (!figures.empty())
  {
    fact("A6_4", "32 rays a vertex traced; shape diameters of device and Embree differ by " + figures);
  }
}

TEST(ShapeDiameter, CapsulesAreTwoRadiiThick)
{
  const auto mesh = read("capsule_figure.obj");
  if (!mesh)
  {
    GTEST_SKIP() << "capsule_figure.obj is absent: set OVERSKETCH_DATA";
  }
  struct Limb
  {
    Vector3 from, to;
    double radius;
  };
  // The free ends are left out: a cone from a cap looks along the limb.
  const Limb limbs[] = { { { 0.65, 0, 1.25 }, { 1.2, 0, 1.25 }, 0.11 },
    { { -0.65, 0, 1.25 }, { -1.2, 0, 1.25 }, 0.11 },
    { { 0.22, 0, -0.7 }, { 0.22, 0, -1.3 }, 0.16 },
    { { -0.22, 0, -0.7 }, { -0.22, 0, -1.3 }, 0.16 },
    { { 0, -0.65, -0.2225 }, { 0, -1.2, -0.415 }, 0.06 } };
  for (const int backend : backends)
  {
    const auto values = diameters(mesh, backend);
    for (const Limb& limb : limbs)
    {
      std::vector<double> found;
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        Vector3 p;
        mesh->GetPoint(i, p.data());
        const Vector3 axis = limb.to - limb.from;
        const double along = (p - limb.from).dot(axis) / axis.squaredNorm();
        if (along > 0.0 && along < 1.0 && (p - limb.from - along * axis).norm() < 1.1 * limb.radius)
        {
          found.push_back(values[static_cast<std::size_t>(i)]);
        }
      }
      ASSERT_GT(found.size(), 50u);
      std::sort(found.begin(), found.end());
      EXPECT_NEAR(found[found.size() / 2] / (2.0 * limb.radius), 1.0, 0.06);
      EXPECT_NEAR(found.front() / (2.0 * limb.radius), 1.0, 0.2);
      EXPECT_NEAR(found.back() / (2.0 * limb.radius), 1.0, 0.2);
    }
  }
}

TEST(ShapeDiameter, InverseAngleWeightsFavourTheAxis)
{
  // In a sphere the axis is the longest way.
  const auto mesh = toPolyData(icosphere(3));
  const auto even = diameters(mesh, Filter::Host, 120.0, false);
  const auto weighted = diameters(mesh, Filter::Host, 120.0, true);
  for (std::size_t i = 0; i < even.size(); ++i)
  {
    EXPECT_GT(weighted[i], even[i] + 0.005);
  }
}
