// A coarse base and the way back to the surface that it was made of.
#include "StellarChain.h"

#include "vtkTypeUInt64Array.h"

#include <gtest/gtest.h>

#include <functional>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Base to smoothing with the source at each step that takes it.
struct Sourced : Chain
{
  explicit Sourced(vtkPolyData* mesh)
    : Chain(mesh)
  {
    base->SetModeToSimplified();
    refine->SetSourceConnection(base->GetOutputPort(1));
    snap->SetSourceConnection(base->GetOutputPort(1));
    smooth->SetSourceConnection(base->GetOutputPort(1));
  }
};

} // namespace

TEST(D5_1, TheFilterKeepsWhatEveryWeldKeeps)
{
  vtkNew<vtkOversketchStellarBase> base;
  const auto mesh = sphere(4);
  base->SetInputData(mesh);
  base->SetModeToSimplified();
  base->SetSourceTolerance(1.0); // nothing is refined again
  base->Update();
  ASSERT_EQ(base->GetErrorCode(), 0u);
  vtkPolyData* made = base->GetOutput();
  // V - 1, E - 3, F - 2 of a closed surface: V and F hang together, and a pair or third says how many there
  // were before they were paired.
  const vtkIdType faces = 2 * base->GetPairs() + base->GetUnpaired();
  EXPECT_EQ(made->GetNumberOfCells(), 2 * base->GetPairs() + 3 * base->GetUnpaired());
  EXPECT_EQ(2 * (made->GetNumberOfPoints() - base->GetUnpaired() - 2), faces);
  EXPECT_LE(faces, mesh->GetNumberOfCells() / 4 + 1);
  EXPECT_GT(faces, mesh->GetNumberOfCells() / 5);
  fact("D5_1",
    "filter: " + std::to_string(mesh->GetNumberOfCells()) + " faces become " + std::to_string(faces) +
      ", V - F / 2 = 2 as before");
  base->SetTargetFaces(1000);
  base->Update();
  EXPECT_NEAR(2 * base->GetPairs() + base->GetUnpaired(), 1000, 1);
  base->SetMaximumError(1e-4);
  base->SetTargetFaces(0);
  base->Update();
  EXPECT_GT(2 * base->GetPairs() + base->GetUnpaired(), mesh->GetNumberOfCells() / 4 + 1);
}

TEST(D6_2, TheStepsPutNewPointsOnTheMeshThatCameIn)
{
  const auto mesh = sphere(4);
  Surface original(mesh);
  Sourced chain(mesh);
  chain.refine->SetTargetEdgeLength(0.02);
  chain.smooth->Update();
  ASSERT_EQ(chain.smooth->GetErrorCode(), 0u);
  vtkPolyData* coarse = chain.base->GetOutput();
  EXPECT_LT(coarse->GetNumberOfCells(), mesh->GetNumberOfCells());
  vtkPolyData* refined = chain.refine->GetOutput();
  double on = 0.0;
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
    on = std::max(on, original.distance(refined->GetPoint(i)));
  EXPECT_LT(on, 1e-9);
  // What is smoothed and not on the curve is back on it too, and the arrays are those of its edge.
  vtkPolyData* smooth = chain.smooth->GetOutput();
  vtkDataArray *moved = smooth->GetPointData()->GetArray("StellarMoved"),
               *curve = smooth->GetPointData()->GetArray("CurveId"),
               *height = smooth->GetPointData()->GetArray("Z");
  vtkIdType slid = 0;
  double back = 0.0, arrays = 0.0;
  for (vtkIdType i = 0; i < smooth->GetNumberOfPoints(); ++i)
  {
    const Vector3 p(smooth->GetPoint(i));
    if (curve->GetComponent(i, 0) < 0.0)
      arrays = std::max(arrays, std::abs(height->GetComponent(i, 0) - p.z()));
    if (moved->GetComponent(i, 0) != 0.0 && curve->GetComponent(i, 0) < 0.0)
    {
      back = std::max(back, original.distance(p.data()));
      ++slid;
    }
  }
  EXPECT_GT(slid, 20);
  EXPECT_LT(back, 1e-9);
  EXPECT_LT(arrays, 4e-3);
  // Without it, the middles of chords.
  Chain plain(mesh);
  plain.base->SetModeToSimplified();
  plain.refine->SetTargetEdgeLength(0.02);
  plain.refine->Update();
  double off = 0.0;
  for (vtkIdType i = 0; i < plain.refine->GetOutput()->GetNumberOfPoints(); ++i)
    off = std::max(off, original.distance(plain.refine->GetOutput()->GetPoint(i)));
  EXPECT_GT(off, 1e-4);
  fact("D6_2",
    "filters, sphere of " + std::to_string(mesh->GetNumberOfCells()) + " as " +
      std::to_string(coarse->GetNumberOfCells()) + " faces: refined points within " +
      std::to_string(on * 1e15) + "e-15 of it, smoothed ones within " + std::to_string(back * 1e15) +
      "e-15, without the source " + std::to_string(off));
}

TEST(StellarSource, TheBaseIsWithinItsToleranceOfTheMesh)
{
  const auto mesh = sphere(4);
  vtkNew<vtkOversketchStellarBase> base;
  base->SetInputData(mesh);
  base->SetModeToSimplified();
  vtkIdType last = 0;
  for (const double tolerance : { 2e-2, 4e-3 })
  {
    base->SetSourceTolerance(tolerance);
    base->Update();
    EXPECT_GT(base->GetOutput()->GetNumberOfCells(), last);
    last = base->GetOutput()->GetNumberOfCells();
    Surface made(base->GetOutput());
    double worst = 0.0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      worst = std::max(worst, made.distance(mesh->GetPoint(i)));
    EXPECT_LT(worst, 2.0 * tolerance);
  }
  base->SetSourceTolerance(0.0);
  expectRefusal(base, Failure::BadMesh, "olerance");
  base->SetSourceTolerance(std::nan(""));
  expectRefusal(base, Failure::BadStroke, "SourceTolerance");
  base->SetSourceTolerance(-1.0);
  base->SetMaximumError(HUGE_VAL);
  expectRefusal(base, Failure::BadStroke, "MaximumError");
}

TEST(StellarSource, ThroughFilesTheSameToTheBit)
{
  Sourced chain(sphere(3));
  chain.simplify->Update();
  ASSERT_EQ(chain.simplify->GetErrorCode(), 0u);
  const auto source = saved(chain.base->GetSourceOutput());
  auto mesh = saved(chain.base->GetOutput());
  const auto curves = saved(chain.curves->GetOutput());
  for (vtkPolyDataAlgorithm* step : chain.steps())
  {
    SCOPED_TRACE(step->GetClassName());
    vtkPolyData* expected = step->GetOutput();
    step->SetInputData(0, mesh);
    step->SetInputData(1, curves);
    if (step == chain.refine || step == chain.snap || step == chain.smooth)
      step->SetInputData(2, source);
    const auto before = cold(expected);
    step->Update();
    ASSERT_EQ(step->GetErrorCode(), 0u);
    expectSameMesh(step->GetOutput(), before);
    mesh = saved(step->GetOutput());
  }
}

TEST(StellarSource, ADirectBaseAndA48MeshHaveNone)
{
  Chain chain(sphere(2));
  chain.refine->SetSourceConnection(chain.base->GetOutputPort(1));
  chain.refine->Update();
  EXPECT_EQ(chain.refine->GetErrorCode(), 0u);
  EXPECT_EQ(chain.base->GetSourceOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkOversketchStellarBase> again;
  again->SetInputConnection(chain.refine->GetOutputPort());
  again->SetModeToSimplified();
  again->Update();
  EXPECT_EQ(again->GetOutput()->GetPoints(), chain.refine->GetOutput()->GetPoints());
  EXPECT_EQ(again->GetSourceOutput()->GetNumberOfPoints(), 0);
}

TEST(StellarSource, ChangedRecordsAreRefusedByName)
{
  Sourced chain(sphere(3));
  chain.smooth->Update();
  const auto field = [](vtkPolyData* s, const char* name) { return s->GetFieldData()->GetArray(name); };
  const auto refused =
    [&](const std::function<void(vtkPolyData*)>& spoil, Failure failure, const std::string& words)
  {
    const auto spoilt = cold(chain.base->GetSourceOutput());
    spoil(spoilt);
    vtkNew<vtkOversketchStellarRefine> refine;
    vtkNew<vtkOversketchStellarSnap> snap;
    vtkNew<vtkOversketchStellarSmooth> smooth;
    for (vtkPolyDataAlgorithm* step : { static_cast<vtkPolyDataAlgorithm*>(refine),
           static_cast<vtkPolyDataAlgorithm*>(snap),
           static_cast<vtkPolyDataAlgorithm*>(smooth) })
    {
      SCOPED_TRACE(step->GetClassName());
      step->SetInputConnection(0, chain.base->GetOutputPort());
      step->SetInputConnection(1, chain.curves->GetOutputPort());
      step->SetInputData(2, spoilt);
      expectRefusal(step, failure, words);
    }
  };
  for (const char* name : { "SourceFaces",
         "SourceRecords",
         "SourceOldFaces",
         "SourceFlatPoints",
         "SourceFlat",
         "SourceRoots",
         "SourceDigest" })
    refused([&](auto* s) { s->GetFieldData()->RemoveArray(name); }, Failure::MissingArray, name);
  for (const char* name : { "SourceFaces", "SourceOldFaces", "SourceFlatPoints", "SourceRoots" })
  {
    refused([&](auto* s) { field(s, name)->SetComponent(7, 0, -3.0); }, Failure::BadMesh, name);
    refused([&](auto* s) { field(s, name)->SetComponent(7, 0, 1e9); }, Failure::BadMesh, name);
  }
  refused([&](auto* s) { field(s, "SourceRecords")->SetComponent(2, 1, 1e9); },
    Failure::BadMesh,
    "SourceRecords of record 2");
  refused([&](auto* s) { field(s, "SourceFlat")->SetComponent(9, 1, std::nan("")); },
    Failure::BadMesh,
    "SourceFlat");
  refused(
    [&](auto* s) { field(s, "SourceFlat")->SetComponent(9, 1, 0.37); }, Failure::BadMesh, "SourceDigest");
  refused([&](auto* s) { field(s, "SourceRoots")->SetComponent(0, 1, 2.0); }, Failure::BadMesh, "Source");
  refused([&](auto* s)
    { field(s, "SourceFaces")->SetNumberOfTuples(field(s, "SourceFaces")->GetNumberOfTuples() - 2); },
    Failure::BadMesh,
    "SourceFaces");
  refused(
    [&](auto* s)
    {
      vtkNew<vtkIdList> corners;
      s->GetPolys()->GetCellAtId(0, corners);
      corners->SetId(0, corners->GetId(1));
      s->GetPolys()->ReplaceCellAtId(0, corners);
    },
    Failure::BadMesh,
    "Source");
  // A source that has nothing to do with the mesh, and no source at all.
  refused(
    [](auto* s)
    {
      for (vtkIdType i = 0; i < s->GetNumberOfPoints(); ++i)
      {
        const Vector3 p(s->GetPoint(i));
        s->GetPoints()->SetPoint(i, p[0] + 1.0, p[1], p[2]);
      }
    },
    Failure::BadMesh,
    "of another mesh");
  refused([](auto* s) { s->ShallowCopy(toPolyData(icosphere(1))); }, Failure::MissingArray, "Source");
  Sourced other(sphere(2));
  other.base->Update();
  refused([&](auto* s) { s->DeepCopy(other.base->GetSourceOutput()); }, Failure::BadMesh, "ource");
}
