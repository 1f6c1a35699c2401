#include "StellarChain.h"

#include "vtkIdTypeArray.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

TEST(D1_1, FilesBetweenStepsAndTheChainInMemoryAgreeToTheBit)
{
  Chain chain(sphere());
  chain.simplify->Update();
  ASSERT_EQ(chain.simplify->GetErrorCode(), 0u);
  int compared = 0;
  for (const bool file : { false, true })
  {
    for (vtkPolyDataAlgorithm* step : chain.steps())
    {
      auto* before = vtkPolyData::SafeDownCast(step->GetInputDataObject(0, 0));
      auto again = vtkSmartPointer<vtkPolyDataAlgorithm>::Take(step->NewInstance());
      if (auto* refine = vtkOversketchStellarRefine::SafeDownCast(again))
        refine->SetRadius(0.15);
      if (auto* displace = vtkOversketchStellarDisplace::SafeDownCast(again))
      {
        displace->SetRadius(0.15);
        displace->SetHeight(0.1);
      }
      if (auto* simplify = vtkOversketchStellarSimplify::SafeDownCast(again))
        simplify->SetRadius(0.15);
      again->SetInputData(0, file ? saved(before) : cold(before));
      again->SetInputData(1, file ? saved(chain.curves->GetOutput()) : cold(chain.curves->GetOutput()));
      again->Update();
      SCOPED_TRACE(step->GetClassName());
      expectSameMesh(step->GetOutput(), again->GetOutput());
      ++compared;
    }
  }
  fact("D1_1",
    "base, refine, snap, smooth, displace, simplify on " +
      std::to_string(chain.simplify->GetOutput()->GetNumberOfCells()) + " faces: " +
      std::to_string(compared) + " steps, each on a copy and on a saved file, the same to the bit");
}

TEST(D1_2, AnotherHeightRunsTheDisplacementAlone)
{
  Chain chain(sphere());
  chain.displace->Update();
  const auto counts = [&]
  {
    return std::vector<vtkIdType>{ chain.base->GetBaseCount(),
      chain.curves->GetProjectionCount(),
      chain.refine->GetRefineCount(),
      chain.snap->GetSnapCount(),
      chain.smooth->GetSmoothCount(),
      chain.displace->GetDistanceCount(),
      chain.displace->GetDisplaceCount() };
  };
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 1, 1, 1, 1, 1, 1 }));
  chain.displace->SetHeight(0.07);
  chain.displace->Update();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 1, 1, 1, 1, 1, 2 }));
  // The same as if it had been so from the beginning.
  Chain other(sphere());
  other.displace->SetHeight(0.07);
  other.displace->Update();
  expectSameMesh(chain.displace->GetOutput(), other.displace->GetOutput());
  chain.displace->SetSharpness(1.0);
  chain.displace->Update();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 1, 1, 1, 1, 1, 3 }));
  chain.refine->SetRadius(0.2);
  chain.displace->Update();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 1, 2, 2, 2, 2, 4 }));
  fact("D1_2", "another height: 1 displacement, nothing else; another radius: from the refinement on");
}

TEST(D1_3, ThreeStrokesChainedEqualThreeSaved)
{
  const std::vector<std::vector<Vector2>> strokes{
    wave(), line({ 400, 200 }, { 400, 400 }), line({ 330, 240 }, { 470, 370 })
  };
  std::vector<std::unique_ptr<Chain>> chained;
  vtkSmartPointer<vtkPolyData> baked = sphere();
  for (const auto& stroke : strokes)
  {
    chained.push_back(std::make_unique<Chain>(nullptr, stroke));
    Chain& chain = *chained.back();
    if (chained.size() == 1)
      chain.base->SetInputData(baked);
    else
      chain.base->SetInputConnection(chained[chained.size() - 2]->simplify->GetOutputPort());
  }
  chained.back()->simplify->Update();
  for (const auto& stroke : strokes)
  {
    Chain alone(baked, stroke);
    alone.simplify->Update();
    baked = saved(alone.simplify->GetOutput());
  }
  expectSameMesh(chained.back()->simplify->GetOutput(), baked);
  EXPECT_EQ(chained[1]->base->GetBaseCount(), 0) << "a 4-8 mesh goes through the base as it is";
  fact("D1_3",
    "three crossing strokes, " + std::to_string(baked->GetNumberOfCells()) +
      " faces: chained and saved after each, the same to the bit");
}

TEST(StellarPipeline, ArraysOfTheUserTravel)
{
  Chain chain(sphere());
  chain.smooth->Update();
  vtkPolyData* flat = chain.smooth->GetOutput();
  ASSERT_GT(flat->GetNumberOfCells(), 2000);
  auto* z = flat->GetPointData()->GetArray("Z");
  auto* triangle = flat->GetCellData()->GetArray("Triangle");
  auto* normals = flat->GetPointData()->GetNormals();
  ASSERT_TRUE(z && triangle && normals);
  double off = 0.0, length = 0.0;
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    // z is linear, so what is mixed where a vertex lies is its z, but for how far the curve is off the
    // facets.
    off = std::max(off, std::abs(z->GetComponent(i, 0) - flat->GetPoint(i)[2]));
    const Vector3 n(normals->GetTuple3(i));
    length = std::max(length, std::abs(n.norm() - 1.0));
    EXPECT_GT(n.dot(Vector3(flat->GetPoint(i)).normalized()), 0.99);
  }
  EXPECT_LT(off, 2e-3);
  EXPECT_LT(length, 1e-12);
  const Mesh coarse = icosphere(3);
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < flat->GetNumberOfCells(); ++c)
  {
    flat->GetPolys()->GetCellAtId(c, ids);
    Vector3 middle = Vector3::Zero();
    for (vtkIdType k = 0; k < 3; ++k)
      middle += Vector3(flat->GetPoint(ids->GetId(k))) / 3.0;
    const Triangle& t = coarse.triangles[static_cast<int>(triangle->GetComponent(c, 0))];
    const Vector3 of = (coarse.points[t[0]] + coarse.points[t[1]] + coarse.points[t[2]]) / 3.0;
    EXPECT_LT((middle - of).norm(), 0.2);
  }
  // Raised: what did not move keeps its normal to the bit, and on the flank they lean.
  chain.displace->Update();
  vtkPolyData* raised = chain.displace->GetOutput();
  auto* turned = raised->GetPointData()->GetNormals();
  double leaning = 1.0;
  for (vtkIdType i = 0; i < raised->GetNumberOfPoints(); ++i)
    leaning = std::min(leaning, Vector3(turned->GetTuple3(i)).dot(Vector3(normals->GetTuple3(i))));
  EXPECT_LT(leaning, 0.9);
  EXPECT_EQ(raised->GetPointData()->GetArray("Z"), z) << "untouched arrays are shared";
  EXPECT_FALSE(raised->GetPointData()->GetArray("BaseNormal"));
  EXPECT_FALSE(raised->GetFieldData()->GetArray("CurveDigest"));
}

TEST(StellarPipeline, AColourRunsNoStepAndChangesNoShape)
{
  const auto mesh = sphere();
  Chain chain(mesh);
  chain.displace->Update();
  const vtkSmartPointer<vtkPoints> points = chain.displace->GetOutput()->GetPoints();
  vtkNew<vtkFloatArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfValues(mesh->GetNumberOfPoints());
  colour->Fill(3.0);
  mesh->GetPointData()->AddArray(colour);
  mesh->Modified();
  chain.displace->Update();
  EXPECT_EQ(chain.displace->GetOutput()->GetPoints(), points);
  EXPECT_EQ(chain.base->GetBaseCount(), 1);
  EXPECT_EQ(chain.refine->GetRefineCount(), 1);
  EXPECT_EQ(chain.displace->GetDisplaceCount(), 1);
  auto* carried = chain.displace->GetOutput()->GetPointData()->GetArray("Colour");
  ASSERT_TRUE(carried);
  for (vtkIdType i = 0; i < carried->GetNumberOfTuples(); ++i)
    ASSERT_EQ(carried->GetComponent(i, 0), 3.0);
}

TEST(StellarPipeline, ThreadsDoNotMatter)
{
  vtkSmartPointer<vtkPolyData> results[2];
  for (int threads = 1; threads <= 2; ++threads)
  {
    vtkSMPTools::Initialize(threads);
    Chain chain(sphere());
    chain.simplify->Update();
    results[threads - 1] = chain.simplify->GetOutput();
  }
  vtkSMPTools::Initialize();
  expectSameMesh(results[0], results[1]);
}

TEST(StellarPipeline, SketchMovesByItsVectorsAndCutsAreCounted)
{
  Chain chain(sphere());
  chain.curves->Update();
  const auto sketch = cold(chain.curves->GetOutput());
  for (vtkIdType i = 0; i < sketch->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = Vector3(sketch->GetPoint(i)) + Vector3(0, 0, 0.3);
    sketch->GetPoints()->SetPoint(i, p.data());
  }
  chain.displace->SetSketchData(sketch);
  chain.displace->SetHeight(7.0);
  chain.displace->Update();
  vtkPolyData* mesh = chain.displace->GetOutput();
  ASSERT_EQ(chain.displace->GetErrorCode(), 0u);
  auto* moved = mesh->GetPointData()->GetArray("Displacement");
  auto* feature = mesh->GetPointData()->GetArray("Feature");
  double off = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    off =
      std::max(off, (Vector3(moved->GetTuple3(i)) - feature->GetComponent(i, 0) * Vector3(0, 0, 0.3)).norm());
  EXPECT_LT(off, 1e-12);
  EXPECT_EQ(chain.displace->GetIntersectingFaces(), 0);
  // A blade through the whole sphere cuts its far side, unless it is held back.
  chain.displace->SetInputConnection(2, nullptr);
  chain.displace->SetHeight(-2.5);
  chain.displace->Update();
  EXPECT_EQ(chain.displace->GetIntersectingFaces(), 0);
  EXPECT_GT(chain.displace->GetHeldBack(), 2);
  EXPECT_NEAR(chain.displace->GetLeastShare(), 0.4 * 2.0 / 2.5, 0.01);
  chain.displace->HoldBackOff();
  chain.displace->Update();
  EXPECT_GT(chain.displace->GetIntersectingFaces(), 10);
  chain.displace->CountIntersectionsOff();
  chain.displace->Update();
  EXPECT_EQ(chain.displace->GetIntersectingFaces(), -1);
  EXPECT_EQ(chain.displace->GetDisplaceCount(), 3);
}

TEST(StellarPipeline, AnotherHeightWritesOnlyWhatItChangesAndNothingThatIsHeld)
{
  Chain chain(sphere());
  std::vector<vtkSmartPointer<vtkPolyData>> held, copies;
  for (const double height : { 0.1, 0.05, -0.02, 0.0815, 0.1, 0.123 })
  {
    chain.displace->SetHeight(height);
    chain.simplify->Update();
    ASSERT_EQ(chain.simplify->GetErrorCode(), 0u);
    Chain fresh(sphere());
    fresh.displace->SetHeight(height);
    fresh.simplify->Update();
    expectSameMesh(chain.simplify->GetOutput(), fresh.simplify->GetOutput());
    expectSameMesh(chain.displace->GetOutput(), fresh.displace->GetOutput());
    vtkPolyData* now = chain.displace->GetOutput();
    if (!held.empty())
    {
      vtkPolyData* last = held.back();
      EXPECT_EQ(now->GetPolys(), last->GetPolys());
      for (const char* name : { "StellarRoot", "StellarPath", "StellarGen" })
      {
        EXPECT_EQ(now->GetCellData()->GetArray(name), last->GetCellData()->GetArray(name)) << name;
      }
      for (const char* name : { "CurveId", "CurveParam" })
      {
        EXPECT_EQ(now->GetPointData()->GetArray(name), last->GetPointData()->GetArray(name)) << name;
      }
      EXPECT_NE(now->GetPoints(), last->GetPoints());
    }
    // Only the arrays are held: the forest is made the one after the next.
    held.push_back(vtkSmartPointer<vtkPolyData>::New());
    held.back()->ShallowCopy(now);
    copies.push_back(cold(now));
  }
  EXPECT_EQ(chain.displace->GetDistanceCount(), 1);
  for (std::size_t i = 0; i < held.size(); ++i)
  {
    SCOPED_TRACE(i);
    expectSameMesh(held[i], copies[i]);
    vtkSmartPointer<vtkPolyData> made[2];
    for (const bool known : { true, false })
    {
      vtkNew<vtkOversketchStellarSimplify> simplify;
      simplify->SetInputData(0, known ? held[i] : copies[i]);
      simplify->SetInputData(1, chain.curves->GetOutput());
      simplify->SetRadius(0.15);
      simplify->Update();
      made[known] = cold(simplify->GetOutput());
    }
    expectSameMesh(made[0], made[1]);
  }
}
