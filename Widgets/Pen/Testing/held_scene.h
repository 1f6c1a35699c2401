// A sphere in a window of 400 x 300 px with a pen whose stroke stays. Header-only.
#ifndef oversketch_widgets_pen_testing_held_scene_h
#define oversketch_widgets_pen_testing_held_scene_h

#include "pen_scene.h"
#include "vtkOversketchHeldStrokeRepresentation.h"
#include "vtkOversketchHeldStrokeWidget.h"

namespace oversketch_test
{

struct Held : Pen
{
  vtkSmartPointer<vtkOversketchHeldStrokeWidget> held = vtkSmartPointer<vtkOversketchHeldStrokeWidget>::New();

  // Parallel, 100 px to a unit of the world, whose origin is the middle of the window.
  Held()
  {
    this->pen->Off();
    this->camera()->ParallelProjectionOn();
    this->camera()->SetParallelScale(1.5);
    this->held->SetInteractor(this->interactor);
    this->held->On();
    this->window->Render();
  }
  vtkOversketchHeldStrokeRepresentation* line() { return this->held->GetHeldStrokeRepresentation(); }
  int red()
  {
    const Pixels now = this->pixels();
    int sum = 0;
    for (int y = 0; y < 300; ++y)
    {
      for (int x = 0; x < 400; ++x)
      {
        sum += isRed(now, x, y);
      }
    }
    return sum;
  }
  void drag(int fromX, int fromY, int toX, int toY, int modifiers = 0)
  {
    this->move(fromX, fromY);
    this->event(vtkCommand::LeftButtonPressEvent, fromX, fromY, modifiers);
    this->move(toX, toY);
  }
};

} // namespace oversketch_test
#endif
