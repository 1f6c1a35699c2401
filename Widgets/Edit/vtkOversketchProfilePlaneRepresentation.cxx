#include "vtkOversketchProfilePlaneRepresentation.h"

#include "drawn_curve.h"
#include "edit_overlay.h"
#include "pen_view.h"

#include "Mesh/context.h"
#include "vtkOversketchFilterTools.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchProfilePlaneRepresentation);

namespace
{

constexpr Colour planeColours[3] = { sectionBlue, axisGreen, regionOrange };
constexpr unsigned char opacity = 34; // of 255
constexpr double planeReach = 0.6;    // half the side, in diagonals of the region's box

} // namespace

struct vtkOversketchProfilePlaneRepresentation::Internals
{
  std::array<bool, 3> visible{ true, true, true };
  std::vector<Vector3> curve, section;
  std::vector<double> shares;
  double half = 0.0;
  bool hasPlanes = false;
  Vector3 origin = Vector3::Zero(), axes[3]; // along, side, outward
  vtkNew<vtkPolyData> borders;
  vtkNew<vtkActor> borderActor;

  // The corners of a plane: normals are outward, side and along.
  std::vector<Vector3> cornersOf(int plane) const
  {
    const Vector3 u = this->half * this->axes[plane == B ? 1 : 0],
                  v = this->half * this->axes[plane == N ? 1 : 2];
    return { this->origin - u - v, this->origin + u - v, this->origin + u + v, this->origin - u + v };
  }
};

vtkOversketchProfilePlaneRepresentation::vtkOversketchProfilePlaneRepresentation()
  : Inner(std::make_unique<Internals>())
{
  Internals& inner = *this->Inner;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(inner.borders);
  inner.borderActor->SetMapper(mapper);
  inner.borderActor->PickableOff();
  inner.borderActor->VisibilityOff();
  this->AddActor(inner.borderActor);
  inner.borderActor->GetProperty()->LightingOff();
  inner.borderActor->GetProperty()->SetLineWidth(2.0f);
}

vtkOversketchProfilePlaneRepresentation::~vtkOversketchProfilePlaneRepresentation() = default;

void vtkOversketchProfilePlaneRepresentation::SetPlaneVisibility(int plane, bool visible)
{
  if (plane >= N && plane <= B && this->Inner->visible[static_cast<std::size_t>(plane)] != visible)
  {
    this->Inner->visible[static_cast<std::size_t>(plane)] = visible;
    this->LayOut();
  }
}

bool vtkOversketchProfilePlaneRepresentation::GetPlaneVisibility(int plane) const
{
  return plane >= N && plane <= B && this->Inner->visible[static_cast<std::size_t>(plane)];
}

int vtkOversketchProfilePlaneRepresentation::GetNumberOfVisiblePlanes() const
{
  const auto& visible = this->Inner->visible;
  return static_cast<int>(std::count(visible.begin(), visible.end(), true));
}

void vtkOversketchProfilePlaneRepresentation::SetCurve(vtkPolyData* curve, const double box[6])
{
  Internals& inner = *this->Inner;
  inner.curve = firstLineOf(curve);
  inner.shares = sharesOf(inner.curve);
  inner.half = planeReach * (Vector3(box[1], box[3], box[5]) - Vector3(box[0], box[2], box[4])).norm();
  this->LayOut();
}

void vtkOversketchProfilePlaneRepresentation::SetSection(vtkPolyData* planes, vtkPolyData* section)
{
  Internals& inner = *this->Inner;
  vtkDataArray* frame = planes ? planes->GetFieldData()->GetArray("Frame") : nullptr;
  inner.hasPlanes = frame && frame->GetNumberOfComponents() == 16 && frame->GetNumberOfTuples() == 1;
  for (int row = 0; inner.hasPlanes && row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      inner.axes[axis][row] = frame->GetComponent(0, 4 * row + axis);
    }
    inner.origin[row] = frame->GetComponent(0, 4 * row + 3);
  }
  inner.section = firstLineOf(section);
  this->LayOut();
}

void vtkOversketchProfilePlaneRepresentation::LayOut()
{
  Internals& inner = *this->Inner;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> borders;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (const int plane : { N, T, B })
  {
    if (!inner.hasPlanes || !this->GetPlaneVisibility(plane))
    {
      continue;
    }
    borders->InsertNextCell(5);
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Vector3& corner : inner.cornersOf(plane))
    {
      const vtkIdType id = points->InsertNextPoint(corner.data());
      borders->InsertCellPoint(id);
    }
    borders->InsertCellPoint(first);
    colours->InsertNextTypedTuple(planeColours[plane].data());
  }
  inner.borders->Initialize();
  inner.borders->SetPoints(points);
  inner.borders->GetCellData()->SetScalars(colours);
  inner.borders->SetLines(borders);
  inner.borderActor->SetVisibility(borders->GetNumberOfCells() > 0);
  this->Modified();
}

double vtkOversketchProfilePlaneRepresentation::GetSlid(double t, const int from[2], const int to[2])
{
  const Internals& inner = *this->Inner;
  if (!this->Renderer || inner.curve.size() < 2)
  {
    return t;
  }
  const View view = PenView::of(this->Renderer).kernelView();
  const Vector3 knob = placeAt(inner.curve, inner.shares, t);
  if (!view.inFront(knob))
  {
    return t;
  }
  const Vector2 by(to[0] - from[0], to[1] - from[1]);
  return nearestShare(view, inner.curve, inner.shares, view.toDisplay(knob).head<2>() + by).value_or(t);
}

int vtkOversketchProfilePlaneRepresentation::FindGrip(const View& view, double x, double y)
{
  const Internals& inner = *this->Inner;
  const Vector2 place(x, y);
  if (!inner.hasPlanes)
  {
    return 0;
  }
  const auto near = [&](const std::vector<Vector3>& line, bool closed)
  { return distanceTo(view, line, closed, place) <= this->GetGrabDistance(); };
  if (near(inner.section, false) || near({ inner.origin }, false))
  {
    return B + 1;
  }
  return this->GetPlaneVisibility(B) && near(inner.cornersOf(B), true) ? B + 1 : 0;
}

void vtkOversketchProfilePlaneRepresentation::Paint(const View& view, Overlay& overlay)
{
  const Internals& inner = *this->Inner;
  if (!inner.hasPlanes)
  {
    return;
  }
  // A tint over all else, since what is half transparent would hang on the order that a scene is drawn in.
  for (const int plane : { N, T, B })
  {
    const std::vector<Polyline> square = seenIn(view, inner.cornersOf(plane));
    if (this->GetPlaneVisibility(plane) && square.size() == 1 && square[0].size() == 4)
    {
      Colour tint = planeColours[plane];
      tint[3] = opacity;
      overlay.polygon(square[0], tint);
    }
  }
  const bool isActive = this->GetActiveGrip() == B + 1;
  overlay.rimmed(seenIn(view, inner.curve), 3.0, strokeRed);
  overlay.profile(seenIn(view, inner.section), isActive ? 6.0 : 4.0);
  if (view.inFront(inner.origin))
  {
    overlay.knob(view.toDisplay(inner.origin).head<2>(), isActive ? 8.0 : 6.5, regionOrange);
  }
}

void vtkOversketchProfilePlaneRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VisiblePlanes: " << this->GetNumberOfVisiblePlanes() << "\n";
}
