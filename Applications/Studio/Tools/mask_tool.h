// A lasso round a part of the model, which no step then moves; and what else a mask may do.
#ifndef oversketch_applications_studio_tools_mask_tool_h
#define oversketch_applications_studio_tools_mask_tool_h

#include "held_stroke_tool.h"

class QCheckBox;
class QComboBox;

namespace oversketch_studio
{

class LengthBox;

class MaskTool : public HeldStrokeTool
{
  Q_OBJECT

public:
  MaskTool(Viewport* viewport, const Document* document);

  QString title() const override { return tr("Mas&k"); }
  QKeySequence key() const override { return tr("4"); }
  QString help() const override
  {
    return tr(
      "Draw a lasso round a part of the model, and no step moves it (4). The middle button always turns.");
  }
  QPainterPath icon() const override;
  QString advice(const Situation& situation) const override;
  QString stage(const QString&) const override { return tr("Masking"); }
  oversketch_session::Values options() const override;
  void setOptions(const oversketch_session::Values& options) override;
  void offer(const oversketch_session::Step& step,
    const oversketch_session::Worker::NodeState& state,
    const oversketch_session::Point& place) override;

private:
  oversketch_session::Values ofLassos() const;
  // Gives the step that is offered these values beside its own, or makes one of them alone.
  void act(const oversketch_session::Values& values);
  void grow(double length);

  QWidget* Bar;
  QComboBox* Mode;
  QCheckBox* Through;
  LengthBox* Length;
  oversketch_session::Values Selected; // of the step that is offered
};

} // namespace oversketch_studio
#endif
