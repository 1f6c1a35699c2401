#include "stroke_lines.h"

#include "viewport.h"

#include "Mesh/context.h"
#include "Stroke/polyline.h"
#include "pen_view.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkIdList.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <QApplication>
#include <QMouseEvent>

#include <cmath>

namespace oversketch_studio
{

using oversketch::PenView;
using oversketch::Polyline;
using oversketch::Vector2;
using oversketch::Vector3;

namespace
{

// px as Qt counts them: how near to a line a click is on it, and the lines' widths.
constexpr double near = 8.0;
constexpr float thin = 2.0F, thick = 4.0F;
constexpr double tolerance = 0.02; // of the model's size: what lies so much behind another surface is seen

} // namespace

StrokeLines::StrokeLines(Viewport* viewport)
  : QObject(viewport)
  , View(viewport)
  , Renderer(viewport->renderer())
{
  for (Drawn* drawn : { &this->Others, &this->Marked })
  {
    drawn->actor->SetMapper(drawn->mapper);
    drawn->mapper->ScalarVisibilityOff();
    // Over the surface that they lie on, and behind all else.
    drawn->mapper->SetResolveCoincidentTopologyToPolygonOffset();
    drawn->mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -6000.0);
    drawn->actor->GetProperty()->SetColor(0.86, 0.13, 0.12);
    drawn->actor->GetProperty()->LightingOff();
    drawn->actor->PickableOff();
    drawn->actor->UseBoundsOff();
    drawn->actor->VisibilityOff();
    viewport->renderer()->AddActor(drawn->actor);
  }
  this->Observer = this->Renderer->AddObserver(vtkCommand::StartEvent, this, &StrokeLines::frameBegins);
  viewport->setMouseTracking(true);
  viewport->installEventFilter(this);
}

StrokeLines::~StrokeLines()
{
  if (this->Renderer) // it may go first, with the view
  {
    this->Renderer->RemoveObserver(this->Observer);
  }
}

void StrokeLines::set(const std::vector<oversketch_session::SharedData>& lines)
{
  const bool none = lines.empty() && this->Lines.empty();
  this->Lines = lines;
  this->Hovered = -1;
  if (!none)
  {
    this->show();
  }
}

void StrokeLines::choose(int step, vtkPolyData* stroke)
{
  this->Chosen = step;
  this->Stroke = stroke;
  this->show();
}

void StrokeLines::showAll(bool all)
{
  this->All = all;
  this->Hovered = -1;
  this->show();
}

bool StrokeLines::isShown() const
{
  return this->Others.mapper->GetInput() || (this->Marked.mapper->GetInput() && !this->isHeld());
}

void StrokeLines::show()
{
  const bool before = this->isShown();
  const auto has = [this](int step)
  {
    return step >= 0 && static_cast<std::size_t>(step) < this->Lines.size() &&
           this->Lines[static_cast<std::size_t>(step)];
  };
  const int marked = has(this->Hovered) ? this->Hovered : has(this->Chosen) ? this->Chosen : -1;
  this->Marked.mapper->SetInputData(
    marked >= 0 ? this->Lines[static_cast<std::size_t>(marked)].own() : nullptr);
  vtkNew<vtkAppendPolyData> others;
  for (int step = 0; this->All && step < static_cast<int>(this->Lines.size()); ++step)
  {
    if (has(step) && step != marked)
    {
      others->AddInputData(this->Lines[static_cast<std::size_t>(step)].own());
    }
  }
  const bool any = others->GetNumberOfInputConnections(0) > 0;
  if (any)
  {
    others->Update();
  }
  this->Others.mapper->SetInputData(any ? others->GetOutput() : nullptr);
  if (before || this->isShown())
  {
    this->View->renderSoon();
  }
}

// The chosen stroke is shown by its tool where that can hold it.
bool StrokeLines::isHeld() const
{
  if (this->All || !this->Stroke)
  {
    return false;
  }
  try
  {
    return PenView::of(this->View->renderer()).fromTheSamePlace(PenView::of(this->Stroke));
  }
  catch (const oversketch::Error&)
  {
    return false; // a stroke of several views
  }
}

void StrokeLines::frameBegins()
{
  this->look(this->Marked, thick, this->isHeld() ? 0.0 : 1.0);
  this->look(this->Others, thin, this->All ? 0.75 : 0.0);
}

void StrokeLines::look(Drawn& drawn, float width, double opacity) const
{
  drawn.actor->SetVisibility(this->Visible && opacity > 0.0 && drawn.mapper->GetInput());
  drawn.actor->GetProperty()->SetOpacity(opacity);
  drawn.actor->GetProperty()->SetLineWidth(width * static_cast<float>(this->View->devicePixelRatioF()));
}

// Not behind the model, as the last frame has it.
bool StrokeLines::isSeen(const double place[3]) const
{
  vtkRenderer* renderer = this->View->renderer();
  renderer->SetWorldPoint(place[0], place[1], place[2], 1.0);
  renderer->WorldToDisplay();
  const double* at = renderer->GetDisplayPoint();
  const int x = static_cast<int>(std::lround(at[0])), y = static_cast<int>(std::lround(at[1]));
  renderer->SetDisplayPoint(x, y, renderer->GetZ(x, y));
  renderer->DisplayToWorld();
  const double* met = renderer->GetWorldPoint();
  if (met[3] == 0.0 || !this->View->mesh())
  {
    return true;
  }
  const Vector3 surface(met[0] / met[3], met[1] / met[3], met[2] / met[3]);
  const oversketch::View view = PenView::of(renderer).kernelView();
  return view.depth(surface) - view.depth(Vector3(place)) < tolerance * this->View->mesh()->GetLength();
}

int StrokeLines::at(const QPoint& place) const
{
  const double ratio = this->View->devicePixelRatioF();
  const Vector2 cursor(ratio * place.x(), ratio * (this->View->height() - 1 - place.y()));
  int found = -1;
  double least = near * ratio;
  try
  {
    const oversketch::View view = PenView::of(this->View->renderer()).kernelView();
    vtkNew<vtkIdList> ids;
    for (std::size_t step = 0; step < this->Lines.size(); ++step)
    {
      const bool isChosen = static_cast<int>(step) == this->Chosen && !this->isHeld();
      vtkPolyData* lines = this->All || isChosen ? this->Lines[step].Get() : nullptr;
      for (vtkIdType i = 0; lines && i < lines->GetNumberOfLines(); ++i)
      {
        lines->GetLines()->GetCellAtId(i, ids);
        Polyline seen;
        std::vector<Vector3> world;
        for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
        {
          const Vector3 point(lines->GetPoint(ids->GetId(k)));
          if (view.inFront(point))
          {
            seen.emplace_back(view.toDisplay(point).head<2>());
            world.push_back(point);
          }
        }
        const auto answer = oversketch::NearestPlace(seen)(cursor, least);
        if (answer.segment < 0 || answer.distance >= least)
        {
          continue;
        }
        const auto from = static_cast<std::size_t>(answer.segment);
        const Vector3 on = (1.0 - answer.t) * world[from] + answer.t * world[from + 1];
        if (this->isSeen(on.data()))
        {
          least = answer.distance;
          found = static_cast<int>(step);
        }
      }
    }
  }
  catch (const oversketch::Error&)
  {
    return -1; // a camera that sees nothing
  }
  return found;
}

void StrokeLines::hover(int step)
{
  if (step != this->Hovered)
  {
    this->Hovered = step;
    this->View->setCursor(step >= 0 ? Qt::PointingHandCursor : Qt::OpenHandCursor);
    this->show();
  }
}

bool StrokeLines::eventFilter(QObject*, QEvent* event)
{
  const auto type = event->type();
  if (type != QEvent::MouseButtonPress && type != QEvent::MouseMove && type != QEvent::MouseButtonRelease)
  {
    return false;
  }
  const auto* mouse = static_cast<QMouseEvent*>(event);
  const auto isNear = [&]
  { return (mouse->pos() - this->Press).manhattanLength() < QApplication::startDragDistance() / 2; };
  if (type == QEvent::MouseButtonPress)
  {
    this->Press = mouse->pos();
    this->Pressed = mouse->button() == Qt::LeftButton && mouse->modifiers() == Qt::NoModifier;
  }
  else if (type == QEvent::MouseMove)
  {
    this->Pressed = this->Pressed && isNear();
    if (this->All && mouse->buttons() == Qt::NoButton)
    {
      this->hover(this->at(mouse->pos()));
    }
  }
  else if (mouse->button() == Qt::LeftButton && this->Pressed && isNear())
  {
    this->Pressed = false;
    // After the tool has had it. The line that is lit under the cursor is meant: a look at the frame that it
    // is lit in may tell another.
    QMetaObject::invokeMethod(
      this,
      [this, place = mouse->pos(), lit = this->Hovered]
      { emit this->clicked(place, lit >= 0 ? lit : this->at(place)); },
      Qt::QueuedConnection);
  }
  return false;
}

} // namespace oversketch_studio
