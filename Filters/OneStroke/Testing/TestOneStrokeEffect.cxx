// What the one-stroke system says of its results, what it refuses, and what Candidate and Reach change.
#include "Harness/edits.h"
#include "Harness/shipped.h"

#include "Mesh/context.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchOneStroke.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <set>
#include <string>

using namespace oversketch_test;

namespace
{

struct Drawn
{
  explicit Drawn(vtkPolyData* stroke)
    : ear(filter)
  {
    this->filter->SetBackendToHost();
    this->filter->SetInputData(0, this->mesh);
    this->filter->SetStrokeData(stroke);
  }
  void run() { this->filter->Update(); }
  bool failedBy(Failure failure) { return this->filter->GetErrorCode() == codeOf(failure); }

  vtkSmartPointer<vtkPolyData> mesh = shippedModel("dog");
  vtkNew<vtkOversketchOneStroke> filter;
  Ear ear;
};

// The stroke with its samples put elsewhere.
vtkSmartPointer<vtkPolyData> put(vtkPolyData* stroke, const std::function<Vector2(const Vector2&)>& where)
{
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->DeepCopy(stroke);
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    Vector3 p;
    made->GetPoint(i, p.data());
    const Vector2 q = where(p.head<2>());
    made->GetPoints()->SetPoint(i, q[0], q[1], 0.0);
  }
  return made;
}

vtkIdType regionSize(vtkOversketchOneStroke* filter)
{
  vtkDataArray* region = filter->GetInnerOutput("RegionBorder")->GetPointData()->GetArray("Region");
  vtkIdType inside = 0;
  for (vtkIdType i = 0; i < region->GetNumberOfTuples(); ++i)
  {
    inside += region->GetComponent(i, 0) != 0.0;
  }
  return inside;
}

} // namespace

TEST(OneStrokeEffect, ADeviceThatIsNotThereIsSaidOnceARun)
{
  setenv("OVERSKETCH_OPENCL", "off", 1);
  Drawn drawn(shippedStroke("dog_longer_leg"));
  drawn.filter->SetBackendToOpenCL();
  for (int run = 1; run <= 2; ++run)
  {
    drawn.filter->Modified();
    drawn.filter->GetStep("ShapeDiameter")->Modified();
    drawn.filter->GetStep("MixtureRegion")->Modified();
    drawn.run();
    EXPECT_LE(drawn.ear.warnings.size(), static_cast<std::size_t>(run));
  }
  unsetenv("OVERSKETCH_OPENCL");
  ASSERT_GE(drawn.ear.warnings.size(), 1u);
  EXPECT_NE(drawn.ear.warnings[0].find("OpenCL"), std::string::npos);
}

TEST(OneStrokeEffect, AStrokeThatDoesWhatWasDrawnIsLeftWithoutAWord)
{
  for (const char* name : { "dog_longer_leg", "dog_curled_tail" })
  {
    Drawn good(shippedStroke(name));
    good.run();
    ASSERT_EQ(good.filter->GetErrorCode(), 0u);
    EXPECT_STREQ(good.filter->GetRemark(), "") << name;
    EXPECT_TRUE(good.ear.warnings.empty()) << name;
    EXPECT_LT(good.filter->GetFigure("effect.outline_px"), 1.0);
    EXPECT_LT(good.filter->GetFigure("effect.worst_outline_px"), 3.0);
    EXPECT_LT(good.filter->GetFigure("effect.outline_back_px"), 1.0);
    EXPECT_GT(good.filter->GetFigure("effect.stretch"), 1.0);
    EXPECT_LT(good.filter->GetFigure("effect.stretch"), 3.0);
    EXPECT_GT(good.filter->GetFigure("effect.moved_share"), 0.02);
    EXPECT_LT(good.filter->GetFigure("effect.moved_share"), 0.15);
    EXPECT_GT(good.filter->GetFigure("effect.roughness_before"), 1.0);
    EXPECT_EQ(good.filter->GetFigure("effect.stray_distance_px"), 0.0);
  }
}

// A torso stroke: the back raised by 16 px moves the back, and neither tail nor head nor legs.
TEST(OneStrokeEffect, ABackThatIsRaisedTakesNoLimbWithIt)
{
  vtkSmartPointer<vtkPolyData> stroke = shippedStroke("dog_curled_tail");
  Drawn dog(stroke);
  dog.run();
  ASSERT_EQ(dog.filter->GetErrorCode(), 0u);
  const View view = oversketch::ViewOf(stroke);
  // The highest place of the outline over each of some columns between tail and neck.
  vtkDataArray* outline = dog.filter->GetInnerOutput("Outline")->GetPointData()->GetArray("Display");
  ASSERT_NE(outline, nullptr);
  std::map<int, double> top;
  for (vtkIdType i = 0; i < outline->GetNumberOfTuples(); ++i)
  {
    double& height = top[static_cast<int>(std::floor(outline->GetComponent(i, 0) / 5.0))];
    height = std::max(height, outline->GetComponent(i, 1));
  }
  constexpr double from = 290.0, to = 430.0;
  std::vector<Vector2> raised;
  for (const auto& [column, height] : top)
  {
    const double x = 5.0 * column + 2.5;
    if (x >= from && x <= to)
    {
      raised.emplace_back(x, height + 16.0 * std::sin(pi * (x - from) / (to - from)));
    }
  }
  ASSERT_GT(raised.size(), 20u);
  dog.filter->SetStrokeData(toStroke(raised, view));
  dog.filter->SetRemeshToOff();
  dog.run();
  ASSERT_EQ(dog.filter->GetErrorCode(), 0u);
  EXPECT_STREQ(dog.filter->GetRemark(), "");
  EXPECT_LT(dog.filter->GetFigure("effect.outline_px"), 3.0);
  EXPECT_LT(dog.filter->GetFigure("effect.moved_share"), 0.2);
  int limbs = 0, back = 0;
  for (vtkIdType i = 0; i < dog.mesh->GetNumberOfPoints(); ++i)
  {
    Vector3 p, q;
    dog.mesh->GetPoint(i, p.data());
    dog.filter->GetOutput()->GetPoint(i, q.data());
    const Vector2 place = view.toDisplay(p).head<2>();
    const double away = std::max(from - place[0], place[0] - to);
    if (away > 40.0)
    {
      ++limbs;
      EXPECT_EQ(p, q) << "point " << i << " at " << place.transpose() << " px";
    }
    back += (view.toDisplay(q).head<2>() - place).norm() > 8.0;
  }
  EXPECT_GT(limbs, dog.mesh->GetNumberOfPoints() / 3);
  EXPECT_GT(back, 50);
}

TEST(OneStrokeEffect, AStrokeInTheVoidIsRefusedWithItsDistanceAndAsPublishedIsNot)
{
  Drawn far(
    put(shippedStroke("dog_longer_leg"), [](const Vector2& p) { return Vector2(p + Vector2(300, 300)); }));
  far.run();
  EXPECT_TRUE(far.failedBy(Failure::NoMatch));
  ASSERT_FALSE(far.ear.errors.empty());
  EXPECT_NE(far.ear.errors[0].find("px from any outline"), std::string::npos);
  EXPECT_EQ(far.filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_STREQ(far.filter->GetRemark(), "");
  far.filter->AsPublishedOn();
  far.ear.errors.clear();
  far.run();
  EXPECT_TRUE(far.ear.errors.empty() || far.ear.errors[0].find("MaximumGap") == std::string::npos);
}

TEST(OneStrokeEffect, AStrokeClosedRoundALimbIsAsGoodAsTheOpenOne)
{
  vtkSmartPointer<vtkPolyData> stroke = shippedStroke("dog_longer_leg");
  std::vector<Vector2> samples = oversketch::StrokeOf(stroke);
  const Vector2 last = samples.back(), gap = samples.front() - last;
  for (int i = 1; i < 20; ++i)
  {
    samples.push_back(last + gap * i / 20.0);
  }
  Drawn closed(toStroke(samples, oversketch::ViewOf(stroke)));
  closed.run();
  ASSERT_EQ(closed.filter->GetErrorCode(), 0u);
  EXPECT_STREQ(closed.filter->GetRemark(), "");
  EXPECT_LT(closed.filter->GetFigure("effect.outline_px"), 1.0);
  EXPECT_LT(closed.filter->GetFigure("effect.moved_share"), 0.15);
  closed.filter->AsPublishedOn();
  closed.run();
  EXPECT_TRUE(closed.failedBy(Failure::BadStroke));
  EXPECT_NE(closed.ear.errors[0].find("it is closed"), std::string::npos);
}

// The tail becomes a fat one, and ends before the loop's right part.
TEST(OneStrokeEffect, OfALoopItIsSaidByHowMuchItIsMissed)
{
  const vtkSmartPointer<vtkPolyData> dog = shippedModel("dog");
  const View view = frontOf(dog);
  Vector2 tip(0.0, -HUGE_VAL);
  for (vtkIdType i = 0; i < dog->GetNumberOfPoints(); ++i)
  {
    const Vector2 p = view.toDisplay(Vector3(dog->GetPoint(i))).head<2>();
    tip = p[1] > tip[1] ? p : tip;
  }
  std::vector<Vector2> samples;
  for (int i = 0; i <= 100; ++i)
  {
    const double angle = 0.0628 * i;
    samples.push_back(tip + Vector2(120.0 * std::sin(angle), -90.0 * (1.0 - std::cos(angle))));
  }
  Drawn loop(toStroke(samples, view));
  loop.run();
  ASSERT_EQ(loop.filter->GetErrorCode(), 0u);
  EXPECT_LT(loop.filter->GetFigure("effect.outline_px"), 1.0);
  double missed = 0.0;
  ASSERT_EQ(std::sscanf(loop.filter->GetRemark(),
              "The result is not as drawn: the outline misses the stroke by %lf px at worst",
              &missed),
    1)
    << loop.filter->GetRemark();
  EXPECT_GT(missed, 10.0);
}

TEST(OneStrokeEffect, AResultThatTearsIsRefusedUnlessItIsAllowed)
{
  vtkSmartPointer<vtkPolyData> stroke = shippedStroke("dog_curled_tail");
  Vector3 first;
  stroke->GetPoint(0, first.data());
  Drawn torn(
    put(stroke, [&](const Vector2& p) { return Vector2(first.head<2>() + 3.0 * (p - first.head<2>())); }));
  for (int again = 0; again < 2; ++again)
  {
    torn.run();
    EXPECT_TRUE(torn.failedBy(Failure::Torn));
    EXPECT_EQ(torn.filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_TRUE(std::isnan(torn.filter->GetFigure("effect.stretch")));
  }
  ASSERT_FALSE(torn.ear.errors.empty());
  EXPECT_NE(torn.ear.errors[0].find("turn AllowTorn on"), std::string::npos);
  torn.ear.errors.clear();
  torn.ear.warnings.clear();
  torn.filter->AllowTornOn();
  torn.run();
  ASSERT_EQ(torn.filter->GetErrorCode(), 0u);
  EXPECT_TRUE(torn.ear.errors.empty());
  EXPECT_GT(torn.filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_GT(torn.filter->GetFigure("effect.stretch"), 8.0);
  ASSERT_EQ(torn.ear.warnings.size(), 1u);
  EXPECT_NE(torn.ear.warnings[0].find(torn.filter->GetRemark()), std::string::npos);
  EXPECT_NE(std::string(torn.filter->GetRemark()).find("stretched or squeezed"), std::string::npos);
}

// Up the outer side of one leg, across below both feet, and up the other's: both would become one, welded.
TEST(OneStrokeEffect, TwoLegsUnderOneLineAreNotWelded)
{
  std::vector<Vector2> line;
  const Vector2 corners[] = { { 341, 256 }, { 335, 19 }, { 465, 19 }, { 460, 247 } };
  for (int k = 0; k < 3; ++k)
  {
    const int count = k == 1 ? 30 : 50;
    for (int i = 0; i < count; ++i)
    {
      line.push_back(corners[k] + static_cast<double>(i) / count * (corners[k + 1] - corners[k]));
    }
  }
  Drawn legs(toStroke(line, oversketch::ViewOf(shippedStroke("person_longer_arm"))));
  legs.mesh = shippedModel("person");
  legs.filter->SetInputData(0, legs.mesh);
  legs.run();
  EXPECT_TRUE(legs.failedBy(Failure::Torn));
  ASSERT_FALSE(legs.ear.errors.empty());
  EXPECT_NE(legs.ear.errors[0].find("passes through itself"), std::string::npos) << legs.ear.errors[0];
  EXPECT_NE(legs.ear.errors[0].find("one limb alone"), std::string::npos);
  legs.filter->AllowTornOn();
  legs.run();
  EXPECT_EQ(legs.filter->GetErrorCode(), 0u);
  EXPECT_GT(legs.filter->GetFigure("effect.new_crossings"), 10);
}

// A limb that is drawn many times as long is stretched as often; its triangles are made anew, so nothing is
// torn.
TEST(OneStrokeEffect, AnArmSeveralTimesAsLongIsNotTorn)
{
  vtkSmartPointer<vtkPolyData> stroke = shippedStroke("person_longer_arm");
  const std::vector<Vector2> samples = oversketch::StrokeOf(stroke);
  const Vector2 base = 0.5 * (samples.front() + samples.back());
  const Vector2 tip = *std::max_element(samples.begin(),
    samples.end(),
    [&](const Vector2& a, const Vector2& b) { return (a - base).norm() < (b - base).norm(); });
  const double length = (tip - base).norm();
  const Vector2 along = (tip - base) / length;
  Drawn arm(put(stroke,
    [&](const Vector2& p)
    {
      const double at = (p - base).dot(along);
      return Vector2(p + 3.5 * at * std::clamp(at / (0.3 * length), 0.0, 1.0) * along);
    }));
  arm.mesh = shippedModel("person");
  arm.filter->SetInputData(0, arm.mesh);
  arm.run();
  ASSERT_EQ(arm.filter->GetErrorCode(), 0u);
  EXPECT_GT(arm.filter->GetFigure("effect.stretch"), 8.0);
  EXPECT_TRUE(arm.filter->GetRemeshed());
  EXPECT_STREQ(arm.filter->GetRemark(), "");
  EXPECT_LT(arm.filter->GetFigure("effect.outline_px"), 1.0);
}

// A tail whose sides cross where they were drawn: taken as the ends of the stroke lie, its left side would go
// to the right, and the tail be turned inside out.
TEST(OneStrokeEffect, NoTailIsTurnedInsideOutForASideThatWasDrawnPastTheOther)
{
  vtkSmartPointer<vtkPolyData> stroke = shippedStroke("dog_curled_tail");
  const std::vector<Vector2> samples = oversketch::StrokeOf(stroke);
  const std::size_t last = samples.size() - 1;
  // Each sample goes over to the other side but the ends: by 1.6 of the way to the one as far from the other
  // end.
  std::vector<Vector2> crossed;
  for (std::size_t i = 0; i <= last; ++i)
  {
    const double share = static_cast<double>(std::min(i, last - i)) / static_cast<double>(last);
    crossed.push_back(samples[i] + std::min(1.0, share / 0.15) * 0.8 * (samples[last - i] - samples[i]));
  }
  Drawn tail(toStroke(crossed, oversketch::ViewOf(stroke)));
  tail.run();
  ASSERT_EQ(tail.filter->GetErrorCode(), 0u);
  EXPECT_LE(tail.filter->GetFigure("effect.inside_out"), 0.002) << tail.filter->GetRemark();
  EXPECT_LT(tail.filter->GetFigure("effect.outline_px"), 3.0);
}

TEST(OneStrokeEffect, CandidatesAreDifferentSectionsAndABadNumberIsRefused)
{
  Drawn tail(shippedStroke("dog_curled_tail"));
  tail.run();
  const int count = tail.filter->GetNumberOfCandidates();
  ASSERT_GE(count, 2);
  std::set<std::string> sections;
  for (int number = 1; number <= count; ++number)
  {
    tail.filter->SetCandidate(number);
    EXPECT_EQ(tail.filter->GetCandidate(), number);
    tail.filter->AllowTornOn();
    tail.run();
    ASSERT_EQ(tail.filter->GetErrorCode(), 0u) << number;
    vtkPolyData* match = tail.filter->GetInnerOutput("Match");
    sections.insert(std::to_string(match->GetNumberOfPoints()) + "/" + std::to_string(match->GetLength()));
  }
  EXPECT_EQ(static_cast<int>(sections.size()), count);
  tail.filter->SetCandidate(count + 1);
  tail.run();
  EXPECT_TRUE(tail.failedBy(Failure::NoMatch));
  EXPECT_NE(tail.ear.errors[0].find("Lower Candidate"), std::string::npos);
}

TEST(OneStrokeEffect, ReachMovesTheRegionsBorderBothWaysAndBackAgain)
{
  Drawn leg(shippedStroke("dog_longer_leg"));
  leg.filter->SetRemeshToOff();
  leg.run();
  const vtkIdType found = regionSize(leg.filter);
  vtkNew<vtkPolyData> first;
  first->DeepCopy(leg.filter->GetOutput());
  vtkIdType before = 0;
  for (const double reach : { -0.2, -0.1, 0.1, 0.3 })
  {
    leg.filter->SetReach(reach);
    leg.run();
    ASSERT_EQ(leg.filter->GetErrorCode(), 0u) << reach;
    const vtkIdType size = regionSize(leg.filter);
    EXPECT_GT(size, before) << reach;
    EXPECT_EQ(size > found, reach > 0.0) << reach;
    before = size;
  }
  leg.filter->SetReach(0.0);
  leg.run();
  EXPECT_TRUE(identical(first, leg.filter->GetOutput()));
}
