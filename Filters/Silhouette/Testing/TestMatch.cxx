#include "match_chain.h"

#include "Silhouette/targets.h"

#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

using namespace oversketch;
using namespace oversketch_test;

TEST(A4_1, ConcentricStrokeOnTheSphere)
{
  for (const bool amended : { false, true })
  {
    for (const bool outline : { false, true })
    {
      const View view = orthographicView(front, up, 200.0);
      Chain chain(sphere(), toStroke(arc(view, 1.2, 20.0, 80.0), view), outline);
      chain.match->SetAmendedScore(amended);
      chain.targets->Update();
      vtkPolyData* section = chain.match->GetOutput();
      ASSERT_GT(section->GetNumberOfPoints(), 10);
      // D in pixels, 200 a unit.
      const double d = field(section, "Distance") / 200.0;
      EXPECT_NEAR(d, 0.2, 0.002);
      const double from = angleOf(pointOf(section, 0));
      const double to = angleOf(pointOf(section, section->GetNumberOfPoints() - 1));
      EXPECT_NEAR(from, 20.0, 0.2);
      EXPECT_NEAR(to, 80.0, 0.2);
      // k on unmerged targets: both polylines over the same handles.
      vtkPolyData* handles = chain.targets->GetOutput();
      std::vector<Vector3> target;
      for (vtkIdType i = 0; i < handles->GetNumberOfPoints(); ++i)
        target.push_back(tuple(handles, "UnmergedTarget", i));
      const double k = field(handles, "SectionLength") / curveLength(target);
      EXPECT_NEAR(k, 1.0 / 1.2, 0.006);
      std::ostringstream text;
      text << (amended ? "amended" : "published") << (outline ? ", outline offered" : "") << ": D " << d
           << " (exact 0.2), section " << from << " to " << to << " deg (20 to 80), k " << k << " (0.833)";
      fact("A4_1", text.str());
    }
  }
}

TEST(A4_2, TheNearerSphereWins)
{
  const View view = orthographicView(front, up, 100.0);
  const Mesh two = joined(icosphere(4), icosphere(4, 0.8), Vector3(2.5, 0, 0));
  const auto mesh = toPolyData(two);
  const int first = icosphere(4).vertexCount();
  for (const bool amended : { false, true })
  {
    for (const auto& [centre, radius, second] :
      { std::tuple(Vector3(0, 0, 0), 1.15, false), std::tuple(Vector3(2.5, 0, 0), 0.95, true) })
    {
      Chain chain(mesh, toStroke(arc(view, radius, 100.0, 160.0, centre), view), true);
      chain.match->SetAmendedScore(amended);
      chain.targets->Update();
      vtkPolyData* handles = chain.targets->GetOutput();
      ASSERT_GT(handles->GetNumberOfPoints(), 4);
      for (vtkIdType i = 0; i < handles->GetNumberOfPoints(); ++i)
        EXPECT_EQ(tuple(handles, "MeshVertices", i)[0] >= first, second);
    }
  }
  fact("A4_2", "two spheres: every control point on the nearer one, published and amended score");
}

// Drawn beside the first sphere, dragged to the second.
TEST(Match, AStrokeThatWasDraggedKeepsItsSection)
{
  const View view = orthographicView(front, up, 100.0);
  const auto mesh = toPolyData(joined(icosphere(4), icosphere(4, 0.8), Vector3(2.5, 0, 0)));
  const auto drawn = toStroke(arc(view, 1.15, 100.0, 160.0, Vector3::Zero()), view);
  Chain before(mesh, drawn, true);
  before.match->Update();
  vtkNew<vtkPolyData> dragged;
  dragged->DeepCopy(drawn);
  for (vtkIdType i = 0; i < dragged->GetNumberOfPoints(); ++i)
  {
    double p[3];
    dragged->GetPoint(i, p);
    dragged->GetPoints()->SetPoint(i, p[0] + 250.0, p[1], p[2]);
  }
  const auto firstOf = [&](vtkPolyData* stroke)
  {
    Chain chain(mesh, stroke, true);
    chain.match->Update();
    return pointOf(chain.match->GetOutput(), 0);
  };
  const Vector3 start = pointOf(before.match->GetOutput(), 0);
  EXPECT_GT((firstOf(dragged) - start).norm(), 1.0);
  vtkNew<vtkDoubleArray> moved;
  moved->SetName("Moved");
  moved->SetNumberOfComponents(2);
  moved->InsertNextTuple2(250.0, 0.0);
  dragged->GetCellData()->AddArray(moved);
  EXPECT_LT((firstOf(dragged) - start).norm(), 1e-9);

  Chain chain(mesh, dragged, true);
  moved->SetValue(0, std::numeric_limits<double>::quiet_NaN());
  chain.match->Modified();
  expectRefusal(chain.match, Failure::BadStroke, "Moved");
}

TEST(A4_2, AHiddenCurveNearerStillNeverWins)
{
  const View view = orthographicView(front, up, 100.0);
  // Curves as visibility would hand them on: the second one lies on the stroke but is hidden.
  Chain chain(sphere(4), toStroke(arc(view, 1.3, 20.0, 80.0), view));
  vtkNew<vtkPolyData> curves;
  curves->DeepCopy(chain.silhouette->GetOutput());
  const vtkIdType visiblePoints = curves->GetNumberOfPoints();
  vtkPolyData* original = chain.silhouette->GetOutput();
  curves->GetLines()->InsertNextCell(static_cast<int>(visiblePoints));
  for (vtkIdType i = 0; i < visiblePoints; ++i)
  {
    const Vector3 p = 1.29 * pointOf(original, i);
    const vtkIdType id = curves->GetPoints()->InsertNextPoint(p.data());
    curves->GetLines()->InsertCellPoint(id);
    for (int a = 0; a < curves->GetPointData()->GetNumberOfArrays(); ++a)
      curves->GetPointData()->GetArray(a)->InsertNextTuple(i, original->GetPointData()->GetArray(a));
  }
  vtkNew<vtkUnsignedCharArray> visible;
  visible->SetName("Visible");
  visible->InsertNextValue(1);
  visible->InsertNextValue(0);
  curves->GetCellData()->AddArray(visible);
  for (const bool amended : { false, true })
  {
    vtkNew<vtkOversketchMatch> match;
    match->SetInputData(curves);
    match->SetStrokeData(chain.stroke);
    match->SetAmendedScore(amended);
    match->Update();
    EXPECT_NEAR(field(match->GetOutput(), "Distance"), 30.0, 0.5);
    visible->SetValue(1, 1);
    visible->Modified();
    curves->Modified();
    match->Modified();
    match->Update(); // the same curve, seen, would win
    EXPECT_NEAR(field(match->GetOutput(), "Distance"), 1.0, 0.5);
    visible->SetValue(1, 0);
    visible->Modified();
  }
  fact("A4_2", "a hidden curve 1 px from the stroke loses to a visible one at 30 px");
}

TEST(A4_2, ReversingTheStrokeChangesNothingButTheOrder)
{
  const View view = perspectiveView(Vector3(1, 0.5, 3), up, 40.0);
  std::vector<Vector2> samples;
  for (int i = 0; i <= 200; ++i)
  {
    const double a = 0.3 + 1.9 * i / 200;
    samples.emplace_back(400 + 290 * std::cos(a) + 8 * std::sin(9 * a), 300 + 260 * std::sin(a));
  }
  std::vector<Vector2> reversed(samples.rbegin(), samples.rend());
  for (const bool outline : { false, true })
  {
    Chain there(sphere(4), toStroke(samples, view), outline),
      back(sphere(4), toStroke(reversed, view), outline);
    vtkPolyData* a = there.targets->GetOutput();
    vtkPolyData* b = back.targets->GetOutput();
    const vtkIdType count = a->GetNumberOfPoints();
    ASSERT_GT(count, 10);
    ASSERT_EQ(b->GetNumberOfPoints(), count);
    double worst = 0.0;
    for (vtkIdType i = 0; i < count; ++i)
    {
      worst = std::max(worst, (pointOf(a, i) - pointOf(b, count - 1 - i)).norm());
      worst = std::max(worst, (tuple(a, "Target", i) - tuple(b, "Target", count - 1 - i)).norm());
    }
    EXPECT_LT(worst, 1e-9);
    EXPECT_NEAR(field(there.match->GetOutput(), "Score"), field(back.match->GetOutput(), "Score"), 1e-9);
    std::ostringstream text;
    text << "reversed stroke: control points and targets agree to " << worst
         << (outline ? " on the outline" : "");
    fact("A4_2", text.str());
  }
}

TEST(A5_1, MergeRatio)
{
  const double omega = 0.2;
  EXPECT_EQ(mergeRatio(0.0, omega), 0.0);
  EXPECT_EQ(mergeRatio(1.0, omega), 0.0);
  EXPECT_NEAR(mergeRatio(0.05, omega), 0.5, 1e-15);
  EXPECT_NEAR(mergeRatio(0.95, omega), 0.5, 1e-15);
  for (const double r : { 0.2, 0.5, 0.8 })
    EXPECT_NEAR(mergeRatio(r, omega), 1.0, 1e-15);
  EXPECT_NEAR(mergeRatio(0.25, 0.5), std::sqrt(0.5), 1e-15);
  // The printed branch has no value at 0.95: its argument leaves the domain of the square root.
  EXPECT_TRUE(std::isnan(std::sqrt(omega - 0.95 / omega)));
  std::ostringstream text;
  text << "f(0.05) = " << mergeRatio(0.05, omega) << ", f(0.95) = " << mergeRatio(0.95, omega)
       << " (printed form: no real value)";
  fact("A5_1", text.str());
}

TEST(A5_2, ConcentricStrokeMovesRadially)
{
  const View view = orthographicView(front, up, 200.0);
  for (const bool outline : { false, true })
  {
    Chain chain(sphere(), toStroke(arc(view, 1.2, 20.0, 80.0), view), outline);
    vtkPolyData* handles = chain.targets->GetOutput();
    ASSERT_GT(handles->GetNumberOfPoints(), 10);
    double radial = 0.0, tangential = 0.0, along = 0.0;
    for (vtkIdType i = 0; i < handles->GetNumberOfPoints(); ++i)
    {
      const Vector3 q = pointOf(handles, i), move = tuple(handles, "Target", i) - q;
      const double r = handles->GetPointData()->GetArray("RelativePosition")->GetComponent(i, 0);
      const Vector3 out = Vector3(q[0], q[1], 0.0).normalized();
      const double f = r < 0.2 ? std::sqrt(r / 0.2) : r > 0.8 ? std::sqrt((1 - r) / 0.2) : 1.0;
      EXPECT_NEAR(r, (angleOf(q) - 20.0) / 60.0, 0.005);
      radial = std::max(radial, std::abs(move.dot(out) - 0.2 * f));
      tangential = std::max(tangential, (move - move.dot(out) * out).norm());
      along = std::max(along, std::abs(move.dot(view.normal())));
    }
    EXPECT_LT(radial, 0.003);
    EXPECT_LT(tangential, 0.006);
    EXPECT_LT(along, 1e-12);
    std::ostringstream text;
    text << (outline ? "outline: " : "curve: ") << "radial movement off 0.2 f(r) by at most " << radial
         << ", sideways " << tangential << ", along the view " << along;
    fact("A5_2", text.str());
  }
}

TEST(A5_2, PerspectiveTargetsStayParallelToTheImage)
{
  const View view = perspectiveView(Vector3(1.0, 0.5, 3.0), up, 40.0);
  Chain chain(sphere(4),
    toStroke(
      [&]
      {
        std::vector<Vector2> samples;
        for (int i = 0; i <= 100; ++i)
          samples.emplace_back(400 + 300 * std::cos(0.02 * i), 300 + 300 * std::sin(0.02 * i));
        return samples;
      }(),
      view),
    true);
  vtkPolyData* handles = chain.targets->GetOutput();
  ASSERT_GT(handles->GetNumberOfPoints(), 10);
  for (vtkIdType i = 0; i < handles->GetNumberOfPoints(); ++i)
    EXPECT_NEAR((tuple(handles, "Target", i) - pointOf(handles, i)).dot(view.normal()), 0.0, 1e-12);
}

TEST(A5_3, StrokeOnTheSectionMovesNothing)
{
  for (const bool perspective : { false, true })
  {
    const View view = perspective ? perspectiveView(Vector3(1.5, 1, 3), up, 40.0)
                                  : orthographicView(Vector3(1, 1, 2), up, 150.0);
    for (const bool outline : { false, true })
    {
      const auto mesh = toPolyData(torus(1.0, 0.4, 96, 48));
      const std::vector<Vector2> guess = [&]
      {
        std::vector<Vector2> samples;
        for (int i = 0; i <= 100; ++i)
          samples.emplace_back(400 + 220 * std::cos(0.015 * i), 300 + 220 * std::sin(0.015 * i));
        return samples;
      }();
      Chain chain(mesh, toStroke(guess, view), outline);
      vtkPolyData* section = chain.match->GetOutput();
      ASSERT_GT(section->GetNumberOfPoints(), 10);
      std::vector<Vector2> traced;
      for (vtkIdType i = 0; i < section->GetNumberOfPoints(); ++i)
      {
        Vector2 p;
        section->GetPointData()->GetArray("Display")->GetTuple(i, p.data());
        traced.push_back(p);
      }
      vtkNew<vtkOversketchTargets> targets;
      targets->SetInputData(section);
      targets->SetStrokeData(toStroke(traced, view));
      targets->SetMeshData(mesh);
      targets->Update();
      vtkPolyData* handles = targets->GetOutput();
      ASSERT_GT(handles->GetNumberOfPoints(), 10);
      double worst = 0.0;
      for (vtkIdType i = 0; i < handles->GetNumberOfPoints(); ++i)
        worst = std::max(worst, (tuple(handles, "Target", i) - pointOf(handles, i)).norm());
      EXPECT_LT(worst, 1e-9);
      std::ostringstream text;
      text << (perspective ? "perspective" : "orthographic") << (outline ? ", outline" : ", curve")
           << ": targets equal sources to " << worst;
      fact("A5_3", text.str());
    }
  }
}

namespace
{

const View plain = orthographicView(front, up, 200.0);

vtkSmartPointer<vtkPolyData> goodStroke()
{
  return toStroke(arc(plain, 1.2, 20.0, 80.0), plain);
}

} // namespace

TEST(Match, RefusesStrokesItCannotUse)
{
  Chain chain(sphere(3), goodStroke());
  const auto refuses = [&](vtkPolyData* stroke, Failure failure, const char* words)
  {
    vtkNew<vtkOversketchMatch> match;
    match->SetInputData(chain.silhouette->GetOutput());
    match->SetStrokeData(stroke);
    expectRefusal(match, failure, words);
  };
  auto stroke = goodStroke();
  stroke->GetCellData()->RemoveArray("ProjectionTransform");
  refuses(stroke, Failure::MissingArray, "ProjectionTransform");
  stroke = goodStroke();
  stroke->GetPoints()->SetPoint(3, std::nan(""), 0, 0);
  refuses(stroke, Failure::BadStroke, "Sample 3");
  stroke = goodStroke();
  stroke->GetLines()->InsertNextCell({ 0, 1, 2 });
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
    stroke->GetCellData()->GetArray(name)->InsertNextTuple(0, stroke->GetCellData()->GetArray(name));
  refuses(stroke, Failure::BadStroke, "2 polylines");
  stroke->GetCellData()->GetArray("ViewTransform")->SetComponent(1, 3, 0.5);
  refuses(stroke, Failure::BadStroke, "different views");
  vtkNew<vtkPolyData> none;
  refuses(none, Failure::BadStroke, "no stroke");
}

TEST(Match, RefusesCurvesItCannotUse)
{
  Chain chain(sphere(3), goodStroke());
  for (const char* name : { "MeshVertices", "MeshWeights", "Normals" })
  {
    vtkNew<vtkPolyData> curves;
    curves->ShallowCopy(chain.silhouette->GetOutput());
    curves->GetPointData()->RemoveArray(name);
    vtkNew<vtkOversketchMatch> match;
    match->SetInputData(curves);
    match->SetStrokeData(goodStroke());
    expectRefusal(match, Failure::MissingArray, name);
  }
  // A mesh instead of curves.
  vtkNew<vtkOversketchMatch> match;
  match->SetInputData(sphere(2));
  match->SetStrokeData(goodStroke());
  expectRefusal(match, Failure::BadMesh, "polylines");
}

TEST(Match, RefusesWhatDoesNotFit)
{
  Chain chain(sphere(3), goodStroke());
  const auto refuses = [&](vtkPolyData* stroke, double gate, const char* words)
  {
    vtkNew<vtkOversketchMatch> match;
    match->SetInputData(chain.silhouette->GetOutput());
    match->SetStrokeData(stroke);
    match->SetMaximumDistance(gate);
    expectRefusal(match, Failure::NoMatch, words);
  };
  // Towards the sphere: both ends have their nearest point at one place.
  std::vector<Vector2> ray;
  ray.reserve(30);
  for (int i = 0; i < 30; ++i)
    ray.emplace_back(700.0 - 2.0 * i, 300.0);
  refuses(toStroke(ray, plain), 0.0, "one place");
  // 40 px away, with a gate at 39 px and at 41.5 px.
  refuses(goodStroke(), 39.0, "MaximumDistance");
  chain.match->SetMaximumDistance(41.5);
  chain.match->Update();
  EXPECT_GT(chain.match->GetOutput()->GetNumberOfPoints(), 2);
}

TEST(Match, EmptyCurvesAreNoError)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkOversketchMatch> match;
  Ear ear(match);
  match->AddInputData(empty);
  match->AddInputData(empty);
  match->SetStrokeData(goodStroke());
  match->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(match->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(Match, BothArcsOfAClosedCurveCompete)
{
  // Over the top and round the bottom: the same ends, the other arc.
  for (const bool amended : { false, true })
  {
    for (const double to : { 150.0, -210.0 })
    {
      Chain chain(sphere(4), toStroke(arc(plain, 1.05, 30.0, to), plain), true);
      chain.match->SetAmendedScore(amended);
      chain.match->Update();
      vtkPolyData* section = chain.match->GetOutput();
      const vtkIdType middle = section->GetNumberOfPoints() / 2;
      EXPECT_EQ(pointOf(section, middle)[1] > 0.0, to > 0.0);
      EXPECT_NEAR(angleOf(pointOf(section, 0)), 30.0, 1.0);
    }
  }
}

TEST(Match, LeastDFavoursFragmentsAndTheAmendedScoreDoesNot)
{
  // A fragment right under the stroke's middle, the whole curve a little farther off.
  Chain chain(sphere(4), goodStroke());
  vtkPolyData* original = chain.silhouette->GetOutput();
  vtkNew<vtkPolyData> curves;
  curves->DeepCopy(original);
  std::vector<vtkIdType> fragment;
  for (vtkIdType i = 0; i < original->GetNumberOfPoints(); ++i)
  {
    const double angle = angleOf(pointOf(original, i));
    if (angle < 22.0 || angle > 78.0)
      continue;
    const Vector3 p = 1.099 * pointOf(original, i);
    fragment.push_back(curves->GetPoints()->InsertNextPoint(p.data()));
    for (int a = 0; a < curves->GetPointData()->GetNumberOfArrays(); ++a)
      curves->GetPointData()->GetArray(a)->InsertNextTuple(i, original->GetPointData()->GetArray(a));
  }
  std::sort(fragment.begin(),
    fragment.end(),
    [&](vtkIdType a, vtkIdType b) { return angleOf(pointOf(curves, a)) < angleOf(pointOf(curves, b)); });
  curves->GetLines()->InsertNextCell(static_cast<vtkIdType>(fragment.size()), fragment.data());
  vtkNew<vtkOversketchMatch> match;
  match->SetInputData(curves);
  // Its outer parts follow the sphere, only the middle the fragment.
  std::vector<Vector2> samples;
  for (int i = 0; i <= 300; ++i)
  {
    const double a = 10.0 + 80.0 * i / 300, bump = 0.095 * std::exp(-std::pow((a - 50.0) / 32.0, 8.0));
    samples.push_back(
      plain.toDisplay((1.005 + bump) * Vector3(std::cos(a * pi / 180), std::sin(a * pi / 180), 0)).head<2>());
  }
  match->SetStrokeData(toStroke(samples, plain));
  match->AmendedScoreOff();
  match->Update();
  EXPECT_EQ(match->GetOutput()->GetCellData()->GetArray("CurveId")->GetComponent(0, 0), 1.0);
  match->AmendedScoreOn();
  match->Update();
  EXPECT_EQ(match->GetOutput()->GetCellData()->GetArray("CurveId")->GetComponent(0, 0), 0.0);
  EXPECT_NEAR(angleOf(pointOf(match->GetOutput(), 0)), 10.0, 1.0);
}
