// System A's tool: a line beside an outline, and the limb follows.
#ifndef oversketch_applications_studio_tools_one_stroke_tool_h
#define oversketch_applications_studio_tools_one_stroke_tool_h

#include "held_stroke_tool.h"

namespace oversketch_studio
{

class OneStrokeTool : public HeldStrokeTool
{
  Q_OBJECT

public:
  OneStrokeTool(Viewport* viewport, const Document* document);

  QString title() const override { return tr("&Outline"); }
  QKeySequence key() const override { return tr("D"); }
  QString help() const override
  {
    return tr("Draw where an outline shall be (D). The middle button always turns.");
  }
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override;
  QString hint() const override { return tr("Draw a line like this, and the tail follows"); }
  QString advice(const Situation& situation) const override;
  QString remedy() const override { return tr("Ctrl+Z undo · F3 other outline · [ ] reach"); }
  QString stage(const QString& name) const override;
};

} // namespace oversketch_studio
#endif
