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

  QString title() const override;
  QKeySequence key() const override;
  QString help() const override;
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override;
  QString hint() const override;
  QString advice(const Situation& situation) const override;
  QString remedy() const override;
  QString stage(const QString& name) const override;
};

} // namespace oversketch_studio
#endif
