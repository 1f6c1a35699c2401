// Edits of coarse models and of limbs beside others: the region is as fine as the hand draws, and where it
// drew.
#include "EditSystem.h"

#include "Harness/shapes.h"
#include "vtkOversketchRefineBetween.h"

#include "vtkFieldData.h"

#include <gtest/gtest.h>

#include <queue>
#include <string>

using namespace oversketch_test;

namespace
{

vtkPolyData* outputOf(vtkOversketchEdit* system, const char* step, int port)
{
  return vtkPolyData::SafeDownCast(system->GetStep(step)->GetOutputDataObject(port));
}

std::vector<vtkIdType> chainOf(vtkPolyData* curve)
{
  std::vector<vtkIdType> chain;
  for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
  {
    chain.push_back(static_cast<vtkIdType>(curve->GetPointData()->GetArray("VertexId")->GetComponent(i, 0)));
  }
  return chain;
}

double middleOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

// How many edges lead from each vertex of the ring to the line, the middle of all.
double edgesFromLineToRing(vtkOversketchEdit* system)
{
  vtkPolyData* mesh = outputOf(system, "BoundaryInsert", 0);
  std::map<vtkIdType, std::set<vtkIdType>> links;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    for (const vtkIdType a : *ids)
    {
      links[a].insert(ids->begin(), ids->end());
    }
  }
  std::map<vtkIdType, int> steps;
  std::queue<vtkIdType> open;
  for (const vtkIdType v : chainOf(outputOf(system, "BoundaryInsert", 2)))
  {
    steps[v] = 0;
    open.push(v);
  }
  for (; !open.empty(); open.pop())
  {
    for (const vtkIdType w : links[open.front()])
    {
      if (steps.emplace(w, steps[open.front()] + 1).second)
      {
        open.push(w);
      }
    }
  }
  std::vector<double> found;
  for (const vtkIdType v : chainOf(outputOf(system, "BoundaryInsert", 1)))
  {
    found.push_back(steps.at(v));
  }
  return middleOf(found);
}

// How far a curve's edges are from its spline in the picture [px]: root of the mean square.
double offSpline(const View& view, vtkPolyData* curve, vtkPolyData* spline)
{
  double sum = 0.0;
  int count = 0;
  for (vtkIdType i = 1; i < curve->GetNumberOfPoints(); ++i)
  {
    const Vector2 a = view.toDisplay(placeOf(curve, i - 1)).head<2>(),
                  b = view.toDisplay(placeOf(curve, i)).head<2>();
    const int parts = std::max(1, static_cast<int>((b - a).norm()));
    for (int k = 0; k < parts; ++k, ++count)
    {
      const Vector2 p = a + (static_cast<double>(k) / parts) * (b - a);
      double least = HUGE_VAL;
      for (vtkIdType j = 0; j < spline->GetNumberOfPoints(); ++j)
      {
        least = std::min(least, (placeOf(spline, j).head<2>() - p).squaredNorm());
      }
      sum += least;
    }
  }
  return std::sqrt(sum / count);
}

// Of the triangles inside the region the smallest angles: p5.
double smallAngles(vtkPolyData* mesh, vtkPolyData* labels)
{
  vtkDataArray* region = labels->GetPointData()->GetArray("EditRegion");
  std::vector<double> angles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    Mesh one;
    bool inside = false;
    for (const vtkIdType id : *ids)
    {
      one.points.push_back(placeOf(mesh, id));
      inside = inside || region->GetComponent(id, 0) == 2.0;
    }
    if (inside)
    {
      angles.push_back(smallestAngle(one, { 0, 1, 2 }));
    }
  }
  std::sort(angles.begin(), angles.end());
  return angles[angles.size() / 20];
}

vtkSmartPointer<vtkPolyData> ball(int levels)
{
  return toPolyData(icosphere(levels));
}

// Two legs that are joined far above and below: a torus from its side, 100 px a unit.
vtkSmartPointer<vtkPolyData> legs()
{
  return toPolyData(torus(2.0, 0.5, 160, 48));
}

std::vector<Vector2> ellipse(double x, double y, double a, double b)
{
  std::vector<Vector2> samples;
  for (int i = 0; i < 120; ++i)
  {
    const double angle = 2.0 * pi * i / 120.0;
    samples.emplace_back(x + a * std::cos(angle), y + b * std::sin(angle));
  }
  return samples;
}

std::vector<Vector2> upright(double x, double low, double high)
{
  std::vector<Vector2> samples;
  for (int i = 0; i <= 30; ++i)
  {
    samples.emplace_back(x, low + (high - low) * i / 30.0);
  }
  return samples;
}

} // namespace

TEST(B11_5, ARegionUnderOneEdgeWideGetsSixEdgesFromLineToRing)
{
  for (const int levels : { 2, 3, 4 })
  {
    EditSystem s(ball(levels), lineOver(60.0), ringOver(45.0));
    s.operate("move 0.5 n %.9g", 0.05);
    vtkPolyData* output = s.run();
    ASSERT_GT(output->GetNumberOfPolys(), 0);
    const double edges = edgesFromLineToRing(s.filter);
    EXPECT_GE(edges, 6.0) << levels;
    const double line = offSpline(
                   s.view, outputOf(s.filter, "BoundaryInsert", 2), outputOf(s.filter, "ReferenceFit", 0)),
                 ring = offSpline(
                   s.view, outputOf(s.filter, "BoundaryInsert", 1), outputOf(s.filter, "BoundaryFit", 0));
    EXPECT_LT(line, 0.5) << levels;
    EXPECT_LT(ring, 0.6) << levels;
    vtkPolyData* made = outputOf(s.filter, "Retriangulate", 0);
    const double angle = smallAngles(made, made);
    EXPECT_GE(angle, 24.0) << levels;
    EXPECT_EQ(eulerNumber(output), 2);
    EXPECT_EQ(output->GetPointData()->GetArray("EdgeLength"), nullptr);
    // What lies two edges beyond the ring stays.
    const double meanEdge = output->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0);
    std::set<std::array<double, 3>> places;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = placeOf(output, i);
      places.insert({ p[0], p[1], p[2] });
    }
    vtkPolyData* patch = outputOf(s.filter, "Enclose", 1);
    for (vtkIdType i = 0; i < s.mesh->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = placeOf(s.mesh, i);
      EXPECT_TRUE(distanceTo(patch, p) <= 2.0 * meanEdge || places.count({ p[0], p[1], p[2] }));
    }
    fact("B11_5",
      std::to_string(s.mesh->GetNumberOfPolys()) + " triangles: " + std::to_string(edges) +
        " edges from line to ring, " + std::to_string(line) + " and " + std::to_string(ring) +
        " px off the splines, angles p5 " + std::to_string(angle));
  }
}

TEST(EditCoarse, AFineModelKeepsItsTrianglesAndSoItDoesAsPublished)
{
  EditSystem fine(ball(6), lineOver(60.0), ringOver(90.0));
  fine.run();
  EXPECT_EQ(
    outputOf(fine.filter, "Refine", 0)->GetPoints(), outputOf(fine.filter, "MeanEdge", 0)->GetPoints());
  EXPECT_EQ(outputOf(fine.filter, "Refine", 0)->GetPointData()->GetArray("EdgeLength"), nullptr);
  EditSystem coarse(ball(3), lineOver(60.0), ringOver(45.0));
  coarse.run();
  EXPECT_GT(outputOf(coarse.filter, "Refine", 0)->GetNumberOfPolys(), coarse.mesh->GetNumberOfPolys());
  coarse.filter->AsPublishedOn();
  coarse.run();
  EXPECT_EQ(vtkOversketchRefineBetween::SafeDownCast(coarse.filter->GetStep("Refine"))->GetEdges(), 0.0);
  EXPECT_LT(outputOf(coarse.filter, "ReferenceInsert", 0)->GetNumberOfPoints(),
    coarse.mesh->GetNumberOfPoints() + 50);
}

TEST(EditCoarse, TheLineKeepsToTheBendsOfItsStroke)
{
  std::vector<Vector2> stroke; // bends of a radius of 13 px
  for (int i = 0; i <= 120; ++i)
  {
    stroke.emplace_back(340.0 + i, 300.0 + 12.0 * std::sin(2.0 * pi * i / 80.0));
  }
  EditSystem s(ball(4), stroke, ringOver(90.0));
  s.run();
  vtkPolyData* line = outputOf(s.filter, "BoundaryInsert", 2);
  EXPECT_LT(offSpline(s.view, line, s.reference), 0.6);
}

TEST(EditCoarse, AnEditThatMovesNothingPutsOutItsInput)
{
  EditSystem s(ball(2), lineOver(60.0), ringOver(45.0));
  const auto before = deepCopy(s.mesh);
  s.filter->SetOperations("move 0.5 n 0");
  vtkPolyData* output = s.run();
  EXPECT_EQ(output->GetPoints(), s.mesh->GetPoints());
  expectSameBits(output, before);
}

TEST(EditCoarse, ARingOverTwoLegsIsThatOfTheLinesLeg)
{
  EditSystem s(legs(), upright(200.0, 280.0, 320.0), ellipse(400.0, 300.0, 290.0, 60.0));
  s.operate("move 0.5 n %.9g", 0.02);
  ASSERT_GT(s.run()->GetNumberOfPolys(), 0);
  vtkPolyData* region = outputOf(s.filter, "Enclose", 0);
  vtkDataArray* labels = region->GetPointData()->GetArray("EditRegion");
  int inside = 0;
  for (vtkIdType i = 0; i < region->GetNumberOfPoints(); ++i)
  {
    if (labels->GetComponent(i, 0) == 2.0)
    {
      ++inside;
      EXPECT_LT(placeOf(region, i)[0], 0.0);
      EXPECT_LT(std::abs(placeOf(region, i)[1]), 1.0);
    }
  }
  EXPECT_GT(inside, 50);
}

// A ring over a leg and most of what is round it encloses nearly all; a circle that does is told, and does.
TEST(EditCoarse, ForARingThatEnclosesNearlyAllOneThatDoesIsTold)
{
  const auto person = shippedModel("person");
  const View view = frontOf(person);
  Vector2 foot(0.0, HUGE_VAL);
  double top = -HUGE_VAL;
  for (vtkIdType i = 0; i < person->GetNumberOfPoints(); ++i)
  {
    const Vector2 p = view.toDisplay(placeOf(person, i)).head<2>();
    top = std::max(top, p[1]);
    if (placeOf(person, i)[0] > 0.0 && p[1] < foot[1])
    {
      foot = p;
    }
  }
  const double high = top - foot[1];
  const Vector2 middle = foot + Vector2(-0.03, 0.1) * high;
  EditSystem s(person,
    upright(middle[0], middle[1] - 0.06 * high, middle[1] + 0.06 * high),
    ellipse(middle[0], middle[1], 0.72 * high, 0.72 * high));
  Ear ear(s.filter);
  s.filter->Update();
  ASSERT_EQ(s.filter->GetErrorCode(), codeOf(Failure::BadRegion));
  ASSERT_FALSE(ear.errors.empty());
  const std::string& said = ear.errors[0];
  const std::size_t at = said.find("A circle of ");
  ASSERT_NE(at, std::string::npos) << said;
  double radius = 0.0, x = 0.0, y = 0.0;
  ASSERT_EQ(std::sscanf(said.c_str() + at, "A circle of %lf px round (%lf, %lf)", &radius, &x, &y), 3)
    << said;
  EXPECT_LT(radius, 0.72 * high);
  s.filter->SetBoundaryData(toStroke(ellipse(x, y, radius, radius), view));
  s.operate("move 0.5 n %.9g", 0.005);
  EXPECT_GT(s.run()->GetNumberOfPolys(), 0);
}

TEST(EditCoarse, AProfileDeeperThanTheLegIsThickIsRefused)
{
  EditSystem s(legs(), upright(200.0, 260.0, 340.0), ellipse(200.0, 300.0, 38.0, 75.0));
  const auto drawn = [](double deep, double lean = 0.0)
  {
    auto profile = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(41);
    for (int i = 0; i <= 40; ++i)
    {
      const double hump = std::pow(std::sin(pi * i / 40.0), 2.0);
      lines->InsertCellPoint(points->InsertNextPoint(i / 40.0 - lean * hump, -deep * hump, 0.0));
    }
    profile->SetPoints(points);
    profile->SetLines(lines);
    return profile;
  };
  s.filter->SetProfileData(drawn(2.2)); // of a width of 0.76, where the leg is 1 thick
  Ear ear(s.filter);
  s.filter->Update();
  EXPECT_EQ(s.filter->GetErrorCode(), codeOf(Failure::BadStroke));
  EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
  ASSERT_FALSE(ear.errors.empty());
  const std::string deep = ear.errors[0];
  EXPECT_NE(deep.find("times as deep as the model is thick there"), std::string::npos) << deep;
  EXPECT_EQ(deep.find("drag"), std::string::npos) << deep;
  s.filter->SetProfileData(drawn(0.3));
  s.run();
  EXPECT_EQ(std::string(s.filter->GetRemark()), "");
  // A profile that leans over outside of the leg is not deep in it, though the ways there lead through it.
  s.filter->SetProfileData(drawn(-0.3, 2.0));
  s.filter->Update();
  EXPECT_EQ(s.filter->GetErrorCode(), 0);
  EXPECT_NE(std::string(s.filter->GetRemark()).find("pass through itself"), std::string::npos);
}

// A ring over a thigh, whose hidden way could lead round the rest of the dog as well.
TEST(EditCoarse, WhatARingTakesLiesInItInThePicture)
{
  Eigen::Matrix4d from, onto = Eigen::Matrix4d::Zero();
  from << -0.9848, 0.0, 0.1736, 0.105, 0.0449, 0.9659, 0.2549, -0.757, -0.1677, 0.2588, -0.9513, -4.381, 0.0,
    0.0, 0.0, 1.0;
  onto.diagonal() << 2.799, 3.732, -1.0513, 0.0;
  onto(2, 3) = -0.8716;
  onto(3, 2) = -1.0;
  const View view(from, onto, 800, 600);
  const Vector2 middle(317.0, 360.0), axis(0.797, -0.604), across(0.604, 0.797);
  std::vector<Vector2> ring;
  for (const Vector2& p : ellipse(0.0, 0.0, 79.0, 61.0))
  {
    ring.emplace_back(middle + p[0] * axis + p[1] * across);
  }
  EditSystem s(shippedModel("dog"));
  s.filter->SetReferenceData(toStroke(
    { { 270, 376 }, { 296, 393 }, { 325, 392 }, { 347, 378 }, { 354, 354 }, { 351, 326 }, { 347, 318 } },
    view));
  s.filter->SetBoundaryData(toStroke(ring, view));
  s.run();
  vtkPolyData* labels = outputOf(s.filter, "Enclose", 0);
  int inside = 0, beyond = 0;
  for (vtkIdType v = 0; v < labels->GetNumberOfPoints(); ++v)
  {
    if (labels->GetPointData()->GetArray("EditRegion")->GetComponent(v, 0) == 2.0)
    {
      const Vector2 p = view.toDisplay(placeOf(labels, v)).head<2>() - middle;
      ++inside;
      beyond += std::hypot(p.dot(axis) / 79.0, p.dot(across) / 61.0) > 1.05 ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_LT(beyond, inside / 20) << inside;
}
