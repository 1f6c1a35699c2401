#include "one_stroke_tool.h"

namespace oversketch_studio
{

OneStrokeTool::OneStrokeTool(Viewport* viewport, const Document* document)
  : HeldStrokeTool("OneStroke", viewport, document)
{
  this->setObjectName("outline");
}

// A limb, and the line that it is to follow.
QPainterPath OneStrokeTool::icon() const
{
  QPainterPath path;
  path.moveTo(7, 22);
  path.cubicTo(7, 13, 9, 11, 12, 11);
  path.cubicTo(15, 11, 17, 13, 17, 22);
  path.moveTo(2.5, 17);
  path.cubicTo(2.5, 7, 6, 2.5, 12, 2.5);
  path.cubicTo(18, 2.5, 21.5, 7, 21.5, 17);
  return path;
}

QVector<QPair<QString, QString>> OneStrokeTool::keys() const
{
  return HeldStrokeTool::keys() + QVector<QPair<QString, QString>>{
    { "F3", tr("take the next outline that fits") },
    { "[  ]", tr("move less or more of the body") },
  };
}

QString OneStrokeTool::advice(const Situation& situation) const
{
  if (situation.redraws)
  {
    return tr("Redraw the selected stroke. T leaves it as it is.");
  }
  if (situation.selected)
  {
    return tr(
      "Blue is where the selected stroke took hold. Change how it acts on the right, or redraw it (Ctrl+R).");
  }
  if (situation.empty || !situation.holds)
  {
    return tr("Draw a line beside a limb's outline: the limb follows. The middle button turns the model, F1 "
              "lists the keys.");
  }
  return tr("Draw on, or drag the red line to move the stroke (Shift: redraw a part; Return: leave it and "
            "draw there). Ctrl+Z undoes. The middle button turns the model.");
}

QString OneStrokeTool::stage(const QString& name) const
{
  if (name == "ShapeDiameter" || name == "MixtureRegion")
  {
    return tr("Finding the limb");
  }
  if (name == "Stretch")
  {
    return tr("Making triangles");
  }
  if (name == "Restore")
  {
    return tr("Evening out triangles");
  }
  return name.startsWith("Deform") || name.startsWith("Correction") ? tr("Deforming")
                                                                    : tr("Finding the outline");
}

} // namespace oversketch_studio
