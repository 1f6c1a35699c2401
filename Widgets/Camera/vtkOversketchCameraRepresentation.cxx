#include "vtkOversketchCameraRepresentation.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkPropCollection.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkOversketchCameraRepresentation);

namespace
{

// Pixels; the slider stands above the dial's centre.
constexpr double margin = 45.0, radius = 30.0, knob = 7.0, trackStart = 55.0, trackLength = 100.0,
                 reach = 8.0;
constexpr double decades = 2.0; // of zoom, 0.1 to 10

using Point = std::array<double, 2>;

std::vector<Point> circle(const Point& centre, double size)
{
  std::vector<Point> points;
  for (int i = 0; i < 48; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / 48;
    points.push_back({ centre[0] + size * std::cos(angle), centre[1] + size * std::sin(angle) });
  }
  return points;
}

void add(vtkPoints* points, vtkCellArray* cells, const std::vector<Point>& corners)
{
  cells->InsertNextCell(static_cast<int>(corners.size()));
  for (const Point& corner : corners)
  {
    cells->InsertCellPoint(points->InsertNextPoint(corner[0], corner[1], 0.0));
  }
}

} // namespace

vtkOversketchCameraRepresentation::vtkOversketchCameraRepresentation()
{
  const auto show = [](vtkPolyData* data, vtkActor2D* actor, double grey, float width)
  {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(grey, grey, grey);
    actor->GetProperty()->SetLineWidth(width);
    actor->PickableOff();
  };
  show(this->Lines, this->LinesActor, 0.3, 2.0f);
  show(this->Knobs, this->KnobsActor, 0.12, 1.0f);
  this->PickableOff();
  this->DragableOff();
}

vtkOversketchCameraRepresentation::~vtkOversketchCameraRepresentation() = default;

vtkOversketchInteractorStyle* vtkOversketchCameraRepresentation::GetStyle()
{
  vtkRenderWindow* window = this->Renderer ? this->Renderer->GetRenderWindow() : nullptr;
  vtkRenderWindowInteractor* interactor = window ? window->GetInteractor() : nullptr;
  return interactor ? vtkOversketchInteractorStyle::SafeDownCast(interactor->GetInteractorStyle()) : nullptr;
}

void vtkOversketchCameraRepresentation::FromCentre(double x, double y, double out[2])
{
  const int* origin = this->Renderer->GetOrigin();
  const int* size = this->Renderer->GetSize();
  out[0] = x - origin[0] - (size[0] - margin);
  out[1] = y - origin[1] - margin;
}

int vtkOversketchCameraRepresentation::ComputeInteractionState(int x, int y, int vtkNotUsed(modify))
{
  this->InteractionState = Outside;
  if (this->Renderer && this->GetStyle())
  {
    double at[2];
    this->FromCentre(x, y, at);
    if (std::hypot(at[0], at[1]) <= radius + knob)
    {
      this->InteractionState = OnDial;
    }
    else if (std::abs(at[0]) <= reach && at[1] >= trackStart - knob &&
             at[1] <= trackStart + trackLength + knob)
    {
      this->InteractionState = OnSlider;
    }
  }
  return this->InteractionState;
}

double vtkOversketchCameraRepresentation::GetDialAngle(double x, double y)
{
  if (!this->Renderer)
  {
    return 0.0;
  }
  double at[2];
  this->FromCentre(x, y, at);
  return vtkMath::DegreesFromRadians(std::atan2(-at[0], at[1]));
}

double vtkOversketchCameraRepresentation::GetZoomRatio(double pixels) const
{
  return std::pow(10.0, decades * pixels / trackLength);
}

void vtkOversketchCameraRepresentation::BuildRepresentation()
{
  if (!this->Renderer)
  {
    return;
  }
  vtkOversketchInteractorStyle* style = this->GetStyle();
  const double zoom = style ? style->GetZoom() : 1.0, spin = style ? style->GetSpin() : 0.0;
  const Point centre{ this->Renderer->GetSize()[0] - margin, margin };
  const double low = centre[1] + trackStart, middle = low + 0.5 * trackLength;
  vtkNew<vtkPoints> linePoints, knobPoints;
  vtkNew<vtkCellArray> lines, discs;
  std::vector<Point> ring = circle(centre, radius);
  ring.push_back(ring.front());
  add(linePoints, lines, ring);
  add(linePoints, lines, { { centre[0], centre[1] + radius - 8.0 }, { centre[0], centre[1] + radius } });
  add(linePoints, lines, { { centre[0], low }, { centre[0], low + trackLength } });
  add(linePoints, lines, { { centre[0] - 8.0, middle }, { centre[0] + 8.0, middle } });
  const double angle = vtkMath::RadiansFromDegrees(spin);
  add(knobPoints,
    discs,
    circle({ centre[0] - radius * std::sin(angle), centre[1] + radius * std::cos(angle) }, knob));
  add(knobPoints, discs, circle({ centre[0], middle + trackLength * std::log10(zoom) / decades }, knob));
  this->Lines->SetPoints(linePoints);
  this->Lines->SetLines(lines);
  this->Knobs->SetPoints(knobPoints);
  this->Knobs->SetPolys(discs);
}

void vtkOversketchCameraRepresentation::GetActors2D(vtkPropCollection* actors)
{
  actors->AddItem(this->LinesActor);
  actors->AddItem(this->KnobsActor);
}

void vtkOversketchCameraRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->LinesActor->ReleaseGraphicsResources(window);
  this->KnobsActor->ReleaseGraphicsResources(window);
}

int vtkOversketchCameraRepresentation::RenderOverlay(vtkViewport* viewport)
{
  this->BuildRepresentation(); // keys and drags change what it shows
  return this->LinesActor->RenderOverlay(viewport) + this->KnobsActor->RenderOverlay(viewport);
}

void vtkOversketchCameraRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Style: " << this->GetStyle() << "\n";
}
