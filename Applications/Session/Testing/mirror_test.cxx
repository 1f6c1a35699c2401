// Steps that act on both sides of a plane: by partners, by a second run, and what the two agree on.
#include "sessions.h"

#include "mirror_image.h"
#include "system_runner.h"
#include "two_sides.h"

#include "Harness/shapes.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

// A line drawn in a view, through places in the world, with a sample every pixel.
vtkSmartPointer<vtkPolyData> drawn(const std::vector<Vector3>& places, const View& view)
{
  std::vector<Vector2> samples;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
  {
    const Vector2 from = view.toDisplay(places[i]).head<2>(), to = view.toDisplay(places[i + 1]).head<2>();
    const int count = std::max(1, static_cast<int>((to - from).norm()));
    for (int k = 0; k < count; ++k)
    {
      samples.push_back(from + static_cast<double>(k) / count * (to - from));
    }
  }
  return toStroke(samples, view);
}

// The bear's left arm drawn longer, in the plane of its middle.
std::vector<Vector3> longerArm()
{
  std::vector<Vector3> places{ { 0.42, 1.03, 0.0 } };
  for (int i = 0; i <= 16; ++i)
  {
    const double angle = 1.25 - pi * i / 16.0;
    places.emplace_back(1.02 + 0.115 * std::cos(angle), 0.72 + 0.115 * std::sin(angle), 0.06);
  }
  places.emplace_back(0.42, 0.79, 0.0);
  return places;
}

// Its left ear.
std::vector<Vector3> longerEar()
{
  std::vector<Vector3> places;
  for (int i = 0; i <= 24; ++i)
  {
    const double angle = (125.0 - 170.0 * i / 24.0) * pi / 180.0;
    const double out = 1.0 + 0.6 * std::sin(pi * i / 24.0);
    places.emplace_back(0.245 + 0.118 * out * std::cos(angle), 1.60 + 0.118 * out * std::sin(angle), 0.0);
  }
  return places;
}

struct Mirrored
{
  SystemRow row = *findSystem("OneStroke"); // which the runner refers to
  SystemRunner runner{ row };
  Outcome outcome;
  Step step;
  bool done = false;

  Mirrored(vtkPolyData* mesh,
    vtkPolyData* stroke,
    const MirrorPlane& plane,
    int remesh,
    bool follow = true,
    const Listener& listener = {},
    bool allowTorn = false)
  {
    this->step.system = "OneStroke";
    this->step.values["Remesh"] = remesh;
    this->step.values["AllowTorn"] = allowTorn;
    this->step.mirror = plane;
    this->row.mirroring = follow ? Mirroring::Partners : Mirroring::TwoRuns;
    this->outcome.mesh = mesh;
    this->done = this->runner.run(this->step,
      { { "Mesh", mesh }, { "Stroke", stroke } },
      vtkOversketchOneStroke::Host,
      {},
      listener,
      this->outcome);
  }
};

// Without a plane.
vtkSmartPointer<vtkPolyData> alone(vtkPolyData* mesh, vtkPolyData* stroke, int remesh)
{
  vtkNew<vtkOversketchOneStroke> system;
  system->SetBackendToHost();
  system->SetRemesh(remesh);
  system->SetInputData(0, mesh);
  system->SetStrokeData(stroke);
  system->Update();
  return system->GetOutput();
}

Vector3 at(vtkPolyData* mesh, vtkIdType i)
{
  Vector3 p;
  mesh->GetPoint(i, p.data());
  return p;
}

// The line from one place to another, of eleven points.
vtkSmartPointer<vtkPolyData> line(const Vector3& from, const Vector3& to)
{
  std::vector<Vector2> none(11, Vector2::Zero());
  auto line = toStroke(none, orthographicView({ 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 }, 100.0));
  for (vtkIdType i = 0; i <= 10; ++i)
  {
    line->GetPoints()->SetPoint(i, Vector3(from + 0.1 * static_cast<double>(i) * (to - from)).data());
  }
  return line;
}

constexpr int off = vtkOversketchOneStroke::RemeshOff, on = vtkOversketchOneStroke::RemeshOn,
              automatic = vtkOversketchOneStroke::RemeshAuto;

} // namespace

TEST(Mirror, BothWaysAgreeOnASymmetricModel)
{
  const auto bear = shippedModel("bear");
  const View front = orthographicView({ 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 }, 150.0);
  const View aside = perspectiveView({ 1.6, 1.2, 7.5 }, { 0.0, 1.0, 0.0 }, 30.0);
  double worst = 0.0;
  for (const View& view : { front, aside })
  {
    for (const auto& places : { longerArm(), longerEar() })
    {
      const auto stroke = drawn(places, view);
      const Mirrored partners(bear, stroke, { 0, 0.0 }, off), runs(bear, stroke, { 0, 0.0 }, off, false);
      ASSERT_EQ(partners.outcome.failure, "");
      ASSERT_EQ(runs.outcome.failure, "");
      EXPECT_GT(largestMove(bear, runs.outcome.mesh), 0.05);
      worst = std::max(worst, largestMove(partners.outcome.mesh, runs.outcome.mesh));
    }
  }
  EXPECT_LE(worst, 1e-6 * bear->GetLength());
  std::cout << "both ways agree within " << worst / bear->GetLength() << " of the bear's size\n";
}

TEST(Mirror, MaskedPointsStayOnBothSides)
{
  const auto bear = shippedModel("bear");
  const auto stroke = drawn(longerArm(), orthographicView({ 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 }, 150.0));
  const vtkSmartPointer<vtkPolyData> free = alone(bear, stroke, off);
  vtkNew<vtkFloatArray> mask;
  mask->SetName("Mask");
  for (vtkIdType i = 0; i < bear->GetNumberOfPoints(); ++i)
  {
    mask->InsertNextValue(std::abs(at(bear, i)[0]) < 0.65 || at(bear, i)[2] < -0.08 ? 1.0F : 0.0F);
  }
  int held = 0; // that moved without a mask
  for (vtkIdType i = 0; i < bear->GetNumberOfPoints(); ++i)
  {
    held += mask->GetValue(i) == 1.0F && at(free, i) != at(bear, i);
  }
  EXPECT_GT(held, 10);
  bear->GetPointData()->AddArray(mask);
  for (const bool follow : { true, false })
  {
    const Mirrored both(bear, stroke, { 0, 0.0 }, off, follow, {}, true);
    ASSERT_EQ(both.outcome.failure, "");
    int left = 0, right = 0;
    for (vtkIdType i = 0; i < bear->GetNumberOfPoints(); ++i)
    {
      const bool moved = at(both.outcome.mesh, i) != at(bear, i);
      EXPECT_FALSE(moved && mask->GetValue(i) == 1.0F) << i;
      (at(bear, i)[0] < 0.0 ? left : right) += moved;
    }
    EXPECT_GT(left, 10) << follow;
    EXPECT_GT(right, 10) << follow;
  }
}

TEST(Mirror, BothSidesOfASymmetricModelFollowAHandAlike)
{
  const auto bear = shippedModel("bear");
  const auto stroke = drawn(longerArm(), orthographicView({ 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 }, 150.0));
  Mirrored partners(bear, stroke, { 0, 0.0 }, off), runs(bear, stroke, { 0, 0.0 }, off, false);
  const auto followed = partners.runner.details(partners.outcome.mesh, {});
  const auto details = runs.runner.details(runs.outcome.mesh, {});
  ASSERT_TRUE(followed && followed->following && details && details->following);
  EXPECT_EQ(details->following->points, followed->following->points);
  for (std::size_t i = 0; i < details->following->moves.size(); ++i)
  {
    for (std::size_t k = 0; k < 9; ++k)
    {
      ASSERT_NEAR(details->following->moves[i][k], followed->following->moves[i][k], 1e-5);
    }
  }
  double box[6];
  details->region->GetBounds(box);
  EXPECT_EQ(box[0], -box[1]) << "the region is that of both sides";
  EXPECT_EQ(details->region->GetNumberOfPolys(), 2 * followed->region->GetNumberOfPolys());
}

TEST(Mirror, AModelWithoutPartnersIsRunOnBothSides)
{
  const auto person = shippedModel("person");
  const auto stroke = shippedStroke("person_longer_arm");
  double box[6];
  person->GetBounds(box);
  for (const int remesh : { off, automatic, on })
  {
    SCOPED_TRACE(remesh);
    const auto one = alone(person, stroke, remesh);
    Mirrored both(person, stroke, { 0, 0.0 }, remesh);
    ASSERT_EQ(both.outcome.failure, "");
    vtkPolyData* mesh = both.outcome.mesh;
    double left[6], now[6];
    one->GetBounds(left);
    mesh->GetBounds(now);
    EXPECT_EQ(left[0], box[0]);
    EXPECT_GT(left[1], box[1] + 0.2);
    EXPECT_EQ(now[1], left[1]) << "the side that was drawn on is as without a plane";
    EXPECT_NEAR(now[0], -now[1], 1e-3) << "the other one reaches as far";
    // Triangles came on one side and on the other, or on none.
    const vtkIdType before = person->GetNumberOfPoints(), first = one->GetNumberOfPoints();
    EXPECT_EQ(mesh->GetNumberOfPoints() > first, first > before);
    // What neither moved is as it was, to the bit.
    std::set<std::array<double, 3>> places;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = at(mesh, i);
      places.insert({ p[0], p[1], p[2] });
    }
    for (vtkIdType i = 0; i < before; ++i)
    {
      const Vector3 p = at(person, i);
      ASSERT_TRUE(std::abs(p[0]) > 0.2 || places.count({ p[0], p[1], p[2] }) > 0);
    }
    const auto details = both.runner.details(mesh, {});
    ASSERT_TRUE(details && details->following);
    EXPECT_EQ(details->following->count, mesh->GetNumberOfPoints());
    int sides[2] = { 0, 0 };
    for (const vtkIdType i : details->following->points)
    {
      ++sides[at(mesh, i)[0] > 0.0];
    }
    EXPECT_GT(sides[0], 500);
    EXPECT_NEAR(sides[0], sides[1], 0.1 * sides[1]);
    Outcome again;
    again.mesh = person;
    both.runner.run(
      both.step, { { "Mesh", person }, { "Stroke", stroke } }, vtkOversketchOneStroke::Host, {}, {}, again);
    EXPECT_TRUE(identical(again.mesh, mesh));
  }
}

TEST(Mirror, ThePlaneMayBeAnywhere)
{
  const auto person = shippedModel("person");
  vtkNew<vtkPolyData> aside;
  aside->DeepCopy(person);
  for (vtkIdType i = 0; i < aside->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = at(person, i) + Vector3(0.3, 0.0, 0.0);
    aside->GetPoints()->SetPoint(i, p.data());
  }
  const auto stroke = shippedStroke("person_longer_arm");
  const auto moved = shippedStroke("person_longer_arm");
  vtkDataArray* view = moved->GetCellData()->GetArray("ViewTransform");
  view->SetComponent(0, 3, view->GetComponent(0, 3) - 0.3);
  for (const int remesh : { off, on })
  {
    const Mirrored here(person, stroke, { 0, 0.0 }, remesh), there(aside, moved, { 0, 0.3 }, remesh);
    ASSERT_EQ(there.outcome.failure, "");
    double a[6], b[6];
    here.outcome.mesh->GetBounds(a);
    there.outcome.mesh->GetBounds(b);
    EXPECT_NEAR(b[0], a[0] + 0.3, 2e-3);
    EXPECT_NEAR(b[1], a[1] + 0.3, 2e-3);
    std::set<std::array<double, 3>> places;
    for (vtkIdType i = 0; i < there.outcome.mesh->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = at(there.outcome.mesh, i);
      places.insert({ p[0], p[1], p[2] });
    }
    for (vtkIdType i = 0; i < aside->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = at(aside, i);
      ASSERT_TRUE(std::abs(p[0] - 0.3) > 0.2 || places.count({ p[0], p[1], p[2] }) > 0)
        << "what nothing moved is as it was, to the bit";
    }
  }
}

TEST(Mirror, AFailureOnTheOtherSideNamesItAndIsTheSteps)
{
  // Behind the eye.
  const auto hand = shippedModel("hand");
  const Mirrored behind(hand, shippedStroke("hand_bent_thumb"), { 2, 4.5 }, automatic);
  EXPECT_TRUE(behind.done);
  EXPECT_EQ(behind.outcome.failure.text().find("mirrored to z > 4.5: "), 0u) << behind.outcome.failure;
  EXPECT_GT(behind.outcome.failure.text().size(), 30u);
  EXPECT_EQ(behind.outcome.mesh, hand) << "what the side did that was drawn on is gone, too";
  std::cout << behind.outcome.failure << '\n';
}

TEST(Mirror, AStrokeOverThePlaneOrOfWhatIsSeenFromBothSidesActsOnce)
{
  const auto dog = shippedModel("dog");
  // The tail lies in the plane; a leg beside it is the one that the mirrored stroke meets, too.
  for (const char* name : { "dog_curled_tail", "dog_longer_leg" })
  {
    const Mirrored once(dog, shippedStroke(name), { 2, 0.0 }, automatic);
    ASSERT_EQ(once.outcome.failure, "");
    EXPECT_TRUE(identical(once.outcome.mesh, alone(dog, shippedStroke(name), automatic)));
  }
}

TEST(Mirror, WhatLiesOverAPlane)
{
  const MirrorPlane plane{ 0, 1.0 };
  const Vector3 left(0.0, 0.0, 0.0), middle(1.0, 1.0, 0.0), right(2.0, 0.0, 0.0), over(1.0, 0.0, 0.0);
  EXPECT_TRUE(crossesMirrorPlane(line(left, right), plane, 1e-6));
  EXPECT_TRUE(crossesMirrorPlane(line(over, middle), plane, 1e-6)) << "in the plane";
  EXPECT_FALSE(crossesMirrorPlane(line(left, over), plane, 1e-6)) << "up to it";
  EXPECT_FALSE(crossesMirrorPlane(line(left, { 1.04, 0.0, 0.0 }), plane, 1e-6))
    << "the end rests on the body";
  EXPECT_TRUE(crossesMirrorPlane(line(left, { 1.4, 0.0, 0.0 }), plane, 1e-6));
  EXPECT_FALSE(crossesMirrorPlane(vtkNew<vtkPolyData>(), plane, 1e-6)) << "no place";
  const Section below{ { 0.5, 0.0, 0.0 }, 1.0 }, above{ { 1.5, 0.0, 0.0 }, 1.0 };
  EXPECT_TRUE(isSamePlace(below, above, plane));
  EXPECT_FALSE(isSamePlace(below, below, plane));
  EXPECT_FALSE(isSamePlace(std::nullopt, above, plane));
  EXPECT_EQ(mirroredTo(below, plane), "mirrored to x > 1");
  EXPECT_EQ(mirroredTo(above, plane), "mirrored to x < 1");
  EXPECT_EQ(mirroredTo(std::nullopt, plane), "mirrored at x = 1");
}

TEST(Mirror, ResultsJoinUnlessBothMovedAPoint)
{
  const auto ball = toPolyData(icosphere(1));
  const auto moved = [&](vtkIdType point)
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->DeepCopy(ball);
    mesh->GetPoints()->SetPoint(point, 3.0, 2.0, static_cast<double>(point));
    return mesh;
  };
  const auto both = joined(ball, moved(4), moved(7));
  ASSERT_TRUE(both);
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(at(both, i), i == 4 || i == 7 ? Vector3(3.0, 2.0, static_cast<double>(i)) : at(ball, i));
  }
  EXPECT_FALSE(joined(ball, moved(4), moved(4)));
  EXPECT_FALSE(joined(ball, moved(4), toPolyData(icosphere(2))));
}

TEST(Mirror, AMeshComesBackFromTheMirrorToTheBit)
{
  for (const double offset : { 0.0, 0.137 })
  {
    for (const char* name : { "dog", "bear" })
    {
      const auto mesh = shippedModel(name);
      vtkNew<vtkFloatArray> normals;
      normals->SetName("Normals");
      normals->SetNumberOfComponents(3);
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        normals->InsertNextTuple(at(mesh, i).normalized().eval().data());
      }
      mesh->GetPointData()->SetNormals(normals);
      const MirrorImage image(mesh, { 0, offset });
      EXPECT_EQ(identical(image.get(), mesh), offset == 0.0 && std::string(name) == "bear")
        << "what is its own image is the same mesh, numbers and all";
      double box[6], other[6];
      mesh->GetBounds(box);
      image.get()->GetBounds(other);
      EXPECT_DOUBLE_EQ(other[0], 2.0 * offset - box[1]);
      EXPECT_EQ(other[3], box[3]);
      const auto back = image.back(image.get());
      EXPECT_TRUE(identical(back, mesh));
      EXPECT_EQ(back->GetPoints()->GetDataType(), mesh->GetPoints()->GetDataType());
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += 97)
      {
        Vector3 a, b;
        normals->GetTuple(i, a.data());
        back->GetPointData()->GetNormals()->GetTuple(i, b.data());
        EXPECT_EQ(a, b);
        const vtkIdType there =
          image.get()->FindPoint(2.0 * offset - at(mesh, i)[0], at(mesh, i)[1], at(mesh, i)[2]);
        image.get()->GetPointData()->GetNormals()->GetTuple(there, b.data());
        EXPECT_EQ(b, Vector3(-a[0], a[1], a[2]));
      }
    }
  }
}

TEST(Mirror, ProgressOnlyGrowsAndACancelOnTheOtherSideIsHeard)
{
  const auto person = shippedModel("person");
  const auto stroke = shippedStroke("person_longer_arm");
  double share = 0.0;
  bool fell = false;
  Listener listener;
  listener.progress = [&](const std::string&, double now)
  {
    fell = fell || now < share;
    share = now;
  };
  const Mirrored whole(person, stroke, { 0, 0.0 }, automatic, true, listener);
  EXPECT_TRUE(whole.done);
  EXPECT_FALSE(fell);
  EXPECT_NEAR(share, 1.0, 1e-6);
  for (const double until : { 0.3, 0.55, 0.7 })
  {
    share = 0.0;
    listener.cancelled = [&] { return share > until; };
    const Mirrored stopped(person, stroke, { 0, 0.0 }, automatic, true, listener);
    EXPECT_FALSE(stopped.done) << until;
    EXPECT_EQ(stopped.outcome.mesh, person);
    EXPECT_EQ(stopped.outcome.failure, "");
  }
}

TEST(Mirror, WarningsAreSaidOnceForEachSide)
{
  const auto bear = shippedModel("bear");
  // A comb's teeth, which the arm cannot follow: it passes through itself.
  std::vector<Vector3> comb{ { 0.42, 1.03, 0.0 } };
  for (int i = 0; i < 9; ++i)
  {
    comb.emplace_back(1.0 + 0.3 * (i % 2), 0.98 - 0.04 * i, 0.06);
  }
  comb.emplace_back(0.42, 0.79, 0.0);
  const auto stroke = drawn(comb, orthographicView({ 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 }, 150.0));
  const Mirrored partners(bear, stroke, { 0, 0.0 }, off, true, {}, true);
  ASSERT_EQ(partners.outcome.failure, "");
  ASSERT_EQ(partners.outcome.remarks.size(), 1u);
  const std::string remark = partners.outcome.remarks[0].text();
  const Mirrored runs(bear, stroke, { 0, 0.0 }, off, false, {}, true);
  ASSERT_EQ(runs.outcome.remarks.size(), 2u);
  EXPECT_EQ(runs.outcome.remarks[0].text(), remark);
  EXPECT_EQ(runs.outcome.remarks[1].text(), "mirrored to x < 0: " + remark);
  vtkNew<vtkPolyData> crooked; // in one point, which moves
  crooked->DeepCopy(bear);
  const vtkIdType tip = crooked->FindPoint(0.95, 0.74, 0.07);
  crooked->GetPoints()->SetPoint(tip, Vector3(at(bear, tip) + Vector3(0.002, 0.001, 0.0)).data());
  const Mirrored tried(crooked, stroke, { 0, 0.0 }, off, true, {}, true);
  ASSERT_EQ(tried.outcome.failure, "");
  EXPECT_EQ(tried.outcome.remarks.size(), 2u) << "what was only tried is not spoken of";
}
