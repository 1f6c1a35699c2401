// Faces at the back: which models have them hidden by others, and that a picture hardly shows whether they
// are drawn.
#include "back_faces.h"
#include "mesh_file.h"
#include "model_view.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace oversketch_studio;

namespace
{

vtkSmartPointer<vtkPolyData> ball(double x = 0.0)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, 0.0, 0.0);
  source->SetThetaResolution(24);
  source->SetPhiResolution(12);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> together(vtkPolyData* one, vtkPolyData* other)
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(one);
  append->AddInputData(other);
  append->Update();
  return append->GetOutput();
}

// Its faces in turn, from the first one, without any further than so many; the last some of them inside out.
vtkSmartPointer<vtkPolyData> faces(vtkPolyData* of, vtkIdType count, vtkIdType turned = 0)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(of->GetPoints());
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> face;
  for (vtkIdType i = 0; i < count; ++i)
  {
    of->GetPolys()->GetCellAtId(i, face);
    if (i >= count - turned)
    {
      std::reverse(face->begin(), face->end());
    }
    cells->InsertNextCell(face);
  }
  mesh->SetPolys(cells);
  return mesh;
}

struct FacesScene
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  ModelView model{ this->renderer };

  explicit FacesScene(vtkPolyData* mesh)
  {
    this->window->SetMultiSamples(0);
    this->window->SetSize(400, 300);
    this->window->AddRenderer(this->renderer);
    this->model.show(mesh);
    this->renderer->ResetCamera(mesh->GetBounds());
  }
  bool hides()
  {
    this->model.hideBacks(true);
    return this->renderer->GetActors()->GetLastActor()->GetProperty()->GetBackfaceCulling();
  }
  std::vector<unsigned char> picture()
  {
    this->window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->window->GetPixelData(0, 0, 399, 299, 0, pixels);
    return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
  }
};

} // namespace

TEST(BackFaces, ABodyIsTold)
{
  const vtkSmartPointer<vtkPolyData> one = ball();
  const vtkIdType count = one->GetNumberOfPolys();
  EXPECT_TRUE(BackFaces::boundBody(one));
  EXPECT_TRUE(BackFaces::boundBody(together(one, ball(3.0))));
  EXPECT_FALSE(BackFaces::boundBody(faces(one, 0)));
  EXPECT_FALSE(BackFaces::boundBody(faces(one, count - 1))) << "a hole";
  EXPECT_FALSE(BackFaces::boundBody(faces(one, count, 1))) << "a face inside out";
  EXPECT_FALSE(BackFaces::boundBody(faces(one, count, count))) << "all inside out";
  EXPECT_FALSE(BackFaces::boundBody(together(together(one, ball(3.0)), faces(ball(6.0), count, count))))
    << "a small one inside out beside two";
  EXPECT_FALSE(BackFaces::boundBody(together(one, faces(one, 1)))) << "a loose face";
  one->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  EXPECT_FALSE(BackFaces::boundBody(one)) << "a place that is no number";
}

TEST(BackFaces, HardlyAPixelShowsWhetherTheyAreDrawn)
{
  oversketch_files::Notes notes;
  const auto dog = oversketch_files::readMesh(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", notes);
  FacesScene scene(dog);
  for (const double turn : { 0.0, 40.0, 90.0, 130.0 })
  {
    scene.renderer->GetActiveCamera()->Azimuth(turn);
    scene.renderer->ResetCamera(dog->GetBounds());
    ASSERT_TRUE(scene.hides());
    const std::vector<unsigned char> without = scene.picture();
    EXPECT_GT(
      std::count_if(without.begin(), without.end(), [](unsigned char value) { return value > 60; }), 5000);
    scene.model.hideBacks(false);
    const std::vector<unsigned char> with = scene.picture();
    int differ = 0;
    for (std::size_t i = 0; i < with.size(); i += 3)
    {
      differ += !std::equal(&with[i], &with[i] + 3, &without[i]);
    }
    EXPECT_LE(differ, 12) << "more than slivers at an outline, of 120,000 pixels, at " << turn;
  }
  // From within the box, and where the near plane cuts it, one may look into the body.
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  const double away = camera->GetDistance();
  camera->Dolly(1e3);
  camera->SetClippingRange(1e-3 * away, away);
  EXPECT_FALSE(scene.hides());
  scene.renderer->ResetCamera(dog->GetBounds());
  EXPECT_TRUE(scene.hides());
  double range[2];
  camera->GetClippingRange(range);
  camera->SetClippingRange(0.5 * (range[0] + range[1]), range[1]);
  EXPECT_FALSE(scene.hides());
}

TEST(BackFaces, WhatIsOpenIsDrawnWhole)
{
  const vtkSmartPointer<vtkPolyData> one = ball();
  FacesScene scene(one);
  EXPECT_TRUE(scene.hides());
  scene.model.preview(faces(one, one->GetNumberOfPolys() / 2));
  EXPECT_FALSE(scene.hides());
  scene.model.clear();
  EXPECT_FALSE(scene.hides());
}
