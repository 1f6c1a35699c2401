// The left button turns the model.
#ifndef oversketch_applications_studio_tools_turn_tool_h
#define oversketch_applications_studio_tools_turn_tool_h

#include "tool.h"

namespace oversketch_studio
{

class Viewport;

class TurnTool : public Tool
{
  Q_OBJECT

public:
  explicit TurnTool(Viewport* viewport);

  QString title() const override { return tr("Ro&tate"); }
  QKeySequence key() const override { return tr("T"); }
  QString help() const override { return tr("The left button rotates the model (T)"); }
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override
  {
    return { { tr("Left drag"), tr("rotate the model") }, { tr("Shift + left drag"), tr("pan") } };
  }
  QString advice(const Situation&) const override
  {
    return tr("Drag anywhere to rotate the model. D draws.");
  }
  void start() override;
  void stop() override {}

private:
  Viewport* View;
};

} // namespace oversketch_studio
#endif
