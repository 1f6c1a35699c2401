// Drawings beside each other in a session: placed, kept, filed, passed by.
#include "sessions.h"

#include "drawing_lines.h"
#include "files.h"
#include "parts.h"
#include "picture_skin.h"
#include "pieces.h"
#include "session_file.h"
#include "systems.h"
#include "texture.h"

#include "vtkOversketchJoinedParts.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMassProperties.h"
#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

// The drawing over a part of the gnome, as a step of its own.
Node drawing(const std::string& name, int id, const std::optional<PartPlace>& place = std::nullopt)
{
  const std::string path = OVERSKETCH_DATA_FOLDER "/Drawings/figure_" + name;
  const auto bytes = std::make_shared<const std::string>(oversketch_files::wholeFile(path + ".png"));
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((path + ".vtp").c_str());
  reader->Update();
  auto step =
    std::make_shared<Step>(withDrawing(*drawingOver({ name + ".png", bytes }), reader->GetOutput()));
  step->values["Levels"] = 2;
  step->part = place;
  Node node;
  node.id = id;
  node.name = name;
  node.step = step;
  return node;
}

Node at(const Node& node, const PartPlace& place)
{
  return changed(node, [&](Step& step) { step.part = place; });
}

const PartPlace beside{ { 600.0, 100.0, 1000.0, 500.0 }, 70.0 };

Session gnome()
{
  Session session;
  session.backend = 2;
  session.nodes = { drawing("body", 1), drawing("head", 2, beside) };
  return session;
}

std::vector<Outcome> madeBy(Evaluator& evaluator, const Session& session)
{
  std::vector<Outcome> outcomes = outcomesOf(evaluator, session);
  for (const Outcome& outcome : outcomes)
  {
    EXPECT_EQ(outcome.failure, "");
  }
  return outcomes;
}

std::string bitsOf(const Session& session)
{
  Evaluator evaluator;
  return digestOf(madeBy(evaluator, session).back().mesh);
}

std::set<int> partsOf(vtkPolyData* mesh)
{
  std::set<int> parts;
  vtkDataArray* ids = mesh->GetCellData()->GetArray("PartId");
  for (vtkIdType f = 0; ids && f < ids->GetNumberOfTuples(); ++f)
  {
    parts.insert(static_cast<int>(ids->GetComponent(f, 0)));
  }
  return parts;
}

double volumeOf(vtkPolyData* mesh)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(mesh);
  return mass->GetVolume();
}

} // namespace

TEST(Parts, ADrawingStandsWhereItsBoxIs)
{
  Evaluator evaluator;
  const Session session = gnome();
  const auto outcomes = madeBy(evaluator, session);
  Session alone = session;
  alone.nodes = { drawing("head", 2) };
  Evaluator other;
  const auto head = madeBy(other, alone)[0].mesh;
  vtkPolyData* body = outcomes[0].mesh;
  vtkPolyData* both = outcomes[1].mesh;
  ASSERT_EQ(both->GetNumberOfPoints(), body->GetNumberOfPoints() + head->GetNumberOfPoints());
  EXPECT_EQ(both->GetNumberOfPolys(), body->GetNumberOfPolys() + head->GetNumberOfPolys());
  EXPECT_EQ(partsOf(both), (std::set<int>{ 0, 1 }));
  // The canvas fills the box; z is scaled by the mean of both and moved.
  const auto canvas = canvasOf(*alone.nodes[0].step);
  const double x = 400.0 / (canvas[2] - canvas[0]), y = 400.0 / (canvas[3] - canvas[1]);
  double worst = 0.0;
  for (vtkIdType i = 0; i < head->GetNumberOfPoints(); ++i)
  {
    const double* from = head->GetPoint(i);
    const Vector3 expected(600.0 + x * (from[0] - canvas[0]),
      100.0 + y * (from[1] - canvas[1]),
      70.0 + std::sqrt(x * y) * from[2]);
    worst = std::max(worst, (expected - Vector3(both->GetPoint(body->GetNumberOfPoints() + i))).norm());
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_NEAR(volumeOf(both) / (volumeOf(body) + std::pow(x * y, 1.5) * volumeOf(head)), 1.0, 1e-6);
  // Both wear their pictures.
  const auto pieces = oversketch_files::piecesOf(both);
  ASSERT_EQ(pieces.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
  {
    const auto& image = std::get<Image>(session.nodes[i].step->inputs.at("Picture"));
    EXPECT_TRUE(pieces[i].picture ==
                skinFor(both, static_cast<int>(i), *image.bytes, oversketch_files::pictureOf(*image.bytes)))
      << i;
  }
}

TEST(Parts, ABackFromTheRimIsAPartAndIsKeptInFiles)
{
  Session session = gnome();
  for (Node& node : session.nodes)
  {
    node = changed(node, [](Step& step) { step.values["BackFromRim"] = true; });
  }
  Evaluator evaluator;
  const auto outcomes = madeBy(evaluator, session);
  EXPECT_EQ(partsOf(outcomes[1].mesh), (std::set<int>{ 0, 1, 2, 3 }));
  const auto pieces = oversketch_files::piecesOf(outcomes[1].mesh);
  ASSERT_EQ(pieces.size(), 4u);
  for (std::size_t i = 0; i < 2; ++i)
  {
    const auto& image = std::get<Image>(session.nodes[i].step->inputs.at("Picture"));
    const auto picture = oversketch_files::pictureOf(*image.bytes);
    EXPECT_TRUE(
      pieces[2 * i].picture == skinFor(outcomes[1].mesh, static_cast<int>(2 * i), *image.bytes, picture));
    EXPECT_TRUE(pieces[2 * i + 1].picture ==
                skinFor(outcomes[1].mesh, static_cast<int>(2 * i + 1), *image.bytes, picture, true));
  }
  const SessionFile back = decode(Encoder().encode({ session, {}, "" }), "file");
  EXPECT_EQ(bitsOf(back.session), digestOf(outcomes[1].mesh));
}

TEST(Parts, MovingOneDrawsNothingAnewAndGivesTheSameBits)
{
  Evaluator evaluator;
  Session session = gnome();
  madeBy(evaluator, session);
  const std::size_t drawn = evaluator.runs();
  EXPECT_EQ(drawn, 2u);
  PartPlace place = beside;
  for (int i = 0; i < 5; ++i)
  {
    place.depth += 3.0;
    place.box[2] += 7.0;
    session.nodes[1] = at(session.nodes[1], place);
    const auto outcomes = madeBy(evaluator, session);
    EXPECT_EQ(digestOf(outcomes[1].mesh), bitsOf(session));
  }
  EXPECT_EQ(evaluator.runs(), drawn);
  // A changed first drawing runs itself alone.
  session.nodes[0] = changed(session.nodes[0], [](Step& step) { step.values["Height"] = 0.5; });
  EXPECT_EQ(digestOf(madeBy(evaluator, session)[1].mesh), bitsOf(session));
  EXPECT_EQ(evaluator.runs(), drawn + 1);
  // And a changed second one.
  session.nodes[1] = changed(session.nodes[1], [](Step& step) { step.values["Height"] = 0.5; });
  EXPECT_EQ(digestOf(madeBy(evaluator, session)[1].mesh), bitsOf(session));
  EXPECT_EQ(evaluator.runs(), drawn + 2);
}

TEST(Parts, ThreeAreCountedOnAndOneThatIsOffIsPassedBy)
{
  Session session = gnome();
  session.nodes.push_back(drawing("hat", 3, PartPlace{ { 0.0, 700.0, 400.0, 900.0 }, 0.0 }));
  Evaluator evaluator;
  EXPECT_EQ(partsOf(madeBy(evaluator, session)[2].mesh), (std::set<int>{ 0, 1, 2 }));
  session.nodes[1].on = false;
  const auto outcomes = madeBy(evaluator, session);
  EXPECT_EQ(partsOf(outcomes[2].mesh), (std::set<int>{ 0, 1 }));
  const std::string& hat = *std::get<Image>(session.nodes[2].step->inputs.at("Picture")).bytes;
  EXPECT_EQ(oversketch_files::piecesOf(outcomes[2].mesh)[1].picture,
    skinFor(outcomes[2].mesh, 1, hat, oversketch_files::pictureOf(hat)));
  // One that fails, or is not drawn yet, leaves the others as they are.
  session.nodes[1].on = true;
  session.nodes[1] = changed(session.nodes[1], [](Step& step) { step.values["Holes"] = std::string("7"); });
  std::vector<Outcome> failed;
  EXPECT_TRUE(evaluator.run(session, {}, failed));
  EXPECT_NE(failed[1].failure, "");
  EXPECT_EQ(digestOf(failed[2].mesh), digestOf(outcomes[2].mesh));
  session.nodes[1] = drawing("head", 2, beside);
  session.nodes[1] =
    changed(session.nodes[1], [](Step& step) { step.inputs["Strokes"] = Lines(vtkNew<vtkPolyData>()); });
  EXPECT_TRUE(evaluator.run(session, {}, failed));
  EXPECT_EQ(digestOf(failed[2].mesh), digestOf(outcomes[2].mesh));
  // The first one off: the others stay at their places.
  session.nodes[1] = drawing("head", 2, beside);
  session.nodes[0].on = false;
  const auto without = madeBy(evaluator, session);
  EXPECT_EQ(partsOf(without[2].mesh), (std::set<int>{ 0, 1 }));
  EXPECT_GT(without[1].mesh->GetBounds()[0], 600.0);
}

TEST(Parts, AreFiledWithTheirPlaces)
{
  const Session session = gnome();
  const Package package = Encoder().encode({ session, {}, "" });
  const SessionFile back = decode(package, "file");
  ASSERT_EQ(back.session.nodes.size(), 2u);
  EXPECT_FALSE(back.session.nodes[0].step->part);
  ASSERT_TRUE(back.session.nodes[1].step->part);
  EXPECT_TRUE(*back.session.nodes[1].step->part == beside);
  EXPECT_EQ(bitsOf(back.session), bitsOf(session));
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& words)
  {
    Package bad = package;
    std::string text = *bad.at(sessionEntry);
    const std::size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    bad[sessionEntry] = std::make_shared<std::string>(text);
    try
    {
      decode(bad, "file");
      FAIL() << to;
    }
    catch (const oversketch_files::Failed& failed)
    {
      EXPECT_NE(std::string(failed.what()).find(words), std::string::npos) << failed.what();
    }
  };
  refused("1000.0", "600.0", "is an empty box");
  refused("1000.0", "1e300", "beyond 1e9");
  refused("600.0,", "", "is not four numbers");
  refused("\"depth\" : 70.0", "\"depth\" : \"70\"", "depth");
}

// By what made them, whatever becomes of the steps before.
TEST(Parts, OnesThatAreHiddenAreFoundAgain)
{
  Session session = gnome();
  session.nodes.push_back(drawing("hat", 3, PartPlace{ { 0.0, 700.0, 400.0, 900.0 }, 0.0 }));
  session.hidden = { { 3, 0 } };
  Evaluator evaluator;
  const auto hidden = [&]
  {
    std::vector<Outcome> outcomes;
    EXPECT_TRUE(evaluator.run(session, {}, outcomes));
    const PartSources parts = sourcesOf(session, outcomes);
    EXPECT_EQ(parts.size(), std::max<std::size_t>(1, partsOf(outcomes.back().mesh).size()));
    return hiddenOf(session, parts);
  };
  EXPECT_EQ(hidden(), std::set<int>{ 2 });
  session.nodes[1].on = false;
  EXPECT_EQ(hidden(), std::set<int>{ 1 });
  session.nodes[1] = drawing("head", 2, beside);
  session.nodes[1] =
    changed(session.nodes[1], [](Step& step) { step.inputs["Strokes"] = Lines(vtkNew<vtkPolyData>()); });
  EXPECT_EQ(hidden(), std::set<int>{ 1 }) << "of one that is not drawn yet";
  session.nodes[1] = drawing("head", 2, beside);
  std::swap(session.nodes[1], session.nodes[2]);
  EXPECT_EQ(hidden(), std::set<int>{ 1 });
  session.nodes[0].on = false;
  EXPECT_EQ(hidden(), std::set<int>{ 0 });
  session.nodes.erase(session.nodes.begin() + 1);
  session.nodes[0].on = true;
  EXPECT_EQ(hidden(), std::set<int>());
  EXPECT_EQ(freshId(session), 4) << "a new step's part would be hidden";
  // Beside a model that was opened.
  session = dogSession();
  session.nodes = { drawing("head", 7, beside) };
  session.hidden = { { 0, 0 } };
  EXPECT_EQ(hidden(), std::set<int>{ 0 });
  session.nodes[0].on = false;
  EXPECT_EQ(hidden(), std::set<int>()) << "no row would bring it back";
  session.nodes[0].on = true;
  session.hidden = { { 7, 0 } };
  EXPECT_EQ(hidden(), std::set<int>{ 1 });
}

// They wear pictures, so that their numbers stay; as one body they are hidden with the model alone.
TEST(Parts, TwoThatAreJoinedAreOneBody)
{
  if (!findSystem("Join"))
  {
    return;
  }
  SessionFile file;
  Session& session = file.session;
  session = gnome();
  session.nodes[1] = at(session.nodes[1], { { 64.0, 370.0, 576.0, 946.0 }, 110.0 });
  auto step = std::make_shared<Step>();
  step->system = "Join";
  step->values = { { "Width", 12.0 } };
  Node node;
  node.id = 3;
  node.step = step;
  for (Node& one : session.nodes)
  {
    one = changed(one, [](Step& coarse) { coarse.values["Levels"] = 0; });
  }
  session.nodes.push_back(node);
  session.hidden = { { 2, 0 }, { 0, 0 } };
  Evaluator evaluator;
  const auto outcomes = madeBy(evaluator, session);
  vtkPolyData* apart = outcomes[1].mesh;
  vtkPolyData* body = outcomes[2].mesh;
  EXPECT_EQ(hiddenOf(session, sourcesOf(session, { outcomes[0], outcomes[1] })), std::set<int>{ 1 });
  EXPECT_EQ(partsOf(body), (std::set<int>{ 0, 1 }));
  EXPECT_EQ(oversketch::JoinedParts(body), (std::set<int>{ 0, 1 }));
  EXPECT_TRUE(oversketch::JoinedParts(apart).empty());
  EXPECT_EQ(hiddenOf(session, sourcesOf(session, outcomes)), std::set<int>()) << "a hole in a body";
  EXPECT_LT(volumeOf(body), volumeOf(apart));
  const SessionFile read = decode(Encoder().encode(file), "a");
  EXPECT_EQ(bitsOf(read.session), digestOf(body));
}

TEST(Parts, OnesThatAreHiddenAreInTheFile)
{
  SessionFile file;
  file.session = dogSession();
  const auto textOf = [](const SessionFile& of) { return *Encoder().encode(of).at(sessionEntry); };
  const std::string without = textOf(file);
  EXPECT_EQ(without.find("hidden_parts"), std::string::npos) << "a member for nothing";
  EXPECT_NE(without.find("\"format_version\" : 1"), std::string::npos);
  file.session.hidden = { { 0, 3 }, { 8, 1 } };
  const Package package = Encoder().encode(file);
  EXPECT_NE(package.at(sessionEntry)->find("\"format_version\" : 2"), std::string::npos);
  SessionFile read = decode(package, "a");
  const auto isSame = [](const PartSource& a, const PartSource& b)
  { return a.step == b.step && a.part == b.part; };
  const std::set<PartSource>&was = file.session.hidden, &is = read.session.hidden;
  EXPECT_TRUE(std::equal(was.begin(), was.end(), is.begin(), is.end(), isSame));
  EXPECT_EQ(textOf(read), *package.at(sessionEntry));
  read.session.hidden.clear();
  EXPECT_EQ(textOf(read), without) << "the file as it was";
  Package bad = package;
  std::string text = *bad.at(sessionEntry);
  text.replace(text.find("\"part\" : 3"), 10, "\"part\" : -3");
  bad[sessionEntry] = std::make_shared<std::string>(text);
  try
  {
    decode(bad, "a");
    FAIL();
  }
  catch (const oversketch_files::Failed& failed)
  {
    EXPECT_NE(std::string(failed.what()).find("hidden part 1: 'part' is not a number in its range"),
      std::string::npos)
      << failed.what();
  }
}

TEST(Parts, OnlyWhatTakesNoMeshMakesOne)
{
  Session session = dogSession();
  session.nodes[0] = at(session.nodes[0], beside);
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  EXPECT_TRUE(evaluator.run(session, {}, outcomes));
  EXPECT_EQ(outcomes[0].failure, "OneStroke changes the mesh that comes to it, and makes no part of its own");
  // Beside a model that was opened.
  session.nodes = { drawing("head", 3, beside) };
  const auto both = madeBy(evaluator, session)[0].mesh;
  EXPECT_EQ(partsOf(both), (std::set<int>{ 0, 1 }));
  EXPECT_EQ(oversketch_files::piecesOf(both).size(), 2u);
}

TEST(Parts, WhatALineLacksIsWhatItMeansWithout)
{
  const auto strokes = strokesOf(linesOf(*drawing("body", 1).step, "Strokes"));
  ASSERT_FALSE(strokes.empty());
  DrawnStroke plain = strokes[0], told = strokes[0];
  plain.line->GetCellData()->RemoveArray("Treatment");
  plain.on = false;
  told.line = vtkSmartPointer<vtkPolyData>::New();
  told.line->ShallowCopy(strokes[0].line);
  vtkNew<vtkIntArray> hole;
  hole->SetName("Treatment");
  hole->InsertNextValue(1);
  told.line->GetCellData()->AddArray(hole);
  const auto back = strokesOf(drawingOf({ plain, told }, strokes[0].line));
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(treatmentOf(back[0].line), 0);
  EXPECT_EQ(treatmentOf(back[1].line), 1) << "a hole is forgotten beside a line that is off";
  DrawnStroke limb = plain;
  limb.line = withDepth(plain.line, 3, 0.5, 2);
  EXPECT_EQ(depthOf(plain.line), 0) << "the line itself stays as it is";
  const auto layers = strokesOf(drawingOf({ plain, limb }, strokes[0].line));
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(depthOf(layers[0].line), 0);
  EXPECT_EQ(heightOf(layers[0].line), 0.0);
  EXPECT_EQ(depthOf(layers[1].line), 3);
  EXPECT_EQ(heightOf(layers[1].line), 0.5);
  EXPECT_EQ(crossSectionOf(layers[1].line), 2);
  EXPECT_FALSE(back[0].on);
  EXPECT_EQ(plain.line->GetCellData()->GetArray("Treatment"), nullptr) << "the line itself has changed";
}

// A copy in the mirror is a part of the step that made it, which a later drawing and a file do not mix up.
TEST(Parts, ACopyIsOfTheStepThatMadeIt)
{
  if (!findSystem("Transform"))
  {
    return;
  }
  SessionFile file;
  Session& session = file.session;
  session.mesh = shippedModel("dog");
  const auto placing = [](int id, int part, const std::vector<double>& move, int copy)
  {
    auto step = std::make_shared<Step>();
    step->system = "Transform";
    step->values = { { "Part", part }, { "Move", move }, { "Copy", copy } };
    Node node;
    node.id = id;
    node.step = step;
    return node;
  };
  session.nodes = {
    placing(4, -1, { 0.1, 0.0, 0.0 }, 1), placing(5, 1, { 0.0, 2.0, 0.0 }, 0), drawing("head", 6, beside)
  };
  Evaluator evaluator;
  const auto outcomes = madeBy(evaluator, session);
  EXPECT_EQ(partsOf(outcomes[0].mesh), (std::set<int>{ 0, 1 }));
  EXPECT_EQ(partsOf(outcomes[2].mesh), (std::set<int>{ 0, 1, 2 }));
  const PartSources parts = sourcesOf(session, outcomes);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts.at(0).step, 0);
  EXPECT_EQ(parts.at(1).step, 4);
  EXPECT_EQ(parts.at(2).step, 6);
  // The first is where it was, to the bit, while the other one moves.
  for (vtkIdType i = 0; i < session.mesh->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(outcomes[0].mesh->GetPoint(i)[1], outcomes[1].mesh->GetPoint(i)[1]);
  }
  const SessionFile read = decode(Encoder().encode(file), "a");
  EXPECT_EQ(digestOf(madeBy(evaluator, read.session).back().mesh), digestOf(outcomes.back().mesh));
  session.nodes[1] = placing(5, 1, { 0.0, 2.0 }, 0);
  EXPECT_NE(faultOf(*session.nodes[1].step), "") << "two numbers are no move";
}
