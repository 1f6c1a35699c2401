#include "Harness/promises.h"

#include "vtkOversketchPush.h"

#include "vtkImageData.h"

using namespace oversketch_test;

namespace
{

const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 100.0);

struct Scene
{
  vtkNew<vtkOversketchPush> filter;
  vtkNew<vtkImageData> picture;

  Scene()
  {
    this->picture->SetDimensions(1, 1, 1);
    this->picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int k = 0; k < 3; ++k)
    {
      this->picture->SetScalarComponentFromDouble(0, 0, 0, k, 255.0);
    }
    this->filter->SetInputData(0, toPolyData(icosphere(3)));
    this->filter->SetInputData(1, toStroke({ { 350, 100 }, { 350, 500 } }, view));
    this->filter->SetInputData(2, toStroke({ { 450, 100 }, { 450, 500 } }, view));
    this->filter->SetInputData(3, this->picture);
  }
};

} // namespace

TEST(PushFilter, PushesOutAndIn)
{
  Scene scene;
  for (const int sense : { vtkOversketchPush::Out, vtkOversketchPush::In })
  {
    scene.filter->SetSense(sense);
    scene.filter->Update();
    double bounds[6];
    scene.filter->GetOutput()->GetBounds(bounds);
    EXPECT_EQ(bounds[5] > 1.01, sense == vtkOversketchPush::Out);
    EXPECT_NEAR(bounds[1], 1.0, 1e-9);
  }
}

TEST(PushFilter, RefusesAndIsCancelled)
{
  Scene scene;
  expectCancel(scene.filter);
  scene.filter->SetInputData(2, toStroke({ { 10, 10 }, { 20, 20 } }, view));
  scene.filter->SetInputData(1, toStroke({ { 10, 20 }, { 20, 30 } }, view));
  expectRefusal(scene.filter, oversketch::Failure::BadStroke, "No point of the mesh lies between");
}
