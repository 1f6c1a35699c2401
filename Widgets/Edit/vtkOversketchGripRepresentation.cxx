#include "vtkOversketchGripRepresentation.h"

#include "edit_overlay.h"
#include "pen_view.h"

#include "Mesh/context.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <string>
#include <vector>

using oversketch::PenView;

struct vtkOversketchGripRepresentation::Internals
{
  oversketch::Overlay overlay;
  vtkNew<vtkTextActor> text;
  std::vector<vtkSmartPointer<vtkActor>> actors;
};

vtkOversketchGripRepresentation::vtkOversketchGripRepresentation()
  : Inner(std::make_unique<Internals>())
{
  vtkTextActor* text = this->Inner->text;
  text->SetPosition(10.0, 10.0);
  text->GetTextProperty()->SetFontSize(15);
  text->GetTextProperty()->SetColor(1.0, 1.0, 1.0);
  text->GetTextProperty()->SetBackgroundColor(0.1, 0.1, 0.1);
  text->GetTextProperty()->SetBackgroundOpacity(0.75);
  text->PickableOff();
  text->VisibilityOff();
  this->PickableOff();
  this->DragableOff();
}

vtkOversketchGripRepresentation::~vtkOversketchGripRepresentation() = default;

int vtkOversketchGripRepresentation::GetGripAt(double x, double y)
{
  if (!this->Renderer)
  {
    return 0;
  }
  try
  {
    const oversketch::Vector2 at = oversketch::inViewport(this->Renderer, x, y);
    return this->FindGrip(PenView::of(this->Renderer).kernelView(), at[0], at[1]);
  }
  catch (const oversketch::Error&)
  {
    return 0; // a camera that sees nothing
  }
}

void vtkOversketchGripRepresentation::SetText(const char* text)
{
  const std::string line = text ? text : "";
  if (line != this->GetText())
  {
    this->Inner->text->SetInput(line.c_str());
    this->Inner->text->SetVisibility(!line.empty());
    this->Modified();
  }
}

const char* vtkOversketchGripRepresentation::GetText()
{
  const char* text = this->Inner->text->GetInput();
  return text ? text : "";
}

vtkTextProperty* vtkOversketchGripRepresentation::GetTextProperty()
{
  return this->Inner->text->GetTextProperty();
}

void vtkOversketchGripRepresentation::AddActor(vtkActor* actor)
{
  this->Inner->actors.emplace_back(actor);
}

void vtkOversketchGripRepresentation::BuildRepresentation() {}

void vtkOversketchGripRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkActor* actor : this->Inner->actors)
  {
    actor->ReleaseGraphicsResources(window);
  }
  this->Inner->overlay.release(window);
  this->Inner->text->ReleaseGraphicsResources(window);
}

int vtkOversketchGripRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  int drawn = 0;
  for (vtkActor* actor : this->Inner->actors)
  {
    drawn += actor->GetVisibility() ? actor->RenderOpaqueGeometry(viewport) : 0;
  }
  return drawn + (this->Inner->text->GetVisibility() ? this->Inner->text->RenderOpaqueGeometry(viewport) : 0);
}

int vtkOversketchGripRepresentation::RenderOverlay(vtkViewport* viewport)
{
  Internals& inner = *this->Inner;
  int drawn = 0;
  if (this->Renderer)
  {
    inner.overlay.clear();
    try
    {
      this->Paint(PenView::of(this->Renderer).kernelView(), inner.overlay);
      drawn += inner.overlay.render(viewport);
    }
    catch (const oversketch::Error&)
    {
      drawn = 0; // a camera that sees nothing
    }
  }
  return drawn + (inner.text->GetVisibility() ? inner.text->RenderOverlay(viewport) : 0);
}

void vtkOversketchGripRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ActiveGrip: " << this->ActiveGrip << "\n";
  os << indent << "GrabDistance: " << this->GrabDistance << "\n";
  os << indent << "Text: " << this->GetText() << "\n";
}
