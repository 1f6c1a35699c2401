// A tool of system B: one of the ways to change what lies between a line on the model and a ring round it.
#ifndef oversketch_applications_studio_tools_edit_tool_h
#define oversketch_applications_studio_tools_edit_tool_h

#include "edit_hand.h"
#include "edit_panel.h"
#include "tool.h"
#include "viewport.h"

#include <QPointer>

#include <memory>

namespace oversketch_studio
{

class EditTool : public Tool
{
  Q_OBJECT

public:
  // For a mode of the hand (vtkOversketchEditWidget::ModeType), which it shares with the other tools.
  EditTool(const std::shared_ptr<EditHand>& hand, int mode, Viewport* viewport);

  QVector<QPair<QString, QString>> keys() const override;
  QString hint() const override;
  HintShape hintShape() const override { return this->Hand->hasLine() ? HintShape::Ring : HintShape::Line; }
  QString advice(const Situation& situation) const override;
  bool judges() const override;
  QString stage(const QString& name) const override;
  std::string system() const override { return "Edit"; }
  void select(int) override { this->Hand->select(); }
  void start() override { this->Hand->takeUp(this->Mode); }
  void stop() override { this->Hand->putDown(); }
  bool draws() const override { return this->Hand->draws(); }
  bool moves() const override { return this->Hand->moves(); }
  bool takesShift(double, double) override { return this->Hand->hasLine(); } // it redraws line and ring
  void offer(const oversketch_session::Step& step,
    const oversketch_session::Worker::NodeState& state,
    const oversketch_session::Point&) override
  {
    this->Hand->offer(step, state);
  }
  void offerNothing() override { this->Hand->offerNothing(); }
  void setMesh(vtkPolyData* mesh) override;
  void setPixelRatio(double ratio) override { this->Hand->setPixelRatio(ratio); }
  void setSteadiness(double pixels) override { this->Hand->setSteadiness(pixels); }
  void setPressure(double pressure) override { this->Hand->setPressure(pressure); }
  void showLines(bool show) override { this->Hand->showLines(show); }
  void setDark(bool dark) override;

  EditHand& hand() const { return *this->Hand; }

protected:
  // The things that can be done to a region with it, for the list of keys and as advice.
  virtual QVector<QPair<QString, QString>> ways() const = 0;
  virtual QString way() const = 0;
  Viewport* viewport() const { return this->View; }
  bool isHeld() const { return this->View->tool() == this; }

  QPointer<EditPanel> Panel; // null: it has none

private:
  std::shared_ptr<EditHand> Hand;
  int Mode;
  Viewport* View;
};

} // namespace oversketch_studio
#endif
