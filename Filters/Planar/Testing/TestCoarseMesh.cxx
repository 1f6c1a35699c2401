#include "CurveShapes.h"
#include "Harness/planar_shapes.h"
#include "vtkOversketchClassify.h"
#include "vtkOversketchCoarseMesh.h"
#include "vtkOversketchDarts.h"
#include "vtkOversketchDistance.h"
#include "vtkOversketchPlanarTools.h"
#include "vtkOversketchPolyline.h"
#include "vtkOversketchQuadMerge.h"
#include "vtkOversketchTreatment.h"

#include "vtkIdList.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// From curves to the coarse mesh, all filters of it.
struct Coarse
{
  vtkNew<vtkOversketchClassify> classify;
  vtkNew<vtkOversketchTreatment> treatment;
  vtkNew<vtkOversketchDistance> distance;
  vtkNew<vtkOversketchPolyline> polyline;
  vtkNew<vtkOversketchDarts> darts;
  vtkNew<vtkOversketchCoarseMesh> mesh;
  vtkNew<vtkOversketchQuadMerge> quads;

  explicit Coarse(vtkPolyData* curves)
  {
    this->classify->SetInputData(curves);
    this->treatment->SetInputConnection(this->classify->GetOutputPort());
    this->distance->SetInputConnection(this->treatment->GetOutputPort());
    this->polyline->SetInputConnection(this->distance->GetOutputPort());
    this->polyline->SetDistanceConnection(this->distance->GetOutputPort(1));
    this->darts->SetInputConnection(this->polyline->GetOutputPort());
    this->darts->SetDistanceConnection(this->distance->GetOutputPort(1));
    this->mesh->SetInputConnection(this->polyline->GetOutputPort());
    this->mesh->SetDartsConnection(this->darts->GetOutputPort());
    this->quads->SetInputConnection(this->mesh->GetOutputPort());
    this->quads->SetEdgesConnection(this->mesh->GetOutputPort(1));
  }
};

double areaOf(vtkPolyData* faces)
{
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; f < faces->GetNumberOfPolys(); ++f)
  {
    faces->GetPolys()->GetCellAtId(f, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const Vector2 a(faces->GetPoint(ids->GetId(k)));
      const Vector2 b(faces->GetPoint(ids->GetId((k + 1) % ids->GetNumberOfIds())));
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
  }
  return area;
}

bool sameMesh(const PlanarMesh& a, const PlanarMesh& b)
{
  const auto samePoint = [](const PlanarPoint& p, const PlanarPoint& q)
  {
    return p.place == q.place && p.kind == q.kind && p.stroke == q.stroke && p.param == q.param &&
           p.isBase == q.isBase;
  };
  const auto sameFace = [](const PlanarFace& f, const PlanarFace& g)
  { return f.corners == g.corners && f.region == g.region && f.object == g.object && f.base == g.base; };
  const auto sameEdge = [](const StrokeEdge& e, const StrokeEdge& f) {
    return e.from == f.from && e.to == f.to && e.stroke == f.stroke && e.start == f.start && e.end == f.end;
  };
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), samePoint) &&
         std::equal(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(), sameFace) &&
         std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(), sameEdge);
}

} // namespace

TEST(CoarseMeshFilter, FromCurvesToFacesAndEdges)
{
  Coarse chain(toCurves(bodyWithFeatures()));
  chain.treatment->SetHoles("4");
  chain.treatment->SetTunnels("1");
  chain.quads->Update();
  ASSERT_EQ(chain.quads->GetErrorCode(), 0u);
  vtkPolyData* lines = chain.polyline->GetOutput();
  EXPECT_EQ(cellValues(lines, "StrokeId"), (std::vector<int>{ 0, 1, 2, 3, 4 }));
  EXPECT_EQ(cellValues(lines, "Role"), (std::vector<int>{ 1, 2, 3, 3, 2 }));
  EXPECT_EQ(cellValues(lines, "Treatment"), (std::vector<int>{ 0, 2, 0, 0, 1 }));
  // A circle's ArcLength and StrokeLength in the world.
  EXPECT_NEAR(lines->GetCellData()->GetArray("StrokeLength")->GetComponent(0, 0), turn * 400.0, 1.0);
  for (vtkPolyData* each :
    { lines, chain.mesh->GetOutput(), chain.mesh->GetEdgesOutput(), chain.quads->GetOutput() })
  {
    EXPECT_TRUE(each->GetFieldData()->HasArray("Canvas"));
    EXPECT_TRUE(each->GetFieldData()->HasArray("Resolution"));
  }
  EXPECT_GT(chain.darts->GetOutput()->GetNumberOfPoints(), 5);
  EXPECT_EQ(chain.darts->GetOutput()->GetNumberOfVerts(), chain.darts->GetOutput()->GetNumberOfPoints());

  vtkPolyData* faces = chain.mesh->GetOutput();
  const double body = areaOf(faces);
  EXPECT_NEAR(body, pi * (400.0 * 400.0 - 60.0 * 60.0), 0.1 * body);
  EXPECT_NEAR(areaOf(chain.quads->GetOutput()), body, 1e-6);
  EXPECT_LT(chain.quads->GetOutput()->GetNumberOfPolys(), faces->GetNumberOfPolys());
  const std::vector<int> regions = cellValues(faces, "RegionId");
  EXPECT_EQ(std::set<int>(regions.begin(), regions.end()), (std::set<int>{ 0, 1 })); // the hole's is gone
  const PlanarMesh mesh = PlanarMeshOf(faces, chain.mesh->GetEdgesOutput());
  std::map<int, double> lengths;
  for (const StrokeEdge& edge : mesh.edges)
    lengths[edge.stroke] += edge.end - edge.start;
  ASSERT_EQ(lengths.size(), 5u);
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(lengths[i], lines->GetCellData()->GetArray("StrokeLength")->GetComponent(i, 0), 1e-9);
  // Polydata and back.
  vtkNew<vtkPolyData> again, againEdges;
  WritePlanarMesh(mesh, again);
  WriteStrokeEdges(mesh, again, againEdges);
  EXPECT_TRUE(sameMesh(PlanarMeshOf(again, againEdges), mesh));
}

TEST(CoarseMeshFilter, EndsOfFeaturesJoinTheRimAsFarAsTheyMay)
{
  // Its end is 0.02 off the rim: in the mesh a point of the feature's own, or one of the rim.
  Coarse chain(toCurves({ circleStroke(0.5, 0.5, 0.4), evenStroke({ { 0.5, 0.5 }, { 0.88, 0.503 } }, false) },
    { Vector2(0.0, 0.0), Vector2(1.0, 1.0) }));
  for (const double distance : { 0.0, 0.01, 0.03 })
  {
    chain.polyline->SetJoinDistance(distance);
    chain.mesh->Update();
    ASSERT_EQ(chain.mesh->GetErrorCode(), 0u);
    double nearest = 1.0;
    const PlanarMesh mesh = PlanarMeshOf(chain.mesh->GetOutput(), chain.mesh->GetEdgesOutput());
    int joined = 0; // edges of the feature that end on the rim
    for (const StrokeEdge& edge : mesh.edges)
    {
      const PlanarPoint& last = mesh.points[edge.to];
      joined += edge.stroke == 1 && last.kind == BoundaryKind::Object;
      nearest = edge.stroke == 1 ? std::min(nearest, 0.4 - (last.place - Vector2(0.5, 0.5)).norm()) : nearest;
    }
    EXPECT_EQ(joined, distance > 0.02 ? 1 : 0);
    EXPECT_NEAR(nearest, distance > 0.02 ? 0.0 : 0.02, 1e-3);
  }
}

TEST(CoarseMeshFilter, OnlyWhatChangedRunsAgain)
{
  Coarse chain(toCurves(bodyWithFeatures()));
  chain.treatment->SetHoles("4"); // the body is thin beside it
  chain.quads->Update();
  vtkPoints* const points = chain.mesh->GetOutput()->GetPoints();
  const auto counts = [&]
  {
    return std::vector<vtkIdType>{ chain.polyline->GetPolylineCount(),
      chain.darts->GetDartsCount(),
      chain.mesh->GetMeshCount(),
      chain.quads->GetMergeCount() };
  };
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 1, 1, 1 }));
  for (vtkAlgorithm* step : { static_cast<vtkAlgorithm*>(chain.polyline),
         static_cast<vtkAlgorithm*>(chain.darts),
         static_cast<vtkAlgorithm*>(chain.mesh),
         static_cast<vtkAlgorithm*>(chain.quads) })
    step->Modified();
  chain.quads->Update();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 1, 1, 1 }));
  EXPECT_EQ(chain.mesh->GetOutput()->GetPoints(), points);
  chain.darts->SetSeed(2);
  chain.quads->Update();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 2, 2, 2 }));
  chain.mesh->SetTerminalRuleToNone();
  chain.quads->Update();
  EXPECT_EQ(counts(), (std::vector<vtkIdType>{ 1, 2, 3, 3 }));
  // As published: fewer vertices, no darts.
  const vtkIdType before = chain.polyline->GetOutput()->GetNumberOfPoints();
  chain.polyline->AsPublishedOn();
  chain.darts->AsPublishedOn();
  chain.quads->Update();
  EXPECT_LT(chain.polyline->GetOutput()->GetNumberOfPoints(), before);
  EXPECT_EQ(chain.darts->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(chain.darts->GetDartsCount(), 2);
  // Neither needs the distance then, and darts need not be connected.
  chain.polyline->SetDistanceConnection(nullptr);
  chain.darts->SetDistanceConnection(nullptr);
  chain.mesh->SetDartsConnection(nullptr);
  chain.quads->Update();
  EXPECT_EQ(chain.quads->GetErrorCode(), 0u);
  EXPECT_GT(chain.quads->GetOutput()->GetNumberOfPolys(), 3);
}

TEST(CoarseMeshFilter, ThreadsDoNotMatter)
{
  const auto meshOf = [](int threads)
  {
    vtkSMPTools::Initialize(threads);
    Coarse chain(toCurves(bodyWithFeatures()));
    chain.mesh->Update();
    PlanarMesh mesh = PlanarMeshOf(chain.mesh->GetOutput(), chain.mesh->GetEdgesOutput());
    vtkSMPTools::Initialize();
    return mesh;
  };
  EXPECT_TRUE(sameMesh(meshOf(1), meshOf(2)));
}

TEST(CoarseMeshFilter, SplitsMakePiecesFiner)
{
  Coarse chain(toCurves(bodyWithFeatures()));
  chain.mesh->Update();
  const StrokeEdge edge = PlanarMeshOf(chain.mesh->GetOutput(), chain.mesh->GetEdgesOutput()).edges[2];
  const std::vector<DrawnStroke> strokes = DrawingOf(chain.distance->GetOutput()).Strokes;
  vtkNew<vtkPolyData> splits;
  const std::vector<StrokeSplit> given{ { edge.stroke, edge.start, edge.end, 3 }, { 3, 1.5, 20.25, 1 } };
  WriteSplits(given, strokes, splits);
  const std::vector<StrokeSplit> read = SplitsOf(splits);
  ASSERT_EQ(read.size(), 2u);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(read[i].stroke, given[i].stroke);
    EXPECT_EQ(read[i].start, given[i].start);
    EXPECT_EQ(read[i].end, given[i].end);
    EXPECT_EQ(read[i].halvings, given[i].halvings);
  }
  EXPECT_NEAR((Vector2(splits->GetPoint(2)) - strokes[3].points.front()).norm(), 1.5, 1e-9);
  const vtkIdType before = chain.polyline->GetOutput()->GetNumberOfPoints();
  chain.polyline->SetSplitsData(splits);
  chain.mesh->Update();
  EXPECT_GT(chain.polyline->GetOutput()->GetNumberOfPoints(), before);
  WriteSplits({ { 0, 0.0, 1.0, 65 } }, strokes, splits);
  splits->Modified();
  expectRefusal(
    chain.polyline, Failure::BadStroke, "Split 0 has no finite ParamStart and ParamEnd, or Halvings outside");
  WriteSplits({ { 4, 0.0, 1.0, 1 } }, strokes, splits);
  vtkIntArray::SafeDownCast(splits->GetCellData()->GetArray("StrokeId"))->SetValue(0, 7);
  splits->GetCellData()->GetArray("StrokeId")->Modified();
  splits->Modified();
  expectRefusal(chain.polyline, Failure::BadStroke, "The splits name stroke 7, but there are 5");
}

TEST(CoarseMeshFilter, RefusesWhatIsNoDrawing)
{
  Coarse chain(toCurves(bodyWithFeatures()));
  chain.treatment->SetHoles("4");
  chain.quads->Update();
  vtkNew<vtkPolyData> lines, darts;
  const auto changed = [&](const char* name, vtkIdType at, double value)
  {
    lines->DeepCopy(chain.polyline->GetOutput());
    vtkDataArray* array = lines->GetCellData()->GetArray(name);
    (array ? array : lines->GetPointData()->GetArray(name))->SetComponent(at, 0, value);
    lines->Modified();
    return lines.Get();
  };
  vtkNew<vtkOversketchCoarseMesh> mesh;
  mesh->SetInputData(changed("Role", 1, 0.0));
  expectRefusal(mesh, Failure::BadStroke, "Polyline 1 has no Role or Treatment");
  mesh->SetInputData(changed("ArcLength", 1, 0.0));
  expectRefusal(mesh, Failure::BadStroke, "Polyline 0 has an ArcLength that does not ascend");
  mesh->SetInputData(changed("StrokeLength", 0, std::nan("")));
  expectRefusal(mesh, Failure::BadStroke, "Polyline 0 has an ArcLength");
  mesh->SetInputData(changed("Closed", 2, 1.0));
  expectRefusal(mesh, Failure::BadStroke, "Polyline 2 is too short, or Closed");
  mesh->SetInputData(changed("RegionId", 4, 7.0));
  expectRefusal(mesh, Failure::BadStroke, "stroke 4 is not where its region is");
  changed("Role", 0, 1.0)->GetPoints()->SetPoint(0, std::nan(""), 0.0, 0.0);
  mesh->SetInputData(lines);
  expectRefusal(mesh, Failure::BadStroke, "Polyline 0 has a point that is not finite");
  mesh->SetInputData(changed("Role", 0, 1.0));
  lines->GetCellData()->RemoveArray("ObjectId");
  expectRefusal(mesh, Failure::MissingArray, "no array ObjectId: take it from vtkOversketchPolyline");
  mesh->SetInputData(changed("Role", 0, 1.0));
  darts->DeepCopy(chain.darts->GetOutput());
  ASSERT_GT(darts->GetNumberOfPoints(), 1);
  darts->GetPoints()->SetPoint(1, 0.0, INFINITY, 0.0);
  mesh->SetDartsData(darts);
  expectRefusal(mesh, Failure::BadStroke, "Dart 1 is not finite");

  chain.darts->SetInputData(changed("Role", 0, 1.0));
  chain.darts->SetDistanceConnection(nullptr);
  expectRefusal(chain.darts, Failure::MissingArray, "There is no distance image to throw darts in");
  chain.polyline->SetDistanceConnection(nullptr);
  expectRefusal(chain.polyline, Failure::MissingArray, "There is no distance image");
  vtkNew<vtkPolyData> none;
  for (vtkPolyDataAlgorithm* step : { static_cast<vtkPolyDataAlgorithm*>(chain.polyline),
         static_cast<vtkPolyDataAlgorithm*>(chain.darts),
         static_cast<vtkPolyDataAlgorithm*>(mesh) })
  {
    step->SetInputData(none);
    Ear ear(step);
    step->Update();
    EXPECT_TRUE(ear.errors.empty());
    EXPECT_EQ(step->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(CoarseMeshFilter, RefusesWhatIsNoMesh)
{
  Coarse chain(toCurves(bodyWithFeatures()));
  chain.mesh->Update();
  vtkNew<vtkPolyData> faces, edges;
  vtkNew<vtkOversketchQuadMerge> quads;
  quads->SetInputData(faces);
  quads->SetEdgesData(edges);
  const auto fresh = [&]
  {
    faces->DeepCopy(chain.mesh->GetOutput());
    edges->DeepCopy(chain.mesh->GetEdgesOutput());
    faces->Modified();
    edges->Modified();
  };
  fresh();
  faces->GetPointData()->GetArray("BoundaryKind")->SetComponent(3, 0, 5.0);
  expectRefusal(quads, Failure::BadMesh, "Point 3 has no BoundaryKind");
  fresh();
  faces->GetPoints()->SetPoint(2, 0.0, std::nan(""), 0.0);
  expectRefusal(quads, Failure::BadMesh, "Point 2 is not finite");
  fresh();
  faces->GetPointData()->RemoveArray("StrokeParam");
  expectRefusal(quads, Failure::MissingArray, "no array StrokeParam");
  fresh();
  const vtkIdType five[5] = { 0, 1, 2, 3, 4 };
  vtkNew<vtkCellArray> polys;
  for (vtkIdType i = 0; i < faces->GetNumberOfPolys(); ++i)
    polys->InsertNextCell(i == 1 ? 5 : 3, five);
  faces->SetPolys(polys);
  expectRefusal(quads, Failure::BadMesh, "Face 1 is neither a triangle nor a quad");
  fresh();
  edges->GetCellData()->GetArray("ParamEnd")->SetComponent(4, 0, INFINITY);
  expectRefusal(quads, Failure::BadMesh, "Edge 4 has no finite ParamStart and ParamEnd");
  fresh();
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = 0; i < edges->GetNumberOfLines(); ++i)
    lines->InsertNextCell(i == 2 ? 3 : 2, five);
  edges->SetLines(lines);
  expectRefusal(quads, Failure::BadMesh, "Edge 2 is not between two points of the mesh");
  fresh();
  quads->Update();
  EXPECT_EQ(quads->GetErrorCode(), 0u);
  EXPECT_EQ(quads->GetEdgesOutput()->GetNumberOfLines(), edges->GetNumberOfLines());
}

TEST(CoarseMeshFilter, CanBeCancelled)
{
  Coarse chain(toCurves(bodyWithFeatures()));
  chain.treatment->SetHoles("4");
  chain.distance->Update();
  expectCancel(chain.polyline);
  chain.polyline->Update();
  expectCancel(chain.darts);
  chain.darts->Update();
  EXPECT_GT(chain.darts->GetOutput()->GetNumberOfPoints(), 5);
  expectCancel(chain.mesh);
  chain.mesh->Update();
  EXPECT_GT(chain.mesh->GetOutput()->GetNumberOfPolys(), 20);
}
