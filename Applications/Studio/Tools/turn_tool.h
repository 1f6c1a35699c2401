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

  QString title() const override;
  QKeySequence key() const override;
  QString help() const override;
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override;
  QString advice(const Situation& situation) const override;
  void start() override;
  void stop() override {}

private:
  Viewport* View;
};

} // namespace oversketch_studio
#endif
