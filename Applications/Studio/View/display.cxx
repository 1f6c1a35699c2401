#include "display.h"

#include "camera_state.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace oversketch_studio
{

namespace
{

constexpr int square[2] = { 1, 1 };

} // namespace

Display::Display(vtkRenderer* renderer, ModelView& model)
  : Renderer(renderer)
  , Model(model)
  , Grid(renderer)
{
  for (const int i : { 0, 1 })
  {
    vtkPolyDataMapper* mapper = this->OnionMappers[i];
    mapper->ScalarVisibilityOff();
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    // Where it lies in the model's surface the model is seen; the faint one is over the model everywhere.
    i == 0 ? mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 200.0)
           : mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, -60000.0);
    vtkActor* onion = this->Onions[i];
    onion->SetMapper(mapper);
    onion->GetProperty()->SetOpacity(i == 0 ? 0.5 : 0.12);
    onion->GetProperty()->BackfaceCullingOn();
    onion->PickableOff();
    onion->VisibilityOff();
    renderer->AddActor(onion);
  }
}

Display::~Display() = default;

void Display::lookAtAll(const double box[6], const int size[2], int up)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const bool isFlat = box[5] - box[4] < 0.5 * std::min(box[1] - box[0], box[3] - box[2]);
  const bool fromY = up == 2 && !isFlat;
  camera->SetPosition(0.0, fromY ? -1.0 : 0.0, fromY ? 0.0 : 1.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, fromY ? 0.0 : 1.0, fromY ? 1.0 : 0.0);
  camera->SetWindowCenter(0.0, 0.0);
  const vtkBoundingBox all = this->Others.box(box);
  double whole[6];
  all.GetBounds(whole);
  this->stepBack(whole, size);
  this->Grid.place(whole, up);
}

void Display::fitAll(const int size[2])
{
  if (!this->Model.mesh())
  {
    return;
  }
  double whole[6];
  this->Others.box(this->Model.mesh()->GetBounds()).GetBounds(whole);
  this->Renderer->GetActiveCamera()->SetWindowCenter(0.0, 0.0);
  this->stepBack(whole, size);
  this->Renderer->ResetCameraClippingRange();
}

// To the same place in all windows: one that is narrower than high has a wider angle.
void Display::stepBack(const double box[6], const int size[2])
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetUseHorizontalViewAngle(size[0] < size[1]);
  this->Renderer->ResetCamera(box); // sets VTK's own angle
  camera->SetUseHorizontalViewAngle(false);
  oversketch::CameraState state(camera);
  state.fit(square, size);
  camera->SetViewAngle(state.angle);
}

void Display::showWhole(const int size[2])
{
  const double none[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  const vtkBoundingBox box = this->Others.box(this->Model.mesh() ? this->Model.mesh()->GetBounds() : none);
  bool isWhole = true;
  for (int i = 0; box.IsValid() && i < 8; ++i)
  {
    double corner[3];
    box.GetCorner(i, corner);
    this->Renderer->SetWorldPoint(corner[0], corner[1], corner[2], 1.0);
    this->Renderer->WorldToView();
    const double* seen = this->Renderer->GetViewPoint();
    isWhole = isWhole && std::abs(seen[0]) < 1.0 && std::abs(seen[1]) < 1.0;
  }
  if (!isWhole)
  {
    double whole[6];
    box.GetBounds(whole);
    this->stepBack(whole, size);
  }
  this->Renderer->ResetCameraClippingRange();
}

void Display::setLook(const ModelLook& look)
{
  this->Look = look;
  this->Model.setLook(look);
  this->Others.setLook(look);
  if (this->Other)
  {
    this->Other->setLook(look);
  }
}

void Display::setGround(bool shown)
{
  this->Ground = shown;
  this->Grid.setVisible(shown);
}

void Display::showOnion(vtkPolyData* mesh)
{
  for (const int i : { 0, 1 })
  {
    this->OnionMappers[i]->SetInputData(mesh);
    this->Onions[i]->SetVisibility(mesh != nullptr);
  }
}

bool Display::onion() const
{
  return this->Onions[0]->GetVisibility();
}

void Display::showInstead(vtkPolyData* mesh)
{
  this->Other.reset();
  if (mesh)
  {
    this->Other = std::make_unique<ModelView>(this->Renderer);
    this->Other->setLook(this->Look);
    this->Other->show(mesh);
  }
  this->Model.setVisible(!mesh);
}

void Display::setDark(bool dark)
{
  this->Grid.setDark(dark);
  for (const int i : { 0, 1 })
  {
    dark ? this->Onions[i]->GetProperty()->SetColor(0.45, 0.70, 1.0)
         : this->Onions[i]->GetProperty()->SetColor(0.20, 0.45, 0.85);
  }
}

void Display::setOverlays(bool shown)
{
  this->Grid.setVisible(shown && this->Ground);
  for (const int i : { 0, 1 })
  {
    this->Onions[i]->SetVisibility(shown && this->OnionMappers[i]->GetInput());
  }
}

} // namespace oversketch_studio
