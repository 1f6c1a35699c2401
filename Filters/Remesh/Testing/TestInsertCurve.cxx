#include "CurveChain.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchMeanEdge.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View front = perspectiveView(Vector3(0, 0, 5), Vector3(0, 1, 0), 30.0);
const View side = orthographicView(Vector3(1, 0.3, 0.2), Vector3(0, 1, 0), 220.0);

std::vector<Vector2> ringAt(const Vector2& centre, double radius)
{
  return circleOf(centre, radius, 90);
}

// A sphere with arrays of all kinds: what varies evenly, labels, colours of cells, ids.
vtkSmartPointer<vtkPolyData> dressedSphere(int levels = 4)
{
  const Mesh mesh = icosphere(levels);
  const std::vector<Vector3> normals = mesh.points;
  auto polyData = toPolyData(mesh, &normals);
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName("Globals");
  for (vtkIdType i = 0; i < polyData->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(3.0 * polyData->GetPoint(i)[0] + 1.0);
    label->InsertNextValue(polyData->GetPoint(i)[0] > 0.0 ? 7 : 3);
    globalIds->InsertNextValue(i);
  }
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("Cell");
  for (vtkIdType i = 0; i < polyData->GetNumberOfPolys(); ++i)
  {
    cells->InsertNextValue(i);
  }
  polyData->GetPointData()->AddArray(height);
  polyData->GetPointData()->AddArray(label);
  polyData->GetPointData()->SetGlobalIds(globalIds);
  polyData->GetCellData()->AddArray(cells);
  return polyData;
}

void expectSameBits(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      ASSERT_EQ(a->GetComponent(i, c), b->GetComponent(i, c));
    }
  }
}

// The curve's points are its vertices, and its segments edges.
void expectChain(vtkPolyData* mesh, vtkPolyData* curves, vtkIdType cell)
{
  const MeshCurve curve = curveOfCell(curves, cell);
  EXPECT_TRUE(soundCurve(curve));
  EXPECT_EQ(looseSegments(MeshOf(mesh), curve), 0);
  vtkNew<vtkIdList> ids;
  curves->GetLines()->GetCellAtId(cell, ids);
  for (int i = 0; i < curve.count(); ++i)
  {
    EXPECT_EQ(Vector3(curves->GetPoint(ids->GetId(i))), Vector3(mesh->GetPoint(curve.vertices[i])));
  }
}

} // namespace

TEST(InsertCurve, ArraysOfMeshAndCurves)
{
  const auto mesh = dressedSphere();
  const auto strokes =
    toStrokes({ { straight({ 330, 270 }, { 470, 330 }, 30), front }, { ringAt({ 400, 300 }, 110), side } },
      { false, true });
  CurveChain chain(mesh, strokes);
  chain.Insert->Update();
  vtkPolyData* output = chain.Insert->GetOutput();
  vtkPolyData* curves = chain.Insert->GetCurvesOutput();
  ASSERT_EQ(curves->GetNumberOfLines(), 2);
  expectChain(output, curves, 0);
  expectChain(output, curves, 1);
  EXPECT_FALSE(curveOfCell(curves, 0).closed);
  EXPECT_TRUE(curveOfCell(curves, 1).closed);
  EXPECT_EQ(curves->GetCellData()->GetArray("StrokeId")->GetComponent(1, 0), 1.0);
  EXPECT_EQ(curves->GetCellData()->GetArray("Closed")->GetComponent(1, 0), 1.0);
  EXPECT_EQ(curves->GetCellData()->GetArray("ViewTransform")->GetNumberOfTuples(), 2);
  EXPECT_EQ(curves->GetFieldData()->GetArray("NurbsDegree")->GetComponent(1, 0), 3.0);
  EXPECT_EQ(curves->GetFieldData()->GetArray("NurbsKnots")->GetNumberOfValues(),
    curves->GetFieldData()->GetArray("NurbsPoints")->GetNumberOfTuples() + 8);
  EXPECT_EQ(eulerNumber(MeshOf(output).triangles), 2);
  EXPECT_EQ(chain.Insert->GetStoredOutput()->GetNumberOfPoints(), 0);

  vtkPointData* points = output->GetPointData();
  EXPECT_EQ(points->GetGlobalIds(), nullptr);
  vtkDataArray* height = points->GetArray("Height");
  vtkDataArray* normals = points->GetNormals();
  ASSERT_TRUE(height && normals && points->GetArray("Label"));
  int mixed = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vector3 place(output->GetPoint(i));
    Vector3 normal;
    normals->GetTuple(i, normal.data());
    EXPECT_NEAR(height->GetComponent(i, 0), 3.0 * place[0] + 1.0, 1e-12);
    EXPECT_NEAR(normal.norm(), 1.0, 1e-12);
    EXPECT_GT(normal.dot(place), 0.99);
    const double label = points->GetArray("Label")->GetComponent(i, 0);
    EXPECT_TRUE(label == 7.0 || label == 3.0);
    mixed += place.norm() < 1.0 - 1e-9; // within a triangle
  }
  EXPECT_GT(mixed, 20);
  // Every triangle lies in the one that it says.
  const SurfaceRays surface(std::make_shared<const Mesh>(MeshOf(mesh)));
  const Mesh made = MeshOf(output);
  int beside = 0;
  for (int t = 0; t < made.triangleCount(); ++t)
  {
    const Triangle& c = made.triangles[t];
    const Vector3 middle = (made.points[c[0]] + made.points[c[1]] + made.points[c[2]]) / 3.0;
    const int source = static_cast<int>(output->GetCellData()->GetArray("Cell")->GetComponent(t, 0));
    beside += surface.closest(middle).at.triangle != source;
  }
  EXPECT_LT(beside, made.triangleCount() / 50); // flips and collapses at the curves
}

TEST(InsertCurve, AStoredCurveIsCarriedAndSoAreTheSteps)
{
  const auto mesh = dressedSphere();
  CurveChain reference(mesh, toStroke(straight({ 340, 280 }, { 460, 320 }, 30), front));
  reference.Insert->Update();
  // The boundary is drawn over what the reference has made of the mesh, and crosses the reference's line.
  CurveChain boundary(
    reference.Insert->GetOutput(), toStrokes({ { ringAt({ 400, 300 }, 120), front } }, { true }));
  boundary.Insert->SetStoredConnection(reference.Insert->GetOutputPort(1));
  boundary.Insert->Update();
  vtkPolyData* stored = boundary.Insert->GetStoredOutput();
  ASSERT_EQ(stored->GetNumberOfLines(), 1);
  expectChain(boundary.Insert->GetOutput(), stored, 0);
  expectChain(boundary.Insert->GetOutput(), boundary.Insert->GetCurvesOutput(), 0);
  EXPECT_EQ(stored->GetCellData()->GetArray("StrokeId")->GetNumberOfTuples(), 1);
  const Mesh result = MeshOf(boundary.Insert->GetOutput());
  const std::vector<Triangle> region =
    sideOf(result, curveOfCell(boundary.Insert->GetCurvesOutput(), 0), seenAt(result, front, { 400, 300 }));
  EXPECT_EQ(eulerNumber(region), 1);

  // Asked again, the same arrays; nothing above what has changed runs.
  vtkPoints* kept = boundary.Insert->GetOutput()->GetPoints();
  boundary.Insert->Modified();
  boundary.Insert->Update();
  EXPECT_EQ(boundary.Insert->GetOutput()->GetPoints(), kept);
  EXPECT_EQ(boundary.Insert->GetInsertionCount(), 1);
  boundary.Insert->CleanOff();
  boundary.Insert->Update();
  EXPECT_EQ(boundary.Insert->GetInsertionCount(), 2);
  EXPECT_EQ(boundary.Project->GetProjectionCount(), 1);
  boundary.Project->SetSpacing(4.0);
  boundary.Insert->Update();
  EXPECT_EQ(boundary.Project->GetProjectionCount(), 2);
  EXPECT_EQ(boundary.Project->GetSceneCount(), 1);
  EXPECT_EQ(boundary.Insert->GetInsertionCount(), 3);
  // Without curves mesh and stored curves pass.
  vtkNew<vtkPolyData> none;
  boundary.Insert->SetCurvesData(none);
  boundary.Insert->Update();
  EXPECT_EQ(
    boundary.Insert->GetOutput()->GetNumberOfPoints(), reference.Insert->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(boundary.Insert->GetStoredOutput()->GetNumberOfLines(), 1);
  EXPECT_EQ(boundary.Insert->GetCurvesOutput()->GetNumberOfPoints(), 0);
  std::ostringstream text;
  boundary.Insert->Print(text);
  boundary.Project->Print(text);
  boundary.Fit->Print(text);
  for (const char* line : { "Snap: On", "Clean: Off", "InsertionCount: 3", "Spacing: 4", "CutLoops: On" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}

TEST(InsertCurve, ThreadsDoNotMatter)
{
  const auto mesh = toPolyData(torus(1.0, 0.4, 90, 45));
  vtkSmartPointer<vtkPolyData> results[2], curves[2];
  for (int threads = 1; threads <= 2; ++threads)
  {
    vtkSMPTools::Initialize(threads);
    CurveChain chain(mesh, toStroke(ringAt({ 480, 340 }, 70), front));
    chain.Fit->ClosedOn();
    chain.Insert->Update();
    results[threads - 1] = chain.Insert->GetOutput();
    curves[threads - 1] = chain.Insert->GetCurvesOutput();
  }
  vtkSMPTools::Initialize();
  ASSERT_GT(curves[0]->GetNumberOfPoints(), 20);
  expectSameBits(results[0]->GetPoints()->GetData(), results[1]->GetPoints()->GetData());
  expectSameBits(
    results[0]->GetPolys()->GetConnectivityArray(), results[1]->GetPolys()->GetConnectivityArray());
  expectSameBits(
    curves[0]->GetPointData()->GetArray("VertexId"), curves[1]->GetPointData()->GetArray("VertexId"));
  expectSameBits(
    curves[0]->GetPointData()->GetArray("CurveT"), curves[1]->GetPointData()->GetArray("CurveT"));
}

TEST(InsertCurve, AnOpenStrokeTakesItsLongestRunAndSaysSo)
{
  Mesh plates =
    gridSurface(6, 6, false, false, [](double u, double v) { return Vector3(u - 1.2, 2 * v - 1, 0); });
  plates = joined(plates,
    gridSurface(6, 6, false, false, [](double u, double v) { return Vector3(0.5 * u, 2 * v - 1, 0); }),
    Vector3::Zero());
  CurveChain chain(toPolyData(plates), toStroke(straight({ 200, 300 }, { 600, 310 }, 90), front));
  Ear ear(chain.Project);
  chain.Insert->Update();
  ASSERT_EQ(ear.warnings.size(), 1u);
  EXPECT_NE(ear.warnings[0].find("in 2 parts"), std::string::npos) << ear.warnings[0];
  ASSERT_EQ(chain.Insert->GetCurvesOutput()->GetNumberOfLines(), 1);
  EXPECT_LT(chain.Insert->GetCurvesOutput()->GetBounds()[1], 0.0);
}

TEST(InsertCurve, RefusesABadHandByName)
{
  const auto mesh = toPolyData(icosphere(3));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vector2> good = straight({ 330, 270 }, { 470, 330 }, 30);
  {
    CurveChain chain(mesh, toStroke(good, front));
    const auto fit = [&](vtkPolyData* strokes, const char* words)
    {
      chain.Fit->SetInputData(strokes);
      expectRefusal(chain.Fit, Failure::BadStroke, words);
    };
    fit(toStroke({ { 400, 300 } }, front), "Stroke 0 cannot be used");
    fit(toStroke({ { 400, 300 }, { 400, 300 } }, front), "fewer than two samples that differ");
    fit(toStroke({ { 400, 300 }, { 410, nan }, { 420, 300 } }, front), "not finite");
    fit(toStrokes({ { good, front }, { { { 0, 0 }, { 1e7, 0 } }, front } }),
      "Stroke 1 cannot be used: it is longer");
    fit(toStrokes({ { ringAt({ 400, 300 }, 3), front } }, { true }), "fewer than two samples that differ");
    fit(toStrokes({ { { { 400, 300 }, { 420, 300 }, { 401, 302 } }, front } }, { true }),
      "A closed curve needs 3 points");
    chain.Fit->SetInputData(toStroke(straight({ 5, 5 }, { 60, 9 }, 20), front));
    expectRefusal(
      chain.Project, Failure::BadStroke, "Stroke 0 cannot be used: nothing of it lies on the mesh");
    const auto blind = toStroke(good, front);
    blind->GetCellData()->RemoveArray("ViewTransform");
    chain.Fit->SetInputData(blind);
    expectRefusal(chain.Project, Failure::MissingArray, "ViewTransform");
    chain.Fit->SetInputData(toStroke(good, front));
    chain.Project->SetSpacing(nan);
    expectRefusal(chain.Project, Failure::BadStroke, "Spacing");
    chain.Project->SetSpacing(0.0);
    expectCancel(chain.Project);
    chain.Project->Update();
    EXPECT_GT(chain.Project->GetOutput()->GetNumberOfPoints(), 5);
    expectCancel(chain.Insert);
    chain.Insert->Update();
    EXPECT_GT(chain.Insert->GetOutput()->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  }
  {
    // Two samples make a line; half beside the model, without bridges, no region.
    CurveChain chain(mesh, toStroke({ { 350, 300 }, { 450, 300 } }, front));
    chain.Insert->Update();
    EXPECT_EQ(chain.Insert->GetCurvesOutput()->GetNumberOfLines(), 1);
    chain.Fit->SetInputData(toStrokes({ { ringAt({ 640, 300 }, 90), front } }, { true }));
    chain.Insert->BridgeOff();
    expectRefusal(chain.Insert, Failure::BadStroke, "Curve 0 cannot be used: it has to be closed");
    chain.Insert->BridgeOn();
    chain.Insert->Update();
    EXPECT_EQ(chain.Insert->GetBridgeCount(), 1);
    EXPECT_EQ(chain.Insert->GetCurvesOutput()->GetNumberOfLines(), 1);
  }
  {
    CurveChain chain(mesh, toStroke(good, front));
    chain.Project->Update();
    vtkNew<vtkOversketchInsertCurve> insert;
    const auto refused = [&](const char* array, bool points, Failure failure, const char* words)
    {
      vtkNew<vtkPolyData> curves;
      curves->ShallowCopy(chain.Project->GetOutput());
      (points ? static_cast<vtkFieldData*>(curves->GetPointData()) : curves->GetCellData())
        ->RemoveArray(array);
      insert->SetInputData(mesh);
      insert->SetCurvesData(curves);
      expectRefusal(insert, failure, words);
    };
    refused("CurveT", true, Failure::MissingArray, "CurveT");
    refused("MeshCell", true, Failure::MissingArray, "MeshCell");
    refused("MeshWeights", true, Failure::MissingArray, "MeshWeights");
    refused("Closed", false, Failure::MissingArray, "Closed");
    refused("ProjectionTransform", false, Failure::MissingArray, "ProjectionTransform");
    insert->SetInputData(toPolyData(icosphere(4)));
    insert->SetCurvesData(chain.Project->GetOutput());
    expectRefusal(insert, Failure::BadMesh, "project the curves on this mesh");
    // Stored curves of another mesh.
    CurveChain other(toPolyData(icosphere(2)), toStroke(good, front));
    other.Insert->Update();
    insert->SetInputData(mesh);
    insert->SetStoredConnection(other.Insert->GetOutputPort(1));
    expectRefusal(insert, Failure::BadStroke, "Stored curve 0");
  }
  {
    vtkNew<vtkPolyData> none;
    CurveChain chain(none, toStroke(good, front));
    chain.Insert->Update();
    EXPECT_EQ(chain.Insert->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(chain.Insert->GetErrorCode(), 0u);
  }
}

TEST(InsertCurve, AsPublishedPointsAreVerticesAndNoMore)
{
  const auto mesh = toPolyData(icosphere(5));
  CurveChain chain(mesh, toStrokes({ { ringAt({ 400, 300 }, 120), front } }, { true }));
  chain.Project->SetSpacing(4.0);
  chain.Insert->SnapOff();
  chain.Insert->EmbedSegmentsOff();
  chain.Insert->CleanOff();
  chain.Insert->BridgeOff();
  chain.Insert->Update();
  const vtkIdType samples = chain.Project->GetOutput()->GetNumberOfPoints();
  EXPECT_EQ(chain.Insert->GetCurvesOutput()->GetNumberOfPoints(), samples);
  EXPECT_EQ(chain.Insert->GetOutput()->GetNumberOfPoints(), mesh->GetNumberOfPoints() + samples);
  EXPECT_EQ(chain.Insert->GetOutput()->GetNumberOfPolys(), mesh->GetNumberOfPolys() + 2 * samples);
}

TEST(MeanEdge, IsThatOfTheMeshAsItWasLoaded)
{
  // A grid of 4 x 4 unit squares: 40 sides and 16 diagonals.
  const auto grid =
    toPolyData(gridSurface(4, 4, false, false, [](double u, double v) { return Vector3(4 * u, 4 * v, 0); }));
  vtkNew<vtkOversketchMeanEdge> mean;
  mean->SetInputData(grid);
  mean->Update();
  const auto valueOf = [](vtkPolyData* mesh)
  { return mesh->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0); };
  const double loaded = valueOf(mean->GetOutput());
  EXPECT_NEAR(loaded, (40.0 + 16.0 * std::sqrt(2.0)) / 56.0, 1e-14);
  EXPECT_EQ(grid->GetFieldData()->GetNumberOfArrays(), 0);
  // Ten curves later it is the same.
  const View above = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 60.0);
  vtkSmartPointer<vtkPolyData> mesh = mean->GetOutput();
  for (int i = 0; i < 10; ++i)
  {
    CurveChain chain(
      mesh, toStroke(straight({ 410.0 + 12 * i, 310 }, { 500.0 + 10 * i, 420.0 + 7 * i }, 20), above));
    chain.Insert->Update();
    vtkNew<vtkOversketchMeanEdge> again;
    again->SetInputConnection(chain.Insert->GetOutputPort());
    again->Update();
    mesh = again->GetOutput();
    EXPECT_EQ(valueOf(mesh), loaded);
  }
  EXPECT_GT(mesh->GetNumberOfPoints(), 2 * grid->GetNumberOfPoints());
  vtkNew<vtkDoubleArray> wrong;
  wrong->SetName("MeanEdge");
  wrong->InsertNextValue(-1.0);
  grid->GetFieldData()->AddArray(wrong);
  grid->Modified();
  expectRefusal(mean, Failure::MissingArray, "MeanEdge");
  vtkNew<vtkPolyData> loose;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1, 2, 3);
  loose->SetPoints(points);
  mean->SetInputData(loose);
  expectRefusal(mean, Failure::BadMesh, "No edge");
  mean->SetInputData(vtkNew<vtkPolyData>());
  mean->Update();
  EXPECT_EQ(mean->GetErrorCode(), 0u);
}
