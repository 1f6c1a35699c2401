// A ball of 100 px radius in a window of 400 x 300 px with the pen that draws lines on it. Header-only.
#ifndef oversketch_widgets_augment_testing_ball_scene_h
#define oversketch_widgets_augment_testing_ball_scene_h

#include "Harness/interaction.h"
#include "Harness/shipped.h"
#include "vtkOversketchAugment.h"
#include "vtkOversketchAugmentWidget.h"
#include "vtkOversketchInteractorStyle.h"
#include "vtkOversketchLiveStrokeRepresentation.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <vector>

namespace oversketch_test
{

using Pixels = std::vector<unsigned char>;

inline std::array<int, 3> pixel(const Pixels& pixels, int x, int y)
{
  const unsigned char* p = &pixels[3 * (400 * std::clamp(y, 0, 299) + std::clamp(x, 0, 399))];
  return { p[0], p[1], p[2] };
}
inline bool isRed(const std::array<int, 3>& p)
{
  return p[0] > 200 && p[1] < 60 && p[2] < 60;
}
inline bool isBlue(const std::array<int, 3>& p)
{
  return p[0] < 60 && p[1] < 130 && p[2] > 200;
}
inline bool isOrange(const std::array<int, 3>& p)
{
  return p[0] > 240 && p[1] > 140 && p[1] < 180 && p[2] < 80;
}

inline vtkSmartPointer<vtkPolyData> ball()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  sphere->Update();
  return sphere->GetOutput();
}

struct Ball : Window
{
  vtkSmartPointer<vtkPolyData> mesh;
  vtkNew<vtkOversketchInteractorStyle> style;
  vtkSmartPointer<vtkOversketchAugmentWidget> widget = vtkSmartPointer<vtkOversketchAugmentWidget>::New();

  explicit Ball(vtkPolyData* shown = ball())
    : Window(400, 300)
    , mesh(shown)
  {
    this->widget->SetInputData(this->mesh);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->widget->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->renderer->AddActor(actor);
    this->camera()->ParallelProjectionOn();
    this->camera()->SetFocalPoint(0.0, 0.0, 0.0);
    this->camera()->SetPosition(0.0, 0.0, 10.0);
    this->camera()->SetParallelScale(1.5);
    this->interactor->SetInteractorStyle(this->style);
    this->widget->SetInteractor(this->interactor);
    this->widget->On();
    this->renderer->ResetCameraClippingRange();
    this->window->Render();
  }

  vtkOversketchAugment* system() { return this->widget->GetAugment(); }
  Pixels pixels()
  {
    vtkNew<vtkUnsignedCharArray> data;
    this->window->GetPixelData(0, 0, 399, 299, 1, data);
    return Pixels(data->GetPointer(0), data->GetPointer(0) + data->GetNumberOfValues());
  }
  int count(bool (*is)(const std::array<int, 3>&))
  {
    const Pixels now = this->pixels();
    int sum = 0;
    for (int y = 0; y < 300; ++y)
    {
      for (int x = 0; x < 400; ++x)
      {
        sum += is(pixel(now, x, y));
      }
    }
    return sum;
  }
  void press(int x, int y, int modifiers = 0)
  {
    this->event(vtkCommand::LeftButtonPressEvent, x, y, modifiers);
  }
  void release(int x, int y) { this->event(vtkCommand::LeftButtonReleaseEvent, x, y); }
  void wheel(int notches, int modifiers)
  {
    for (int i = 0; i < std::abs(notches); ++i)
    {
      this->event(notches > 0 ? vtkCommand::MouseWheelForwardEvent : vtkCommand::MouseWheelBackwardEvent,
        200,
        100,
        modifiers);
    }
  }
  // A wave over the upper half of the ball, through (202, 199).
  void drawLine()
  {
    this->play("augment_line.log");
    this->play("augment_up.log");
  }
};

} // namespace oversketch_test
#endif
