#include "place_gizmo.h"

#include "viewport.h"

#include "pen_view.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

namespace oversketch_studio
{

using oversketch::Vector2;

namespace
{

constexpr double gizmoLineWidth = 3.0; // px as Qt counts them
constexpr std::array<unsigned char, 3> axisColours[3] = { { 219, 50, 47 },
  { 40, 150, 70 },
  { 50, 110, 240 } };
constexpr std::array<unsigned char, 3> squareColour = { 150, 150, 158 }, litColour = { 250, 158, 51 };

} // namespace

PlaceGizmo::PlaceGizmo(Viewport* view)
  : View(view)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Data);
  this->Actor->SetMapper(mapper);
  this->Actor->PickableOff();
  this->Actor->VisibilityOff();
  this->setPixelRatio(1.0);
  view->renderer()->AddActor2D(this->Actor);
}

PlaceGizmo::~PlaceGizmo()
{
  this->View->renderer()->RemoveActor2D(this->Actor);
}

void PlaceGizmo::setPixelRatio(double ratio)
{
  this->Ratio = ratio;
  this->Actor->GetProperty()->SetLineWidth(static_cast<float>(gizmoLineWidth * ratio));
}

void PlaceGizmo::show(const std::optional<Stand>& stand)
{
  const bool wasShown = this->Shown.has_value();
  this->Shown = stand;
  if (wasShown || stand)
  {
    this->follow();
    this->View->renderSoon();
  }
}

void PlaceGizmo::follow()
{
  this->Seen.reset();
  const int* size = this->View->renderer()->GetSize();
  const auto view = size[0] > 0 && size[1] > 0 ? oversketch::PenView::of(this->View->renderer()).sight()
                                               : std::nullopt; // a camera that sees nothing
  if (this->Shown && view)
  {
    const auto& [middle, pose] = *this->Shown;
    this->Seen = seeGizmo(*view, middle + pose.move, oversketch::turnedBy(pose.turn), this->Ratio);
  }
  this->Actor->SetVisibility(this->Seen && this->Visible);
  if (this->Seen)
  {
    this->paint();
  }
}

std::optional<GizmoGrip> PlaceGizmo::at(const Vector2& place) const
{
  return this->Seen && this->Visible ? gripAt(*this->Seen, place) : std::nullopt;
}

void PlaceGizmo::light(const std::optional<GizmoGrip>& grip)
{
  if (!(grip == this->Lit))
  {
    this->Lit = grip;
    this->View->setHandCursor(grip ? Qt::SizeAllCursor : Qt::OpenHandCursor);
    this->View->renderSoon();
  }
}

void PlaceGizmo::add(const std::vector<Vector2>& places, const Colour& colour, bool isFilled)
{
  vtkCellArray* cells = isFilled ? this->Data->GetPolys() : this->Data->GetLines();
  auto* colours = static_cast<vtkUnsignedCharArray*>(this->Data->GetPointData()->GetScalars());
  cells->InsertNextCell(static_cast<int>(places.size()));
  for (const Vector2& place : places)
  {
    cells->InsertCellPoint(this->Data->GetPoints()->InsertNextPoint(place[0], place[1], 0.0));
    colours->InsertNextTypedTuple(colour.data());
  }
}

void PlaceGizmo::paint()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines, polys;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colour");
  colours->SetNumberOfComponents(3);
  this->Data->Initialize();
  this->Data->SetPoints(points);
  this->Data->SetLines(lines);
  this->Data->SetPolys(polys);
  this->Data->GetPointData()->SetScalars(colours);
  const GizmoSize size;
  const GizmoShape& seen = *this->Seen;
  const auto colourOf = [this](GizmoGrip::Part part, int axis)
  {
    const bool isLit = this->Lit && *this->Lit == GizmoGrip{ part, axis };
    return isLit ? litColour : part == GizmoGrip::Square ? squareColour : axisColours[axis];
  };
  for (int k = 0; k < 3; ++k)
  {
    this->add(seen.axes[k].ring, colourOf(GizmoGrip::Ring, k), false);
  }
  // In px as Qt counts them, along a direction and across.
  const auto put = [&](const Vector2& run, double along, double across) -> Vector2
  { return seen.middle + seen.ratio * (along * run + across * Vector2(-run[1], run[0])); };
  for (int k = 0; k < 3; ++k)
  {
    if (const auto& run = seen.axes[k].run)
    {
      const Colour arrow = colourOf(GizmoGrip::Arrow, k);
      this->add({ put(*run, size.arrowFrom, 0.0), put(*run, size.arrowTo - 8.0, 0.0) }, arrow, false);
      this->add({ put(*run, size.arrowTo, 0.0),
                  put(*run, size.arrowTo - 14.0, 6.0),
                  put(*run, size.arrowTo - 14.0, -6.0) },
        arrow,
        true);
      const double near = size.box - size.boxSide, far = size.box + size.boxSide;
      this->add({ put(*run, near, -size.boxSide),
                  put(*run, far, -size.boxSide),
                  put(*run, far, size.boxSide),
                  put(*run, near, size.boxSide) },
        colourOf(GizmoGrip::Box, k),
        true);
    }
  }
  const Vector2 right = Vector2::UnitX();
  this->add({ put(right, -size.square, -size.square),
              put(right, size.square, -size.square),
              put(right, size.square, size.square),
              put(right, -size.square, size.square) },
    colourOf(GizmoGrip::Square, 0),
    true);
  this->Data->Modified();
}

} // namespace oversketch_studio
