// A sheet to draw on in a window of 400 x 300 px. Header-only.
#ifndef oversketch_widgets_drawing_testing_desk_h
#define oversketch_widgets_drawing_testing_desk_h

#include "Harness/drawings.h"
#include "Harness/interaction.h"
#include "vtkOversketchDrawingWidget.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkCellData.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <string>
#include <vector>

namespace oversketch_test
{

struct Desk : Window
{
  vtkSmartPointer<vtkOversketchDrawingWidget> sheet = vtkSmartPointer<vtkOversketchDrawingWidget>::New();

  Desk()
    : Window(400, 300)
  {
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    this->interactor->SetInteractorStyle(style);
    this->sheet->SetCanvas(0.0, 0.0, 400.0, 300.0);
    this->sheet->SetInteractor(this->interactor);
    this->sheet->On();
    this->window->Render();
  }

  void draw(const std::vector<Vector2>& places, int modifiers = 0)
  {
    const auto at = [&](std::size_t i, unsigned long event)
    { this->event(event, int(std::lround(places[i][0])), int(std::lround(places[i][1])), modifiers); };
    at(0, vtkCommand::LeftButtonPressEvent);
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      at(i, vtkCommand::MouseMoveEvent);
    }
    at(places.size() - 1, vtkCommand::LeftButtonReleaseEvent);
  }
  void drawRing(const Vector2& centre, double radius) { this->draw(closedRing(centre, radius)); }
  void click(int x, int y)
  {
    this->event(vtkCommand::LeftButtonPressEvent, x, y);
    this->event(vtkCommand::LeftButtonReleaseEvent, x, y);
  }
  void wheel(bool nearer, int x, int y)
  {
    this->event(nearer ? vtkCommand::MouseWheelForwardEvent : vtkCommand::MouseWheelBackwardEvent, x, y);
  }

  static std::vector<Vector2> closedRing(const Vector2& centre, double radius)
  {
    std::vector<Vector2> places = ring(centre, radius, 60);
    places.push_back(places[0]);
    return places;
  }
  vtkPolyData* drawing() { return this->sheet->GetDrawing(); }
  std::vector<int> labels(const char* name)
  {
    std::vector<int> values;
    vtkDataArray* array = this->sheet->GetCurves()->GetCellData()->GetArray(name);
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(int(array->GetComponent(i, 0)));
    }
    return values;
  }
  Vector2 curvePoint(vtkIdType i)
  {
    const double* p = this->sheet->GetCurves()->GetPoint(i);
    EXPECT_EQ(p[2], 0.0);
    return { p[0], p[1] };
  }
};

inline std::vector<Vector2> pointsOf(vtkPolyData* data)
{
  std::vector<Vector2> points;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    points.emplace_back(data->GetPoint(i)[0], data->GetPoint(i)[1]);
  }
  return points;
}

} // namespace oversketch_test
#endif
