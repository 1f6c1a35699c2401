#include "match_chain.h"

#include "Silhouette/targets.h"

#include "vtkIdTypeArray.h"

#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View view = orthographicView(front, up, 200.0);

vtkSmartPointer<vtkPolyData> arcStroke()
{
  return toStroke(arc(view, 1.2, 20.0, 80.0), view);
}

// A sphere behind another one, seen past its right side: the outline changes from one to the other.
Mesh twoLayers(double depth)
{
  return joined(icosphere(4), icosphere(4), Vector3(0.35, 0, depth));
}

} // namespace

TEST(Targets, HandlesAreNumberedBoundAndOnTheMesh)
{
  const auto mesh = sphere(4);
  Chain chain(mesh, arcStroke(), true);
  vtkPolyData* handles = chain.targets->GetOutput();
  const vtkIdType count = handles->GetNumberOfPoints();
  ASSERT_GT(count, 5);
  EXPECT_EQ(handles->GetNumberOfVerts(), count);
  double last = 0.0;
  std::vector<Vector3> section, target;
  for (vtkIdType i = 0; i < count; ++i)
  {
    EXPECT_EQ(vtkIdTypeArray::SafeDownCast(handles->GetPointData()->GetArray("HandleId"))->GetValue(i), i);
    const Vector3 vertices = tuple(handles, "MeshVertices", i), weights = tuple(handles, "MeshWeights", i);
    Vector3 p = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
      p += weights[k] * pointOf(mesh, static_cast<vtkIdType>(vertices[k]));
    EXPECT_NEAR((p - pointOf(handles, i)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(weights.sum(), 1.0, 1e-12);
    const double r = handles->GetPointData()->GetArray("RelativePosition")->GetComponent(i, 0);
    EXPECT_GE(r, last);
    last = r;
    section.push_back(pointOf(handles, i));
    target.push_back(tuple(handles, "Target", i));
  }
  EXPECT_NEAR(field(handles, "SectionLength"), curveLength(section), 1e-12);
  EXPECT_NEAR(field(handles, "TargetLength"), curveLength(target), 1e-12);
  // Points to and fro across a curve by a tenth of their spacing add nothing to speak of.
  std::vector<Vector3> zigzag;
  for (int i = 0; i <= 100; ++i)
    zigzag.emplace_back(0.01 * i, 0.0, i % 2 == 0 ? 0.005 : -0.005);
  EXPECT_NEAR(curveLength(zigzag), 1.0, 0.03); // unsmoothed 1.41
}

TEST(Targets, OmegaBlendsTheEnds)
{
  Chain chain(sphere(5), arcStroke());
  chain.targets->SetOmega(0.5);
  chain.targets->Update();
  vtkPolyData* handles = chain.targets->GetOutput();
  for (vtkIdType i = 0; i < handles->GetNumberOfPoints(); ++i)
  {
    const double r = handles->GetPointData()->GetArray("RelativePosition")->GetComponent(i, 0);
    const Vector3 q = pointOf(handles, i);
    const double moved = (tuple(handles, "Target", i) - q).norm(),
                 whole = (tuple(handles, "UnmergedTarget", i) - q).norm();
    EXPECT_NEAR(moved / whole, std::sqrt(std::min(r, 1.0 - r) / 0.5), 1e-9);
  }
}

TEST(Targets, OffsetsTurnWithTheStroke)
{
  // A straight horizontal section whose points lie 2 px above the loop; the stroke stands upright.
  vtkNew<vtkPolyData> section;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdTypeArray> vertices;
  vertices->SetName("MeshVertices");
  vertices->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> weights, normals, offset;
  weights->SetName("MeshWeights");
  weights->SetNumberOfComponents(3);
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  offset->SetName("Offset");
  offset->SetNumberOfComponents(2);
  const Mesh mesh = icosphere(1);
  lines->InsertNextCell(11);
  for (int i = 0; i <= 10; ++i)
  {
    const Vector3 p = view.toWorld(Vector2(300 + 10 * i, 302), -100.0);
    lines->InsertCellPoint(points->InsertNextPoint(p.data()));
    const double vertex[3] = { 0, 0, 0 }, weight[3] = { 1, 0, 0 }, shift[2] = { 0, 2 };
    vertices->InsertNextTuple(vertex);
    weights->InsertNextTuple(weight);
    normals->InsertNextTuple(weight);
    offset->InsertNextTuple(shift);
  }
  section->SetPoints(points);
  section->SetLines(lines);
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ vertices, weights, normals, offset })
    section->GetPointData()->AddArray(array);
  vtkNew<vtkOversketchTargets> targets;
  targets->SetInputData(section);
  targets->SetStrokeData(toStroke({ { 500, 100 }, { 500, 250 }, { 500, 400 } }, view));
  targets->SetMeshData(toPolyData(mesh));
  targets->Update();
  vtkPolyData* handles = targets->GetOutput();
  ASSERT_EQ(handles->GetNumberOfPoints(), 11);
  for (int i = 0; i <= 10; ++i)
  {
    const Vector3 d = view.toDisplay(tuple(handles, "UnmergedTarget", i));
    EXPECT_NEAR((d.head<2>() - Vector2(498, 100 + 30 * i)).norm(), 0.0, 1e-3)
      << i; // float points in the section
  }
}

TEST(Targets, OneLayerOfTwoThatShareAnOutline)
{
  // The front sphere's outline from 60 to 100 degrees, the rear one's from there to 20: most of it the rear
  // one's.
  const Mesh mesh = twoLayers(-3.0);
  const auto polyData = toPolyData(mesh);
  const int first = icosphere(4).vertexCount();
  std::vector<Vector2> samples;
  for (int i = 0; i <= 300; ++i)
  {
    const double a = (120.0 - 110.0 * i / 300) * pi / 180;
    samples.push_back(view.toDisplay(Vector3(0.175 + 1.25 * std::cos(a), 1.15 * std::sin(a), 0)).head<2>());
  }
  Chain chain(polyData, toStroke(samples, view), true);
  const auto layersOf = [&](vtkPolyData* handles)
  {
    std::set<bool> layers;
    for (vtkIdType i = 0; i < handles->GetNumberOfPoints(); ++i)
      layers.insert(tuple(handles, "MeshVertices", i)[0] >= first);
    return layers;
  };
  EXPECT_EQ(layersOf(chain.targets->GetOutput()), std::set<bool>({ true }));
  const vtkIdType kept = chain.targets->GetOutput()->GetNumberOfPoints();
  chain.targets->SingleLayerOff();
  chain.targets->Update();
  EXPECT_EQ(layersOf(chain.targets->GetOutput()), std::set<bool>({ false, true }));
  EXPECT_GT(chain.targets->GetOutput()->GetNumberOfPoints(), kept);
}

TEST(Targets, AGapInOneLayerDoesNotSplitIt)
{
  // Control points between 45 and 60 degrees are lost; both sides stay, being near each other on the mesh.
  const auto mesh = sphere(5);
  Chain chain(mesh, arcStroke(), true);
  vtkNew<vtkPolyData> section;
  section->DeepCopy(chain.match->GetOutput());
  vtkIdType left = 0;
  for (vtkIdType i = 0; i < section->GetNumberOfPoints(); ++i)
  {
    const double angle = angleOf(pointOf(section, i));
    vtkDataArray* vertices = section->GetPointData()->GetArray("MeshVertices");
    if (angle > 45.0 && angle < 60.0)
      vertices->SetTuple3(i, -1, -1, -1);
    left += vertices->GetComponent(i, 0) >= 0;
  }
  vtkNew<vtkOversketchTargets> targets;
  targets->SetInputData(section);
  targets->SetStrokeData(arcStroke());
  targets->SetMeshData(mesh);
  targets->Update();
  EXPECT_EQ(targets->GetOutput()->GetNumberOfPoints(), left);
}

TEST(Targets, RefusesBadInputs)
{
  Chain chain(sphere(3), arcStroke(), true);
  const auto refuses =
    [&](vtkPolyData* section, vtkPolyData* stroke, vtkPolyData* mesh, Failure failure, const char* words)
  {
    vtkNew<vtkOversketchTargets> targets;
    targets->SetInputData(section);
    targets->SetStrokeData(stroke);
    targets->SetMeshData(mesh);
    expectRefusal(targets, failure, words);
  };
  vtkPolyData* good = chain.match->GetOutput();
  refuses(good, arcStroke(), sphere(1), Failure::BadMesh, "MeshVertices");
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(good);
  bare->GetPointData()->RemoveArray("MeshVertices");
  refuses(bare, arcStroke(), sphere(3), Failure::MissingArray, "MeshVertices");
  refuses(chain.silhouette->GetOutput(), arcStroke(), sphere(3), Failure::BadMesh, "open polyline");
  vtkNew<vtkPolyData> odd;
  odd->DeepCopy(good);
  odd->GetPointData()->GetArray("Display")->SetComponent(2, 0, std::nan(""));
  refuses(odd, arcStroke(), sphere(3), Failure::BadMesh, "Display");
  vtkNew<vtkPolyData> loose;
  loose->DeepCopy(good);
  for (vtkIdType i = 0; i < loose->GetNumberOfPoints(); ++i)
    loose->GetPointData()->GetArray("MeshVertices")->SetTuple3(i, -1, -1, -1);
  refuses(loose, arcStroke(), sphere(3), Failure::NoMatch, "two control points");
  refuses(good, toStroke({ { 9, 9 }, { 9, 9 } }, view), sphere(3), Failure::BadStroke, "no length");

  vtkNew<vtkPolyData> empty;
  vtkNew<vtkOversketchTargets> targets;
  Ear ear(targets);
  targets->SetInputData(empty);
  targets->SetStrokeData(arcStroke());
  targets->SetMeshData(empty);
  targets->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(targets->GetOutput()->GetNumberOfPoints(), 0);
}
