// A tool of system B: one of the ways to change what lies between a line on the model and a ring round it.
#ifndef oversketch_applications_studio_tools_edit_tool_h
#define oversketch_applications_studio_tools_edit_tool_h

#include "tool.h"

#include <memory>

namespace oversketch_studio
{

class EditHand;
class Viewport;

class EditTool : public Tool
{
  Q_OBJECT

public:
  // For a mode of the hand (vtkOversketchEditWidget::ModeType), which it shares with the other tools.
  EditTool(const std::shared_ptr<EditHand>& hand, int mode, Viewport* viewport);
  ~EditTool() override;

  QVector<QPair<QString, QString>> keys() const override;
  QString hint() const override;
  HintShape hintShape() const override;
  QString advice(const Situation& situation) const override;
  bool judges() const override;
  QString stage(const QString& name) const override;
  std::string system() const override { return "Edit"; }
  void select(int node) override;
  void start() override;
  void stop() override;
  bool draws() const override;
  bool moves() const override;
  void offer(const oversketch_session::Step& step,
    const oversketch_session::Worker::NodeState& state,
    const oversketch_session::Point& place) override;
  void offerNothing() override;
  void setMesh(vtkPolyData* mesh) override;
  void setPixelRatio(double ratio) override;
  void setSteadiness(double pixels) override;
  void setPressure(double pressure) override;
  void showLines(bool show) override;

  EditHand& hand() const { return *this->Hand; }

protected:
  // What can be done to a region with it, for the list of keys and as advice.
  virtual QVector<QPair<QString, QString>> ways() const = 0;
  virtual QString way() const = 0;
  Viewport* viewport() const { return this->View; }

private:
  std::shared_ptr<EditHand> Hand;
  int Mode;
  Viewport* View;
};

} // namespace oversketch_studio
#endif
