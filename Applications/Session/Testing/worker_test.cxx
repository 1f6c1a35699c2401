// Sessions on a thread of their own: the newest wins, a cancelled one leaves nothing behind.
#include "sessions.h"

#include "models.h"
#include "session_file.h"
#include "worker.h"

#include "Harness/polydata.h"

#include "vtkMassProperties.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <random>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

// Collects what a worker tells, and waits for it.
struct Desk
{
  std::mutex mutex;
  std::condition_variable told;
  std::vector<Worker::Result> done;
  std::vector<Worker::Details> details;
  std::vector<std::uint64_t> cancelled;
  std::vector<std::string> stages;
  std::vector<SharedData> glances;
  std::size_t pictures = 0;

  Worker::Listener listener()
  {
    Worker::Listener listener;
    listener.done = [this](const Worker::Result& result)
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->done.push_back(result);
      this->told.notify_all();
    };
    listener.detailed = [this](const Worker::Details& following)
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->details.push_back(following);
      this->told.notify_all();
    };
    listener.cancelled = [this](std::uint64_t ticket)
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->cancelled.push_back(ticket);
      this->told.notify_all();
    };
    listener.evaluatedAside = [this](const SharedData& mesh)
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->glances.push_back(mesh);
      this->told.notify_all();
    };
    listener.pictured = [this](std::uint64_t, std::size_t, const std::shared_ptr<const Thumbnail>&)
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      ++this->pictures;
      this->told.notify_all();
    };
    listener.progress = [this](std::uint64_t, std::size_t, const std::string& stage, double)
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->stages.push_back(stage);
      this->told.notify_all();
    };
    return listener;
  }
  template <typename Condition>
  bool wait(const Condition& condition)
  {
    std::unique_lock<std::mutex> lock(this->mutex);
    return this->told.wait_for(lock, std::chrono::seconds(60), condition);
  }
};

// What the evaluator gives, to be asked while no worker runs: VTK's thread pool is one for the process.
std::string expectedOf(const Session& session)
{
  std::vector<Outcome> outcomes;
  Evaluator evaluator;
  EXPECT_TRUE(evaluator.run(session, {}, outcomes));
  return digestOf(outcomes.back().mesh);
}

} // namespace

TEST(Worker, GivesWhatTheEvaluatorGives)
{
  const Session session = dogSession();
  std::vector<Outcome> outcomes;
  Evaluator evaluator;
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  Desk desk;
  Worker worker(desk.listener());
  const std::uint64_t ticket = worker.submit(session);
  ASSERT_TRUE(desk.wait([&] { return !desk.done.empty(); }));
  const Worker::Result& result = desk.done[0];
  EXPECT_EQ(result.ticket, ticket);
  EXPECT_TRUE(identical(result.mesh, outcomes[1].mesh));
  ASSERT_EQ(result.nodes.size(), 2u);
  EXPECT_EQ(result.nodes[1].section->middle, outcomes[1].section->middle);
  EXPECT_GT(result.nodes[1].hold->GetNumberOfPoints(), 1);
  EXPECT_EQ(result.backendUsed, int(vtkOversketchOneStroke::Host));
}

TEST(Worker, AGlanceGivesAnEarlierMeshAndChangesNothing)
{
  const Session session = dogSession();
  Session before = session, none = session;
  before.nodes.resize(1);
  none.nodes.clear();
  const std::string expected = expectedOf(before);
  Desk desk;
  Worker worker(desk.listener());
  worker.submit(session);
  ASSERT_TRUE(desk.wait([&] { return !desk.details.empty(); }));
  const std::size_t stages = desk.stages.size();
  const auto glance = [&](const Session& at)
  {
    worker.evaluateAside(at);
    EXPECT_TRUE(desk.wait([&] { return !desk.glances.empty(); }));
    const vtkSmartPointer<vtkPolyData> mesh = desk.glances.at(0).own();
    desk.glances.clear();
    EXPECT_TRUE(mesh->GetPointData()->GetNormals());
    mesh->GetPointData()->SetNormals(nullptr);
    return digestOf(mesh);
  };
  EXPECT_EQ(glance(before), expected);
  EXPECT_EQ(glance(none), digestOf(session.mesh));
  EXPECT_EQ(desk.stages.size(), stages) << "a step was run for it";
  EXPECT_EQ(desk.done.size(), 1u);
  // What is submitted goes before it.
  worker.evaluateAside(before);
  worker.submit(session);
  ASSERT_TRUE(desk.wait([&] { return desk.done.size() == 2; }));
  EXPECT_TRUE(identical(desk.done[0].mesh, desk.done[1].mesh));
}

TEST(Worker, WhatAGlanceInterruptsGoesOn)
{
  Session session = dogSession();
  Session none = session;
  none.nodes.clear();
  Desk desk;
  std::vector<std::uint64_t> traced;
  std::vector<std::size_t> pictured;
  Worker* worker = nullptr;
  Worker::Listener listener = desk.listener();
  // Before anything of what comes after the details could begin.
  listener.detailed = [&, inner = listener.detailed](const Worker::Details& details)
  {
    worker->evaluateAside(none);
    inner(details);
  };
  listener.traced = [&](std::uint64_t ticket, const std::vector<SharedData>&)
  {
    const std::lock_guard<std::mutex> lock(desk.mutex);
    EXPECT_EQ(desk.glances.size(), 1u) << "not interrupted";
    traced.push_back(ticket);
  };
  listener.pictured = [&](std::uint64_t, std::size_t node, const std::shared_ptr<const Thumbnail>&)
  {
    const std::lock_guard<std::mutex> lock(desk.mutex);
    pictured.push_back(node);
    desk.told.notify_all();
  };
  Worker busy(listener);
  worker = &busy;
  const std::uint64_t ticket = busy.submit(session);
  ASSERT_TRUE(desk.wait([&] { return pictured.size() == 2; })) << "nothing more was prepared";
  EXPECT_EQ(traced, std::vector<std::uint64_t>{ ticket });
  EXPECT_EQ(pictured, (std::vector<std::size_t>{ 1, 0 }));
  EXPECT_EQ(desk.done.size(), 1u);
}

TEST(Worker, HandsTheMeshOverFirstAndCopiesOnlyWhatRan)
{
  Session session = dogSession();
  Desk desk;
  Worker worker(desk.listener());
  worker.submit(session);
  ASSERT_TRUE(desk.wait([&] { return !desk.details.empty(); }));
  {
    const std::lock_guard<std::mutex> lock(desk.mutex);
    ASSERT_EQ(desk.done.size(), 1u);
    EXPECT_FALSE(desk.done[0].nodes[1].region || desk.done[0].nodes[1].following) << "they came first";
    EXPECT_EQ(desk.details[0].ticket, desk.done[0].ticket);
    EXPECT_EQ(desk.details[0].digest, digestOf(desk.done[0].mesh));
    for (const Worker::NodeState& node : desk.details[0].nodes)
    {
      ASSERT_TRUE(node.region && node.following && node.hold);
      EXPECT_GT(node.region->GetNumberOfPolys(), 10);
    }
    vtkNew<vtkMassProperties> part, whole;
    part->SetInputData(desk.details[0].nodes[1].region.own());
    whole->SetInputData(desk.done[0].mesh.own());
    EXPECT_NEAR(desk.details[0].nodes[1].share, part->GetSurfaceArea() / whole->GetSurfaceArea(), 1e-9)
      << "by area: a line's own triangles are small and many";
  }
  session.nodes[1] = changed(session.nodes[1], [](Step& step) { step.values["AdjustNormals"] = true; });
  worker.submit(session);
  ASSERT_TRUE(desk.wait([&] { return desk.details.size() == 2; }));
  const auto &before = desk.details[0].nodes, &after = desk.details[1].nodes;
  EXPECT_EQ(before[0].region.identity(), after[0].region.identity()) << "copied again";
  EXPECT_EQ(before[0].hold.identity(), after[0].hold.identity()) << "copied again";
  EXPECT_EQ(desk.done[1].nodes[0].following, before[0].following) << "known with the mesh";
  EXPECT_NE(before[1].region.identity(), after[1].region.identity());
}

TEST(Worker, AMeshThatStaysHasItsNormalsOnce)
{
  Session session = dogSession();
  Desk desk;
  Worker worker(desk.listener());
  const auto shown = [&](const Session& of)
  {
    const std::size_t before = desk.done.size();
    worker.submit(of);
    EXPECT_TRUE(desk.wait([&] { return desk.done.size() > before; }));
    return desk.done.back().display;
  };
  const SharedData first = shown(session);
  session.nodes[1].on = false;
  const SharedData other = shown(session);
  session.nodes[1].name = "renamed";
  const SharedData same = shown(session);
  EXPECT_FALSE(isShallowCopy(first, other));
  EXPECT_TRUE(isShallowCopy(other, same));
}

// What is given back while the mesh is looked at elsewhere is made again with the same bits.
TEST(Worker, WhatIsGivenBackIsMadeAgainWithTheSameBits)
{
  const Session session = dogSession();
  Session shorter = session, other = session;
  shorter.nodes.pop_back();
  other.nodes[1] = changed(
    other.nodes[1], [](Step& step) { step.values["Remesh"] = int(vtkOversketchOneStroke::RemeshOn); });
  const std::vector<Session> sessions{ shorter, session, other, session };
  std::vector<std::string> expected;
  expected.reserve(sessions.size());
  for (const Session& each : sessions)
  {
    expected.push_back(expectedOf(each));
  }
  Desk desk;
  Worker worker(desk.listener());
  worker.keepWorkUpTo(0);
  for (std::size_t i = 0; i < sessions.size(); ++i)
  {
    const std::uint64_t ticket = worker.submit(sessions[i]);
    ASSERT_TRUE(desk.wait([&] { return desk.done.size() == i + 1; }));
    worker.seen(ticket);
    const SharedData& mesh = desk.done[i].mesh;
    EXPECT_EQ(digestOf(mesh), expected[i]); // while the worker gives back
    EXPECT_GT(mesh->GetLength(), 0.0);
    ASSERT_TRUE(desk.wait([&] { return desk.details.size() == i + 1; }));
    EXPECT_EQ(desk.details[i].digest, expected[i]);
  }
}

TEST(Worker, WaitsWithWhatComesAfterTheMeshUntilThatIsSeen)
{
  using Clock = std::chrono::steady_clock;
  const auto told = [](bool isSeen)
  {
    Desk desk;
    Clock::time_point done, detailed;
    Worker::Listener listener = desk.listener();
    Worker* told = nullptr;
    listener.done = [&](const Worker::Result& result)
    {
      done = Clock::now();
      if (isSeen)
      {
        told->seen(result.ticket);
      }
    };
    listener.detailed = [&, inner = listener.detailed](const Worker::Details& details)
    {
      detailed = Clock::now();
      inner(details);
    };
    Worker worker(listener);
    told = &worker;
    worker.submit(dogSession());
    EXPECT_TRUE(desk.wait([&] { return !desk.details.empty(); }));
    return std::chrono::duration<double, std::milli>(detailed - done).count();
  };
  EXPECT_GE(told(false), 150.0);
  double least = 150.0; // whatever else the machine does
  for (int i = 0; i < 5 && least >= 150.0; ++i)
  {
    least = std::min(least, told(true));
  }
  EXPECT_LT(least, 150.0);
}

TEST(Worker, AnswersASessionWithoutAMesh)
{
  Desk desk;
  Worker worker(desk.listener());
  worker.submit({});
  ASSERT_TRUE(desk.wait([&] { return !desk.details.empty(); }));
  EXPECT_FALSE(desk.done[0].mesh || desk.done[0].display);
  EXPECT_EQ(desk.details[0].digest, "");
}

TEST(Worker, TheNewestSessionWins)
{
  Session session = dogSession();
  const std::string expected = expectedOf(session);
  Desk desk;
  Worker worker(desk.listener());
  std::uint64_t last = 0;
  constexpr int count = 5;
  for (int i = 0; i < count; ++i)
  {
    session.nodes[0].on = i % 2 == 0; // in the last one as at first
    last = worker.submit(session);
  }
  ASSERT_TRUE(desk.wait([&] { return !desk.done.empty() && desk.done.back().ticket == last; }));
  EXPECT_EQ(desk.done.size() + desk.cancelled.size(), std::size_t(count)) << "each is answered once";
  EXPECT_EQ(digestOf(desk.done.back().mesh), expected);
}

TEST(Worker, CancelStopsWhatRunsAndTheNextRunIsWhole)
{
  const std::string expected = expectedOf(dogSession());
  Desk desk;
  Worker worker(desk.listener());
  const std::uint64_t ticket = worker.submit(dogSession());
  ASSERT_TRUE(desk.wait([&] { return !desk.stages.empty(); }));
  worker.cancel();
  ASSERT_TRUE(desk.wait([&] { return !desk.cancelled.empty() || !desk.done.empty(); }));
  ASSERT_EQ(desk.cancelled.size(), 1u);
  EXPECT_EQ(desk.cancelled[0], ticket);
  worker.submit(dogSession());
  ASSERT_TRUE(desk.wait([&] { return !desk.done.empty(); }));
  EXPECT_EQ(digestOf(desk.done[0].mesh), expected);
}

// An interface waits until its newest session is answered: one that is lost would make it wait for ever.
TEST(Worker, AnswersEachSessionOnceWhateverComesBetween)
{
  Session ball;
  ball.mesh = toPolyData(icosphere(2));
  ball.backend = vtkOversketchOneStroke::Host;
  const oversketch::View view = orthographicView({ 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 }, 30.0, 100, 100);
  for (const double away : { 4.0, 8.0, 12.0 })
  {
    std::vector<oversketch::Vector2> line;
    for (int i = -10; i <= 10; ++i)
    {
      line.push_back({ 50.0 + 2.0 * i, 80.0 + away - 0.06 * i * i });
    }
    ball.nodes.push_back(nodeOf(toStroke(line, view), "bulge", freshId(ball)));
  }
  std::vector<std::string> expected; // of so many strokes
  for (std::size_t count = 0; count <= ball.nodes.size(); ++count)
  {
    Session session = ball;
    session.nodes.resize(count);
    Evaluator evaluator;
    std::vector<Outcome> outcomes;
    ASSERT_TRUE(evaluator.run(session, {}, outcomes));
    for (const Outcome& outcome : outcomes)
    {
      ASSERT_EQ(outcome.failure, "");
    }
    expected.push_back(digestOf(resultOf(session, outcomes)));
  }

  std::mt19937 random(1);
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  std::map<std::uint64_t, std::string> wanted;
  std::map<std::uint64_t, int> answers;
  std::size_t done = 0, cancelled = 0;
  for (int worker = 0; worker < 20; ++worker)
  {
    wanted.clear();
    answers.clear();
    Desk desk;
    Worker busy(desk.listener());
    for (int i = 0; i < 100; ++i)
    {
      Session session = ball; // often one that goes on where another runs
      session.nodes.resize(static_cast<std::size_t>(below(4)));
      const std::uint64_t ticket = busy.submit(session);
      wanted[ticket] = expected[session.nodes.size()];
      answers[ticket] = 0;
      switch (below(8))
      {
        case 0:
          busy.cancel();
          break;
        case 1:
          ASSERT_TRUE(desk.wait([&] { return desk.done.size() + desk.cancelled.size() == wanted.size(); }));
          break;
        case 2:
          std::this_thread::yield();
          break;
        default:
          break;
      }
    }
    ASSERT_TRUE(desk.wait([&] { return desk.done.size() + desk.cancelled.size() >= wanted.size(); }));
    const std::lock_guard<std::mutex> lock(desk.mutex);
    for (const Worker::Result& result : desk.done)
    {
      ++answers[result.ticket];
      EXPECT_EQ(digestOf(result.mesh), wanted[result.ticket]);
    }
    for (const std::uint64_t ticket : desk.cancelled)
    {
      ++answers[ticket];
    }
    EXPECT_EQ(answers.size(), wanted.size());
    for (const auto& [ticket, times] : answers)
    {
      EXPECT_EQ(times, 1) << "ticket " << ticket << " of worker " << worker;
    }
    done += desk.done.size();
    cancelled += desk.cancelled.size();
  }
  std::cout << done << " done, " << cancelled << " cancelled\n";
  EXPECT_GT(done, 100u);
  EXPECT_GT(cancelled, 100u);
}

TEST(Worker, AStrokeAfterThePreparationComputesNoShapeDiameter)
{
  Session session = dogSession();
  const Node second = session.nodes.back();
  session.nodes.pop_back();
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  evaluator.prepare(*findSystem("OneStroke"), outcomes[0].mesh, session.backend, {});
  session.nodes.push_back(second);
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  EXPECT_EQ(evaluator.runs(), 2u);
  const double prepared = evaluator.system("OneStroke")->GetStageTime("ShapeDiameter");
  Evaluator cold;
  std::vector<Outcome> same;
  ASSERT_TRUE(cold.run(session, {}, same));
  EXPECT_TRUE(identical(outcomes[1].mesh, same[1].mesh));
  EXPECT_LT(prepared, 0.1 * cold.system("OneStroke")->GetStageTime("ShapeDiameter"));
}

TEST(Worker, EndsAtOnceInTheMiddleOfARun)
{
  for (int i = 0; i < 5; ++i)
  {
    Desk desk;
    {
      Worker worker(desk.listener());
      worker.submit(dogSession());
      desk.wait([&] { return desk.stages.size() >= static_cast<std::size_t>(i); });
    }
    EXPECT_TRUE(desk.done.empty() || desk.done[0].mesh);
  }
}
