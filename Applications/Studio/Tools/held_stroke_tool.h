// A tool of a system that is given one stroke: it is drawn with the pen, stays, and can be taken hold of.
#ifndef oversketch_applications_studio_tools_held_stroke_tool_h
#define oversketch_applications_studio_tools_held_stroke_tool_h

#include "pen_section.h"
#include "preview.h"
#include "tool.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <optional>

class QComboBox;
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
  // Draws for a system of the list. `look` is how it is asked what is to be seen under the pen, on a thread
  // of its own.
  HeldStrokeTool(const std::string& system,
    Viewport* viewport,
    const Document* document,
    oversketch_session::SectionFinder::Look look = {});
  ~HeldStrokeTool() override;

  QVector<QPair<QString, QString>> keys() const override;
  std::string system() const override { return this->System; }
  // Those of setBar, and Mirror, where the system's steps can have one.
  QWidget* makeOptions(QWidget* parent) override;
  oversketch_session::Values options() const override;
  void setOptions(const oversketch_session::Values& options) override;
  void start() override;
  void stop() override;
  bool draws() const override;
  bool moves() const override;
  bool leavesRows() const override { return true; }
  void offer(const oversketch_session::Step& step,
    const oversketch_session::Worker::NodeState& state,
    const oversketch_session::Point& place) override;
  void offerNothing() override;
  void setFollowing(const std::shared_ptr<const oversketch_session::Following>& following) override
  {
    this->Followed = following;
  }
  void setMesh(vtkPolyData* mesh) override { this->Section.setMesh(mesh); }
  void setPixelRatio(double ratio) override;
  void setSteadiness(double pixels) override;
  void setPressure(double pressure) override;
  void frameBegins() override { this->Section.frameBegins(); }
  void framePainted() override { this->Section.framePainted(); }
  bool holds(double x, double y) override;
  void showLines(bool show) override;

protected:
  // Sets what new steps are made with beside their stroke, also the one whose stroke is being drawn.
  void setValues(const oversketch_session::Values& values);
  // The same, and gives them to the step that is offered, but while a line is drawn, whose alone they are
  // then.
  void shape(const oversketch_session::Values& values, bool mergesIntoLast);
  // Whether shape() would change that one.
  bool shapesOffered() const { return this->Offered && !this->draws(); }
  // The mesh that the step that is offered was drawn on, where it can be told from what is shown: then what
  // the stroke would make is looked for there while it is moved.
  virtual vtkSmartPointer<vtkPolyData> meshBefore() const { return nullptr; }
  // Says whether the red line can be taken hold of and moved.
  virtual bool grabs() const { return true; }
  // Tells of a line that the hand has begun whether it is for the step that is offered, and begins none. Such
  // a line has grown; it is whole; it has ended, whole or dropped.
  virtual bool takesLine(vtkPolyData*) { return false; }
  virtual void lineGrows(vtkPolyData*) {}
  virtual void lineWhole(vtkPolyData*) {}
  virtual void lineEnds() {}
  // Gives it options of its own, a widget with a layout that is hidden until the window has a place for it.
  void setBar(QWidget* bar);
  // Has options begin with each model: one that is opened, or the first one that a step makes. `begin` gets
  // the diagonal of its box, 0 where there is none yet.
  void beginWithModels(const std::function<void(double diagonal)>& begin);
  Viewport* viewport() const { return this->View; }
  const Document* document() const { return this->OpenDocument; }

private:
  std::optional<oversketch_session::MirrorPlane> mirrorPlane() const;
  void begins();
  void handMoves();
  void strokeEnds();
  void followHand();
  void letGo();
  vtkOversketchStrokeWidget* pen() const;

  std::string System, Input; // the stroke's
  Viewport* View;
  const Document* OpenDocument;
  QWidget* Bar = nullptr; // null: none
  QComboBox* Mirror = nullptr;
  bool Sized = false;                           // options are those of a model
  vtkNew<vtkOversketchHeldStrokeWidget> Widget; // shows and moves strokes; the document runs them
  PenSection Section;
  oversketch_session::Values StrokeValues;
  std::optional<oversketch_session::Values> Offered; // of the step that is
  std::shared_ptr<const oversketch_session::Following> Followed;
  std::unique_ptr<Preview> MovePreview; // while a stroke is moved
  bool LooksBefore = false;             // the same, over meshBefore()
  std::optional<bool> TakesLine;        // while one is drawn, once that is known: takesLine
  double Ratio = 1.0, Steadiness = 6.0;
};

} // namespace oversketch_studio
#endif
