// The window of oversketch-studio.
#ifndef oversketch_applications_studio_window_main_window_h
#define oversketch_applications_studio_window_main_window_h

#include "document.h"
#include "large_models.h"
#include "preferences.h"

#include <QMainWindow>
#include <QVector>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

class QAction;
class QDockWidget;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QSplitter;
class QStackedWidget;
class QTimer;
class QToolBar;

namespace oversketch_studio
{

class AdviceLabel;
struct Example;
class HistoryPanel;
struct Lesson;
class LessonPlayer;
class OptionPresets;
class ScenePanel;
class StrokeLines;
class Tool;
class ViewMenu;
class Viewport;

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
  // Begins a drawing over a picture, or says why it cannot; on an empty canvas where there is none. Returns
  // whether it did.
  bool openPicture(const QString& path);
  // Opens the model that is shipped, with a line that says where to draw.
  void openShippedModel();

protected:
  void closeEvent(QCloseEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  // Menus, strip of tools, bar of options, status bar: main_window_menus.cxx.
  void makeMenus();
  void makeToolMenu();
  void makeViewMenu();
  void makeTools();
  void drawToolIcons();
  void makeStatus();
  QAction* add(QMenu* menu, const QString& text, const QKeySequence& keys, const std::function<void()>& run);
  QDockWidget* addDock(const QString& title, const QString& name, QWidget* panel);
  void remember(const QString& path);
  void fillRecent();
  void fillExamples();
  void placeForHand(bool left);

  // Files: main_window_files.cxx. tried runs what may throw Failed and says why in a box; returns whether it
  // went well.
  bool tried(const std::function<void()>& run);
  // Whether a long work may begin; says which one it has to wait for.
  bool mayBegin();
  void tell(const QStringList& notes);
  // Does a work on a thread of its own, while the window says what goes on, and `then` after it here. Returns
  // whether both went well, and says why not in a box, where they were not given up.
  bool runAside(const QString& what, const std::function<void()>& work, const std::function<void()>& then);
  // Reads aside, and gives `then` what was read. The thread may outlive the window.
  template <typename Read, typename Then>
  bool readAside(const QString& name, const Read& read, const Then& then)
  {
    const auto made = std::make_shared<std::optional<decltype(read())>>();
    return this->runAside(
      tr("Reading %1…").arg(name),
      [made, read] { *made = read(); },
      [&made, &then] { then(std::move(**made)); });
  }
  // Begins a drawing over a picture, or on an empty canvas where there is none.
  bool beginDrawing(const QString& picture);
  // Shows what is read, instead of what is there.
  bool openRead(const QString& name, const std::function<Document::Opened()>& read);
  bool openFile(const QString& path);
  bool openExample(const Example& example);
  bool recover(const oversketch_session::LeftBehind& left, const QString& name);
  bool saveTo(const QString& path);
  void openAsked();
  QString modelAsked(const QString& title); // a path; empty for none
  void takeWhatIsTyped();
  bool save();
  bool saveAs();
  void exportAsked();
  void exportModel(int model, int part, const QString& name);
  // As one mesh; of it that part, or -1 all.
  void exportMeshes(const ExactResults& results, int part, const QString& name);
  // Writes what `make` makes on a thread of its own, if it does, and then says so, with the file's name.
  void writeAside(const QString& path,
    const QString& said,
    const std::function<vtkSmartPointer<vtkPolyData>()>& make);
  void printAsked();
  void writePrint(const vtkSmartPointer<vtkPolyData>& mesh);
  void screenshot(bool lines);
  void turntableAsked();
  // Whether what is not saved may be left.
  bool mayLeave();

  // Pictures: main_window_pictures.cxx.
  QString pictureAsked(const QString& title);
  void newFromPictureAsked();
  void addPartAsked();
  int drawingMeant() const; // the one that was selected last, else the first one; -1: none
  void addBackAsked();
  void setBack(const oversketch_session::Image* image); // of that one; null takes it away
  void addPicture(const QString& path);
  void addPictureAsked();

  // Models of the scene: main_window_models.cxx.
  void listenToModels();
  void addModelAsked();
  void addModel(const QString& path);
  // Chooses the one beside that is seen there [px of the view]; false where none is.
  bool chooseModelAt(const QPoint& place);

  // Rows of the history and their lines on the model: main_window_rows.cxx.
  void listenToRows();
  void clicked(const QPoint& place, int line);
  bool leavesRows() const; // whether the tool in the hand lets a click and Escape leave the selected row
  void chooseLine();
  void tooShort(double least);
  void refuseLine(const QString& why);

  // The foot: main_window_advice.cxx.
  void advise();
  void hearRows();
  void hush();
  bool speak();
  void offerAnyway(int row, const std::string& property);
  void teach();
  void stopTeaching();
  void playLesson(const Lesson& lesson);

  void listenToDocument();
  void listenToPanels();
  void listenToTool(Tool* tool);
  void changed(Document::Change change);
  void stepDrawn(const oversketch_session::Step& step);
  void stepChanged(const oversketch_session::Step& step);
  void stepRemade(const oversketch_session::Step& step);
  void opened();
  void stepShaped(const oversketch_session::Values& values, bool mergesIntoLast);
  void setTool(Tool* tool);
  void selectDrawing(const Tool* tool);
  // The one that draws steps of a node's system, the one in the hand before others; null where none does.
  Tool* toolOf(int node) const;
  void lookFrom(int node);
  void askPreferences();
  void apply(const Preferences& preferences);
  void refresh();
  void select(int node);
  void showSection(int node); // where the step took hold
  // The step that can be taken hold of: the selected one, else the last.
  void offerStep();
  int nodeMeant() const; // that one; -1: none
  void offerNothing();
  bool isNothingDrawn() const;
  void showResult();
  void showDetails();

  Document* OpenDocument;
  LargeModels* Large;
  Viewport* View;
  QVector<Tool*> Tools;
  QVector<QAction*> ToolActions;   // of the same order
  QVector<QDockWidget*> ToolDocks; // of the same order; null where a tool has no panel
  QSplitter* Sides;                // the view, and what tools draw on that is not the model
  QVector<QWidget*> Canvases;      // of the tools' order; null where a tool draws on the model
  ScenePanel* Scene;
  HistoryPanel* History;
  ViewMenu* Look;
  StrokeLines* Lines;
  QToolBar* Strip = nullptr;
  QStackedWidget* Options = nullptr; // of the tools, in their order
  AdviceLabel* Advice;
  LessonPlayer* Teacher;
  QPushButton* Anyway; // does what a message asks for
  QLabel* Mode;
  QProgressBar* Progress;
  QPushButton* Cancel;
  QTimer* BusyTimer; // progress is shown for what takes longer than a moment
  QMenu *Recent = nullptr, *Examples = nullptr;
  OptionPresets* Presets = nullptr;
  QAction *Undo = nullptr, *Redo = nullptr, *Save = nullptr, *Export = nullptr, *Print = nullptr,
          *Turntable = nullptr, *Dark = nullptr, *Region = nullptr, *Back = nullptr, *NoBack = nullptr;
  QVector<QAction*> DockActions;
  Preferences Settings;
  int Redrawn = -1;                        // the step that the next one replaces
  int Offered = -1;                        // the one that can be taken hold of in the view
  int Speaks = -1;                         // the row whose words are at the foot; -1: none
  std::map<int, oversketch::Message> Said; // by the rows' ids: what the last result had to say of each
  std::function<void()> OnAnyway;
  bool FrameOnNextMesh = false;
  bool AcceptsSteps = true; // the chosen model, steps
  bool ShowsHints = false;  // hints, until a step has been drawn or the model turned
};

} // namespace oversketch_studio
#endif
