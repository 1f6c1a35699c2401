// The list of what is in the scene: the models, the parts of the one that is worked on, and the pictures
// behind them; each is seen or not, a model is locked or not.
#ifndef oversketch_applications_studio_panels_scene_panel_h
#define oversketch_applications_studio_panels_scene_panel_h

#include "session.h"

#include <QWidget>

#include <functional>
#include <set>
#include <vector>

class QAction;
class QListWidget;
class QSlider;
class QToolButton;

namespace oversketch_studio
{

class Document;

class ScenePanel : public QWidget
{
  Q_OBJECT

public:
  ScenePanel(Document* document, QWidget* parent = nullptr);

  // Writes the selected part or model, for a menu; adds to the scene.
  QAction* exporting() const { return this->Export; }
  QAction* modelAdding() const { return this->AddModel; }
  QAction* pictureAdding() const { return this->AddPicture; }

  // Brings it up to what the document is.
  void refresh();

signals:
  void modelAsked();
  void joinAsked(const oversketch_session::Step& step); // of the parts of the chosen model
  void addAsked();                                      // a picture
  // The camera is to go where the picture is seen.
  void viewAsked(int picture);
  // These parts of the chosen model are hidden (ModelView::hide).
  void partsHidden(const std::set<int>& parts);
  // A part of a model is to be written by itself; -1: all of it.
  void exportAsked(int model, int part, const QString& name);

private:
  // The thing that a row is of: a model, one of its parts, or a picture; -1 where it is none of that kind.
  struct Row
  {
    int model = -1, part = -1, picture = -1;
  };

  void makeActions();
  void listenToList();
  Row rowAt(int at) const;
  // The selected picture, or -1.
  int current() const;
  oversketch_session::Picture pictureAt(const Row& row) const;
  void list();
  void findParts();
  std::set<int> hiddenParts() const; // of these
  void hideParts();
  void addRow(const Row& row, const QString& text, const QString& help, bool shown);
  QStringList partNames() const;
  void choose(int at);
  void setShown(int at, bool shown);
  // Another way in which a model or a picture is in the scene.
  void change(const Row& row, const std::function<void(bool& shown, bool& locked)>& how);
  void lock(bool locked);
  void remove();
  void exportRow();
  void showMenu(const QPoint& at);
  void showSelected();

  Document* OpenDocument;
  QListWidget* List;
  QSlider* Opacity;
  QToolButton *Add, *View, *Lock, *Remove, *Join;
  QAction *Export, *AddModel, *AddPicture;
  std::vector<Row> Rows;
  std::vector<int> Parts; // of the chosen model, where it has several
  std::set<int> Told;     // with partsHidden
  int PartsOf = 0;        // the model's id
  int Ticked = -1;        // the row whose tick the mouse has just changed
  bool Filling = false;
};

} // namespace oversketch_studio
#endif
