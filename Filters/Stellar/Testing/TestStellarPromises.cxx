#include "Harness/spoilt.h"
#include "StellarChain.h"

#include "vtkTypeUInt64Array.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A snapped mesh, its curves, and each of the steps that read both.
struct Snapped
{
  Snapped()
    : chain(sphere(2))
  {
    chain.smooth->Update();
    mesh = chain.snap->GetOutput();
    curves = chain.curves->GetOutput();
  }

  // All steps refuse what `spoil` makes of a copy of the mesh.
  void expectRefused(const std::function<void(vtkPolyData*)>& spoil,
    Failure failure,
    const std::string& words)
  {
    for (vtkPolyDataAlgorithm* step : chain.steps())
    {
      const auto spoilt = cold(mesh);
      spoil(spoilt);
      auto again = vtkSmartPointer<vtkPolyDataAlgorithm>::Take(step->NewInstance());
      again->SetInputData(0, spoilt);
      if (step != chain.simplify)
        again->SetInputData(1, curves);
      SCOPED_TRACE(step->GetClassName());
      expectRefusal(again, failure, words);
    }
  }

  Chain chain;
  vtkPolyData *mesh, *curves;
};

vtkIdType firstSnapped(vtkPolyData* mesh)
{
  vtkDataArray* ids = mesh->GetPointData()->GetArray("CurveId");
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    if (ids->GetComponent(i, 0) >= 0.0)
      return i;
  return -1;
}

} // namespace

TEST(StellarPromises, SpoiltMeshesAreRefusedByName)
{
  Snapped s;
  for (const Spoilt& way : spoiltWays())
  {
    if (!*way.needs || s.mesh->GetPointData()->GetArray(way.needs))
    {
      SCOPED_TRACE(way.words);
      s.expectRefused(way.spoil, way.failure, way.words);
    }
  }
  s.expectRefused(
    [](auto* m) { m->GetPoints()->SetPoint(3, 0.0, std::nan(""), 0.0); }, Failure::BadMesh, "Point 3");
  s.expectRefused(splitFirstCell, Failure::BadMesh, "split");
}

TEST(StellarPromises, OtherCurvesAreRefused)
{
  Snapped s;
  for (vtkPolyDataAlgorithm* step : s.chain.steps())
  {
    if (step == s.chain.simplify)
      continue;
    SCOPED_TRACE(step->GetClassName());
    const auto with = [&](vtkPolyData* mesh, vtkPolyData* curves)
    {
      auto again = vtkSmartPointer<vtkPolyDataAlgorithm>::Take(step->NewInstance());
      again->SetInputData(0, mesh);
      again->SetInputData(1, curves);
      return again;
    };
    const auto moved = cold(s.curves);
    moved->GetPoints()->SetPoint(3, 0.1, 0.2, 1.0);
    expectRefusal(with(s.mesh, moved), Failure::BadStroke, "CurveDigest");
    const auto digest = cold(s.mesh);
    auto* array = vtkTypeUInt64Array::SafeDownCast(digest->GetFieldData()->GetArray("CurveDigest"));
    ASSERT_TRUE(array);
    array->SetValue(0, array->GetValue(0) ^ 1u);
    expectRefusal(with(digest, s.curves), Failure::BadStroke, "CurveDigest");
    const auto without = cold(s.mesh);
    without->GetFieldData()->RemoveArray("CurveDigest");
    expectRefusal(with(without, s.curves), Failure::MissingArray, "CurveDigest");
    const auto parameter = cold(s.mesh);
    auto* parameters = parameter->GetPointData()->GetArray("CurveParam");
    const vtkIdType snapped = firstSnapped(parameter);
    ASSERT_GE(snapped, 0);
    const double at = parameters->GetComponent(snapped, 0);
    parameters->SetComponent(snapped, 0, at < 0.6 ? at + 0.6 : at - 0.6);
    expectRefusal(with(parameter, s.curves), Failure::BadStroke, "is snapped to curve 0 at arc length");
    const auto reordered = cold(s.curves);
    reordered->GetCellData()->GetArray("CurveId")->SetComponent(0, 0, 1.0);
    expectRefusal(with(s.mesh, reordered), Failure::BadStroke, "CurveId of curve 0");
    const auto notFinite = cold(s.curves);
    notFinite->GetPoints()->SetPoint(3, std::nan(""), 0.0, 0.0);
    expectRefusal(with(s.mesh, notFinite), Failure::BadStroke, "finite");
    expectRefusal(with(s.mesh, toPolyData(icosphere(0))), Failure::BadStroke, "polylines");
    const auto noRadius = cold(s.curves);
    vtkNew<vtkDoubleArray> radius;
    radius->SetName("Radius");
    radius->SetNumberOfValues(noRadius->GetNumberOfCells());
    radius->Fill(0.0);
    noRadius->GetCellData()->AddArray(radius);
    expectRefusal(with(s.mesh, noRadius), Failure::BadStroke, "Radius");
  }
}

TEST(StellarPromises, ParametersOutOfRangeAreRefused)
{
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  Snapped s;
  const auto same = [&](auto&& filter)
  {
    filter->SetInputData(0, s.mesh);
    filter->SetInputData(1, s.curves);
  };
  for (const double bad : { nan, infinite, 0.0 })
  {
    vtkNew<vtkOversketchStellarRefine> refine;
    same(refine);
    refine->SetRadius(bad);
    expectRefusal(refine, Failure::BadStroke, "adius");
    vtkNew<vtkOversketchStellarDisplace> displace;
    same(displace);
    displace->SetRadius(bad);
    expectRefusal(displace, Failure::BadStroke, "adius");
  }
  for (const double bad : { nan, infinite })
  {
    vtkNew<vtkOversketchStellarDisplace> displace;
    same(displace);
    displace->SetHeight(bad);
    expectRefusal(displace, Failure::BadStroke, "Height");
    vtkNew<vtkOversketchStellarSimplify> simplify;
    simplify->SetInputData(0, s.mesh);
    simplify->SetTolerance(bad);
    expectRefusal(simplify, Failure::BadStroke, "olerance");
  }
  for (const char* bad : { "0 1", "1 0, 0 1", "0 1, 0.5 nan, 1 0", "x", "0 1 1 0" })
  {
    vtkNew<vtkOversketchStellarDisplace> displace;
    same(displace);
    displace->SetProfile(bad);
    expectRefusal(displace, Failure::BadStroke, "rofile");
  }
  vtkNew<vtkOversketchStellarDisplace> displace;
  same(displace);
  displace->SetSharpness(-1.0);
  expectRefusal(displace, Failure::BadStroke, "harpness");
  // The limit of faces speaks before memory goes.
  vtkNew<vtkOversketchStellarRefine> refine;
  same(refine);
  refine->SetRadius(0.2);
  refine->SetTargetEdgeLength(1e-12);
  refine->SetMaximumGeneration(62);
  refine->SetMaximumFaces(20000);
  expectRefusal(refine, Failure::BadRegion, "20000");
}

TEST(StellarPromises, BaseRefusesWhatIsNoManifoldAndMendsWhatIsNo48Mesh)
{
  Mesh fan = icosphere(1);
  fan.triangles.push_back({ fan.triangles[0][0], fan.triangles[0][1], 30 });
  vtkNew<vtkOversketchStellarBase> base;
  base->SetInputData(toPolyData(fan));
  expectRefusal(base, Failure::BadMesh, "edge");
  Mesh turned = icosphere(1);
  std::swap(turned.triangles[4][0], turned.triangles[4][1]);
  base->SetInputData(toPolyData(turned));
  expectRefusal(base, Failure::BadMesh, "edge");

  // A 4-8 mesh goes through, the very arrays; one that was spoilt becomes a base, and one is told.
  Snapped s;
  base->SetInputData(cold(s.mesh));
  const vtkIdType made = base->GetBaseCount();
  {
    Ear ear(base);
    base->Update();
    EXPECT_TRUE(ear.errors.empty() && ear.warnings.empty());
  }
  EXPECT_EQ(base->GetBaseCount(), made);
  expectSameMesh(base->GetOutput(), s.mesh);
  const auto spoilt = cold(s.mesh);
  spoilt->GetCellData()->GetArray("StellarGen")->SetComponent(3, 0, 40.0);
  base->SetInputData(spoilt);
  {
    Ear ear(base);
    base->Update();
    ASSERT_EQ(ear.warnings.size(), 1u);
    EXPECT_NE(ear.warnings[0].find("StellarGen of cell 3"), std::string::npos) << ear.warnings[0];
  }
  EXPECT_EQ(base->GetBaseCount(), made + 1);
  EXPECT_FALSE(base->GetOutput()->GetFieldData()->GetArray("CurveDigest"));
  vtkNew<vtkOversketchStellarRefine> refine;
  refine->SetInputConnection(0, base->GetOutputPort());
  refine->SetInputData(1, s.curves);
  refine->Update();
  EXPECT_EQ(refine->GetErrorCode(), 0u);
}

TEST(StellarPromises, BasesAreExact)
{
  const Mesh octahedron{
    { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } }
  };
  vtkNew<vtkOversketchStellarBase> base;
  base->SetInputData(toPolyData(octahedron));
  base->Update();
  EXPECT_EQ(base->GetOutput()->GetNumberOfCells(), 2 * base->GetPairs() + 3 * base->GetUnpaired());
  EXPECT_EQ(base->GetUnpaired(), 0);
  // A triangle alone: three cells round its barycentre, with the mean of what its corners have.
  auto one = toPolyData({ { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 3, 0 } }, { { 0, 1, 2 } } });
  vtkNew<vtkFloatArray> values;
  values->SetName("V");
  for (const float v : { 1.0f, 2.0f, 6.0f })
    values->InsertNextValue(v);
  one->GetPointData()->AddArray(values);
  base->SetInputData(one);
  base->Update();
  ASSERT_EQ(base->GetOutput()->GetNumberOfCells(), 3);
  EXPECT_EQ(Vector3(base->GetOutput()->GetPoint(3)), Vector3(1, 1, 0));
  EXPECT_FLOAT_EQ(
    static_cast<float>(base->GetOutput()->GetPointData()->GetArray("V")->GetComponent(3, 0)), 3.0f);
}

TEST(StellarPromises, CancelledRunsLeaveNothingAndRunAgain)
{
  Chain chain(sphere());
  chain.simplify->Update();
  const auto whole = cold(chain.simplify->GetOutput());
  Chain second(sphere());
  for (vtkPolyDataAlgorithm* step : second.steps())
  {
    SCOPED_TRACE(step->GetClassName());
    expectCancel(step);
    step->Update();
    EXPECT_GT(step->GetOutput()->GetNumberOfCells(), 0);
  }
  expectSameMesh(second.simplify->GetOutput(), whole);
  vtkNew<vtkOversketchStellarBase> base;
  base->SetInputData(sphere());
  expectCancel(base);
}

TEST(StellarPromises, EmptyMeshesAndNoCurvesAreNoErrors)
{
  Snapped s;
  vtkNew<vtkPolyData> nothing;
  for (vtkPolyDataAlgorithm* step : s.chain.steps())
  {
    SCOPED_TRACE(step->GetClassName());
    auto again = vtkSmartPointer<vtkPolyDataAlgorithm>::Take(step->NewInstance());
    Ear ear(again);
    again->SetInputData(0, nothing);
    again->SetInputData(1, s.curves);
    again->Update();
    EXPECT_EQ(again->GetOutput()->GetNumberOfPoints(), 0);
    again->SetInputData(0, s.mesh);
    again->SetInputData(1, nothing);
    again->Update();
    EXPECT_GT(again->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_TRUE(ear.errors.empty());
    std::ostringstream text;
    again->PrintSelf(text, vtkIndent());
    EXPECT_NE(text.str().find("Count: "), std::string::npos);
  }
}

TEST(StellarPromises, FacesAreTheSameTinyHugeAndFarAway)
{
  vtkIdType cells = 0;
  for (const double scale : { 1.0, 1.0 / 1024.0, 1048576.0 })
  {
    Mesh mesh = icosphere(2);
    Snapped home;
    for (Vector3& p : mesh.points)
      p *= scale;
    const auto curves = cold(home.curves);
    for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = scale * Vector3(curves->GetPoint(i));
      curves->GetPoints()->SetPoint(i, p.data());
    }
    Chain chain(toPolyData(mesh));
    for (vtkPolyDataAlgorithm* step : chain.steps())
      step->SetInputData(1, curves);
    chain.refine->SetRadius(0.15 * scale);
    chain.displace->SetRadius(0.15 * scale);
    chain.displace->SetHeight(0.1 * scale);
    chain.simplify->SetRadius(0.15 * scale);
    chain.simplify->Update();
    ASSERT_EQ(chain.simplify->GetErrorCode(), 0u);
    const vtkIdType count = chain.simplify->GetOutput()->GetNumberOfCells();
    EXPECT_EQ(cells == 0 ? count : cells, count) << scale;
    cells = count;
  }
}
