#include "direct_tool.h"

#include "vtkOversketchEditWidget.h"

namespace oversketch_studio
{

DirectTool::DirectTool(const std::shared_ptr<EditHand>& hand, Viewport* viewport)
  : EditTool(hand, vtkOversketchEditWidget::Direct, viewport)
{
  this->setObjectName("direct");
}

// Three axes on a line.
QPainterPath DirectTool::icon() const
{
  QPainterPath path;
  path.moveTo(2, 20);
  path.cubicTo(6, 13, 9, 17, 11, 15);
  path.lineTo(11, 3);
  path.moveTo(8.5, 6);
  path.lineTo(11, 3);
  path.lineTo(13.5, 6);
  path.moveTo(11, 15);
  path.lineTo(22, 15);
  path.moveTo(19, 12.5);
  path.lineTo(22, 15);
  path.lineTo(19, 17.5);
  path.moveTo(11, 15);
  path.lineTo(16, 21.5);
  return path;
}

QVector<QPair<QString, QString>> DirectTool::ways() const
{
  return {
    { tr("  On the line"), tr("all of it follows; beside it: turn the model") },
    { tr("  On an axis"), tr("inner third: move, middle: scale, outer: rotate") },
    { tr("Left click"), tr("on the line: a handle with three axes") },
    { tr("Delete"), tr("take the selected handle away") },
  };
}

QString DirectTool::way() const
{
  return tr("Drag the red line, or click on it for a handle with axes: inner third moves, middle scales, "
            "outer rotates. Shift over line or ring redraws a part. Return: done with it.");
}

} // namespace oversketch_studio
