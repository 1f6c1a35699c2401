// The list of strokes, with what each does and how it acts.
#ifndef oversketch_studio_history_panel_h
#define oversketch_studio_history_panel_h

#include <QWidget>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QListWidgetItem;

namespace oversketch_studio
{

class Document;

// A choice of mirror planes: none, x, y, z. Its index is what Document::mirrorPlane takes.
QComboBox* mirrorChoice(QWidget* parent);

class HistoryPanel : public QWidget
{
  Q_OBJECT

public:
  HistoryPanel(Document* document, QWidget* parent = nullptr);

  // The selected stroke, or -1.
  int current() const;
  // What can be done with it, for a menu.
  QList<QAction*> strokeActions() const
  {
    return { this->redraw_, this->view_, this->up_, this->down_, this->remove_ };
  }

signals:
  void selected(int node);
  // The stroke is to be drawn anew.
  void redrawAsked(int node);
  // The camera is to go where the stroke was drawn.
  void viewAsked(int node);

private:
  void refresh();
  void showParameters();
  void edit();
  void itemChanged(QListWidgetItem* item);

  Document* document_;
  QListWidget* list_;
  QLabel* empty_; // says what will be listed
  QComboBox* remesh_;
  QCheckBox *adjustNormals_, *asPublished_;
  QComboBox* mirror_;
  QAction *redraw_, *view_, *up_, *down_, *remove_;
  bool filling_ = false;
};

} // namespace oversketch_studio
#endif
