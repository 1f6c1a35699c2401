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

  QString title() const override { return tr("Dir&ect edit"); }
  QKeySequence key() const override { return tr("E"); }
  QString help() const override
  {
    return tr("Draw a line on the model and a ring round it, and drag the line (E)");
  }
  QPainterPath icon() const override;

protected:
  QVector<QPair<QString, QString>> ways() const override;
  QString way() const override;
};

} // namespace oversketch_studio
#endif
