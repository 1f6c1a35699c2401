#include "match_chain.h"

#include "vtkSMPTools.h"

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View view = perspectiveView(Vector3(1, 2, 4), up, 35.0);

vtkSmartPointer<vtkPolyData> anyStroke(double shift = 0.0)
{
  std::vector<Vector2> samples;
  for (int i = 0; i <= 100; ++i)
    samples.emplace_back(420 + 210 * std::cos(0.02 * i) + shift, 300 + 210 * std::sin(0.02 * i));
  return toStroke(samples, view);
}

bool same(vtkPolyData* a, vtkPolyData* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() || a->GetNumberOfLines() != b->GetNumberOfLines())
    return false;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    if (pointOf(a, i) != pointOf(b, i))
      return false;
    for (int k = 0; k < a->GetPointData()->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* values = a->GetPointData()->GetArray(k);
      for (int c = 0; c < values->GetNumberOfComponents(); ++c)
        if (values->GetComponent(i, c) != b->GetPointData()->GetArray(k)->GetComponent(i, c))
          return false;
    }
  }
  return true;
}

} // namespace

TEST(OutlineFilter, LoopsCarryTheSilhouetteAndLieWhereTheySay)
{
  const auto mesh = toPolyData(torus(1.0, 0.4, 96, 48));
  Chain chain(mesh, anyStroke(), true);
  vtkPolyData* outline = chain.outline->GetOutput();
  ASSERT_EQ(outline->GetNumberOfLines(), 2);
  EXPECT_EQ(outline->GetCellData()->GetArray("Hole")->GetComponent(0, 0), 0.0);
  EXPECT_EQ(outline->GetCellData()->GetArray("Hole")->GetComponent(1, 0), 1.0);
  vtkIdType bound = 0;
  double largest = 0.0;
  for (vtkIdType i = 0; i < outline->GetNumberOfPoints(); ++i)
  {
    Vector2 display, offset;
    outline->GetPointData()->GetArray("Display")->GetTuple(i, display.data());
    outline->GetPointData()->GetArray("Offset")->GetTuple(i, offset.data());
    EXPECT_NEAR((view.toDisplay(pointOf(outline, i)).head<2>() - display - offset).norm(), 0.0, 1e-9);
    largest = std::max(largest, offset.norm());
    const Vector3 vertices = tuple(outline, "MeshVertices", i), weights = tuple(outline, "MeshWeights", i);
    if (vertices[0] < 0)
    {
      EXPECT_EQ(vertices, Vector3(-1, -1, -1));
      continue;
    }
    ++bound;
    Vector3 p = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
      p += weights[k] * pointOf(mesh, static_cast<vtkIdType>(vertices[k]));
    EXPECT_NEAR((p - pointOf(outline, i)).norm(), 0.0, 1e-12);
  }
  EXPECT_LE(largest, 3.0);
  // Both curves of the torus are seen whole here: nothing of them is lost.
  EXPECT_GE(bound, 0.97 * static_cast<double>(chain.silhouette->GetOutput()->GetNumberOfPoints()));
}

TEST(OutlineFilter, ANewStrokeInTheSameViewFindsTheLoops)
{
  Chain chain(sphere(3), anyStroke(), true);
  EXPECT_EQ(chain.outline->GetTraceCount(), 1);
  chain.setStroke(anyStroke(15.0));
  EXPECT_EQ(chain.outline->GetTraceCount(), 1);
  chain.setStroke(
    toStroke(arc(orthographicView(front, up, 200.0), 1.1, 10, 80), orthographicView(front, up, 200.0)));
  EXPECT_EQ(chain.outline->GetTraceCount(), 2);
}

TEST(OutlineFilter, ThreadsAndCachesDoNotMatter)
{
  const auto mesh = toPolyData(torus(1.0, 0.4, 192, 96));
  vtkNew<vtkPolyData> results[3];
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    Chain chain(mesh, anyStroke(), true);
    results[threads - 1]->DeepCopy(chain.outline->GetOutput());
    if (threads == 2)
    {
      chain.outline->Modified();
      chain.targets->Update();
      EXPECT_EQ(chain.outline->GetTraceCount(), 1);
      results[2]->DeepCopy(chain.outline->GetOutput());
    }
  }
  vtkSMPTools::Initialize(0);
  EXPECT_TRUE(same(results[0], results[1]));
  EXPECT_TRUE(same(results[0], results[2]));
}

TEST(OutlineFilter, CancelledAndTriedAgain)
{
  const auto mesh = toPolyData(torus(1.0, 0.4, 192, 96));
  Chain whole(mesh, anyStroke(), true);
  Chain chain(mesh, anyStroke(), false);
  expectCancel(chain.outline);
  EXPECT_EQ(chain.outline->GetTraceCount(), 0);
  chain.outline->Update();
  EXPECT_TRUE(same(chain.outline->GetOutput(), whole.outline->GetOutput()));
}

TEST(OutlineFilter, RefusesBadInputs)
{
  Chain chain(sphere(2), anyStroke());
  const auto refuses =
    [&](vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* curves, Failure failure, const char* words)
  {
    vtkNew<vtkOversketchOutline> outline;
    outline->SetInputData(mesh);
    outline->SetStrokeData(stroke);
    outline->SetCurvesData(curves);
    expectRefusal(outline, failure, words);
  };
  vtkPolyData* curves = chain.silhouette->GetOutput();
  const auto broken = sphere(2);
  broken->GetPoints()->SetPoint(7, 0, std::nan(""), 0);
  refuses(broken, anyStroke(), curves, Failure::BadMesh, "Point 7");
  const auto quads = sphere(2);
  quads->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  refuses(quads, anyStroke(), curves, Failure::BadMesh, "not a triangle");
  const auto blind = anyStroke();
  blind->GetCellData()->RemoveArray("ViewTransform");
  refuses(sphere(2), blind, curves, Failure::MissingArray, "ViewTransform");
  // Curves of a larger mesh.
  refuses(sphere(1), anyStroke(), curves, Failure::BadMesh, "MeshVertices");
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(curves);
  bare->GetPointData()->RemoveArray("MeshWeights");
  refuses(sphere(2), anyStroke(), bare, Failure::MissingArray, "MeshWeights");

  vtkNew<vtkPolyData> empty;
  vtkNew<vtkOversketchOutline> outline;
  Ear ear(outline);
  outline->SetInputData(empty);
  outline->SetStrokeData(anyStroke());
  outline->SetCurvesData(empty);
  outline->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(outline->GetOutput()->GetNumberOfPoints(), 0);
}
