// The window without a mouse, in another language, and as its user likes it.
#include "document.h"
#include "history_panel.h"
#include "language.h"
#include "main_window.h"
#include "message_text.h"
#include "mouse.h"
#include "options_stack.h"
#include "preferences.h"
#include "tool.h"
#include "viewport.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVersion.h"

#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <QTranslator>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <vector>

using namespace oversketch_studio;

namespace
{

// A window on the shipped model, with one stroke in its history, which is selected.
struct ReachScene
{
  explicit ReachScene(bool stroke)
  {
    this->window.resize(1000, 700); // the processor draws it in less time
    this->window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&this->window, 60000));
    QApplication::setActiveWindow(&this->window);
    this->window.openShippedModel();
    this->view = this->window.findChild<Viewport*>();
    this->document = this->window.findChild<Document*>();
    EXPECT_TRUE(this->document->isOpen());
    this->wait();
    if (stroke)
    {
      this->draw(0.0);
      this->window.findChild<QListWidget*>("history")->setCurrentRow(0);
    }
  }
  ~ReachScene() { this->document->discardAutosave(); }

  void wait()
  {
    EXPECT_TRUE(QTest::qWaitFor([this] { return this->document->isSettled(); }, 600000));
  }
  // A line across the view that trembles by so much.
  void draw(double tremble)
  {
    const int width = this->view->width(), y = this->view->height() / 3;
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, { width / 4, y });
    for (int x = width / 4; x < 3 * width / 4; x += 12)
    {
      const int up = static_cast<int>(std::lround(tremble * std::sin(x)));
      moveMouse(this->view, { x, y + up });
      QApplication::processEvents();
    }
    QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, { 3 * width / 4, y });
    this->wait();
  }

  MainWindow window;
  Viewport* view = nullptr;
  Document* document = nullptr;
};

// Entries of a menu and of those in it.
void collect(const QMenu* menu, std::set<const QAction*>& found)
{
  std::set<QString> letters;
  for (const QAction* action : menu->actions())
  {
    if (action->isSeparator())
    {
      continue;
    }
    found.insert(action);
    const int at = action->text().indexOf('&');
    EXPECT_GE(at, 0) << "no underlined letter: " << qPrintable(action->text());
    EXPECT_TRUE(letters.insert(action->text().mid(at + 1, 1).toLower()).second)
      << "the same letter twice in " << qPrintable(menu->title()) << ": " << qPrintable(action->text());
    if (action->menu())
    {
      collect(action->menu(), found);
    }
  }
}

// Marks what was asked of it, by us and by Qt.
class Marker : public QTranslator
{
public:
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* source, const char*, int) const override
  {
    return QString::fromUtf8("¡") + QString::fromUtf8(source);
  }
};

int unmarked(const QWidget* root)
{
  int marked = 0;
  for (const QString& text : textsOf(*root))
  {
    if (!text.isEmpty())
    {
      EXPECT_TRUE(text.contains(QString::fromUtf8("¡"))) << "not translated: " << qPrintable(text);
      ++marked;
    }
  }
  return marked;
}

} // namespace

TEST(Reach, EveryActionIsInAMenuWithALetter)
{
  ReachScene scene(false);
  std::set<const QAction*> reached;
  std::set<QString> letters;
  for (const QAction* top : scene.window.menuBar()->actions())
  {
    const int at = top->text().indexOf('&');
    EXPECT_GE(at, 0) << qPrintable(top->text());
    EXPECT_TRUE(letters.insert(top->text().mid(at + 1, 1).toLower()).second) << qPrintable(top->text());
    reached.insert(top);
    collect(top->menu(), reached);
  }
  EXPECT_GE(reached.size(), 20u);
  std::set<QString> keys;
  for (const QAction* action : scene.window.findChildren<QAction*>())
  {
    if (!action->isSeparator() && action->isEnabled() && action->isVisible() && !action->text().isEmpty())
    {
      EXPECT_TRUE(reached.count(action)) << "in no menu: " << qPrintable(action->text());
    }
    for (const QKeySequence& sequence : action->shortcuts())
    {
      EXPECT_TRUE(keys.insert(sequence.toString()).second) << "twice: " << qPrintable(sequence.toString());
    }
  }
}

TEST(Reach, TabGoesThroughEverythingAndShowsWhereItIs)
{
  ReachScene scene(true);
  scene.view->setFocus();
  std::set<QWidget*> visited;
  QWidget* at = scene.view;
  for (int i = 0; i < 40 && visited.insert(at).second; ++i)
  {
    const QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(at);
    ASSERT_TRUE(spoken);
    EXPECT_FALSE(spoken->text(QAccessible::Name).isEmpty()) << at->metaObject()->className();
    QTest::keyClick(at, Qt::Key_Tab);
    QWidget* next = QApplication::focusWidget();
    ASSERT_TRUE(next);
    // Where the keys go is seen: on the widget itself, or on the frame about the view.
    const auto seen = [](QWidget* widget)
    {
      QWidget* shown = qobject_cast<Viewport*>(widget) ? widget->parentWidget() : widget;
      return shown->grab().toImage();
    };
    if (next != at)
    {
      const QImage with = seen(next);
      at->setFocus();
      EXPECT_NE(with, seen(next)) << next->metaObject()->className() << ' '
                                  << qPrintable(next->accessibleName());
      next->setFocus();
    }
    at = next;
  }
  EXPECT_EQ(at, scene.view) << "Tab comes round";
  for (QWidget* widget : scene.window.findChildren<QWidget*>())
  {
    const bool isPartOfANumber = qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) != nullptr;
    if (widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) &&
        !isPartOfANumber)
    {
      EXPECT_TRUE(visited.count(widget))
        << widget->metaObject()->className() << ' ' << qPrintable(widget->accessibleName());
    }
  }
  EXPECT_GE(visited.size(), 10u);
}

// Each key of the list moves the camera, or is the window's own; and each that moves it is in the list.
TEST(Reach, TheListOfKeysIsTrue)
{
  ReachScene scene(false);
  QTest::keyClick(scene.view, Qt::Key_T);
  QString listed;
  for (const QString& line : QString::fromUtf8(scene.view->camera()->GetKeyList()).split('\n'))
  {
    for (const QString& word : line.left(13).split(' ', Qt::SkipEmptyParts))
    {
      listed += word.size() == 1 && word != "+" ? word : QString();
    }
  }
  vtkCamera* camera = scene.view->renderWindow()->GetRenderers()->GetFirstRenderer()->GetActiveCamera();
  QString moves;
  for (const char* key = "abcdefghijklmnoprstuvwxyz0123456789"; *key; ++key)
  {
    // From a view that no key leads to.
    camera->SetPosition(1.0, 2.0, 5.0);
    camera->SetFocalPoint(0.1, 0.2, 0.3);
    camera->SetViewUp(0.1, 1.0, 0.2);
    const auto seen = [camera]
    {
      std::vector<double> values{ camera->GetViewAngle(), camera->GetParallelScale() };
      for (const double* at : { camera->GetPosition(), camera->GetFocalPoint(), camera->GetViewUp() })
      {
        values.insert(values.end(), at, at + 3);
      }
      return values;
    };
    const std::vector<double> before = seen();
    QTest::keyClick(scene.view, *key);
    moves += seen() != before ? QString(*key) : QString();
  }
  QTest::keyClick(scene.view, Qt::Key_5); // as it was, for the next window
  for (const QChar key : moves)
  {
    EXPECT_TRUE(listed.contains(key)) << "not in the list: " << key.toLatin1();
  }
  EXPECT_GE(moves.size(), 16);
  for (const QChar key : listed)
  {
    EXPECT_TRUE(moves.contains(key) || QString("abdefgqstou4678?[]").contains(key))
      << "does nothing: " << key.toLatin1();
  }
}

TEST(Reach, AStrokeIsChangedWithKeysAlone)
{
  ReachScene scene(true);
  const std::string before = scene.document->digest();
  auto* list = scene.window.findChild<QListWidget*>("history");
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Space); // off
  ASSERT_TRUE(QTest::qWaitFor([&] { return !scene.document->session().nodes[0].on; }, 600000));
  scene.wait();
  EXPECT_NE(scene.document->digest(), before);
  QTest::keyClick(&scene.window, Qt::Key_Z, Qt::ControlModifier);
  scene.wait();
  EXPECT_TRUE(scene.document->session().nodes[0].on);
  EXPECT_EQ(scene.document->digest(), before);
  list->setCurrentRow(0);
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Delete);
  scene.wait();
  EXPECT_TRUE(scene.document->session().nodes.empty());
}

// Another place that fits, and more or less of the body, for the selected stroke or the last one; what is not
// as drawn is marked in its row.
TEST(Reach, TheNextPlaceAndTheReachAreAKeyAway)
{
  using oversketch_session::Value;
  ReachScene scene(true);
  auto* list = scene.window.findChild<QListWidget*>("history");
  const auto valueOf = [&](const char* property)
  {
    const auto& values = scene.document->session().nodes[0].step->values;
    const auto it = values.find(property);
    return it == values.end() ? Value() : it->second;
  };
  const auto press = [&](Qt::Key key, Qt::KeyboardModifier with = Qt::NoModifier)
  {
    QTest::keyClick(&scene.window, key, with);
    scene.wait();
    const auto& state = scene.document->result().nodes[0];
    const bool isMarked = !state.failure.empty() || !state.remark.empty();
    EXPECT_EQ(list->item(0)->icon().isNull(), !isMarked && !state.elsewhere);
    EXPECT_TRUE(
      list->item(0)->toolTip().contains(plainWords(state.failure.empty() ? state.remark : state.failure)));
  };
  list->setCurrentRow(-1); // the last stroke is meant
  scene.view->setFocus();
  const std::string first = scene.document->digest();
  press(Qt::Key_BracketRight);
  EXPECT_EQ(valueOf("Reach"), Value(0.05));
  EXPECT_NE(scene.document->digest(), first);
  press(Qt::Key_BracketLeft);
  EXPECT_EQ(valueOf("Reach"), Value(0.0));
  EXPECT_EQ(scene.document->digest(), first);
  press(Qt::Key_BracketLeft);
  EXPECT_EQ(valueOf("Reach"), Value(-0.05));
  press(Qt::Key_BracketRight);
  // Through all that fit, and from beyond the last one back to the first.
  int places = 1;
  do
  {
    press(Qt::Key_F3);
    ASSERT_LE(++places, 30);
    EXPECT_EQ(valueOf("Candidate"), Value(places));
  } while (scene.document->result().nodes[0].failure.text().find("no number") == std::string::npos);
  press(Qt::Key_F3);
  EXPECT_EQ(valueOf("Candidate"), Value(1));
  EXPECT_EQ(scene.document->digest(), first);
}

TEST(Reach, AboutNamesTheVersions)
{
  ReachScene scene(false);
  const auto actions = scene.window.findChildren<QAction*>();
  const auto about = std::find_if(
    actions.begin(), actions.end(), [](const QAction* action) { return action->text().contains("About"); });
  ASSERT_NE(about, actions.end());
  QCoreApplication::setApplicationVersion("12.34");
  QString told;
  QTimer::singleShot(0,
    [&told]
    {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_TRUE(box);
      told = box->text();
      box->reject();
    });
  (*about)->trigger();
  for (const char* what : { "12.34", vtkVersion::GetVTKVersion(), qVersion(), "BSD-3-Clause" })
  {
    EXPECT_TRUE(told.contains(what)) << what << " is not in: " << qPrintable(told);
  }
}

TEST(Texts, EverythingThatIsSeenIsTranslated)
{
  Marker marker;
  QCoreApplication::installTranslator(&marker);
  {
    ReachScene scene(true);
    EXPECT_GE(unmarked(&scene.window), 60);
    for (Tool* tool : scene.view->findChildren<Tool*>())
    {
      scene.view->setTool(tool);
      const QStringList lines = QString::fromUtf8(scene.view->camera()->GetKeyList()).split('\n');
      EXPECT_GE(lines.size(), 15);
      for (const QString& line : lines)
      {
        const bool goesOn = line.startsWith(QString(13, ' '));
        EXPECT_TRUE(line.isEmpty() || goesOn || line.contains(QString::fromUtf8("¡"))) << qPrintable(line);
      }
      EXPECT_TRUE(lines[0].endsWith(tool->name())) << qPrintable(lines[0]);
    }
    const PreferencesDialog dialog(Preferences::read());
    EXPECT_GE(unmarked(&dialog), 10);
  }
  QCoreApplication::removeTranslator(&marker);
}

TEST(Tools, HaveOneNameEverywhereTheirOptionsAboveAndTheirDock)
{
  const ReachScene scene(false);
  const auto* foot = scene.window.findChild<QLabel*>("mode");
  const auto* options = scene.window.findChild<OptionsStack*>();
  std::set<const QWidget*> pages;
  const auto inStrip = scene.window.findChild<QToolBar*>("tools_strip")->actions();
  const auto tools = scene.view->findChildren<Tool*>();
  EXPECT_GE(tools.size(), 4);
  for (const Tool* tool : tools)
  {
    const QString name = tool->name();
    const auto isIts = [&](const QAction* one) { return one->text() == tool->title(); };
    const auto entry = std::find_if(inStrip.begin(), inStrip.end(), isIts);
    ASSERT_NE(entry, inStrip.end()) << qPrintable(name);
    EXPECT_EQ((*entry)->iconText().replace('\n', ' '), name);
    (*entry)->trigger();
    EXPECT_EQ(foot->text(), name);
    pages.insert(options->currentWidget());
    const QString keys = scene.view->camera()->GetKeyList();
    EXPECT_EQ(keys.section('\n', 0, 0), "Tool: " + name);
    for (const Tool* other : tools)
    {
      EXPECT_TRUE(keys.simplified().contains(other->name())) << qPrintable(other->name());
    }
    for (const Tool* other : tools)
    {
      const auto* dock = scene.window.findChild<QDockWidget*>(other->objectName() + "_dock");
      EXPECT_TRUE(!dock || dock->isVisible() == (other == tool)) << qPrintable(other->name());
    }
    if (const auto* dock = scene.window.findChild<QDockWidget*>(tool->objectName() + "_dock"))
    {
      EXPECT_EQ(dock->windowTitle(), name);
      EXPECT_EQ(dock->toggleViewAction()->text().remove('&'), name);
      EXPECT_TRUE(dock->features() & QDockWidget::DockWidgetFloatable);
    }
  }
  EXPECT_EQ(pages.size(), static_cast<std::size_t>(tools.size()));
}

TEST(Preferences, AreKeptAndHold)
{
  const auto roughness = [](const ReachScene& scene)
  {
    const auto stroke = oversketch_session::linesOf(*scene.document->session().nodes.back().step, "Stroke");
    double box[6];
    stroke->GetBounds(box);
    return box[3] - box[2];
  };
  Preferences liked;
  liked.dark = false;
  liked.stabilizer = 0.0;
  liked.backend = 2;
  liked.write();
  {
    ReachScene scene(false);
    EXPECT_EQ(scene.document->session().backend, 2);
    EXPECT_GT(QApplication::palette().color(QPalette::Window).lightness(), 128);
    scene.draw(8.0);
    EXPECT_GT(roughness(scene), 13.0 * scene.view->devicePixelRatioF());
  }
  liked.dark = true;
  liked.stabilizer = 40.0;
  liked.backend = 0;
  liked.write();
  {
    ReachScene scene(false);
    EXPECT_EQ(scene.document->session().backend, 0);
    EXPECT_LT(QApplication::palette().color(QPalette::Window).lightness(), 128);
    scene.draw(8.0);
    EXPECT_LT(roughness(scene), 10.0 * scene.view->devicePixelRatioF());
  }
  QSettings().setValue("stabilizer", -5.0);
  QSettings().setValue("backend", 17);
  const Preferences read = Preferences::read();
  EXPECT_EQ(read.stabilizer, 0.0);
  EXPECT_EQ(read.backend, 2);
  Preferences().write();
}

TEST(Preferences, TheBackEndActsAtOnceAsOneStep)
{
  ReachScene scene(true);
  ASSERT_EQ(scene.document->session().backend, 0);
  const std::size_t strokes = scene.document->session().nodes.size();
  scene.document->setBackend(0); // no choice, no step
  EXPECT_FALSE(scene.document->isBusy());
  scene.document->setBackend(2);
  scene.wait();
  EXPECT_EQ(scene.document->session().backend, 2);
  EXPECT_EQ(scene.document->result().backendUsed, 2);
  EXPECT_EQ(scene.document->session().nodes.size(), strokes);
  scene.document->undo();
  scene.wait();
  EXPECT_EQ(scene.document->session().backend, 0);
  EXPECT_EQ(scene.document->session().nodes.size(), strokes);
  scene.document->redo();
  scene.wait();
  EXPECT_EQ(scene.document->session().backend, 2);
}

TEST(Preferences, TheDialogueGivesWhatWasChosen)
{
  Preferences asked;
  asked.stabilizer = 17.0;
  asked.dark = false;
  asked.backend = 1;
  const Preferences given = PreferencesDialog(asked).preferences();
  EXPECT_EQ(given.stabilizer, 17.0);
  EXPECT_FALSE(given.dark);
  EXPECT_EQ(given.backend, 1);
}
