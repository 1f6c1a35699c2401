// The shipped dog in a window of 400 x 300 px with the pen that deforms it. Header-only.
#ifndef oversketch_widgets_one_stroke_testing_dog_scene_h
#define oversketch_widgets_one_stroke_testing_dog_scene_h

#include "Harness/interaction.h"
#include "Harness/shipped.h"
#include "vtkOversketchInteractorStyle.h"
#include "vtkOversketchLiveStrokeRepresentation.h"
#include "vtkOversketchOneStroke.h"
#include "vtkOversketchOneStrokeWidget.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace oversketch_test
{

using Pixels = std::vector<unsigned char>;

inline const unsigned char* pixel(const Pixels& pixels, int x, int y)
{
  return &pixels[3 * (400 * std::clamp(y, 0, 299) + std::clamp(x, 0, 399))];
}
inline bool isRed(const Pixels& pixels, int x, int y)
{
  const unsigned char* p = pixel(pixels, x, y);
  return p[0] > 200 && p[1] < 60 && p[2] < 60;
}
inline bool isBlue(const Pixels& pixels, int x, int y)
{
  const unsigned char* p = pixel(pixels, x, y);
  return p[0] < 60 && p[1] < 130 && p[2] > 200;
}
inline bool isOrange(const Pixels& pixels, int x, int y)
{
  const unsigned char* p = pixel(pixels, x, y);
  return p[0] > 100 && p[2] < p[0] / 2 && p[1] > p[0] / 2;
}

struct Dog : Window
{
  vtkSmartPointer<vtkPolyData> mesh;
  vtkNew<vtkOversketchInteractorStyle> style;
  vtkSmartPointer<vtkOversketchOneStrokeWidget> widget = vtkSmartPointer<vtkOversketchOneStrokeWidget>::New();

  // The view of the shipped stroke dog_longer_leg, at half its size.
  explicit Dog(vtkPolyData* shown = nullptr)
    : Window(400, 300)
    , mesh(shown ? vtkSmartPointer<vtkPolyData>(shown) : shippedModel("dog"))
  {
    this->widget->SetInputData(this->mesh);
    this->widget->GetOneStroke()->SetBackendToHost();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->widget->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->renderer->AddActor(actor);
    this->camera()->ParallelProjectionOn();
    this->camera()->SetFocalPoint(0.05, 0.75, 0.0);
    this->camera()->SetPosition(0.05, 0.75, 10.0);
    this->camera()->SetParallelScale(60.0 / 47.0);
    this->interactor->SetInteractorStyle(this->style);
    this->widget->SetInteractor(this->interactor);
    this->widget->On();
    this->renderer->ResetCameraClippingRange();
    this->window->Render();
  }

  Pixels pixels()
  {
    vtkNew<vtkUnsignedCharArray> data;
    this->window->GetPixelData(0, 0, 399, 299, 1, data);
    return Pixels(data->GetPointer(0), data->GetPointer(0) + data->GetNumberOfValues());
  }
  int count(bool (*is)(const Pixels&, int, int))
  {
    const Pixels now = this->pixels();
    int sum = 0;
    for (int y = 0; y < 300; ++y)
    {
      for (int x = 0; x < 400; ++x)
      {
        sum += is(now, x, y);
      }
    }
    return sum;
  }
  void press(int x, int y, int modifiers = 0)
  {
    this->event(vtkCommand::LeftButtonPressEvent, x, y, modifiers);
  }
  void release(int x, int y) { this->event(vtkCommand::LeftButtonReleaseEvent, x, y); }
  void drawLeg()
  {
    this->play("pen_dog_leg.log");
    this->play("pen_up.log");
  }
  // Beside the outer side of the tail.
  void drawTail()
  {
    this->press(120, 195);
    for (int i = 1; i <= 14; ++i)
    {
      this->move(120 - 3 * i, 195 + 4 * i);
    }
    this->release(78, 251);
  }
};

} // namespace oversketch_test
#endif
