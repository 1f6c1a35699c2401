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

Polyline circle(const Vector2& centre, double radius, int corners)
{
  Polyline rim;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * M_PI * i / corners;
    rim.emplace_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return rim;
}

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

void Overlay::rimmed(const std::vector<Polyline>& lines,
  double width,
  const Colour& colour,
  const Colour& rim)
{
  for (const bool isRim : { true, false })
  {
    for (const Polyline& line : lines)
    {
      this->line(line, width + (isRim ? 2.0 : 0.0), isRim ? rim : colour);
    }
  }
}

void Overlay::profile(const std::vector<Polyline>& pieces, double width)
{
  double length = 0.0;
  for (const Polyline& piece : pieces)
  {
    this->line(piece, width + 2.0, paperWhite);
    length += piece.empty() ? 0.0 : arcLengths(piece).back();
  }
  double done = 0.0;
  for (const Polyline& piece : pieces)
  {
    for (std::size_t i = 1; i < piece.size(); ++i)
    {
      const double share = length > 0.0 ? done / length : 0.0;
      Colour colour{ 0, 0, 0, 255 };
      for (std::size_t c = 0; c < 3; ++c)
      {
        colour[c] =
          static_cast<unsigned char>(std::lround((1.0 - share) * regionOrange[c] + share * sectionBlue[c]));
      }
      this->line({ piece[i - 1], piece[i] }, width, colour);
      done += (piece[i] - piece[i - 1]).norm();
    }
  }
}

void Overlay::disc(const Vector2& centre, double radius, const Colour& colour)
{
  this->polygon(circle(centre, radius, radius < 3.0 ? 8 : 24), colour);
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
