// What the hand holds: a pen with pressure, fingers, its side; and the options that it likes.
#include "option_presets.h"
#include "pen.h"
#include "preferences.h"
#include "scene.h"
#include "tool.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QSettings>
#include <QTimer>
#include <QToolBar>

#include <cmath>
#include <string>
#include <vector>

using namespace oversketch_studio;
using namespace oversketch_session;

namespace
{

std::vector<QPoint> straight(const QPoint& from, const QPoint& to)
{
  std::vector<QPoint> way;
  for (int i = 0; i <= 30; ++i)
  {
    way.push_back(from + (to - from) * i / 30);
  }
  return way;
}

std::vector<QPoint> ring(const QPoint& middle, double wide, double high)
{
  std::vector<QPoint> way;
  for (int i = 0; i <= 60; ++i)
  {
    const double angle = 2.0 * M_PI * i / 60;
    way.push_back(middle + QPoint(int(wide * std::cos(angle)), int(high * std::sin(angle))));
  }
  return way;
}

void expectPressure(vtkPolyData* stroke, const std::string& what)
{
  ASSERT_TRUE(stroke) << what;
  vtkDataArray* pressure = stroke->GetPointData()->GetArray("Pressure");
  ASSERT_TRUE(pressure) << what;
  double range[2];
  pressure->GetRange(range);
  EXPECT_LT(range[0], 0.3) << what;
  EXPECT_GT(range[1], 0.6) << what;
  EXPECT_LT(range[1], 0.9) << what;
}

vtkSmartPointer<vtkPolyData> lastLines(Scene& scene, const char* input)
{
  const auto& nodes = scene.document->session().nodes;
  return nodes.empty() ? nullptr : linesOf(*nodes.back().step, input);
}

} // namespace

TEST(Pen, PressureReachesTheStrokesOfEveryTool)
{
  Scene scene;
  QApplication::setActiveWindow(&scene.window);
  for (Tool* tool : scene.view->findChildren<Tool*>())
  {
    scene.view->setTool(tool);
    // What it does with this tool is said; what it does with the line's height is in Line.*.
    const QString keys = QString::fromUtf8(scene.view->camera()->GetKeyList()).simplified();
    EXPECT_TRUE(keys.contains("Pen pressure " + tool->pressure())) << qPrintable(tool->name());
    EXPECT_EQ(tool->pressure(),
      tool->name() == "Line on surface" ? "is the line's height, where Pressure is height is ticked"
      : tool->name() == "Smooth"        ? "is how much it smooths"
                                        : "makes no difference to this tool");
  }
  const QPoint middle = scene.seen(scene.document->result().mesh->GetCenter()) - QPoint(20, 20);
  const auto take = [&](Qt::Key key)
  {
    QTest::keyClick(scene.view, key);
    QApplication::processEvents();
    scene.wait();
    QApplication::processEvents();
  };
  take(Qt::Key_B);
  drawWithPen(scene.view, straight(middle - QPoint(60, 0), middle + QPoint(60, 0)));
  scene.wait();
  expectPressure(lastLines(scene, "Strokes"), "line on surface");
  scene.document->undo();
  scene.wait();
#ifdef OVERSKETCH_WITH_EDIT
  take(Qt::Key_E);
  drawWithPen(scene.view, straight(middle - QPoint(35, 0), middle + QPoint(35, 0)));
  drawWithPen(scene.view, ring(middle, 75, 40));
  scene.wait();
  ASSERT_EQ(scene.document->session().nodes.size(), 1u);
  expectPressure(lastLines(scene, "Reference"), "line of an edit");
  expectPressure(lastLines(scene, "Boundary"), "ring of an edit");
  scene.document->undo();
  scene.wait();
#endif
  take(Qt::Key_D);
  const QPoint top = scene.top();
  std::vector<QPoint> arch;
  for (int i = -15; i <= 15; ++i)
  {
    arch.push_back(top + QPoint(3 * i, int(std::lround(20.0 - 45.0 * std::cos(0.08 * i)))));
  }
  drawWithPen(scene.view, arch);
  scene.wait();
  expectPressure(lastLines(scene, "Stroke"), "outline");
  scene.document->undo();
  scene.wait();
  // And the picture's.
  scene.window.openPicture({});
  scene.document->discardAutosave();
  scene.wait();
  auto* pad = scene.window.findChild<QWidget*>("drawing_pad");
  ASSERT_TRUE(QTest::qWaitFor([&] { return pad->isVisible() && pad->width() > 200; }, 60000));
  drawWithPen(pad, ring({ pad->width() / 2, pad->height() / 2 }, 60, 60));
  scene.wait();
  expectPressure(lastLines(scene, "Strokes"), "drawing");
}

TEST(Pen, OneFingerDrawsTwoTurnAndZoom)
{
  Scene scene;
  QTouchDevice* screen = QTest::createTouchDevice();
  const auto look = [&]
  {
    vtkCamera* camera = scene.renderer()->GetActiveCamera();
    return std::vector<double>{ camera->GetDirectionOfProjection()[0],
      camera->GetDirectionOfProjection()[1],
      camera->GetDirectionOfProjection()[2] };
  };
  const auto steps = [&] { return scene.document->session().nodes.size(); };
  const QPoint middle(scene.view->width() / 2, scene.view->height() / 2);
  // Two that go apart.
  const std::vector<double> before = look();
  const double zoom = scene.view->camera()->GetZoom();
  const auto two = [&](const QPoint& a, const QPoint& b, const QPoint& toA, const QPoint& toB)
  {
    QTest::touchEvent(scene.view, screen).press(0, a, scene.view);
    QTest::touchEvent(scene.view, screen).move(0, a, scene.view).press(1, b, scene.view);
    for (int i = 1; i <= 10; ++i)
    {
      QTest::touchEvent(scene.view, screen)
        .move(0, a + (toA - a) * i / 10, scene.view)
        .move(1, b + (toB - b) * i / 10, scene.view);
      QApplication::processEvents();
    }
    QTest::touchEvent(scene.view, screen).move(0, toA, scene.view).release(1, toB, scene.view);
    QTest::touchEvent(scene.view, screen).release(0, toA, scene.view);
  };
  two(middle - QPoint(50, 0), middle + QPoint(50, 0), middle - QPoint(75, 0), middle + QPoint(75, 0));
  EXPECT_NEAR(scene.view->camera()->GetZoom(), 1.5 * zoom, 0.01);
  EXPECT_EQ(look(), before);
  scene.view->camera()->SetZoom(zoom);
  // Two that go together.
  const QPoint aside(80, 0);
  two(middle - QPoint(50, 0),
    middle + QPoint(50, 0),
    middle - QPoint(50, 0) + aside,
    middle + QPoint(50, 0) + aside);
  EXPECT_NE(look(), before);
  EXPECT_NEAR(scene.view->camera()->GetZoom(), zoom, 1e-9);
  EXPECT_EQ(steps(), 0u) << "fingers that turned have drawn";
  scene.view->camera()->ResetToFirstView();
  // One.
  const QPoint top = scene.top();
  const auto at = [&](int i)
  { return top + QPoint(3 * i, int(std::lround(20.0 - 45.0 * std::cos(0.08 * i)))); };
  const auto draw = [&](int to)
  {
    QTest::touchEvent(scene.view, screen).press(0, at(-15), scene.view);
    for (int i = -14; i <= to; ++i)
    {
      QTest::touchEvent(scene.view, screen).move(0, at(i), scene.view);
      QApplication::processEvents();
    }
  };
  draw(15);
  QTest::touchEvent(scene.view, screen).release(0, at(15), scene.view);
  scene.wait();
  EXPECT_EQ(steps(), 1u);
  scene.document->undo();
  scene.wait();
  // A second finger takes back what the first had begun.
  draw(0);
  EXPECT_TRUE(scene.view->tool()->draws());
  QTest::touchEvent(scene.view, screen).move(0, at(0), scene.view).press(1, middle, scene.view);
  EXPECT_FALSE(scene.view->tool()->draws());
  QTest::touchEvent(scene.view, screen).release(0, at(0), scene.view).release(1, middle, scene.view);
  scene.wait();
  EXPECT_EQ(steps(), 0u);
}

TEST(Pen, TheLeftHandHasToolsAtTheRight)
{
  Preferences left;
  left.leftHanded = true;
  left.write();
  {
    Scene scene;
    QApplication::processEvents();
    const auto x = [&](QWidget* one) { return one->mapTo(&scene.window, QPoint(0, 0)).x(); };
    EXPECT_GT(x(scene.window.findChild<QToolBar*>("tools_strip")), x(scene.view));
    for (const char* dock : { "scene_dock", "history_dock" })
    {
      auto* panel = scene.window.findChild<QDockWidget*>(dock);
      EXPECT_TRUE(panel->isVisible());
      EXPECT_LT(x(panel), x(scene.view)) << dock;
    }
  }
  Preferences().write();
  {
    Scene scene;
    QApplication::processEvents();
    EXPECT_EQ(
      scene.window.toolBarArea(scene.window.findChild<QToolBar*>("tools_strip")), Qt::LeftToolBarArea);
    EXPECT_EQ(scene.window.dockWidgetArea(scene.window.findChild<QDockWidget*>("history_dock")),
      Qt::RightDockWidgetArea);
  }
}

TEST(Pen, OptionsAreKeptUnderANameAndTakenUpAgain)
{
  QSettings().remove("presets");
  Scene scene;
  QApplication::setActiveWindow(&scene.window);
  auto* presets = scene.window.findChild<OptionPresets*>();
  ASSERT_TRUE(presets);
  QTest::keyClick(scene.view, Qt::Key_B);
  auto* radius = scene.window.findChild<QDoubleSpinBox*>("augment_radius");
  auto* direction = scene.window.findChild<QComboBox*>("augment_direction");
  const double own = radius->value();
  radius->setValue(2.0 * own);
  const double wide = radius->value();
  presets->keep("Wide & raised");
  radius->setValue(own);
  direction->setCurrentIndex(1);
  emit direction->activated(1);
  // By the menu and the dialogue.
  QTimer look;
  QObject::connect(&look,
    &QTimer::timeout,
    [&look]
    {
      auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
      auto* name = dialog && dialog->isVisible() ? dialog->findChild<QLineEdit*>() : nullptr;
      if (name)
      {
        look.stop();
        QTest::keyClicks(name, "carved");
        QTest::keyClick(name, Qt::Key_Return);
      }
    });
  look.start(20);
  emit presets->aboutToShow();
  ASSERT_EQ(presets->actions().size(), 4);
  presets->actions()[2]->trigger();
  EXPECT_FALSE(look.isActive()) << "no name was asked for";
  EXPECT_EQ(presets->names(), (QStringList{ "carved", "Wide & raised" }));
  emit presets->aboutToShow();
  ASSERT_EQ(presets->actions().size(), 5); // two, a line, keep, remove
  presets->actions()[1]->trigger();
  EXPECT_NEAR(radius->value(), wide, 1e-9);
  EXPECT_EQ(direction->currentIndex(), 0);
  presets->actions()[0]->trigger();
  EXPECT_NEAR(radius->value(), own, 1e-6 * own);
  EXPECT_EQ(direction->currentIndex(), 1);
  // The outline's are others.
  QTest::keyClick(scene.view, Qt::Key_D);
  EXPECT_TRUE(presets->names().isEmpty());
  QTest::keyClick(scene.view, Qt::Key_B);
  emit presets->aboutToShow();
  ASSERT_TRUE(presets->actions().last()->menu());
  presets->actions().last()->menu()->actions()[0]->trigger();
  EXPECT_EQ(presets->names(), QStringList{ "Wide & raised" });
  QTest::keyClick(scene.view, Qt::Key_T);
  EXPECT_FALSE(presets->isEnabled()) << "there is nothing to keep";
  QSettings().remove("presets");
}
