// The list of what is in the scene: the model with its parts, and the pictures behind it; each is seen or
// not.
#ifndef oversketch_studio_scene_panel_h
#define oversketch_studio_scene_panel_h

#include <QWidget>

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

  // Writes the selected part, or the model, for a menu.
  QAction* exporting() const { return this->Export; }

  // Brings it up to what the document is.
  void refresh();

signals:
  void addAsked();
  // The camera is to go where the picture is seen.
  void viewAsked(int picture);
  // These parts of the model are hidden (ModelView::hide).
  void partsHidden(const std::set<int>& parts);
  // A part of the model is to be written by itself; -1: all of it.
  void exportAsked(int part, const QString& name);

private:
  // The selected picture, or -1.
  int current() const;
  void listModel();
  QStringList partNames() const;
  void setPartShown(int row, bool shown);
  void exportPart();
  void showMenu(const QPoint& at);
  void showPicture();
  void setShown(int picture, bool shown);

  Document* OpenDocument;
  QListWidget* List;
  QSlider* Opacity;
  QToolButton *Add, *View, *Remove;
  QAction* Export;
  std::vector<int> Parts; // of the rows of the model: their numbers, or one -1
  std::set<int> Hidden;   // of the parts
  bool Filling = false;
};

} // namespace oversketch_studio
#endif
