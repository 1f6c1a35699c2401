// Augmentation in a session: beside one-stroke deformation, on a terrain, on both sides of a plane.
#include "sessions.h"

#include "files.h"
#include "session_file.h"

#include "vtkOversketchSystem.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMassProperties.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

// A stroke of these samples with the view of another.
vtkSmartPointer<vtkPolyData> lineIn(vtkPolyData* view, const std::vector<Vector2>& samples)
{
  auto line = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(samples.size()));
  for (const Vector2& sample : samples)
  {
    cells->InsertCellPoint(points->InsertNextPoint(sample[0], sample[1], 0.0));
  }
  line->SetPoints(points);
  line->SetLines(cells);
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
  {
    line->GetCellData()->AddArray(view->GetCellData()->GetArray(name));
  }
  return line;
}

vtkSmartPointer<vtkPolyData> viewOf(const std::vector<double>& view,
  const std::vector<double>& projection,
  const std::vector<double>& size)
{
  auto made = vtkSmartPointer<vtkPolyData>::New();
  for (const auto& [name, values] : { std::pair("ViewTransform", &view),
         std::pair("ProjectionTransform", &projection),
         std::pair("ViewportSize", &size) })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(values->size()));
    array->InsertNextTuple(values->data());
    made->GetCellData()->AddArray(array);
  }
  return made;
}

Node augmentation(int id, vtkPolyData* strokes, const Values& values)
{
  auto step = std::make_shared<Step>();
  step->system = "Augment";
  step->values = values;
  step->inputs["Strokes"] = Lines(strokes);
  Node node;
  node.id = id;
  node.name = "Line";
  node.step = step;
  return node;
}

Session dogChain()
{
  const auto leg = shippedStroke("dog_longer_leg"), tail = shippedStroke("dog_curled_tail");
  const double width = leg->GetCellData()->GetArray("ViewportSize")->GetComponent(0, 0);
  const double height = leg->GetCellData()->GetArray("ViewportSize")->GetComponent(0, 1);
  std::vector<Vector2> collar, vein;
  for (int i = 0; i <= 40; ++i)
  {
    const double t = i / 40.0;
    collar.push_back({ (0.45 + 0.1 * t) * width, (0.5 + 0.02 * std::sin(6.0 * t)) * height });
    vein.push_back({ (0.42 + 0.1 * t) * width, (0.55 + 0.03 * t) * height });
  }
  Session session;
  session.mesh = shippedModel("dog");
  session.backend = 2;
  session.nodes = { nodeOf(leg, "leg", 1),
    augmentation(2, lineIn(leg, collar), { { "Radius", 0.05 }, { "Height", 0.02 } }),
    nodeOf(tail, "tail", 3),
    augmentation(4, lineIn(leg, vein), { { "Radius", 0.04 }, { "Height", -0.01 } }) };
  return session;
}

} // namespace

TEST(AugmentSession, BothKindsStandInOneHistoryAndInItsFile)
{
  Session session = dogChain();
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  for (const Outcome& outcome : outcomes)
  {
    EXPECT_EQ(outcome.failure, "");
  }
  const std::string digest = digestOf(outcomes.back().mesh);

  // The file says all of it, in version 2.
  Encoder encoder;
  const Package package = encoder.encode({ session, originHere(2), digest });
  EXPECT_NE(package.at(sessionEntry)->find("\"format_version\" : 2"), std::string::npos);
  const SessionFile again = decode(package, "chain");
  EXPECT_EQ(digestOf(outcomesOf(again.session).back().mesh), digest);

  // The first stroke is edited; what depends follows as if it had been so from the start, with the lines'
  // lengths.
  const auto other = [](Step& step) { step.values["AdjustNormals"] = true; };
  session.nodes[0] = changed(session.nodes[0], other);
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  EXPECT_EQ(outcomes[1].failure.text() + outcomes[3].failure.text(), "");
  EXPECT_NE(digestOf(outcomes.back().mesh), digest);
  Session fresh = dogChain();
  fresh.nodes[0] = changed(fresh.nodes[0], other);
  EXPECT_EQ(digestOf(outcomesOf(fresh).back().mesh), digestOf(outcomes.back().mesh));
}

// A hand turns the height after the next step has been prepared: nothing but the height is computed anew.
TEST(AugmentSession, ALineThatFollowsAHandKeepsItsSteps)
{
  Session session = dogChain();
  const Node vein = session.nodes[3];
  session.nodes.resize(2);
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  evaluator.prepare(*findSystem("Augment"), outcomes[1].mesh, session.backend, {});
  const auto pointsOf = [&evaluator](const char* step)
  {
    auto* made = vtkPolyData::SafeDownCast(evaluator.system("Augment")->GetInnerOutput(step));
    return vtkSmartPointer<vtkPoints>(made->GetPoints());
  };
  const auto refined = pointsOf("Refine"), smoothed = pointsOf("Smooth"), displaced = pointsOf("Displace");
  session.nodes[1] = changed(session.nodes[1], [](Step& step) { step.values["Height"] = -0.03; });
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  EXPECT_EQ(pointsOf("Refine"), refined);
  EXPECT_EQ(pointsOf("Smooth"), smoothed);
  EXPECT_NE(pointsOf("Displace"), displaced);
  EXPECT_EQ(digestOf(outcomes[1].mesh), digestOf(outcomesOf(session)[1].mesh));

  // What is prepared serves the next step, and is the same as nothing.
  evaluator.prepare(*findSystem("Augment"), outcomes[1].mesh, session.backend, {});
  session.nodes.push_back(vein);
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  EXPECT_EQ(digestOf(outcomes[2].mesh), digestOf(outcomesOf(session)[2].mesh));
}

TEST(AugmentSession, ATerrainBeginsASessionAndKeepsItsHeights)
{
  // A cone of heights, 33 samples a side.
  std::string grid = "ncols 33\nnrows 33\ncellsize 1\n";
  for (int j = 0; j < 33; ++j)
  {
    for (int i = 0; i < 33; ++i)
    {
      grid += std::to_string(12.0 - std::hypot(i - 16.0, j - 16.0)) + " ";
    }
  }
  auto terrain = std::make_shared<Step>();
  terrain->system = "Terrain";
  terrain->values = { { "Columns", 8 } };
  terrain->inputs["Heights"] = Image{ "cone.asc", std::make_shared<const std::string>(grid) };
  Node first;
  first.id = 1;
  first.name = "Terrain";
  first.step = terrain;
  // From above, one pixel a tenth of a sample.
  const auto view = viewOf({ 1, 0, 0, -16, 0, 1, 0, -16, 0, 0, 1, -50, 0, 0, 0, 1 },
    { 0.05, 0, 0, 0, 0, 0.05, 0, 0, 0, 0, -0.01, 0, 0, 0, 0, 1 },
    { 400, 400 });
  const auto line = lineIn(view, { { 150, 130 }, { 200, 150 }, { 250, 130 } });
  Session session;
  session.nodes = { first,
    augmentation(2, line, { { "Radius", 1.5 }, { "Height", 1e-9 }, { "Simplify", false } }) };
  const auto outcomes = outcomesOf(session);
  ASSERT_EQ(outcomes[0].failure.text() + outcomes[1].failure.text(), "");
  ASSERT_EQ(outcomes[0].mesh->GetNumberOfPolys(), 2 * 8 * 8);
  vtkPolyData* mesh = outcomes[1].mesh;
  ASSERT_GT(mesh->GetNumberOfPoints(), 200);
  int onHeights = 0;
  vtkDataArray* snapped = mesh->GetPointData()->GetArray("CurveId");
  for (vtkIdType i = 81; i < mesh->GetNumberOfPoints(); ++i) // new ones
  {
    const double* p = mesh->GetPoint(i);
    const int x = std::min(31, static_cast<int>(p[0])), y = std::min(31, static_cast<int>(p[1]));
    const double u = p[0] - x, v = p[1] - y;
    const auto at = [](int a, int b) { return 12.0 - std::hypot(a - 16.0, b - 16.0); };
    const double z =
      (1 - v) * ((1 - u) * at(x, y) + u * at(x + 1, y)) + v * ((1 - u) * at(x, y + 1) + u * at(x + 1, y + 1));
    onHeights += snapped->GetComponent(i, 0) < 0 && std::abs(p[2] - z) < 2e-6;
  }
  EXPECT_GT(onHeights, 100);
  Encoder encoder;
  const Package package = encoder.encode({ session, originHere(2), "" });
  const SessionFile again = decode(package, "cone");
  EXPECT_EQ(digestOf(outcomesOf(again.session)[1].mesh), digestOf(mesh));
  // What is no grid of heights is refused when the file is read.
  Package damaged = package;
  for (auto& [name, bytes] : damaged)
  {
    if (name.rfind("images/", 0) == 0)
    {
      bytes = std::make_shared<const std::string>(bytes->substr(0, 200));
    }
  }
  EXPECT_THROW(decode(damaged, "cone"), oversketch_files::Failed);
}

TEST(AugmentSession, BothSidesOfAPlaneAreOneRun)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(40);
  ball->SetPhiResolution(40);
  ball->Update();
  // Turned a little, in perspective, off the axis.
  const double c = std::cos(0.2), s = std::sin(0.2);
  const auto view = viewOf({ c, 0, s, 0.02, 0, 1, 0, -0.03, -s, 0, c, -2, 0, 0, 0, 1 },
    { 2.5, 0, 0.1, 0, 0, 3, 0, 0, 0, 0, -1.1, -0.2, 0, 0, -1, 0 },
    { 500, 400 });
  const auto line = lineIn(view, { { 320, 150 }, { 330, 200 }, { 310, 260 } });
  Session session;
  session.mesh = vtkSmartPointer<vtkPolyData>(ball->GetOutput());
  session.nodes = { augmentation(1, line, { { "Radius", 0.08 }, { "Height", 0.04 } }) };
  const vtkSmartPointer<vtkPolyData> one = outcomesOf(session)[0].mesh;
  session.nodes[0] = changed(session.nodes[0], [](Step& step) { step.mirror = MirrorPlane{ 0, 0.0 }; });
  const auto outcomes = outcomesOf(session);
  ASSERT_EQ(outcomes[0].failure, "");
  const auto volumeOf = [](vtkPolyData* mesh)
  {
    vtkNew<vtkMassProperties> mass;
    mass->SetInputData(mesh);
    return mass->GetVolume();
  };
  // As much rises again, on the other side.
  const double before = volumeOf(ball->GetOutput()), once = volumeOf(one), twice = volumeOf(outcomes[0].mesh);
  ASSERT_GT(once, before);
  EXPECT_NEAR(twice - before, 2.0 * (once - before), 0.02 * (once - before));
  double highest[2] = { 0.0, 0.0 };
  Vector3 top[2];
  for (vtkIdType i = 0; i < outcomes[0].mesh->GetNumberOfPoints(); ++i)
  {
    Vector3 p;
    outcomes[0].mesh->GetPoint(i, p.data());
    const int side = p[0] > 0.0;
    if (p.norm() > highest[side])
    {
      highest[side] = p.norm();
      top[side] = p;
    }
  }
  EXPECT_GT(highest[0], 0.53);
  EXPECT_NEAR(highest[0], highest[1], 2e-3);
  EXPECT_GT(top[1][0], 0.05);
  EXPECT_LT(top[0][0], -0.05);
  // Over the plane itself it acts once.
  const auto across = lineIn(view, { { 170, 200 }, { 250, 210 }, { 330, 200 } });
  session.nodes = { augmentation(1, across, { { "Radius", 0.08 }, { "Height", 0.04 } }) };
  const std::string alone = digestOf(outcomesOf(session)[0].mesh);
  session.nodes[0] = changed(session.nodes[0], [](Step& step) { step.mirror = MirrorPlane{ 0, 0.0 }; });
  EXPECT_EQ(digestOf(outcomesOf(session)[0].mesh), alone);
}
