#include "axis_gizmo.h"

#include "viewport.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <QApplication>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace oversketch_studio
{

namespace
{

constexpr int side = 84;         // px as Qt counts them
constexpr double length = 30.0;  // of an axis
constexpr double positive = 8.5; // radius of its ends
constexpr double negative = 5.5;
const QColor colours[3] = { { 214, 72, 84 }, { 112, 164, 40 }, { 62, 126, 214 } };

} // namespace

AxisGizmo::AxisGizmo(Viewport* view)
  : QWidget(view)
  , View(view)
  , Renderer(view->renderer())
{
  this->setObjectName("axis_gizmo");
  this->setFixedSize(side, side);
  this->setMouseTracking(true);
  this->setFocusPolicy(Qt::NoFocus); // the same by the View menu
  this->setCursor(Qt::ArrowCursor);
  this->setAccessibleName(tr("Axes"));
  this->Observer = this->Renderer->AddObserver(vtkCommand::EndEvent, this, &AxisGizmo::look);
  this->look();
}

AxisGizmo::~AxisGizmo()
{
  this->Renderer->RemoveObserver(this->Observer);
}

void AxisGizmo::look()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const bool parallel = camera->GetParallelProjection() != 0;
  if (std::exchange(this->Parallel, parallel) != parallel)
  {
    emit this->projected(parallel);
  }
  const vtkMatrix4x4* view = camera->GetViewTransformMatrix();
  std::array<std::array<double, 3>, 3> axes;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < 3; ++i)
    {
      axes[axis][i] = view->GetElement(i, axis);
    }
  }
  if (axes != this->Axes)
  {
    this->Axes = axes;
    this->update();
  }
}

QPointF AxisGizmo::end(int axis, bool isNegative) const
{
  const double reach = isNegative ? -length : length;
  return QPointF(0.5 * side + reach * this->Axes[axis][0], 0.5 * side - reach * this->Axes[axis][1]);
}

void AxisGizmo::setDark(bool dark)
{
  this->Dark = dark;
  this->update();
}

std::optional<AxisGizmo::End> AxisGizmo::endAt(const QPointF& at) const
{
  std::optional<End> found;
  double nearest = -2.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool isNegative : { false, true })
    {
      const QPointF from = at - this->end(axis, isNegative);
      const double depth = isNegative ? -this->Axes[axis][2] : this->Axes[axis][2];
      if (std::hypot(from.x(), from.y()) <= (isNegative ? negative : positive) + 1.5 && depth > nearest)
      {
        found = End{ axis, isNegative };
        nearest = depth;
      }
    }
  }
  return found;
}

void AxisGizmo::setHovered(const std::optional<End>& end)
{
  if (!(end == this->Hovered))
  {
    this->Hovered = end;
    this->update();
  }
}

bool AxisGizmo::event(QEvent* event)
{
  if (event->type() == QEvent::ToolTip)
  {
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto end = this->endAt(help->pos());
    const QString sides[3][2] = {
      { tr("Right"), tr("Left") }, { tr("Top"), tr("Bottom") }, { tr("Front"), tr("Back") }
    };
    if (end)
    {
      QToolTip::showText(help->globalPos(), sides[end->axis][end->negative], this);
    }
    return true;
  }
  return QWidget::event(event);
}

void AxisGizmo::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (this->underMouse() || this->Turns)
  {
    painter.setPen(Qt::NoPen);
    painter.setBrush(this->Dark ? QColor(255, 255, 255, 28) : QColor(0, 0, 0, 24));
    painter.drawEllipse(this->rect().adjusted(1, 1, -1, -1));
  }
  std::vector<End> ends;
  for (int axis = 0; axis < 3; ++axis)
  {
    ends.push_back({ axis, false });
    ends.push_back({ axis, true });
  }
  const auto depth = [this](const End& end) { return (end.negative ? -1.0 : 1.0) * this->Axes[end.axis][2]; };
  std::sort(ends.begin(), ends.end(), [&](const End& a, const End& b) { return depth(a) < depth(b); });
  QFont font = this->font();
  font.setPixelSize(11);
  font.setBold(true);
  painter.setFont(font);
  const QString names[3] = { tr("X"), tr("Y"), tr("Z") };
  for (const End& end : ends)
  {
    const QPointF at = this->end(end.axis, end.negative);
    const bool hovered = this->Hovered && *this->Hovered == end;
    QColor colour = colours[end.axis];
    if (end.negative)
    {
      painter.setPen(QPen(colour, 1.5));
      colour.setAlpha(hovered ? 255 : 70);
      painter.setBrush(colour);
      painter.drawEllipse(at, negative, negative);
      continue;
    }
    painter.setPen(QPen(colour, 2.2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(0.5 * side, 0.5 * side), at);
    painter.setPen(hovered ? QPen(Qt::white, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(colour);
    painter.drawEllipse(at, positive, positive);
    painter.setPen(Qt::white);
    painter.drawText(QRectF(at.x() - 10, at.y() - 10, 20, 20), Qt::AlignCenter, names[end.axis]);
  }
}

void AxisGizmo::mousePressEvent(QMouseEvent* event)
{
  this->Pressed = this->Last = event->pos();
  this->Turns = false;
  this->Passes = !this->endAt(event->pos());
  event->setAccepted(!this->Passes); // else it is the view's: handles may lie between the ends
}

void AxisGizmo::mouseMoveEvent(QMouseEvent* event)
{
  if (this->Passes)
  {
    event->ignore();
    return;
  }
  if (!(event->buttons() & Qt::LeftButton))
  {
    this->setHovered(this->endAt(event->pos()));
    event->setAccepted(this->Hovered.has_value());
    return;
  }
  this->Turns =
    this->Turns || (event->pos() - this->Pressed).manhattanLength() >= QApplication::startDragDistance();
  if (this->Turns)
  {
    // A way across it is half a turn.
    const double scale = double(this->View->height()) * this->View->devicePixelRatioF() / side;
    const QPoint by = event->pos() - this->Last;
    this->Last = event->pos();
    this->setHovered({});
    this->View->camera()->TurnBy(scale * by.x(), -scale * by.y());
  }
}

void AxisGizmo::mouseReleaseEvent(QMouseEvent* event)
{
  if (std::exchange(this->Passes, false))
  {
    event->ignore();
    return;
  }
  const auto end = this->endAt(this->Pressed);
  if (event->button() == Qt::LeftButton && !this->Turns && end && end == this->endAt(event->pos()))
  {
    this->View->camera()->LookFromSide(end->axis, end->negative);
  }
  this->Turns = false;
  this->update();
}

void AxisGizmo::leaveEvent(QEvent*)
{
  this->setHovered({});
  this->update();
}

} // namespace oversketch_studio
