// A sphere under the interactor style's camera, as editors.md, section 13 (camera), has it: a 400 x 400
// window, parallel scale 1, unit sphere, camera at (0, 0, 10).
#ifndef oversketch_widgets_camera_testing_style_scene_h
#define oversketch_widgets_camera_testing_style_scene_h

#include "Harness/interaction.h"
#include "Harness/shapes.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <vector>

namespace oversketch_test
{

struct StyleScene : Window
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkActor> actor;
  vtkNew<vtkOversketchInteractorStyle> style;

  explicit StyleScene(bool parallel = true)
  {
    this->sphere->SetThetaResolution(64);
    this->sphere->SetPhiResolution(65);
    this->sphere->SetRadius(1.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->sphere->GetOutputPort());
    this->actor->SetMapper(mapper);
    this->renderer->AddActor(this->actor);
    this->camera()->SetParallelProjection(parallel);
    this->camera()->SetParallelScale(1.0);
    this->camera()->SetPosition(0.0, 0.0, 10.0);
    this->renderer->ResetCameraClippingRange();
    this->interactor->SetInteractorStyle(this->style);
    this->window->Render();
    this->interactor->EnableRenderOff(); // the camera is what is tested
  }

  std::vector<double> state()
  {
    vtkCamera* c = this->camera();
    std::vector<double> all{ c->GetViewAngle(), c->GetParallelScale() };
    for (const double* v : { c->GetPosition(), c->GetFocalPoint(), c->GetViewUp() })
    {
      all.insert(all.end(), v, v + 3);
    }
    return all;
  }
};

inline void expectNear(const std::vector<double>& a, const std::vector<double>& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_NEAR(a[i], b[i], tolerance) << i;
  }
}

inline std::vector<double> three(const double* v)
{
  return { v[0], v[1], v[2] };
}

} // namespace oversketch_test
#endif
