// The toy's tool: two lines round a part of the model, and the scene's picture pushes it.
#ifndef oversketch_applications_studio_tools_push_tool_h
#define oversketch_applications_studio_tools_push_tool_h

#include "tool.h"

#include "vtkNew.h"

class vtkCallbackCommand;
class vtkOversketchStrokeWidget;

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

private:
  void strokeEnds();

  Viewport* View;
  const Document* OpenDocument;
  vtkNew<vtkOversketchStrokeWidget> Pen;
  vtkNew<vtkCallbackCommand> Observer;
  oversketch_session::Lines First; // until the second is drawn
};

} // namespace oversketch_studio
#endif
