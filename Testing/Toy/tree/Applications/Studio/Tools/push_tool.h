// The toy's tool: two lines round a part of the model, and the scene's picture pushes it. The wheel pushes
// the last step further, by a hand of its own: the model follows before the step has run again.
#ifndef oversketch_applications_studio_tools_push_tool_h
#define oversketch_applications_studio_tools_push_tool_h

#include "tool.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <optional>

class vtkCallbackCommand;
class vtkOversketchStrokeWidget;
class vtkOversketchSystem;

namespace oversketch_studio
{

class Document;
class Viewport;

class PushTool : public Tool
{
  Q_OBJECT

public:
  PushTool(Viewport* viewport, const Document* document);
  ~PushTool() override;

  QString title() const override;
  QKeySequence key() const override;
  QString help() const override;
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override;
  QString advice(const Situation& situation) const override;
  std::string system() const override { return "PushBetween"; }
  void start() override;
  void stop() override;
  bool draws() const override;
  void offer(const oversketch_session::Step& step,
    const oversketch_session::Worker::NodeState& state,
    const oversketch_session::Point& place) override;
  void offerNothing() override { this->Offered.reset(); }
  bool wheel(double notches, Qt::KeyboardModifiers modifiers, ulong time) override;

private:
  void strokeEnds();

  Viewport* View;
  const Document* OpenDocument;
  vtkNew<vtkOversketchStrokeWidget> Pen;
  vtkNew<vtkCallbackCommand> Observer;
  oversketch_session::Lines First; // until the second is drawn
  std::optional<oversketch_session::Step> Offered;
  vtkSmartPointer<vtkOversketchSystem> Hand; // makes what is seen while the wheel turns
};

} // namespace oversketch_studio
#endif
