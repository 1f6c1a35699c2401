#include "turn_tool.h"

#include "viewport.h"

#include "vtkOversketchInteractorStyle.h"

namespace oversketch_studio
{

TurnTool::TurnTool(Viewport* viewport)
  : Tool(viewport)
  , View(viewport)
{
}

QString TurnTool::title() const
{
  return tr("Ro&tate");
}

QKeySequence TurnTool::key() const
{
  return tr("T");
}

QString TurnTool::help() const
{
  return tr("The left button rotates the model (T)");
}

// An arrow round an upright axis.
QPainterPath TurnTool::icon() const
{
  QPainterPath path;
  path.moveTo(12, 2);
  path.lineTo(12, 22);
  path.arcMoveTo(3, 8, 18, 9, 60);
  path.arcTo(3, 8, 18, 9, 60, 300);
  path.moveTo(22, 8);
  path.lineTo(21, 12.5);
  path.lineTo(16.5, 11.5);
  return path;
}

QVector<QPair<QString, QString>> TurnTool::keys() const
{
  return { { tr("Left drag"), tr("rotate the model") }, { tr("Shift + left drag"), tr("pan") } };
}

QString TurnTool::advice(const Situation&) const
{
  return tr("Drag anywhere to rotate the model. D draws.");
}

void TurnTool::start()
{
  this->View->camera()->SetModeToNavigate();
  this->View->setHandCursor(Qt::OpenHandCursor);
}

} // namespace oversketch_studio
