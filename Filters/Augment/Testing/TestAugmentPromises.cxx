// What the augmentation system refuses, how it is cancelled, and what must not matter to it.
#include "Hostile/sound.h"
#include "SharedModels.h"

#include "vtkOversketchStellarRefine.h"

#include "vtkCallbackCommand.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>

using namespace oversketch_test;
using oversketch::Failure;

namespace
{

// The same triangles of the same points, split in the same places.
void expectSameConnectivity(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_EQ(a->GetNumberOfPolys(), b->GetNumberOfPolys());
  vtkNew<vtkIdList> left, right;
  for (vtkIdType i = 0; i < a->GetNumberOfPolys(); ++i)
  {
    a->GetPolys()->GetCellAtId(i, left);
    b->GetPolys()->GetCellAtId(i, right);
    ASSERT_TRUE(std::equal(left->begin(), left->end(), right->begin(), right->end())) << "cell " << i;
  }
  for (const char* name : { "StellarRoot", "StellarPath", "StellarGen" })
  {
    EXPECT_TRUE(sameArray(a->GetCellData()->GetArray(name), b->GetCellData()->GetArray(name))) << name;
  }
}

} // namespace

TEST(AugmentPromises, RefusesStrokesAndNumbersThatAreNone)
{
  System s(shippedModel("bear"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  s.run();
  const auto refuse = [&](const char* words) { expectRefusal(s.filter, Failure::BadStroke, words); };
  vtkNew<vtkPolyData> none;
  s.filter->SetStrokesData(none);
  refuse("no stroke");
  s.filter->SetStrokesData(strokesOf({ { { 5, 5 }, { 40, 5 } } }, s.view));
  refuse("draw it over the model");
  s.filter->SetStrokesData(strokesOf({ { { 380, 300 }, { nan, 300 }, { 440, 300 } } }, s.view));
  refuse("troke");
  s.filter->SetStrokesData(strokesOf({ { { 380, 300 } } }, s.view));
  refuse("troke");
  s.filter->SetStrokesData(s.strokes);
  for (const double radius : { nan, std::numeric_limits<double>::infinity(), 0.0 })
  {
    s.filter->SetRadius(radius);
    refuse("adius");
  }
  s.filter->SetRadius(-1.0);
  s.filter->SetHeight(nan);
  refuse("Height");
  s.filter->SetHeight(0.0);
  s.filter->SetSharpness(-1.0);
  refuse("harpness");
  s.filter->SetSharpness(1.5);
  for (const char* profile : { "0 1, 0.6 0.5, 0.4 0.2, 1 0", "cat", "0 1" })
  {
    s.filter->SetProfile(profile);
    refuse("rofile");
  }
  s.filter->SetProfile("");
  auto viewless = deepCopy(s.strokes);
  viewless->GetCellData()->RemoveArray("ViewTransform");
  s.filter->SetStrokesData(viewless);
  expectRefusal(s.filter, Failure::MissingArray, "ViewTransform");
  s.filter->SetStrokesData(s.strokes);
  EXPECT_GT(s.run()->GetNumberOfPoints(), 0);
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
  {
    auto blind = deepCopy(s.strokes);
    blind->GetCellData()->GetArray(name)->SetComponent(0, 1, nan);
    s.filter->SetStrokesData(blind);
    refuse(name == std::string("ViewportSize") ? "positive" : "finite");
  }
  s.filter->SetStrokesData(s.strokes);
  // Edges that would take more triangles than memory holds.
  auto* refine = vtkOversketchStellarRefine::SafeDownCast(s.filter->GetStep("Refine"));
  refine->SetMaximumGeneration(62);
  refine->SetMaximumFaces(100000);
  s.filter->SetTargetEdgeLength(1e-12);
  expectRefusal(s.filter, Failure::BadRegion, "100000");
  s.filter->SetTargetEdgeLength(0.0);
  refine->SetMaximumGeneration(16);
  refine->SetMaximumFaces(4000000);
  // Radii that reach over everything, and that reach nothing.
  s.filter->SetRadius(10.0 * s.diagonal());
  EXPECT_GT(s.run()->GetNumberOfPoints(), 0);
  vtkNew<vtkPolyData> empty;
  s.filter->SetInputData(0, empty);
  s.filter->SetRadius(-1.0);
  s.run();
  EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Below 0, whatever it is, is the default of the parameter and none of a stroke's own.
TEST(AugmentPromises, ANegativeRadiusIsTheDefaultOrRefused)
{
  System s(shippedModel("bear"));
  const auto usual = deepCopy(s.run());
  s.filter->SetRadius(0.03 * s.diagonal());
  EXPECT_EQ(s.run()->GetNumberOfPolys(), usual->GetNumberOfPolys());
  for (const double radius : { -1e-300, -0.5, -1e300 })
  {
    s.filter->SetRadius(radius);
    expectSame(usual, s.run());
  }
  s.filter->SetRadius(-std::numeric_limits<double>::infinity());
  expectRefusal(s.filter, Failure::BadStroke, "Radius is not a finite number");
  s.filter->SetRadius(-1.0);
  for (const double radius : { 0.0, -1.0, -1e-300, std::numeric_limits<double>::quiet_NaN() })
  {
    const auto strokes = deepCopy(s.strokes);
    vtkNew<vtkDoubleArray> own;
    own->SetName("Radius");
    own->InsertNextValue(radius);
    strokes->GetCellData()->AddArray(own);
    s.filter->SetStrokesData(strokes);
    expectRefusal(s.filter, Failure::BadStroke, "Radius");
  }
}

// What a radius that reaches no point gives: a mesh that is finer under the stroke, and nothing moved but
// onto it.
TEST(AugmentPromises, ARadiusThatReachesNothingMakesASoundMesh)
{
  for (const double radius : { 1e-300, 1e-12 })
  {
    System s(shippedModel("bear"));
    s.filter->SetRadius(radius);
    s.run();
    expectSound48(
      s.filter->GetInnerOutput("Base"), s.filter->GetInnerOutput("Simplify"), s.filter->GetOutput());
    EXPECT_GT(s.filter->GetOutput()->GetNumberOfPolys(), s.mesh->GetNumberOfPolys());
    EXPECT_LE(
      largestMove(s.filter->GetInnerOutput("Smooth"), s.filter->GetInnerOutput("Displace")), 0.51 * radius);
  }
}

// Rings, scribbles, many samples, into the air and back: a mesh whose 4-8 arrays hold, or one refusal.
TEST(AugmentPromises, AnyStrokeMakesASoundMeshOrOneMessage)
{
  std::vector<std::vector<Vector2>> strokes(5);
  for (int i = 0; i < 100000; ++i)
  {
    const double a = 2.0 * pi * i / 100000.0;
    strokes[0].emplace_back(400.0 + 40.0 * std::cos(a), 300.0 + 30.0 * std::sin(a));
  }
  for (int i = 0; i <= 200; ++i)
  {
    const double a = i / 20.0;
    strokes[1].emplace_back(
      400.0 + 60.0 * std::sin(3.1 * a), 300.0 + 50.0 * std::sin(4.3 * a)); // through itself
    strokes[2].emplace_back(50.0 + 3.5 * i, 300.0 + 20.0 * std::sin(a));   // over the edges
    strokes[3].emplace_back(400.0 + i % 2, 300.0);
    strokes[4].emplace_back(i % 3 ? 400.0 : 100.0, 250.0 + i % 7);
  }
  for (const std::vector<Vector2>& stroke : strokes)
  {
    System s(shippedModel("bear"), { stroke });
    Ear ear(s.filter);
    s.filter->Update();
    if (s.filter->GetErrorCode() != 0u)
    {
      EXPECT_EQ(ear.errors.size(), 1u);
      continue;
    }
    expectSound48(
      s.filter->GetInnerOutput("Base"), s.filter->GetInnerOutput("Simplify"), s.filter->GetOutput());
    EXPECT_GT(s.filter->GetOutput()->GetNumberOfPolys(), s.mesh->GetNumberOfPolys());
  }
}

// The same triangles however large the model is and wherever it stands.
TEST(AugmentPromises, SizeAndPlaceDoNotMatter)
{
  vtkSmartPointer<vtkPolyData> home;
  for (const auto& [scale, shift] : { std::make_pair(1.0, 0.0),
         std::make_pair(std::ldexp(1.0, -60), 0.0),
         std::make_pair(std::ldexp(1.0, 30), 0.0),
         std::make_pair(1.0, 1024.0) })
  {
    auto mesh = deepCopy(shippedModel("bear"));
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = scale * pointOf(mesh, i) + Vector3::Constant(shift);
      points->InsertNextPoint(p.data());
    }
    mesh->SetPoints(points);
    System s(mesh);
    SCOPED_TRACE(std::to_string(scale) + " " + std::to_string(shift));
    home = home ? home : deepCopy(s.run());
    expectSameConnectivity(s.run(), home);
  }
}

// Models as they come: a ten-millionth in size, and millions of lengths away.
TEST(AugmentPromises, TinyAndFarModelsBecomeWhatTheyDoAtHome)
{
  for (const auto& [name, scale, shift] : { std::make_tuple("dirty_tiny_scale.off", 1e7, Vector3(0, 0, 0)),
         std::make_tuple("dirty_far_from_origin.obj", 1.0, Vector3(-5e6, 3e6, -1e6)) })
  {
    const oversketch::Mesh model = exactModel(name);
    if (model.triangles.empty())
    {
      GTEST_SKIP() << "no shared data";
    }
    ASSERT_EQ(model.points.size(), 829u) << name;
    ASSERT_EQ(model.triangles.size(), 1654u) << name;
    oversketch::Mesh home = model;
    for (Vector3& p : home.points)
    {
      p = scale * (p + shift);
    }
    System there(toPolyData(model), { vein(200) }), here(toPolyData(home), { vein(200) });
    vtkPolyData *away = there.run(), *near = here.run();
    EXPECT_GT(near->GetNumberOfPolys(), 1654);
    expectSameConnectivity(away, near);
    ASSERT_EQ(away->GetNumberOfPoints(), near->GetNumberOfPoints()) << name;
    double worst = 0.0;
    for (vtkIdType i = 0; i < away->GetNumberOfPoints(); ++i)
    {
      worst = std::max(worst, (scale * (pointOf(away, i) + shift) - pointOf(near, i)).norm());
    }
    EXPECT_LT(worst, 1e-6 * here.diagonal()) << name;
  }
}

TEST(AugmentPromises, ADirtyMeshIsRefusedByNameOrMadeASoundOne)
{
  const std::map<std::string, const char*> refused{ { "nonmanifold_edges.obj", "edge" },
    { "inside_out.obj", nullptr },
    { "holes.obj", nullptr },
    { "far_from_origin.obj", "without area" },
    { "klein_bottle.obj", "" } };
  for (const auto& [name, words] : refused)
  {
    const std::string path = sharedData("meshes/dirty_" + name);
    if (path.empty())
    {
      GTEST_SKIP() << "no shared data";
    }
    System s(objModel("dirty_" + name), { vein(200) });
    if (words)
    {
      expectRefusal(s.filter, Failure::BadMesh, words);
    }
    else
    {
      EXPECT_GT(s.run()->GetNumberOfPolys(), s.mesh->GetNumberOfPolys()) << name;
    }
  }
}

TEST(AugmentPromises, CancelledInAnyStageTheNextRunIsWhole)
{
  for (const int mode : { vtkOversketchAugment::Surface, vtkOversketchAugment::Silhouette })
  {
    System whole(shippedModel("dog"));
    if (mode == vtkOversketchAugment::Silhouette)
    {
      whole.strokes = strokesOf({ overTheTop(whole) }, whole.view);
      whole.filter->SetStrokesData(whole.strokes);
      whole.filter->SetSketchMode(vtkOversketchAugment::Silhouette);
    }
    whole.run();
    std::set<std::string> stopped;
    for (int i = 0; i < whole.filter->GetNumberOfStages(); ++i)
    {
      System s(whole.mesh);
      s.filter->SetStrokesData(whole.strokes);
      s.filter->SetSketchMode(mode);
      std::string stage = s.filter->GetStage(i);
      vtkNew<vtkCallbackCommand> stop;
      stop->SetClientData(&stage);
      stop->SetCallback(
        [](vtkObject* caller, unsigned long, void* name, void*)
        {
          auto* filter = static_cast<vtkOversketchAugment*>(caller);
          if (*static_cast<std::string*>(name) == filter->GetStageName())
          {
            filter->AbortExecuteOn();
          }
        });
      const unsigned long tag = s.filter->AddObserver(vtkCommand::ProgressEvent, stop);
      Ear ear(s.filter);
      s.filter->Update();
      EXPECT_TRUE(ear.errors.empty());
      if (s.filter->GetErrorCode() == codeOf(Failure::Cancelled))
      {
        stopped.insert(stage);
        EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
      }
      s.filter->RemoveObserver(tag);
      s.filter->AbortExecuteOff();
      s.filter->Modified();
      expectSame(whole.filter->GetOutput(), s.run());
    }
    for (const char* stage : { "Base", "Refine", "Snap", "Displace" })
    {
      EXPECT_TRUE(stopped.count(stage)) << stage;
    }
  }
}
