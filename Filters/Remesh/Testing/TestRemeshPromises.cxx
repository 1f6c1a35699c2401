// What every filter promises, for vtkOversketchRemesh: data carried over, the same bits, errors, cancelling.
#include "RemeshTools.h"

#include "vtkSMPTools.h"

#include <sstream>

using namespace oversketch_test;

TEST(Remesh, DataAreCarriedOver)
{
  const Mesh mesh = icosphere(3);
  std::vector<Vector3> normals = mesh.points;
  const auto input = withRegion(mesh, upperHalf);
  input->GetPointData()->SetNormals(toPolyData(mesh, &normals)->GetPointData()->GetNormals());
  std::vector<double> linear;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("Cells");
  for (const Vector3& p : mesh.points)
  {
    linear.push_back(1.0 + p[0] - 2.0 * p[1]);
    ids->InsertNextValue(ids->GetNumberOfTuples());
  }
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    cells->InsertNextValue(t);
  }
  input->GetPointData()->SetScalars(doubles("Linear", linear));
  input->GetPointData()->SetGlobalIds(ids);
  input->GetCellData()->AddArray(cells);
  input->GetFieldData()->AddArray(doubles("Note", { 7.0 }));
  const auto content = contentOf(input);
  Remeshed stretch(input, vtkOversketchRemesh::Stretch, handlesOn(input, 0.4, 1.0));
  const auto output = stretch.run();
  EXPECT_EQ(contentOf(input), content);
  ASSERT_NE(output->GetPointData()->GetScalars(), nullptr);
  ASSERT_NE(output->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(output->GetPointData()->GetGlobalIds(), nullptr);
  EXPECT_EQ(output->GetFieldData()->GetArray("Note")->GetComponent(0, 0), 7.0);
  EXPECT_EQ(
    output->GetFieldData()->GetArray("GuideLength")->GetComponent(0, 0), stretch.filter->GetGuideLength());
  EXPECT_EQ(input->GetFieldData()->GetArray("GuideLength"), nullptr);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vector3 p(output->GetPoint(i)), n(output->GetPointData()->GetNormals()->GetTuple(i));
    EXPECT_NEAR(output->GetPointData()->GetScalars()->GetComponent(i, 0), 1.0 + p[0] - 2.0 * p[1], 1e-12);
    EXPECT_NEAR(n.norm(), 1.0, 1e-12);
    EXPECT_GT(n.dot(p.normalized()), 0.999);
  }
  // The cell data come from the triangle under the middle: its own middle is within a triangle's size.
  for (vtkIdType t = 0; t < output->GetNumberOfCells(); ++t)
  {
    const int from = static_cast<int>(output->GetCellData()->GetArray("Cells")->GetComponent(t, 0));
    const Triangle& s = mesh.triangles[from];
    vtkIdType count = 0;
    const vtkIdType* c = nullptr;
    output->GetPolys()->GetCellAtId(t, count, c);
    const Vector3 middle =
      (Vector3(output->GetPoint(c[0])) + Vector3(output->GetPoint(c[1])) + Vector3(output->GetPoint(c[2]))) /
      3.0;
    const Vector3 sourceMiddle = (mesh.points[s[0]] + mesh.points[s[1]] + mesh.points[s[2]]) / 3.0;
    EXPECT_LT((middle - sourceMiddle).norm(), (mesh.points[s[0]] - mesh.points[s[1]]).norm());
  }
}

TEST(Remesh, SameBitsForAnyNumberOfThreadsColdOrKept)
{
  const auto input = withRegion(icosphere(4), upperHalf, 0.1);
  const auto handles = handlesOn(input, 0.5, 1.0);
  std::vector<std::vector<double>> results;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&] { results.push_back(contentOf(Remeshed(input, vtkOversketchRemesh::Stretch, handles).run())); });
  }
  EXPECT_EQ(results[0], results[1]);

  Remeshed stretch(input, vtkOversketchRemesh::Stretch, handles);
  EXPECT_EQ(contentOf(stretch.run()), results[0]);
  EXPECT_EQ(stretch.filter->GetRemeshCount(), 1);
  vtkPoints* points = stretch.filter->GetOutput()->GetPoints();
  vtkDataArray* region = stretch.filter->GetOutput()->GetPointData()->GetArray("Region");
  // A new colour, a moved target: found again. Another length: remeshed.
  vtkNew<vtkPolyData> coloured;
  coloured->ShallowCopy(input);
  coloured->GetPointData()->AddArray(doubles("Colour", std::vector<double>(input->GetNumberOfPoints(), 0.5)));
  stretch.filter->SetInputData(coloured);
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(handles);
  moved->GetPointData()->GetArray("Target")->FillComponent(1, 9.0);
  stretch.filter->SetHandlesData(moved);
  stretch.filter->Update();
  EXPECT_EQ(stretch.filter->GetRemeshCount(), 1);
  EXPECT_EQ(stretch.filter->GetOutput()->GetPoints(), points);
  EXPECT_EQ(stretch.filter->GetOutput()->GetPointData()->GetArray("Region"), region);
  ASSERT_NE(stretch.filter->GetOutput()->GetPointData()->GetArray("Colour"), nullptr);
  EXPECT_EQ(stretch.filter->GetHandlesOutput()->GetPointData()->GetArray("Target")->GetComponent(0, 1), 9.0);
  moved->GetFieldData()->GetArray("TargetLength")->FillComponent(0, 1.5);
  moved->Modified();
  stretch.filter->Update();
  EXPECT_EQ(stretch.filter->GetRemeshCount(), 2);
}

TEST(Remesh, SourcesOfWhatCouldChangeAreThoseOfAll)
{
  const auto input = withRegion(icosphere(4), upperHalf, 0.1);
  const auto handles = handlesOn(input, 0.5, 1.0);
  Remeshed all(input, vtkOversketchRemesh::Stretch, handles),
    some(input, vtkOversketchRemesh::Stretch, handles);
  some.filter->SourcesOfAllOff();
  const auto whole = all.run(), part = some.run();
  EXPECT_EQ(MeshOf(whole).points, MeshOf(part).points);
  EXPECT_EQ(MeshOf(whole).triangles, MeshOf(part).triangles);
  EXPECT_EQ(part->GetCellData()->GetArray("SourceCell"), nullptr);
  EXPECT_EQ(part->GetCellData()->GetArray("SourceWeights"), nullptr);
  EXPECT_EQ(whole->GetFieldData()->GetArray("SourceCell"), nullptr);
  EXPECT_EQ(whole->GetFieldData()->GetArray("UnchangedCell"), nullptr);
  vtkDataArray* const cells = whole->GetCellData()->GetArray("SourceCell");
  vtkDataArray* const weights = whole->GetCellData()->GetArray("SourceWeights");
  vtkFieldData* const fields = part->GetFieldData();
  for (const char* name : { "SourceCell", "SourceWeights", "UnchangedCell" })
  {
    ASSERT_NE(fields->GetArray(name), nullptr) << name;
  }
  const vtkIdType unchanged = fields->GetArray("UnchangedCell")->GetNumberOfTuples();
  const vtkIdType count = whole->GetNumberOfPolys();
  EXPECT_GT(unchanged, 100);
  EXPECT_EQ(fields->GetArray("SourceCell")->GetNumberOfTuples(), count - unchanged);
  for (vtkIdType t = 0; t < count; ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(cells->GetComponent(t, c),
        t < unchanged ? fields->GetArray("UnchangedCell")->GetComponent(t, 0)
                      : fields->GetArray("SourceCell")->GetComponent(t - unchanged, c));
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_EQ(weights->GetComponent(t, 3 * c + k),
          t < unchanged ? double(k == c)
                        : fields->GetArray("SourceWeights")->GetComponent(t - unchanged, 3 * c + k));
      }
    }
  }
  // Another remeshing does not pass on an earlier one's.
  Remeshed next(part, vtkOversketchRemesh::Restore);
  const auto restored = next.run();
  EXPECT_EQ(restored->GetFieldData()->GetArray("UnchangedCell"), nullptr);
  EXPECT_EQ(restored->GetFieldData()->GetArray("SourceCell"), nullptr);
  EXPECT_NE(restored->GetCellData()->GetArray("SourceCell"), nullptr);
}

TEST(Remesh, ReleasedWorkIsMadeAnew)
{
  const auto input = withRegion(icosphere(4), upperHalf, 0.1);
  Remeshed stretch(input, vtkOversketchRemesh::Stretch, handlesOn(input, 0.5, 1.0));
  const auto content = contentOf(stretch.run());
  stretch.filter->ReleaseWork();
  EXPECT_EQ(stretch.filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(stretch.filter->GetHandlesOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(contentOf(stretch.run()), content);
  EXPECT_GT(stretch.filter->GetHandlesOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(stretch.filter->GetRemeshCount(), 2);
}

TEST(Remesh, RefusesWhatItCannotRead)
{
  struct Case
  {
    std::string word;
    Failure failure;
    std::function<void(vtkPolyData*, vtkPolyData*)> spoil;
  };
  const std::vector<Case> cases = {
    { "Region",
      Failure::MissingArray,
      [](vtkPolyData* m, vtkPolyData*) { m->GetPointData()->RemoveArray("Region"); } },
    { "ShapeDiameter",
      Failure::MissingArray,
      [](vtkPolyData* m, vtkPolyData*) { m->GetPointData()->RemoveArray("ShapeDiameter"); } },
    { "Region",
      Failure::MissingArray,
      [](vtkPolyData* m, vtkPolyData*)
      {
        m->GetPointData()->AddArray(
          doubles("Region", std::vector<double>(3 * m->GetNumberOfPoints(), 1.0), 3));
      } },
    { "Point 3",
      Failure::BadMesh,
      [](vtkPolyData* m, vtkPolyData*) { m->GetPoints()->SetPoint(3, NAN, 0, 0); } },
    { "Cell",
      Failure::BadMesh,
      [](vtkPolyData* m, vtkPolyData*) {
        m->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
      } },
    { "lines",
      Failure::BadMesh,
      [](vtkPolyData* m, vtkPolyData*)
      {
        vtkNew<vtkCellArray> lines;
        lines->InsertNextCell({ 0, 1 });
        m->SetLines(lines);
      } },
    { "MeshVertices",
      Failure::MissingArray,
      [](vtkPolyData*, vtkPolyData* h) { h->GetPointData()->RemoveArray("MeshVertices"); } },
    { "Point 2",
      Failure::BadMesh,
      [](vtkPolyData*, vtkPolyData* h)
      { h->GetPointData()->GetArray("MeshVertices")->SetComponent(2, 0, 1e6); } },
    { "Point 1",
      Failure::BadMesh,
      [](vtkPolyData*, vtkPolyData* h)
      { h->GetPointData()->GetArray("MeshWeights")->SetComponent(1, 0, NAN); } },
    { "SectionLength",
      Failure::MissingArray,
      [](vtkPolyData*, vtkPolyData* h) { h->GetFieldData()->RemoveArray("SectionLength"); } },
    { "TargetLength",
      Failure::MissingArray,
      [](vtkPolyData*, vtkPolyData* h)
      { h->GetFieldData()->GetArray("TargetLength")->FillComponent(0, 0.0); } },
  };
  for (const Case& c : cases)
  {
    const auto input = withRegion(icosphere(2), upperHalf);
    const auto handles = handlesOn(input, 1.0, 2.0);
    Remeshed stretch(input, vtkOversketchRemesh::Stretch, handles);
    const auto good = contentOf(stretch.run());
    vtkNew<vtkPolyData> badInput, badHandles;
    badInput->DeepCopy(input);
    badHandles->DeepCopy(handles);
    c.spoil(badInput, badHandles);
    stretch.filter->SetInputData(badInput);
    stretch.filter->SetHandlesData(badHandles);
    expectRefusal(stretch.filter, c.failure, c.word);
    EXPECT_EQ(stretch.filter->GetHandlesOutput()->GetNumberOfPoints(), 0);
    stretch.filter->SetInputData(input);
    stretch.filter->SetHandlesData(handles);
    EXPECT_EQ(contentOf(stretch.run()), good);
  }
}

TEST(Remesh, NothingToDoIsNoError)
{
  vtkNew<vtkPolyData> empty;
  Remeshed none(empty, vtkOversketchRemesh::Stretch);
  Ear ear(none.filter);
  EXPECT_EQ(none.run()->GetNumberOfPoints(), 0);
  const auto outside = withRegion(icosphere(2), [](const Vector3&) { return false; });
  Remeshed same(outside, vtkOversketchRemesh::Restore);
  const auto output = same.run();
  expectOutsideUntouched(outside, output);
  EXPECT_EQ(output->GetNumberOfPoints(), outside->GetNumberOfPoints());
  EXPECT_EQ(output->GetNumberOfCells(), outside->GetNumberOfCells());
  EXPECT_TRUE(ear.errors.empty());
}

TEST(Remesh, ACancelledRunIsSilentAndARetryComplete)
{
  const auto input = withRegion(icosphere(4), upperHalf);
  const auto whole =
    contentOf(Remeshed(input, vtkOversketchRemesh::Stretch, handlesOn(input, 0.5, 1.0)).run());
  Remeshed stretch(input, vtkOversketchRemesh::Stretch, handlesOn(input, 0.5, 1.0));
  expectCancel(stretch.filter, 0.4);
  EXPECT_EQ(stretch.filter->GetRemeshCount(), 0);
  EXPECT_EQ(contentOf(stretch.run()), whole);
}

TEST(Remesh, PrintsEveryParameter)
{
  vtkNew<vtkOversketchRemesh> filter;
  std::ostringstream os;
  filter->Print(os);
  for (const char* name :
    { "Stage: ", "Iterations: 5", "LimitByDiameter: On", "ProtectSection: On", "KeepSmooth: On" })
  {
    EXPECT_NE(os.str().find(name), std::string::npos) << name;
  }
}
