// The widgets of the edit, each in a window of its own. Header-only.
#ifndef oversketch_widgets_edit_testing_widget_scenes_h
#define oversketch_widgets_edit_testing_widget_scenes_h

#include "edit_scene.h"
#include "vtkOversketchAreaSelectRepresentation.h"
#include "vtkOversketchAreaSelectWidget.h"
#include "vtkOversketchAxisHandleRepresentation.h"
#include "vtkOversketchAxisHandleWidget.h"
#include "vtkOversketchLayerHandleRepresentation.h"
#include "vtkOversketchLayerHandleWidget.h"
#include "vtkOversketchProfilePlaneRepresentation.h"
#include "vtkOversketchProfilePlaneWidget.h"
#include "vtkOversketchProfileRepresentation.h"
#include "vtkOversketchRegionRepresentation.h"
#include "vtkOversketchRegionWidget.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkPointData.h"

#include <set>

namespace oversketch_test
{

struct RegionScene : EditWindow
{
  vtkSmartPointer<vtkOversketchRegionWidget> widget = vtkSmartPointer<vtkOversketchRegionWidget>::New();

  RegionScene()
  {
    this->widget->SetModel(this->mesh);
    this->widget->SetInteractor(this->interactor);
    this->widget->On();
    this->window->Render();
  }
  vtkOversketchRegionRepresentation* shown() { return this->widget->GetRegionRepresentation(); }
  void drawBoth()
  {
    this->play("region_line.log");
    this->play("region_ring.log");
  }
  void reset()
  {
    this->widget->SetRegion(nullptr, nullptr);
    this->lookFromFront();
  }
};

struct AxisScene : EditWindow
{
  BallRegion region{ *this };
  vtkSmartPointer<vtkOversketchAxisHandleWidget> widget =
    vtkSmartPointer<vtkOversketchAxisHandleWidget>::New();

  AxisScene()
  {
    EXPECT_TRUE(this->widget->SetCurve(this->region.line, this->region.mesh()));
    this->widget->SetInteractor(this->interactor);
    this->widget->On();
    this->window->Render();
  }
  vtkOversketchAxisHandleRepresentation* shown() { return this->widget->GetAxisHandleRepresentation(); }
  std::string operations() { return this->widget->GetOperations(); }
  // Where a handle at the middle of the line is seen.
  Vector2 middle()
  {
    const vtkIdType count = this->region.line->GetNumberOfPoints();
    double length = 0.0, before = 0.0;
    const auto at = [&](vtkIdType i) { return Vector3(this->region.line->GetPoint(i)); };
    for (vtkIdType i = 1; i < count; ++i)
    {
      length += (at(i) - at(i - 1)).norm();
    }
    for (vtkIdType i = 1; i < count; ++i)
    {
      const double step = (at(i) - at(i - 1)).norm();
      if (before + step >= 0.5 * length)
      {
        const Vector3 p = at(i - 1) + (0.5 * length - before) / step * (at(i) - at(i - 1));
        const auto px = this->display({ p[0], p[1], p[2] });
        return { px[0], px[1] };
      }
      before += step;
    }
    return { 0.0, 0.0 };
  }
  void reset()
  {
    this->widget->SetOperations("");
    this->widget->SetCurve(this->region.line, this->region.mesh());
    this->lookFromFront();
  }
};

// A widget on the disc, which fills most of the window's height, or on the model.
template <class Widget, class Representation>
struct SideScene : EditWindow
{
  BallRegion region{ *this };
  vtkSmartPointer<Widget> widget = vtkSmartPointer<Widget>::New();

  explicit SideScene(bool onDisc)
    : EditWindow(!onDisc)
  {
    EXPECT_TRUE(this->widget->SetRegion(this->region.mesh()));
    onDisc ? this->shown()->SetSideToDisc() : this->shown()->SetSideToModel();
    this->camera()->SetParallelScale(onDisc ? 1.1 : 1.5);
    this->widget->SetInteractor(this->interactor);
    this->widget->On();
    this->renderer->ResetCameraClippingRange();
    this->window->Render();
  }
  Representation* shown()
  {
    this->widget->CreateDefaultRepresentation();
    return Representation::SafeDownCast(this->widget->GetRepresentation());
  }
};

struct LayerScene : SideScene<vtkOversketchLayerHandleWidget, vtkOversketchLayerHandleRepresentation>
{
  explicit LayerScene(bool onDisc = true)
    : SideScene(onDisc)
  {
  }
  std::string layers() { return this->widget->GetLayers(); }
  std::vector<double> weights()
  {
    this->region.system->SetLayers(this->widget->GetLayers());
    return this->region.weights();
  }
  // From the disc's middle to its rim at the top, where a share is.
  int heightOf(double share)
  {
    for (int y = 150; y < 299; ++y)
    {
      if (this->shown()->GetShareAt(200, y) >= share)
      {
        return y;
      }
    }
    return 299;
  }
  std::set<int> greys()
  {
    std::set<int> found;
    this->window->Render();
    for (int y = 152; y < 280; ++y)
    {
      const auto p = this->pixel(190, y);
      if (p[0] == p[1] && p[1] == p[2])
      {
        found.insert(p[0]);
      }
    }
    return found;
  }
  void reset()
  {
    this->widget->SetLayers("");
    this->lookFromFront();
  }
};

struct AreaScene : SideScene<vtkOversketchAreaSelectWidget, vtkOversketchAreaSelectRepresentation>
{
  explicit AreaScene(bool onDisc = true)
    : SideScene(onDisc)
  {
  }
  vtkPolyData* areas() { return this->widget->GetAreas(); }
  std::vector<double> weights() { return this->region.weights(); }
  void reset()
  {
    this->widget->SetAreas(nullptr);
    this->widget->SetRegion(this->region.mesh());
    this->lookFromFront();
  }
};

struct ProfileScene : EditWindow
{
  BallRegion region{ *this };
  Window flat{ 400, 300 };
  vtkNew<vtkOversketchInteractorStyle> flatStyle;
  vtkSmartPointer<vtkOversketchProfilePlaneWidget> widget =
    vtkSmartPointer<vtkOversketchProfilePlaneWidget>::New();

  ProfileScene()
  {
    this->flat.interactor->SetInteractorStyle(this->flatStyle);
    this->flat.window->Render();
    this->widget->SetProfileRenderer(this->flat.renderer);
    EXPECT_TRUE(this->widget->SetRegion(this->region.mesh(), this->region.line, this->region.ring()));
    this->widget->SetInteractor(this->interactor);
    this->widget->On();
    this->window->Render();
    this->flat.window->Render();
  }
  vtkOversketchProfilePlaneRepresentation* shown() { return this->widget->GetProfilePlaneRepresentation(); }
  // A place of the profile in its window.
  Vector2 inWindow(const Vector3& place)
  {
    const auto at = this->flat.display({ place[0], place[1], place[2] });
    return { at[0], at[1] };
  }
  // Draws the section anew, raised by `height` of its width times sin(pi t).
  void drawBump(double height)
  {
    vtkPolyData* section = this->widget->GetSectionProfile();
    vtkDataArray* shares = section->GetPointData()->GetArray("CurveT");
    const auto at = [&](vtkIdType i)
    {
      const double t = shares->GetComponent(i, 0);
      return this->inWindow(Vector3(section->GetPoint(i)) + height * std::sin(pi * t) * Vector3::UnitY());
    };
    // With a tablet's samples, which need not be whole pixels.
    vtkOversketchStrokeWidget* pen = this->widget->GetPen();
    pen->BeginStroke(at(0)[0], at(0)[1]);
    for (vtkIdType i = 1; i < section->GetNumberOfPoints(); ++i)
    {
      pen->AddSample(at(i)[0], at(i)[1]);
    }
    pen->EndStroke();
  }
  void reset()
  {
    this->flatStyle->ShowKeysOff();
    this->widget->GetPen()->Drop();
    this->widget->SetProfile(nullptr);
    this->widget->SetProfileAt(0.5);
    this->lookFromFront();
  }
};

} // namespace oversketch_test
#endif
