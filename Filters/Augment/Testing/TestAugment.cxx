// The augmentation system: what comes out, what it agrees with, what runs again.
#include "AugmentTools.h"
#include "Harness/saved.h"

#include "vtkOversketchChaikin.h"
#include "vtkOversketchForEach.h"
#include "vtkOversketchStellarBase.h"
#include "vtkOversketchStellarDisplace.h"
#include "vtkOversketchStellarRefine.h"
#include "vtkOversketchStellarSimplify.h"
#include "vtkOversketchStellarSmooth.h"
#include "vtkOversketchStellarSnap.h"
#include "vtkOversketchStrokeThinning.h"
#include "vtkOversketchSurfaceStroke.h"

#include "vtkCallbackCommand.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

using namespace oversketch_test;

namespace
{

const char* const models[] = { "bear", "dog", "hand", "octopus" };

double distanceTo(vtkPolyData* curves, const Vector3& p)
{
  double least = HUGE_VAL;
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    least = std::min(least, (pointOf(curves, i) - p).norm());
  }
  return least;
}

double highest(vtkPolyData* mesh)
{
  vtkDataArray* moves = mesh->GetPointData()->GetArray("Displacement");
  double most = 0.0;
  for (vtkIdType i = 0; moves && i < moves->GetNumberOfTuples(); ++i)
  {
    most = std::max(most, Vector3(moves->GetTuple3(i)).norm());
  }
  return most;
}

// Strokes of one run rise along the normals of the mesh before all; what is chained does where it is told to.
void keepBaseNormals(vtkOversketchAugment* filter, bool keep)
{
  vtkOversketchStellarDisplace::SafeDownCast(filter->GetStep("Displace"))->SetKeepBaseNormals(keep);
}

} // namespace

TEST(Augment, AVeinRisesByItsHeightAndNothingElseMoves)
{
  for (const std::string model : models)
  {
    // Between the octopus's eyes is a crease in which a feature as wide as an eye turns faces over.
    System s(shippedModel(model), { vein(120.0, model == "octopus" ? 60.0 : 0.0) });
    const double radius = 0.03 * s.diagonal();
    vtkPolyData* output = s.run();
    ASSERT_GT(output->GetNumberOfPolys(), s.mesh->GetNumberOfPolys()) << model;
    EXPECT_EQ(s.filter->GetFigure("met.flipped_faces"), 0) << model;
    EXPECT_NEAR(highest(output), 0.5 * radius, 1e-9 * radius) << model;
    vtkPolyData* curves = s.filter->GetInnerOutput("Curves");
    ASSERT_GT(curves->GetNumberOfLines(), 0);
    // Base points stand first, in their order.
    vtkIdType far = 0, moved = 0;
    for (vtkIdType i = 0; i < s.mesh->GetNumberOfPoints(); ++i)
    {
      const bool same = pointOf(output, i) == pointOf(s.mesh, i);
      const bool away = distanceTo(curves, pointOf(s.mesh, i)) > 1.5 * radius;
      far += away;
      moved += !same;
      EXPECT_TRUE(same || !away) << model << " point " << i;
    }
    EXPECT_GT(far, s.mesh->GetNumberOfPoints() / 2);
    EXPECT_GT(moved, 0);
    vtkNew<vtkPolyData> region, hold;
    s.filter->GetRegion(region);
    s.filter->GetHold(hold);
    EXPECT_GT(region->GetNumberOfPolys(), 0);
    EXPECT_TRUE(identical(hold, curves));
  }
}

// A stroke's own radius and height go before the parameters.
TEST(Augment, ReadsWhatAStrokeSaysOfItself)
{
  System s(shippedModel("bear"), { vein(120, 30), vein(120, -30) });
  const double r = 0.03 * s.diagonal();
  for (const auto& [name, first, second] :
    { std::make_tuple("Radius", r, 0.6 * r), std::make_tuple("Height", 0.2 * r, -0.4 * r) })
  {
    vtkNew<vtkDoubleArray> own;
    own->SetName(name);
    own->InsertNextValue(first);
    own->InsertNextValue(second);
    s.strokes->GetCellData()->AddArray(own);
  }
  s.filter->SetHeight(5.0 * r);
  EXPECT_NEAR(highest(s.run()), 0.4 * r, 1e-9 * r);
}

TEST(Augment, StrokesThatDoNotMeetAreTheSameAtOnceAndOneByOne)
{
  System s(shippedModel("octopus"), { vein(60, 45), vein(60, -45) });
  s.filter->SetRadius(0.012 * s.diagonal());
  s.filter->SetSimplify(false);
  const auto atOnce = deepCopy(s.run());
  s.filter->OneByOneOn();
  vtkPolyData* oneByOne = s.run();
  ASSERT_EQ(atOnce->GetNumberOfPoints(), oneByOne->GetNumberOfPoints());
  EXPECT_LT(largestMove(atOnce, oneByOne), 1e-9 * s.diagonal());
}

TEST(Augment, ChainedEqualsSavedEqualsOneByOne)
{
  const std::vector<std::vector<Vector2>> drawn{ vein(), vein(80, 4), vein(60, -3) };
  for (const char* model : { "bear", "dog" })
  {
    vtkSmartPointer<vtkPolyData> chained = shippedModel(model), baked = chained;
    System all(chained, drawn);
    for (const std::vector<Vector2>& stroke : drawn)
    {
      for (vtkSmartPointer<vtkPolyData>* mesh : { &chained, &baked })
      {
        vtkNew<vtkOversketchAugment> filter;
        filter->SetInputData(0, *mesh);
        const auto strokes = strokesOf({ stroke }, all.view);
        filter->SetStrokesData(strokes);
        keepBaseNormals(filter, &stroke != &drawn.back());
        filter->Update();
        ASSERT_EQ(filter->GetErrorCode(), 0u);
        *mesh =
          mesh == &baked ? saved(filter->GetOutput()) : vtkSmartPointer<vtkPolyData>(filter->GetOutput());
      }
    }
    expectSame(chained, baked);
    all.filter->OneByOneOn();
    expectSame(chained, all.run());
  }
}

// By hand, with what each step's header calls published.
TEST(Augment, AsPublishedIsEachStepAsPublished)
{
  for (const bool published : { true, false })
  {
    System s(shippedModel("bear"), { vein(), { { 400, 280 }, { 400, 320 } } });
    s.filter->SetAsPublished(published);
    const double radius = 0.03 * s.diagonal();
    vtkNew<vtkOversketchStrokeThinning> thinning;
    thinning->SetInputData(0, s.strokes);
    vtkNew<vtkOversketchChaikin> chaikin;
    chaikin->SetInputConnection(0, thinning->GetOutputPort());
    vtkNew<vtkOversketchStellarBase> base;
    base->SetInputData(0, s.mesh);
    vtkNew<vtkOversketchSurfaceStroke> curves;
    curves->SetInputConnection(0, chaikin->GetOutputPort());
    curves->SetMeshConnection(base->GetOutputPort());
    curves->SetTolerance(published ? 0.0 : 0.02 * radius);
    vtkNew<vtkOversketchStellarRefine> refine;
    vtkNew<vtkOversketchStellarSnap> snap;
    vtkNew<vtkOversketchStellarSmooth> smooth;
    vtkNew<vtkOversketchStellarDisplace> displace;
    vtkNew<vtkOversketchStellarSimplify> simplify;
    vtkAlgorithm* before = base;
    for (vtkAlgorithm* step : { static_cast<vtkAlgorithm*>(refine),
           static_cast<vtkAlgorithm*>(snap),
           static_cast<vtkAlgorithm*>(smooth),
           static_cast<vtkAlgorithm*>(displace),
           static_cast<vtkAlgorithm*>(simplify) })
    {
      step->SetInputConnection(0, before->GetOutputPort());
      step->SetInputConnection(1, curves->GetOutputPort());
      before = step;
    }
    refine->SetRadius(radius);
    snap->SetRadius(radius);
    displace->SetRadius(radius);
    simplify->SetRadius(radius);
    if (published)
    {
      base->ImprovePairsOff();
      refine->FineFootOff();
      refine->ConnectedOnlyOff();
      refine->SeedCurveFacesOff();
      snap->SetOrderToAllAtOnce();
      snap->SnapFootOff();
      snap->ConnectedOnlyOff();
      smooth->SetRings(-1);
      displace->ConnectedOnlyOff();
      displace->SetNormalsToCurrent();
      displace->SetCombineToSum();
      simplify->ConnectedOnlyOff();
    }
    simplify->Update();
    expectSame(simplify->GetOutput(), s.run());
    EXPECT_EQ(displace->GetFlippedFaces(), s.filter->GetFigure("met.flipped_faces"));
  }
}

// Of strokes one by one, what the steps count of each, and one progress over all.
TEST(Augment, FiguresTimesAndProgressAreOfAllStrokes)
{
  const std::vector<std::vector<Vector2>> drawn{ vein(), vein(80, 4), { { 400, 280 }, { 400, 320 } } };
  System s(shippedModel("bear"), drawn);
  EXPECT_TRUE(std::isnan(s.filter->GetFigure("met.crossings")));
  std::map<std::string, double> sums;
  double least = HUGE_VAL, longest = 0.0;
  vtkSmartPointer<vtkPolyData> mesh = s.mesh;
  for (const std::vector<Vector2>& stroke : drawn)
  {
    System one(mesh, { stroke });
    one.strokes = strokesOf({ stroke }, s.view);
    one.filter->SetStrokesData(one.strokes);
    keepBaseNormals(one.filter, &stroke != &drawn.back());
    mesh = deepCopy(one.run());
    auto* snap = vtkOversketchStellarSnap::SafeDownCast(one.filter->GetStep("Snap"));
    auto* smooth = vtkOversketchStellarSmooth::SafeDownCast(one.filter->GetStep("Smooth"));
    EXPECT_EQ(one.filter->GetFigure("met.crossings"), snap->GetCrossings());
    EXPECT_EQ(one.filter->GetFigure("met.residual"), snap->GetResidual());
    EXPECT_EQ(one.filter->GetFigure("met.refused_moves"), snap->GetRefused() + smooth->GetRefused());
    for (const char* name : { "met.crossings",
           "met.residual",
           "met.refused_moves",
           "met.faces_added",
           "met.flipped_faces",
           "met.self_intersecting_faces" })
    {
      sums[name] += one.filter->GetFigure(name);
    }
    least = std::min(least, one.filter->GetFigure("met.crest_minimum"));
    longest = std::max(longest, one.filter->GetFigure("met.longest_curve_segment"));
    EXPECT_GT(one.filter->GetFigure("met.crest_mean"), 0.9); // on the flank of the one before
    EXPECT_LE(one.filter->GetFigure("met.crest_mean"), 1.0 + 1e-12);
  }
  s.filter->OneByOneOn();
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> hear;
  hear->SetClientData(&progress);
  hear->SetCallback([](vtkObject* filter, unsigned long, void* to, void*)
    { static_cast<std::vector<double>*>(to)->push_back(vtkAlgorithm::SafeDownCast(filter)->GetProgress()); });
  s.filter->AddObserver(vtkCommand::ProgressEvent, hear);
  s.run();
  for (const auto& [name, sum] : sums)
  {
    EXPECT_EQ(s.filter->GetFigure(name.c_str()), sum) << name;
  }
  EXPECT_EQ(s.filter->GetFigure("met.crest_minimum"), least);
  EXPECT_EQ(s.filter->GetFigure("met.longest_curve_segment"), longest);
  EXPECT_LT(longest, 0.5 * 0.03 * s.diagonal());
  EXPECT_GT(s.filter->GetFigure("met.smallest_angle"), 0.0);
  EXPECT_LT(s.filter->GetFigure("met.smallest_angle"), 60.0);
  EXPECT_TRUE(std::isnan(s.filter->GetFigure("Cats")));
  ASSERT_FALSE(progress.empty());
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_LE(progress.back(), 1.0 + 1e-9);
  EXPECT_LT(*std::lower_bound(progress.begin(), progress.end(), 0.2), 0.5); // not all in the first third
  const double all = s.filter->GetStageTime("Displace");
  s.filter->Prepare();
  EXPECT_EQ(s.filter->GetStageTime("Displace"), all);
  s.filter->SetStrokesData(strokesOf({ { { 5, 5 }, { 40, 5 } } }, s.view));
  Ear ear(s.filter);
  s.filter->Update();
  EXPECT_TRUE(std::isnan(s.filter->GetFigure("met.crossings")));
}

TEST(Augment, ACoarseBaseIsRefinedWhereItIsDrawnAndFollowsTheMesh)
{
  System s(shippedModel("dog"));
  const vtkIdType direct = s.run()->GetNumberOfPolys();
  s.filter->SetBaseToSimplified();
  auto* base = vtkOversketchStellarBase::SafeDownCast(s.filter->GetStep("Base"));
  base->SetSourceTolerance(4e-3 * s.diagonal());
  vtkPolyData* output = s.run();
  EXPECT_LT(output->GetNumberOfPolys(), direct / 2);
  EXPECT_LT(output->GetNumberOfPolys(), s.mesh->GetNumberOfPolys());
  EXPECT_GT(base->GetSourceOutput()->GetNumberOfPoints(), 0);
  EXPECT_NEAR(highest(output), 0.5 * 0.03 * s.diagonal(), 0.02 * 0.03 * s.diagonal());
  const auto all = deepCopy(output);
  System again(s.mesh);
  again.filter->SetBase(vtkOversketchAugment::Simplified);
  vtkOversketchStellarBase::SafeDownCast(again.filter->GetStep("Base"))
    ->SetSourceTolerance(4e-3 * s.diagonal());
  expectSame(all, again.run());
  s.filter->SetBaseToDirect();
  EXPECT_EQ(s.run()->GetNumberOfPolys(), direct);
}

TEST(Augment, AnotherHeightRunsTheDisplacementAndARadiusTheRefinementToo)
{
  System s(shippedModel("dog"));
  s.filter->SimplifyOff();
  s.run();
  auto* base = vtkOversketchStellarBase::SafeDownCast(s.filter->GetStep("Base"));
  auto* curves = vtkOversketchSurfaceStroke::SafeDownCast(s.filter->GetStep("Curves"));
  auto* refine = vtkOversketchStellarRefine::SafeDownCast(s.filter->GetStep("Refine"));
  auto* snap = vtkOversketchStellarSnap::SafeDownCast(s.filter->GetStep("Snap"));
  auto* displace = vtkOversketchStellarDisplace::SafeDownCast(s.filter->GetStep("Displace"));
  const auto counts = [&]
  {
    return std::vector<vtkIdType>{ base->GetBaseCount(),
      curves->GetProjectionCount(),
      refine->GetRefineCount(),
      snap->GetSnapCount(),
      displace->GetDistanceCount(),
      displace->GetDisplaceCount() };
  };
  const double r = 0.03 * s.diagonal();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 1, 1, 1, 1, 1 }));
  ASSERT_TRUE(s.filter->Prepare()); // which is done
  s.filter->SetHeight(-r);
  s.run();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 1, 1, 1, 1, 2 }));
  s.filter->SetSharpness(2.0);
  s.filter->SetProfile("0 1, 0.5 0.9, 1 0");
  s.run();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 1, 1, 1, 1, 3 }));
  s.filter->SetRadius(0.8 * r);
  s.run();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 2, 2, 2, 2, 4 }));
  s.filter->SetSharpness(3.0); // whose crest asks for shorter edges
  s.run();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 2, 3, 3, 3, 5 }));
  vtkNew<vtkDoubleArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfTuples(s.mesh->GetNumberOfPoints());
  colour->Fill(0.5);
  s.mesh->GetPointData()->AddArray(colour);
  vtkPolyData* output = s.run();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 2, 3, 3, 3, 5 }));
  ASSERT_TRUE(output->GetPointData()->GetArray("Colour"));
  EXPECT_EQ(
    output->GetPointData()->GetArray("Colour")->GetComponent(output->GetNumberOfPoints() - 1, 0), 0.5);
}

TEST(Augment, OneAndTwoThreadsColdAndCachedAgreeToTheBit)
{
  System s(shippedModel("hand"), { vein(), vein(80, 20) });
  vtkSMPTools::Initialize(1);
  const auto one = deepCopy(s.run());
  s.filter->Modified();
  expectSame(one, s.run());
  System two(shippedModel("hand"), { vein(), vein(80, 20) });
  vtkSMPTools::Initialize(2);
  expectSame(one, two.run());
  vtkSMPTools::Initialize();
}

TEST(Augment, ReshapeIsTheNextOutputBeforeItIsMade)
{
  System s(shippedModel("dog"));
  vtkPolyData* output = s.run();
  const double r = 0.03 * s.diagonal();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(output->GetPoints());
  ASSERT_TRUE(s.filter->Reshape(-0.7 * r, 1.9, points));
  vtkSmartPointer<vtkPolyData> before = deepCopy(output);
  expectSame(before, s.run()); // nothing changed
  s.filter->SetHeight(-0.7 * r);
  s.filter->SetSharpness(1.9);
  s.filter->SimplifyOff();
  s.run();
  vtkPolyData* displaced = s.filter->GetInnerOutput("Displace");
  vtkIdType next = 0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i, ++next)
  {
    while (next < displaced->GetNumberOfPoints() && pointOf(displaced, next) != Vector3(points->GetPoint(i)))
    {
      ++next;
    }
    ASSERT_LT(next, displaced->GetNumberOfPoints()) << i;
  }
  points->SetNumberOfPoints(3);
  Ear ear(s.filter);
  EXPECT_FALSE(s.filter->Reshape(r, 1.0, points));
  EXPECT_EQ(ear.errors.size(), 1u);
}

TEST(Augment, ACrestIsShownBeforeTheStrokeIsDone)
{
  System s(shippedModel("bear"));
  ASSERT_TRUE(s.filter->Prepare());
  EXPECT_EQ(vtkOversketchSurfaceStroke::SafeDownCast(s.filter->GetStep("Curves"))->GetSceneCount(), 1);
  EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkPolyData> crest;
  ASSERT_TRUE(s.filter->PreviewCrest(s.mesh, s.strokes, crest));
  ASSERT_EQ(crest->GetNumberOfLines() % 3, 0);
  ASSERT_GT(crest->GetNumberOfLines(), 0);
  vtkPolyData* output = s.run();
  // The crest of the preview is that of the surface: its points lie within the chords' error of it.
  vtkPolyData* curves = s.filter->GetInnerOutput("Curves");
  const double r = 0.03 * s.diagonal();
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR((pointOf(crest, i) - pointOf(curves, i)).norm(), 0.5 * r, 1e-9 * r);
    EXPECT_LT(distanceTo(output, pointOf(crest, i)), 0.3 * r);
  }
  auto* base = vtkOversketchStellarBase::SafeDownCast(s.filter->GetStep("Base"));
  EXPECT_EQ(base->GetBaseCount(), 1);
  auto* rays = vtkOversketchSurfaceStroke::SafeDownCast(s.filter->GetStep("Curves"));
  EXPECT_EQ(rays->GetSceneCount(), 1);
  vtkNew<vtkPolyData> dot;
  EXPECT_FALSE(s.filter->PreviewCrest(s.mesh, dot, crest));
  EXPECT_EQ(crest->GetNumberOfPoints(), 0);
}

TEST(Augment, ADriverOfSystemsDrivesIt)
{
  System s(shippedModel("bear"), { vein(), vein(80, 20) });
  const auto alone = deepCopy(s.run());
  vtkNew<vtkOversketchForEach> each;
  vtkNew<vtkOversketchAugment> filter;
  each->SetFilter(filter);
  vtkNew<vtkMultiBlockDataSet> models;
  models->SetBlock(0, s.mesh);
  models->SetBlock(1, s.mesh);
  each->SetInputDataObject(0, models);
  each->SetStrokeData(s.strokes);
  each->Update();
  EXPECT_EQ(each->GetErrorCode(), 0u);
  auto* made = vtkMultiBlockDataSet::SafeDownCast(each->GetOutputDataObject(0));
  ASSERT_TRUE(made);
  for (const unsigned int block : { 0u, 1u })
  {
    expectSame(alone, vtkPolyData::SafeDownCast(made->GetBlock(block)));
  }
}

// A line over the dog's back follows the stroke in the picture.
TEST(Augment, ASilhouetteGoesWhereItIsDrawn)
{
  System s(shippedModel("dog"));
  s.filter->SetSketchMode(vtkOversketchAugment::Silhouette);
  s.filter->SetStrokesData(strokesOf({ overTheTop(s) }, s.view));
  vtkPolyData* output = s.run();
  EXPECT_EQ(s.filter->GetFigure("met.flipped_faces"), 0);
  vtkPolyData* sketch = vtkPolyData::SafeDownCast(s.filter->GetStep("Sketch")->GetOutputDataObject(1));
  ASSERT_GT(sketch->GetNumberOfPoints(), 2);
  for (vtkIdType i = 0; i < sketch->GetNumberOfPoints(); ++i)
  {
    EXPECT_LT(distanceTo(output, pointOf(sketch, i)), 0.01 * s.diagonal()) << i;
  }
  vtkNew<vtkPoints> points;
  points->DeepCopy(output->GetPoints());
  EXPECT_TRUE(s.filter->Reshape(0.0, 1.0, points));
}
