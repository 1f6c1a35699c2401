#include "edit_overlay.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace oversketch
{

Overlay::Overlay()
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Data);
  this->Actor->SetMapper(mapper);
  this->Actor->PickableOff();
  this->clear();
}

Overlay::~Overlay() = default;

void Overlay::clear()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colour");
  colours->SetNumberOfComponents(4);
  this->Data->Initialize();
  this->Data->SetPoints(points);
  this->Data->SetPolys(polygons);
  this->Data->GetPointData()->SetScalars(colours);
}

void Overlay::polygon(const Polyline& corners, const Colour& colour)
{
  auto* colours = static_cast<vtkUnsignedCharArray*>(this->Data->GetPointData()->GetScalars());
  vtkCellArray* polygons = this->Data->GetPolys();
  polygons->InsertNextCell(static_cast<int>(corners.size()));
  for (const Vector2& p : corners)
  {
    polygons->InsertCellPoint(this->Data->GetPoints()->InsertNextPoint(p[0], p[1], 0.0));
    colours->InsertNextTypedTuple(colour.data());
  }
  this->Data->GetPoints()->Modified();
  this->Data->Modified();
}

void Overlay::line(const Polyline& points, double width, const Colour& colour)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (width > 2.0 && points.size() > 1) // joints and ends are round
    {
      this->disc(points[i], 0.5 * width, colour);
    }
    if (i > 0)
    {
      const Vector2 step = points[i] - points[i - 1];
      const double length = step.norm();
      if (length > 0.0)
      {
        const Vector2 beside = Vector2(-step[1], step[0]) * (0.5 * width / length);
        this->polygon(
          { points[i - 1] + beside, points[i - 1] - beside, points[i] - beside, points[i] + beside }, colour);
      }
    }
  }
}

void Overlay::disc(const Vector2& centre, double radius, const Colour& colour)
{
  const int corners = radius < 3.0 ? 8 : 24;
  Polyline rim;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * M_PI * i / corners;
    rim.emplace_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  this->polygon(rim, colour);
}

void Overlay::knob(const Vector2& centre, double radius, const Colour& colour)
{
  this->disc(centre, radius + 2.0, paperWhite);
  this->disc(centre, radius, colour);
}

int Overlay::render(vtkViewport* viewport)
{
  return this->Data->GetNumberOfPolys() > 0 ? this->Actor->RenderOverlay(viewport) : 0;
}

void Overlay::release(vtkWindow* window)
{
  this->Actor->ReleaseGraphicsResources(window);
}

} // namespace oversketch
