#include "vtkOversketchLayerHandleRepresentation.h"

#include "drawn_curve.h"
#include "edit_overlay.h"
#include "pen_view.h"
#include "region_patch.h"

#include "Mesh/context.h"
#include "Shading/layer_list.h"
#include "vtkOversketchCarriedArrays.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchLayerHandleRepresentation);

namespace
{

constexpr int steps = 1024;         // of a share, in the texture
constexpr double nearCurve = 0.003; // a handle's line on a curve is drawn beside it

} // namespace

struct vtkOversketchLayerHandleRepresentation::Internals
{
  std::unique_ptr<RegionPatch> patch;
  int patches = 0; // that were made
  LayerList list;
  std::vector<LayerHandle> shown;  // where they are held
  std::map<double, Vector2> knobs; // by rest, the place on the disc that each is to be near to
  vtkNew<vtkPolyData> greys;
  vtkNew<vtkPolyDataNormals> normals;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkTexture> texture;
  vtkNew<vtkActor> actor;
  vtkNew<vtkImageData> ramp;
  vtkSmartPointer<vtkImageData> display;
  double box[6] = { -1.0, 1.0, -1.0, 1.0, 0.0, 0.0 };

  void layOut(PatchSide side);
  void place(PatchSide side);
  void paintRamp(const oversketch::Layers& layers);
  Vector3 knobOf(PatchSide side, const LayerHandle& handle) const;
  // Place of the region under one of the window; none where a camera sees nothing.
  SurfaceHit under(vtkRenderer* renderer, PatchSide side, double x, double y) const
  {
    try
    {
      return this->patch && renderer
               ? this->patch->under(side, PenView::of(renderer).kernelView(), inViewport(renderer, x, y))
               : SurfaceHit();
    }
    catch (const Error&)
    {
      return {};
    }
  }
  // Line of a handle.
  std::vector<std::array<Vector3, 2>> lineOf(PatchSide side, const LayerHandle& handle) const
  {
    return this->patch->level(side, std::clamp(handle.place, nearCurve, 1.0 - nearCurve));
  }
};

// The patch with the coordinates of both textures: by share and by place on the disc.
void vtkOversketchLayerHandleRepresentation::Internals::layOut(PatchSide side)
{
  this->greys->Initialize();
  if (this->patch)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkFloatArray> byShare, byDisc;
    byShare->SetName("ByShare");
    byDisc->SetName("ByDisc");
    byShare->SetNumberOfComponents(2);
    byDisc->SetNumberOfComponents(2);
    const Mesh& mesh = this->patch->shape(side);
    const Mesh& disc = this->patch->shape(PatchSide::Disc);
    points->SetNumberOfPoints(mesh.vertexCount());
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      byShare->InsertNextTuple2(this->patch->shares()[i], 0.5);
      byDisc->InsertNextTuple2(0.5 * (disc.points[i][0] + 1.0), 0.5 * (disc.points[i][1] + 1.0));
    }
    this->greys->SetPoints(points);
    this->greys->SetPolys(CellsOf(mesh.triangles));
    this->greys->GetPointData()->AddArray(byShare);
    this->greys->GetPointData()->AddArray(byDisc);
    this->greys->GetPointData()->SetActiveTCoords(this->display ? "ByDisc" : "ByShare");
    this->place(side);
  }
  this->actor->SetVisibility(this->patch != nullptr);
  const bool flat = side == PatchSide::Disc;
  this->actor->GetProperty()->SetLighting(!flat);
  this->texture->SetInputData(this->display ? this->display.Get() : this->ramp.Get());
}

// Where the patch's vertices are.
void vtkOversketchLayerHandleRepresentation::Internals::place(PatchSide side)
{
  const Mesh& mesh = this->patch->shape(side);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    this->greys->GetPoints()->SetPoint(v, mesh.points[v].data());
  }
  this->greys->GetPoints()->Modified();
  this->greys->GetBounds(this->box);
}

void vtkOversketchLayerHandleRepresentation::Internals::paintRamp(const oversketch::Layers& layers)
{
  auto* greyScale = static_cast<vtkUnsignedCharArray*>(this->ramp->GetPointData()->GetScalars());
  for (int i = 0; i < steps; ++i)
  {
    const auto grey = static_cast<unsigned char>(layers.grey(layers.level((i + 0.5) / steps)));
    const unsigned char rgb[3] = { grey, grey, grey };
    greyScale->SetTypedTuple(i, rgb);
  }
  greyScale->Modified();
  this->ramp->Modified();
}

Vector3 vtkOversketchLayerHandleRepresentation::Internals::knobOf(PatchSide side,
  const LayerHandle& handle) const
{
  const double share = std::clamp(handle.place, nearCurve, 1.0 - nearCurve);
  const auto known = this->knobs.find(handle.rest);
  const Vector2 wanted = known != this->knobs.end() ? known->second : Vector2(2.0, 0.0);
  const auto onDisc = this->patch->level(PatchSide::Disc, share), there = this->patch->level(side, share);
  double least = std::numeric_limits<double>::infinity();
  Vector3 place = Vector3::Zero();
  for (std::size_t i = 0; i < onDisc.size(); ++i)
  {
    const double apart = (onDisc[i][0].head<2>() - wanted).norm();
    if (apart < least)
    {
      least = apart;
      place = there[i][0];
    }
  }
  return place;
}

vtkOversketchLayerHandleRepresentation::vtkOversketchLayerHandleRepresentation()
  : Inner(std::make_unique<Internals>())
{
  Internals& inner = *this->Inner;
  inner.ramp->SetDimensions(steps, 1, 1);
  inner.ramp->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  inner.texture->InterpolateOff();
  inner.texture->RepeatOff();
  inner.texture->EdgeClampOn();
  inner.normals->SetInputData(inner.greys);
  inner.normals->SplittingOff();
  inner.normals->ConsistencyOff();
  inner.mapper->SetInputConnection(inner.normals->GetOutputPort());
  inner.mapper->ScalarVisibilityOff();
  // Over the surface that it is a part of.
  inner.mapper->SetResolveCoincidentTopologyToPolygonOffset();
  inner.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, -200.0);
  inner.actor->SetMapper(inner.mapper);
  inner.actor->SetTexture(inner.texture);
  inner.actor->GetProperty()->SetAmbient(0.35);
  inner.actor->GetProperty()->SetDiffuse(0.65);
  inner.actor->PickableOff();
  this->AddActor(inner.actor);
  inner.layOut(PatchSide::Disc);
  this->Follow();
}

vtkOversketchLayerHandleRepresentation::~vtkOversketchLayerHandleRepresentation() = default;

void vtkOversketchLayerHandleRepresentation::Follow()
{
  Internals& inner = *this->Inner;
  inner.paintRamp(layersOf(inner.list, -1, this->Levels));
  LayerList list = inner.list; // which may not have the area
  inner.shown = oversketch::Layers(2, handlesIn(list, this->Area)).held();
  this->Modified();
}

bool vtkOversketchLayerHandleRepresentation::SetRegion(vtkPolyData* mesh)
{
  Internals& inner = *this->Inner;
  bool fits = true, isNew = true;
  try
  {
    isNew = followRegion(inner.patch, mesh);
    inner.patches += isNew && inner.patch ? 1 : 0;
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    fits = false;
  }
  if (isNew)
  {
    inner.layOut(patchSide(this->Side));
  }
  else if (this->Side == Model)
  {
    inner.place(PatchSide::Model);
  }
  this->Modified();
  return fits;
}

void vtkOversketchLayerHandleRepresentation::SetSide(int side)
{
  if (side != this->Side && (side == Disc || side == Model))
  {
    this->Side = side;
    this->Inner->layOut(patchSide(side));
    this->Modified();
  }
}

void vtkOversketchLayerHandleRepresentation::SetLevels(int levels)
{
  if (std::clamp(levels, 2, 256) != this->Levels)
  {
    this->Levels = std::clamp(levels, 2, 256);
    this->Follow();
  }
}

void vtkOversketchLayerHandleRepresentation::SetLayers(const char* text)
{
  const std::string now = text ? text : "";
  if (now == this->Layers)
  {
    return;
  }
  Internals& inner = *this->Inner;
  try
  {
    LayerList list = layerList(now);
    layersOf(list, -1, this->Levels);
    for (const AreaLayers& area : std::vector<AreaLayers>(list.areas))
    {
      layersOf(list, area.area, this->Levels);
    }
    inner.list = std::move(list);
    this->Layers = now;
    this->Follow();
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
  }
}

void vtkOversketchLayerHandleRepresentation::SetArea(int area)
{
  if (std::max(area, -1) != this->Area)
  {
    this->Area = std::max(area, -1);
    this->Follow();
  }
}

void vtkOversketchLayerHandleRepresentation::SetDisplay(vtkImageData* display)
{
  Internals& inner = *this->Inner;
  if (display != inner.display)
  {
    inner.display = display;
    inner.texture->SetInputData(display ? display : inner.ramp.Get());
    inner.greys->GetPointData()->SetActiveTCoords(display ? "ByDisc" : "ByShare");
    inner.greys->Modified();
    this->Modified();
  }
}

vtkImageData* vtkOversketchLayerHandleRepresentation::GetDisplay()
{
  return this->Inner->display;
}

double vtkOversketchLayerHandleRepresentation::GetShareAt(double x, double y)
{
  const SurfaceHit hit = this->Inner->under(this->Renderer, patchSide(this->Side), x, y);
  return hit.found() ? this->Inner->patch->shareAt(hit.at) : 1.0;
}

bool vtkOversketchLayerHandleRepresentation::IsOnRegion(double x, double y)
{
  return this->Inner->under(this->Renderer, patchSide(this->Side), x, y).found();
}

void vtkOversketchLayerHandleRepresentation::PutKnob(int handle, double x, double y)
{
  Internals& inner = *this->Inner;
  const SurfaceHit hit = inner.under(this->Renderer, patchSide(this->Side), x, y);
  if (hit.found() && handle >= 0 && handle < this->GetNumberOfHandles())
  {
    inner.knobs[inner.shown[static_cast<std::size_t>(handle)].rest] = inner.patch->discAt(hit.at);
    this->Modified();
  }
}

int vtkOversketchLayerHandleRepresentation::GetPatchCount() const
{
  return this->Inner->patches;
}

int vtkOversketchLayerHandleRepresentation::GetNumberOfHandles() const
{
  return static_cast<int>(this->Inner->shown.size());
}

int vtkOversketchLayerHandleRepresentation::FindGrip(const View& view, double x, double y)
{
  const Internals& inner = *this->Inner;
  int found = 0;
  double least = this->GetGrabDistance();
  for (std::size_t i = 0; inner.patch && i < inner.shown.size(); ++i)
  {
    for (const Polyline& piece : segmentsIn(view, inner.lineOf(patchSide(this->Side), inner.shown[i])))
    {
      const double apart = NearestPlace(piece)(Vector2(x, y)).distance;
      if (apart <= least)
      {
        least = apart;
        found = static_cast<int>(i) + 1;
      }
    }
  }
  return found;
}

void vtkOversketchLayerHandleRepresentation::Paint(const View& view, Overlay& overlay)
{
  const Internals& inner = *this->Inner;
  for (std::size_t i = 0; inner.patch && i < inner.shown.size(); ++i)
  {
    const bool isActive = this->GetActiveGrip() == static_cast<int>(i) + 1;
    overlay.rimmed(segmentsIn(view, inner.lineOf(patchSide(this->Side), inner.shown[i])),
      isActive ? 4.0 : 2.5,
      regionOrange,
      inkGrey);
    const Vector3 knob = inner.knobOf(patchSide(this->Side), inner.shown[i]);
    if (view.inFront(knob))
    {
      overlay.knob(view.toDisplay(knob).head<2>(), isActive ? 8.0 : 6.5, strokeRed);
    }
  }
}

double* vtkOversketchLayerHandleRepresentation::GetBounds()
{
  return this->Inner->patch ? this->Inner->box : nullptr;
}

void vtkOversketchLayerHandleRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Side: " << (this->Side == Disc ? "disc" : "model") << "\n";
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Area: " << this->Area << "\n";
  os << indent << "Handles: " << this->GetNumberOfHandles() << "\n";
  os << indent << "PatchCount: " << this->GetPatchCount() << "\n";
}
