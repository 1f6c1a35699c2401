// Promises of joining: arrays and pictures of parts, one point a place, threads, cancelling, refusals.
#include "Harness/shipped.h"

#include "vtkOversketchAssemble.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchJoin.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

Mesh shifted(Mesh mesh, const Vector3& by)
{
  for (Vector3& p : mesh.points)
  {
    p += by;
  }
  return mesh;
}

// Two balls that overlap, parts 0 and 1, with texture coordinates (x, part) and pictures.
vtkSmartPointer<vtkPolyData> twoBalls(bool wears)
{
  vtkNew<vtkOversketchAssemble> assemble;
  for (const int part : { 0, 1 })
  {
    const Mesh ball = shifted(icosphere(3), { 1.1 * part, 0.2 * part, 0.0 });
    const auto data = toPolyData(ball);
    if (wears)
    {
      vtkNew<vtkDoubleArray> coordinates;
      coordinates->SetName("TCoords");
      coordinates->SetNumberOfComponents(2);
      for (const Vector3& p : ball.points)
      {
        coordinates->InsertNextTuple2(p[0], part);
      }
      data->GetPointData()->SetTCoords(coordinates);
      vtkNew<vtkUnsignedCharArray> picture;
      picture->SetName("Texture");
      picture->InsertNextValue(static_cast<unsigned char>(part));
      data->GetFieldData()->AddArray(picture);
    }
    assemble->AddInputData(data);
  }
  assemble->Update();
  return assemble->GetOutput();
}

TEST(Join, EachFaceWearsThePictureOfItsPart)
{
  for (const double width : { 0.0, 0.3 })
  {
    SCOPED_TRACE(width);
    vtkNew<vtkOversketchJoin> join;
    join->SetInputData(twoBalls(true));
    join->SetWidth(width);
    join->Update();
    vtkPolyData* made = join->GetOutput();
    ASSERT_GT(made->GetNumberOfPolys(), 0);
    vtkDataArray* parts = made->GetCellData()->GetArray("PartId");
    vtkDataArray* coordinates = made->GetPointData()->GetTCoords();
    ASSERT_NE(parts, nullptr);
    ASSERT_NE(coordinates, nullptr);
    EXPECT_NE(made->GetFieldData()->GetArray("Part1.Texture"), nullptr);
    ASSERT_NE(made->GetFieldData()->GetArray("Joined"), nullptr);
    EXPECT_EQ(made->GetFieldData()->GetArray("Joined")->GetNumberOfTuples(), 2);
    std::set<int> seen;
    for (vtkIdType f = 0; f < made->GetNumberOfPolys(); ++f)
    {
      const int part = static_cast<int>(parts->GetComponent(f, 0));
      seen.insert(part);
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      made->GetPolys()->GetCellAtId(f, count, ids);
      for (vtkIdType k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(coordinates->GetComponent(ids[k], 1), part, 1e-9); // none between the two pictures
        if (width == 0.0)
        {
          EXPECT_NEAR(coordinates->GetComponent(ids[k], 0), made->GetPoint(ids[k])[0], 1e-9);
        }
      }
    }
    EXPECT_EQ(seen, (std::set<int>{ 0, 1 }));
    // A further part joins that body, whose parts are one.
    vtkNew<vtkOversketchJoin> again;
    again->SetInputData(0, made);
    again->SetInputData(1, toPolyData(shifted(icosphere(3), { 0.5, 1.2, 0.1 })));
    again->Update();
    EXPECT_EQ(again->GetErrorCode(), 0u);
    EXPECT_EQ(again->GetFigure("parts"), 2.0);
    ASSERT_NE(again->GetOutput()->GetFieldData()->GetArray("Joined"), nullptr);
    EXPECT_EQ(again->GetOutput()->GetFieldData()->GetArray("Joined")->GetNumberOfTuples(), 3);
  }
}

TEST(Join, WithoutPicturesThereAreNoParts)
{
  vtkNew<vtkOversketchJoin> join;
  join->SetInputData(twoBalls(false));
  join->Update();
  EXPECT_EQ(join->GetOutput()->GetCellData()->GetArray("PartId"), nullptr);
  EXPECT_EQ(join->GetOutput()->GetFieldData()->GetArray("Joined"), nullptr);
  const Mesh made = MeshOf(join->GetOutput());
  EXPECT_EQ(made.vertexCount() - made.triangleCount() / 2, 2); // no place has two points
  EXPECT_EQ(join->GetFigure("parts"), 2.0);
  EXPECT_TRUE(std::isnan(join->GetFigure("seam.sharpest_edge")));
}

TEST(Join, PiecesAndAFurtherMeshAreParts)
{
  const Mesh ball = icosphere(2);
  vtkNew<vtkOversketchJoin> join;
  join->SetInputData(0, toPolyData(joined(ball, ball, { 1.2, 0.1, 0.0 })));
  join->Update();
  EXPECT_EQ(join->GetFigure("parts"), 2.0);
  const vtkIdType pieces = join->GetOutput()->GetNumberOfPolys();
  join->SetInputData(0, toPolyData(ball));
  join->SetInputData(1, toPolyData(shifted(ball, { 1.2, 0.1, 0.0 })));
  join->Update();
  EXPECT_EQ(join->GetFigure("parts"), 2.0);
  EXPECT_EQ(join->GetOutput()->GetNumberOfPolys(), pieces);
}

TEST(Join, ThreadsMakeNoDifference)
{
  vtkNew<vtkOversketchJoin> join;
  join->SetInputData(twoBalls(true));
  join->SetWidth(0.25);
  vtkNew<vtkPolyData> one;
  vtkSMPTools::Initialize(1);
  join->Update();
  one->DeepCopy(join->GetOutput());
  vtkSMPTools::Initialize(2);
  join->Modified();
  join->Update();
  EXPECT_TRUE(identical(one, join->GetOutput()));
  vtkSMPTools::Initialize();
}

TEST(Join, Promises)
{
  vtkNew<vtkOversketchJoin> join;
  join->SetInputData(twoBalls(false));
  expectCancel(join);
  join->Update();
  EXPECT_GT(join->GetOutput()->GetNumberOfPoints(), 0);
  join->SetWidth(-1.0);
  expectRefusal(join, Failure::BadRegion, "give a width of 0 or more");
  join->SetWidth(0.0);
  join->SetInputData(toPolyData(icosphere(2)));
  expectRefusal(join, Failure::BadMesh, "There is one part only");
  join->SetInputData(toPolyData(joined(icosphere(2), icosphere(2), { 3, 0, 0 })));
  expectRefusal(join, Failure::BadMesh, "ask for a bridge");
  join->BridgeOn();
  join->SetWidth(0.3);
  join->Update();
  EXPECT_EQ(join->GetErrorCode(), 0u);
  const Mesh made = MeshOf(join->GetOutput());
  EXPECT_EQ(made.vertexCount() - made.triangleCount() / 2, 2); // one ball, to bend and stretch
}

} // namespace
