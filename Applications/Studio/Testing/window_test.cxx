// The window under random mouse, keys and menus: it never fails, says no error, and takes no more and more
// memory.
#include "document.h"
#include "files.h"
#include "main_window.h"
#include "view.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <random>
#include <string>

#include <malloc.h>

using namespace oversketch_studio;

namespace
{

// Answers every question with Escape, as soon as it is asked.
void answerQuestions()
{
  auto* timer = new QTimer(qApp);
  QObject::connect(timer,
    &QTimer::timeout,
    []
    {
      if (QWidget* asked = QApplication::activeModalWidget())
      {
        QTest::keyClick(asked, Qt::Key_Escape);
      }
      if (QWidget* popup = QApplication::activePopupWidget())
      {
        popup->close();
      }
    });
  timer->start(5);
}

// MiB, without what the allocator keeps for later.
double resident()
{
  malloc_trim(0);
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind("VmRSS:", 0) == 0)
    {
      return std::stod(line.substr(6)) / 1024.0;
    }
  }
  return 0.0;
}

// Waits for the result. The limit only ends a test that hangs: a wild stroke with normals adjusted takes half
// a minute under the sanitizers.
bool settles(const Document& document)
{
  return QTest::qWaitFor([&] { return !document.isBusy(); }, 600000);
}

struct Hand
{
  explicit Hand(unsigned seed)
    : random(seed)
  {
  }
  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(this->random); }
  QPoint place(QWidget* on) { return { this->upTo(on->width() - 1), this->upTo(on->height() - 1) }; }

  // A stroke, a turn, a click, a key or a menu entry.
  void act(MainWindow& window, View& view)
  {
    static const Qt::Key keys[] = { Qt::Key_R,
      Qt::Key_X,
      Qt::Key_Y,
      Qt::Key_Z,
      Qt::Key_1,
      Qt::Key_2,
      Qt::Key_3,
      Qt::Key_W,
      Qt::Key_C,
      Qt::Key_H,
      Qt::Key_L,
      Qt::Key_I,
      Qt::Key_M,
      Qt::Key_J,
      Qt::Key_K,
      Qt::Key_P,
      Qt::Key_N,
      Qt::Key_D,
      Qt::Key_T,
      Qt::Key_F1,
      Qt::Key_Escape,
      Qt::Key_Backspace,
      Qt::Key_Return,
      Qt::Key_Delete,
      Qt::Key_Tab,
      Qt::Key_Space,
      Qt::Key_Up,
      Qt::Key_Down };
    static const Qt::KeyboardModifiers modifiers[] = {
      Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier
    };
    const Qt::MouseButton button = this->upTo(3) > 0 ? Qt::LeftButton : Qt::MiddleButton;
    switch (this->upTo(9))
    {
      case 0:
      case 1:
      case 2:
        QTest::mousePress(&view, button, modifiers[this->upTo(2)], this->place(&view));
        break;
      case 3:
      case 4:
      case 5:
        QTest::mouseMove(&view, this->place(&view));
        break;
      case 6:
        QTest::mouseRelease(&view, button, Qt::NoModifier, this->place(&view));
        break;
      case 7:
        QTest::keyClick(
          &view, keys[this->upTo(static_cast<int>(std::size(keys)) - 1)], modifiers[this->upTo(1)]);
        break;
      case 8:
      {
        auto widgets = window.findChildren<QWidget*>();
        QWidget* one = widgets[this->upTo(widgets.size() - 1)];
        if (one->isVisible() && one->width() > 0 && one->height() > 0)
        {
          QTest::mouseClick(one, Qt::LeftButton, Qt::NoModifier, this->place(one));
        }
        break;
      }
      default:
      {
        auto actions = window.findChildren<QAction*>();
        QAction* one = actions[this->upTo(actions.size() - 1)];
        const QString name = one->text();
        if (one->isEnabled() && !name.contains("Quit") && !one->menu())
        {
          one->trigger();
        }
        break;
      }
    }
    QApplication::processEvents();
  }

  std::mt19937 random;
};

} // namespace

// OVERSKETCH_SEQUENCES asks for another number of sequences than that of the usual run,
// OVERSKETCH_FIRST_SEQUENCE for others than the first, so that many can be shared out.
TEST(Window, LivesThroughRandomHands)
{
  const char* asked = std::getenv("OVERSKETCH_SEQUENCES");
  const int sequences = asked ? std::atoi(asked) : 4;
  const char* from = std::getenv("OVERSKETCH_FIRST_SEQUENCE");
  const int first = from ? std::atoi(from) : 0;
  constexpr int events = 200;
  double early = 0.0;
  for (int sequence = 0; sequence < sequences; ++sequence)
  {
    Hand hand(static_cast<unsigned>(first + sequence));
    MainWindow window;
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 60000));
    window.openShippedModel();
    auto* view = window.findChild<View*>();
    auto* document = window.findChild<Document*>();
    ASSERT_TRUE(view && document && document->isOpen());
    ASSERT_TRUE(settles(*document));
    for (int event = 0; event < events; ++event)
    {
      hand.act(window, *view);
    }
    QTest::mouseRelease(view, Qt::LeftButton);
    ASSERT_TRUE(settles(*document)) << "sequence " << first + sequence;
    // What is shown is what the history makes of the mesh, and undoing all of it shows the mesh as it was.
    while (document->canUndo())
    {
      document->undo();
    }
    ASSERT_TRUE(settles(*document));
    EXPECT_EQ(document->result().digest, oversketch_session::digestOf(document->session().mesh));
    EXPECT_EQ(oversketch_files::takeError(), "") << "sequence " << first + sequence;
    document->discardAutosave();
    if (sequence == sequences / 5)
    {
      early = resident();
    }
  }
  // A few sequences differ by their strokes; a leak shows over many.
  if (sequences >= 20)
  {
    const double late = resident();
    std::printf("Resident after a fifth of the sequences %.0f MiB, at the end %.0f MiB\n", early, late);
    EXPECT_LT(late, 1.3 * early + 50.0);
  }
}

int main(int count, char** values)
{
  testing::InitGoogleTest(&count, values);
  const QTemporaryDir home;
  qputenv("XDG_STATE_HOME", home.path().toLocal8Bit());
  QStandardPaths::setTestModeEnabled(true);
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, home.path());
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  const QApplication application(count, values);
  QCoreApplication::setOrganizationName("oversketch");
  QCoreApplication::setApplicationName("oversketch-test");
  oversketch_files::catchMessages();
  answerQuestions();
  return RUN_ALL_TESTS();
}
