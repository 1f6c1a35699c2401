// Facts of editors.md, section 13, flatten and texture, by the filter: the fields.
#include "ShadingScenes.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

struct Measured
{
  vtkNew<vtkOversketchDistanceField> filter;

  explicit Measured(vtkPolyData* mesh, vtkPolyData* reference)
  {
    this->filter->SetInputData(mesh);
    this->filter->SetReferenceData(reference);
  }
  explicit Measured(const Scene& scene)
    : Measured(meshOf(scene), toChain(scene.mesh, scene.reference))
  {
  }
  std::vector<double> values(const char* name)
  {
    this->filter->Update();
    return pointValues(this->filter->GetOutput(), name);
  }
};

double weight(double s, bool linear)
{
  return linear ? 1.0 - s : 1.0 - s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
}

} // namespace

TEST(DistanceFieldFilter, AStripFallsEvenly)
{
  const Drawn drawn = strip(200, 20);
  Measured made(sceneOf(drawn));
  made.filter->SetMeasureToEuclidean();
  for (const double smoothing : { 0.0, 0.15 })
  {
    made.filter->SetFieldSmoothing(smoothing);
    const std::vector<double> s = made.values("CurveDistance"), side = made.values("CurveSide");
    for (int v = 0; v < drawn.patch.vertexCount(); ++v)
    {
      const Vector3& p = drawn.patch.points[v];
      if (std::abs(p[0]) <= 5.0)
      {
        EXPECT_NEAR(s[v], std::abs(p[1]), smoothing == 0.0 ? 1e-9 : 1e-6);
        EXPECT_EQ(side[v], std::abs(p[1]) < 1e-9 ? 0.0 : p[1] > 0.0 ? 1.0 : -1.0);
      }
    }
  }
  // As published is straight, and not smoothed.
  made.filter->SetMeasureToSurface();
  made.filter->AsPublishedOn();
  const std::vector<double> published = made.values("CurveDistance");
  made.filter->AsPublishedOff();
  made.filter->SetMeasureToEuclidean();
  made.filter->SetFieldSmoothing(0.0);
  made.filter->SetParameterSmoothing(0.0);
  EXPECT_EQ(made.values("CurveDistance"), published);
}

TEST(B6_4, ByTheFilterAndAsPublished)
{
  const Drawn drawn = hill(72);
  Measured made(sceneOf(drawn));
  const auto jumps = [&](bool linear)
  {
    std::vector<double> w;
    for (const double s : made.values("CurveDistance"))
    {
      EXPECT_GE(s, 0.0);
      EXPECT_LE(s, 1.0);
      w.push_back(weight(s, linear));
    }
    for (const int v : drawn.reference)
      EXPECT_EQ(w[v], 1.0);
    return slopeJumps(drawn, w);
  };
  const auto [inner, outer] = jumps(false);
  EXPECT_LE(inner, 0.4);
  EXPECT_LE(outer, 0.15);
  made.filter->AsPublishedOn();
  const auto [innerPublished, outerPublished] = jumps(true);
  EXPECT_GE(innerPublished, 1.8);
  EXPECT_LE(innerPublished, 2.7);
  EXPECT_GE(outerPublished, 0.85);
  EXPECT_LE(outerPublished, 1.1);
  fact("B6_4",
    "by the filter: slope jump at the line " + std::to_string(innerPublished) + " as published, " +
      std::to_string(inner) + " by default, at the ring " + std::to_string(outerPublished) + ", " +
      std::to_string(outer));
}

TEST(B6_5, ByTheFilterAndAsPublished)
{
  const Drawn drawn = hook();
  Measured made(sceneOf(drawn));
  const double smoothed = largestStep(drawn, made.values("CurveParameter"));
  made.filter->AsPublishedOn();
  const double published = largestStep(drawn, made.values("CurveParameter"));
  EXPECT_LE(smoothed, 0.25);
  EXPECT_GE(published, 0.9);
  fact("B6_5",
    "by the filter: largest step of the parameter over an edge " + std::to_string(published) +
      " as published, " + std::to_string(smoothed) + " by default");
}

TEST(DistanceFieldFilter, OutsideIsBlackAndTheOtherDirectionMirrors)
{
  const Scene scene = capScene();
  Measured made(scene);
  const std::vector<double> s = made.values("CurveDistance"), place = made.values("CurveParameter"),
                            side = made.values("CurveSide");
  int left = 0, right = 0;
  for (std::size_t v = 0; v < s.size(); ++v)
  {
    if (scene.labels[v] == 2)
    {
      EXPECT_LT(s[v], 1.0);
      left += side[v] > 0.0;
      right += side[v] < 0.0;
    }
    else
    {
      EXPECT_EQ(s[v], 1.0);
    }
    if (scene.mesh.points[v][2] < 0.1)
    {
      EXPECT_EQ(place[v], 0.0);
      EXPECT_EQ(side[v], 0.0);
    }
  }
  EXPECT_NEAR(static_cast<double>(left) / right, 1.0, 0.3);
  Scene back = scene;
  std::reverse(back.reference.begin(), back.reference.end());
  Measured other(back);
  const std::vector<double> s2 = other.values("CurveDistance"), place2 = other.values("CurveParameter");
  for (std::size_t v = 0; v < s.size(); ++v)
  {
    EXPECT_NEAR(s2[v], s[v], 2e-5); // of equal ways fronts take the first, with its slope
    if (scene.labels[v] == 2)
    {
      EXPECT_NEAR(place2[v], 1.0 - place[v], 0.01);
    }
  }
}

TEST(DistanceFieldFilter, OnlyWhatItReadsMeasuresAnew)
{
  Scene scene = capScene(3);
  const auto mesh = meshOf(scene);
  Measured made(mesh, toChain(scene.mesh, scene.reference));
  made.filter->Update();
  vtkDataArray* const first = made.filter->GetOutput()->GetPointData()->GetArray("CurveDistance");
  vtkNew<vtkDoubleArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(mesh->GetNumberOfPoints());
  mesh->GetPointData()->AddArray(other);
  made.filter->Update();
  EXPECT_TRUE(made.filter->GetOutput()->GetPointData()->HasArray("Other"));
  EXPECT_EQ(made.filter->GetOutput()->GetPointData()->GetArray("CurveDistance"), first);
  EXPECT_EQ(made.filter->GetFieldCount(), 1);
  scene.reference.pop_back();
  made.filter->SetReferenceData(toChain(scene.mesh, scene.reference));
  made.filter->Update();
  EXPECT_EQ(made.filter->GetFieldCount(), 2);
  made.filter->SetFieldSmoothing(0.1);
  made.filter->Update();
  EXPECT_EQ(made.filter->GetFieldCount(), 3);
}

TEST(DistanceFieldFilter, OneAndTwoThreadsGiveTheSameBits)
{
  const Scene scene = capScene();
  Measured one(scene), two(scene);
  vtkSMPTools::Initialize(1);
  one.filter->Update();
  vtkSMPTools::Initialize(2);
  two.filter->Update();
  vtkSMPTools::Initialize();
  for (const char* name : { "CurveDistance", "CurveParameter", "CurveSide" })
    EXPECT_TRUE(sameBits(one.filter->GetOutput()->GetPointData()->GetArray(name),
      two.filter->GetOutput()->GetPointData()->GetArray(name)))
      << name;
}

TEST(DistanceFieldFilter, RefusesAndCancels)
{
  const Scene scene = capScene(3);
  const auto refused = [&](const std::vector<int>& chain, const char* words)
  {
    Measured made(meshOf(scene), toChain(scene.mesh, chain));
    expectRefusal(made.filter, Failure::BadStroke, words);
  };
  const int a = scene.reference[2], far = scene.reference[5];
  const auto rim =
    static_cast<int>(std::find(scene.labels.begin(), scene.labels.end(), 1) - scene.labels.begin());
  const int outside = nearestVertex(scene.mesh, { 0, 0, -1 });
  const char* const noChain = "is not a chain of two or more vertices inside the region";
  refused({ a }, noChain);
  refused({ a, a }, noChain);
  refused({ a, far }, noChain);
  refused({ a, rim }, noChain);
  refused({ outside, outside + 1 }, noChain);
  refused({ a, -1 }, "is no vertex of the mesh");
  refused({}, noChain);
  Measured made(scene);
  for (const double bad : { -0.1, 11.0, std::nan("") })
  {
    made.filter->SetFieldSmoothing(bad);
    expectRefusal(made.filter, Failure::BadStroke, "FieldSmoothing is not within 0 and 10");
    made.filter->SetFieldSmoothing(0.15);
    made.filter->SetParameterSmoothing(bad);
    expectRefusal(made.filter, Failure::BadStroke, "ParameterSmoothing is not within 0 and 10");
    made.filter->SetParameterSmoothing(0.3);
  }
  expectCancel(made.filter);
  made.filter->Update();
  EXPECT_EQ(made.filter->GetErrorCode(), 0u);
  vtkNew<vtkPolyData> nothing;
  made.filter->SetInputData(nothing);
  Ear ear(made.filter);
  made.filter->Update();
  EXPECT_TRUE(ear.errors.empty());
}
