#include "CurveShapes.h"
#include "Harness/refine_runs.h"
#include "Harness/refine_shapes.h"
#include "Planar/trim.h"
#include "vtkOversketchClassify.h"
#include "vtkOversketchCoarseMesh.h"
#include "vtkOversketchDistance.h"
#include "vtkOversketchPlanarRefine.h"
#include "vtkOversketchPlanarTools.h"
#include "vtkOversketchPolyline.h"
#include "vtkOversketchTrimHoles.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const Canvas unitCanvas{ Vector2::Zero(), Vector2::Ones() };

// A drawing's coarse mesh and curves, as the filters before have them.
struct Inputs
{
  vtkNew<vtkPolyData> faces, edges;
  vtkSmartPointer<vtkPolyData> curves;

  explicit Inputs(const CoarseDrawing& drawing)
    : Inputs(drawing.mesh, drawing.strokes)
  {
  }

  Inputs(const PlanarMesh& mesh, const std::vector<DrawnStroke>& strokes)
    : curves(toCurves(strokes, unitCanvas))
  {
    WritePlanarMesh(mesh, this->faces);
    WriteStrokeEdges(mesh, this->faces, this->edges);
  }

  template <typename Filter>
  void feed(Filter* filter) const
  {
    filter->SetInputData(this->faces);
    filter->SetEdgesData(this->edges);
    filter->SetCurvesData(this->curves);
  }
};

vtkPolyData* outputOf(vtkPolyDataAlgorithm* filter, int port)
{
  return filter->GetOutput(port);
}

// The mesh of a filter's outputs 0 and 1.
PlanarMesh meshOf(vtkPolyDataAlgorithm* filter)
{
  return PlanarMeshOf(outputOf(filter, 0), outputOf(filter, 1));
}

void expectSame(const PlanarMesh& a, const PlanarMesh& b)
{
  ASSERT_EQ(a.points.size(), b.points.size());
  ASSERT_EQ(a.faces.size(), b.faces.size());
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t p = 0; p < a.points.size(); ++p)
  {
    const PlanarPoint &x = a.points[p], &y = b.points[p];
    EXPECT_TRUE(x.place == y.place && x.kind == y.kind && x.stroke == y.stroke && x.param == y.param &&
                x.isBase == y.isBase)
      << p;
  }
  for (std::size_t f = 0; f < a.faces.size(); ++f)
  {
    const PlanarFace &x = a.faces[f], &y = b.faces[f];
    EXPECT_TRUE(x.corners == y.corners && x.region == y.region && x.object == y.object && x.base == y.base)
      << f;
  }
  for (std::size_t e = 0; e < a.edges.size(); ++e)
  {
    const StrokeEdge &x = a.edges[e], &y = b.edges[e];
    EXPECT_TRUE(
      x.from == y.from && x.to == y.to && x.stroke == y.stroke && x.start == y.start && x.end == y.end)
      << e;
  }
}

// A face between two strokes that the third level has no room for.
CoarseDrawing tightDrawing()
{
  return bowDrawing(0.06);
}

} // namespace

TEST(PlanarRefineFilter, GivesTheKernelsMesh)
{
  for (const CoarseDrawing& drawing :
    { discDrawing(0.3, 13), bowDrawing(), gridDrawing(5, Cells::Mixed, true, 3) })
  {
    const Inputs inputs(drawing);
    vtkNew<vtkOversketchPlanarRefine> filter;
    inputs.feed(filter.Get());
    for (const bool quads : { false, true })
    {
      filter->SetQuads(quads);
      for (const int levels : { 0, 2, 3 })
      {
        filter->SetLevels(levels);
        filter->Update();
        ASSERT_EQ(filter->GetErrorCode(), 0u);
        PlanarRefineOptions options;
        options.levels = levels;
        options.quads = quads;
        expectSame(meshOf(filter), refinePlanar(drawing.mesh, drawing.strokes, options, Context()).mesh);
        EXPECT_EQ(outputOf(filter, 2)->GetNumberOfCells(), 0);
        EXPECT_EQ(filter->GetInverted(), 0);
      }
    }
  }
}

TEST(PlanarRefineFilter, TakesTheLevelsOfTheSketch)
{
  const CoarseDrawing drawing = gridDrawing(5, Cells::Triangles, true, 3);
  const Inputs inputs(drawing);
  vtkNew<vtkOversketchPlanarRefine> filter;
  inputs.feed(filter.Get());
  filter->Update();
  EXPECT_EQ(filter->GetLevelsMade(), 3);
  const PlanarMesh usual = meshOf(filter);
  filter->LevelsFromSketchOn();
  filter->Update();
  PlanarRefineOptions options;
  options.levels = levelsOfSketch(drawing.mesh, options.canvasSide);
  ASSERT_GT(options.levels, 3);
  EXPECT_EQ(filter->GetLevelsMade(), options.levels);
  expectSame(meshOf(filter), refinePlanar(drawing.mesh, drawing.strokes, options, Context()).mesh);
  const vtkIdType count = filter->GetRefineCount();
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetRefineCount(), count) << "it is kept";
  EXPECT_EQ(filter->GetLevelsMade(), options.levels);
  filter->AsPublishedOn();
  filter->Update();
  EXPECT_EQ(filter->GetLevelsMade(), 3) << "as published: as many as are asked for";
  filter->AsPublishedOff();
  filter->LevelsFromSketchOff();
  filter->Update();
  expectSame(meshOf(filter), usual);
}

TEST(PlanarRefineFilter, HandsBackPartsOfStrokesAndNoMesh)
{
  const CoarseDrawing drawing = tightDrawing();
  const Inputs inputs(drawing);
  vtkNew<vtkOversketchPlanarRefine> filter;
  inputs.feed(filter.Get());
  Ear ear(filter);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_TRUE(ear.errors.empty());
  ASSERT_EQ(ear.warnings.size(), 1u);
  EXPECT_NE(ear.warnings[0].find("Strokes leave triangles no room, or"), std::string::npos)
    << ear.warnings[0];
  EXPECT_EQ(outputOf(filter, 0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(outputOf(filter, 1)->GetNumberOfCells(), 0);
  const std::vector<StrokeSplit> splits = SplitsOf(outputOf(filter, 2)),
                                 expected = refinePlanar(drawing.mesh, drawing.strokes, {}, Context()).splits;
  ASSERT_FALSE(splits.empty());
  ASSERT_EQ(splits.size(), expected.size());
  for (std::size_t i = 0; i < splits.size(); ++i)
  {
    EXPECT_EQ(splits[i].stroke, 1); // the bow
    EXPECT_EQ(splits[i].start, expected[i].start);
    EXPECT_EQ(splits[i].end, expected[i].end);
    EXPECT_EQ(splits[i].halvings, 1);
  }
  EXPECT_GT(filter->GetInverted(), 0);

  // As published the mesh comes out as it is.
  filter->AsPublishedOn();
  filter->Update();
  EXPECT_EQ(outputOf(filter, 0)->GetNumberOfCells(), 8 * 64);
  EXPECT_EQ(outputOf(filter, 2)->GetNumberOfCells(), 0);
  EXPECT_GT(filter->GetInverted(), 0);
  EXPECT_EQ(ear.warnings.size(), 1u);
  EXPECT_EQ(filter->GetRefineCount(), 2);
}

TEST(PlanarRefineFilter, ComputesNothingTwice)
{
  const Inputs inputs(bowDrawing());
  vtkNew<vtkOversketchPlanarRefine> filter;
  inputs.feed(filter.Get());
  filter->Update();
  vtkPoints* points = filter->GetOutput()->GetPoints();
  filter->Modified();
  filter->Update();
  // What a stroke is treated as is nothing to this step, though it is an array of the curves.
  vtkNew<vtkIntArray> treatment;
  treatment->SetName("Treatment");
  treatment->InsertNextValue(0);
  treatment->InsertNextValue(0);
  inputs.curves->GetCellData()->AddArray(treatment);
  inputs.curves->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetRefineCount(), 1);
  EXPECT_EQ(filter->GetOutput()->GetPoints(), points);
  filter->SetSnapShare(0.25);
  filter->Update();
  EXPECT_EQ(filter->GetRefineCount(), 2);
  EXPECT_NE(filter->GetOutput()->GetPoints(), points);
  inputs.edges->GetCellData()->GetArray("ParamEnd")->Modified();
  inputs.edges->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetRefineCount(), 3);
  inputs.curves->GetPoints()->Modified();
  inputs.curves->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetRefineCount(), 4);
}

TEST(PlanarRefineFilter, OneAndTwoThreadsGiveTheSameBits)
{
  const Inputs inputs(gridDrawing(12, Cells::Mixed, true, 7));
  PlanarMesh first;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkOversketchPlanarRefine> filter;
    inputs.feed(filter.Get());
    filter->Update();
    if (threads == 1)
    {
      first = meshOf(filter);
    }
    expectSame(meshOf(filter), first);
  }
  EXPECT_FALSE(first.faces.empty());
  vtkSMPTools::Initialize();
}

TEST(PlanarRefineFilter, RefusesAndCancels)
{
  const auto refuse = [](Failure failure,
                        const std::string& words,
                        const std::function<void(Inputs&, vtkOversketchPlanarRefine*)>& spoil)
  {
    Inputs inputs(squareDrawing());
    vtkNew<vtkOversketchPlanarRefine> filter;
    spoil(inputs, filter);
    inputs.feed(filter.Get());
    expectRefusal(filter, failure, words);
    EXPECT_EQ(outputOf(filter, 1)->GetNumberOfCells(), 0);
    EXPECT_EQ(outputOf(filter, 2)->GetNumberOfCells(), 0);
  };
  using Filter = vtkOversketchPlanarRefine;
  for (const char* name : { "BoundaryKind", "StrokeId", "StrokeParam", "IsBaseVertex" })
  {
    refuse(
      Failure::MissingArray, name, [&](Inputs& in, Filter*) { in.faces->GetPointData()->RemoveArray(name); });
  }
  for (const char* name : { "RegionId", "ObjectId", "BaseFaceId" })
  {
    refuse(
      Failure::MissingArray, name, [&](Inputs& in, Filter*) { in.faces->GetCellData()->RemoveArray(name); });
  }
  for (const char* name : { "StrokeId", "ParamStart", "ParamEnd" })
  {
    refuse(
      Failure::MissingArray, name, [&](Inputs& in, Filter*) { in.edges->GetCellData()->RemoveArray(name); });
  }
  refuse(Failure::MissingArray,
    "Canvas",
    [](Inputs& in, Filter*) { in.curves->GetFieldData()->RemoveArray("Canvas"); });
  refuse(Failure::BadMesh,
    "on the border and on no stroke",
    [](Inputs& in, Filter*)
    {
      PlanarMesh open = squareDrawing().mesh;
      open.edges.pop_back();
      WriteStrokeEdges(open, in.faces, in.edges);
    });
  refuse(Failure::BadMesh,
    "point 0 lies on stroke 1 of 1",
    [](Inputs& in, Filter*) { in.faces->GetPointData()->GetArray("StrokeId")->SetComponent(0, 0, 1); });
  refuse(Failure::BadMesh,
    "is no part of stroke 0",
    [](Inputs& in, Filter*) { in.edges->GetCellData()->GetArray("ParamEnd")->SetComponent(1, 0, 7.0); });
  refuse(Failure::BadStroke, "levels is -1", [](Inputs&, Filter* filter) { filter->SetLevels(-1); });
  refuse(Failure::BadStroke, "levels is 11", [](Inputs&, Filter* filter) { filter->SetLevels(11); });
  refuse(Failure::BadStroke,
    "the snap's share is",
    [](Inputs&, Filter* filter) { filter->SetSnapShare(std::numeric_limits<double>::quiet_NaN()); });

  const Inputs inputs(squareDrawing());
  vtkNew<vtkOversketchPlanarRefine> filter;
  inputs.feed(filter.Get());
  expectCancel(filter, 0.3);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 4 * 64);

  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(TrimHolesFilter, CutsByRegionAndTreatment)
{
  const UnitDrawing drawing({ circleStroke(0.5, 0.5, 0.4),
    circleStroke(0.4, 0.5, 0.2),
    circleStroke(0.4, 0.5, 0.1),
    circleStroke(0.75, 0.5, 0.08) });
  const PlanarMesh mesh = rebuilt(drawing, DeltaMode::Adaptive, {}).result.mesh;
  ASSERT_FALSE(mesh.faces.empty());
  const Inputs inputs(mesh, drawing.strokes);
  WriteClassification(drawing.classes, inputs.curves);
  vtkNew<vtkOversketchTrimHoles> filter;
  inputs.feed(filter.Get());
  filter->Update(); // nothing is a hole
  EXPECT_EQ(filter->GetOutput()->GetPoints(), inputs.faces->GetPoints());
  const auto treat = [&](const std::vector<Treatment>& treatments)
  {
    vtkNew<vtkIntArray> array;
    array->SetName("Treatment");
    for (const Treatment treatment : treatments)
    {
      array->InsertNextValue(static_cast<int>(treatment));
    }
    inputs.curves->GetCellData()->AddArray(array);
    inputs.curves->Modified();
    filter->Update();
    ASSERT_EQ(filter->GetErrorCode(), 0u);
    expectSame(meshOf(filter), withoutRegions(mesh, regionsInHoles(drawing.classes, treatments)));
  };
  const Treatment fill = Treatment::Fill, hole = Treatment::Hole, tunnel = Treatment::Tunnel;
  treat({ fill, hole, fill, tunnel });
  const vtkIdType first = filter->GetOutput()->GetNumberOfCells();
  EXPECT_LT(first, inputs.faces->GetNumberOfCells());
  treat({ fill, fill, hole, hole });
  EXPECT_NE(filter->GetOutput()->GetNumberOfCells(), first);
  treat({ hole, tunnel, tunnel, tunnel });
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), inputs.faces->GetNumberOfCells());

  treat({ fill, hole, fill, fill });
  // Of the third stroke, which lies in the hole, it does not matter what it is.
  vtkPoints* points = filter->GetOutput()->GetPoints();
  treat({ fill, hole, tunnel, tunnel });
  EXPECT_EQ(filter->GetOutput()->GetPoints(), points);
  inputs.faces->GetCellData()->GetArray("RegionId")->SetComponent(7, 0, 4);
  inputs.faces->GetCellData()->GetArray("RegionId")->Modified();
  inputs.faces->Modified();
  expectRefusal(filter, Failure::BadMesh, "face 7 lies in region 4 of 4");
  inputs.curves->GetCellData()->RemoveArray("Role");
  inputs.curves->Modified();
  expectRefusal(filter, Failure::MissingArray, "Role");
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetErrorCode(), 0u);
}

TEST(PlanarRefineFilter, TheSplitsFedBackMakeAMesh)
{
  const std::vector<DrawnStroke> strokes{ circleStroke(0.5, 0.5, 0.4),
    circleStroke(0.4, 0.5, 0.2),
    circleStroke(0.4, 0.5, 0.1),
    circleStroke(0.75, 0.5, 0.08) };
  vtkNew<vtkOversketchClassify> classify;
  vtkNew<vtkOversketchDistance> distance;
  vtkNew<vtkOversketchPolyline> polyline;
  vtkNew<vtkOversketchCoarseMesh> coarse;
  vtkNew<vtkOversketchPlanarRefine> filter;
  classify->SetInputData(toCurves(strokes, unitCanvas));
  distance->SetInputConnection(classify->GetOutputPort());
  polyline->SetInputConnection(distance->GetOutputPort());
  polyline->SetDistanceConnection(distance->GetOutputPort(1));
  coarse->SetInputConnection(polyline->GetOutputPort());
  filter->SetInputConnection(coarse->GetOutputPort());
  filter->SetEdgesConnection(coarse->GetOutputPort(1));
  filter->SetCurvesConnection(distance->GetOutputPort());
  std::vector<StrokeSplit> splits;
  int rounds = 0;
  Ear ear(filter);
  for (filter->Update(); filter->GetSplitsOutput()->GetNumberOfCells() > 0 && rounds < 24; filter->Update())
  {
    addSplits(splits, SplitsOf(filter->GetSplitsOutput()));
    vtkNew<vtkPolyData> data;
    WriteSplits(splits, strokes, data);
    polyline->SetSplitsData(data);
    ++rounds;
  }
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_GE(rounds, 1);
  EXPECT_EQ(ear.warnings.size(), static_cast<std::size_t>(rounds));
  EXPECT_EQ(filter->GetInverted(), 0);
  EXPECT_EQ(outputOf(filter, 0)->GetNumberOfCells(), 64 * coarse->GetOutput()->GetNumberOfCells());
  EXPECT_NEAR(areaOf(meshOf(filter)), pi * 0.16, 0.002);
}
