// System B's tool Profile: a plane slides along the line, and what it cuts is drawn anew in a dock.
#ifndef oversketch_applications_studio_tools_profile_tool_h
#define oversketch_applications_studio_tools_profile_tool_h

#include "edit_tool.h"

namespace oversketch_studio
{

class ProfileTool : public EditTool
{
  Q_OBJECT

public:
  ProfileTool(const std::shared_ptr<EditHand>& hand, Viewport* viewport);
  ~ProfileTool() override;

  QString title() const override { return tr("&Profile"); }
  QKeySequence key() const override { return tr("A"); }
  QString help() const override
  {
    return tr("Draw a line on the model and a ring round it, and redraw its cross-section (A)");
  }
  QPainterPath icon() const override;
  QWidget* makePanel(QWidget* parent) override;

protected:
  QVector<QPair<QString, QString>> ways() const override;
  QString way() const override;
};

} // namespace oversketch_studio
#endif
