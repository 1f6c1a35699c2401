#include "vtkOversketchAxisHandleRepresentation.h"

#include "drawn_curve.h"
#include "edit_overlay.h"
#include "pen_view.h"

#include "Matrix/moved.h"
#include "Matrix/operations.h"
#include "Mesh/context.h"
#include "Mesh/view.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchAxisHandleRepresentation);

namespace
{

constexpr double third = 30.0;     // px of an axis
constexpr double freeOfKnob = 7.0; // px, where an axis begins
constexpr double leastSeen = 0.17; // sine of the angle to the line of sight
// px: rings about the knob, in place of an axis that points at the viewer: up and down moves, round turns.
constexpr double movingRing = 17.0, turningRing = 30.0;
constexpr Colour axisColours[3] = { strokeRed, axisGreen, sectionBlue };

// Grips: 1 the line; from 2 on ten of each handle, its knob and three parts of three axes.
constexpr int lineGrip = 1, firstHandle = 2, gripsOfHandle = 10;

const Vector3& directionOf(const CurveFrame& frame, int axis)
{
  return axis == 0 ? frame.along : axis == 1 ? frame.side : frame.outward;
}

} // namespace

struct vtkOversketchAxisHandleRepresentation::Internals
{
  std::vector<Vector3> curve; // before the edit
  std::vector<double> shares; // of its length, of each point
  std::optional<CurveFrames> frames;
  std::optional<View> drawnIn; // for drags in that view
  std::string text;
  std::vector<Operation> rows;

  struct Handle
  {
    double t;
    CurveFrame frame; // before the edit, its origin where the edit has taken it
  };
  std::vector<Handle> handles; // along the line
  std::vector<Vector3> moved;  // the line after the edit

  // At the press.
  Handle held{};
  Vector3 grabbed = Vector3::Zero();
  Vector2 from = Vector2::Zero();

  void follow();
  // Where an axis runs in the picture; absent where it points at the viewer.
  static std::optional<Vector2> seen(const View& view, const Handle& handle, int axis)
  {
    constexpr double step = 20.0; // px
    const Vector3& origin = handle.frame.origin;
    const Vector3 end = origin + step * pixelSize(view, origin) * directionOf(handle.frame, axis);
    if (!view.inFront(origin) || !view.inFront(end))
    {
      return std::nullopt;
    }
    const Vector2 run = (view.toDisplay(end) - view.toDisplay(origin)).head<2>();
    return run.norm() > leastSeen * step ? std::optional<Vector2>(run.normalized()) : std::nullopt;
  }
};

// All operations at once, as the system applies them to the line, whose weight is 1.
void vtkOversketchAxisHandleRepresentation::Internals::follow()
{
  this->handles.clear();
  this->moved = this->curve;
  if (!this->frames)
  {
    return;
  }
  const auto frameAt = [&](double t) { return this->frames->at(t); };
  std::function<Vector3(const Vector2&)> shiftOf;
  if (this->drawnIn)
  {
    shiftOf = [&](const Vector2& pixels)
    {
      const View& view = *this->drawnIn;
      const Vector3 middle = frameAt(0.5).origin;
      const Vector2 seen = view.toDisplay(middle).head<2>();
      return Vector3(
        view.toWorld(seen + pixels, view.depth(middle)) - view.toWorld(seen, view.depth(middle)));
    };
  }
  OperatedHandles operated = handlesOf(this->text, frameAt, shiftOf);
  shiftAll(operated.handles, operated.shift, frameAt);
  std::map<double, Matrix4> logs; // of all that is done at a place, at once
  for (const PlacedHandle& made : operated.handles)
  {
    logs.emplace(made.t, Matrix4::Zero()).first->second += logarithm(made.matrix);
  }
  std::vector<double> places;
  std::vector<Matrix4> sums;
  for (const auto& [t, log] : logs)
  {
    places.push_back(t);
    sums.push_back(log);
  }
  std::vector<double> weights;
  for (const double share : this->shares)
  {
    const std::vector<double> tent = tents(places, share);
    weights.insert(weights.end(), tent.begin(), tent.end());
  }
  this->moved = oversketch::moved(this->curve, sums, weights, Context());
  for (const double t : handlePlaces(this->rows))
  {
    Handle handle{ t, frameAt(t) };
    handle.frame.origin = (exponential(logs.at(t)) * handle.frame.origin.homogeneous()).head<3>();
    this->handles.push_back(handle);
  }
}

vtkOversketchAxisHandleRepresentation::vtkOversketchAxisHandleRepresentation()
  : Inner(std::make_unique<Internals>())
{
}

vtkOversketchAxisHandleRepresentation::~vtkOversketchAxisHandleRepresentation() = default;

int vtkOversketchAxisHandleRepresentation::GetPart(int grip) const
{
  const int part = (grip - firstHandle) % gripsOfHandle;
  return grip == lineGrip ? Line : grip < firstHandle ? -1 : part == 0 ? Knob : (part - 1) % 3;
}

int vtkOversketchAxisHandleRepresentation::GetHandle(int grip) const
{
  return grip < firstHandle ? -1 : (grip - firstHandle) / gripsOfHandle;
}

int vtkOversketchAxisHandleRepresentation::GetAxis(int grip) const
{
  const int part = (grip - firstHandle) % gripsOfHandle;
  return grip < firstHandle || part == 0 ? -1 : (part - 1) / 3;
}

bool vtkOversketchAxisHandleRepresentation::SetCurve(vtkPolyData* curve, vtkPolyData* mesh)
{
  Internals& inner = *this->Inner;
  inner.curve.clear();
  inner.frames.reset();
  bool fits = true;
  if (curve && mesh && curve->GetNumberOfPoints() > 0)
  {
    try
    {
      const auto data = SharedMesh(mesh);
      std::vector<Vector3> points, normals;
      for (const int v : VerticesOnce(ReadChain(curve, data->Surface().vertexCount(), "reference curve")))
      {
        points.push_back(data->Surface().points[v]);
        normals.push_back(data->Normals()[v]);
      }
      inner.frames.emplace(points, normals);
      inner.shares = sharesOf(points);
      inner.curve = points;
      inner.drawnIn.reset();
      if (!ViewArraysOf(curve).empty())
      {
        inner.drawnIn = ViewOf(curve);
      }
      inner.follow();
    }
    catch (const Error& error)
    {
      vtkErrorMacro(<< error.what());
      inner.curve.clear();
      inner.frames.reset();
      fits = false;
    }
  }
  if (!inner.frames)
  {
    inner.follow();
  }
  this->Modified();
  return fits;
}

void vtkOversketchAxisHandleRepresentation::SetOperations(const char* text)
{
  Internals& inner = *this->Inner;
  const std::string now = text ? text : "";
  if (now == inner.text)
  {
    return;
  }
  const std::string before = inner.text;
  try
  {
    inner.rows = operationsOf(now);
    inner.text = now;
    inner.follow();
    this->Modified();
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    inner.text = before;
    inner.rows = operationsOf(before);
    inner.follow();
  }
}

const char* vtkOversketchAxisHandleRepresentation::GetOperations() const
{
  return this->Inner->text.c_str();
}

int vtkOversketchAxisHandleRepresentation::GetNumberOfHandles() const
{
  return static_cast<int>(this->Inner->handles.size());
}

double vtkOversketchAxisHandleRepresentation::GetHandleT(int handle) const
{
  return handle >= 0 && handle < this->GetNumberOfHandles()
           ? this->Inner->handles[static_cast<std::size_t>(handle)].t
           : -1.0;
}

double vtkOversketchAxisHandleRepresentation::GetT(double x, double y)
{
  const Internals& inner = *this->Inner;
  if (!this->Renderer || inner.moved.size() < 2)
  {
    return -1.0;
  }
  const View view = PenView::of(this->Renderer).kernelView();
  return nearestShare(view, inner.moved, inner.shares, inViewport(this->Renderer, x, y)).value_or(-1.0);
}

bool vtkOversketchAxisHandleRepresentation::IsOnLine(double x, double y)
{
  if (!this->Renderer)
  {
    return false;
  }
  return distanceTo(PenView::of(this->Renderer).kernelView(),
           this->Inner->moved,
           false,
           inViewport(this->Renderer, x, y)) <= this->GetGrabDistance();
}

void vtkOversketchAxisHandleRepresentation::StartDrag(double x, double y, int handle, double t)
{
  Internals& inner = *this->Inner;
  if (!this->Renderer || inner.moved.empty())
  {
    return;
  }
  inner.from = inViewport(this->Renderer, x, y);
  inner.grabbed = placeAt(inner.moved, inner.shares, t);
  if (handle >= 0 && handle < this->GetNumberOfHandles())
  {
    inner.held = inner.handles[static_cast<std::size_t>(handle)];
  }
}

double vtkOversketchAxisHandleRepresentation::GetAmount(int part, int axis, double x, double y)
{
  const Internals& inner = *this->Inner;
  const double nothing = part == Scale ? 1.0 : 0.0;
  if (!this->Renderer)
  {
    return nothing;
  }
  const View view = PenView::of(this->Renderer).kernelView();
  const Vector2 to = inViewport(this->Renderer, x, y);
  const Vector3& origin = inner.held.frame.origin;
  const Vector3& along = directionOf(inner.held.frame, axis);
  if (part == Move && !Internals::seen(view, inner.held, axis))
  {
    const double towards = along.dot(view.towardsViewer(origin)) < 0.0 ? -1.0 : 1.0;
    return towards * (to[1] - inner.from[1]) * pixelSize(view, origin);
  }
  if (part == Rotate)
  {
    return degreesAbout(view, inner.from, to, origin, along);
  }
  const double a = alongAxis(view, inner.from, origin, along), b = alongAxis(view, to, origin, along);
  return part == Move ? b - a : a != 0.0 ? b / a : nothing;
}

void vtkOversketchAxisHandleRepresentation::GetShift(double x, double y, double shift[3])
{
  std::fill(shift, shift + 3, 0.0);
  if (this->Renderer)
  {
    const Internals& inner = *this->Inner;
    const View view = PenView::of(this->Renderer).kernelView();
    const double depth = view.depth(inner.grabbed);
    const Vector3 by =
      view.toWorld(inViewport(this->Renderer, x, y), depth) - view.toWorld(inner.from, depth);
    std::copy_n(by.data(), 3, shift);
  }
}

void vtkOversketchAxisHandleRepresentation::GetAlongAxes(double t, const double shift[3], double along[3])
{
  std::fill(along, along + 3, 0.0);
  if (this->Inner->frames)
  {
    const CurveFrame frame = this->Inner->frames->at(t);
    for (int axis = 0; axis < 3; ++axis)
    {
      along[axis] = directionOf(frame, axis).dot(Vector3(shift));
    }
  }
}

int vtkOversketchAxisHandleRepresentation::FindGrip(const View& view, double x, double y)
{
  const Internals& inner = *this->Inner;
  const Vector2 place(x, y);
  int found = 0;
  double least = this->GetGrabDistance();
  const int selected = this->SelectedHandle;
  if (selected >= 0 && selected < this->GetNumberOfHandles())
  {
    const Internals::Handle& handle = inner.handles[static_cast<std::size_t>(selected)];
    for (int axis = 0; axis < 3; ++axis)
    {
      if (const auto run = Internals::seen(view, handle, axis))
      {
        const Vector2 from = place - view.toDisplay(handle.frame.origin).head<2>();
        const double along = from.dot(*run), beside = std::abs(from[0] * (*run)[1] - from[1] * (*run)[0]);
        if (along >= freeOfKnob && along <= 3.0 * third + this->GetGrabDistance() && beside <= least)
        {
          least = beside;
          const int part = std::min(static_cast<int>(along / third), 2);
          found = firstHandle + gripsOfHandle * selected + 1 + 3 * axis + part;
        }
      }
    }
    const double far = (place - view.toDisplay(handle.frame.origin).head<2>()).norm();
    for (int axis = 0; found == 0 && axis < 3; ++axis) // where no other axis is
    {
      const bool moves = far < 0.5 * (movingRing + turningRing);
      const double beside = std::abs(far - (moves ? movingRing : turningRing));
      if (!Internals::seen(view, handle, axis) && view.inFront(handle.frame.origin) &&
          beside < std::min(least, 0.5 * (turningRing - movingRing)))
      {
        found = firstHandle + gripsOfHandle * selected + 1 + 3 * axis + (moves ? int(Move) : int(Rotate));
      }
    }
  }
  for (int i = 0; found == 0 && i < this->GetNumberOfHandles(); ++i)
  {
    const Vector3& at = inner.handles[static_cast<std::size_t>(i)].frame.origin;
    if (view.inFront(at) && (view.toDisplay(at).head<2>() - place).norm() <= this->GetGrabDistance())
    {
      found = firstHandle + gripsOfHandle * i;
    }
  }
  return found == 0 && distanceTo(view, inner.moved, false, place) <= this->GetGrabDistance() ? lineGrip
                                                                                              : found;
}

namespace
{

void paintRing(Overlay& overlay, const Vector2& at, double radius, const Colour& colour, bool isActive)
{
  Polyline ring = circle(at, radius, 48);
  ring.push_back(ring.front());
  overlay.rimmed({ ring }, isActive ? 4.5 : 3.0, isActive ? regionOrange : colour);
}

void paintAxis(Overlay& overlay, const Vector2& from, const Vector2& run, const Colour& colour, int active)
{
  const Vector2 beside(-run[1], run[0]);
  const auto at = [&](double along, double across) { return Vector2(from + along * run + across * beside); };
  for (const bool isRim : { true, false })
  {
    const double rim = isRim ? 1.5 : 0.0;
    for (int part = 0; part < 3; ++part)
    {
      const Colour& paint = isRim ? paperWhite : part == active ? regionOrange : colour;
      const double size = (part == active ? 8.0 : 6.0) + rim;
      overlay.line({ at(third * part + (part == 0 ? freeOfKnob : 0.0), 0.0),
                     at(third * (part + 1) - (part == 2 ? 15.0 : 0.0), 0.0) },
        (part == active ? 4.0 : 2.5) + 2.0 * rim,
        paint);
      const double middle = third * (part + 0.5);
      if (part == vtkOversketchAxisHandleRepresentation::Move)
      {
        overlay.polygon(
          { at(middle + 1.4 * size, 0.0), at(middle - 0.6 * size, size), at(middle - 0.6 * size, -size) },
          paint);
      }
      else if (part == vtkOversketchAxisHandleRepresentation::Scale)
      {
        const double half = 0.85 * size;
        overlay.polygon({ at(middle - half, half),
                          at(middle - half, -half),
                          at(middle + half, -half),
                          at(middle + half, half) },
          paint);
      }
      else
      {
        Polyline ring = circle({ middle, 0.0 }, 8.0, 32);
        ring.push_back(ring.front());
        std::transform(
          ring.begin(), ring.end(), ring.begin(), [&](const Vector2& p) { return at(p[0], p[1]); });
        overlay.line(ring, (part == active ? 4.5 : 3.5) + 2.0 * rim, paint);
      }
    }
  }
}

} // namespace

void vtkOversketchAxisHandleRepresentation::Paint(const View& view, Overlay& overlay)
{
  const Internals& inner = *this->Inner;
  const int active = this->GetActiveGrip();
  overlay.rimmed(seenIn(view, inner.moved), active == lineGrip ? 5.0 : 3.0, strokeRed);
  for (int i = 0; i < this->GetNumberOfHandles(); ++i)
  {
    const Internals::Handle& handle = inner.handles[static_cast<std::size_t>(i)];
    if (!view.inFront(handle.frame.origin))
    {
      continue;
    }
    const Vector2 at = view.toDisplay(handle.frame.origin).head<2>();
    const auto held = [this, active, i](int axis)
    { return GetHandle(active) == i && GetAxis(active) == axis ? GetPart(active) : -1; };
    for (int axis = 0; i == this->SelectedHandle && axis < 3; ++axis)
    {
      if (!Internals::seen(view, handle, axis)) // under the axes, which are taken hold of first
      {
        paintRing(overlay, at, movingRing, axisColours[axis], held(axis) == Move);
        paintRing(overlay, at, turningRing, axisColours[axis], held(axis) == Rotate);
      }
    }
    for (int axis = 0; i == this->SelectedHandle && axis < 3; ++axis)
    {
      if (const auto run = Internals::seen(view, handle, axis))
      {
        paintAxis(overlay, at, *run, axisColours[axis], held(axis));
      }
    }
    const bool isActive = active == firstHandle + gripsOfHandle * i;
    overlay.knob(at, isActive ? 7.0 : 5.5, i == this->SelectedHandle ? regionOrange : inkGrey);
  }
}

void vtkOversketchAxisHandleRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Operations: " << this->GetOperations() << "\n";
  os << indent << "SelectedHandle: " << this->SelectedHandle << "\n";
  os << indent << "Handles: " << this->GetNumberOfHandles() << "\n";
}
