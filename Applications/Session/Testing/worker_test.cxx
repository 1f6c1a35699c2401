// Sessions on a thread of their own: the newest wins, a cancelled one leaves nothing behind.
#include "sessions.h"

#include "session_file.h"
#include "worker.h"

#include "Harness/polydata.h"

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
  std::vector<std::uint64_t> cancelled;
  std::vector<std::string> stages;

  Worker::Listener listener()
  {
    Worker::Listener listener;
    listener.done = [this](const Worker::Result& result)
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->done.push_back(result);
      this->told.notify_all();
    };
    listener.cancelled = [this](std::uint64_t ticket)
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->cancelled.push_back(ticket);
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
  EXPECT_EQ(result.digest, digestOf(outcomes[1].mesh));
  ASSERT_EQ(result.nodes.size(), 2u);
  EXPECT_EQ(result.nodes[1].section->middle, outcomes[1].section->middle);
  EXPECT_GT(result.nodes[1].matched->GetNumberOfPoints(), 1);
  EXPECT_EQ(result.backendUsed, int(vtkOversketchOneStroke::Host));
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
  EXPECT_EQ(desk.done.back().digest, expected);
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
  EXPECT_EQ(desk.done[0].digest, expected);
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
    ball.nodes.push_back(nodeOf(toStroke(line, view), "bulge"));
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
      EXPECT_EQ(result.digest, wanted[result.ticket]);
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
  evaluator.prepare(outcomes[0].mesh, {});
  session.nodes.push_back(second);
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  EXPECT_EQ(evaluator.runs(), 2u);
  const double prepared = evaluator.system()->GetStageTime("ShapeDiameter");
  Evaluator cold;
  std::vector<Outcome> same;
  ASSERT_TRUE(cold.run(session, {}, same));
  EXPECT_TRUE(identical(outcomes[1].mesh, same[1].mesh));
  EXPECT_LT(prepared, 0.1 * cold.system()->GetStageTime("ShapeDiameter"));
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
