#include "StellarChain.h"
#include "vtkOversketchForEach.h"
#include "vtkOversketchTerrain.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkImageData> imageOf(int width, int height, const std::function<double(int, int)>& gray)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("Gray");
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
      scalars->InsertNextValue(gray(i, j));
  image->GetPointData()->SetScalars(scalars);
  return image;
}

vtkSmartPointer<vtkPolyData> curveAcross(double y, double length)
{
  auto curve = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(50);
  for (int i = 0; i < 50; ++i)
    lines->InsertCellPoint(points->InsertNextPoint(length * (0.1 + 0.8 * i / 49.0), y, 0.0));
  curve->SetPoints(points);
  curve->SetLines(lines);
  return curve;
}

} // namespace

TEST(Terrain, GridCountsHeightsAndItsSource)
{
  vtkNew<vtkOversketchTerrain> terrain;
  const auto image = imageOf(33, 17, [](int i, int j) { return 0.01 * (i - 16) * (i - 16) + 0.02 * j; });
  terrain->SetInputData(image);
  terrain->SetColumns(8);
  terrain->SetScale(2.0);
  terrain->SetOffset(5.0);
  terrain->Update();
  vtkPolyData* mesh = terrain->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfPoints(), 9 * 5);
  ASSERT_EQ(mesh->GetNumberOfCells(), 2 * 8 * 4);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Vector3 p(mesh->GetPoint(i));
    EXPECT_NEAR(p[2], 5.0 + 2.0 * (0.01 * (p[0] - 16) * (p[0] - 16) + 0.02 * p[1]), 1e-12);
  }
  EXPECT_EQ(terrain->GetSourceOutput()->GetNumberOfPoints(), 0);

  // Refined, new points lie on the image, whose source the mesh carries; without it on the chords.
  vtkNew<vtkOversketchStellarRefine> refine;
  refine->SetInputConnection(0, terrain->GetOutputPort());
  refine->SetInputData(1, curveAcross(8.3, 32.0));
  refine->SetRadius(3.0);
  refine->SetTargetEdgeLength(1.2);
  const auto highestError = [&]
  {
    refine->Update();
    EXPECT_EQ(refine->GetErrorCode(), 0u);
    double error = 0.0;
    for (vtkIdType i = 45; i < refine->GetOutput()->GetNumberOfPoints(); ++i)
    {
      const Vector3 p(refine->GetOutput()->GetPoint(i));
      const int below = static_cast<int>(p[0]);
      const double along = p[0] - below;
      const auto gray = [](double x) { return 0.01 * (x - 16) * (x - 16); };
      const double z = 5.0 + 2.0 * ((1 - along) * gray(below) + along * gray(below + 1) + 0.02 * p[1]);
      error = std::max(error, std::abs(p[2] - z));
    }
    return error;
  };
  EXPECT_LT(highestError(), 1e-9);
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(mesh);
  bare->GetFieldData()->RemoveArray("TerrainGray");
  bare->GetFieldData()->RemoveArray("TerrainRules");
  refine->SetInputData(0, bare);
  EXPECT_GT(highestError(), 0.01);
  refine->SetSourceConnection(terrain->GetOutputPort(1));
  EXPECT_LT(highestError(), 1e-9);
  refine->SetInputConnection(0, terrain->GetOutputPort());
  refine->RemoveAllInputConnections(2);
  EXPECT_LT(highestError(), 1e-9);
  const auto chain = cold(refine->GetOutput());
  ASSERT_GT(chain->GetNumberOfCells(), 200);
  // Through a file.
  vtkNew<vtkOversketchStellarRefine> again;
  again->SetInputData(0, saved(mesh));
  again->SetInputData(1, curveAcross(8.3, 32.0));
  again->SetRadius(3.0);
  again->SetTargetEdgeLength(1.2);
  again->Update();
  expectSameMesh(again->GetOutput(), chain);
  EXPECT_EQ(terrain->GetTerrainCount(), 1);
}

TEST(Terrain, ColoursCountByLuminanceAndHolesAreLeftOut)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 1);
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetNumberOfComponents(3);
  for (int i = 0; i < 9; ++i)
    rgb->InsertNextTuple3(100, 50, 200);
  image->GetPointData()->SetScalars(rgb);
  vtkNew<vtkOversketchTerrain> terrain;
  terrain->SetInputData(image);
  terrain->SetColumns(2);
  terrain->Update();
  ASSERT_EQ(terrain->GetOutput()->GetNumberOfCells(), 8);
  EXPECT_NEAR(terrain->GetOutput()->GetPoint(4)[2], 0.299 * 100 + 0.587 * 50 + 0.114 * 200, 1e-12);
}

TEST(Terrain, WhatIsMissingIsFilledWhereItIsNarrowAndSaid)
{
  const double missing = std::numeric_limits<double>::quiet_NaN();
  // A hole in the lower left corner, one sample elsewhere, a row.
  const auto image = imageOf(9,
    9,
    [missing](int i, int j)
    { return (i < 3 && j < 3) || (i == 6 && j == 3) || j == 6 ? missing : 2.0 * i + j; });
  vtkNew<vtkOversketchTerrain> terrain;
  terrain->SetInputData(image);
  terrain->SetColumns(8);
  {
    Ear ear(terrain);
    terrain->Update();
    ASSERT_EQ(ear.warnings.size(), 1u);
    EXPECT_NE(
      ear.warnings[0].find("10 missing samples were filled, each from those beside it. 9 missing samples, "
                           "three and more side by side in both directions, are holes; 9 of 64 quads there "
                           "are left out."),
      std::string::npos)
      << ear.warnings[0];
    terrain->Modified(); // what is kept says it, too
    terrain->Update();
    EXPECT_EQ(ear.warnings.size(), 2u);
  }
  vtkPolyData* mesh = terrain->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfCells(), 2 * (64 - 9));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Vector3 p(mesh->GetPoint(i));
    EXPECT_NEAR(p[2], 2.0 * p[0] + p[1], 1e-12);
  }
  // Whole again: nothing is said.
  terrain->SetInputData(imageOf(9, 9, [](int i, int j) { return 2.0 * i + j; }));
  Ear ear(terrain);
  terrain->Update();
  EXPECT_EQ(ear.warnings.size(), 0u);
}

TEST(Terrain, ItsPlaceOnTheMapGoesAlong)
{
  const auto image = imageOf(33, 17, [](int i, int j) { return 0.1 * i * j; });
  image->SetSpacing(30.0, 20.0, 1.0);
  vtkNew<vtkOversketchTerrain> terrain;
  terrain->SetInputData(image);
  terrain->SetColumns(8);
  terrain->Update();
  EXPECT_FALSE(terrain->GetOutput()->GetFieldData()->GetArray("MapOrigin")) << "of no map";
  const auto there = vtkSmartPointer<vtkImageData>::New();
  there->ShallowCopy(image);
  there->SetOrigin(500015.0, 4600010.0, 0.0);
  terrain->SetInputData(there);
  vtkNew<vtkOversketchStellarRefine> refine;
  refine->SetInputConnection(0, terrain->GetOutputPort());
  refine->SetInputData(1, curveAcross(160.0, 960.0));
  refine->SetRadius(60.0);
  refine->Update();
  EXPECT_EQ(refine->GetErrorCode(), 0u);
  EXPECT_EQ(terrain->GetOutput()->GetBounds()[0], 0.0);
  EXPECT_EQ(terrain->GetOutput()->GetBounds()[1], 960.0);
  for (vtkPolyData* mesh : { terrain->GetOutput(), refine->GetOutput() })
  {
    vtkDataArray* origin = mesh->GetFieldData()->GetArray("MapOrigin");
    ASSERT_TRUE(origin && origin->GetNumberOfComponents() == 3 && origin->GetNumberOfTuples() == 1);
    EXPECT_EQ(Vector3(origin->GetTuple3(0)), Vector3(500015.0, 4600010.0, 0.0));
  }
}

// What is put out is what every step takes, and what is not is said.
TEST(Terrain, HeightsThatNoStepTakesAreRefused)
{
  vtkNew<vtkOversketchTerrain> terrain;
  terrain->SetInputData(imageOf(9, 9, [](int i, int j) { return i + j == 7 ? 4.0 : 1.0; }));
  terrain->SetColumns(8);
  for (const double scale : { 2e11, 3e11, -3e11, 1e31 })
  {
    terrain->SetScale(scale);
    const bool isTaken = 4.0 * std::abs(scale) <= 1e12;
    if (!isTaken)
    {
      expectRefusal(terrain, Failure::BadMesh, "no step takes coordinates beyond 1e+12");
      continue;
    }
    terrain->Update();
    ASSERT_EQ(terrain->GetErrorCode(), 0u);
    EXPECT_NO_THROW(MeshOf(terrain->GetOutput()));
  }
  // The bound is that of the filters that read meshes.
  vtkNew<vtkPolyData> beyond;
  terrain->SetScale(2e11);
  terrain->Update();
  beyond->DeepCopy(terrain->GetOutput());
  beyond->GetPoints()->SetPoint(3, 0.0, 0.0, 1.01e12);
  EXPECT_THROW(MeshOf(beyond), Error);
}

// As ParaView offers it: a collection of images, and no stroke.
TEST(Terrain, ADriverOfSystemsDrivesIt)
{
  vtkNew<vtkMultiBlockDataSet> images;
  images->SetBlock(0, imageOf(9, 9, [](int i, int j) { return i * j; }));
  images->SetBlock(1, imageOf(5, 3, [](int i, int j) { return i - j; }));
  vtkNew<vtkOversketchTerrain> driven;
  driven->SetColumns(4);
  vtkNew<vtkOversketchForEach> each;
  each->SetFilter(driven);
  each->SetInputDataObject(0, images);
  each->Update();
  EXPECT_EQ(each->GetErrorCode(), 0u);
  auto* made = vtkMultiBlockDataSet::SafeDownCast(each->GetOutputDataObject(0));
  ASSERT_TRUE(made && made->GetNumberOfBlocks() == 2);
  for (const unsigned int block : { 0u, 1u })
  {
    vtkNew<vtkOversketchTerrain> alone;
    alone->SetColumns(4);
    alone->SetInputData(vtkImageData::SafeDownCast(images->GetBlock(block)));
    alone->Update();
    auto* mesh = vtkPolyData::SafeDownCast(made->GetBlock(block));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->GetNumberOfCells(), block == 0 ? 32 : 16);
    expectSameMesh(alone->GetOutput(), mesh);
  }
}

TEST(Terrain, BadImagesAndSourcesAreRefused)
{
  vtkNew<vtkOversketchTerrain> terrain;
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(3, 3, 1);
  terrain->SetInputData(bare);
  expectRefusal(terrain, Failure::MissingArray, "scalars");
  vtkNew<vtkImageData> deep;
  deep->SetDimensions(3, 3, 3);
  deep->AllocateScalars(VTK_DOUBLE, 1);
  terrain->SetInputData(deep);
  expectRefusal(terrain, Failure::BadMesh, "slices");
  terrain->SetInputData(imageOf(1, 9, [](int, int) { return 0.0; }));
  expectRefusal(terrain, Failure::BadMesh, "sample");
  terrain->SetInputData(imageOf(4, 4, [](int, int) { return std::nan(""); }));
  expectRefusal(terrain, Failure::BadMesh, "quad");
  terrain->SetInputData(imageOf(4, 4, [](int i, int) { return i; }));
  terrain->SetScale(std::nan(""));
  expectRefusal(terrain, Failure::BadMesh, "cale");
  terrain->SetScale(1.0);
  terrain->Update();

  vtkNew<vtkOversketchStellarRefine> refine;
  refine->SetInputConnection(0, terrain->GetOutputPort());
  refine->SetInputData(1, curveAcross(1.0, 3.0));
  const auto source = cold(terrain->GetSourceOutput());
  source->GetFieldData()->RemoveArray("TerrainRules");
  refine->SetSourceData(source);
  expectRefusal(refine, Failure::MissingArray, "TerrainRules");
  const auto counted = cold(terrain->GetSourceOutput());
  counted->GetFieldData()->GetArray("TerrainRules")->SetTuple1(0, 1e300);
  refine->SetSourceData(counted);
  expectRefusal(refine, Failure::BadMesh, "TerrainRules");
  const auto cut = cold(terrain->GetSourceOutput());
  cut->GetFieldData()->GetArray("TerrainRules")->SetTuple1(1, 7.0);
  refine->SetSourceData(cut);
  expectRefusal(refine, Failure::BadMesh, "");
}
