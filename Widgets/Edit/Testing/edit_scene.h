// A ball of 100 px radius in a window of 400 x 300 px, a line and a ring on it, and what the system makes of
// them for the widgets. Header-only.
#ifndef oversketch_widgets_edit_testing_edit_scene_h
#define oversketch_widgets_edit_testing_edit_scene_h

#include "Harness/interaction.h"
#include "Harness/polydata.h"
#include "vtkOversketchEdit.h"
#include "vtkOversketchInteractorStyle.h"

#include "vtkActor.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace oversketch_test
{

using oversketch::Vector2;
using oversketch::Vector3;

inline vtkSmartPointer<vtkPolyData> editBall()
{
  return toPolyData(icosphere(4));
}

// Parallel, 100 px to a unit of the world, whose origin is the middle of the window.
struct EditWindow : Window
{
  vtkSmartPointer<vtkPolyData> mesh = editBall();
  vtkNew<vtkOversketchInteractorStyle> style;

  explicit EditWindow(bool showsMesh = true)
    : Window(400, 300)
  {
    if (showsMesh)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(this->mesh);
      mapper->ScalarVisibilityOff();
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      this->renderer->AddActor(actor);
    }
    this->lookFromFront();
    this->interactor->SetInteractorStyle(this->style);
    this->window->Render();
  }
  void lookFromFront()
  {
    this->camera()->ParallelProjectionOn();
    this->camera()->SetFocalPoint(0.0, 0.0, 0.0);
    this->camera()->SetPosition(0.0, 0.0, 10.0);
    this->camera()->SetViewUp(0.0, 1.0, 0.0);
    this->camera()->SetParallelScale(1.5);
    this->renderer->ResetCameraClippingRange();
  }
  View view()
  {
    Eigen::Matrix4d eye = Eigen::Matrix4d::Identity(), p = Eigen::Matrix4d::Identity();
    eye(2, 3) = -10.0;
    p(0, 0) = 0.5;
    p(1, 1) = 1.0 / 1.5;
    p(2, 2) = -0.1;
    return View(eye, p, 400, 300);
  }
  void press(int x, int y, int modifiers = 0)
  {
    this->event(vtkCommand::LeftButtonPressEvent, x, y, modifiers);
  }
  void release(int x, int y, int modifiers = 0)
  {
    this->event(vtkCommand::LeftButtonReleaseEvent, x, y, modifiers);
  }
  void drag(int fromX, int fromY, int toX, int toY)
  {
    this->move(fromX, fromY);
    this->press(fromX, fromY);
    this->move(toX, toY);
  }
  void click(int x, int y)
  {
    this->move(x, y);
    this->press(x, y);
    this->release(x, y);
  }
  void draw(const std::vector<Vector2>& places, int modifiers = 0)
  {
    const auto at = [&](const Vector2& p, unsigned long event)
    { this->event(event, int(std::lround(p[0])), int(std::lround(p[1])), modifiers); };
    at(places.front(), vtkCommand::LeftButtonPressEvent);
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      at(places[i], vtkCommand::MouseMoveEvent);
    }
    at(places.back(), vtkCommand::LeftButtonReleaseEvent);
  }
  std::array<int, 3> pixel(int x, int y)
  {
    vtkNew<vtkUnsignedCharArray> data;
    this->window->GetPixelData(x, y, x, y, 1, data);
    return { data->GetValue(0), data->GetValue(1), data->GetValue(2) };
  }
};

inline std::vector<Vector2> lineSamples()
{
  std::vector<Vector2> samples;
  for (int x = 160; x <= 240; x += 4)
  {
    samples.emplace_back(x, 142.0 + 8.0 * std::cos(pi * (x - 200) / 120.0));
  }
  return samples;
}

inline std::vector<Vector2> ringSamples(double wide = 75.0, double high = 60.0)
{
  std::vector<Vector2> samples;
  for (int i = 0; i < 72; ++i)
  {
    const double angle = 2.0 * pi * i / 72;
    samples.emplace_back(200.0 + wide * std::cos(angle), 150.0 + high * std::sin(angle));
  }
  return samples;
}

// The system over that line and ring.
struct BallRegion
{
  vtkNew<vtkOversketchEdit> system;
  vtkNew<vtkPolyData> line;

  explicit BallRegion(EditWindow& scene)
  {
    this->system->SetInputData(0, scene.mesh);
    this->system->SetReferenceData(toStroke(lineSamples(), scene.view()));
    this->system->SetBoundaryData(toStroke(ringSamples(), scene.view()));
    this->run();
    this->system->GetHold(this->line);
  }
  vtkPolyData* run()
  {
    Ear ear(this->system);
    this->system->Update();
    EXPECT_EQ(this->system->GetErrorCode(), 0u) << (ear.errors.empty() ? "" : ear.errors[0]);
    return this->system->GetOutput();
  }
  // Run anew, how far each vertex follows.
  std::vector<double> weights()
  {
    this->run();
    vtkDataArray* array = this->system->GetInnerOutput("Shading")->GetPointData()->GetArray("EditWeight");
    std::vector<double> values;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetComponent(i, 0));
    }
    return values;
  }
  vtkPolyData* mesh() { return this->system->GetInnerOutput("Distance"); }
  vtkPolyData* ring()
  {
    return vtkPolyData::SafeDownCast(this->system->GetStep("Enclose")->GetInputDataObject(2, 0));
  }
};

// What the pictures of a widget and its camera tell of keys and buttons that it should have swallowed.
struct CameraState
{
  std::array<double, 3> position{};
  double scale = 0.0;

  explicit CameraState(EditWindow& scene)
    : scale(scene.camera()->GetParallelScale())
  {
    scene.camera()->GetPosition(this->position.data());
  }
  bool operator==(const CameraState& other) const
  {
    return this->position == other.position && this->scale == other.scale;
  }
};

// Everything that is not the left button or a widget's own, in the midst of a drag.
inline void disturb(EditWindow& scene)
{
  for (const char* key : { "x", "w", "q", "b", "r", "6", "Delete" })
  {
    scene.key(key);
  }
  scene.event(vtkCommand::MiddleButtonPressEvent, 200, 150);
  scene.move(240, 170);
  scene.event(vtkCommand::MiddleButtonReleaseEvent, 240, 170);
  scene.event(vtkCommand::MouseWheelForwardEvent, 200, 150);
}

} // namespace oversketch_test
#endif
