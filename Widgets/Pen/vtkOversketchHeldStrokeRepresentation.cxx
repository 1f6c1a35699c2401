#include "vtkOversketchHeldStrokeRepresentation.h"

#include "pen_stroke.h"
#include "seen_line.h"
#include "vtkOversketchFilterTools.h"

#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <limits>

vtkStandardNewMacro(vtkOversketchHeldStrokeRepresentation);

using oversketch::inViewport;
using oversketch::PenStroke;
using oversketch::PenView;
using oversketch::Polyline;
using oversketch::seenIn;
using oversketch::Vector2;
using oversketch::Vector3;

struct vtkOversketchHeldStrokeRepresentation::Internals
{
  PenStroke stroke;          // no points while there is none
  double depth = 0.0;        // camera z of its plane, in its view
  std::vector<Vector3> line; // in the world
  vtkNew<vtkProperty2D> property, seen;
  oversketch::Line2D picture{ seen };
  vtkNew<vtkTextActor> text;

  // The line as the renderer shows it [px in its viewport], in pieces where it passes behind the eye.
  std::vector<Polyline> seenFrom(vtkRenderer* renderer, const Vector3& moved) const
  {
    std::vector<Vector3> places = this->line;
    for (Vector3& place : places)
    {
      place += moved;
    }
    const auto view = PenView::of(renderer).sight();
    return view ? seenIn(*view, places) : std::vector<Polyline>();
  }
};

vtkOversketchHeldStrokeRepresentation::vtkOversketchHeldStrokeRepresentation()
  : Inner(std::make_unique<Internals>())
{
  Internals& inner = *this->Inner;
  inner.property->SetColor(0.86, 0.13, 0.12);
  inner.property->SetLineWidth(3.0);
  inner.text->SetPosition(10.0, 10.0);
  inner.text->GetTextProperty()->SetFontSize(15);
  inner.text->GetTextProperty()->SetColor(1.0, 1.0, 1.0);
  inner.text->GetTextProperty()->SetBackgroundColor(0.1, 0.1, 0.1);
  inner.text->GetTextProperty()->SetBackgroundOpacity(0.75);
  inner.text->PickableOff();
  inner.text->VisibilityOff();
  this->PickableOff();
  this->DragableOff();
}

vtkOversketchHeldStrokeRepresentation::~vtkOversketchHeldStrokeRepresentation() = default;

void vtkOversketchHeldStrokeRepresentation::SetStroke(vtkPolyData* stroke, const double place[3])
{
  Internals& inner = *this->Inner;
  inner.stroke = {};
  inner.line.clear();
  std::fill(this->Translation, this->Translation + 3, 0.0);
  if (stroke && stroke->GetNumberOfPoints() > 0)
  {
    try
    {
      const PenStroke read = PenStroke::of(stroke);
      const oversketch::View view = read.view.kernelView();
      inner.depth = view.depth(Vector3(place));
      for (const Vector2& point : read.points)
      {
        inner.line.push_back(view.toWorld(point, inner.depth));
      }
      inner.stroke = read;
    }
    catch (const oversketch::Error&)
    {
      inner.line.clear();
    }
  }
  this->Modified();
}

bool vtkOversketchHeldStrokeRepresentation::HasStroke() const
{
  return !this->Inner->line.empty();
}

bool vtkOversketchHeldStrokeRepresentation::IsInReach()
{
  return this->HasStroke() && this->Renderer &&
         PenView::of(this->Renderer).fromTheSamePlace(this->Inner->stroke.view);
}

bool vtkOversketchHeldStrokeRepresentation::IsInItsView()
{
  return this->HasStroke() && this->Renderer && PenView::of(this->Renderer) == this->Inner->stroke.view;
}

double vtkOversketchHeldStrokeRepresentation::DistanceTo(double x, double y)
{
  double least = std::numeric_limits<double>::infinity();
  if (!this->HasStroke() || !this->Renderer || (!this->ShowFromElsewhere && !this->IsInReach()))
  {
    return least;
  }
  const Vector2 place = inViewport(this->Renderer, x, y);
  for (const Polyline& piece : this->Inner->seenFrom(this->Renderer, Vector3(this->Translation)))
  {
    if (!piece.empty())
    {
      least = std::min(least, oversketch::NearestPlace(piece)(place).distance);
    }
  }
  return least;
}

void vtkOversketchHeldStrokeRepresentation::LookFromStroke()
{
  if (this->HasStroke() && this->Renderer)
  {
    this->Inner->stroke.view.putInto(this->Renderer);
  }
}

void vtkOversketchHeldStrokeRepresentation::Move(double fromX, double fromY, double toX, double toY)
{
  if (!this->IsInReach())
  {
    return;
  }
  // From the same place the plane has the same depth, whatever the zoom.
  const oversketch::View view = PenView::of(this->Renderer).kernelView();
  const auto onPlane = [&](double x, double y)
  { return view.toWorld(inViewport(this->Renderer, x, y), this->Inner->depth); };
  const Vector3 translation = onPlane(toX, toY) - onPlane(fromX, fromY);
  std::copy_n(translation.data(), 3, this->Translation);
  this->Modified();
}

void vtkOversketchHeldStrokeRepresentation::PutMoved(vtkPolyData* stroke)
{
  Internals& inner = *this->Inner;
  if (!this->HasStroke())
  {
    stroke->Initialize();
    return;
  }
  PenStroke moved = inner.stroke;
  const oversketch::View view = moved.view.kernelView();
  const Vector2 shift =
    (view.toDisplay(inner.line[0] + Vector3(this->Translation)) - view.toDisplay(inner.line[0])).head<2>();
  for (Vector2& point : moved.points)
  {
    point += shift;
  }
  moved.moved += shift;
  moved.putInto(stroke);
}

void vtkOversketchHeldStrokeRepresentation::SetText(const char* text)
{
  const std::string line = text ? text : "";
  if (line == this->GetText())
  {
    return;
  }
  this->Inner->text->SetInput(line.c_str());
  this->Inner->text->SetVisibility(!line.empty());
  this->Modified();
}

const char* vtkOversketchHeldStrokeRepresentation::GetText()
{
  const char* text = this->Inner->text->GetInput();
  return text ? text : "";
}

vtkProperty2D* vtkOversketchHeldStrokeRepresentation::GetProperty()
{
  return this->Inner->property;
}

vtkTextProperty* vtkOversketchHeldStrokeRepresentation::GetTextProperty()
{
  return this->Inner->text->GetTextProperty();
}

void vtkOversketchHeldStrokeRepresentation::BuildRepresentation() {}

void vtkOversketchHeldStrokeRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Inner->picture.actor->ReleaseGraphicsResources(window);
  this->Inner->text->ReleaseGraphicsResources(window);
}

int vtkOversketchHeldStrokeRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  return this->Inner->text->GetVisibility() ? this->Inner->text->RenderOpaqueGeometry(viewport) : 0;
}

int vtkOversketchHeldStrokeRepresentation::RenderOverlay(vtkViewport* viewport)
{
  Internals& inner = *this->Inner;
  int drawn = inner.text->GetVisibility() ? inner.text->RenderOverlay(viewport) : 0;
  if (!this->ShowStroke || !this->HasStroke() || !this->Renderer)
  {
    return drawn;
  }
  const bool inReach = this->IsInReach();
  if (!inReach && !this->ShowFromElsewhere)
  {
    return drawn;
  }
  inner.picture.setAll(inner.seenFrom(this->Renderer, Vector3(this->Translation)));
  const float width = inner.property->GetLineWidth();
  inner.seen->DeepCopy(inner.property);
  inner.seen->SetOpacity(inner.property->GetOpacity() * (inReach || this->Highlighted ? 1.0 : 0.5));
  inner.seen->SetLineWidth(this->Highlighted ? width + 3.0F : inReach ? width : 0.5F * width);
  return drawn + inner.picture.actor->RenderOverlay(viewport);
}

void vtkOversketchHeldStrokeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShowStroke: " << this->ShowStroke << "\n";
  os << indent << "ShowFromElsewhere: " << this->ShowFromElsewhere << "\n";
  os << indent << "Highlighted: " << this->Highlighted << "\n";
  os << indent << "Translation: " << this->Translation[0] << " " << this->Translation[1] << " "
     << this->Translation[2] << "\n";
  os << indent << "Text: " << this->GetText() << "\n";
  os << indent << "Samples: " << this->Inner->stroke.count() << "\n";
}
