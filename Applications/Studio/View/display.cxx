#include "display.h"

#include "camera_state.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace oversketch_studio
{

namespace
{

constexpr int square[2] = { 1, 1 };
constexpr double across = 10.0;        // lines for the model's width, about
constexpr double headIntensity = 0.86; // white with a model's shine is then just below white

// 1, 2 or 5 times a power of ten.
double roundNumber(double about)
{
  const double ten = std::pow(10.0, std::floor(std::log10(about)));
  const double of = about / ten;
  return ten * (of < 1.5 ? 1.0 : of < 3.5 ? 2.0 : of < 7.5 ? 5.0 : 10.0);
}

// Across the axis that is up: from places on x and the other axis.
void addLine(vtkPolyData* to, int up, double x0, double other0, double x1, double other1, double height)
{
  const auto add = [&](double x, double other)
  {
    return up == 1 ? to->GetPoints()->InsertNextPoint(x, height, other)
                   : to->GetPoints()->InsertNextPoint(x, other, height);
  };
  const vtkIdType from = add(x0, other0);
  to->GetLines()->InsertNextCell({ from, add(x1, other1) });
}

} // namespace

Display::Display(vtkRenderer* renderer, ModelView& model)
  : Renderer(renderer)
  , Model(model)
{
  const auto addLines = [&](vtkPolyData* lines, vtkActor* actor)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(lines);
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    renderer->AddActor(actor);
  };
  this->Kit->SetKeyLightWarmth(0.55);
  this->Kit->SetKeyToFillRatio(2.5);
  this->Head->SetLightTypeToHeadlight();
  this->Head->SetIntensity(headIntensity);
  this->setLight(Light::Three);
  addLines(this->Lines, this->LineActor);
  addLines(this->Middle, this->MiddleActor);
  this->showGround(false);
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
  this->placeGround(whole, up);
}

void Display::fitAll(const int size[2])
{
  if (!this->Model.mesh())
  {
    return;
  }
  double whole[6];
  this->box().GetBounds(whole);
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

vtkBoundingBox Display::box() const
{
  const double none[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  return this->Others.box(this->Model.mesh() ? this->Model.mesh()->GetBounds() : none);
}

void Display::showWhole(const int size[2])
{
  const vtkBoundingBox box = this->box();
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

void Display::setLight(Light light)
{
  this->Renderer->RemoveAllLights();
  light == Light::Head ? this->Renderer->AddLight(this->Head)
                       : this->Kit->AddLightsToRenderer(this->Renderer);
  this->setLook({ this->Look.shading, light, this->Look.pictures, this->Look.plain });
}

void Display::castShadow(bool isHeld)
{
  if (!isHeld)
  {
    std::vector<vtkPolyData*> meshes = this->Other ? this->Other->drawn() : this->Model.drawn();
    const std::vector<vtkPolyData*> beside = this->Others.drawn();
    meshes.insert(meshes.end(), beside.begin(), beside.end());
    this->Shadow.cast(meshes);
  }
  this->Shadow.look();
}

void Display::setGround(bool shown)
{
  this->Ground = shown;
  this->showGround(shown);
}

void Display::showGround(bool shown)
{
  this->LineActor->SetVisibility(shown);
  this->MiddleActor->SetVisibility(shown);
}

void Display::placeGround(const double box[6], int up)
{
  this->Shadow.setGround(up, box[2 * up]);
  const int beside = 3 - up;
  const double width = std::max(box[1] - box[0], box[2 * beside + 1] - box[2 * beside]);
  for (vtkPolyData* lines : { this->Lines.Get(), this->Middle.Get() })
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    lines->SetPoints(points);
    lines->SetLines(cells);
  }
  if (!(width > 0.0) || !std::isfinite(width))
  {
    return;
  }
  const double step = roundNumber(width / across), height = box[2 * up];
  const auto first = [&](int axis) { return std::floor((box[2 * axis] - 0.5 * width) / step); };
  const auto last = [&](int axis) { return std::ceil((box[2 * axis + 1] + 0.5 * width) / step); };
  const double x0 = first(0), x1 = last(0), z0 = first(beside), z1 = last(beside);
  for (double i = x0; i <= x1; ++i)
  {
    addLine(i == 0.0 ? this->Middle : this->Lines, up, i * step, z0 * step, i * step, z1 * step, height);
  }
  for (double i = z0; i <= z1; ++i)
  {
    addLine(i == 0.0 ? this->Middle : this->Lines, up, x0 * step, i * step, x1 * step, i * step, height);
  }
}

void Display::showOnion(vtkPolyData* mesh)
{
  for (const int i : { 0, 1 })
  {
    this->OnionMappers[i]->SetInputData(mesh);
    this->Onions[i]->SetVisibility(mesh != nullptr);
  }
}

void Display::showInstead(vtkPolyData* mesh, bool coloured)
{
  this->Other.reset();
  if (mesh)
  {
    this->Other = std::make_unique<ModelView>(this->Renderer);
    ModelLook look = this->Look;
    if (coloured)
    {
      look.shading = look.shading == Shading::Matcap ? Shading::Smooth : look.shading;
      look.pictures = true;
    }
    this->Other->setLook(look);
    this->Other->show(mesh);
  }
  this->Model.setVisible(!mesh);
}

void Display::setDark(bool dark)
{
  const double line = dark ? 0.30 : 0.70, middle = dark ? 0.45 : 0.52;
  this->LineActor->GetProperty()->SetColor(line, line, line);
  this->MiddleActor->GetProperty()->SetColor(middle, middle, middle);
  for (const int i : { 0, 1 })
  {
    dark ? this->Onions[i]->GetProperty()->SetColor(0.45, 0.70, 1.0)
         : this->Onions[i]->GetProperty()->SetColor(0.20, 0.45, 0.85);
  }
}

void Display::setOverlays(bool shown)
{
  this->showGround(shown && this->Ground);
  for (const int i : { 0, 1 })
  {
    this->Onions[i]->SetVisibility(shown && this->OnionMappers[i]->GetInput());
  }
}

} // namespace oversketch_studio
