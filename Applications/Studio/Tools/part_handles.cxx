#include "part_handles.h"

#include "viewport.h"

#include "pen_view.h"

#include "vtkActor2D.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <string>
#include <vector>

namespace oversketch_studio
{

using namespace oversketch_session;
using oversketch::Vector2;

namespace
{

// px as Qt counts them: of handles, how near to one the cursor takes hold of it, of the way to the depth's.
constexpr double handleSize = 10.0, handleGrabDistance = 9.0, depthDistance = 56.0, boxLineWidth = 2.0;
constexpr float first = 1.0F; // before camera and tools

void setPlaces(vtkPolyData* data, const std::vector<Vector2>& places, bool areLines)
{
  vtkNew<vtkPoints> points;
  for (const Vector2& place : places)
  {
    points->InsertNextPoint(place[0], place[1], 0.0);
  }
  vtkNew<vtkCellArray> cells;
  const auto count = static_cast<vtkIdType>(places.size());
  for (vtkIdType i = 0; i < count; i += areLines ? 2 : 1)
  {
    const vtkIdType ids[2] = { i, i + 1 };
    cells->InsertNextCell(areLines ? 2 : 1, ids);
  }
  data->Initialize();
  data->SetPoints(points);
  areLines ? data->SetLines(cells) : data->SetVerts(cells);
}

} // namespace

PartHandles::PartHandles(Viewport* view)
  : View(view)
{
  const double blue[3] = { 0.30, 0.60, 1.00 }, orange[3] = { 0.98, 0.62, 0.20 };
  const auto add = [this](vtkPolyData* data, vtkActor2D* actor, const double colour[3])
  {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    actor->PickableOff();
    actor->VisibilityOff();
    this->View->renderer()->AddActor2D(actor);
  };
  add(this->Lines, this->LineActor, blue);
  add(this->Corners, this->CornerActor, blue);
  add(this->Depth, this->DepthActor, orange);
  this->setPixelRatio(1.0);
  this->Observer->SetClientData(this);
  this->Observer->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<PartHandles*>(self)->heard(event); });
  for (const unsigned long event : { vtkCommand::LeftButtonPressEvent,
         vtkCommand::MouseMoveEvent,
         vtkCommand::LeftButtonReleaseEvent,
         vtkCommand::KeyPressEvent })
  {
    view->interactor()->AddObserver(event, this->Observer, first);
  }
}

PartHandles::~PartHandles()
{
  this->View->interactor()->RemoveObserver(this->Observer);
  for (vtkActor2D* actor : { this->LineActor.Get(), this->CornerActor.Get(), this->DepthActor.Get() })
  {
    this->View->renderer()->RemoveActor2D(actor);
  }
}

void PartHandles::setPixelRatio(double ratio)
{
  this->Ratio = ratio;
  this->LineActor->GetProperty()->SetLineWidth(static_cast<float>(boxLineWidth * ratio));
  this->CornerActor->GetProperty()->SetPointSize(static_cast<float>(handleSize * ratio));
  this->DepthActor->GetProperty()->SetPointSize(static_cast<float>(handleSize * ratio));
}

void PartHandles::show(const std::optional<PartPlace>& place)
{
  if (!place)
  {
    this->Held.reset();
    this->point(std::nullopt);
  }
  if (place == this->Place)
  {
    return;
  }
  this->Place = place;
  this->follow(); // no frame follows once the tool is put down
  this->View->renderSoon();
}

void PartHandles::follow()
{
  this->Seen.reset();
  std::array<Vector2, 6> seen;
  const int* size = this->View->renderer()->GetSize();
  if (this->Place && size[0] > 0 && size[1] > 0 &&
      seeHandles(oversketch::PenView::of(this->View->renderer()).kernelView(),
        *this->Place,
        depthDistance * this->Ratio,
        seen))
  {
    this->Seen = seen;
    setPlaces(this->Lines,
      { seen[0], seen[1], seen[1], seen[2], seen[2], seen[3], seen[3], seen[0], seen[4], seen[5] },
      true);
    setPlaces(this->Corners, { seen.begin(), seen.begin() + 5 }, false);
    setPlaces(this->Depth, { seen[5] }, false);
  }
  for (vtkActor2D* actor : { this->LineActor.Get(), this->CornerActor.Get(), this->DepthActor.Get() })
  {
    actor->SetVisibility(this->Seen && this->Visible);
  }
}

std::optional<PartHandle> PartHandles::handleAt(const Vector2& place) const
{
  std::optional<PartHandle> nearest;
  double least = handleGrabDistance * this->Ratio;
  for (std::size_t i = 0; this->Seen && this->Visible && i < this->Seen->size(); ++i)
  {
    const double distance = ((*this->Seen)[i] - place).norm();
    if (distance < least)
    {
      least = distance;
      nearest = static_cast<PartHandle>(i);
    }
  }
  return nearest;
}

void PartHandles::point(const std::optional<PartHandle>& handle)
{
  if (handle.has_value() != this->Pointed)
  {
    this->Pointed = handle.has_value();
    this->View->setHandCursor(this->Pointed ? Qt::SizeAllCursor : Qt::OpenHandCursor);
  }
}

void PartHandles::heard(unsigned long event)
{
  vtkRenderWindowInteractor* interactor = this->View->interactor();
  const int* position = interactor->GetEventPosition();
  const Vector2 at(position[0], position[1]);
  this->Observer->SetAbortFlag(0);
  if (!this->Place)
  {
    return;
  }
  if (event == vtkCommand::LeftButtonPressEvent)
  {
    if (const auto handle = this->handleAt(at))
    {
      this->Held = Drag{ *handle, at, *this->Place };
      this->Observer->SetAbortFlag(1);
    }
    return;
  }
  if (!this->Held)
  {
    if (event == vtkCommand::MouseMoveEvent)
    {
      this->point(this->handleAt(at));
    }
    return;
  }
  this->Observer->SetAbortFlag(1); // nobody else hears of a drag
  if (event == vtkCommand::MouseMoveEvent)
  {
    const PartPlace place = dragged(oversketch::PenView::of(this->View->renderer()).kernelView(),
      this->Held->from,
      this->Held->handle,
      this->Held->start,
      at,
      interactor->GetShiftKey() != 0);
    if (!(place == *this->Place))
    {
      this->Place = place;
      const bool mergesIntoLast = std::exchange(this->Held->hasMoved, true);
      this->View->renderSoon();
      this->moved(place, mergesIntoLast);
    }
  }
  else if (event == vtkCommand::LeftButtonReleaseEvent)
  {
    this->Held.reset();
  }
  else if (interactor->GetKeySym() && std::string(interactor->GetKeySym()) == "Escape")
  {
    const bool wasMoved = this->Held->hasMoved;
    this->Held.reset();
    if (wasMoved)
    {
      this->givenUp();
    }
  }
}

} // namespace oversketch_studio
