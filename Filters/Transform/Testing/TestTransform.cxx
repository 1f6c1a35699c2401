// Places of a box that is placed, what keeps its bits, the copy in the mirror, refusals.
#include "Harness/copies.h"
#include "Harness/promises.h"
#include "Harness/shapes.h"
#include "Harness/shipped.h"

#include "vtkOversketchMaskArray.h"
#include "vtkOversketchTransform.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Positive where faces look outward.
double volumeOf(vtkPolyData* mesh, int part = -1)
{
  auto* parts = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("PartId"));
  double sum = 0.0;
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    if (part < 0 || parts->GetValue(f) == part)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetPolys()->GetCellAtId(f, count, ids);
      for (vtkIdType k = 2; k < count; ++k)
      {
        const Vector3 a(mesh->GetPoint(ids[0])), b(mesh->GetPoint(ids[k - 1])), c(mesh->GetPoint(ids[k]));
        sum += a.dot(b.cross(c)) / 6.0;
      }
    }
  }
  return sum;
}

void setParts(vtkPolyData* mesh, const std::vector<int>& numbers)
{
  vtkNew<vtkIntArray> parts;
  parts->SetName("PartId");
  for (const int number : numbers)
  {
    parts->InsertNextValue(number);
  }
  mesh->GetCellData()->AddArray(parts);
}

// Two boxes, parts 0 and 1, with texture coordinates and a field array of part 1.
struct Placed : testing::Test
{
  Placed()
  {
    std::vector<int> numbers(12, 0);
    numbers.resize(24, 1);
    setParts(this->mesh, numbers);
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetName("Texture");
    coordinates->SetNumberOfComponents(2);
    for (int i = 0; i < 16; ++i)
    {
      coordinates->InsertNextTuple2(0.05 * i, 0.5);
    }
    this->mesh->GetPointData()->SetTCoords(coordinates);
    vtkNew<vtkStringArray> worn;
    worn->SetName("Part1.Worn");
    worn->InsertNextValue("blue");
    this->mesh->GetFieldData()->AddArray(worn);
    this->filter->SetInputData(this->mesh);
  }
  vtkPolyData* run()
  {
    this->filter->Update();
    EXPECT_EQ(this->filter->GetErrorCode(), 0u);
    return this->filter->GetOutput();
  }
  void expectAt(int point, const Vector3& place)
  {
    EXPECT_LT((Vector3(this->filter->GetOutput()->GetPoint(point)) - place).norm(), 1e-12) << point;
  }

  vtkSmartPointer<vtkPolyData> mesh =
    toPolyData(joined(box({ 0, 0, 0 }, { 2, 4, 6 }), box({ 0, 0, 0 }, { 1, 1, 1 }), { 10, 0, 0 }));
  vtkNew<vtkOversketchTransform> filter;
};

} // namespace

TEST_F(Placed, NothingDoneKeepsAllBits)
{
  vtkPolyData* output = this->run();
  EXPECT_EQ(output->GetPoints(), this->mesh->GetPoints());
  EXPECT_EQ(output->GetPolys(), this->mesh->GetPolys());
  this->filter->SetPart(1);
  EXPECT_EQ(this->run()->GetPoints(), this->mesh->GetPoints());
}

TEST_F(Placed, APartIsScaledTurnedAndMovedAboutItsMiddle)
{
  const auto kept = deepCopy(this->mesh);
  this->filter->SetPart(0);
  this->filter->SetScale(2.0, 1.0, 0.5);
  this->filter->SetTurn(90.0, 0.0, 90.0); // y goes to z, and x to y then
  this->filter->SetMove(100.0, 0.0, 0.0);
  vtkPolyData* output = this->run();
  // From the middle (1, 2, 3) the far corner lies at (1, 2, 3), scaled (2, 2, 1.5), turned about x
  // (2, -1.5, 2), about z (1.5, 2, 2).
  this->expectAt(7, Vector3(101.0, 2.0, 3.0) + Vector3(1.5, 2.0, 2.0));
  this->expectAt(0, Vector3(101.0, 2.0, 3.0) - Vector3(1.5, 2.0, 2.0));
  for (int i = 8; i < 16; ++i)
  {
    EXPECT_EQ(Vector3(output->GetPoint(i)), Vector3(this->mesh->GetPoint(i)));
  }
  EXPECT_NEAR(volumeOf(output, 0), 48.0, 1e-9);
  EXPECT_NEAR(volumeOf(output, 1), 1.0, 1e-9);
  EXPECT_EQ(output->GetPolys(), this->mesh->GetPolys());
  EXPECT_EQ(output->GetPointData()->GetTCoords(), this->mesh->GetPointData()->GetTCoords());
  EXPECT_TRUE(identical(kept, this->mesh)) << "the input was touched";
  EXPECT_EQ(this->filter->GetFigure("moved"), 8.0);
}

TEST_F(Placed, TurnsAreAboutYThenXThenZ)
{
  this->filter->SetPart(1); // its middle is (10.5, 0.5, 0.5)
  const Vector3 middle(10.5, 0.5, 0.5);
  this->filter->SetTurn(90.0, 90.0, 0.0);
  this->run();
  // (1, 1, 1) / 2 about y: (1, 1, -1) / 2; about x: (1, 1, 1) / 2.
  this->expectAt(15, middle + Vector3(0.5, 0.5, 0.5));
  this->filter->SetTurn(90.0, 0.0, 90.0);
  this->run();
  // About x: (1, -1, 1) / 2; about z: (1, 1, 1) / 2.
  this->expectAt(15, middle + Vector3(0.5, 0.5, 0.5));
  this->filter->SetTurn(0.0, 90.0, 90.0);
  this->run();
  // About y: (1, 1, -1) / 2; about z: (-1, 1, -1) / 2.
  this->expectAt(15, middle + Vector3(-0.5, 0.5, -0.5));
}

TEST_F(Placed, AllOfItIsPlacedAboutItsMiddle)
{
  this->filter->SetScale(2.0, 2.0, 2.0);
  this->run();
  const Vector3 middle(5.5, 2.0, 3.0);
  for (int i = 0; i < 16; ++i)
  {
    this->expectAt(i, middle + 2.0 * (Vector3(this->mesh->GetPoint(i)) - middle));
  }
  EXPECT_NEAR(volumeOf(this->filter->GetOutput()), 8.0 * 49.0, 1e-9);
}

TEST_F(Placed, NormalsTurnWithTheSurfaceAlsoWhereItIsFlattened)
{
  // A roof's, which scaling by itself would not keep upright on it.
  std::vector<Vector3> normals(16, Vector3(1.0, 1.0, 0.0).normalized());
  const auto roof =
    toPolyData(joined(box({ 0, 0, 0 }, { 2, 4, 6 }), box({ 0, 0, 0 }, { 1, 1, 1 }), { 10, 0, 0 }), &normals);
  roof->GetCellData()->AddArray(this->mesh->GetCellData()->GetArray("PartId"));
  this->filter->SetInputData(roof);
  this->filter->SetPart(0);
  this->filter->SetScale(2.0, 1.0, 1.0);
  vtkPolyData* output = this->run();
  const auto normal = [&](int i) { return Vector3(output->GetPointData()->GetNormals()->GetTuple(i)); };
  EXPECT_LT((normal(3) - Vector3(0.5, 1.0, 0.0).normalized()).norm(), 1e-12);
  EXPECT_EQ(normal(12), normals[12]);
}

TEST_F(Placed, MaskedPointsStay)
{
  std::vector<double> mask(static_cast<std::size_t>(this->mesh->GetNumberOfPoints()), 0.0);
  mask[0] = mask[9] = 1.0;
  PutMask(mask, this->mesh);
  this->filter->SetMove(1.0, 2.0, 3.0);
  this->filter->Update();
  ASSERT_EQ(this->filter->GetErrorCode(), 0u);
  for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
  {
    const Vector3 way =
      mask[static_cast<std::size_t>(i)] == 1.0 ? Vector3::Zero().eval() : Vector3(1.0, 2.0, 3.0);
    const Vector3 moved(this->filter->GetOutput()->GetPoint(i)), before(this->mesh->GetPoint(i));
    EXPECT_LT((moved - before - way).norm(), 1e-6);
  }
  EXPECT_EQ(this->filter->GetFigure("moved"), this->mesh->GetNumberOfPoints() - 2);
}

TEST_F(Placed, FloatsStayFloats)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(this->mesh->GetPoints());
  this->mesh->SetPoints(points);
  this->filter->SetPart(1);
  this->filter->SetMove(0.0, 0.1, 0.0);
  vtkPolyData* output = this->run();
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(Vector3(output->GetPoint(7)), Vector3(this->mesh->GetPoint(7)));
  EXPECT_FLOAT_EQ(static_cast<float>(output->GetPoint(8)[1]), 0.1F);
}

TEST_F(Placed, TheCopyIsItsMirrorImageAndAFurtherPart)
{
  this->filter->SetPart(1);
  this->filter->SetMove(0.0, 5.0, 0.0);
  this->filter->SetCopyToMirrored();
  this->filter->SetMirrorOffset(4.0);
  vtkPolyData* output = this->run();
  ASSERT_EQ(output->GetNumberOfPoints(), 24);
  ASSERT_EQ(output->GetNumberOfPolys(), 36);
  for (int i = 0; i < 8; ++i)
  {
    const Vector3 own(output->GetPoint(8 + i)), copy(output->GetPoint(16 + i));
    EXPECT_EQ(copy, Vector3(8.0 - own[0], own[1], own[2]));
    EXPECT_EQ(own[1], this->mesh->GetPoint(8 + i)[1] + 5.0);
    EXPECT_EQ(output->GetPointData()->GetTCoords()->GetComponent(16 + i, 0),
      output->GetPointData()->GetTCoords()->GetComponent(8 + i, 0));
  }
  EXPECT_NEAR(volumeOf(output, 0), 48.0, 1e-9);
  EXPECT_NEAR(volumeOf(output, 1), 1.0, 1e-9);
  EXPECT_NEAR(volumeOf(output, 2), 1.0, 1e-9) << "inside out";
  auto* worn = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("Part2.Worn"));
  ASSERT_TRUE(worn);
  EXPECT_EQ(worn->GetValue(0), "blue");
  EXPECT_FALSE(this->mesh->GetFieldData()->GetAbstractArray("Part2.Worn")) << "the input was touched";
  EXPECT_EQ(this->filter->GetFigure("copied"), 8.0);
}

TEST_F(Placed, OfSeveralPartsSeveralAreAdded)
{
  this->filter->SetCopyToMirrored();
  this->filter->SetMirrorAxisToZ();
  vtkPolyData* output = this->run();
  for (int part = 0; part < 4; ++part)
  {
    EXPECT_NEAR(volumeOf(output, part), part % 2 == 0 ? 48.0 : 1.0, 1e-9) << part;
  }
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_EQ(Vector3(output->GetPoint(i)), Vector3(this->mesh->GetPoint(i)));
    EXPECT_EQ(output->GetPoint(16 + i)[2], -this->mesh->GetPoint(i)[2]);
  }
}

TEST_F(Placed, AMeshWithoutPartsIsPartZeroAndItsCopyPartOne)
{
  this->mesh->GetCellData()->RemoveArray("PartId");
  this->filter->SetPart(0);
  this->filter->SetCopyToMirrored();
  vtkPolyData* output = this->run();
  EXPECT_NEAR(volumeOf(output, 0), 49.0, 1e-9);
  EXPECT_NEAR(volumeOf(output, 1), 49.0, 1e-9);
}

TEST_F(Placed, NormalsOfTheCopyAreMirrored)
{
  const Mesh ball = icosphere(2);
  const std::vector<Vector3> normals = vertexNormals(ball);
  const auto round = toPolyData(ball, &normals);
  this->filter->SetInputData(round);
  this->filter->SetCopyToMirrored();
  this->filter->SetMirrorOffset(3.0);
  vtkPolyData* output = this->run();
  for (int i = 0; i < ball.vertexCount(); ++i)
  {
    const Vector3 normal(output->GetPointData()->GetNormals()->GetTuple(ball.vertexCount() + i));
    EXPECT_LT((normal - Vector3(-normals[i][0], normals[i][1], normals[i][2])).norm(), 1e-14);
  }
}

TEST_F(Placed, QuadsStayQuads)
{
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 2, 3, 1 });
  quads->InsertNextCell({ 4, 5, 7, 6 });
  vtkNew<vtkPolyData> sheets;
  sheets->SetPoints(this->mesh->GetPoints());
  sheets->SetPolys(quads);
  this->filter->SetInputData(sheets);
  this->filter->SetCopyToMirrored();
  vtkPolyData* output = this->run();
  ASSERT_EQ(output->GetNumberOfPolys(), 4);
  vtkNew<vtkIdList> corners;
  output->GetPolys()->GetCellAtId(2, corners);
  ASSERT_EQ(corners->GetNumberOfIds(), 4);
  const vtkIdType wanted[4] = { 16, 17, 19, 18 };
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_EQ(corners->GetId(k), wanted[k]);
  }
}

TEST_F(Placed, ThreadsChangeNothing)
{
  const Mesh ball = icosphere(5);
  const std::vector<Vector3> normals = vertexNormals(ball);
  vtkSmartPointer<vtkPolyData> first;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkOversketchTransform> other;
    other->SetInputData(toPolyData(ball, &normals));
    other->SetTurn(10.0, 20.0, 30.0);
    other->SetScale(1.0, 2.0, 3.0);
    other->SetCopyToMirrored();
    other->Update();
    first = first ? first : deepCopy(other->GetOutput());
    EXPECT_TRUE(identical(first, other->GetOutput())) << threads;
  }
  vtkSMPTools::Initialize(0);
}

TEST_F(Placed, ABadHandIsToldWhatIsWrong)
{
  this->filter->SetPart(7);
  expectRefusal(this->filter, Failure::BadMesh, "no part 7; the highest number is 1");
  this->filter->SetPart(0);
  this->filter->SetScale(1.0, 0.0, 1.0);
  expectRefusal(this->filter, Failure::BadStroke, "Scale");
  this->filter->SetScale(1.0, -2.0, 1.0);
  expectRefusal(this->filter, Failure::BadStroke, "Scale has the factor -2");
  this->filter->SetScale(1.0, 1.0, 1.0);
  this->filter->SetMove(std::nan(""), 0.0, 0.0);
  expectRefusal(this->filter, Failure::BadStroke, "Move");
  this->filter->SetMove(1e13, 0.0, 0.0);
  expectRefusal(this->filter, Failure::BadMesh, "beyond 1e12");
  this->filter->SetMove(0.0, 0.0, 0.0);
  this->filter->SetTurn(0.0, std::numeric_limits<double>::infinity(), 0.0);
  expectRefusal(this->filter, Failure::BadStroke, "Turn");
  this->filter->SetTurn(0.0, 0.0, 0.0);
  std::vector<int> numbers(24, 0);
  numbers[5] = 1;
  setParts(this->mesh, numbers);
  this->mesh->Modified();
  expectRefusal(this->filter, Failure::BadMesh, "is of part 0 and of another one");
  numbers[5] = -1;
  setParts(this->mesh, numbers);
  this->mesh->Modified();
  expectRefusal(this->filter, Failure::BadMesh, "PartId holds -1");
  setParts(this->mesh, { 0, 1 });
  this->mesh->Modified();
  expectRefusal(this->filter, Failure::BadMesh, "PartId must hold one int a face");
}

// Parts that wear pictures keep their numbers when they are joined (vtkOversketchJoin).
TEST_F(Placed, PartsThatAreJoinedAreNotTornApart)
{
  vtkNew<vtkIntArray> joined;
  joined->SetName("Joined");
  joined->InsertNextValue(1);
  this->mesh->GetFieldData()->AddArray(joined);
  this->filter->SetMove(1.0, 0.0, 0.0);
  this->filter->SetPart(1);
  expectRefusal(this->filter, Failure::BadMesh, "Part 1 is joined with others");
  this->filter->SetPart(0);
  EXPECT_EQ(this->run()->GetPoint(0)[0], this->mesh->GetPoint(0)[0] + 1.0);
  this->filter->SetPart(-1);
  EXPECT_EQ(this->run()->GetPoint(8)[0], this->mesh->GetPoint(8)[0] + 1.0);
}

TEST_F(Placed, CancelLeavesNothing)
{
  this->filter->SetMove(1.0, 0.0, 0.0);
  expectCancel(this->filter, 0.1);
  EXPECT_EQ(this->run()->GetPoint(0)[0], 1.0);
}

TEST_F(Placed, NothingInGivesNothingOut)
{
  vtkNew<vtkPolyData> none;
  this->filter->SetInputData(none);
  EXPECT_EQ(this->run()->GetNumberOfPoints(), 0);
}
