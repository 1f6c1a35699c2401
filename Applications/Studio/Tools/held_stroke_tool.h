// A tool of a system that is given one stroke: it is drawn with the pen, stays, and can be taken hold of.
#ifndef oversketch_studio_held_stroke_tool_h
#define oversketch_studio_held_stroke_tool_h

#include "pen_section.h"
#include "preview.h"
#include "tool.h"

#include "vtkNew.h"

#include <memory>

class QComboBox;
class vtkCallbackCommand;
class vtkOversketchHeldStrokeWidget;
class vtkOversketchStrokeWidget;

namespace oversketch_studio
{

class Document;
class Viewport;

class HeldStrokeTool : public Tool
{
  Q_OBJECT

public:
  // Of a system of the list.
  HeldStrokeTool(const std::string& system, Viewport* viewport, const Document* document);
  ~HeldStrokeTool() override;

  QVector<QPair<QString, QString>> keys() const override;
  std::string system() const override { return this->System; }
  // Mirror, where the system's steps can have one.
  QWidget* makeOptions(QWidget* parent) override;
  void start() override;
  void stop() override;
  bool draws() const override;
  bool moves() const override;
  void offer(const oversketch_session::Step& step,
    const oversketch_session::Worker::NodeState& state,
    const oversketch_session::Point& place) override;
  void offerNothing() override;
  void setFollowing(const std::shared_ptr<const oversketch_session::Following>& following) override;
  void setMesh(vtkPolyData* mesh) override;
  void setPixelRatio(double ratio) override;
  void setSteadiness(double pixels) override;
  void setPressure(double pressure) override;
  void frameBegins() override { this->Section.frameBegins(); }
  void framePainted() override { this->Section.framePainted(); }
  void showLines(bool show) override;

private:
  void heard(unsigned long event);
  void strokeEnds();
  void followHand();
  void letGo();
  vtkOversketchStrokeWidget* pen() const;

  std::string System, Input; // the stroke's
  Viewport* View;
  const Document* OpenDocument;
  QComboBox* Mirror = nullptr;
  vtkNew<vtkOversketchHeldStrokeWidget> Widget; // shows and moves strokes; the document runs them
  vtkNew<vtkCallbackCommand> Observer;
  PenSection Section;
  std::shared_ptr<const oversketch_session::Following> Followed;
  std::unique_ptr<Preview> MovePreview; // while a stroke is moved
  double Ratio = 1.0, Steadiness = 6.0;
};

} // namespace oversketch_studio
#endif
