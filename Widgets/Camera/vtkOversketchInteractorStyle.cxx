#include "vtkOversketchInteractorStyle.h"

#include "Mesh/context.h"
#include "camera_drag.h"
#include "camera_keys.h"
#include "camera_moves.h"
#include "camera_state.h"
#include "mesh_picker.h"
#include "pen_view.h"
#include "widget_events.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkOversketchInteractorStyle);

namespace
{

using oversketch::CameraAction;
using oversketch::CameraDrag;
using oversketch::CameraState;
using oversketch::FirstView;

constexpr double stepOfZoom = 1.1;

enum Button
{
  Left,
  Middle,
  Right
};

} // namespace

struct vtkOversketchInteractorStyle::Internals
{
  vtkOversketchInteractorStyle* style;
  std::vector<FirstView> firstViews;
  std::unique_ptr<CameraDrag> drag;
  oversketch::MeshPicker picker;
  oversketch::KeyList keyList;
  std::string keyText; // the host's
  unsigned long charTag = 0;

  explicit Internals(vtkOversketchInteractorStyle* self)
    : style(self)
  {
  }

  vtkRenderWindowInteractor* interactor() const { return this->style->Interactor; }

  vtkRenderer* renderer() const
  {
    if (!this->style->CurrentRenderer && this->interactor())
    {
      const int* at = this->interactor()->GetEventPosition();
      this->style->FindPokedRenderer(at[0], at[1]);
    }
    return this->style->CurrentRenderer;
  }

  // Turns to the renderer under the cursor, outside a drag.
  void poke()
  {
    if (!this->drag)
    {
      const int* at = this->interactor()->GetEventPosition();
      this->style->FindPokedRenderer(at[0], at[1]);
    }
  }

  // The first view of the renderer's camera; null without a camera and, unless it is to be remembered now,
  // before the style first changed it.
  FirstView* firstView(bool remember = true)
  {
    vtkRenderer* in = this->renderer();
    if (!in || !in->IsActiveCameraCreated())
    {
      return nullptr;
    }
    auto& views = this->firstViews;
    views.erase(
      std::remove_if(views.begin(), views.end(), [](const FirstView& v) { return !v.camera; }), views.end());
    vtkCamera* camera = in->GetActiveCamera();
    const auto known =
      std::find_if(views.begin(), views.end(), [&](const FirstView& v) { return v.camera == camera; });
    if (known != views.end())
    {
      return &*known;
    }
    return remember ? &views.emplace_back(FirstView{ camera, CameraState(camera), 0.0 }) : nullptr;
  }

  void show()
  {
    vtkRenderer* in = this->style->CurrentRenderer;
    if (this->style->AutoAdjustCameraClippingRange)
    {
      in->ResetCameraClippingRange();
    }
    if (this->interactor()->GetLightFollowCamera())
    {
      in->UpdateLightsGeometryToFollowCamera();
    }
    this->style->InvokeEvent(vtkCommand::InteractionEvent);
    this->interactor()->Render();
  }

  // One step of the camera, outside a drag.
  template <typename Change>
  void step(const Change& change)
  {
    FirstView* first = this->drag ? nullptr : this->firstView();
    if (first)
    {
      this->style->InvokeEvent(vtkCommand::StartInteractionEvent);
      change(*first);
      this->show();
      this->style->InvokeEvent(vtkCommand::EndInteractionEvent);
    }
  }

  void wheel(double steps)
  {
    this->poke();
    const int* at = this->interactor()->GetEventPosition();
    this->style->ZoomAt(std::pow(stepOfZoom, steps), at[0], at[1]);
  }
  // Where a display position is across the view [-1 to 1].
  Eigen::Vector2d across(double x, double y) const
  {
    vtkRenderer* in = this->renderer();
    const int *origin = in->GetOrigin(), *size = in->GetSize();
    return { 2.0 * (x - origin[0]) / std::max(1, size[0]) - 1.0,
      2.0 * (y - origin[1]) / std::max(1, size[1]) - 1.0 };
  }
  Eigen::Vector3d middle(const CameraState& camera) const
  {
    const auto models = oversketch::modelsIn(this->renderer());
    return models ? models->centre : camera.focal;
  }
  double height() const { return std::max(1, this->renderer()->GetSize()[1]); } // px
  void press(Button button, int state);
  void move();
  void release(Button button);
  void endDrag();
  void act(const CameraAction& action);
  void updateKeyList();

  bool swallowChar(vtkObject*, unsigned long, void*) { return this->action().kind != CameraAction::None; }
  // The meaning of the key in the interactor.
  CameraAction action() const
  {
    vtkRenderWindowInteractor* keys = this->interactor();
    if (!keys || !keys->GetKeySym() || keys->GetControlKey() || keys->GetAltKey())
    {
      return {};
    }
    return oversketch::cameraAction(keys->GetKeySym(), keys->GetShiftKey() != 0);
  }
};

void vtkOversketchInteractorStyle::Internals::press(Button button, int state)
{
  this->poke();
  FirstView* first = this->drag ? nullptr : this->firstView();
  if (!first)
  {
    return;
  }
  const int* at = this->interactor()->GetEventPosition();
  const auto kind = state == VTKIS_PAN    ? CameraDrag::Kind::Pan
                    : state == VTKIS_ZOOM ? CameraDrag::Kind::Zoom
                    : this->style->Orbit == vtkOversketchInteractorStyle::Trackball
                      ? CameraDrag::Kind::Trackball
                      : CameraDrag::Kind::Turntable;
  this->drag = std::make_unique<CameraDrag>(
    kind, button, at[0], at[1], this->style->CurrentRenderer, this->picker, *first, this->style->UpAxis);
  this->style->GrabFocus(this->style->EventCallbackCommand);
  this->style->StartState(state);
}

void vtkOversketchInteractorStyle::Internals::move()
{
  FirstView* first = this->drag ? this->firstView() : nullptr;
  if (first)
  {
    const int* at = this->interactor()->GetEventPosition();
    this->drag->move(at[0], at[1], *first);
    this->show();
  }
}

void vtkOversketchInteractorStyle::Internals::release(Button button)
{
  if (this->drag && this->drag->button() == button)
  {
    FirstView* first = this->drag->hasMoved() ? nullptr : this->firstView();
    if (first)
    {
      this->drag->takeBack(first->camera);
    }
    this->endDrag();
  }
}

void vtkOversketchInteractorStyle::Internals::endDrag()
{
  this->drag.reset();
  this->style->ReleaseFocus();
  this->style->StopState();
}

void vtkOversketchInteractorStyle::Internals::act(const CameraAction& action)
{
  switch (action.kind)
  {
    case CameraAction::Look:
      return this->style->LookAlong(action.axis, action.sign < 0);
    case CameraAction::Reset:
      return this->style->ResetToFirstView();
    case CameraAction::Center:
      return this->style->CenterOnMesh();
    case CameraAction::ShowKeys:
      return this->style->SetShowKeys(!this->style->ShowKeys);
    case CameraAction::Quit:
      return this->interactor()->ExitCallback();
    case CameraAction::None:
      return;
    default:
      return this->step([&](FirstView& first) { oversketch::moveByKey(action, first); });
  }
}

void vtkOversketchInteractorStyle::Internals::updateKeyList()
{
  const bool own = this->keyText.empty();
  this->keyList.show(this->style->ShowKeys ? this->renderer() : nullptr,
    own ? oversketch::cameraHelp(this->style->Mode == Draw) : this->keyText);
}

vtkOversketchInteractorStyle::vtkOversketchInteractorStyle()
  : Inner(std::make_unique<Internals>(this))
{
}

vtkOversketchInteractorStyle::~vtkOversketchInteractorStyle()
{
  this->SetInteractor(nullptr);
}

void vtkOversketchInteractorStyle::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  if (interactor == this->Interactor)
  {
    return;
  }
  Internals& inner = *this->Inner;
  if (this->Interactor)
  {
    if (inner.drag)
    {
      inner.drag.reset();
      this->ReleaseFocus();
      this->State = VTKIS_NONE;
    }
    this->Interactor->RemoveObserver(inner.charTag);
    inner.keyList.show(nullptr, {});
    this->SetCurrentRenderer(nullptr);
  }
  this->Superclass::SetInteractor(interactor);
  if (interactor)
  {
    // Before any widget, which would switch itself off on i.
    inner.charTag = interactor->AddObserver(vtkCommand::CharEvent, &inner, &Internals::swallowChar, 1.0f);
  }
}

void vtkOversketchInteractorStyle::SetMode(int mode)
{
  const int clamped = std::clamp<int>(mode, Navigate, Draw);
  if (clamped != this->Mode)
  {
    this->Mode = clamped;
    this->Inner->updateKeyList();
    this->Modified();
  }
}

void vtkOversketchInteractorStyle::TurnBy(double x, double y)
{
  this->Inner->step(
    [&](FirstView& first)
    {
      const Eigen::Vector3d about = this->Inner->middle(CameraState(first.camera));
      CameraState camera = oversketch::straightened(CameraState(first.camera), about, this->CurrentRenderer);
      camera.turn(
        oversketch::turntableTurn(camera, Eigen::Vector2d(x, y) / this->Inner->height(), this->UpAxis),
        about);
      camera.putInto(first.camera);
    });
}

void vtkOversketchInteractorStyle::PanBy(double x, double y)
{
  this->Inner->step(
    [&](FirstView& first)
    {
      CameraState camera(first.camera);
      const Eigen::Vector3d right = camera.direction().cross(camera.up).normalized();
      camera.move(-oversketch::viewHeight(first.camera) / this->Inner->height() *
                  (x * right + y * right.cross(camera.direction())));
      camera.putInto(first.camera);
    });
}

void vtkOversketchInteractorStyle::ZoomAt(double factor, double x, double y)
{
  if (std::isfinite(factor) && factor > 0.0)
  {
    this->Inner->step(
      [&](FirstView& first) { first.setZoom(first.zoom() * factor, this->Inner->across(x, y)); });
  }
}

void vtkOversketchInteractorStyle::SetParallelProjection(bool parallel)
{
  if (parallel != this->GetParallelProjection())
  {
    this->Inner->step([&](FirstView& first) { first.setParallel(parallel); });
  }
}

bool vtkOversketchInteractorStyle::GetParallelProjection()
{
  const FirstView* first = this->Inner->firstView(false);
  return first && first->camera->GetParallelProjection() != 0;
}

void vtkOversketchInteractorStyle::SetShowKeys(bool show)
{
  if (show != this->ShowKeys)
  {
    this->ShowKeys = show;
    this->Inner->updateKeyList();
    this->Modified();
    if (this->Interactor)
    {
      this->Interactor->Render();
    }
  }
}

void vtkOversketchInteractorStyle::SetKeyList(const char* text)
{
  const std::string given = text ? text : "";
  if (given != this->Inner->keyText)
  {
    this->Inner->keyText = given;
    this->Inner->updateKeyList();
    this->Modified();
  }
}

const char* vtkOversketchInteractorStyle::GetKeyList() const
{
  return this->Inner->keyText.empty() ? nullptr : this->Inner->keyText.c_str();
}

void vtkOversketchInteractorStyle::SetZoom(double zoom)
{
  if (std::isfinite(zoom) && zoom != this->GetZoom())
  {
    this->Inner->step([&](FirstView& first) { first.setZoom(zoom); });
    this->Modified();
  }
}

double vtkOversketchInteractorStyle::GetZoom()
{
  const FirstView* first = this->Inner->firstView(false);
  return first ? first->zoom() : 1.0;
}

void vtkOversketchInteractorStyle::SetSpin(double degrees)
{
  if (std::isfinite(degrees) && degrees != this->GetSpin())
  {
    this->Inner->step([&](FirstView& first) { first.roll(degrees - first.spin); });
    this->Modified();
  }
}

double vtkOversketchInteractorStyle::GetSpin()
{
  const FirstView* first = this->Inner->firstView(false);
  return first ? first->spin : 0.0;
}

void vtkOversketchInteractorStyle::SaveFirstView()
{
  if (FirstView* first = this->Inner->firstView())
  {
    first->state = CameraState(first->camera);
    first->spin = 0.0;
    this->Modified();
  }
}

void vtkOversketchInteractorStyle::ResetToFirstView()
{
  this->Inner->step(
    [](FirstView& first)
    {
      first.state.putInto(first.camera);
      first.spin = 0.0;
    });
}

void vtkOversketchInteractorStyle::CenterOnMesh()
{
  this->Inner->step(
    [this](FirstView& first)
    {
      CameraState camera(first.camera);
      camera.move(this->Inner->middle(camera) - camera.focal);
      camera.centre.setZero();
      camera.putInto(first.camera);
    });
}

void vtkOversketchInteractorStyle::LookAlong(int axis, bool against)
{
  this->Inner->step(
    [&](FirstView& first)
    {
      CameraState camera(first.camera);
      const int a = std::clamp(axis, 0, 2);
      camera.position =
        camera.focal - (against ? -1.0 : 1.0) * first.camera->GetDistance() * Eigen::Vector3d::Unit(a);
      camera.up = Eigen::Vector3d::Unit(a == this->UpAxis ? 3 - this->UpAxis : this->UpAxis);
      camera.centre.setZero();
      camera.putInto(first.camera);
      first.spin = 0.0;
    });
}

void vtkOversketchInteractorStyle::LookFromSide(int axis, bool negative)
{
  this->Inner->step(
    [&](FirstView& first)
    {
      CameraState camera(first.camera);
      oversketch::lookFromSide(
        camera, this->Inner->middle(camera), std::clamp(axis, 0, 2), negative, this->UpAxis);
      camera.putInto(first.camera);
      first.spin = 0.0;
    });
}

bool vtkOversketchInteractorStyle::LookFrom(vtkPolyData* stroke)
{
  vtkRenderer* in = this->Inner->drag ? nullptr : this->Inner->renderer();
  if (!in || !stroke)
  {
    return false;
  }
  try
  {
    const auto view = oversketch::PenView::of(stroke);
    in->GetActiveCamera(); // makes one where there is none
    this->Inner->step([&](FirstView&) { view.putInto(in); });
    return true;
  }
  catch (const oversketch::Error&)
  {
    return false;
  }
}

bool vtkOversketchInteractorStyle::FollowSize(const int before[2], const int now[2])
{
  vtkRenderer* in = this->Inner->drag ? nullptr : this->Inner->renderer();
  if (!in || !in->IsActiveCameraCreated())
  {
    return false;
  }
  if (FirstView* first = this->Inner->firstView(false))
  {
    first->state.fit(before, now);
  }
  CameraState camera(in->GetActiveCamera());
  camera.fit(before, now);
  camera.putInto(in->GetActiveCamera());
  return true;
}

void vtkOversketchInteractorStyle::OnMouseMove()
{
  this->Inner->move();
}

void vtkOversketchInteractorStyle::OnLeftButtonDown()
{
  const bool control = this->Interactor->GetControlKey(), alt = this->Interactor->GetAltKey();
  const bool shift = this->Interactor->GetShiftKey();
  if (control || alt || shift || this->Mode == Navigate)
  {
    this->Inner->press(Left, !shift ? VTKIS_ROTATE : control ? VTKIS_ZOOM : VTKIS_PAN);
  }
}

void vtkOversketchInteractorStyle::OnLeftButtonUp()
{
  this->Inner->release(Left);
}

void vtkOversketchInteractorStyle::OnMiddleButtonDown()
{
  this->Inner->press(Middle,
    this->Interactor->GetShiftKey() || this->Interactor->GetAltKey() ? VTKIS_PAN
    : this->Interactor->GetControlKey()                              ? VTKIS_ZOOM
                                                                     : VTKIS_ROTATE);
}

void vtkOversketchInteractorStyle::OnMiddleButtonUp()
{
  this->Inner->release(Middle);
}

void vtkOversketchInteractorStyle::OnRightButtonDown()
{
  this->Inner->press(Right, VTKIS_PAN);
}

void vtkOversketchInteractorStyle::OnRightButtonUp()
{
  this->Inner->release(Right);
}

void vtkOversketchInteractorStyle::OnMouseWheelForward()
{
  this->Inner->wheel(this->MouseWheelMotionFactor);
}

void vtkOversketchInteractorStyle::OnMouseWheelBackward()
{
  this->Inner->wheel(-this->MouseWheelMotionFactor);
}

void vtkOversketchInteractorStyle::OnKeyPress()
{
  Internals& inner = *this->Inner;
  if (inner.drag)
  {
    if (oversketch::keyOf(this->Interactor) == "Escape")
    {
      if (FirstView* first = inner.firstView())
      {
        inner.drag->takeBack(first->camera);
        inner.show();
      }
      inner.endDrag();
    }
    return;
  }
  const CameraAction action = inner.action();
  if (action.kind != CameraAction::None)
  {
    inner.poke();
    inner.act(action);
  }
}

void vtkOversketchInteractorStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "Orbit: " << this->Orbit << "\n";
  os << indent << "UpAxis: " << this->UpAxis << "\n";
  os << indent << "ParallelProjection: " << this->GetParallelProjection() << "\n";
  os << indent << "Zoom: " << this->GetZoom() << "\n";
  os << indent << "Spin: " << this->GetSpin() << "\n";
  os << indent << "ShowKeys: " << this->ShowKeys << "\n";
  os << indent << "KeyList: " << (this->GetKeyList() ? this->GetKeyList() : "(none)") << "\n";
}
