// System B's tool Shade: grey layers say how far the model follows the line, on the model and on a disc in a
// dock.
#ifndef oversketch_applications_studio_tools_shade_tool_h
#define oversketch_applications_studio_tools_shade_tool_h

#include "edit_tool.h"

#include <QPointer>

class QSpinBox;
class QToolButton;

namespace oversketch_studio
{

class ShadeTool : public EditTool
{
  Q_OBJECT

public:
  ShadeTool(const std::shared_ptr<EditHand>& hand, Viewport* viewport);
  ~ShadeTool() override;

  QString title() const override { return tr("Sh&ade"); }
  QKeySequence key() const override { return tr("S"); }
  QString help() const override
  {
    return tr(
      "Draw a line on the model and a ring round it, and say by grey layers how far the model follows (S)");
  }
  QPainterPath icon() const override;
  QWidget* makePanel(QWidget* parent) override;
  void start() override;

protected:
  QVector<QPair<QString, QString>> ways() const override;
  QString way() const override;

private:
  // The dock shows what the hand has.
  void follow();

  QPointer<QToolButton> Lasso;
  QPointer<QSpinBox> Levels;
  int Areas = 0; // when the dock last followed
};

} // namespace oversketch_studio
#endif
