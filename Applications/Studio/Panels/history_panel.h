// The list of steps, of any kind, with what each does and how it acts.
#ifndef oversketch_applications_studio_panels_history_panel_h
#define oversketch_applications_studio_panels_history_panel_h

#include "step.h"
#include "thumbnail.h"

#include <QWidget>

#include <functional>
#include <map>
#include <memory>

class QAction;
class QLabel;
class QListWidgetItem;

namespace oversketch_studio
{

class Document;
class StepList;
class StepPanel;

class HistoryPanel : public QWidget
{
  Q_OBJECT

public:
  HistoryPanel(Document* document, QWidget* parent = nullptr);

  // The selected step, or -1; of a drawing the line of it that is selected, or -1.
  int current() const;
  int currentLine() const;
  // Selects a step; -1: none.
  void selectStep(int node) { this->select(node, -1); }
  // Shows the form of a system while no step is selected.
  void turnTo(const std::string& system);
  // The actions on it, for a menu; the first ones have buttons under the list, too.
  QList<QAction*> strokeActions() const
  {
    return this->buttonActions() + QList<QAction*>{ this->Next, this->Less, this->More } + this->rowActions();
  }
  // Takes the selected step away, where the focus is on a widget that has it.
  QAction* removal() const { return this->Remove; }

  // Brings it up to what the document is.
  void refresh();

signals:
  void selected(int node);
  // The step is to be drawn anew.
  void redrawAsked(int node);
  // A line of a drawing is.
  void lineAsked(int node, int line);
  // The camera is to go where the step was drawn.
  void viewAsked(int node);
  // A form that had the keys can have them no more.
  void keysLeft();
  // Something cannot be done: why.
  void told(const QString& why);

private:
  void makeActions();
  QList<QAction*> buttonActions() const
  {
    return { this->Redraw, this->View, this->Up, this->Down, this->Remove };
  }
  QList<QAction*> rowActions() const
  {
    return { this->Rename, this->Toggle, this->Again, this->ShowTo, this->ShowAll };
  }
  void listenToList();
  // Whether a step may be put at another place; says why not.
  bool mayMove(int from, int to);
  void move(int from, int to);
  void moveLine(int node, int from, int to);
  void showMenu(const QPoint& at);
  void showPicture(int node);
  void tell(QListWidgetItem* item, int node);
  void addStep(int node);
  void addLines(int node);
  void select(int node, int line);
  void remove();
  void setOn(int node, int line, bool on);
  void showStep();
  // The id of a step by its place; -1 of none.
  int idOf(int node) const;
  // Values of a step, or of its line where that is not -1.
  void setParameters(int id, int line, const oversketch_session::Values& values, int mirror);
  // The step that keys change: the selected one, else the last; -1 where there is none.
  int changed() const;
  // Gives a parameter of it another value, made of the one that it has.
  void change(const char* property,
    const std::function<oversketch_session::Value(const oversketch_session::Value&)>& to);
  void itemChanged(QListWidgetItem* item);

  Document* OpenDocument;
  StepList* List;
  QLabel* Empty; // says what will be listed
  StepPanel* Form;
  int FormId = -1, FormLine = -1; // of the step that the form shows; of its line
  QAction *Redraw, *View, *Up, *Down, *Next, *Less, *More, *Remove, *Rename, *Toggle, *Again, *ShowTo,
    *ShowAll;
  bool Filling = false;
  std::map<int, std::shared_ptr<const oversketch_session::Thumbnail>> Pictures; // by the steps' ids
};

} // namespace oversketch_studio
#endif
