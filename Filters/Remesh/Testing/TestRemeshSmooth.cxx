// What is smooth stays smooth, and what is sharp stays sharp.
#include "RemeshTools.h"

#include "Mesh/roughness.h"

#include "vtkSMPTools.h"

using namespace oversketch_test;

namespace
{

struct Look
{
  Roughness rough;
  double sharpLength = 0.0;
  int points = 0; // of the region
};

Look lookOf(vtkPolyData* data)
{
  const Mesh mesh = MeshOf(data);
  const Adjacency adjacency = buildAdjacency(mesh);
  vtkDataArray* array = data->GetPointData()->GetArray("Region");
  std::vector<char> region;
  Look look;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    region.push_back(array->GetComponent(v, 0) != 0.0);
    look.points += region.back();
  }
  look.rough = roughness(mesh, adjacency, region);
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e)
  {
    const MeshEdge& edge = adjacency.edges[e];
    const int* sides = adjacency.trianglesBegin(static_cast<int>(e));
    if (edge.triangleCount == 2 &&
        facetNormal(mesh, sides[0]).dot(facetNormal(mesh, sides[1])) < std::cos(sharpAngle * pi / 180.0))
    {
      look.sharpLength += (mesh.points[edge.v1] - mesh.points[edge.v0]).norm();
    }
  }
  return look;
}

// A tube that tapers and bends along x, of `around` quads; `aspect` times as long as wide in the middle.
Mesh tail(int around, double aspect)
{
  const double radius = 0.1, length = 3.0;
  const int along = static_cast<int>(length / (aspect * 2 * pi * radius / around));
  return gridSurface(around,
    along,
    true,
    false,
    [=](double u, double v)
    {
      const double r = radius * (1.2 - 0.8 * v), a = -2 * pi * u, x = length * v;
      return Vector3(x, r * std::cos(a) + 0.1 * x * x, r * std::sin(a));
    });
}

// The cube of side 2 round the origin, n squares along an edge.
Mesh box(int n)
{
  Mesh mesh;
  std::map<std::array<int, 3>, int> known;
  const auto vertex = [&](const std::array<int, 3>& at)
  {
    const auto found = known.emplace(at, mesh.vertexCount());
    if (found.second)
    {
      mesh.points.emplace_back(2.0 * at[0] / n - 1.0, 2.0 * at[1] / n - 1.0, 2.0 * at[2] / n - 1.0);
    }
    return found.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, n })
    {
      for (int i = 0; i < n * n; ++i)
      {
        const auto corner = [&](int du, int dv)
        {
          std::array<int, 3> at{};
          at[axis] = side;
          at[(axis + 1) % 3] = i % n + du;
          at[(axis + 2) % 3] = i / n + dv;
          return vertex(at);
        };
        const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
        mesh.triangles.push_back(side > 0 ? Triangle{ a, b, c } : Triangle{ a, c, b });
        mesh.triangles.push_back(side > 0 ? Triangle{ a, c, d } : Triangle{ a, d, c });
      }
    }
  }
  return mesh;
}

double volumeOf(const Mesh& mesh)
{
  double volume = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    volume += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6.0;
  }
  return volume;
}

} // namespace

TEST(Remesh, ATailOfLongTrianglesStaysAsSmoothAsItIs)
{
  for (const int around : { 6, 8, 12, 16 })
  {
    for (const double aspect : { 1.0, 4.0, 8.0 })
    {
      SCOPED_TRACE(std::to_string(around) + " quads around, aspect " + std::to_string(aspect));
      const auto input = withRegion(
        tail(around, aspect), [](const Vector3& p) { return p[0] > 0.3; }, 0.2);
      const Look before = lookOf(input), after = lookOf(Remeshed(input, vtkOversketchRemesh::Restore).run());
      std::cout << around << " around, aspect " << aspect << ": mean angle " << before.rough.meanAngle
                << " -> " << after.rough.meanAngle << ", sharp " << before.rough.sharpShare << " -> "
                << after.rough.sharpShare << ", points " << before.points << " -> " << after.points << "\n";
      EXPECT_FALSE(rougher(after.rough, before.rough));
      EXPECT_GT(after.points, 0.9 * before.points);
    }
  }
  // As published it does not.
  Remeshed published(
    withRegion(tail(12, 4.0), [](const Vector3& p) { return p[0] > 0.3; }), vtkOversketchRemesh::Restore);
  published.filter->KeepSmoothOff();
  published.filter->LimitByDiameterOff();
  const Look before = lookOf(published.filter->GetPolyDataInput(0)), after = lookOf(published.run());
  EXPECT_TRUE(rougher(after.rough, before.rough));
  EXPECT_LT(after.points, 0.9 * before.points);
}

TEST(Remesh, TheEdgesOfABoxStaySharp)
{
  const auto input = withRegion(box(6), [](const Vector3&) { return true; });
  for (const double k : { 1.0, 0.6, 0.3 })
  {
    Remeshed stretch(input, vtkOversketchRemesh::Stretch, handlesOn(input, k, 1.0));
    const auto dense = stretch.run();
    const auto result = Remeshed(dense, vtkOversketchRemesh::Restore).run();
    for (vtkPolyData* data : { dense.Get(), result.Get() })
    {
      EXPECT_NEAR(lookOf(data).sharpLength, 24.0, 1e-9) << k;
      EXPECT_NEAR(volumeOf(MeshOf(data)), 8.0, 1e-9) << k;
    }
  }
}

TEST(Remesh, LengthsOfStageStretchAreThoseOfStageRestore)
{
  // Half of the tube is of long triangles, half of even ones: each gets its own back.
  const Mesh mesh = gridSurface(16,
    45,
    true,
    false,
    [](double u, double v)
    {
      const double x = v < 2.0 / 3.0 ? 1.5 * v : 1.0 + 12.0 * (v - 2.0 / 3.0), a = -2 * pi * u;
      return Vector3(x - 1.0, 0.1 * std::cos(a), 0.1 * std::sin(a));
    });
  const auto input = withRegion(mesh, [](const Vector3& p) { return p[0] > -0.8 && p[0] < 4.5; });
  Remeshed stretch(input, vtkOversketchRemesh::Stretch, handlesOn(input, 0.4, 1.0));
  const auto dense = stretch.run();
  vtkDataArray* lengths = dense->GetPointData()->GetArray("EdgeLength");
  ASSERT_NE(lengths, nullptr);
  ASSERT_EQ(lengths->GetNumberOfTuples(), dense->GetNumberOfPoints());
  const Look before = lookOf(input), between = lookOf(dense);
  const auto result = Remeshed(dense, vtkOversketchRemesh::Restore).run();
  const Look after = lookOf(result);
  std::cout << "mean angle " << before.rough.meanAngle << " -> " << after.rough.meanAngle << ", points "
            << before.points << ", " << between.points << ", " << after.points << "\n";
  EXPECT_GT(between.points, 3 * before.points);
  EXPECT_LT(after.points, 0.5 * between.points);
  EXPECT_GT(after.points, 0.9 * before.points);
  EXPECT_FALSE(rougher(after.rough, before.rough));
  // Without them it takes the dense mesh's own, and leaves it as dense.
  dense->GetPointData()->RemoveArray("EdgeLength");
  EXPECT_GT(lookOf(Remeshed(dense, vtkOversketchRemesh::Restore).run()).points, 0.8 * between.points);

  vtkNew<vtkPolyData> bad;
  bad->ShallowCopy(dense);
  bad->GetPointData()->AddArray(
    doubles("EdgeLength", std::vector<double>(3 * dense->GetNumberOfPoints(), 1.0), 3));
  Remeshed refused(bad, vtkOversketchRemesh::Restore);
  expectRefusal(refused.filter, Failure::MissingArray, "EdgeLength");
}

// Points of a cap that lie over each other, as where hairs are pressed flat: what the other passes leave
// folded.
TEST(Remesh, FoldsAreTakenOut)
{
  Mesh mesh = icosphere(4);
  unsigned seed = 7;
  const auto random = [&seed]
  {
    seed = seed * 1664525U + 1013904223U;
    return static_cast<double>(seed) / 4294967296.0 - 0.5;
  };
  for (Vector3& p : mesh.points)
  {
    const Vector3 shift(random(), random(), random());
    if (p[2] > 0.7)
    {
      p = (p + 0.22 * shift).normalized();
    }
  }
  const auto input = withRegion(mesh, upperHalf);
  const auto foldsOf = [](vtkPolyData* data)
  {
    const Mesh shape = MeshOf(data);
    const Adjacency adjacency = buildAdjacency(shape);
    int folds = 0;
    for (std::size_t e = 0; e < adjacency.edges.size(); ++e)
    {
      const int* sides = adjacency.trianglesBegin(static_cast<int>(e));
      folds += facetNormal(shape, sides[0]).dot(facetNormal(shape, sides[1])) < std::cos(100.0 * pi / 180.0);
    }
    return folds;
  };
  Remeshed usual(input, vtkOversketchRemesh::Restore), other(input, vtkOversketchRemesh::Restore);
  other.filter->TakeOutFoldsOn();
  const auto left = usual.run(), out = other.run();
  EXPECT_GT(foldsOf(input), 100);
  EXPECT_GT(foldsOf(left), 20);
  EXPECT_LT(foldsOf(out), foldsOf(left) / 3);
  expectOutsideUntouched(input, out);
  // Points alone differ.
  ASSERT_EQ(out->GetNumberOfPoints(), left->GetNumberOfPoints());
  EXPECT_EQ(MeshOf(out).triangles, MeshOf(left).triangles);
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        Remeshed again(input, vtkOversketchRemesh::Restore);
        again.filter->TakeOutFoldsOn();
        EXPECT_EQ(contentOf(again.run()), contentOf(out)) << threads;
      });
  }
  // Where nothing is folded nothing moves.
  const auto smooth = withRegion(icosphere(4), upperHalf);
  Remeshed plain(smooth, vtkOversketchRemesh::Restore), asked(smooth, vtkOversketchRemesh::Restore);
  asked.filter->TakeOutFoldsOn();
  EXPECT_EQ(contentOf(asked.run()), contentOf(plain.run()));
  std::cout << foldsOf(input) << " folded edges, " << foldsOf(left) << " after remeshing, " << foldsOf(out)
            << " are left\n";
}
