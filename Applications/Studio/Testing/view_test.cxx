// How the model is looked at: the camera from anywhere, displays, what it was before; each by a hand at the
// window.
#include "axis_gizmo.h"
#include "display.h"
#include "mesh_file.h"
#include "scene.h"
#include "solids.h"
#include "tool.h"
#include "view_bar.h"
#include "view_menu.h"

#include "Harness/polydata.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QNativeGestureEvent>
#include <QTemporaryDir>
#include <QWheelEvent>

#include <vector>

using namespace oversketch_studio;

namespace
{

std::vector<double> cameraOf(Scene& scene)
{
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  std::vector<double> all{ camera->GetViewAngle(),
    camera->GetParallelScale(),
    camera->GetWindowCenter()[0],
    camera->GetWindowCenter()[1],
    double(camera->GetParallelProjection()) };
  for (const double* three : { camera->GetPosition(), camera->GetFocalPoint(), camera->GetViewUp() })
  {
    all.insert(all.end(), three, three + 3);
  }
  return all;
}

void drag(Viewport* view,
  Qt::MouseButton button,
  const QPoint& from,
  const QPoint& by,
  Qt::KeyboardModifiers with = Qt::NoModifier)
{
  QTest::mousePress(view, button, with, from);
  for (int i = 1; i <= 4; ++i)
  {
    QMouseEvent move(
      QEvent::MouseMove, from + i * by / 4, view->mapToGlobal(from + i * by / 4), Qt::NoButton, button, with);
    QApplication::sendEvent(view, &move);
  }
  QTest::mouseRelease(view, button, with, from + by);
}

// How far the picture's right is from level.
double tilt(Scene& scene)
{
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  double right[3];
  vtkMath::Cross(camera->GetDirectionOfProjection(), camera->GetViewUp(), right);
  return std::abs(right[1]);
}

double turned(Scene& scene, const double before[3]) // degrees
{
  return vtkMath::DegreesFromRadians(
    vtkMath::AngleBetweenVectors(scene.renderer()->GetActiveCamera()->GetDirectionOfProjection(), before));
}

QAction* actionOf(Scene& scene, const QString& text)
{
  for (QAction* action : scene.window.findChildren<QAction*>())
  {
    if (action->text() == text)
    {
      return action;
    }
  }
  ADD_FAILURE() << "no action " << text.toStdString();
  return nullptr;
}

// Pixels that differ by more than smoothing does.
int different(const QImage& a, const QImage& b)
{
  int found = 0;
  for (int y = 0; y < a.height(); ++y)
  {
    for (int x = 0; x < a.width(); ++x)
    {
      const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
      found +=
        std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue()) > 24;
    }
  }
  return found;
}

bool isOrange(const QColor& c)
{
  return c.red() > 150 && c.red() > 1.3 * c.green() && c.green() > 1.6 * c.blue();
}

} // namespace

TEST(View, TheCameraTurnsFromAnywhere)
{
  Scene scene;
  QApplication::setActiveWindow(&scene.window);
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  const auto first = cameraOf(scene);
  const QPoint nowhere(40, scene.view->height() - 40),
    body(scene.view->width() / 2, scene.view->height() / 2);
  const auto back = [&]
  {
    QTest::keyClick(scene.view, Qt::Key_W);
    EXPECT_EQ(cameraOf(scene), first);
  };
  const double ahead[3] = { 0.0, 0.0, -1.0 };
  // Beside the model and on it, the horizon level; 60 px are no quarter of a turn any more.
  drag(scene.view, Qt::MiddleButton, nowhere, { 80, -40 });
  EXPECT_GT(turned(scene, ahead), 5.0);
  EXPECT_LT(tilt(scene), 1e-9);
  back();
  drag(scene.view, Qt::MiddleButton, body, { 60, 0 });
  EXPECT_GT(turned(scene, ahead), 5.0);
  EXPECT_LT(turned(scene, ahead), 30.0);
  EXPECT_LT(tilt(scene), 1e-9);
  back();
  // Freely, as an option that is kept.
  actionOf(scene, "Turn fr&eely, as a ball")->trigger();
  drag(scene.view, Qt::MiddleButton, nowhere, { 80, -60 });
  EXPECT_GT(tilt(scene), 1e-3);
  back();
  actionOf(scene, "Turn fr&eely, as a ball")->trigger();
  // Alt + left turns, Alt + middle and Alt + Shift + left pan, Space + left turns; none of them draws.
  drag(scene.view, Qt::LeftButton, nowhere, { 80, 0 }, Qt::AltModifier);
  EXPECT_GT(turned(scene, ahead), 5.0);
  back();
  for (const auto& [button, with] : { std::pair(Qt::MiddleButton, Qt::KeyboardModifiers(Qt::AltModifier)),
         std::pair(Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier) })
  {
    drag(scene.view, button, nowhere, { 80, 0 }, with);
    EXPECT_LT(turned(scene, ahead), 1e-9);
    EXPECT_NE(cameraOf(scene), first);
    back();
  }
  QTest::keyPress(scene.view, Qt::Key_Space);
  drag(scene.view, Qt::LeftButton, nowhere, { 80, 0 });
  QTest::keyRelease(scene.view, Qt::Key_Space);
  EXPECT_GT(turned(scene, ahead), 5.0);
  back();
  // Two fingers turn, with Shift they pan, a pinch zooms.
  const auto scroll = [&](Qt::KeyboardModifiers with)
  {
    QWheelEvent event(body,
      scene.view->mapToGlobal(body),
      QPoint(60, 0),
      QPoint(480, 0),
      Qt::NoButton,
      with,
      Qt::ScrollUpdate,
      false);
    QApplication::sendEvent(scene.view, &event);
  };
  scroll(Qt::NoModifier);
  EXPECT_GT(turned(scene, ahead), 5.0);
  EXPECT_LT(tilt(scene), 1e-9);
  back();
  scroll(Qt::ShiftModifier);
  EXPECT_LT(turned(scene, ahead), 1e-9);
  EXPECT_NE(cameraOf(scene), first);
  back();
  QNativeGestureEvent pinch(
    Qt::ZoomNativeGesture, nullptr, body, body, scene.view->mapToGlobal(body), 0.5, 0, 0);
  QApplication::sendEvent(scene.view, &pinch);
  EXPECT_NEAR(scene.view->camera()->GetZoom(), 1.5, 1e-9);
  back();
  // The wheel, where the cursor is; the eye stays.
  const QPoint top = scene.top();
  QWheelEvent notch(top,
    scene.view->mapToGlobal(top),
    QPoint(),
    QPoint(0, 360),
    Qt::NoButton,
    Qt::NoModifier,
    Qt::NoScrollPhase,
    false);
  QApplication::sendEvent(scene.view, &notch);
  EXPECT_GT(scene.view->camera()->GetZoom(), 1.05);
  EXPECT_LE((scene.top() - top).manhattanLength(), 2);
  EXPECT_EQ(camera->GetPosition()[2], first[7]);
  back();
  // Sides by keys; the projection by another, of the same size.
  const double sides[6][3] = {
    { 0, 0, -1 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }
  };
  for (int i = 0; i < 6; ++i)
  {
    QTest::keyClick(scene.view, static_cast<Qt::Key>(Qt::Key_1 + i), Qt::ControlModifier);
    EXPECT_LT(turned(scene, sides[i]), 1e-6) << i;
  }
  back();
  auto* bar = scene.window.findChild<ViewBar*>();
  const QString perspective = bar->findChild<QAbstractButton*>()->text();
  QTest::keyClick(scene.view, Qt::Key_5);
  EXPECT_TRUE(camera->GetParallelProjection());
  EXPECT_NE(bar->findChild<QAbstractButton*>()->text(), perspective);
  EXPECT_TRUE(ViewSettings::read().parallel);
  QTest::keyClick(scene.view, Qt::Key_5);
  EXPECT_FALSE(camera->GetParallelProjection());
  EXPECT_TRUE(scene.document->session().nodes.empty()) << "something was drawn";
}

TEST(View, TheAxesInTheCornerAreClickedAndDragged)
{
  Scene scene;
  auto* gizmo = scene.window.findChild<AxisGizmo*>();
  ASSERT_TRUE(gizmo && gizmo->isVisible());
  const double left[3] = { -1.0, 0.0, 0.0 }, right[3] = { 1.0, 0.0, 0.0 };
  QTest::mouseClick(gizmo, Qt::LeftButton, Qt::NoModifier, gizmo->end(0, false).toPoint());
  EXPECT_LT(turned(scene, left), 1e-6);
  QTest::keyClick(scene.view, Qt::Key_W);
  scene.pictureAtRest();
  QTest::mouseClick(gizmo, Qt::LeftButton, Qt::NoModifier, gizmo->end(0, true).toPoint());
  EXPECT_LT(turned(scene, right), 1e-6);
  QTest::keyClick(scene.view, Qt::Key_W);
  const QPoint middle = gizmo->end(2, false).toPoint();
  QTest::mousePress(gizmo, Qt::LeftButton, Qt::NoModifier, middle);
  moveMouse(gizmo, middle + QPoint(12, 0));
  moveMouse(gizmo, middle + QPoint(21, 0));
  QTest::mouseRelease(gizmo, Qt::LeftButton, Qt::NoModifier, middle + QPoint(21, 0));
  const double ahead[3] = { 0.0, 0.0, -1.0 };
  EXPECT_NEAR(turned(scene, ahead), 45.0, 1.0);
  EXPECT_TRUE(scene.document->session().nodes.empty());
  QTest::keyClick(scene.view, Qt::Key_W);
  const QPoint between = gizmo->rect().center() + QPoint(14, 14);
  QTest::mousePress(gizmo, Qt::LeftButton, Qt::NoModifier, between);
  EXPECT_TRUE(scene.view->tool()->draws()) << "what lies between its ends is the view's";
  QTest::keyClick(scene.view, Qt::Key_Escape);
  QTest::mouseRelease(gizmo, Qt::LeftButton, Qt::NoModifier, between);
  EXPECT_TRUE(scene.document->session().nodes.empty());
  // It takes no keys, and no line that begins beside it; while a line is drawn it is not painted.
  EXPECT_EQ(gizmo->focusPolicy(), Qt::NoFocus);
  QTest::keyClick(scene.view, Qt::Key_W);
  scene.pictureAtRest();
  struct Paints : QObject
  {
    bool eventFilter(QObject*, QEvent* event) override
    {
      this->count += event->type() == QEvent::Paint;
      return false;
    }
    int count = 0;
  } paints;
  gizmo->installEventFilter(&paints);
  const QPoint corner = gizmo->geometry().bottomLeft() + QPoint(-4, 4);
  QTest::mousePress(scene.view, Qt::LeftButton, Qt::NoModifier, corner);
  for (int i = 1; i <= 10; ++i)
  {
    moveMouse(scene.view, corner + QPoint(i * 5, -i * 5)); // under it
    QApplication::processEvents();
  }
  EXPECT_TRUE(scene.view->tool()->draws());
  EXPECT_EQ(paints.count, 0);
  QTest::keyClick(scene.view, Qt::Key_Escape);
  QTest::mouseRelease(scene.view, Qt::LeftButton, Qt::NoModifier, corner + QPoint(50, -50));
  scene.wait();
}

TEST(View, TheModelIsShownInManyWays)
{
  Scene scene;
  const QImage smooth = scene.pictureAtRest();
  EXPECT_EQ(scene.window.findChild<QLabel*>("triangles")->text(),
    QString("%1k tri").arg(scene.view->mesh()->GetNumberOfPolys() / 1000));
  const auto as = [&](const char* text)
  {
    actionOf(scene, text)->trigger();
    return scene.pictureAtRest();
  };
  const QImage flat = as("&Flat"), wire = as("&Wireframe over shade"), clay = as("&Clay (matcap)");
  EXPECT_EQ(ViewSettings::read().shading, Shading::Matcap);
  EXPECT_GT(different(flat, smooth), 500);
  EXPECT_GT(different(wire, smooth), 20000);
  const auto isRed = [](const QColor& c) { return c.red() > 1.3 * c.blue() && c.red() > 60; };
  EXPECT_EQ(count(smooth, isRed), count(flat, isRed));
  EXPECT_GT(count(clay, isRed), 20000);
  EXPECT_EQ(different(as("&Smooth"), smooth), 0);
  // The ground.
  const QImage ground = as("&Ground grid");
  EXPECT_GT(different(ground, smooth), 300);
  EXPECT_TRUE(ViewSettings::read().ground);
  EXPECT_EQ(different(as("&Ground grid"), smooth), 0);
  // A stroke; the model before it while U is held; the original through it.
  QTest::keyClick(scene.view, Qt::Key_W); // hides the hint
  const QImage before = scene.pictureAtRest();
  scene.draw();
  scene.release();
  scene.wait();
  QTest::keyClick(scene.view, Qt::Key_Return); // the red line is let go
  const QImage after = scene.pictureAtRest();
  const int changed = different(after, before);
  EXPECT_GT(changed, 200);
  QTest::keyPress(scene.view, Qt::Key_U);
  EXPECT_TRUE(QTest::qWaitFor([&] { return scene.view->display().instead(); }, 600000));
  EXPECT_EQ(different(scene.pictureAtRest(), before), 0);
  QTest::keyRelease(scene.view, Qt::Key_U);
  EXPECT_FALSE(scene.view->display().instead());
  EXPECT_EQ(different(scene.pictureAtRest(), after), 0);
  EXPECT_GT(different(as("&Onion of the original"), after), 2000);
  EXPECT_EQ(different(as("&Onion of the original"), after), 0);
}

TEST(View, WhatMovesIsOrangeAtOnce)
{
  Scene scene;
  actionOf(scene, "&Region that moves")->trigger();
  EXPECT_EQ(count(scene.pictureAtRest(), isOrange), 0);
  scene.draw();
  scene.release();
  scene.wait();
  EXPECT_GT(count(scene.pictureAtRest(), isOrange), 500);
}

TEST(View, AMirrorPlaneIsSeenEdgeOn)
{
  Scene scene;
  auto* mirror = scene.window.findChild<QComboBox*>("mirror");
  const auto with = [&](int choice)
  {
    mirror->setCurrentIndex(choice);
    emit mirror->activated(choice);
    return scene.pictureAtRest();
  };
  QTest::keyClick(scene.view, Qt::Key_5);
  const QImage none = with(0);
  const auto isBlue = [](const QColor& c) { return c.blue() > 120 && c.blue() > 1.3 * c.red(); };
  EXPECT_EQ(count(none, isBlue), 0);
  // The plane across x, from the front: a line as high as the model and more.
  EXPECT_GT(count(with(1), isBlue), scene.view->height() / 4);
  with(0);
  QTest::keyClick(scene.view, Qt::Key_5);
}

TEST(View, ACubesEdgesAreSharp)
{
  Scene scene;
  const QTemporaryDir folder;
  QTest::keyClick(scene.view, Qt::Key_5);
  for (const int squares : { 4, 100 })
  {
    SCOPED_TRACE(squares);
    const QString path = folder.filePath(QString("box%1.ply").arg(squares));
    oversketch_files::Notes notes;
    oversketch_files::writeMesh(oversketch_test::toPolyData(boxOf(squares)), path.toStdString(), notes);
    scene.document->discardAutosave();
    ASSERT_TRUE(scene.window.open(path));
    scene.wait();
    const QImage front = scene.pictureAtRest();
    // The front face is of one colour from edge to edge.
    const double corner[3] = { 0.985, 0.985, 1.0 }, middle[3] = { 0.0, 0.0, 1.0 };
    const QColor at = front.pixelColor(scene.seen(corner)), in = front.pixelColor(scene.seen(middle));
    EXPECT_GT(in.red(), 60);
    EXPECT_NEAR(at.red(), in.red(), 3);
    EXPECT_NEAR(at.blue(), in.blue(), 3);
  }
  QTest::keyClick(scene.view, Qt::Key_5);
}
