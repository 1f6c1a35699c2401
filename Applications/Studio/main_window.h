// The window of oversketch-studio.
#ifndef oversketch_studio_main_window_h
#define oversketch_studio_main_window_h

#include "preferences.h"

#include <QMainWindow>

#include <functional>

class QAction;
class QComboBox;
class QDockWidget;
class QFrame;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QTimer;
class vtkPolyData;

namespace oversketch_studio
{

class Document;
class HistoryPanel;
class View;

class MainWindow : public QMainWindow
{
  Q_OBJECT

public:
  // Throws Failed where autosaves cannot be kept.
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  // Opens a mesh or a session, or says in a box why it cannot. Returns whether it did.
  bool open(const QString& path);
  // Offers what a crash left behind; true when it was opened.
  bool offerRecovery();
  // Opens the model that is shipped, with a line that says where to draw.
  void openShippedModel();

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  // Menus, tool bar, status bar: main_window_menus.cxx.
  void makeMenus();
  void makeTools();
  void makeStatus();
  QAction* add(QMenu* menu, const QString& text, const QKeySequence& keys, const std::function<void()>& run);
  void remember(const QString& path);
  void fillRecent();

  // Runs what may throw Failed and says why in a box. Returns whether it went well.
  bool tried(const std::function<void()>& run);
  void tell(const QStringList& notes);

  void openAsked();
  bool save();
  bool saveAs();
  void exportAsked();
  void screenshot();
  // Whether what is not saved may be left.
  bool mayLeave();
  void strokeDrawn(vtkPolyData* stroke);
  void strokeChanged(vtkPolyData* stroke);
  void setDrawing(bool drawing);
  void askPreferences();
  void apply(const Preferences& preferences);
  void refresh();
  void advise();
  void select(int node);
  void showSection(int node); // where the stroke took hold
  // The stroke that can be taken hold of: the selected one, else the last.
  void offerStroke();
  void showResult();
  void showDetails();

  Document* document_;
  View* view_;
  QFrame* frame_; // about the view, in the colour of the focus while keys go there
  HistoryPanel* history_;
  QDockWidget* dock_;
  QLabel* advice_;
  QLabel* mode_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QTimer* patience_; // progress is shown for what takes longer than a moment
  QMenu* recent_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr, *save_ = nullptr, *draw_ = nullptr, *turn_ = nullptr,
          *dark_ = nullptr, *region_ = nullptr;
  QComboBox* mirror_ = nullptr;
  Preferences preferences_;
  int redrawn_ = -1; // the stroke that the next one replaces
  int offered_ = -1; // the one that can be taken hold of in the view
  bool reset_ = false;
  bool drawn_ = false; // the change that is on its way is a stroke just drawn
};

} // namespace oversketch_studio
#endif
