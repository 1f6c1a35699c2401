// Undo and redo: what comes back, and what they cost.
#include "sessions.h"

#include "history.h"

#include "Harness/polydata.h"

#include <gtest/gtest.h>

#include <malloc.h>

#include <cmath>
#include <iostream>
#include <random>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

// Those of small blocks and of mapped ones.
double mebibytesInUse()
{
  const struct mallinfo2 info = ::mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / (1 << 20);
}

// Sixty samples with their view, as a hand draws them: no two alike.
vtkSmartPointer<vtkPolyData> drawn(int number)
{
  const double turn = 0.001 * number;
  const View view =
    orthographicView({ std::sin(turn), 0.0, std::cos(turn) }, { 0.0, 1.0, 0.0 }, 100.0, 1200, 800);
  std::vector<Vector2> line;
  line.reserve(60);
  for (int i = 0; i < 60; ++i)
  {
    line.emplace_back(100.0 + 10.0 * i + 0.37 * number, 300.0 + 100.0 * std::sin(0.1 * i + 0.01 * number));
  }
  return toStroke(line, view);
}

bool same(const Session& a, const Session& b)
{
  return a.meshName == b.meshName && a.mesh.identity() == b.mesh.identity() && a.backend == b.backend &&
         a.nodes == b.nodes;
}

} // namespace

TEST(History, UndoRedoAndANewBranch)
{
  const auto stroke = drawn(0);
  Session session;
  History history(session);
  EXPECT_FALSE(history.canUndo() || history.canRedo());
  for (int i = 0; i < 4; ++i)
  {
    session.nodes.push_back(nodeOf(stroke, std::to_string(i), i + 1));
    history.commit(session);
    session = history.now();
  }
  EXPECT_EQ(history.now().nodes.size(), 4u);
  history.undo();
  history.undo();
  EXPECT_EQ(history.now().nodes.size(), 2u);
  history.redo();
  EXPECT_EQ(history.now().nodes.back().name, "2");
  Session amended = history.now();
  amended.nodes.back().name = "third";
  history.amend(amended);
  EXPECT_TRUE(history.canRedo()) << "an amendment is no step";
  history.redo();
  history.undo();
  EXPECT_EQ(history.now().nodes.back().name, "third");
  Session branch = history.now();
  branch.nodes.pop_back();
  history.commit(branch);
  EXPECT_FALSE(history.canRedo());
  for (int i = 0; i < 10; ++i)
  {
    history.undo();
  }
  EXPECT_TRUE(history.now().nodes.empty());
}

// Beside a history that keeps every state whole.
TEST(History, GivesBackWhatAWholeHistoryWould)
{
  const auto stroke = drawn(0);
  const SharedData meshes[] = { toPolyData(icosphere(0)), toPolyData(icosphere(0)) };
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    History history{ Session() };
    std::vector<Session> states{ Session() };
    std::size_t at = 0;
    const auto change = [&](Session session)
    {
      const std::size_t kind = below(8), size = session.nodes.size();
      auto& nodes = session.nodes;
      if (kind < 2 || size == 0)
      {
        nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(below(size + 1)),
          nodeOf(stroke, std::to_string(random()), freshId(session)));
      }
      else if (kind == 2)
      {
        nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(below(size)));
      }
      else if (kind == 3)
      {
        std::shuffle(nodes.begin(), nodes.end(), random);
      }
      else if (kind == 4)
      {
        session.backend = static_cast<int>(below(3));
        session.mesh = meshes[below(2)];
        session.meshName = std::to_string(random());
      }
      else if (kind == 5)
      {
        nodes[below(size)].on = below(2) == 0;
      }
      else
      {
        nodes[below(size)].committed = Section{ { 1.0, 2.0, 0.1 * static_cast<double>(below(9)) }, 1.0 };
      }
      return session;
    };
    for (int act = 0; act < 300; ++act)
    {
      const std::size_t kind = below(6);
      if (kind < 2)
      {
        const Session next = change(states[at]);
        states.resize(++at);
        states.push_back(next);
        history.commit(next);
      }
      else if (kind == 2)
      {
        states[at] = change(states[at]);
        history.amend(states[at]);
      }
      else if (kind == 3)
      {
        at += at + 1 < states.size() ? 1 : 0;
        history.redo();
      }
      else
      {
        at -= at > 0 ? 1 : 0;
        history.undo();
      }
      ASSERT_TRUE(same(history.now(), states[at])) << "seed " << seed << ", act " << act;
      ASSERT_EQ(history.canUndo(), at > 0);
      ASSERT_EQ(history.canRedo(), at + 1 < states.size());
    }
  }
}

TEST(History, TenThousandStrokesTakeLessThanFiftyMebibytes)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) // whose memory is not counted so
  constexpr int count = 1000;
#else
  constexpr int count = 10000;
#endif
  ::mallopt(M_MMAP_THRESHOLD, 1 << 28); // or each copy of a session is a new mapping, and most of the time
  const double before = mebibytesInUse();
  History history{ Session() };
  for (int i = 0; i < count; ++i)
  {
    Session next = history.now();
    auto step = std::make_shared<Step>();
    step->system = "OneStroke";
    step->inputs["Stroke"] = Lines(drawn(i));
    Node node;
    node.id = i + 1;
    node.step = step;
    node.name = "Stroke " + std::to_string(i + 1);
    next.nodes.push_back(node);
    history.commit(std::move(next));
    if (i % 100 == 0) // where it took hold is learned afterwards, as by the Studio
    {
      Session learned = history.now();
      learned.nodes.back().committed = Section{ { 1.0, 2.0, 3.0 }, 0.1 * i };
      history.amend(std::move(learned));
    }
  }
  const double used = mebibytesInUse() - before;
  std::cout << count << " strokes: " << used << " MiB, " << used * 1048576.0 / count << " bytes each\n";
  EXPECT_EQ(history.now().nodes.size(), std::size_t(count));
  EXPECT_EQ(strokeOf(history.now().nodes[432])->GetNumberOfPoints(), 60);
  if (count == 10000)
  {
    EXPECT_LT(used, 50.0);
    EXPECT_GT(used, 10.0) << "the strokes alone take that";
  }
  for (int i = 0; i < count; ++i)
  {
    history.undo();
  }
  EXPECT_TRUE(history.now().nodes.empty());
  EXPECT_FALSE(history.canUndo());
}
