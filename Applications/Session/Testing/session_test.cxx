// Running sessions: what runs again, what stays, what fails.
#include "sessions.h"

#include "Harness/shapes.h"

#include "vtkWeakPointer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

Session with(Session session, std::size_t node, const std::string& property, const Value& value)
{
  session.nodes[node] = changed(session.nodes[node], [&](Step& step) { step.values[property] = value; });
  return session;
}

Session without(Session session, std::size_t node)
{
  session.nodes[node].on = false;
  return session;
}

vtkSmartPointer<vtkPolyData> elsewhereStroke(vtkPolyData* stroke)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->DeepCopy(stroke);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    moved->GetPoints()->SetPoint(i, 0.01 * static_cast<double>(i), 1.0, 0.0); // far too short
  }
  return moved;
}

} // namespace

TEST(Session, ReleasedWorkChangesNothingThatComesAfter)
{
  const Session session = with(dogSession(), 0, "Remesh", vtkOversketchOneStroke::RemeshOn);
  Session first = session;
  first.nodes.pop_back();
  Evaluator evaluator, other;
  auto outcomes = outcomesOf(evaluator, first, true);
  ASSERT_TRUE(evaluator.details(outcomes, {}));
  const auto details = outcomes[0].details;
  ASSERT_TRUE(details);
  evaluator.releaseWork();
  // What was made is kept, also its details.
  outcomes = outcomesOf(evaluator, first, true);
  ASSERT_TRUE(evaluator.details(outcomes, {}));
  EXPECT_EQ(outcomes[0].details, details);
  EXPECT_EQ(evaluator.runs(), 1u);
  // A step after it, and that one with something else about it.
  for (const Session& next : { session, with(session, 1, "Remesh", vtkOversketchOneStroke::RemeshOn) })
  {
    outcomes = outcomesOf(evaluator, next, true);
    const auto expected = outcomesOf(other, next, true);
    EXPECT_TRUE(identical(outcomes[1].mesh, expected[1].mesh));
    ASSERT_TRUE(evaluator.details(outcomes, {}));
    EXPECT_TRUE(outcomes[1].details && outcomes[1].details->following);
    evaluator.releaseWork();
  }
}

TEST(Session, AStrokeInHandIsFollowedAsTheSystemDragsIt)
{
  const Session session = dogSession();
  for (const int remesh : { vtkOversketchOneStroke::RemeshOff, vtkOversketchOneStroke::RemeshOn })
  {
    Evaluator evaluator;
    auto outcomes = outcomesOf(evaluator, with(session, 0, "Remesh", remesh), true);
    ASSERT_TRUE(evaluator.details(outcomes, {}));
    const Outcome& outcome = outcomes[0];
    ASSERT_TRUE(outcome.details && outcome.details->following);
    const struct
    {
      vtkPolyData* mesh;
      const Following* following;
      vtkPolyData* region;
    } leg{ outcome.mesh, outcome.details->following.get(), outcome.details->region };
    EXPECT_EQ(leg.following->count, leg.mesh->GetNumberOfPoints());
    EXPECT_GT(leg.following->points.size(), 100u);
    EXPECT_LT(leg.following->points.size(), static_cast<std::size_t>(leg.mesh->GetNumberOfPoints()) / 2);
    vtkNew<vtkOversketchOneStroke> alone;
    alone->SetBackendToHost();
    alone->SetRemesh(remesh);
    alone->SetInputData(0, session.mesh);
    alone->SetStrokeData(strokeOf(session.nodes[0]));
    alone->Update();
    const double by[3] = { 0.05, -0.1, 0.02 };
    vtkNew<vtkPoints> dragged;
    dragged->SetDataTypeToDouble();
    dragged->DeepCopy(alone->GetOutput()->GetPoints());
    ASSERT_TRUE(alone->Drag(by, dragged));
    double worst = 0.0, most = 0.0;
    for (std::size_t i = 0; i < leg.following->points.size(); ++i)
    {
      double from[3], to[3];
      leg.mesh->GetPoint(leg.following->points[i], from);
      dragged->GetPoint(leg.following->points[i], to);
      const std::array<float, 9>& moves = leg.following->moves[i];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double move = by[0] * moves[k] + by[1] * moves[3 + k] + by[2] * moves[6 + k];
        worst = std::max(worst, std::abs(from[k] + move - to[k]));
        most = std::max(most, std::abs(move));
      }
    }
    EXPECT_LT(worst, 1e-5);
    EXPECT_GT(most, 0.08);
    // The region is what moves: its points are among those that follow.
    EXPECT_GT(leg.region->GetNumberOfPolys(), 100);
    EXPECT_LT(leg.region->GetNumberOfPoints(), leg.mesh->GetNumberOfPoints() / 2);
  }
}

TEST(Session, BothSidesOfAMirrorFollowAHand)
{
  const View view = orthographicView({ 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 }, 100.0);
  std::vector<Vector2> bulge;
  for (int i = 0; i <= 50; ++i)
  {
    const double angle = (2.0 * i - 50.0) * pi / 180.0;
    bulge.emplace_back(400.0 + 120.0 * std::cos(angle), 300.0 + 120.0 * std::sin(angle));
  }
  Session session;
  session.mesh = toPolyData(icosphere(4));
  session.backend = vtkOversketchOneStroke::Host;
  session.nodes = { changed(nodeOf(toStroke(bulge, view), "bulge"),
    [](Step& step)
    {
      step.values.clear(); // where points have partners a step is not remeshed, whatever it says
      step.mirror = MirrorPlane{ 0, 0.0 };
    }) };
  Evaluator evaluator;
  auto outcomes = outcomesOf(evaluator, session);
  ASSERT_EQ(outcomes[0].failure, "");
  EXPECT_EQ(outcomes[0].mesh->GetNumberOfPoints(), session.mesh->GetNumberOfPoints());
  ASSERT_TRUE(evaluator.details(outcomes, {}));
  ASSERT_TRUE(outcomes[0].details && outcomes[0].details->following);
  const Following* following = outcomes[0].details->following.get();
  std::map<std::array<double, 3>, std::array<float, 9>> moves;
  int left = 0, right = 0;
  for (std::size_t i = 0; i < following->points.size(); ++i)
  {
    double p[3];
    session.mesh->GetPoint(following->points[i], p);
    moves[{ p[0], p[1], p[2] }] = following->moves[i];
  }
  for (const auto& [place, move] : moves)
  {
    left += place[0] < -1e-3;
    right += place[0] > 1e-3;
    const auto partner = moves.find({ -place[0], place[1], place[2] });
    if (place[0] > 1e-3)
    {
      ASSERT_NE(partner, moves.end());
      for (std::size_t k = 0; k < 9; ++k)
      {
        EXPECT_NEAR(partner->second[k], k % 3 == 0 ? -move[k] : move[k], 1e-5);
      }
    }
  }
  EXPECT_GT(right, 50);
  EXPECT_EQ(left, right);
}

TEST(Session, StrokesActInTheirOrder)
{
  const Session session = dogSession();
  Evaluator evaluator;
  const auto outcomes = outcomesOf(evaluator, session);
  ASSERT_TRUE(outcomes[0].failure.empty()) << outcomes[0].failure;
  ASSERT_TRUE(outcomes[1].failure.empty()) << outcomes[1].failure;
  // The same by hand.
  vtkNew<vtkOversketchOneStroke> first, second;
  first->SetInputData(session.mesh);
  first->SetStrokeData(strokeOf(session.nodes[0]));
  second->SetInputConnection(first->GetOutputPort());
  second->SetStrokeData(strokeOf(session.nodes[1]));
  for (vtkOversketchOneStroke* system : { first.Get(), second.Get() })
  {
    system->SetBackendToHost();
    system->SetRemeshToOff();
  }
  second->Update();
  EXPECT_TRUE(identical(outcomes[0].mesh, first->GetOutput()));
  EXPECT_TRUE(identical(outcomes[1].mesh, second->GetOutput()));
  EXPECT_GT(largestMove(outcomes[0].mesh, outcomes[1].mesh), 0.0);
  EXPECT_EQ(resultOf(session, outcomes), outcomes[1].mesh);
  EXPECT_EQ(resultOf(session, {}), session.mesh);
}

TEST(Session, OnlyWhatDependsOnAChangeRunsAgain)
{
  const Session session = dogSession();
  Evaluator evaluator;
  const auto whole = outcomesOf(evaluator, session);
  EXPECT_EQ(evaluator.runs(), 2u);
  outcomesOf(evaluator, session);
  EXPECT_EQ(evaluator.runs(), 2u) << "nothing changed";

  Session renamed = session;
  renamed.nodes[0].name = "front leg";
  outcomesOf(evaluator, renamed);
  EXPECT_EQ(evaluator.runs(), 2u) << "a name is no change of the mesh";

  const auto edited = outcomesOf(evaluator, with(session, 1, "AdjustNormals", true));
  EXPECT_EQ(evaluator.runs(), 3u) << "the first stroke does not depend on the second";
  EXPECT_EQ(edited[0].mesh, whole[0].mesh);
  EXPECT_GT(largestMove(edited[1].mesh, whole[1].mesh), 0.0);

  const auto second = outcomesOf(evaluator, without(session, 0));
  EXPECT_EQ(evaluator.runs(), 4u) << "the second stroke acts on another mesh";
  EXPECT_TRUE(identical(second[0].mesh, session.mesh));

  const auto back = outcomesOf(evaluator, session);
  EXPECT_EQ(evaluator.runs(), 4u) << "undone: both results are kept";
  EXPECT_EQ(back[1].mesh, whole[1].mesh);
  Evaluator cold;
  EXPECT_TRUE(identical(outcomesOf(cold, without(session, 0))[1].mesh, second[1].mesh));
}

TEST(Session, AFailedStrokeIsPassedByAndTheRestGoesOn)
{
  Session session = dogSession();
  session.nodes.insert(session.nodes.begin(), nodeOf(elsewhereStroke(strokeOf(session.nodes[0])), "dot"));
  Evaluator evaluator;
  const auto outcomes = outcomesOf(evaluator, session);
  EXPECT_NE(outcomes[0].failure.text().find("px long"), std::string::npos) << outcomes[0].failure;
  EXPECT_TRUE(identical(outcomes[0].mesh, session.mesh));
  EXPECT_FALSE(outcomes[0].section.has_value());
  Evaluator cold;
  const auto good = outcomesOf(cold, dogSession());
  EXPECT_TRUE(identical(outcomes[2].mesh, good[1].mesh));
  outcomesOf(evaluator, session);
  EXPECT_EQ(evaluator.runs(), 3u) << "a failure is kept like a result";
}

TEST(Session, CancelledAndRunAgainGivesTheWholeResult)
{
  const Session session = dogSession();
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  int polls = 0;
  Evaluator::Watch watch;
  watch.cancelled = [&] { return ++polls > 3; };
  EXPECT_FALSE(evaluator.run(session, watch, outcomes));
  EXPECT_LT(outcomes.size(), 2u);
  Evaluator cold;
  EXPECT_TRUE(identical(outcomesOf(evaluator, session)[1].mesh, outcomesOf(cold, session)[1].mesh));
}

TEST(Session, ProgressNamesNodeAndStageAndRises)
{
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  std::vector<double> shares;
  std::vector<std::string> stages;
  Evaluator::Watch watch;
  watch.progress = [&](std::size_t node, const std::string& stage, double share)
  {
    shares.push_back(static_cast<double>(node) + share);
    if (stages.empty() || stages.back() != stage)
    {
      stages.push_back(stage);
    }
  };
  ASSERT_TRUE(evaluator.run(dogSession(), watch, outcomes));
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_NE(std::find(stages.begin(), stages.end(), "ShapeDiameter"), stages.end());
}

TEST(Session, AStrokeThatTakesHoldElsewhereIsMarked)
{
  Session session = dogSession();
  Evaluator evaluator;
  auto outcomes = outcomesOf(evaluator, session);
  ASSERT_TRUE(outcomes[0].section.has_value());
  EXPECT_FALSE(outcomes[0].elsewhere) << "not committed yet";
  session.nodes[0].committed = outcomes[0].section;
  session.nodes[1].committed = outcomes[0].section; // the leg's place for the tail
  outcomes = outcomesOf(evaluator, session);
  EXPECT_FALSE(outcomes[0].elsewhere);
  EXPECT_TRUE(outcomes[1].elsewhere);
  // The middle lies on the matched curve's own bounds and its length is at least the distance of its ends.
  double box[6];
  outcomes[0].hold->GetBounds(box);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_GE(outcomes[0].section->middle[static_cast<std::size_t>(k)], box[2 * k]);
    EXPECT_LE(outcomes[0].section->middle[static_cast<std::size_t>(k)], box[2 * k + 1]);
  }
  EXPECT_GE(outcomes[0].section->length, outcomes[0].hold->GetLength() * 0.5);
}

TEST(Session, KeptResultsStayWithinTheirBudget)
{
  const Session session = dogSession();
  Evaluator poor(1);
  outcomesOf(poor, session);
  outcomesOf(poor, session);
  EXPECT_EQ(poor.runs(), 2u) << "those of the session itself stay";
  outcomesOf(poor, without(session, 0));
  outcomesOf(poor, session);
  EXPECT_GT(poor.runs(), 3u) << "others went";
}

TEST(Session, WhatNobodyCanAskForAgainIsNotKept)
{
  Evaluator evaluator;
  Session session = dogSession(), bare = session;
  bare.nodes.clear();
  const vtkWeakPointer<vtkPolyData> second = outcomesOf(evaluator, session)[1].mesh.Get();
  outcomesOf(evaluator, bare);
  ASSERT_TRUE(second) << "it is undone, and may be redone";
  session.nodes.pop_back();
  outcomesOf(evaluator, bare);
  EXPECT_FALSE(second) << "nobody holds its stroke";
  outcomesOf(evaluator, session);
  EXPECT_EQ(evaluator.runs(), 2u) << "the first is kept";
}
