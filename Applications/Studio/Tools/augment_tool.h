// System D's tool: a line on the surface, and the model becomes finer there and rises.
#ifndef oversketch_applications_studio_tools_augment_tool_h
#define oversketch_applications_studio_tools_augment_tool_h

#include "held_stroke_tool.h"

namespace oversketch_studio
{

class AugmentOptions;
class ProfileEditor;

class AugmentTool : public HeldStrokeTool
{
  Q_OBJECT

public:
  AugmentTool(Viewport* viewport, const Document* document);

  QString title() const override { return tr("&Line on surface"); }
  QKeySequence key() const override { return tr("B"); }
  QString help() const override
  {
    return tr("Draw a line on the model, and it rises (B). The middle button always turns.");
  }
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override;
  QString hint() const override { return tr("Draw a line on the body like this, and it rises"); }
  HintShape hintShape() const override { return HintShape::Line; }
  QString advice(const Situation& situation) const override;
  QString stage(const QString& name) const override;
  // The options are those of the red line, which follows them, and of the lines that come.
  oversketch_session::Values options() const override;
  void setOptions(const oversketch_session::Values& options) override;
  QString pressure() const override { return tr("is the line's height, where Pressure is height is ticked"); }
  QWidget* makePanel(QWidget* parent) override;
  void offer(const oversketch_session::Step& step,
    const oversketch_session::Worker::NodeState& state,
    const oversketch_session::Point& place) override;
  bool wheel(double notches, Qt::KeyboardModifiers modifiers, ulong time) override;

protected:
  vtkSmartPointer<vtkPolyData> meshBefore() const override;

private:
  oversketch_session::Values values() const;
  void reshape(bool mergesIntoLast) { this->shape(this->values(), mergesIntoLast); }

  AugmentOptions* Options;
  ProfileEditor* Profile;
};

} // namespace oversketch_studio
#endif
