#include "Harness/polydata.h"
#include "vtkOversketchMatch.h"
#include "vtkOversketchOutline.h"
#include "vtkOversketchSilhouette.h"
#include "vtkOversketchTargets.h"

#include "Mesh/context.h"
#include "Silhouette/targets.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const Vector3 up(0, 1, 0), front(0, 0, 1);

std::vector<Vector2> arc(const View& view,
  double radius,
  double from,
  double to,
  const Vector3& centre = Vector3::Zero())
{
  std::vector<Vector2> samples;
  const int count = 400;
  for (int i = 0; i <= count; ++i)
  {
    const double a = (from + (to - from) * i / count) * pi / 180.0;
    samples.push_back(view.toDisplay(centre + radius * Vector3(std::cos(a), std::sin(a), 0.0)).head<2>());
  }
  return samples;
}

std::vector<Vector3> sphereNormals(const Mesh& mesh)
{
  std::vector<Vector3> normals = mesh.points;
  for (Vector3& n : normals)
    n.normalize();
  return normals;
}

vtkSmartPointer<vtkPolyData> sphere(int levels = 5)
{
  const Mesh mesh = icosphere(levels);
  const std::vector<Vector3> normals = sphereNormals(mesh);
  return toPolyData(mesh, &normals);
}

Vector3 pointOf(vtkPolyData* data, vtkIdType i)
{
  Vector3 p;
  data->GetPoint(i, p.data());
  return p;
}

Vector3 tuple(vtkPolyData* data, const char* name, vtkIdType i)
{
  Vector3 p;
  data->GetPointData()->GetArray(name)->GetTuple(i, p.data());
  return p;
}

double field(vtkPolyData* data, const char* name)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

double angleOf(const Vector3& p)
{
  return std::atan2(p[1], p[0]) * 180.0 / pi;
}

// Two meshes side by side.
Mesh joined(const Mesh& a, const Mesh& b, const Vector3& shift)
{
  Mesh m = a;
  for (const Vector3& p : b.points)
    m.points.push_back(p + shift);
  for (const Triangle& t : b.triangles)
    m.triangles.push_back({ t[0] + a.vertexCount(), t[1] + a.vertexCount(), t[2] + a.vertexCount() });
  return m;
}

struct Chain
{
  vtkNew<vtkOversketchSilhouette> silhouette;
  vtkNew<vtkOversketchOutline> outline;
  vtkNew<vtkOversketchMatch> match;
  vtkNew<vtkOversketchTargets> targets;
  vtkNew<vtkPolyData> stroke;

  Chain(vtkPolyData* mesh, vtkPolyData* strokeData, bool withOutline = false)
  {
    this->stroke->ShallowCopy(strokeData);
    this->silhouette->SetInputData(mesh);
    this->silhouette->SetStrokeData(this->stroke);
    this->outline->SetInputData(mesh);
    this->outline->SetStrokeData(this->stroke);
    this->outline->SetCurvesConnection(this->silhouette->GetOutputPort());
    this->match->AddInputConnection(this->silhouette->GetOutputPort());
    if (withOutline)
    {
      this->match->AddInputConnection(this->outline->GetOutputPort());
    }
    this->match->SetStrokeData(this->stroke);
    this->targets->SetInputConnection(this->match->GetOutputPort());
    this->targets->SetStrokeData(this->stroke);
    this->targets->SetMeshData(mesh);
    this->targets->Update();
  }
  void setStroke(vtkPolyData* data)
  {
    this->stroke->ShallowCopy(data);
    this->stroke->Modified();
    this->targets->Update();
  }
};

} // namespace

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
      double target = 0.0;
      for (vtkIdType i = 1; i < handles->GetNumberOfPoints(); ++i)
        target += (tuple(handles, "UnmergedTarget", i) - tuple(handles, "UnmergedTarget", i - 1)).norm();
      const double k = field(handles, "SectionLength") / target;
      EXPECT_NEAR(k, 1.0 / 1.2, 0.004);
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
    curves->Modified();
    match->Modified();
    match->Update(); // the same curve, seen, would win
    EXPECT_NEAR(field(match->GetOutput(), "Distance"), 1.0, 0.5);
    visible->SetValue(1, 0);
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
