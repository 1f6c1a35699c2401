#include "place_gizmo.h"

#include "viewport.h"

#include "pen_view.h"

#include "vtkOversketchTransform.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace oversketch_studio
{

using oversketch::Polyline;
using oversketch::Vector2;
using oversketch::Vector3;
using oversketch::View;

namespace
{

// px as Qt counts them: where handles are from the middle, half a side of square and boxes, how near to one
// the cursor takes hold of it.
constexpr double arrowFrom = 14.0, arrowTo = 58.0, boxAt = 74.0, ringAt = 96.0, half = 6.0, grab = 8.0,
                 gizmoLineWidth = 3.0;
constexpr int ringCorners = 64;
constexpr double leastRun = 0.17;                       // sine of the angle to the line of sight
constexpr double leastFactor = 0.02, mostFactor = 50.0; // of one drag
constexpr std::array<unsigned char, 3> axisColours[3] = { { 219, 50, 47 },
  { 40, 150, 70 },
  { 50, 110, 240 } },
                                       squareColour{ 150, 150, 158 }, litColour{ 250, 158, 51 };

} // namespace

Eigen::Affine3d Pose::about(const Vector3& middle) const
{
  vtkNew<vtkTransform> transform;
  vtkOversketchTransform::Compose(
    this->move.data(), this->turn.data(), this->scale.data(), middle.data(), transform);
  return Eigen::Affine3d(Eigen::Matrix4d(transform->GetMatrix()->GetData()).transpose());
}

Eigen::Matrix3d Pose::axes() const
{
  return Pose{ Vector3::Zero(), this->turn, Vector3::Ones() }.about(Vector3::Zero()).linear();
}

std::vector<GizmoShape> seeGizmo(const View& view,
  const Vector3& middle,
  const Eigen::Matrix3d& axes,
  double ratio)
{
  if (!view.inFront(middle))
  {
    return {};
  }
  const Vector2 at = view.toDisplay(middle).head<2>();
  const auto box = [&](const Vector2& run, double along) -> Polyline
  {
    const Vector2 beside = ratio * half * Vector2(-run[1], run[0]), ahead = ratio * half * run,
                  centre = at + ratio * along * run;
    return {
      centre - ahead - beside, centre + ahead - beside, centre + ahead + beside, centre - ahead + beside
    };
  };
  const double pixel = pixelSize(view, middle);
  std::vector<GizmoShape> rings, seen;
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 across = axes.col((k + 1) % 3), upright = axes.col((k + 2) % 3);
    Polyline ring;
    for (int i = 0; i <= ringCorners; ++i)
    {
      const double angle = 2.0 * M_PI * i / ringCorners;
      const Vector3 place =
        middle + ringAt * ratio * pixel * (std::cos(angle) * across + std::sin(angle) * upright);
      if (!view.inFront(place))
      {
        return {};
      }
      ring.emplace_back(view.toDisplay(place).head<2>());
    }
    rings.push_back({ { GizmoGrip::Ring, k }, std::move(ring), false });
    // A short way, which perspective does not bend.
    Vector2 run = view.toDisplay(middle + pixel * axes.col(k)).head<2>() - at;
    if (run.norm() > leastRun)
    {
      run.normalize();
      const Vector2 tip = at + ratio * arrowTo * run, foot = tip - ratio * 14.0 * run,
                    beside = ratio * half * Vector2(-run[1], run[0]);
      seen.push_back({ { GizmoGrip::Arrow, k }, { at + ratio * arrowFrom * run, foot }, false });
      seen.push_back({ { GizmoGrip::Arrow, k }, { tip, foot + beside, foot - beside }, true });
      seen.push_back({ { GizmoGrip::Box, k }, box(run, boxAt), true });
    }
  }
  seen.push_back({ {}, box(Vector2::UnitX(), 0.0), true });
  rings.insert(rings.end(), seen.begin(), seen.end());
  return rings;
}

// A ring that is seen from its rim lies under arrows.
std::optional<GizmoGrip> gripAt(const std::vector<GizmoShape>& seen, const Vector2& place, double ratio)
{
  std::optional<GizmoGrip> nearest;
  double least = grab * ratio;
  for (const bool isRing : { false, true })
  {
    for (const GizmoShape& shape : seen)
    {
      if ((shape.grip.part == GizmoGrip::Ring) == isRing)
      {
        const double distance = oversketch::NearestPlace(shape.outline, shape.isFilled)(place).distance;
        nearest = distance < least ? shape.grip : nearest;
        least = std::min(least, distance);
      }
    }
    if (nearest)
    {
      break;
    }
  }
  return nearest;
}

Pose posed(const View& view,
  const Vector3& middle,
  const Pose& from,
  const GizmoGrip& grip,
  const Vector2& start,
  const Vector2& now,
  bool uniform)
{
  Pose to = from;
  const Vector3 at = middle + from.move, axis = from.axes().col(grip.axis);
  const double before = alongAxis(view, start, at, axis), after = alongAxis(view, now, at, axis);
  switch (grip.part)
  {
    case GizmoGrip::Square:
      to.move += view.toWorld(now, view.depth(at)) - view.toWorld(start, view.depth(at));
      break;
    case GizmoGrip::Arrow:
      to.move += (after - before) * axis;
      break;
    case GizmoGrip::Box:
      for (int k = 0; k < 3; ++k)
      {
        const bool scales = before != 0.0 && (uniform || k == grip.axis);
        to.scale[k] *= scales ? std::clamp(after / before, leastFactor, mostFactor) : 1.0;
      }
      break;
    case GizmoGrip::Ring:
      vtkNew<vtkTransform> turned;
      turned->RotateWXYZ(oversketch::degreesAbout(view, start, now, at, axis), axis.data());
      turned->RotateZ(from.turn[2]);
      turned->RotateX(from.turn[0]);
      turned->RotateY(from.turn[1]);
      turned->GetOrientation(to.turn.data());
      break;
  }
  return to;
}

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
  if (std::exchange(this->Shown, stand) || stand)
  {
    this->follow();
    this->View->renderSoon();
  }
}

std::optional<GizmoGrip> PlaceGizmo::at(const Vector2& place) const
{
  return this->Visible ? gripAt(this->Seen, place, this->Ratio) : std::nullopt;
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

void PlaceGizmo::follow()
{
  this->Seen.clear();
  const int* size = this->View->renderer()->GetSize();
  const auto view = size[0] > 0 && size[1] > 0 ? oversketch::PenView::of(this->View->renderer()).sight()
                                               : std::nullopt; // a camera that sees nothing
  if (this->Shown && view)
  {
    const auto& [middle, pose] = *this->Shown;
    this->Seen = seeGizmo(*view, middle + pose.move, pose.axes(), this->Ratio);
  }
  this->Actor->SetVisibility(this->Visible && !this->Seen.empty());
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines, polys;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("colour");
  colours->SetNumberOfComponents(3);
  for (const GizmoShape& shape : this->Seen)
  {
    const bool isLit = this->Lit && *this->Lit == shape.grip;
    const auto& own = shape.grip.part == GizmoGrip::Square ? squareColour : axisColours[shape.grip.axis];
    vtkCellArray* cells = shape.isFilled ? polys : lines;
    cells->InsertNextCell(static_cast<int>(shape.outline.size()));
    for (const Vector2& corner : shape.outline)
    {
      cells->InsertCellPoint(points->InsertNextPoint(corner[0], corner[1], 0.0));
      colours->InsertNextTypedTuple((isLit ? litColour : own).data());
    }
  }
  this->Data->Initialize();
  this->Data->SetPoints(points);
  this->Data->SetLines(lines);
  this->Data->SetPolys(polys);
  this->Data->GetPointData()->SetScalars(colours);
}

} // namespace oversketch_studio
