// A line over the model, and the surface is smooth there; with Shift in any tool's hand (HandGestures).
#ifndef oversketch_applications_studio_tools_relax_tool_h
#define oversketch_applications_studio_tools_relax_tool_h

#include "held_stroke_tool.h"

namespace oversketch_studio
{

class LengthBox;

class RelaxTool : public HeldStrokeTool
{
  Q_OBJECT

public:
  RelaxTool(Viewport* viewport, const Document* document);

  QString title() const override { return tr("Smoot&h"); }
  QKeySequence key() const override { return tr("Q"); }
  QString help() const override
  {
    return tr("Draw over the model, and it is smooth there (Q, or Shift + drag with any tool). The middle "
              "button always turns.");
  }
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override;
  QString hint() const override { return tr("Draw over the body like this, and it is smooth there"); }
  HintShape hintShape() const override { return HintShape::Line; }
  QString advice(const Situation& situation) const override;
  QString stage(const QString&) const override { return tr("Smoothing"); }
  QString pressure() const override { return tr("is how much it smooths"); }
  // The radius as a share of the model's size.
  oversketch_session::Values options() const override;
  void setOptions(const oversketch_session::Values& options) override;
  void offer(const oversketch_session::Step& step,
    const oversketch_session::Worker::NodeState& state,
    const oversketch_session::Point& place) override;
  bool wheel(double notches, Qt::KeyboardModifiers modifiers, ulong time) override;

private:
  void setRadius(double radius, bool mergesIntoLast);

  QWidget* Bar;
  LengthBox* Radius;
  ulong WheelTime = 0;
};

} // namespace oversketch_studio
#endif
