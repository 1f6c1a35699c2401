// A use of the left button in the viewport: one tool a system, and one that turns the model. To add one: a
// file here and a row in tools.cxx.
#ifndef oversketch_applications_studio_tools_tool_h
#define oversketch_applications_studio_tools_tool_h

#include "hint.h"
#include "message_text.h"
#include "session.h"
#include "worker.h"

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QPainterPath>
#include <QPair>
#include <QString>
#include <QVector>

#include <memory>
#include <string>

class QAction;
class QWidget;

namespace oversketch_studio
{

class Tool : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  // Its name, with its letter for menus; its key; what it does, in a sentence; its picture in lines, in a
  // square of 24.
  virtual QString title() const = 0;
  virtual QKeySequence key() const = 0;
  virtual QString help() const = 0;
  virtual QPainterPath icon() const = 0;
  QString name() const { return this->title().remove('&'); }
  // Tells what mouse and keys do with it: pairs of keys and words, for the list of keys.
  virtual QVector<QPair<QString, QString>> keys() const = 0;
  // Tells what the pressure of a pen does with it.
  virtual QString pressure() const { return tr("makes no difference to this tool"); }
  // The text that a person new to it reads on the shipped model.
  virtual QString hint() const { return {}; }
  virtual HintShape hintShape() const { return HintShape::Limb; }
  // Says what to do next.
  struct Situation
  {
    bool empty = true;     // no step has been taken
    bool selected = false; // a step is
    bool holds = false;    // a red line can be dragged
    bool redraws = false;  // what is drawn next replaces the selected step's
  };
  virtual QString advice(const Situation& situation) const = 0;
  // Says what can be done about a step of its system of which something is to be said.
  virtual QString remedy() const { return tr("Ctrl+Z undoes."); }
  // Words for what a step of its system has to say.
  virtual QString words(const oversketch::Message& message) const { return briefWords(message); }
  // A stage of its system's, in words.
  virtual QString stage(const QString& name) const { return name; }

  // Whose steps it makes (SystemRow::name); empty: none.
  virtual std::string system() const { return {}; }
  // The step of the history that it changes by itself; -1: none. One is selected, -1: none.
  virtual int node() const { return -1; }
  virtual void select(int) {}
  // A line of that step is, -1: none.
  virtual void selectLine(int) {}
  // The options that new steps are made with, for the bar above the viewport; null where there is nothing to
  // choose.
  virtual QWidget* makeOptions(QWidget*) { return nullptr; }
  // The options as values by names, to be kept as a set; none where there is nothing to choose. Lengths do
  // not depend on the model that is open.
  virtual oversketch_session::Values options() const { return {}; }
  virtual void setOptions(const oversketch_session::Values&) {}
  // Other things that can be done with it while it is in the hand, for a menu.
  virtual QList<QAction*> actions() const { return {}; }
  // A second view of what it makes, for a panel beside the viewport; null: none.
  virtual QWidget* makePanel(QWidget*) { return nullptr; }

  // It is taken up, and put down.
  virtual void start() = 0;
  virtual void stop() = 0;
  // Whether the hand draws at this moment; whether it holds something that follows it.
  virtual bool draws() const { return false; }
  virtual bool moves() const { return false; }
  bool isBusy() const { return this->draws() || this->moves(); }
  // Whether a click beside its lines, and Escape, leave the selected row also where that is one of its steps.
  virtual bool leavesRows() const { return this->system().empty(); }

  // A step of its system that can be taken hold of, with what is known of it, and a place on the model; no
  // step any more; how the mesh follows it, where that is known only later.
  virtual void offer(const oversketch_session::Step&,
    const oversketch_session::Worker::NodeState&,
    const oversketch_session::Point&)
  {
  }
  virtual void offerNothing() {}
  virtual void setFollowing(const std::shared_ptr<const oversketch_session::Following>&) {}

  // Whether its advice also says why a step of its system did nothing.
  virtual bool judges() const { return false; }
  // The property of its step (node()) that is to be turned on; empty where none is.
  virtual std::string asked() const { return {}; }
  // A canvas that is drawn on in place of the model: a widget beside the viewport, seen while the tool is in
  // the hand; null: the model.
  virtual QWidget* makeCanvas(QWidget*) { return nullptr; }
  // The next line replaces one of the lines of its step; -1: none.
  virtual void redraw(int) {}

  // The mesh that is drawn over from here on, once it is on screen.
  virtual void setMesh(vtkPolyData*) {}
  // The screen's pixels a pixel as Qt counts them; how far the line trails behind the pen [px as Qt counts
  // them]; the pen's pressure, where it has one.
  virtual void setPixelRatio(double) {}
  virtual void setSteadiness(double) {}
  virtual void setPressure(double) {}
  // The wheel has been turned away from the hand, by so many notches, at a time [ms, the event's]. Returns
  // whether it was of use; then it is not the camera's.
  virtual bool wheel(double, Qt::KeyboardModifiers, ulong) { return false; }
  virtual void setDark(bool) {}
  // A frame begins; it has been painted.
  virtual void frameBegins() {}
  virtual void framePainted() {}
  // Whether its line is seen there [px of the screen from the lower left corner], and can be taken hold of.
  virtual bool holds(double, double) { return false; }
  // Whether a press there with Shift is its own: else it smooths the model.
  virtual bool takesShift(double x, double y) { return this->holds(x, y); }
  // Its lines, for a picture without them.
  virtual void showLines(bool) {}

signals:
  // The hand has made a step; it has changed the one that was offered.
  void drawn(const oversketch_session::Step& step);
  void changed(const oversketch_session::Step& step);
  // It has changed inputs and values of that one.
  void remade(const oversketch_session::Step& step);
  // The line that was drawn is no stroke: one is that long at least [px of the screen].
  void tooShort(double least);
  // It makes no step, for that reason.
  void refused(const QString& why);
  // The hand gives the step that was offered other values; `mergesIntoLast`: of one movement with the last
  // time.
  void shaped(const oversketch_session::Values& values, bool mergesIntoLast);
  // The hand has changed a step of the history, whatever is offered.
  void edited(int node, const oversketch_session::Step& step);
  // The hand puts a part of the model elsewhere; `mergesIntoLast`: of one movement with the last time. It
  // gives the movement up.
  void placed(int node, const oversketch_session::PartPlace& place, bool mergesIntoLast);
  void givenUp();
  // The canvas and the model change sides.
  void swapAsked();
  // The hand moves a step that the mesh cannot follow before it is let go; it lets go.
  void movesAlone();
  void left();
};

} // namespace oversketch_studio
#endif
