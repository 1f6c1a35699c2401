// Steps of several systems with several inputs: references, sessions without a mesh, pictures.
#include "sessions.h"
#include "toys.h"

#include "files.h"
#include "session_file.h"
#include "texture.h"

#include <gtest/gtest.h>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

struct Runs
{
  Evaluator evaluator{ std::size_t(2) << 30, rowsWithToys() };

  std::vector<Outcome> of(const Session& session)
  {
    std::vector<Outcome> outcomes;
    EXPECT_TRUE(this->evaluator.run(session, {}, outcomes));
    return outcomes;
  }
};

double topOf(vtkPolyData* mesh)
{
  mesh->ComputeBounds();
  return mesh->GetBounds()[5];
}

std::string failureOf(Session session, std::size_t node, const std::function<void(Step&)>& change)
{
  session.nodes[node] = changed(session.nodes[node], change);
  return Runs().of(session)[node].failure.text();
}

} // namespace

TEST(Steps, TheFirstMayMakeTheMeshAndTheNextTakesWhatItPutsOut)
{
  Runs runs;
  const auto outcomes = runs.of(liftedBall());
  ASSERT_EQ(outcomes[0].failure.text() + outcomes[1].failure.text(), "");
  const double ball = topOf(outcomes[0].mesh);
  EXPECT_DOUBLE_EQ(topOf(outcomes[1].mesh), ball + 1.0 + 5.0 - 3.0);
  EXPECT_EQ(outcomes[0].outputs.count(1), 1u);
  EXPECT_TRUE(outcomes[1].outputs.empty()) << "nobody refers to it";
  EXPECT_EQ(resultOf(liftedBall(), outcomes), outcomes[1].mesh);
}

TEST(Steps, AReferenceIsLive)
{
  Runs runs;
  Session session = liftedBall();
  const double three = topOf(runs.of(session)[1].mesh);
  EXPECT_EQ(runs.evaluator.runs(), 2u);
  // Another drawing: what refers to the first step runs anew; a name changes nothing.
  session.nodes[0] = changed(session.nodes[0], [](Step& step) { step.inputs["Drawing"] = lineOf(6); });
  session.nodes[0].name = "other";
  EXPECT_NEAR(topOf(runs.of(session)[1].mesh) - three, topOf(runs.of(session)[0].mesh) / 2.0, 1e-12);
  EXPECT_EQ(runs.evaluator.runs(), 4u);
  runs.of(liftedBall());
  EXPECT_EQ(runs.evaluator.runs(), 6u) << "a step is known by its identity, not by what it says";
  // Of an outcome that was kept without the port, the port is had all the same.
  Session one = session;
  one.nodes.pop_back();
  Runs later;
  later.of(one);
  EXPECT_EQ(later.of(session)[1].failure, "");
  EXPECT_EQ(later.evaluator.runs(), 3u);
}

TEST(Steps, AStepMayTakeTheMeshOfAnyEarlierOne)
{
  Session session = liftedBall();
  session.nodes.push_back(
    nodeOf(3, "Lift", { { "Mesh", StepOutput{ 1, 0 } }, { "Up", lineOf(2) }, { "Against", lineOf(2) } }));
  Runs runs;
  const auto outcomes = runs.of(session);
  ASSERT_EQ(outcomes[2].failure, "");
  EXPECT_DOUBLE_EQ(topOf(outcomes[2].mesh), topOf(outcomes[0].mesh) + 1.0);
}

TEST(Steps, WhatAReferenceMissesIsToldOfTheStepThatRefers)
{
  const Session good = liftedBall();
  const auto referring = [&](const StepOutput& output)
  { return failureOf(good, 1, [&](Step& step) { step.inputs["Against"] = output; }); };
  EXPECT_EQ(referring({ 1, 1 }), "");
  EXPECT_NE(referring({ 7, 0 }).find("no longer there"), std::string::npos);
  EXPECT_NE(referring({ 2, 0 }).find("is itself"), std::string::npos);
  EXPECT_NE(referring({ 1, 2 }).find("has no output 2"), std::string::npos);
  EXPECT_NE(referring({ 1, 2 }).find("'Blow1'"), std::string::npos);
  Session off = good;
  off.mesh = toPolyData(icosphere(1));
  off.nodes[0].on = false;
  Runs runs;
  EXPECT_NE(runs.of(off)[1].failure.text().find("'Against' is of 'Blow1', which is off"), std::string::npos);
  EXPECT_EQ(runs.evaluator.runs(), 0u);
  Session failed = good;
  failed.mesh = off.mesh;
  failed.nodes[0] = changed(failed.nodes[0], [](Step& step) { step.inputs.clear(); });
  const auto outcomes = Runs().of(failed);
  EXPECT_NE(outcomes[0].failure.text().find("'Drawing' is missing"), std::string::npos);
  EXPECT_NE(outcomes[1].failure.text().find("which did nothing"), std::string::npos);
  EXPECT_TRUE(identical(outcomes[1].mesh, off.mesh)) << "the mesh passes by";
  Session turned = good;
  std::swap(turned.nodes[0], turned.nodes[1]);
  turned.mesh = off.mesh;
  EXPECT_NE(Runs().of(turned)[0].failure.text().find("comes after it"), std::string::npos);
  EXPECT_EQ(Runs().of(turned)[1].failure, "") << "the rest goes on";
}

TEST(Steps, WhatNoSystemOfTheListCanRunIsAFailureOfItsOwn)
{
  const Session good = liftedBall();
  EXPECT_NE(failureOf(good, 1, [](Step& step) { step.system = "Fly"; }).find("'Fly'"), std::string::npos);
  EXPECT_NE(failureOf(good, 1, [](Step& step) { step.values["Speed"] = 1; }).find("'Speed' is no parameter"),
    std::string::npos);
  EXPECT_NE(failureOf(good, 1, [](Step& step) { step.values["Height"] = 1; }).find("'Height' of Lift"),
    std::string::npos);
  EXPECT_NE(
    failureOf(good, 1, [](Step& step) { step.inputs["Wings"] = lineOf(2); }).find("'Wings' is no input"),
    std::string::npos);
  EXPECT_NE(failureOf(good, 1, [](Step& step) { step.mirror = MirrorPlane(); }).find("both sides"),
    std::string::npos);
  EXPECT_NE(failureOf(dogSession(), 0, [](Step& step) { step.values["Remesh"] = 3; }).find("'Remesh'"),
    std::string::npos);
  Session without;
  without.nodes = { good.nodes[1] };
  const auto outcomes = Runs().of(without);
  EXPECT_NE(outcomes[0].failure.text().find("no mesh yet"), std::string::npos);
  EXPECT_EQ(resultOf(without, outcomes), nullptr);
}

TEST(Steps, ValuesOfEveryKindReachTheSystem)
{
  Session session = liftedBall();
  session.nodes[1] = changed(session.nodes[1],
    [](Step& step)
    {
      step.values = {
        { "Height", 0.25 }, { "Times", 3 }, { "Down", true }, { "Shift", std::vector<double>{ 7.0, -1.0 } }
      };
    });
  const auto outcomes = Runs().of(session);
  EXPECT_DOUBLE_EQ(topOf(outcomes[1].mesh), topOf(outcomes[0].mesh) - 3.0 * 2.25);
  EXPECT_DOUBLE_EQ(outcomes[1].mesh->GetBounds()[1], outcomes[0].mesh->GetBounds()[1] + 7.0);
  // The next step of the same system has its own, or the defaults.
  session.nodes.push_back(nodeOf(3, "Lift", { { "Up", lineOf(2) }, { "Against", lineOf(2) } }));
  const auto more = Runs().of(session);
  EXPECT_DOUBLE_EQ(topOf(more[2].mesh), topOf(more[1].mesh) + 1.0);
}

TEST(Steps, APictureIsGivenByItsBytes)
{
  oversketch_files::catchMessages();
  Session session = liftedBall();
  const double bare = topOf(Runs().of(session)[0].mesh);
  session.nodes[0] = changed(session.nodes[0], [](Step& step) { step.inputs["Picture"] = picture(); });
  EXPECT_NEAR(topOf(Runs().of(session)[0].mesh), 1.1 * bare, 1e-12);
  session.nodes[0] = changed(session.nodes[0],
    [](Step& step) {
      step.inputs["Picture"] = Image{ "torn.png", std::make_shared<const std::string>("\x89PNG") };
    });
  EXPECT_NE(Runs().of(session)[0].failure.text().find("'torn.png', which cannot be read"), std::string::npos);
}

TEST(Steps, ANewIdIsThatOfNoStepThatWasOrIsReferredTo)
{
  Session session = liftedBall();
  EXPECT_EQ(freshId(session), 3);
  session.nodes.pop_back();
  EXPECT_EQ(freshId(session), 2);
  session.nodes[0] = changed(session.nodes[0],
    [](Step& step) {
      step.inputs["Drawing"] = StepOutput{ 9, 0 };
    });
  EXPECT_EQ(freshId(session), 10);
  EXPECT_EQ(freshId({}), 1);
}

TEST(Steps, AMeshWearsThePictureThatItWasMadeOf)
{
  Runs runs;
  Session session = liftedBall();
  EXPECT_EQ(oversketch_files::textureOf(runs.of(session)[1].mesh), "") << "there is no picture";
  const Image image = picture();
  session.nodes[0] = changed(session.nodes[0], [&](Step& step) { step.inputs["Picture"] = image; });
  for (int run = 0; run < 2; ++run) // the second answers from what is kept
  {
    const auto outcomes = runs.of(session);
    EXPECT_EQ(oversketch_files::textureOf(outcomes[0].mesh), *image.bytes) << "to the byte";
    EXPECT_EQ(oversketch_files::textureOf(outcomes[1].mesh), *image.bytes) << "the next step takes it along";
  }
  EXPECT_EQ(oversketch_files::textureOf(
              vtkPolyData::SafeDownCast(runs.evaluator.system("Blow")->GetOutputDataObject(0))),
    "")
    << "the filter's own output is left alone";
}
