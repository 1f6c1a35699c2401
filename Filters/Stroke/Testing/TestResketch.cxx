// Facts of editors.md, section 13 (re-sketching), of curves on a mesh and of profiles; the figures of the
// blend itself are the kernel's.
#include "Harness/promises.h"
#include "Harness/strokes.h"
#include "vtkOversketchResketch.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View front = orthographicView(Vector3(0, 0, 1), Vector3(0, 1, 0), 10.0);

// A curve in a plane, without a view.
vtkSmartPointer<vtkPolyData> planeCurve(const std::vector<Vector2>& samples, bool closed = false)
{
  auto curve = toStrokes({ { samples, front } }, { closed });
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
  {
    curve->GetCellData()->RemoveArray(name);
  }
  return curve;
}

// The same, drawn on a mesh in the plane z = 0, its points being vertices 100, 101 and so on.
vtkSmartPointer<vtkPolyData> meshCurve(const std::vector<Vector2>& display, bool closed = false)
{
  auto curve = planeCurve(display, closed);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("VertexId");
  for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
  {
    const Vector3 p(curve->GetPoint(i));
    curve->GetPoints()->SetPoint(i, front.toWorld(p.head<2>(), front.depth(Vector3::Zero())).data());
    ids->InsertNextValue(100 + i);
  }
  curve->GetPointData()->AddArray(ids);
  return curve;
}

std::vector<Vector2> level(double x0, double x1, double y)
{
  return straight({ x0, y }, { x1, y }, static_cast<int>(std::abs(x1 - x0)) + 1);
}

std::vector<double> valuesOf(vtkPolyData* curve, const char* name)
{
  vtkDataArray* array = curve->GetPointData()->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

bool rises(const std::vector<double>& values)
{
  return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

struct Redrawing
{
  vtkNew<vtkOversketchResketch> filter;
  Redrawing(vtkPolyData* curve, vtkPolyData* stroke)
  {
    this->filter->SetInputData(curve);
    this->filter->SetStrokeData(stroke);
  }
  vtkPolyData* run()
  {
    this->filter->Update();
    return this->filter->GetOutput();
  }
};

} // namespace

TEST(B4_2, PointsOutsideKeepTheirVertices)
{
  int kept = 0;
  for (const bool backwards : { false, true })
  {
    Redrawing redrawing(
      meshCurve(level(0, 100, 0)), toStroke(backwards ? level(60, 40, 2) : level(40, 60, 2), front));
    vtkPolyData* r = redrawing.run();
    ASSERT_EQ(redrawing.filter->GetErrorCode(), 0u);
    const std::vector<double> ids = valuesOf(r, "VertexId");
    kept = 0;
    for (vtkIdType i = 0; i < r->GetNumberOfPoints(); ++i)
    {
      const Vector3 p(r->GetPoint(i));
      const bool outside = p[0] < 28.0 - 1e-9 || p[0] > 72.0 + 1e-9;
      if (outside)
      {
        EXPECT_NEAR(ids[i], 100.0 + p[0], 1e-9) << p.transpose();
        EXPECT_NEAR(p[1], 0.0, 1e-9);
        ++kept;
      }
      if (p[0] > 29.0 && p[0] < 71.0)
      {
        EXPECT_EQ(ids[i], -1.0) << p.transpose();
      }
    }
    EXPECT_EQ(kept, 2 * 28);
    EXPECT_TRUE(rises(valuesOf(r, "CurveT")));
    EXPECT_NE(r->GetCellData()->GetArray("ViewTransform"), nullptr);
  }
  fact("B4_2",
    "on a mesh: " + std::to_string(kept) +
      " points outside 0.28 to 0.72 keep their vertices, others have none");
}

TEST(B4_1, OfAProfileWithItsSources)
{
  // A profile of length 1: all is in its measure.
  const auto small = [](const std::vector<Vector2>& points)
  {
    std::vector<Vector2> result;
    for (const Vector2& p : points)
    {
      result.emplace_back(p / 100.0);
    }
    return result;
  };
  for (const double k : { 6.0, 3.0 })
  {
    Redrawing redrawing(planeCurve(small(level(0, 100, 0))), planeCurve(small(level(40, 60, 2))));
    redrawing.filter->SetK(k);
    vtkPolyData* r = redrawing.run();
    ASSERT_EQ(redrawing.filter->GetErrorCode(), 0u);
    EXPECT_FALSE(r->GetPointData()->HasArray("VertexId"));
    const std::vector<double> sources = valuesOf(r, "SourceT");
    EXPECT_TRUE(rises(sources));
    EXPECT_TRUE(rises(valuesOf(r, "CurveT")));
    EXPECT_EQ(valuesOf(r, "CurveT").front(), 0.0);
    EXPECT_EQ(valuesOf(r, "CurveT").back(), 1.0);
    const double left = 0.4 - 0.02 * k, right = 0.6 + 0.02 * k;
    for (vtkIdType i = 0; i < r->GetNumberOfPoints(); ++i)
    {
      const Vector3 p(r->GetPoint(i));
      // The old curve lies on the x axis: a source is where p was, but along the transitions.
      if (p[0] <= left || p[0] >= right || (p[0] >= 0.4 && p[0] <= 0.6))
      {
        EXPECT_NEAR(sources[i], p[0], 1e-12);
        EXPECT_NEAR(p[1], p[0] >= 0.4 && p[0] <= 0.6 ? 0.02 : 0.0, 1e-12);
      }
    }
  }
  fact("B4_1", "a profile of length 1: left at 0.28, k = 3 at 0.34; sources rise and are the old places");
}

TEST(B4_4, ClosestLosesTheBulgeInTheFilterToo)
{
  std::vector<Vector2> arc;
  for (int i = 0; i <= 40; ++i)
  {
    const double angle = pi * i / 40.0;
    arc.emplace_back(50.0 - 10.0 * std::cos(angle), 10.0 * std::sin(angle));
  }
  Redrawing redrawing(planeCurve(level(0, 100, 0)), planeCurve(arc));
  const auto high = [&]
  {
    vtkPolyData* r = redrawing.run();
    int count = 0;
    for (vtkIdType i = 0; i < r->GetNumberOfPoints(); ++i)
    {
      count += r->GetPoint(i)[1] > 5.0 ? 1 : 0;
    }
    return count;
  };
  const int stays = high();
  redrawing.filter->SetMiddleToClosest();
  const int collapsed = high();
  EXPECT_GT(stays, 20);
  EXPECT_LE(collapsed, 1);
  EXPECT_EQ(redrawing.filter->GetResketchCount(), 2);
  fact("B4_4",
    "points over half the bulge's height: " + std::to_string(stays) + ", by closest places " +
      std::to_string(collapsed));
}

TEST(Resketch, AClosedCurveStaysClosedAndKeepsItsVertices)
{
  std::vector<Vector2> circle, chord;
  for (int i = 0; i < 200; ++i)
  {
    circle.emplace_back(100.0 * std::cos(2 * pi * i / 200), 100.0 * std::sin(2 * pi * i / 200));
  }
  for (int i = -40; i <= 40; ++i)
  {
    chord.emplace_back(95.0, i);
  }
  Redrawing redrawing(meshCurve(circle, true), toStroke(chord, front));
  vtkPolyData* r = redrawing.run();
  ASSERT_EQ(redrawing.filter->GetErrorCode(), 0u);
  const std::vector<Vector3> points = pointsOfCell(r, 0);
  EXPECT_EQ(points.front(), points.back());
  EXPECT_EQ(static_cast<vtkIdType>(points.size()), r->GetNumberOfPoints() + 1);
  const std::vector<double> shares = valuesOf(r, "CurveT"), ids = valuesOf(r, "VertexId"),
                            sources = valuesOf(r, "SourceT");
  EXPECT_TRUE(rises(shares));
  EXPECT_LT(shares.back(), 1.0);
  int kept = 0;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    EXPECT_GE(sources[i], 0.0);
    EXPECT_LE(sources[i], 1.0);
    if (ids[i] >= 0.0)
    {
      const Vector2 was = circle[static_cast<std::size_t>(ids[i]) - 100];
      EXPECT_LT((points[i].head<2>() - was).norm(), 1e-9);
      EXPECT_NEAR(sources[i], (ids[i] - 100.0) / 200.0, 1e-9);
      ++kept;
    }
  }
  EXPECT_GT(kept, 100);
}

TEST(Resketch, NumbersOfBothAreBlendedAndOthersPassed)
{
  const auto withPressure = [](vtkSmartPointer<vtkPolyData> curve, float value)
  {
    vtkNew<vtkFloatArray> pressure;
    pressure->SetName("Pressure");
    pressure->SetNumberOfTuples(curve->GetNumberOfPoints());
    pressure->FillValue(value);
    curve->GetPointData()->AddArray(pressure);
    return curve;
  };
  const auto curve = withPressure(planeCurve(level(0, 100, 0)), 0.25f);
  vtkNew<vtkDoubleArray> matrix;
  matrix->SetName("Matrix");
  matrix->InsertNextValue(7.0);
  curve->GetFieldData()->AddArray(matrix);
  Redrawing redrawing(curve, withPressure(planeCurve(level(40, 60, 2)), 0.75f));
  vtkPolyData* r = redrawing.run();
  const std::vector<double> pressure = valuesOf(r, "Pressure");
  ASSERT_EQ(pressure.size(), static_cast<std::size_t>(r->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < r->GetNumberOfPoints(); ++i)
  {
    const double x = r->GetPoint(i)[0];
    EXPECT_GE(pressure[i], 0.25);
    EXPECT_LE(pressure[i], 0.75);
    if (x < 28.0 || x > 72.0)
    {
      EXPECT_EQ(pressure[i], 0.25);
    }
    if (x >= 40.0 && x <= 60.0)
    {
      EXPECT_EQ(pressure[i], 0.75);
    }
  }
  EXPECT_EQ(r->GetFieldData()->GetArray("Matrix")->GetComponent(0, 0), 7.0);
  vtkPoints* points = r->GetPoints();
  redrawing.filter->Modified();
  EXPECT_EQ(redrawing.run()->GetPoints(), points);
  EXPECT_EQ(redrawing.filter->GetResketchCount(), 1);
}

TEST(Resketch, WhatReplacesNothingWarns)
{
  Redrawing redrawing(planeCurve(level(0, 100, 0)), planeCurve({ { 50, 4 }, { 50, 9 } }));
  Ear ear(redrawing.filter);
  vtkPolyData* r = redrawing.run();
  EXPECT_EQ(ear.warnings.size(), 1u);
  EXPECT_EQ(r->GetNumberOfPoints(), 101);
  EXPECT_EQ(valuesOf(r, "SourceT").back(), 1.0);
}

TEST(Resketch, RefusesAndCancels)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto good = [] { return planeCurve(level(0, 100, 0)); };
  const auto drawn = [] { return toStroke(level(40, 60, 2), front); };
  const struct
  {
    vtkSmartPointer<vtkPolyData> curve, stroke;
    Failure failure;
    const char* words;
  } cases[] = {
    { good(), toStroke({ { 5, 5 }, { 5, 5 } }, front), Failure::BadStroke, "The stroke has no two places" },
    { planeCurve({ { 5, 5 }, { 5, 5 } }), drawn(), Failure::BadStroke, "The curve has no two places" },
    { good(), toStroke({ { 5, 5 }, { nan, 5 } }, front), Failure::BadStroke, "sample 1 is not finite" },
    { good(),
      toStrokes({ { level(0, 9, 0), front }, { level(0, 9, 1), front } }),
      Failure::BadStroke,
      "2 polylines where the stroke is one" },
    { toPolyData(icosphere(1)), drawn(), Failure::BadStroke, "polylines and no other cells" },
    { meshCurve(level(0, 100, 0)), planeCurve(level(40, 60, 2)), Failure::MissingArray, "ViewTransform" },
    { meshCurve(level(0, 100, 0)),
      toStroke(level(40, 60, 2), perspectiveView(Vector3(-30, -30, -0.5), Vector3(0, 0, 1), 50)),
      Failure::BadStroke,
      "is not in front of the eye" },
  };
  for (const auto& each : cases)
  {
    Redrawing redrawing(each.curve, each.stroke);
    expectRefusal(redrawing.filter, each.failure, each.words);
  }
  Redrawing redrawing(good(), drawn());
  expectCancel(redrawing.filter);
  EXPECT_GT(redrawing.run()->GetNumberOfPoints(), 90);
  vtkNew<vtkPolyData> empty;
  redrawing.filter->SetInputData(empty);
  Ear ear(redrawing.filter);
  EXPECT_EQ(redrawing.run()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(ear.errors.empty());
}
