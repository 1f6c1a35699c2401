// Weights from a painted image: editors.md, section 7, transfer.
#include "ShadingScenes.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkImageData> picture(int width, int height, int type, int components, double value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  image->GetPointData()->GetScalars()->Fill(value);
  return image;
}

struct Painted
{
  Scene scene;
  vtkNew<vtkOversketchFlatten> flatten;
  vtkNew<vtkOversketchTextureToWeight> filter;

  explicit Painted(int levels = 3)
    : scene(capScene(levels))
  {
    this->flatten->SetInputData(meshOf(this->scene));
    this->flatten->SetReferenceData(toChain(this->scene.mesh, this->scene.reference));
    this->filter->SetInputConnection(this->flatten->GetOutputPort());
  }
  std::vector<double> weights(vtkImageData* image)
  {
    this->filter->SetImageData(image);
    this->filter->Update();
    EXPECT_EQ(this->filter->GetErrorCode(), 0u);
    return pointValues(this->filter->GetOutput(), "EditWeight");
  }
  // Every vertex strictly inside has the value, all others 0.
  void expectAll(vtkImageData* image, double value)
  {
    const std::vector<double> w = this->weights(image);
    ASSERT_EQ(w.size(), this->scene.labels.size());
    for (std::size_t v = 0; v < w.size(); ++v)
      ASSERT_EQ(w[v], this->scene.labels[v] == 2 ? value : 0.0) << v;
  }
};

} // namespace

TEST(TextureToWeightFilter, WhiteFollowsWhollyAndBlackNotAtAll)
{
  Painted painted;
  const struct
  {
    int type;
    double white;
  } types[] = {
    { VTK_UNSIGNED_CHAR, 255.0 }, { VTK_UNSIGNED_SHORT, 65535.0 }, { VTK_FLOAT, 1.0 }, { VTK_DOUBLE, 1.0 }
  };
  for (const auto& each : types)
    for (int components = 1; components <= 4; ++components)
    {
      painted.expectAll(picture(8, 8, each.type, components, each.white), 1.0);
      painted.expectAll(picture(8, 8, each.type, components, 0.0), 0.0);
    }
  painted.expectAll(picture(1, 1, VTK_UNSIGNED_CHAR, 3, 102.0), 0.4);
  painted.expectAll(picture(1, 1, VTK_UNSIGNED_SHORT, 1, 13107.0), 0.2);
}

TEST(TextureToWeightFilter, WhatIsTransparentIsNotPainted)
{
  Painted painted;
  const auto image = picture(4, 4, VTK_UNSIGNED_CHAR, 4, 255.0);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->FillComponent(3, 0.0);
  painted.expectAll(image, 0.0);
  scalars->FillComponent(3, 51.0);
  scalars->Modified();
  painted.expectAll(image, 0.2);
  // Red, green and blue by their brightness.
  const double bright[3] = { 0.299, 0.587, 0.114 };
  for (int k = 0; k < 3; ++k)
  {
    const auto colour = picture(4, 4, VTK_UNSIGNED_CHAR, 3, 0.0);
    colour->GetPointData()->GetScalars()->FillComponent(k, 255.0);
    for (const double w : painted.weights(colour))
      EXPECT_TRUE(w == 0.0 || std::abs(w - bright[k]) < 1e-12) << w;
  }
}

TEST(TextureToWeightFilter, ARampIsReadBetweenItsTexels)
{
  Painted painted(4);
  // Grey is u, on few texels and on very many.
  for (const int width : { 10, 20000 })
  {
    const auto ramp = picture(width, 3, VTK_FLOAT, 1, 0.0);
    for (vtkIdType i = 0; i < ramp->GetNumberOfPoints(); ++i)
      ramp->GetPointData()->GetScalars()->SetComponent(i, 0, (static_cast<double>(i % width) + 0.5) / width);
    const std::vector<double> w = painted.weights(ramp),
                              uv = pointValues(painted.filter->GetOutput(), "DiscCoords");
    for (std::size_t v = 0; v < w.size(); ++v)
      if (painted.scene.labels[v] == 2)
      {
        EXPECT_NEAR(w[v], std::clamp(uv[2 * v], 0.5 / width, 1.0 - 0.5 / width), 1e-7);
      }
  }
}

TEST(TextureToWeightFilter, ABlobMovesWhatLiesInItAndNothingElse)
{
  Painted painted(5);
  const int size = 256;
  const auto image = picture(size, size, VTK_UNSIGNED_CHAR, 1, 0.0);
  const auto within = [&](double i, double j) { return std::hypot(i - 150.5, j - 120.5) < 30.0; };
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i)
      if (within(i, j))
        image->GetPointData()->GetScalars()->SetComponent(static_cast<vtkIdType>(j) * size + i, 0, 255.0);
  const std::vector<double> w = painted.weights(image),
                            uv = pointValues(painted.filter->GetOutput(), "DiscCoords");
  int moved = 0;
  for (std::size_t v = 0; v < w.size(); ++v)
  {
    const double r = std::hypot(uv[2 * v] * size - 151.0, uv[2 * v + 1] * size - 121.0);
    if (painted.scene.labels[v] == 2 && r < 28.5)
    {
      EXPECT_EQ(w[v], 1.0);
      ++moved;
    }
    else if (r > 31.5)
    {
      EXPECT_EQ(w[v], 0.0);
    }
  }
  EXPECT_GT(moved, 50);
}

TEST(TextureToWeightFilter, ReadsAnewOnlyWhatChanged)
{
  Painted painted;
  const auto image = picture(2, 2, VTK_UNSIGNED_CHAR, 1, 255.0);
  painted.weights(image);
  vtkDataArray* const first = painted.filter->GetOutput()->GetPointData()->GetArray("EditWeight");
  painted.filter->Modified();
  painted.filter->Update();
  EXPECT_EQ(painted.filter->GetOutput()->GetPointData()->GetArray("EditWeight"), first);
  image->GetPointData()->GetScalars()->Fill(0.0);
  image->GetPointData()->GetScalars()->Modified();
  image->Modified();
  painted.expectAll(image, 0.0);
}

TEST(TextureToWeightFilter, RefusesAndCancels)
{
  Painted painted;
  const auto filter = painted.filter.Get();
  const auto refused = [&](vtkImageData* image, const char* words)
  {
    filter->SetImageData(image);
    expectRefusal(filter, Failure::BadStroke, words);
  };
  vtkNew<vtkImageData> none;
  refused(none, "has no samples");
  none->SetDimensions(3, 3, 1);
  refused(none, "has no scalars that are greys");
  refused(picture(2, 2, VTK_INT, 1, 0.0), "has no scalars that are greys");
  refused(picture(2, 2, VTK_UNSIGNED_CHAR, 5, 0.0), "of 1 to 4 components");
  refused(
    picture(2, 2, VTK_FLOAT, 1, std::nan("")), "of the weight image is not within 0, black, and 1, white");
  refused(picture(2, 2, VTK_FLOAT, 1, 255.0), "scale its numbers");
  refused(picture(2, 2, VTK_FLOAT, 1, -0.1), "scale its numbers");
  const auto slices = vtkSmartPointer<vtkImageData>::New();
  slices->SetDimensions(2, 2, 2);
  slices->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  refused(slices, "several slices");
  filter->SetImageData(picture(2, 2, VTK_UNSIGNED_CHAR, 1, 0.0));
  vtkNew<vtkPolyData> mesh;
  painted.flatten->Update();
  mesh->DeepCopy(painted.flatten->GetOutput());
  filter->SetInputData(mesh);
  const auto inside =
    std::find(painted.scene.labels.begin(), painted.scene.labels.end(), 2) - painted.scene.labels.begin();
  mesh->GetPointData()->GetArray("DiscCoords")->SetComponent(inside, 0, std::nan(""));
  expectRefusal(filter, Failure::BadMesh, "DiscCoords of vertex");
  mesh->GetPointData()->RemoveArray("DiscCoords");
  mesh->Modified();
  expectRefusal(filter, Failure::MissingArray, "no array DiscCoords");
  filter->SetInputConnection(painted.flatten->GetOutputPort());
  expectCancel(filter);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  vtkNew<vtkPolyData> nothing;
  Ear ear(filter);
  filter->SetInputData(nothing);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
}
