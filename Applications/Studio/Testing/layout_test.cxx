// The window as large or small as screens are, dark and light, each tool in the hand and its docks open:
// nothing lies over another, nothing is cut off, no room is wasted.
#include "options_stack.h"
#include "scene.h"
#include "status_labels.h"
#include "tool.h"

#include "vtkOversketchInteractorStyle.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QHelpEvent>
#include <QLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QScrollArea>
#include <QSlider>
#include <QSplitter>
#include <QStatusBar>
#include <QToolBar>
#include <QToolTip>

#include <iostream>
#include <set>

using namespace oversketch_studio;

namespace
{

bool isIn(const QWidget* one, const QWidget* other)
{
  return other == one || other->isAncestorOf(one);
}

QRect placeIn(const QWidget& window, const QWidget* one)
{
  return { one->mapTo(const_cast<QWidget*>(&window), QPoint()), one->size() };
}

std::string told(const QRect& at)
{
  return std::to_string(at.width()) + " x " + std::to_string(at.height()) + " at " + std::to_string(at.x()) +
         ", " + std::to_string(at.y());
}

// Bars, docks and what is between them.
QList<QWidget*> quartersOf(MainWindow& window)
{
  QList<QWidget*> all{ window.menuBar(), window.statusBar(), window.centralWidget() };
  for (QToolBar* bar : window.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
  {
    all << bar;
  }
  for (QDockWidget* dock : window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
  {
    if (dock->isVisible() && !dock->isFloating())
    {
      all << dock;
    }
  }
  return all;
}

// What a hand takes hold of.
bool isControl(const QWidget* one)
{
  return qobject_cast<const QAbstractButton*>(one) || qobject_cast<const QComboBox*>(one) ||
         qobject_cast<const QAbstractSpinBox*>(one) || qobject_cast<const QSlider*>(one) ||
         qobject_cast<const QListWidget*>(one);
}

// What scrolls need not be seen whole.
bool isScrolled(const QWidget* one)
{
  for (const QWidget* above = one->parentWidget(); above; above = above->parentWidget())
  {
    if (qobject_cast<const QScrollArea*>(above))
    {
      return true;
    }
  }
  return false;
}

void expectInOrder(Scene& scene)
{
  MainWindow& window = scene.window;
  const auto quarters = quartersOf(window);
  for (int i = 0; i < quarters.size(); ++i)
  {
    const QRect at = placeIn(window, quarters[i]);
    const std::string name =
      quarters[i]->objectName().toStdString() + ' ' + quarters[i]->metaObject()->className();
    EXPECT_TRUE(window.rect().contains(at)) << name << " leaves the window: " << told(at);
    EXPECT_GE(at.height(), quarters[i]->minimumSizeHint().height()) << name << " is cut off";
    for (int j = 0; j < i; ++j)
    {
      EXPECT_FALSE(at.intersects(placeIn(window, quarters[j])))
        << name << " lies over " << quarters[j]->objectName().toStdString() << ' '
        << quarters[j]->metaObject()->className();
    }
  }
  std::set<std::string> cut;
  for (const QWidget* one : window.findChildren<QWidget*>())
  {
    const bool isLooked = one->isVisible() && one->window() == &window && isControl(one) &&
                          !isScrolled(one) && !isIn(one, window.menuBar());
    // The strip of tools has a button for what does not fit.
    if (isLooked && one->objectName() != "qt_toolbar_ext_button" &&
        one->visibleRegion().boundingRect() != one->rect())
    {
      const auto* button = qobject_cast<const QAbstractButton*>(one);
      cut.insert(std::string(one->metaObject()->className()) + ' ' + one->objectName().toStdString() + ' ' +
                 one->accessibleName().toStdString() + (button ? button->text().toStdString() : "") + ' ' +
                 told(placeIn(window, one)) + ", seen " + told(one->visibleRegion().boundingRect()));
    }
  }
  for (const std::string& one : cut)
  {
    ADD_FAILURE() << one;
  }
  // The options: as many lines as they need in the width that they have.
  const auto* options = window.findChild<OptionsStack*>();
  const QWidget* shown = options->currentWidget();
  const int needs = shown->layout() ? shown->layout()->totalHeightForWidth(shown->width()) : 0;
  const int button = window.findChild<QWidget*>("presets")->sizeHint().height();
  EXPECT_GE(options->height(), needs);
  EXPECT_LE(window.findChild<QToolBar*>("options_bar")->height(), std::max(needs, button) + 14)
    << "an empty line; the options need " << needs << " px of " << options->height();
  // Rows are seen, and so is the model.
  EXPECT_GE(window.findChild<QListWidget*>("history")->viewport()->height(), 60);
  EXPECT_GE(scene.view->width(), 200);
  EXPECT_GE(scene.view->height(), 300);
}

// The line of text on the shipped model: whole, beside what lies over the view, and legible.
void expectHintBeside(Scene& scene)
{
  ASSERT_FALSE(scene.view->hint().isEmpty());
  const Hint::Box text = scene.view->hintBox().textBox();
  const double ratio = scene.view->devicePixelRatioF();
  EXPECT_GE(text.left, 0.0);
  EXPECT_LE(text.right, ratio * scene.view->width());
  EXPECT_GE(text.bottom, 0.0);
  EXPECT_LE(text.top, ratio * scene.view->height());
  EXPECT_GE(text.top - text.bottom, 10.0 * ratio);
  const auto taken = scene.view->overlays();
  EXPECT_EQ(taken.size(), 2u);
  for (const Hint::Box& box : taken)
  {
    EXPECT_TRUE(
      text.right <= box.left || box.right <= text.left || text.top <= box.bottom || box.top <= text.bottom)
      << "the hint, " << text.left << " to " << text.right << " and " << text.bottom << " to " << text.top
      << ", meets " << box.left << " to " << box.right << " and " << box.bottom << " to " << box.top;
  }
}

// The list of keys: whole and legible.
void expectKeysLegible(Scene& scene)
{
  const std::string keys = scene.view->camera()->GetKeyList();
  vtkTextActor* list = nullptr;
  auto* props = scene.renderer()->GetViewProps();
  props->InitTraversal();
  while (vtkProp* prop = props->GetNextProp())
  {
    auto* text = vtkTextActor::SafeDownCast(prop);
    list = text && text->GetInput() && keys == text->GetInput() ? text : list;
  }
  ASSERT_TRUE(list);
  EXPECT_GE(list->GetTextProperty()->GetFontSize(), 8);
  double box[4]; // from where it stands
  list->GetBoundingBox(scene.renderer(), box);
  const int* size = scene.renderer()->GetSize();
  EXPECT_LE(box[1] - box[0], 0.99 * size[0]);
  EXPECT_LE(box[3] - box[2], 0.99 * size[1]);
}

// What to do next, where it is longer than two lines: in letters that can be read, the whole in its tool tip.
void expectLongAdviceLegible(Scene& scene)
{
  auto* advice = scene.window.findChild<AdviceLabel*>();
  const QString said = advice->text();
  QString text;
  while (text.size() < 400)
  {
    text += "The result is not as drawn: what lies beside the stroke moved too. ";
  }
  advice->setText(text);
  EXPECT_GE(advice->fitting().pointSizeF(), 0.849 * advice->font().pointSizeF());
  const bool isWhole = advice->shown() == text;
  EXPECT_TRUE(isWhole || (advice->shown().size() > 100 && advice->shown().endsWith(QChar(0x2026))));
  QHelpEvent asked(QEvent::ToolTip, { 5, 5 }, advice->mapToGlobal(QPoint(5, 5)));
  QApplication::sendEvent(advice, &asked);
  EXPECT_EQ(QToolTip::text().contains(text), !isWhole);
  QToolTip::hideText();
  advice->setText(said);
}

} // namespace

// In pixels as Qt counts them; a run with QT_SCALE_FACTOR=2 has twice as many. OVERSKETCH_SHOTS=FOLDER keeps
// the pictures.
TEST(Layout, NothingIsCutOffOnAnyScreen)
{
  Scene scene;
  QApplication::setActiveWindow(&scene.window);
  const QString shots = qEnvironmentVariable("OVERSKETCH_SHOTS");
  const double scale = scene.window.devicePixelRatioF();
  for (const QSize& size : { QSize(800, 600), QSize(1000, 700), QSize(1280, 800) })
  {
    scene.window.resize(size);
    scene.settle();
    const QString name = QString("%1x%2_%3_hint").arg(size.width()).arg(size.height()).arg(scale);
    SCOPED_TRACE(qPrintable(name));
    expectHintBeside(scene);
    if (!shots.isEmpty())
    {
      scene.pictureAtRest();
      EXPECT_TRUE(scene.window.grab().save(QDir(shots).filePath(name + ".png")));
    }
  }
  scene.draw();
  scene.release();
  scene.wait();
  ASSERT_EQ(scene.document->session().nodes.size(), 1u) << "no step was drawn";
  EXPECT_EQ(scene.document->result().nodes.at(0).failure, "");
  QAction* dark = nullptr;
  for (QAction* action : scene.window.findChildren<QAction*>())
  {
    dark = action->text() == "&Dark" ? action : dark;
  }
  ASSERT_TRUE(dark);
  int looked = 0;
  for (const QSize& size : { QSize(800, 600), QSize(1280, 800), QSize(2560, 1440) })
  {
    if (scale > 1.0 && size.width() > 1280)
    {
      continue; // no screen has so many
    }
    scene.window.resize(size);
    for (const bool light : { false, true })
    {
      if (dark->isChecked() == light)
      {
        dark->trigger();
      }
      for (Tool* tool : scene.view->findChildren<Tool*>())
      {
        QTest::keyClick(scene.view, static_cast<Qt::Key>(tool->key()[0]));
        ASSERT_EQ(scene.view->tool(), tool);
        for (int i = 0; i < 5; ++i)
        {
          QApplication::processEvents();
        }
        const QString name = QString("%1x%2_%3_%4_%5")
                               .arg(size.width())
                               .arg(size.height())
                               .arg(scale)
                               .arg(light ? "light" : "dark", tool->objectName());
        SCOPED_TRACE(qPrintable(name));
        EXPECT_EQ(scene.window.size(), size);
        expectInOrder(scene);
        const auto* advice = scene.window.findChild<AdviceLabel*>();
        EXPECT_GE(advice->fitting().pointSizeF(), 0.849 * advice->font().pointSizeF());
        if (size.width() == 800 && !light)
        {
          QTest::keyClick(scene.view, Qt::Key_F1);
          QApplication::processEvents();
          expectKeysLegible(scene);
          if (!shots.isEmpty())
          {
            EXPECT_TRUE(scene.window.grab().save(QDir(shots).filePath(name + "_keys.png")));
          }
          QTest::keyClick(scene.view, Qt::Key_F1);
          expectLongAdviceLegible(scene);
        }
        ++looked;
        if (!shots.isEmpty())
        {
          scene.pictureAtRest();
          EXPECT_TRUE(scene.window.grab().save(QDir(shots).filePath(name + ".png")));
        }
      }
    }
  }
  if (!dark->isChecked())
  {
    dark->trigger();
  }
  std::cout << looked << " windows\n";
}
