// Rings and lines of a bad hand over shared models: what comes of them is what regions are grown up to.
#include "CurveChain.h"
#include "SurfaceTools.h"
#include "vtkOversketchFilterTools.h"

#include <gtest/gtest.h>

#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// The picture's stroke with a hand's slow wander and its jitter [px].
std::vector<Vector2> byHand(std::vector<Vector2> stroke, std::mt19937& random)
{
  std::normal_distribution<double> wander(0.0, 0.5), jitter(0.0, 0.4);
  Vector2 off = Vector2::Zero();
  for (Vector2& sample : stroke)
  {
    for (int k = 0; k < 2; ++k)
    {
      off[k] = 0.85 * off[k] + wander(random);
      sample[k] += 2.0 * off[k] + jitter(random);
    }
  }
  return stroke;
}

} // namespace

TEST(InsertCurve, ShakyRingsAndLinesOverModels)
{
  for (const char* name : { "spot_5k9.obj", "hand_closed.obj", "bunny_5k.obj" })
  {
    const auto model = sharedModel(name);
    if (!model)
    {
      GTEST_SKIP();
    }
    const Mesh before = MeshOf(model);
    const int euler = eulerNumber(before.triangles);
    std::mt19937 random(11);
    std::vector<double> angles;
    double squares = 0.0, farthest = 0.0;
    int count = 0;
    for (const bool perspective : { false, true })
    {
      const View view = viewOfModel(model, perspective);
      for (int i = 0; i < 6; ++i)
      {
        const bool ring = i % 2 == 0;
        const std::size_t start = random() % before.points.size();
        const Vector2 middle = view.toDisplay(before.points[start]).head<2>();
        const double radius = 30.0 + 10.0 * i;
        const std::vector<Vector2> stroke = byHand(
          ring ? circleOf(middle, radius)
               : straight(middle - Vector2(radius, 0.5 * radius), middle + Vector2(radius, 0.5 * radius), 60),
          random);
        CurveChain chain(model, toStroke(stroke, view));
        chain.Fit->SetClosed(ring);
        Ear ear(chain.Project); // lines may go over gaps
        chain.Insert->Update();
        vtkPolyData* curves = chain.Insert->GetCurvesOutput();
        ASSERT_EQ(curves->GetNumberOfLines(), 1) << name << " " << i;
        const Mesh after = MeshOf(chain.Insert->GetOutput());
        const MeshCurve curve = curveOfCell(curves, 0);
        EXPECT_EQ(curve.closed, ring);
        EXPECT_TRUE(soundCurve(curve)) << name << " " << i;
        EXPECT_EQ(looseSegments(after, curve), 0) << name << " " << i;
        EXPECT_EQ(eulerNumber(after.triangles), euler) << name << " " << i;
        double near = 0.0;
        for (const Triangle& t : trianglesAlong(after, curve))
        {
          near += areaOf(after, t);
        }
        EXPECT_LT(std::abs(areaOf(after) - areaOf(before)), 1e-2 * near) << name << " " << i;
        const std::vector<double> along = anglesAlong(after, curve);
        angles.insert(angles.end(), along.begin(), along.end());
        if (ring)
        {
          // A region on either side, whatever was hidden of the ring.
          const std::size_t one = sideOf(after, curve, 0).size();
          EXPECT_LT(one, after.triangles.size()) << name << " " << i;
        }
        else
        {
          Polyline picture;
          for (vtkIdType k = 0; k < chain.Fit->GetOutput()->GetNumberOfPoints(); ++k)
          {
            picture.emplace_back(Vector3(chain.Fit->GetOutput()->GetPoint(k)).head<2>());
          }
          const NearestPlace nearest(picture);
          for (const int v : curve.vertices)
          {
            const double away = nearest(view.toDisplay(after.points[v]).head<2>()).distance;
            squares += away * away;
            farthest = std::max(farthest, away);
            ++count;
          }
        }
      }
    }
    std::sort(angles.begin(), angles.end());
    EXPECT_GT(share(angles, 0.05), 13.0) << name;
    EXPECT_LT(std::sqrt(squares / count), 1.2) << name;
    EXPECT_LT(farthest, 7.0) << name;
    std::cout << name << ": p1, p5 of the angles " << share(angles, 0.01) << ", " << share(angles, 0.05)
              << ", off the stroke " << std::sqrt(squares / count) << " px rms, " << farthest
              << " px at most\n";
  }
}
