#include "curve_chain.h"

#include "Silhouette/occlusion.h"
#include "Silhouette/visibility.h"

#include "vtkSMPTools.h"

#include <cstdlib>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr double R = 1.0, r = 0.4;

View torusView(double degrees)
{
  const double a = degrees * pi / 180.0;
  return orthographicView(Vector3(std::sin(a), 0.0, std::cos(a)), axisY, 200.0);
}

int hiddenParts(vtkPolyData* curves)
{
  int hidden = 0;
  for (vtkIdType cell = 0; cell < curves->GetNumberOfLines(); ++cell)
  {
    hidden += cellValue(curves, "Visible", cell) == 0;
  }
  return hidden;
}

// The curve with the smaller length of the two that a torus has.
int innerCurve(vtkPolyData* silhouette)
{
  return lengthOf(silhouette, lineOf(silhouette, 0)) < lengthOf(silhouette, lineOf(silhouette, 1)) ? 0 : 1;
}

struct Share
{
  double inner, outer; // hidden length over length
};

Share hiddenShare(CurveChain& chain, bool smoothed)
{
  if (!smoothed)
  {
    chain.visibility->SetInputConnection(chain.silhouette->GetOutputPort());
  }
  chain.visibility->Update();
  vtkPolyData* parts = chain.visibility->GetOutput();
  const int inner = innerCurve(chain.silhouette->GetOutput());
  double hidden[2] = { 0.0, 0.0 }, whole[2] = { 0.0, 0.0 };
  for (vtkIdType cell = 0; cell < parts->GetNumberOfLines(); ++cell)
  {
    const int which = cellValue(parts, "CurveId", cell) == inner ? 0 : 1;
    const double length = lengthOf(parts, lineOf(parts, cell));
    whole[which] += length;
    hidden[which] += cellValue(parts, "Visible", cell) ? 0.0 : length;
  }
  return { hidden[0] / whole[0], hidden[1] / whole[1] };
}

} // namespace

TEST(A3_1, NothingOfAConvexBodyIsHidden)
{
  Mesh ellipsoid = icosphere(4);
  for (Vector3& p : ellipsoid.points)
  {
    p = Vector3(p[0], 0.4 * p[1], 1.7 * p[2]);
  }
  int cases = 0;
  for (const Mesh& mesh : { icosphere(4), ellipsoid })
  {
    for (const Vector3& from : { Vector3(0, 0, 1), Vector3(1, 2, 3), Vector3(-3, 1, 0.2) })
    {
      for (const View& view :
        { orthographicView(from, axisY, 150.0), perspectiveView(4.0 * from.normalized(), axisY, 60.0) })
      {
        CurveChain chain(mesh, view);
        for (vtkAlgorithm* source :
          { static_cast<vtkAlgorithm*>(chain.silhouette), static_cast<vtkAlgorithm*>(chain.snake) })
        {
          chain.visibility->SetInputConnection(source->GetOutputPort());
          chain.visibility->Update();
          vtkPolyData* parts = chain.visibility->GetOutput();
          ASSERT_EQ(parts->GetNumberOfLines(), 1);
          EXPECT_TRUE(lineOf(parts, 0).closed);
          EXPECT_EQ(hiddenParts(parts), 0);
          ++cases;
        }
        // No point by itself, either: the vote has nothing to forgive.
        vtkPolyData* curves = chain.silhouette->GetOutput();
        std::vector<OcclusionQuery> queries;
        for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
        {
          OcclusionQuery query{ view.toScreen(pointAt(curves, i)), {} };
          for (int k = 0; k < 3; ++k)
          {
            query.vertices[k] =
              static_cast<int>(curves->GetPointData()->GetArray("MeshVertices")->GetComponent(i, k));
          }
          queries.push_back(query);
        }
        const auto hidden = occludedOnHost<double>(mesh, projectVertices(mesh, view), queries);
        EXPECT_EQ(std::count(hidden.begin(), hidden.end(), 1), 0);
      }
    }
  }
  fact("A3_1", "0 hidden parts and points in " + std::to_string(cases) + " cases, both cameras");
}

TEST(A3_2, TorusCuspsAndTheClosedHole)
{
  // Below the threshold of 50.77 degrees neither contour is cut, above the inner one is, near the four cusps.
  const Mesh mesh = torus(R, r, 256, 128);
  for (const double degrees : { 20.0, 40.0, 47.0 })
  {
    CurveChain chain(mesh, torusView(degrees));
    chain.visibility->RejoinOff();
    chain.visibility->Update();
    EXPECT_EQ(chain.visibility->GetOutput()->GetNumberOfLines(), 2) << degrees;
  }
  double worst = 0.0;
  for (const double degrees : { 56.0, 58.0, 60.0 })
  {
    CurveChain chain(mesh, torusView(degrees));
    chain.visibility->RejoinOff();
    chain.visibility->Update();
    vtkPolyData* parts = chain.visibility->GetOutput();
    const int inner = innerCurve(chain.silhouette->GetOutput());
    const double c = std::cos(degrees * pi / 180.0), s = std::sin(degrees * pi / 180.0);
    const double u = std::acos(std::sqrt((std::pow(r * c / R, 2.0 / 3.0) - c * c) / (s * s))) * 180.0 / pi;
    std::vector<double> nearest(4, 180.0); // of a cut to each of the four cusps
    int outerParts = 0;
    for (vtkIdType cell = 0; cell < parts->GetNumberOfLines(); ++cell)
    {
      if (cellValue(parts, "CurveId", cell) != inner)
      {
        ++outerParts;
        continue;
      }
      const Vector3 cut = pointAt(parts, lineOf(parts, cell).ids[0]);
      const double angle = std::atan2(cut[1], cut[0]) * 180.0 / pi;
      const double cusps[4] = { u, 180.0 - u, u - 180.0, -u };
      for (int k = 0; k < 4; ++k)
      {
        nearest[k] = std::min(nearest[k], std::abs(angle - cusps[k]));
      }
    }
    EXPECT_EQ(outerParts, 1) << degrees;
    worst = std::max(worst, *std::max_element(nearest.begin(), nearest.end()));
  }
  EXPECT_LT(worst, 2.5);
  // The middle of the hole is seen through up to arccos(r/R) = 66.42 degrees.
  const Mesh fine = torus(R, r, 400, 200);
  for (const double degrees : { 66.0, 66.8 })
  {
    const View view = torusView(degrees);
    Vector3 far = view.toScreen(Vector3::Zero());
    far[2] -= 50.0;
    const auto hidden =
      occludedOnHost<double>(fine, projectVertices(fine, view), { { far, { -1, -1, -1 } } });
    EXPECT_EQ(hidden[0], degrees > 66.42) << degrees;
  }
  fact("A3_2",
    "no cut at 20, 40, 47 degrees, cuts within " + std::to_string(worst) +
      " degrees of all four cusps at 56, 58, 60, outer contour never cut; hole seen through at 66.0, not at "
      "66.8");
}

TEST(A3_3, HiddenShareOfTheInnerContour)
{
  const double angles[] = { 30.0, 58.0, 64.0, 80.0 }, exact[] = { 0.0, 0.336, 0.493, 0.670 };
  const Mesh mesh = torus(R, r, 256, 128);
  std::string figures;
  for (const bool smoothed : { false, true })
  {
    figures += smoothed ? "; smoothed" : "raw";
    for (int k = 0; k < 4; ++k)
    {
      CurveChain chain(mesh, torusView(angles[k]));
      const Share share = hiddenShare(chain, smoothed);
      EXPECT_NEAR(share.inner, exact[k], 0.025) << angles[k] << smoothed;
      EXPECT_EQ(share.outer, 0.0) << angles[k];
      figures += " " + std::to_string(share.inner);
    }
  }
  // At 58 degrees visibility flips at these places.
  CurveChain chain(mesh, torusView(58.0));
  chain.visibility->Update();
  vtkPolyData* parts = chain.visibility->GetOutput();
  std::vector<double> flips;
  for (vtkIdType cell = 0; cell < parts->GetNumberOfLines(); ++cell)
  {
    if (cellValue(parts, "Visible", cell) &&
        cellValue(parts, "CurveId", cell) == innerCurve(chain.silhouette->GetOutput()))
    {
      const Line line = lineOf(parts, cell);
      for (vtkIdType id : { line.ids.front(), line.ids.back() })
      {
        const Vector3 p = pointAt(parts, id);
        const double u = std::atan2(p[1], p[0]) * 180.0 / pi;
        flips.push_back(u < 0.0 ? u + 360.0 : u);
      }
    }
  }
  std::sort(flips.begin(), flips.end());
  const double places[] = { 71.2, 129.4, 230.6, 288.8 };
  ASSERT_EQ(flips.size(), 4u);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(flips[k], places[k], 2.0);
  }
  fact("A3_3", "at 30, 58, 64, 80 degrees (exact 0, 0.336, 0.493, 0.670): " + figures);
}

TEST(A3_4, ImageLengthsWithoutCusps)
{
  const double c = std::cos(30.0 * pi / 180.0);
  double perimeter = 0.0; // of the ellipse R, R cos 30, by small steps
  for (int i = 0; i < 100000; ++i)
  {
    const double t = 2 * pi * (i + 0.5) / 100000;
    perimeter += std::hypot(R * std::sin(t), R * c * std::cos(t)) * 2 * pi / 100000;
  }
  EXPECT_NEAR(perimeter + 2 * pi * r, 8.383, 1e-3);
  CurveChain chain(torus(R, r, 256, 128), torusView(30.0));
  chain.visibility->SetInputConnection(chain.silhouette->GetOutputPort());
  chain.visibility->Update();
  vtkPolyData* parts = chain.visibility->GetOutput();
  ASSERT_EQ(parts->GetNumberOfLines(), 2);
  double lengths[2];
  const View view = torusView(30.0);
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    EXPECT_EQ(cellValue(parts, "Visible", cell), 1);
    const Line line = lineOf(parts, cell);
    ASSERT_TRUE(line.closed);
    lengths[cell] = 0.0;
    for (std::size_t k = 0; k < line.ids.size(); ++k)
    {
      lengths[cell] += (view.toScreen(pointAt(parts, line.ids[k])) -
                         view.toScreen(pointAt(parts, line.ids[(k + 1) % line.ids.size()])))
                         .head<2>()
                         .norm() /
                       200.0;
    }
  }
  const double longer = std::max(lengths[0], lengths[1]), shorter = std::min(lengths[0], lengths[1]);
  EXPECT_NEAR(longer, perimeter + 2 * pi * r, 0.01);
  EXPECT_NEAR(shorter, perimeter - 2 * pi * r, 0.01);
  fact("A3_4",
    "30 degrees: image lengths " + std::to_string(longer) + " and " + std::to_string(shorter) +
      " (8.383 and 3.357)");
}

// A small sphere in front of a large one: its contour cuts the one behind, is itself cut and joined again.
TEST(Visibility, ATJunctionCutsBothCurvesAndJoinsTheFrontOne)
{
  Mesh mesh = icosphere(4);
  Mesh front = icosphere(4, 0.5);
  for (Vector3& p : front.points)
  {
    p += Vector3(1.0, 0.0, 3.0);
  }
  for (Triangle t : front.triangles)
  {
    for (int& v : t)
    {
      v += mesh.vertexCount();
    }
    mesh.triangles.push_back(t);
  }
  mesh.points.insert(mesh.points.end(), front.points.begin(), front.points.end());
  for (const bool perspective : { false, true })
  {
    const View view =
      perspective ? perspectiveView(Vector3(0, 0, 9), axisY, 35.0) : orthographicView(axisZ, axisY, 150.0);
    CurveChain chain(mesh, view);
    chain.visibility->Update();
    vtkPolyData* parts = chain.visibility->GetOutput();
    ASSERT_EQ(parts->GetNumberOfLines(), 3) << perspective;
    int frontParts = 0, visibleBack = 0, hiddenBack = 0;
    Line ends[2];
    for (vtkIdType cell = 0; cell < 3; ++cell)
    {
      const Line line = lineOf(parts, cell);
      const bool visible = cellValue(parts, "Visible", cell) != 0;
      if (pointAt(parts, line.ids[0])[2] > 1.5)
      {
        ++frontParts;
        EXPECT_TRUE(visible && line.closed);
        // The joined curve keeps the inserted points, bound to three vertices with weights that give their
        // place.
        for (vtkIdType id : line.ids)
        {
          double w[3], v[3];
          parts->GetPointData()->GetArray("MeshWeights")->GetTuple(id, w);
          parts->GetPointData()->GetArray("MeshVertices")->GetTuple(id, v);
          Vector3 position = Vector3::Zero();
          for (int k = 0; k < 3; ++k)
          {
            position += w[k] * mesh.points[static_cast<std::size_t>(v[k])];
          }
          EXPECT_LT((position - pointAt(parts, id)).norm(), 1e-12);
          EXPECT_NEAR(w[0] + w[1] + w[2], 1.0, 1e-12);
        }
        const Line before = lineOf(chain.snake->GetOutput(), cellValue(parts, "CurveId", cell));
        EXPECT_EQ(line.ids.size(), before.ids.size() + 2);
        continue;
      }
      EXPECT_FALSE(line.closed);
      (visible ? visibleBack : hiddenBack) += 1;
      ends[visible ? 0 : 1] = line;
    }
    EXPECT_EQ(frontParts, 1);
    EXPECT_EQ(visibleBack, 1);
    EXPECT_EQ(hiddenBack, 1);
    // The two parts of the back curve meet in the crossings.
    EXPECT_EQ(pointAt(parts, ends[0].ids.back()), pointAt(parts, ends[1].ids.front()));
    EXPECT_EQ(pointAt(parts, ends[0].ids.front()), pointAt(parts, ends[1].ids.back()));
    chain.visibility->RejoinOff();
    chain.visibility->Update();
    EXPECT_EQ(chain.visibility->GetOutput()->GetNumberOfLines(), 4);
  }
}

TEST(Visibility, WhatLiesBehindTheEyeIsHiddenAndHidesNothing)
{
  Mesh mesh = icosphere(3);
  const Mesh behind = cylinder(0.5, 12.0, 24, 40); // passes the eye on its way
  for (Triangle t : behind.triangles)
  {
    for (int& v : t)
    {
      v += mesh.vertexCount();
    }
    mesh.triangles.push_back(t);
  }
  for (const Vector3& p : behind.points)
  {
    mesh.points.push_back(p + Vector3(3.0, 0.0, 0.0));
  }
  const View view = perspectiveView(Vector3(0, 0, 6), axisY, 45.0);
  CurveChain chain(mesh, view);
  chain.visibility->Update();
  vtkPolyData* parts = chain.visibility->GetOutput();
  int onSphere = 0;
  for (vtkIdType cell = 0; cell < parts->GetNumberOfLines(); ++cell)
  {
    const Line line = lineOf(parts, cell);
    const bool visible = cellValue(parts, "Visible", cell) != 0;
    for (vtkIdType id : line.ids)
    {
      EXPECT_TRUE(!visible || view.inFront(pointAt(parts, id)));
    }
    if (pointAt(parts, line.ids[0]).norm() < 1.1)
    {
      ++onSphere;
      EXPECT_TRUE(visible && line.closed);
    }
  }
  EXPECT_EQ(onSphere, 1);
  EXPECT_GT(hiddenParts(parts), 0);
}

TEST(Visibility, TheDeviceDecidesLikeTheHost)
{
  const std::shared_ptr<Device> device = Device::instance();
  if (!device)
  {
    GTEST_SKIP() << "no OpenCL device on this machine";
  }
  // Points all over the picture, at all depths.
  const Mesh mesh = torus(R, r, 200, 100);
  int tested = 0, hiddenCount = 0;
  for (const View& view : { torusView(58.0), perspectiveView(Vector3(0.5, 1.0, 1.6), axisZ, 70.0) })
  {
    const auto screen = projectVertices(mesh, view);
    std::vector<OcclusionQuery> queries;
    for (int v = 0; v < mesh.vertexCount(); v += 7)
    {
      if (std::isfinite(screen[v][2]))
      {
        queries.push_back({ screen[v], { v, v, v } });
      }
    }
    const auto host = occludedOnHost<double>(mesh, screen, queries);
    const auto hostFloat = occludedOnHost<float>(mesh, screen, queries);
    EXPECT_EQ(occludedOnDevice<float>(*device, mesh, screen, queries), hostFloat);
    if (device->info().fp64)
    {
      EXPECT_EQ(occludedOnDevice<double>(*device, mesh, screen, queries), host);
    }
    int differ = 0;
    for (std::size_t i = 0; i < host.size(); ++i)
    {
      differ += host[i] != hostFloat[i];
      hiddenCount += host[i];
    }
    EXPECT_LE(differ, static_cast<int>(host.size()) / 100);
    tested += static_cast<int>(host.size());
  }
  EXPECT_GT(hiddenCount, tested / 4);
  EXPECT_LT(hiddenCount, 3 * tested / 4);
}

TEST(Visibility, GridAndBruteForceAgree)
{
  const Mesh mesh = torus(R, r, 40, 20);
  const View view = torusView(70.0);
  const auto screen = projectVertices(mesh, view);
  std::vector<OcclusionQuery> queries;
  for (int t = 0; t < mesh.triangleCount(); t += 3)
  {
    const Triangle& c = mesh.triangles[t];
    const Vector3 p = 0.2 * screen[c[0]] + 0.3 * screen[c[1]] + 0.5 * screen[c[2]];
    queries.push_back({ p, { c[0], c[1], c[2] } });
  }
  const auto hidden = occludedOnHost<double>(mesh, screen, queries);
  int count = 0;
  for (std::size_t q = 0; q < queries.size(); ++q)
  {
    // As published, w0, w1, w2 by division.
    const auto cross = [](const Vector3& a, const Vector3& b) { return a[0] * b[1] - a[1] * b[0]; };
    bool expected = false;
    for (const Triangle& c : mesh.triangles)
    {
      const Vector3 &p = queries[q].screen, &a = screen[c[0]], &b = screen[c[1]], &d = screen[c[2]];
      const double A = cross(b - a, d - a), w0 = cross(b - p, d - p) / A, w1 = cross(d - p, a - p) / A,
                   w2 = 1 - w0 - w1;
      const bool touches = std::any_of(c.begin(),
        c.end(),
        [&](int v) { return std::count(queries[q].vertices.begin(), queries[q].vertices.end(), v) > 0; });
      expected =
        expected || (!touches && w0 >= 0 && w1 >= 0 && w2 >= 0 && w0 * a[2] + w1 * b[2] + w2 * d[2] > p[2]);
    }
    EXPECT_EQ(hidden[q] != 0, expected) << q;
    count += expected;
  }
  EXPECT_GT(count, 100);
}

TEST(Visibility, TheFilterGivesTheSameOnDeviceAndHostAndForAnyThreads)
{
  const Mesh mesh = torus(R, r, 128, 64);
  vtkSMPTools::Initialize(1);
  CurveChain one(mesh, torusView(58.0));
  one.visibility->Update();
  EXPECT_EQ(one.visibility->GetBackendUsed(), vtkOversketchVisibility::Host);
  vtkSMPTools::Initialize(2);
  CurveChain two(mesh, torusView(58.0));
  two.visibility->Update();
  expectSame(one.visibility->GetOutput(), two.visibility->GetOutput());
  if (Device::instance() && Device::instance()->info().fp64)
  {
    two.visibility->SetBackendToOpenCL();
    two.visibility->Update();
    EXPECT_EQ(two.visibility->GetBackendUsed(), vtkOversketchVisibility::OpenCL);
    expectSame(one.visibility->GetOutput(), two.visibility->GetOutput());
  }
  // Without a device the host stands in and says so.
  setenv("OVERSKETCH_OPENCL", "off", 1);
  CurveChain three(mesh, torusView(58.0));
  three.visibility->SetBackendToOpenCL();
  Ear ear(three.visibility);
  three.visibility->Update();
  unsetenv("OVERSKETCH_OPENCL");
  EXPECT_EQ(ear.warnings.size(), 1u);
  EXPECT_EQ(three.visibility->GetBackendUsed(), vtkOversketchVisibility::Host);
  expectSame(one.visibility->GetOutput(), three.visibility->GetOutput());
}

TEST(Visibility, RunsOnlyWhatChanged)
{
  CurveChain chain(torus(R, r, 64, 32), torusView(58.0));
  chain.visibility->Update();
  vtkPoints* points = chain.visibility->GetOutput()->GetPoints();
  const auto other = toStroke({ { 1, 2 }, { 3, 4 }, { 5, 6 } }, torusView(58.0));
  chain.silhouette->SetStrokeData(other);
  chain.snake->SetStrokeData(other);
  chain.visibility->SetStrokeData(other);
  chain.visibility->Update();
  EXPECT_EQ(chain.visibility->GetTestCount(), 1);
  EXPECT_EQ(chain.visibility->GetOutput()->GetPoints(), points);
  chain.visibility->RejoinOff();
  chain.visibility->Update();
  EXPECT_EQ(chain.silhouette->GetExtractionCount(), 1);
  EXPECT_EQ(chain.snake->GetSmoothingCount(), 1);
  EXPECT_EQ(chain.visibility->GetTestCount(), 2);
  const auto moved = toStroke({ { 1, 2 }, { 3, 4 } }, torusView(59.0));
  chain.silhouette->SetStrokeData(moved);
  chain.snake->SetStrokeData(moved);
  chain.visibility->SetStrokeData(moved);
  chain.visibility->Update();
  EXPECT_EQ(chain.silhouette->GetExtractionCount(), 2);
  EXPECT_EQ(chain.snake->GetSmoothingCount(), 2);
  EXPECT_EQ(chain.visibility->GetTestCount(), 3);
}

TEST(Visibility, CancelsAndRecovers)
{
  CurveChain chain(torus(R, r, 64, 32), torusView(58.0)), other(torus(R, r, 64, 32), torusView(58.0));
  chain.snake->Update();
  expectCancelAndRetry(chain.visibility, other.visibility);
}

TEST(Visibility, RefusesWhatItCannotRead)
{
  CurveChain chain(icosphere(2), torusView(30.0));
  chain.snake->Update();
  const auto with = expectRefusalOf<vtkOversketchVisibility>;
  const auto fresh = [&] { return copyOf(chain.snake->GetOutput()); };
  auto curves = fresh();
  curves->GetPointData()->RemoveArray("MeshVertices");
  with(curves, chain.mesh, chain.stroke, Failure::MissingArray, "MeshVertices");
  curves = fresh();
  curves->GetPointData()->GetArray("MeshVertices")->SetComponent(5, 1, -1);
  with(curves, chain.mesh, chain.stroke, Failure::BadMesh, "Point 5");
  with(fresh(), toPolyData(icosphere(0)), chain.stroke, Failure::BadMesh, "does not have");
  auto nan = toPolyData(icosphere(2));
  nan->GetPoints()->SetPoint(4, 0, 0, std::nan(""));
  with(fresh(), nan, chain.stroke, Failure::BadMesh, "Point 4");
  const auto viewless = copyOf(chain.stroke);
  viewless->GetCellData()->RemoveArray("ViewportSize");
  with(fresh(), chain.mesh, viewless, Failure::MissingArray, "ViewportSize");
  expectNothingOfNoCurves<vtkOversketchVisibility>(chain.mesh, chain.stroke);
}
