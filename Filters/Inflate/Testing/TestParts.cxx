// Facts of image-assisted.md, sections 15 and 16: texture coordinates and assembled parts.
#include "DrawingChain.h"
#include "vtkOversketchAssemble.h"
#include "vtkOversketchProjectTexture.h"

#include "vtkIntArray.h"
#include "vtkPolyDataNormals.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

Eigen::Matrix4d shifted(double x, double y, double z, double scaleX = 1.0)
{
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topRightCorner<3, 1>() = Vector3(x, y, z);
  matrix(0, 0) = scaleX;
  return matrix;
}

vtkSmartPointer<vtkPolyData> placedAt(vtkPolyData* part, const Eigen::Matrix4d& matrix)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(part);
  vtkNew<vtkDoubleArray> placement;
  placement->SetName("Placement");
  placement->SetNumberOfComponents(16);
  placement->SetNumberOfTuples(1);
  for (int i = 0; i < 16; ++i)
  {
    placement->SetComponent(0, i, matrix(i / 4, i % 4));
  }
  vtkNew<vtkFieldData> fields; // the part's own is shared
  fields->ShallowCopy(part->GetFieldData());
  fields->AddArray(placement);
  result->SetFieldData(fields);
  return result;
}

// The polygons of one part.
vtkSmartPointer<vtkPolyData> partOf(vtkPolyData* all, int number)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdList> ids;
  vtkDataArray* parts = all->GetCellData()->GetArray("PartId");
  for (vtkIdType f = 0; f < all->GetNumberOfPolys(); ++f)
  {
    if (parts->GetComponent(f, 0) == number)
    {
      all->GetPolys()->GetCellAtId(f, ids);
      polys->InsertNextCell(ids);
    }
  }
  result->SetPoints(all->GetPoints());
  result->SetPolys(polys);
  return result;
}

vtkSmartPointer<vtkImageData> picture(int columns, int rows)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  image->SetSpacing(0.5, 0.5, 1.0);
  image->SetOrigin(10.25, -3.75, 0.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  return image;
}

} // namespace

TEST(C15_1, TheCanvassCornersAreThePicturesCorners)
{
  // A picture of 40 x 20 px of 0.5 units: from (10, -4) to (30, 6).
  const auto mesh = toPlanar(rectangle(Vector2(10.0, -4.0), Vector2(20.0, 10.0), 2, 1, true, 0));
  vtkNew<vtkOversketchProjectTexture> filter;
  const auto corners = [&](vtkPolyData* input, vtkImageData* image)
  {
    filter->SetInputData(input);
    filter->SetPictureData(image);
    filter->Update();
    EXPECT_EQ(filter->GetErrorCode(), 0u);
    vtkDataArray* coordinates = filter->GetOutput()->GetPointData()->GetTCoords();
    return std::array<double, 4>{ coordinates->GetComponent(0, 0),
      coordinates->GetComponent(0, 1),
      coordinates->GetComponent(5, 0),
      coordinates->GetComponent(5, 1) };
  };
  const std::array<double, 4> whole{ 0.0, 0.0, 1.0, 1.0 };
  EXPECT_EQ(corners(mesh, picture(40, 20)), whole);
  WriteCanvas({ Vector2(10.0, -4.0), Vector2(20.0, 10.0) }, mesh);
  EXPECT_EQ(corners(mesh, nullptr), whole);
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetTCoords()->GetName(), "TCoords");
  EXPECT_EQ(mesh->GetPointData()->GetTCoords(), nullptr) << "the input is untouched";
  fact("C15_1", "a picture of 40 x 20 px, and a Canvas: its corners at exactly (0, 0) and (1, 1)");
}

TEST(ProjectTexture, ThePictureOfTheBackIsSeenFromBehind)
{
  DrawingChain chain(Treatment::Tunnel, 2);
  for (vtkAlgorithm* maker :
    { static_cast<vtkAlgorithm*>(chain.Cut), static_cast<vtkAlgorithm*>(chain.Extrude) })
  {
    vtkNew<vtkOversketchProjectTexture> texture;
    texture->SetInputConnection(maker->GetOutputPort());
    texture->Update();
    vtkNew<vtkPolyData> plain;
    plain->ShallowCopy(texture->GetOutput());
    EXPECT_EQ(plain->GetCellData()->GetArray("PartId"), nullptr);
    texture->SetBackPictureData(picture(7, 3));
    texture->Update();
    ASSERT_EQ(texture->GetErrorCode(), 0u);
    vtkPolyData* apart = texture->GetOutput();
    ASSERT_EQ(apart->GetNumberOfPolys(), plain->GetNumberOfPolys());
    vtkDataArray *parts = apart->GetCellData()->GetArray("PartId"),
                 *sides = apart->GetCellData()->GetArray("Side");
    vtkDataArray *before = plain->GetPointData()->GetTCoords(), *after = apart->GetPointData()->GetTCoords();
    vtkNew<vtkIdList> was, is;
    std::map<vtkIdType, int> partOfPoint;
    int backs = 0;
    for (vtkIdType face = 0; face < apart->GetNumberOfPolys(); ++face)
    {
      plain->GetPolys()->GetCellAtId(face, was);
      apart->GetPolys()->GetCellAtId(face, is);
      const bool back = sides->GetComponent(face, 0) < 0.0;
      backs += back;
      ASSERT_EQ(parts->GetComponent(face, 0), back ? 1.0 : 0.0);
      for (vtkIdType k = 0; k < is->GetNumberOfIds(); ++k)
      {
        const vtkIdType p = is->GetId(k), q = was->GetId(k);
        ASSERT_EQ(Vector3(apart->GetPoint(p)), Vector3(plain->GetPoint(q)));
        const double s = before->GetComponent(q, 0);
        ASSERT_EQ(after->GetComponent(p, 0), back ? 1.0 - s : s);
        ASSERT_EQ(after->GetComponent(p, 1), before->GetComponent(q, 1));
        ASSERT_EQ(partOfPoint.emplace(p, back).first->second, back) << "no point is of both";
      }
    }
    EXPECT_GT(backs, 100);
    EXPECT_EQ(apart->GetPointData()->GetNumberOfArrays(), plain->GetPointData()->GetNumberOfArrays());
  }
  const auto flat = toPlanar(rectangle(Vector2(10.0, -4.0), Vector2(20.0, 10.0), 2, 1, true, 0));
  vtkNew<vtkOversketchProjectTexture> texture;
  texture->SetInputData(flat);
  texture->SetPictureData(picture(40, 20));
  texture->SetBackPictureData(picture(40, 20));
  expectRefusal(texture, Failure::MissingArray, "Side");
}

TEST(C15_2, FrontAndBackAgreeAndPlacingChangesNothing)
{
  DrawingChain chain(Treatment::Tunnel, 2);
  int compared = 0;
  for (vtkAlgorithm* maker :
    { static_cast<vtkAlgorithm*>(chain.Cut), static_cast<vtkAlgorithm*>(chain.Extrude) })
  {
    vtkNew<vtkOversketchProjectTexture> texture;
    texture->SetInputConnection(maker->GetOutputPort());
    texture->Update();
    vtkPolyData* surface = texture->GetOutput();
    vtkDataArray* coordinates = surface->GetPointData()->GetTCoords();
    std::map<std::pair<double, double>, std::pair<double, double>> seen;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const Vector3 p(surface->GetPoint(i));
      const std::pair<double, double> place(coordinates->GetComponent(i, 0), coordinates->GetComponent(i, 1));
      EXPECT_EQ(place.first, p[0] / 1024.0);
      EXPECT_EQ(place.second, p[1] / 1024.0);
      const auto known = seen.emplace(std::make_pair(p[0], p[1]), place);
      EXPECT_EQ(known.first->second, place);
      compared += !known.second;
    }
    vtkNew<vtkOversketchAssemble> assemble;
    assemble->AddInputData(placedAt(surface, shifted(5.0, 6.0, 7.0, -2.0)));
    assemble->Update();
    vtkDataArray* after = assemble->GetOutput()->GetPointData()->GetTCoords();
    ASSERT_NE(after, nullptr);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(after->GetComponent(i, 0), coordinates->GetComponent(i, 0));
      EXPECT_EQ(after->GetComponent(i, 1), coordinates->GetComponent(i, 1));
    }
  }
  EXPECT_GT(compared, 1000);
  fact("C15_2",
    std::to_string(compared) + " points over another one: the same coordinates, and after placing as before");
}

TEST(C16_1, AMirroredPartStillLooksOutward)
{
  DrawingChain chain(Treatment::Fill, 2);
  chain.Inflate->Update();
  vtkPolyData* part = chain.Inflate->GetOutput();
  const double volume = shapeOf(part).volume;
  vtkNew<vtkOversketchAssemble> assemble;
  assemble->AddInputData(placedAt(part, shifted(0.0, 0.0, 300.0)));
  assemble->AddInputData(placedAt(part, shifted(900.0, 0.0, 0.0, -0.5)));
  assemble->Update();
  std::string figures;
  for (const int number : { 0, 1 })
  {
    const Shape shape = shapeOf(partOf(assemble->GetOutput(), number));
    EXPECT_EQ(shape.loops + shape.odd + shape.pinched, 0);
    EXPECT_NEAR(shape.volume / volume, number == 0 ? 1.0 : 0.5, 1e-9);
    figures += (number == 0 ? "" : ", ") + digits(shape.volume / volume);
  }
  fact("C16_1", "one part shifted, one mirrored and halved: both closed, volumes of " + figures);
}

TEST(C16_2, CountsAreSums)
{
  DrawingChain torus(Treatment::Hole, 2), ball(Treatment::Fill, 2);
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkOversketchAssemble> assemble;
  assemble->AddInputConnection(torus.Inflate->GetOutputPort());
  assemble->AddInputData(empty);
  assemble->AddInputConnection(ball.Inflate->GetOutputPort());
  assemble->AddInputConnection(ball.Extrude->GetOutputPort());
  assemble->Update();
  ASSERT_EQ(assemble->GetErrorCode(), 0u);
  vtkPolyData* all = assemble->GetOutput();
  const vtkIdType points = torus.Inflate->GetOutput()->GetNumberOfPoints() +
                           ball.Inflate->GetOutput()->GetNumberOfPoints() +
                           ball.Extrude->GetOutput()->GetNumberOfPoints();
  const vtkIdType faces = torus.Inflate->GetOutput()->GetNumberOfPolys() +
                          ball.Inflate->GetOutput()->GetNumberOfPolys() +
                          ball.Extrude->GetOutput()->GetNumberOfPolys();
  EXPECT_EQ(all->GetNumberOfPoints(), points);
  EXPECT_EQ(all->GetNumberOfPolys(), faces);
  expectClosed(all, 0 + 2 + 2);
  EXPECT_EQ(shapeOf(partOf(all, 0)).chi, 0);
  EXPECT_EQ(shapeOf(partOf(all, 1)).triangles, 0);
  EXPECT_EQ(shapeOf(partOf(all, 2)).chi, 2);
  EXPECT_EQ(partOf(all, 3)->GetNumberOfPolys(), ball.Extrude->GetOutput()->GetNumberOfPolys());
  for (const char* name : { "Displacement", "Side", "PlanarId", "BoundaryKind" })
  {
    EXPECT_NE(all->GetPointData()->GetArray(name), nullptr) << name;
  }
  EXPECT_EQ(all->GetFieldData()->GetArray("Canvas"), nullptr);
  EXPECT_NE(all->GetFieldData()->GetArray("Part0.Canvas"), nullptr);
  EXPECT_NE(all->GetFieldData()->GetArray("Part3.Canvas"), nullptr);
  fact("C16_2",
    "torus, nothing, ball and slab: " + std::to_string(points) + " points and " + std::to_string(faces) +
      " faces are the sums, chi 0 + 2 + 2 = 4");
}

TEST(C16_3, MovingAPartRunsNoOther)
{
  DrawingChain chain(Treatment::Fill, 2);
  vtkNew<vtkOversketchAssemble> assemble;
  assemble->AddInputConnection(chain.Inflate->GetOutputPort());
  chain.Inflate->Update();
  const auto moved = placedAt(chain.Inflate->GetOutput(), shifted(0.0, 0.0, 1.0));
  assemble->AddInputData(moved);
  assemble->Update();
  const vtkMTimeType before = chain.Inflate->GetOutput()->GetMTime();
  for (int i = 2; i < 6; ++i)
  {
    moved->GetFieldData()->GetArray("Placement")->SetComponent(0, 11, i);
    moved->GetFieldData()->GetArray("Placement")->Modified();
    moved->Modified();
    assemble->Update();
    EXPECT_EQ(partOf(assemble->GetOutput(), 1)->GetPoint(assemble->GetOutput()->GetNumberOfPoints() - 1)[2],
      moved->GetPoint(moved->GetNumberOfPoints() - 1)[2] + i);
  }
  EXPECT_EQ(chain.Inflate->GetInflateCount(), 1);
  EXPECT_EQ(chain.Inflate->GetOutput()->GetMTime(), before);
  EXPECT_EQ(chain.Classify->GetClassificationCount(), 1);
  fact("C16_3", "a part moved four times: the other one's filters ran once, their output is the same");
}

TEST(Assemble, WhatWasAssembledStaysSeveralParts)
{
  DrawingChain ball(Treatment::Fill, 1);
  ball.Inflate->Update();
  const auto part = [&](double x) { return placedAt(ball.Inflate->GetOutput(), shifted(x, 0.0, 0.0)); };
  const auto named = part(0.0);
  vtkNew<vtkDoubleArray> ink;
  ink->SetName("Ink");
  ink->InsertNextValue(7.0);
  named->GetFieldData()->AddArray(ink);
  const auto joined = [](const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
  {
    vtkNew<vtkOversketchAssemble> assemble;
    for (vtkPolyData* one : parts)
    {
      assemble->AddInputData(one);
    }
    assemble->Update();
    EXPECT_EQ(assemble->GetErrorCode(), 0u);
    return vtkSmartPointer<vtkPolyData>(assemble->GetOutput());
  };
  // Two and then two more are the same as four at once, to the bit.
  const auto pair = joined({ part(1000.0), named });
  const auto all = joined({ part(2000.0), pair, part(3000.0) });
  const auto atOnce = joined({ part(2000.0), part(1000.0), named, part(3000.0) });
  ASSERT_EQ(all->GetNumberOfPoints(), atOnce->GetNumberOfPoints());
  for (vtkIdType i = 0; i < all->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(Vector3(all->GetPoint(i)), Vector3(atOnce->GetPoint(i)));
  }
  for (vtkIdType f = 0; f < all->GetNumberOfPolys(); ++f)
  {
    EXPECT_EQ(all->GetCellData()->GetArray("PartId")->GetComponent(f, 0),
      atOnce->GetCellData()->GetArray("PartId")->GetComponent(f, 0));
  }
  for (int number = 0; number < 4; ++number)
  {
    EXPECT_EQ(shapeOf(partOf(all, number)).chi, 2);
    const std::string prefix = "Part" + std::to_string(number) + ".";
    EXPECT_NE(all->GetFieldData()->GetArray((prefix + "Canvas").c_str()), nullptr) << number;
    EXPECT_EQ(all->GetFieldData()->GetArray((prefix + "Ink").c_str()) != nullptr, number == 2);
  }
  const auto wrong = part(0.0);
  vtkNew<vtkIntArray> ids;
  ids->SetName("PartId");
  ids->SetNumberOfTuples(wrong->GetNumberOfPolys());
  ids->FillValue(-1);
  wrong->GetCellData()->AddArray(ids);
  vtkNew<vtkOversketchAssemble> filter;
  filter->AddInputData(wrong);
  expectRefusal(filter, Failure::BadMesh, "Part 0: Cell array PartId holds -1");
}

TEST(Assemble, CoordinatesOfSomeAreNoneOfTheOthers)
{
  DrawingChain ball(Treatment::Fill, 1);
  vtkNew<vtkOversketchProjectTexture> texture;
  texture->SetInputConnection(ball.Inflate->GetOutputPort());
  texture->Update();
  vtkNew<vtkOversketchAssemble> assemble;
  assemble->AddInputConnection(ball.Inflate->GetOutputPort());
  assemble->AddInputConnection(texture->GetOutputPort());
  assemble->Update();
  vtkDataArray* coordinates = assemble->GetOutput()->GetPointData()->GetTCoords();
  ASSERT_NE(coordinates, nullptr);
  const vtkIdType count = texture->GetOutput()->GetNumberOfPoints();
  vtkDataArray* own = texture->GetOutput()->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int c = 0; c < 2; ++c)
    {
      EXPECT_EQ(coordinates->GetComponent(i, c), 0.0);
      EXPECT_EQ(coordinates->GetComponent(count + i, c), own->GetComponent(i, c));
    }
  }
}

TEST(ProjectTexture, RefusesAndCancels)
{
  DrawingChain chain(Treatment::Fill, 1);
  vtkNew<vtkOversketchProjectTexture> filter;
  filter->SetInputData(chain.Mesh);
  expectCancel(filter);
  filter->Update();
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetTCoords(), nullptr);
  const auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->ShallowCopy(chain.Mesh);
  bare->SetFieldData(vtkNew<vtkFieldData>());
  filter->SetInputData(bare);
  expectRefusal(filter, Failure::MissingArray, "Canvas");
  const auto deep = picture(4, 4);
  deep->SetDimensions(4, 4, 3);
  filter->SetPictureData(deep);
  expectRefusal(filter, Failure::BadStroke, "slices");
  const auto turned = picture(4, 4);
  turned->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  filter->SetPictureData(turned);
  expectRefusal(filter, Failure::BadStroke, "direction matrix");
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
}

TEST(Assemble, RefusesAndCancels)
{
  DrawingChain chain(Treatment::Fill, 1);
  vtkNew<vtkOversketchAssemble> filter;
  filter->AddInputData(chain.Mesh);
  expectCancel(filter);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), chain.Mesh->GetNumberOfPolys());
  const auto refused = [&](vtkPolyData* part, const std::string& words)
  {
    filter->RemoveAllInputs();
    filter->AddInputData(chain.Mesh);
    filter->AddInputData(part);
    expectRefusal(filter, Failure::BadMesh, "Part 1: " + words);
  };
  refused(placedAt(chain.Mesh, shifted(0, 0, 0, 0)), "A part's placement flattens it");
  refused(placedAt(chain.Mesh, shifted(0, 0, std::nan(""))), "A part's placement must be an affine matrix");
  Eigen::Matrix4d perspective = shifted(0, 0, 0);
  perspective(3, 2) = 1.0;
  refused(placedAt(chain.Mesh, perspective), "A part's placement must be an affine matrix");
  const auto few = placedAt(chain.Mesh, shifted(0, 0, 0));
  few->GetFieldData()->GetArray("Placement")->SetNumberOfTuples(2);
  refused(few, "Field array Placement must hold 16 numbers");
  refused(toCurves({ closedStroke(ringAt(512, 512, 100)) }), "");
  // Normals would be those of before.
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(chain.Mesh);
  normals->Update();
  filter->RemoveAllInputs();
  filter->AddInputConnection(normals->GetOutputPort());
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNormals(), nullptr);
}
