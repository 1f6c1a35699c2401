// Texture seams, and what else the user's points carry, under the augmentation system.
#include "SharedModels.h"

#include "Mesh/weld.h"

#include "vtkOversketchStellarBase.h"
#include "vtkOversketchStellarDisplace.h"

#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace oversketch_test;

namespace
{

// A sphere whose texture is cut along half a meridian and whose triangles are two patches of colour.
vtkSmartPointer<vtkPolyData> seamed()
{
  const oversketch::Mesh ball = icosphere(4);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> texture;
  texture->SetName("TCoords");
  texture->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIntArray> patch;
  patch->SetName("Patch");
  std::map<std::pair<int, float>, vtkIdType> known;
  for (const oversketch::Triangle& t : ball.triangles)
  {
    const Vector3 middle = (ball.points[t[0]] + ball.points[t[1]] + ball.points[t[2]]) / 3.0;
    polys->InsertNextCell(3);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3& p = ball.points[t[k]];
      // Over the front, z > 0, the texture jumps at x = 0.
      const double u = p[0] + (middle[0] > 0.0 && middle[2] > 0.0 ? 4.0 : 0.0);
      const auto [at, isNew] =
        known.emplace(std::make_pair(t[k], static_cast<float>(u)), points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(p.data());
        texture->InsertNextTuple2(u, p[1]);
      }
      polys->InsertCellPoint(at->second);
    }
    patch->InsertNextValue(middle[1] > 0.0);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  mesh->GetPointData()->SetTCoords(texture);
  mesh->GetCellData()->AddArray(patch);
  return mesh;
}

// The same with one point a place, in the order of its first points.
oversketch::Mesh weldedSphere(vtkPolyData* mesh)
{
  oversketch::Mesh split;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    split.points.push_back(pointOf(mesh, i));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    mesh->GetPolys()->GetCellAtId(f, ids);
    split.triangles.push_back(
      { static_cast<int>(ids->GetId(0)), static_cast<int>(ids->GetId(1)), static_cast<int>(ids->GetId(2)) });
  }
  return oversketch::weldedMesh(split, oversketch::weldPoints(split.points));
}

} // namespace

// Of the two sides of a seam each keeps its texture, also under a stroke that runs across and along it; what
// the output says of itself as a 4-8 mesh holds, so a second stroke goes on from it.
TEST(AugmentSeams, TextureSeamsKeepTheirSides)
{
  vtkSmartPointer<vtkPolyData> mesh = seamed();
  std::vector<Vector2> wave;
  for (int i = 0; i <= 60; ++i)
  {
    wave.emplace_back(400.0 + 30.0 * std::sin(i / 6.0), 200.0 + 200.0 * i / 60.0);
  }
  System s(mesh, { wave });
  vtkOversketchStellarDisplace::SafeDownCast(s.filter->GetStep("Displace"))->SetKeepBaseNormals(true);
  vtkSmartPointer<vtkPolyData> first = deepCopy(s.run());
  System next(first);
  next.filter->SetStrokesData(strokesOf({ { { 320, 300 }, { 480, 310 } } }, s.view));
  vtkSmartPointer<vtkPolyData> second = deepCopy(next.run());
  EXPECT_EQ(vtkOversketchStellarBase::SafeDownCast(next.filter->GetStep("Base"))->GetBaseCount(), 0);
  System chain(mesh, { wave, { { 320, 300 }, { 480, 310 } } });
  chain.filter->OneByOneOn();
  EXPECT_TRUE(identical(second, chain.run())); // textures are mixed once instead of twice
  vtkDataArray* once = chain.filter->GetOutput()->GetPointData()->GetTCoords();
  vtkDataArray* twice = second->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(twice->GetComponent(i, 0), once->GetComponent(i, 0), 1e-3);
    EXPECT_NEAR(twice->GetComponent(i, 1), once->GetComponent(i, 1), 1e-3);
  }
  for (vtkPolyData* output : { first.Get(), second.Get(), chain.filter->GetOutput() })
  {
    EXPECT_TRUE(output->GetCellData()->GetArray("StellarPath"));
    vtkDataArray* texture = output->GetPointData()->GetTCoords();
    vtkDataArray* patch = output->GetCellData()->GetArray("Patch");
    ASSERT_TRUE(texture && patch);
    EXPECT_FALSE(output->GetPointData()->GetArray("Place"));
    vtkNew<vtkIdList> ids;
    for (vtkIdType f = 0; f < output->GetNumberOfPolys(); ++f)
    {
      output->GetPolys()->GetCellAtId(f, ids);
      int right = 0;
      for (vtkIdType k = 0; k < 3; ++k)
      {
        // No corner lies between the sides.
        const double u = texture->GetComponent(ids->GetId(k), 0);
        EXPECT_LT(std::min(std::abs(u), std::abs(u - 4.0)), 1.1);
        right += u > 2.0;
        // A point that rose by h still shows what lay under it.
        const Vector3 p = pointOf(output, ids->GetId(k));
        EXPECT_NEAR(texture->GetComponent(ids->GetId(k), 1), p[1] / p.norm(), 0.05);
      }
      EXPECT_TRUE(right == 0 || right == 3) << f;
    }
  }
  // Points that repeat a place stand last.
  std::set<std::vector<double>> places;
  bool repeats = false;
  for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = pointOf(first, i);
    const bool isNew = places.insert({ p[0], p[1], p[2] }).second;
    EXPECT_FALSE(isNew && repeats) << i;
    repeats = repeats || !isNew;
  }
  EXPECT_TRUE(repeats);
}

using SeamEdges = std::vector<std::pair<vtkIdType, vtkIdType>>;

// Edges between cells of different charts.
SeamEdges seamEdges(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, double> seen;
  vtkDataArray* charts = mesh->GetCellData()->GetArray("Chart");
  SeamEdges seams;
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; charts && f < mesh->GetNumberOfPolys(); ++f)
  {
    mesh->GetPolys()->GetCellAtId(f, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const vtkIdType a = ids->GetId(k), b = ids->GetId((k + 1) % 3);
      const auto [other, isNew] = seen.emplace(std::minmax(a, b), charts->GetComponent(f, 0));
      if (!isNew && other->second != charts->GetComponent(f, 0))
      {
        seams.push_back(other->first);
      }
    }
  }
  return seams;
}

// What lies on a seam stays on its line, so the texture beside it is that of the place: no point of one side
// is drawn over the other.
TEST(AugmentSeams, SeamsStayWhereTheyAre)
{
  std::vector<Vector2> wave;
  for (int i = 0; i <= 60; ++i)
  {
    wave.emplace_back(400.0 + 12.0 * std::sin(i / 6.0), 200.0 + 200.0 * i / 60.0);
  }
  System s(seamed(), { wave });
  vtkPolyData* output = s.run();
  vtkPolyData *base = s.filter->GetInnerOutput("Base"), *even = s.filter->GetInnerOutput("Smooth");
  vtkDataArray* curve = even->GetPointData()->GetArray("CurveId");
  ASSERT_TRUE(curve);
  const SeamEdges before = seamEdges(base), after = seamEdges(even);
  EXPECT_GT(after.size(), before.size());
  std::set<vtkIdType> onSeam;
  for (const auto& [a, b] : after)
  {
    onSeam.insert(a);
    onSeam.insert(b);
  }
  int snapped = 0;
  for (const vtkIdType point : onSeam)
  {
    snapped += curve->GetComponent(point, 0) >= 0.0;
    const Vector3 p = pointOf(even, point);
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : before)
    {
      const Vector3 from = pointOf(base, a), along = pointOf(base, b) - from;
      const double share = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - from - share * along).norm());
    }
    EXPECT_LE(nearest, 1e-12) << p.transpose();
  }
  EXPECT_GT(snapped, 3);
  // The first points of the output are those of the steps; the texture is x, and 4 more on one side.
  vtkDataArray* texture = output->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < even->GetNumberOfPoints(); ++i)
  {
    const double u = texture->GetComponent(i, 0);
    EXPECT_NEAR(u > 2.0 ? u - 4.0 : u, pointOf(even, i)[0], 2e-3) << i;
  }
}

// Welding the output gives what the mesh with the same charts and no texture becomes, points, cells and
// Stellar arrays.
TEST(AugmentSeams, WeldedTheOutputIsThatOfTheMeshWithoutSeams)
{
  System split(seamed());
  vtkPolyData* output = split.run();
  const oversketch::Mesh sphere = weldedSphere(split.mesh);
  System bare(toPolyData(sphere));
  vtkNew<vtkIntArray> charts;
  charts->SetName("Chart");
  for (const oversketch::Triangle& t : sphere.triangles)
  {
    const Vector3 middle = (sphere.points[t[0]] + sphere.points[t[1]] + sphere.points[t[2]]) / 3.0;
    charts->InsertNextValue(middle[0] > 0.0 && middle[2] > 0.0);
  }
  bare.mesh->GetCellData()->AddArray(charts);
  vtkPolyData* single = bare.run();
  ASSERT_GT(output->GetNumberOfPoints(), single->GetNumberOfPoints());
  ASSERT_EQ(output->GetNumberOfPolys(), single->GetNumberOfPolys());
  std::map<std::vector<double>, vtkIdType> vertices; // by place
  const auto vertexAt = [&](const Vector3& p)
  {
    return vertices.emplace(std::vector<double>{ p[0], p[1], p[2] }, static_cast<vtkIdType>(vertices.size()))
      .first->second;
  };
  vtkDataArray* moved = output->GetPointData()->GetArray("StellarMoved");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const vtkIdType v = vertexAt(pointOf(output, i));
    EXPECT_TRUE(i >= single->GetNumberOfPoints() || v == i);
    EXPECT_EQ(pointOf(output, i), pointOf(single, v));
    EXPECT_EQ(
      moved->GetComponent(i, 0), single->GetPointData()->GetArray("StellarMoved")->GetComponent(v, 0));
  }
  vtkNew<vtkIdList> a, b;
  for (vtkIdType f = 0; f < output->GetNumberOfPolys(); ++f)
  {
    output->GetPolys()->GetCellAtId(f, a);
    single->GetPolys()->GetCellAtId(f, b);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      EXPECT_EQ(vertexAt(pointOf(output, a->GetId(k))), b->GetId(k));
    }
  }
  for (const char* name : { "StellarRoot", "StellarPath", "StellarGen" })
  {
    EXPECT_TRUE(sameArray(output->GetCellData()->GetArray(name), single->GetCellData()->GetArray(name)));
  }
}

TEST(AugmentSeams, AModelsTextureStaysOnIt)
{
  vtkSmartPointer<vtkPolyData> spot = objModel("spot_uv.obj");
  if (!spot)
  {
    GTEST_SKIP();
  }
  System s(spot);
  const double r = 0.03 * s.diagonal();
  vtkPolyData* output = s.run();
  ASSERT_GT(output->GetNumberOfPolys(), spot->GetNumberOfPolys());
  vtkDataArray* before = spot->GetPointData()->GetTCoords();
  vtkDataArray* after = output->GetPointData()->GetTCoords();
  ASSERT_TRUE(before && after);
  // Every pair of place and texture of the model away from the stroke is there.
  std::set<std::vector<double>> there;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = pointOf(output, i);
    there.insert({ p[0], p[1], p[2], after->GetComponent(i, 0), after->GetComponent(i, 1) });
  }
  vtkPolyData* curves = s.filter->GetInnerOutput("Curves");
  for (vtkIdType i = 0; i < spot->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = pointOf(spot, i);
    double away = HUGE_VAL;
    for (vtkIdType c = 0; c < curves->GetNumberOfPoints(); ++c)
    {
      away = std::min(away, (pointOf(curves, c) - p).norm());
    }
    if (away > 1.5 * r)
    {
      EXPECT_TRUE(there.count({ p[0], p[1], p[2], before->GetComponent(i, 0), before->GetComponent(i, 1) }))
        << i;
    }
  }
}
