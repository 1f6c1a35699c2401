// What system C promises of bad drawings, of cancelling, of threads and of what it computes anew.
#include "DrawingRuns.h"

#include "vtkOversketchClassify.h"
#include "vtkOversketchDistance.h"
#include "vtkOversketchInflate.h"
#include "vtkOversketchPlanarRefine.h"

#include "vtkSMPTools.h"

using namespace oversketch;
using namespace oversketch_test;

namespace
{

std::vector<Line> face()
{
  return { circle(400, 300, 220),
    circle(320, 360, 40),
    circle(480, 360, 40),
    { { { 320, 220 }, { 400, 190 }, { 480, 220 } }, false } };
}

// Classifications, distances, refinements, thicknesses and ratios that were computed.
using Counts = std::array<vtkIdType, 5>;

Counts countsOf(System& system)
{
  auto* inflate = system.step<vtkOversketchInflate>("Inflate");
  return { system.step<vtkOversketchClassify>("Classify")->GetClassificationCount(),
    system.step<vtkOversketchDistance>("Distance")->GetDistanceCount(),
    system.step<vtkOversketchPlanarRefine>("Refine")->GetRefineCount(),
    inflate->GetThicknessCount(),
    inflate->GetRatioCount() };
}

// Cancels a run in the step of this name: it ends silently, empty, and what comes after the step does not
// run.
void expectStopIn(vtkOversketchInflateDrawing* filter, std::string step)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&step);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* name, void*)
    {
      auto* system = static_cast<vtkOversketchInflateDrawing*>(caller);
      if (*static_cast<std::string*>(name) == system->GetStageName())
      {
        system->AbortExecuteOn();
      }
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  Ear ear(filter);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), codeOf(Failure::Cancelled));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(ear.errors.empty());
  bool after = false;
  for (int i = 0; i < filter->GetNumberOfStages(); ++i)
  {
    EXPECT_TRUE(!after || filter->GetStageTime(filter->GetStage(i)) == 0.0) << filter->GetStage(i);
    after = after || filter->GetStage(i) == step;
  }
  filter->RemoveObserver(tag);
  filter->AbortExecuteOff();
  filter->Modified();
}

} // namespace

TEST(InflateDrawingPromises, OnlyWhatIsReadIsComputedAnew)
{
  const auto lines = face();
  System system(drawn({ lines[0], lines[1], lines[2] }));
  system.mesh();
  Counts was = countsOf(system);
  EXPECT_EQ(was, (Counts{ 1, 1, was[2], 0, 1 })) << "once each, the mesh once and for every rebuild";
  EXPECT_EQ(was[2], 1 + system.filter->GetRebuilds());
  system.filter->SetInputData(0, drawn(lines));
  system.mesh();
  was[0] += 1;
  was[2] += 1 + system.filter->GetRebuilds();
  EXPECT_EQ(countsOf(system), was) << "a further feature measures and solves nothing";
  system.filter->SetHeight(0.7);
  system.mesh();
  EXPECT_EQ(countsOf(system), was) << "nor does another height";
  system.filter->SetProfile("linear");
  system.mesh();
  was[3] = countsOf(system)[3];
  was[4] = countsOf(system)[4];
  EXPECT_EQ(countsOf(system), was) << "a profile makes no mesh";
  system.filter->SetTunnels("1");
  system.mesh();
  EXPECT_EQ(countsOf(system)[0], was[0]) << "a treatment labels nothing";
  EXPECT_EQ(countsOf(system)[1], was[1]) << "tunnels are no rims";
  const vtkMTimeType time = system.filter->GetOutput()->GetMTime();
  system.filter->Update();
  EXPECT_EQ(system.filter->GetOutput()->GetMTime(), time) << "nothing has changed";
}

TEST(InflateDrawingPromises, SameBitsForAnyThreadsColdAndKept)
{
  const auto strokes = drawn(face());
  vtkNew<vtkPolyData> alone;
  vtkSMPTools::Initialize(1);
  {
    System system(strokes);
    system.filter->SetHoles("1");
    alone->DeepCopy(system.mesh());
  }
  vtkSMPTools::Initialize(2);
  System system(strokes);
  system.mesh();
  system.filter->SetLevels(2);
  system.mesh();
  system.filter->SetLevels(3);
  system.filter->SetHoles("1");
  EXPECT_TRUE(identical(system.mesh(), alone));
  vtkSMPTools::Initialize();
}

TEST(InflateDrawingPromises, BadDrawingsAreRefusedInWords)
{
  std::vector<Vector2> eight;
  const std::vector<Vector2> wild = { { 100, 100 }, { std::nan(""), 200 }, { 300, 100 } };
  for (int i = 0; i < 200; ++i)
  {
    const double t = 2.0 * pi * i / 200.0;
    eight.emplace_back(400.0 + 200.0 * std::sin(t), 300.0 + 150.0 * std::sin(2.0 * t));
  }
  const struct
  {
    std::vector<Line> lines;
    const char* words;
  } cases[] = {
    { { { eight, true } },
      "crosses itself near (400, 300); draw it without the loop. Or let strokes cross: turn Arrange on." },
    { { circle(400, 300, 200), circle(600, 300, 100) }, "crosses stroke 1 near" },
    { { circle(400, 300, 200), circle(600, 300, 100) }, "anew. Or let strokes cross: turn Arrange on." },
    { { { { { 100, 100 }, { 300, 200 } }, false } }, "bounds an object" },
    { { { wild, false } }, "finite" }
  };
  for (const auto& one : cases)
  {
    SCOPED_TRACE(one.words);
    System system(drawn(one.lines));
    expectRefusal(system.filter, Failure::BadStroke, one.words);
    system.filter->SetInputData(0, drawn({ circle(400, 300, 100) }));
    EXPECT_EQ(topologyOf(system.mesh()).chi, 2) << "a sound one after it";
  }
  System system(drawn({ circle(400, 300, 100) }));
  system.filter->SetHoles("7");
  expectRefusal(system.filter, Failure::BadStroke, "7");
  system.filter->SetHoles("");
  // What has nothing to do with crossing says nothing of it; where strokes may cross already, nothing does.
  system.filter->SetInputData(0, drawn({ { { { 100, 100 }, { 300, 200 } }, false } }));
  Ear open(system.filter);
  system.filter->Update();
  ASSERT_EQ(open.errors.size(), 1u);
  EXPECT_EQ(open.errors[0].find("Arrange"), std::string::npos) << open.errors[0];
  system.filter->SetInputData(0, drawn({ circle(400, 300, 100) }));
  system.filter->SetProfile("0 0, 1 nan");
  expectRefusal(system.filter, Failure::BadStroke, "rofile");
  vtkNew<vtkPolyData> nothing;
  System empty(nothing);
  Ear ear(empty.filter);
  EXPECT_EQ(empty.mesh()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(ear.errors.empty());
}

TEST(InflateDrawingPromises, ARunIsCancelledInEachStepAndMadeWhole)
{
  const auto strokes = drawn(face());
  const auto image = picture(800,
    600,
    1,
    [](int x, int y, int) { return (Vector2(x, y) - Vector2(400, 300)).norm() < 219.0 ? 220 : 30; });
  const auto prepare = [&](System& system, bool other)
  {
    system.filter->SetInputData(1, image);
    system.filter->MagneticOn();
    system.filter->SetLevels(2);
    system.filter->SetArrange(other);
    system.filter->SetQuads(other);
    system.filter->SetExtrudeDepth(other ? 20.0 : 0.0);
    system.filter->SetTunnels(other ? "1" : "");
  };
  std::set<std::string> stopped;
  for (const bool other : { false, true }) // inflated, and by all the other steps
  {
    System whole(strokes);
    prepare(whole, other);
    whole.mesh();
    EXPECT_EQ(topologyOf(whole.filter->GetOutput()).chi, other ? 0 : 2);
    for (int i = 0; i < whole.filter->GetNumberOfStages(); ++i)
    {
      const std::string name = whole.filter->GetStage(i);
      SCOPED_TRACE(name + (other ? ", the other steps" : ""));
      if (whole.filter->GetStageTime(name.c_str()) > 0.0)
      {
        System system(strokes);
        prepare(system, other);
        expectStopIn(system.filter, name);
        system.mesh();
        EXPECT_EQ(largestMove(system.filter->GetOutput(), whole.filter->GetOutput()), 0.0);
        EXPECT_EQ(cornersOf(system.filter->GetOutput()), cornersOf(whole.filter->GetOutput()));
        stopped.insert(name);
      }
    }
  }
  vtkNew<vtkPolyData> nothing;
  System traced(nothing);
  traced.filter->SetInputData(1, image);
  traced.filter->SetTrace("auto");
  expectStopIn(traced.filter, "Trace");
  EXPECT_EQ(topologyOf(traced.mesh()).chi, 2);
  stopped.insert("Trace");
  System layered(strokes);
  layered.filter->SetBothSides("1");
  layered.mesh();
  layered.filter->Modified();
  expectStopIn(layered.filter, "Layers");
  EXPECT_EQ(topologyOf(layered.mesh()).pieces, 3);
  stopped.insert("Layers");
  EXPECT_EQ(static_cast<int>(stopped.size()), System(strokes).filter->GetNumberOfStages()) << "every step";
}

TEST(InflateDrawingPromises, ProgressNeverFalls)
{
  System system(drawn(face()));
  system.filter->SetInFront("1"); // the run of a layer counts, too
  std::vector<double> shares;
  vtkNew<vtkCallbackCommand> hear;
  hear->SetClientData(&shares);
  hear->SetCallback([](vtkObject*, unsigned long, void* all, void* share)
    { static_cast<std::vector<double>*>(all)->push_back(*static_cast<double*>(share)); });
  system.filter->AddObserver(vtkCommand::ProgressEvent, hear);
  system.mesh();
  EXPECT_GT(shares.size(), 10u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_LE(shares.back(), 1.0);
}
