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

void TurnTool::start()
{
  this->View->camera()->SetModeToNavigate();
  this->View->setHandCursor(Qt::OpenHandCursor);
}

} // namespace oversketch_studio
