// System B's tool Direct: the line itself is dragged, or axes on it.
#ifndef oversketch_applications_studio_tools_direct_tool_h
#define oversketch_applications_studio_tools_direct_tool_h

#include "edit_tool.h"

namespace oversketch_studio
{

class DirectTool : public EditTool
{
  Q_OBJECT

public:
  DirectTool(const std::shared_ptr<EditHand>& hand, Viewport* viewport);

  QString title() const override;
  QKeySequence key() const override;
  QString help() const override;
  QPainterPath icon() const override;

protected:
  QVector<QPair<QString, QString>> ways() const override;
  QString way() const override;
};

} // namespace oversketch_studio
#endif
