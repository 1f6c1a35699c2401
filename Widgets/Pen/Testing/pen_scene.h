// A sphere in a window of 400 x 300 px with a pen. Header-only.
#ifndef oversketch_widgets_pen_testing_pen_scene_h
#define oversketch_widgets_pen_testing_pen_scene_h

#include "Harness/interaction.h"
#include "vtkOversketchInteractorStyle.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRendererCollection.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <vector>

namespace oversketch_test
{

using Pixels = std::vector<unsigned char>;

struct Pen : Window
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkOversketchInteractorStyle> style;
  vtkSmartPointer<vtkOversketchStrokeWidget> pen = vtkSmartPointer<vtkOversketchStrokeWidget>::New();

  explicit Pen(int samples = 0)
    : Window(400, 300)
  {
    this->window->SetMultiSamples(samples);
    this->sphere->SetThetaResolution(32);
    this->sphere->SetPhiResolution(32);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->renderer->AddActor(actor);
    this->renderer->ResetCamera();
    this->interactor->SetInteractorStyle(this->style);
    this->pen->SetInteractor(this->interactor);
    this->pen->On();
    this->window->Render();
  }

  Pixels pixels()
  {
    vtkNew<vtkUnsignedCharArray> data;
    this->window->GetPixelData(0, 0, 399, 299, 1, data);
    return Pixels(data->GetPointer(0), data->GetPointer(0) + data->GetNumberOfValues());
  }
  void press(int x, int y) { this->event(vtkCommand::LeftButtonPressEvent, x, y); }
  void release(int x, int y) { this->event(vtkCommand::LeftButtonReleaseEvent, x, y); }
  void drawLine(int x0, int x1, int y, int step = 4)
  {
    this->press(x0, y);
    for (int x = x0 + step; x <= x1; x += step)
    {
      this->move(x, y);
    }
    this->release(x1, y);
  }
  std::vector<std::array<double, 2>> samples()
  {
    std::vector<std::array<double, 2>> all;
    for (vtkIdType i = 0; i < this->pen->GetStroke()->GetNumberOfPoints(); ++i)
    {
      const double* p = this->pen->GetStroke()->GetPoint(i);
      EXPECT_EQ(p[2], 0.0);
      all.push_back({ p[0], p[1] });
    }
    return all;
  }
};

inline bool isRed(const Pixels& pixels, int x, int y)
{
  const unsigned char* p = &pixels[3 * (400 * y + x)];
  return p[0] > 200 && p[1] < 60 && p[2] < 60;
}

} // namespace oversketch_test
#endif
