// Lassos on shapes whose enclosed part is known: what is masked, what the mask does then, and what the filter
// promises.
#include "Harness/copies.h"
#include "Harness/promises.h"
#include "Harness/shapes.h"
#include "Harness/shipped.h"
#include "Harness/strokes.h"

#include "vtkOversketchMask.h"
#include "vtkOversketchMaskArray.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// The ball from the front, its radius 200 px in a viewport of 800 x 600.
View front()
{
  return orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 200.0);
}

std::vector<Vector2> rectangle(double left, double bottom, double right, double top)
{
  return { { left, bottom }, { right, bottom }, { right, top }, { left, top } };
}

struct MaskOfBall : testing::Test
{
  MaskOfBall()
  {
    this->filter->SetInputData(0, this->mesh);
    // The right half of the picture.
    this->filter->SetStrokesData(toStroke(rectangle(400.5, 10, 790, 590), front()));
  }
  std::vector<double> made()
  {
    this->filter->Update();
    EXPECT_EQ(this->filter->GetErrorCode(), 0u);
    std::vector<double> mask = MaskOf(this->filter->GetOutput());
    mask.resize(this->ball.points.size(), 0.0);
    return mask;
  }
  // How many points do not have what a formula says.
  int wrong(const std::vector<double>& mask, const std::function<bool(const Vector3&)>& isMasked) const
  {
    int count = 0;
    for (std::size_t v = 0; v < mask.size(); ++v)
    {
      count += mask[v] != (isMasked(this->ball.points[v]) ? 1.0 : 0.0);
    }
    return count;
  }

  const Mesh ball = icosphere(5);
  vtkSmartPointer<vtkPolyData> mesh = toPolyData(ball);
  vtkNew<vtkOversketchMask> filter;
};

} // namespace

TEST_F(MaskOfBall, IsWhatTheLassoEnclosesAndTheEyeSees)
{
  const auto kept = deepCopy(this->mesh);
  const std::vector<double> mask = this->made();
  // Of vertices at the limb facets decide.
  EXPECT_LT(this->wrong(mask, [](const Vector3& p) { return p[0] > 0.0025 && p[2] > 0.0; }), 250);
  for (std::size_t v = 0; v < mask.size(); ++v)
  {
    EXPECT_FALSE(mask[v] != 0.0 && (this->ball.points[v][0] < 0.0 || this->ball.points[v][2] < -0.1)) << v;
  }
  EXPECT_EQ(this->filter->GetFigure("masked"), std::count(mask.begin(), mask.end(), 1.0));
  EXPECT_TRUE(identical(kept, this->mesh)) << "the input was touched";
  EXPECT_EQ(this->filter->GetOutput()->GetPoints(), this->mesh->GetPoints());
  EXPECT_EQ(this->filter->GetOutput()->GetPolys(), this->mesh->GetPolys());
}

TEST_F(MaskOfBall, GoesThroughWhereItIsToldTo)
{
  this->filter->ThroughOn();
  EXPECT_EQ(this->wrong(this->made(), [](const Vector3& p) { return 200.0 * p[0] >= 0.5; }), 0);
}

TEST_F(MaskOfBall, IsAddedToTakenFromAndReplaced)
{
  this->filter->ThroughOn();
  this->made();
  vtkNew<vtkOversketchMask> next;
  next->SetInputConnection(0, this->filter->GetOutputPort());
  next->SetStrokesData(toStroke(rectangle(10, 300.5, 790, 590), front())); // the upper half
  next->ThroughOn();
  const auto right = [](const Vector3& p) { return 200.0 * p[0] >= 0.5; };
  const auto upper = [](const Vector3& p) { return 200.0 * p[1] >= 0.5; };
  const auto masked = [&](int mode)
  {
    next->SetMode(mode);
    next->Update();
    std::vector<double> mask = MaskOf(next->GetOutput());
    mask.resize(this->ball.points.size(), 0.0);
    return mask;
  };
  EXPECT_EQ(
    this->wrong(masked(vtkOversketchMask::Add), [&](const Vector3& p) { return right(p) || upper(p); }), 0);
  EXPECT_EQ(
    this->wrong(masked(vtkOversketchMask::Subtract), [&](const Vector3& p) { return right(p) && !upper(p); }),
    0);
  EXPECT_EQ(this->wrong(masked(vtkOversketchMask::Replace), upper), 0);
  next->SetStrokesData(nullptr);
  EXPECT_EQ(this->wrong(masked(vtkOversketchMask::Replace), [](const Vector3&) { return false; }), 0);
}

TEST_F(MaskOfBall, InvertedTwiceIsItself)
{
  const std::vector<double> once = this->made();
  vtkNew<vtkOversketchMask> first, second;
  first->SetInputConnection(0, this->filter->GetOutputPort());
  first->InvertOn();
  second->SetInputConnection(0, first->GetOutputPort());
  second->InvertOn();
  second->Update();
  EXPECT_EQ(MaskOf(second->GetOutput()), once);
  const std::vector<double> other = MaskOf(first->GetOutput());
  for (std::size_t v = 0; v < once.size(); ++v)
  {
    EXPECT_EQ(other[v], 1.0 - once[v]) << v;
  }
}

TEST(MaskOfPlane, GrowsAndShrinksByALength)
{
  // Points every 0.1 in x and y, 41 in a row; a lasso round the middle one.
  Mesh plane;
  constexpr int side = 41;
  for (int i = 0; i < side * side; ++i)
  {
    plane.points.emplace_back(0.1 * (i % side - side / 2), 0.1 * (i / side - side / 2), 0.0);
  }
  for (int y = 0; y + 1 < side; ++y)
  {
    for (int x = 0; x + 1 < side; ++x)
    {
      const int a = y * side + x;
      plane.triangles.push_back({ a, a + 1, a + side });
      plane.triangles.push_back({ a + 1, a + side + 1, a + side });
    }
  }
  vtkNew<vtkOversketchMask> grown, shrunk;
  grown->SetInputData(0, toPolyData(plane));
  grown->SetStrokesData(toStroke(rectangle(395, 295, 405, 305), front()));
  grown->SetGrow(1.05);
  shrunk->SetInputConnection(0, grown->GetOutputPort());
  shrunk->SetGrow(-0.45);
  shrunk->Update();
  const std::vector<double> wide = MaskOf(grown->GetOutput()), narrow = MaskOf(shrunk->GetOutput());
  for (int i = 0; i < side * side; ++i)
  {
    const Vector3& p = plane.points[i];
    if (p[1] == 0.0) // along edges a length is a length
    {
      EXPECT_EQ(wide[i], std::abs(p[0]) < 1.05 ? 1.0 : 0.0) << p[0];
      EXPECT_EQ(narrow[i], std::abs(p[0]) < 0.65 ? 1.0 : 0.0) << p[0];
    }
    EXPECT_FALSE(p.norm() > 1.05 && wide[i] != 0.0) << "no way is shorter than the straight one";
  }
}

TEST(MaskOfSeams, IsOneForPointsAtOnePlace)
{
  const Mesh ball = icosphere(3);
  Mesh split;
  for (const Triangle& t : ball.triangles)
  {
    const int first = split.vertexCount();
    for (const int v : t)
    {
      split.points.push_back(ball.points[v]);
    }
    split.triangles.push_back({ first, first + 1, first + 2 });
  }
  vtkNew<vtkOversketchMask> whole, cut;
  whole->SetInputData(0, toPolyData(ball));
  cut->SetInputData(0, toPolyData(split));
  for (vtkOversketchMask* filter : { whole.Get(), cut.Get() })
  {
    filter->SetStrokesData(toStroke(rectangle(410, 10, 790, 590), front()));
    filter->SetGrow(0.2);
    filter->Update();
  }
  const std::vector<double> expected = MaskOf(whole->GetOutput()), found = MaskOf(cut->GetOutput());
  ASSERT_FALSE(expected.empty());
  for (int t = 0; t < ball.triangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(found[3 * t + k], expected[ball.triangles[t][k]]);
    }
  }
  // Of several values that came in the largest counts.
  vtkNew<vtkFloatArray> mask;
  mask->SetName("Mask");
  for (int i = 0; i < split.vertexCount(); ++i)
  {
    mask->InsertNextValue(i == 0 ? 1.0f : 0.0f);
  }
  const auto uneven = toPolyData(split);
  uneven->GetPointData()->AddArray(mask);
  vtkNew<vtkOversketchMask> twice;
  twice->SetInputData(0, uneven);
  twice->SetGrow(1e-9);
  twice->Update();
  const std::vector<double> even = MaskOf(twice->GetOutput());
  EXPECT_EQ(std::count(even.begin(), even.end(), 1.0),
    std::count(split.points.begin(), split.points.end(), split.points[0]));
}

TEST_F(MaskOfBall, ThreadsChangeNothing)
{
  this->filter->SetGrow(0.1);
  const std::vector<double> first = this->made();
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    this->filter->SetInputData(0, deepCopy(this->mesh));
    EXPECT_EQ(this->made(), first) << threads;
  }
  vtkSMPTools::Initialize(0);
}

TEST_F(MaskOfBall, ABadHandIsToldWhatIsWrong)
{
  const auto draw = [this](const std::vector<Vector2>& samples)
  { this->filter->SetStrokesData(toStroke(samples, front())); };
  draw(rectangle(5, 5, 60, 60));
  expectRefusal(this->filter, Failure::BadStroke, "encloses no point");
  draw({ { 300, 300 }, { 500, 300 } });
  expectRefusal(this->filter, Failure::BadStroke, "at least 3");
  draw({ { 300, 300 }, { 500, std::nan("") }, { 300, 400 } });
  expectRefusal(this->filter, Failure::BadStroke, "not finite");
  this->filter->SetStrokesData(nullptr);
  expectRefusal(this->filter, Failure::BadStroke, "There is no lasso");
  this->filter->SetGrow(std::nan(""));
  expectRefusal(this->filter, Failure::BadStroke, "Grow");
  this->filter->SetGrow(0.1);
  vtkNew<vtkFloatArray> array;
  array->SetName("Mask");
  array->SetNumberOfValues(this->mesh->GetNumberOfPoints());
  array->Fill(0.0);
  array->SetValue(7, std::nanf(""));
  this->mesh->GetPointData()->AddArray(array);
  expectRefusal(this->filter, Failure::MissingArray, "not finite at point 7");
  vtkNew<vtkFloatArray> three;
  three->SetName("Mask");
  three->SetNumberOfComponents(3);
  three->SetNumberOfTuples(this->mesh->GetNumberOfPoints());
  three->Fill(0.0);
  this->mesh->GetPointData()->AddArray(three);
  expectRefusal(this->filter, Failure::MissingArray, "Mask");
}

TEST_F(MaskOfBall, CancelLeavesNothing)
{
  expectCancel(this->filter);
  const std::vector<double> mask = this->made();
  EXPECT_GT(std::count(mask.begin(), mask.end(), 1.0), 1000);
}

TEST_F(MaskOfBall, NothingInGivesNothingOut)
{
  vtkNew<vtkPolyData> none;
  this->filter->SetInputData(0, none);
  this->filter->Update();
  EXPECT_EQ(this->filter->GetErrorCode(), 0u);
  EXPECT_EQ(this->filter->GetOutput()->GetNumberOfPoints(), 0);
}
