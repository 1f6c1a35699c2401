// Edits in a session: curves of an earlier step by reference, what runs again, the file, both sides of a
// plane.
#include "sessions.h"

#include "Harness/edits.h"
#include "Harness/executions.h"
#include "Harness/polydata.h"
#include "Harness/strokes.h"
#include "session_file.h"
#include "system_runner.h"
#include "worker.h"

#include "vtkOversketchSystem.h"

#include "vtkPointLocator.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

std::vector<Vector2> shifted(std::vector<Vector2> samples, double by)
{
  for (Vector2& sample : samples)
  {
    sample[0] += by;
  }
  return samples;
}

Node editNode(int id, const Values& values)
{
  auto step = std::make_shared<Step>();
  step->system = "Edit";
  step->values = values;
  Node node;
  node.id = id;
  node.name = "Edit " + std::to_string(id);
  node.step = step;
  return node;
}

// A line and a ring on the model, so many pixels beside its middle.
Node drawnEdit(int id, vtkPolyData* mesh, const Values& values, double aside = 0.0)
{
  const View view = frontOf(mesh);
  return changed(editNode(id, values),
    [&](Step& step)
    {
      step.inputs["Reference"] = Lines(toStroke(shifted(lineOver(40.0), aside), view));
      step.inputs["Boundary"] = Lines(toStroke(shifted(ringOver(40.0), aside), view));
    });
}

Node furtherEdit(int id, int of, const Values& values)
{
  return changed(editNode(id, values),
    [of](Step& step)
    {
      step.inputs["Reference"] = StepOutput{ of, 1 };
      step.inputs["Boundary"] = StepOutput{ of, 2 };
    });
}

// Pulled, then turned by the curves of the pull.
Session bearSession()
{
  Session session;
  session.meshName = "bear.ply";
  session.mesh = shippedModel("bear");
  session.backend = 2;
  session.nodes = { drawnEdit(1, session.mesh.Get(), { { "Operations", std::string("move 0.5 n 0.05") } }),
    furtherEdit(2, 1, { { "Operations", std::string("rotate 0.5 t 15") } }) };
  return session;
}

} // namespace

TEST(EditSession, AStepTakesTheCurvesOfAnEarlierOne)
{
  Session session = bearSession();
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  EXPECT_EQ(outcomes[0].failure.text() + outcomes[1].failure.text(), "");
  EXPECT_EQ(evaluator.runs(), 2u);
  const std::string pulled = digestOf(outcomes[0].mesh), turned = digestOf(outcomes[1].mesh);
  EXPECT_NE(pulled, turned);
  ASSERT_TRUE(outcomes[0].outputs.at(1)->IsA("vtkPolyData"));

  // Another turn runs that step alone; another pull both, as if it had been so from the start.
  session.nodes[1] =
    changed(session.nodes[1], [](Step& step) { step.values["Operations"] = std::string("rotate 0.5 t 20"); });
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  EXPECT_EQ(evaluator.runs(), 3u);
  EXPECT_EQ(digestOf(outcomes[0].mesh), pulled);
  session.nodes[0] =
    changed(session.nodes[0], [](Step& step) { step.values["Operations"] = std::string("move 0.5 n 0.03"); });
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  EXPECT_EQ(evaluator.runs(), 5u);
  EXPECT_EQ(outcomes[1].failure, "");
  EXPECT_EQ(digestOf(outcomesOf(session)[1].mesh), digestOf(outcomes[1].mesh));

  // A pull that is off has no curves.
  session.nodes[0].on = false;
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  EXPECT_EQ(outcomes[1].failure, "its input 'Reference' is of 'Edit 1', which is off");
}

TEST(EditSession, TheFileSaysAllOfItAndReplaysToTheBit)
{
  const Session session = bearSession();
  const std::string digest = digestOf(outcomesOf(session).back().mesh);
  Encoder encoder;
  const Package package = encoder.encode({ session, originHere(2), digest });
  EXPECT_NE(package.at(sessionEntry)->find("\"format_version\" : 2"), std::string::npos);
  const SessionFile again = decode(package, "edit");
  ASSERT_EQ(again.session.nodes.size(), 2u);
  EXPECT_EQ(std::get<StepOutput>(again.session.nodes[1].step->inputs.at("Boundary")).port, 2);
  EXPECT_EQ(digestOf(outcomesOf(again.session).back().mesh), digest);
}

// All that a step may hold: redrawn lines, a profile, areas and layers, an image.
TEST(EditSession, EachInputActs)
{
  Session session;
  session.mesh = shippedModel("bear");
  session.backend = 2;
  const Node node = drawnEdit(1, session.mesh.Get(), { { "Operations", std::string("move 0.5 n 0.05") } });
  session.nodes = { node };
  std::set<std::string> digests{ digestOf(outcomesOf(session)[0].mesh) };
  const auto add = [&](const char* what, const auto& change)
  {
    session.nodes = { changed(node, change) };
    const std::vector<Outcome> outcomes = outcomesOf(session);
    EXPECT_EQ(outcomes[0].failure, "") << what;
    EXPECT_TRUE(digests.insert(digestOf(outcomes[0].mesh)).second) << what << " changes nothing";
  };
  const View view = frontOf(session.mesh.Get());
  add("redrawn",
    [&](Step& step)
    {
      step.inputs["Boundary"] = Lines(toStrokes({ { ringOver(40.0), view },
        { { { 440, 280 }, { 455, 290 }, { 458, 300 }, { 455, 310 }, { 440, 322 } }, view } }));
    });
  vtkNew<vtkPolyData> line;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(4);
  for (const auto& [x, y] :
    { std::pair(-0.5, -0.5), std::pair(0.5, -0.5), std::pair(0.5, 0.5), std::pair(-0.5, 0.5) })
  {
    cells->InsertCellPoint(points->InsertNextPoint(x, y, 0.0));
  }
  line->SetPoints(points);
  line->SetLines(cells);
  add("areas",
    [&](Step& step)
    {
      step.inputs["Areas"] = Lines(line);
      step.values["Layers"] = std::string("area 0 9; handle 0.5 0.2");
    });
  add("layers", [](Step& step) { step.values["Layers"] = std::string("handle 0.5 0.8"); });
  vtkNew<vtkPolyData> profile;
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> polyline;
  polyline->InsertNextCell({ places->InsertNextPoint(0.0, 0.0, 0.0),
    places->InsertNextPoint(0.4, 0.4, 0.0),
    places->InsertNextPoint(1.0, 0.0, 0.0) });
  profile->SetPoints(places);
  profile->SetLines(polyline);
  add("profile",
    [&](Step& step)
    {
      step.values.erase("Operations");
      step.inputs["Profile"] = Lines(profile);
    });
  session.nodes = { changed(node, [](Step& step) { step.inputs.erase("Boundary"); }) };
  EXPECT_EQ(outcomesOf(session)[0].failure, "its input 'Boundary' is missing");
}

// The bear is the same on both sides of x = 0: so is what an edit on one side makes with a mirror.
TEST(EditSession, ItActsOnBothSides)
{
  Session session;
  session.mesh = shippedModel("bear");
  session.backend = 2;
  const Values values{ { "Operations", std::string("move 0.5 n 0.08; rotate 0.5 t 20") } };
  const Node node = drawnEdit(1, session.mesh.Get(), values, 60.0);
  session.nodes = { changed(node, [](Step& step) { step.mirror = MirrorPlane{ 0, 0.0 }; }) };
  const std::vector<Outcome> both = outcomesOf(session);
  ASSERT_EQ(both[0].failure, "");
  session.nodes = { node };
  const std::vector<Outcome> one = outcomesOf(session);
  const double meanEdge = one[0].mesh->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0);
  const auto farthest = [&](vtkPolyData* mesh)
  {
    vtkNew<vtkPointLocator> locator;
    locator->SetDataSet(mesh);
    locator->BuildLocator();
    double worst = 0.0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3], q[3];
      mesh->GetPoint(i, p);
      p[0] = -p[0];
      mesh->GetPoint(locator->FindClosestPoint(p), q);
      worst = std::max(worst, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
    return worst;
  };
  EXPECT_GT(farthest(one[0].mesh), 0.5 * meanEdge);
  EXPECT_LT(farthest(both[0].mesh), 1e-3 * meanEdge);
  EXPECT_GT(both[0].mesh->GetNumberOfPoints(), one[0].mesh->GetNumberOfPoints() - 200);

  // A line over the plane itself acts once.
  const Node middle = drawnEdit(1, session.mesh.Get(), values);
  session.nodes = { middle };
  const std::string once = digestOf(outcomesOf(session)[0].mesh);
  session.nodes = { changed(middle, [](Step& step) { step.mirror = MirrorPlane{ 0, 0.0 }; }) };
  EXPECT_EQ(digestOf(outcomesOf(session)[0].mesh), once);
}

TEST(EditSession, EachStepComesWithWhatItActsOn)
{
  const Session session = bearSession();
  const std::vector<Outcome> outcomes = outcomesOf(session);
  std::mutex mutex;
  std::condition_variable told;
  std::vector<Worker::Result> done;
  Worker::Listener listener;
  listener.done = [&](const Worker::Result& result)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    done.push_back(result);
    told.notify_all();
  };
  Worker worker(listener);
  const auto last = [&](std::size_t count)
  {
    std::unique_lock<std::mutex> lock(mutex);
    EXPECT_TRUE(told.wait_for(lock, std::chrono::seconds(60), [&] { return done.size() >= count; }));
    return done.empty() ? Worker::Result() : done.back();
  };
  worker.submit(session);
  const Worker::Result result = last(1);
  ASSERT_EQ(result.nodes.size(), 2u);
  EXPECT_EQ(result.nodes[0].before.identity(), session.mesh.identity());
  EXPECT_TRUE(result.nodes[0].given.empty());
  ASSERT_NE(result.nodes[1].before.Get(), nullptr);
  EXPECT_EQ(digestOf(result.nodes[1].before), digestOf(outcomes[0].mesh));
  for (const int port : { 1, 2 })
  {
    const char* name = port == 1 ? "Reference" : "Boundary";
    ASSERT_EQ(result.nodes[1].given.count(name), 1u) << name;
    vtkPolyData* given = result.nodes[1].given.at(name);
    EXPECT_EQ(given->GetNumberOfPoints(),
      vtkPolyData::SafeDownCast(outcomes[0].outputs.at(port))->GetNumberOfPoints());
  }
  // What has not changed is the same data again: a hand that holds it need not begin anew.
  const Worker::Result again = (worker.submit(session), last(2));
  EXPECT_EQ(again.nodes[1].before.identity(), result.nodes[1].before.identity());
  EXPECT_EQ(again.nodes[1].given.at("Boundary").identity(), result.nodes[1].given.at("Boundary").identity());
}
