// Steps that act on both sides of a plane: by partners, by a second run, and what the two agree on.
#include "sessions.h"

#include "mirror_image.h"
#include "system_runner.h"
#include "two_sides.h"

#include "Harness/shapes.h"

#include "vtkFloatArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
  SystemRunner runner{ *findSystem("OneStroke") };
  Outcome outcome;
  Step step;

  Mirrored(vtkPolyData* mesh, vtkPolyData* stroke, const MirrorPlane& plane, int remesh, bool follow = true)
  {
    this->step.system = "OneStroke";
    this->step.values["Remesh"] = remesh;
    this->step.mirror = plane;
    this->runner.setFollowPartners(follow);
    this->outcome.mesh = mesh;
    EXPECT_TRUE(this->runner.run(this->step,
      { { "Mesh", mesh }, { "Stroke", stroke } },
      vtkOversketchOneStroke::Host,
      {},
      {},
      this->outcome));
  }
};

constexpr int off = vtkOversketchOneStroke::RemeshOff;

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
      std::cout << "worst " << worst << " move " << largestMove(bear, runs.outcome.mesh) << " partners move " << largestMove(bear, partners.outcome.mesh) << "\n";
    }
  }
  EXPECT_LE(worst, 1e-6 * bear->GetLength());
}
