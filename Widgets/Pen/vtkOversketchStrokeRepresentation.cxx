#include "vtkOversketchStrokeRepresentation.h"

#include "last_frame.h"
#include "pen_stroke.h"
#include "seen_line.h"
#include "vtkOversketchFilterTools.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <optional>
#include <vector>

vtkStandardNewMacro(vtkOversketchStrokeRepresentation);

namespace
{

using oversketch::inViewport;
using oversketch::Line2D;
using oversketch::linesOf;
using oversketch::PenStroke;
using oversketch::PenView;
using oversketch::seenIn;
using oversketch::Vector2;

} // namespace

struct vtkOversketchStrokeRepresentation::Internals
{
  vtkNew<vtkProperty2D> property, sectionProperty, crestProperty, footProperty;
  Line2D section{ sectionProperty }, feet{ footProperty }, crest{ crestProperty }, running{ property },
    kept{ property };
  vtkNew<vtkPolyData> crestLines;   // in the world
  std::optional<PenStroke> drawing; // while the pen is down
  PenStroke stroke;                 // drawn last
  bool over = false;                // the pen draws over it
  bool sectionFollows = false;      // the section is what is drawn
  oversketch::LastFrame frame;
  // State of the window's last frame: its size, and whether the stroke drawn last is in it.
  std::array<int, 2> shownSize{ 0, 0 };
  bool strokeShown = false;

  // In the order that they are drawn in; the crest is told from the stroke that it is seen beside.
  std::array<vtkActor2D*, 4> inThePicture() const
  {
    return { this->section.actor, this->feet.actor, this->running.actor, this->crest.actor };
  }
  bool hasCrest() const { return this->crestLines->GetNumberOfLines() > 0; }
  void placeCrest(const PenView& from)
  {
    std::vector<oversketch::WorldLine> strong, thin;
    vtkDataArray* parts = this->crestLines->GetCellData()->GetArray("Part");
    vtkIdType cell = 0;
    for (const oversketch::WorldLine& line : linesOf(this->crestLines))
    {
      (!parts || parts->GetComponent(cell++, 0) == 0.0 ? strong : thin).push_back(line);
    }
    const auto view = from.sight();
    this->crest.setAll(view ? seenIn(*view, strong) : std::vector<oversketch::Polyline>());
    this->feet.setAll(view ? seenIn(*view, thin) : std::vector<oversketch::Polyline>());
    this->footProperty->DeepCopy(this->crestProperty);
    this->footProperty->SetLineWidth(0.5F * this->crestProperty->GetLineWidth());
  }

  const PenStroke& current() const { return this->drawing ? *this->drawing : this->stroke; }
};

vtkOversketchStrokeRepresentation::vtkOversketchStrokeRepresentation()
  : Inner(std::make_unique<Internals>())
{
  this->Inner->property->SetColor(0.86, 0.13, 0.12);
  this->Inner->property->SetLineWidth(3.0);
  this->Inner->sectionProperty->SetColor(0.16, 0.42, 0.95);
  this->Inner->sectionProperty->SetLineWidth(4.0);
  this->Inner->crestProperty->SetColor(0.98, 0.62, 0.20);
  this->Inner->crestProperty->SetLineWidth(3.0);
  for (vtkActor2D* actor : this->Inner->inThePicture())
  {
    this->Inner->frame.overlay()->AddViewProp(actor);
  }
  this->PickableOff();
  this->DragableOff();
}

vtkOversketchStrokeRepresentation::~vtkOversketchStrokeRepresentation() = default;

void vtkOversketchStrokeRepresentation::BeginStroke(bool over)
{
  Internals& inner = *this->Inner;
  vtkRenderWindow* window = this->Renderer ? this->Renderer->GetRenderWindow() : nullptr;
  if (!window || inner.drawing)
  {
    return;
  }
  PenStroke begun;
  begun.view = PenView::of(this->Renderer);
  inner.over = over && inner.stroke.count() > 0 && inner.stroke.view == begun.view;
  inner.drawing = begun;
  inner.running.set({});
  // The frame that is kept must be of this size, and without a stroke that is not drawn over.
  const int* size = window->GetSize();
  if (inner.shownSize != std::array<int, 2>{ size[0], size[1] } || (inner.strokeShown && !inner.over))
  {
    window->Render();
  }
  const int* origin = this->Renderer->GetOrigin();
  for (vtkActor2D* actor : inner.inThePicture())
  {
    actor->SetPosition(origin[0], origin[1]);
  }
  inner.frame.freeze(window);
}

void vtkOversketchStrokeRepresentation::AddSample(double x, double y, double pressure, double time)
{
  Internals& inner = *this->Inner;
  if (!inner.drawing || !this->Renderer)
  {
    return;
  }
  inner.drawing->add(inViewport(this->Renderer, x, y), pressure, time);
  inner.running.add(inner.drawing->points.back());
  if (inner.sectionFollows)
  {
    inner.section.add(inner.drawing->points.back());
  }
}

void vtkOversketchStrokeRepresentation::RemoveLast(double length)
{
  Internals& inner = *this->Inner;
  PenStroke& from = inner.drawing ? *inner.drawing : inner.stroke;
  from.removeLast(length);
  (inner.drawing ? inner.running : inner.kept).set(from.points);
  if (inner.drawing && inner.sectionFollows)
  {
    inner.section.set(from.points);
  }
}

bool vtkOversketchStrokeRepresentation::EndStroke()
{
  Internals& inner = *this->Inner;
  const bool whole = inner.drawing && inner.drawing->count() > 1;
  if (whole)
  {
    inner.stroke = inner.over ? inner.stroke.resketched(*inner.drawing) : *inner.drawing;
    inner.kept.set(inner.stroke.points);
  }
  this->DropStroke();
  return whole;
}

void vtkOversketchStrokeRepresentation::DropStroke()
{
  Internals& inner = *this->Inner;
  inner.drawing.reset();
  inner.running.set({});
  inner.section.set({});
  inner.sectionFollows = false;
  this->SetCrest(nullptr);
  inner.frame.thaw();
}

void vtkOversketchStrokeRepresentation::Clear()
{
  this->DropStroke();
  this->Inner->stroke = {};
  this->Inner->kept.set({});
}

bool vtkOversketchStrokeRepresentation::IsDrawing() const
{
  return this->Inner->drawing.has_value();
}

bool vtkOversketchStrokeRepresentation::FitsRenderer()
{
  const Internals& inner = *this->Inner;
  if (!inner.drawing || !this->Renderer)
  {
    return false;
  }
  const int* size = this->Renderer->GetSize();
  return inner.drawing->view.size == std::array<int, 2>{ size[0], size[1] } &&
         (!inner.frame.frozen() || inner.frame.fits());
}

vtkIdType vtkOversketchStrokeRepresentation::GetNumberOfSamples() const
{
  return this->Inner->current().count();
}

void vtkOversketchStrokeRepresentation::GetPolyData(vtkPolyData* stroke)
{
  this->Inner->current().putInto(stroke);
}

bool vtkOversketchStrokeRepresentation::SetStroke(vtkPolyData* stroke)
{
  Internals& inner = *this->Inner;
  if (inner.drawing || !stroke)
  {
    return false;
  }
  try
  {
    inner.stroke = PenStroke::of(stroke);
  }
  catch (const oversketch::Error&)
  {
    return false;
  }
  inner.kept.set(inner.stroke.points);
  return true;
}

void vtkOversketchStrokeRepresentation::PutView(vtkPolyData* stroke)
{
  PenStroke begun;
  if (this->Renderer)
  {
    begun.view = PenView::of(this->Renderer);
    begun.add(Vector2::Zero(), 1.0, 0.0);
  }
  begun.putInto(stroke);
}

void vtkOversketchStrokeRepresentation::SetSection(vtkPolyData* section)
{
  std::vector<oversketch::Polyline> seen;
  const auto view = this->Inner->drawing ? this->Inner->drawing->view.sight() : std::nullopt;
  if (view && section)
  {
    vtkDataArray* places = section->GetPointData()->GetArray("Display");
    if (!places || places->GetNumberOfComponents() != 2)
    {
      this->Inner->section.setAll(seenIn(*view, linesOf(section)));
      return;
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType line = 0; line < section->GetNumberOfLines(); ++line)
    {
      section->GetLines()->GetCellAtId(line, ids);
      seen.emplace_back();
      for (const vtkIdType id : *ids)
      {
        Vector2 place;
        places->GetTuple(id, place.data());
        seen.back().push_back(place);
      }
    }
  }
  this->Inner->section.setAll(seen);
}

void vtkOversketchStrokeRepresentation::SetSectionFollows(bool follows)
{
  Internals& inner = *this->Inner;
  inner.sectionFollows = follows && inner.drawing;
  inner.section.set(inner.sectionFollows ? inner.drawing->points : oversketch::Polyline());
}

bool vtkOversketchStrokeRepresentation::GetSectionFollows() const
{
  return this->Inner->sectionFollows;
}

void vtkOversketchStrokeRepresentation::SetCrest(vtkPolyData* crest)
{
  Internals& inner = *this->Inner;
  inner.crestLines->Initialize();
  if (crest)
  {
    inner.crestLines->ShallowCopy(crest);
  }
  // Without a stroke the next frame's view is the one that counts.
  inner.placeCrest(inner.drawing ? inner.drawing->view : PenView());
  this->Modified();
}

vtkProperty2D* vtkOversketchStrokeRepresentation::GetProperty()
{
  return this->Inner->property;
}

vtkProperty2D* vtkOversketchStrokeRepresentation::GetSectionProperty()
{
  return this->Inner->sectionProperty;
}

vtkProperty2D* vtkOversketchStrokeRepresentation::GetCrestProperty()
{
  return this->Inner->crestProperty;
}

void vtkOversketchStrokeRepresentation::SetRenderer(vtkRenderer* renderer)
{
  if (renderer != this->Renderer)
  {
    this->DropStroke();
    this->Inner->shownSize = { 0, 0 };
  }
  this->Superclass::SetRenderer(renderer);
}

void vtkOversketchStrokeRepresentation::BuildRepresentation() {}

void vtkOversketchStrokeRepresentation::GetActors2D(vtkPropCollection* actors)
{
  actors->AddItem(this->Inner->kept.actor);
}

void vtkOversketchStrokeRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Inner->kept.actor->ReleaseGraphicsResources(window);
  for (vtkActor2D* actor : this->Inner->inThePicture())
  {
    actor->ReleaseGraphicsResources(window);
  }
}

int vtkOversketchStrokeRepresentation::RenderOverlay(vtkViewport* viewport)
{
  Internals& inner = *this->Inner;
  vtkRenderWindow* window = this->Renderer ? this->Renderer->GetRenderWindow() : nullptr;
  if (!window)
  {
    return 0;
  }
  const int* size = window->GetSize();
  inner.shownSize = { size[0], size[1] };
  inner.strokeShown = inner.stroke.count() > 1 && (!inner.drawing || inner.over) &&
                      inner.stroke.view == PenView::of(this->Renderer);
  int drawn = 0;
  if (inner.strokeShown)
  {
    drawn += inner.kept.actor->RenderOverlay(viewport);
  }
  if (!inner.drawing && inner.hasCrest())
  {
    inner.placeCrest(PenView::of(this->Renderer));
  }
  if ((inner.drawing || inner.hasCrest()) && !inner.frame.frozen())
  {
    for (vtkActor2D* actor : inner.inThePicture())
    {
      actor->SetPosition(0.0, 0.0);
      drawn += actor->RenderOverlay(viewport);
    }
  }
  return drawn;
}

void vtkOversketchStrokeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Drawing: " << this->IsDrawing() << "\n";
  os << indent << "Samples: " << this->GetNumberOfSamples() << "\n";
  os << indent << "SectionFollows: " << (this->GetSectionFollows() ? "On" : "Off") << "\n";
}
