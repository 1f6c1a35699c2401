// What was whole in view stays whole in a window, or beside a dock, that makes the view narrower than high;
// and the view comes back as it was.
#include "scene.h"
#include "session_file.h"
#include "tool.h"
#include "viewport.h"

#include "pen_view.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkCamera.h"

#include <QDockWidget>
#include <QTemporaryDir>
#include <QWheelEvent>

#include <array>

using namespace oversketch_studio;
using oversketch_session::Look;

namespace
{

struct Sizes : Scene
{
  Sizes()
  {
    QTest::keyClick(this->view, Qt::Key_W); // hides the hint
    this->wide();
  }
  void size(int width, int height)
  {
    this->window.resize(width, height);
    this->settle();
  }
  void wide()
  {
    this->size(1200, 800);
    ASSERT_GT(this->view->width(), this->view->height());
  }
  void narrow()
  {
    this->size(800, 1000);
    ASSERT_LT(this->view->width(), 0.7 * this->view->height());
  }
  bool isWhole()
  {
    vtkPolyData* mesh = this->document->result().mesh;
    int inside = 0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      inside += this->view->rect().contains(this->seen(mesh->GetPoint(i)));
    }
    return inside == mesh->GetNumberOfPoints();
  }
  void zoom(const QPoint& at, int notches)
  {
    for (int i = 0; i < notches; ++i)
    {
      QWheelEvent turned(at,
        this->view->mapToGlobal(at),
        QPoint(),
        QPoint(0, 120),
        Qt::NoButton,
        Qt::NoModifier,
        Qt::NoScrollPhase,
        false);
      QApplication::sendEvent(this->view, &turned);
    }
  }
  // The place of the world that is seen in the middle, as deep as where the camera looks at.
  oversketch::Vector3 middle()
  {
    const auto now = oversketch::PenView::of(this->renderer());
    const oversketch::View seen = now.kernelView();
    const oversketch::Vector3 focus(this->renderer()->GetActiveCamera()->GetFocalPoint());
    return seen.toWorld({ 0.5 * now.size[0], 0.5 * now.size[1] }, seen.depth(focus));
  }
};

void expectSame(const Look& a, const Look& b)
{
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.focus, b.focus);
  EXPECT_EQ(a.up, b.up);
  EXPECT_NEAR(a.angle, b.angle, 1e-11);
  EXPECT_NEAR(a.height, b.height, 1e-12 * b.height);
  EXPECT_NEAR(a.shift[0], b.shift[0], 1e-12);
  EXPECT_NEAR(a.shift[1], b.shift[1], 1e-12);
  EXPECT_EQ(a.size, b.size);
}

} // namespace

TEST(ViewSize, WhatIsWholeStaysWholeAndComesBack)
{
  Sizes scene;
  for (const char* projection : { "perspective", "parallel" })
  {
    SCOPED_TRACE(projection);
    scene.wide();
    ASSERT_TRUE(scene.isWhole());
    const Look first = lookOf(*scene.view);
    scene.narrow();
    EXPECT_TRUE(scene.isWhole());
    // From each side, and the first view.
    for (int side = 0; side < 6; ++side)
    {
      QTest::keyClick(scene.view, static_cast<Qt::Key>(Qt::Key_1 + side), Qt::ControlModifier);
      EXPECT_TRUE(scene.isWhole()) << side;
    }
    QTest::keyClick(scene.view, Qt::Key_W);
    EXPECT_TRUE(scene.isWhole());
    EXPECT_NEAR(scene.view->camera()->GetZoom(), 1.0, 1e-12);
    for (int i = 0; i < 30; ++i)
    {
      scene.size(800 + 37 * i % 400, 1000 - 53 * i % 400);
    }
    scene.wide();
    expectSame(lookOf(*scene.view), first);
    QTest::keyClick(scene.view, Qt::Key_5);
    scene.settle();
  }
}

TEST(ViewSize, ADockThatIsMadeWiderLeavesTheModelWhole)
{
  Sizes scene;
  scene.size(1000, 900);
  const Look first = lookOf(*scene.view);
  auto* dock = scene.window.findChild<QDockWidget*>("history_dock");
  const int before = dock->width();
  scene.window.resizeDocks({ dock }, { before + 300 }, Qt::Horizontal);
  scene.settle();
  ASSERT_LT(scene.view->width(), 0.7 * scene.view->height());
  EXPECT_TRUE(scene.isWhole());
  scene.window.resizeDocks({ dock }, { before }, Qt::Horizontal);
  scene.settle();
  expectSame(lookOf(*scene.view), first);
}

// A model that is opened in a narrow view is as whole, and as large in a wide one as ever.
TEST(ViewSize, AModelThatIsOpenedInANarrowViewIsWhole)
{
  Sizes scene;
  const Look first = lookOf(*scene.view);
  scene.narrow();
  scene.window.openShippedModel();
  scene.wait();
  EXPECT_TRUE(scene.isWhole());
  scene.wide();
  const Look now = lookOf(*scene.view);
  EXPECT_NEAR(now.position[2], first.position[2], 1e-9 * first.position[2]);
  EXPECT_NEAR(now.angle, first.angle, 1e-11);
}

// What was enlarged under the cursor stays in the middle.
TEST(ViewSize, TheMiddleOfAnEnlargedPictureStays)
{
  Sizes scene;
  scene.zoom({ scene.view->width() * 4 / 5, scene.view->height() / 3 }, 6);
  scene.settle();
  const Look first = lookOf(*scene.view);
  ASSERT_GT(std::abs(first.shift[0]) + std::abs(first.shift[1]), 0.2);
  const auto middle = scene.middle();
  for (const bool narrow : { true, false })
  {
    narrow ? scene.narrow() : scene.size(1200, 700);
    EXPECT_LT((scene.middle() - middle).norm(), 1e-9) << narrow;
  }
  scene.wide();
  expectSame(lookOf(*scene.view), first);
}

TEST(ViewSize, StrokesKeepTheirView)
{
  Sizes scene;
  const Look first = lookOf(*scene.view);
  scene.draw();
  scene.release();
  scene.wait();
  ASSERT_EQ(scene.document->session().nodes.size(), 1u);
  const auto stroke = oversketch_session::linesOf(*scene.document->session().nodes[0].step, "Stroke");
  const auto drawn = oversketch::PenView::of(stroke);
  EXPECT_TRUE(drawn == oversketch::PenView::of(scene.renderer()));
  // Looked at in a narrow window it is all there, and in the first size its view is its own again.
  scene.narrow();
  QTest::keyClick(scene.view, Qt::Key_X);
  scene.view->lookFrom(stroke);
  EXPECT_TRUE(scene.isWhole());
  EXPECT_TRUE(drawn.fromTheSamePlace(oversketch::PenView::of(scene.renderer())));
  EXPECT_TRUE(oversketch::PenView::of(stroke) == drawn);
  scene.wide();
  expectSame(lookOf(*scene.view), first);
  EXPECT_TRUE(drawn == oversketch::PenView::of(scene.renderer()));
}

// A line is given up with the view that it was begun in, and what is turned goes on turning: neither jumps.
TEST(ViewSize, NothingJumpsUnderTheHand)
{
  Sizes scene;
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  const double angle = camera->GetViewAngle();
  const QPoint beside(40, scene.view->height() - 40);
  QTest::mousePress(scene.view, Qt::MiddleButton, Qt::NoModifier, beside);
  moveMouse(scene.view, beside + QPoint(30, 0), Qt::MiddleButton);
  scene.narrow();
  EXPECT_EQ(camera->GetViewAngle(), angle);
  moveMouse(scene.view, beside + QPoint(60, 0), Qt::MiddleButton);
  EXPECT_EQ(camera->GetViewAngle(), angle);
  QTest::mouseRelease(scene.view, Qt::MiddleButton, Qt::NoModifier, beside + QPoint(60, 0));
  EXPECT_GT(camera->GetViewAngle(), 1.2 * angle);
  EXPECT_TRUE(scene.isWhole());
  QTest::keyClick(scene.view, Qt::Key_W);
  scene.draw();
  ASSERT_TRUE(scene.view->tool()->draws());
  scene.wide();
  EXPECT_FALSE(scene.view->tool()->draws());
  EXPECT_NEAR(camera->GetViewAngle(), angle, 1e-11);
  scene.release();
  scene.wait();
  EXPECT_TRUE(scene.document->session().nodes.empty());
}

TEST(ViewSize, ASessionOpensInAnotherSizeAsIfItsWindowHadBeenResized)
{
  const QTemporaryDir folder;
  const QString file = folder.filePath("narrow.oversketch");
  Sizes scene;
  scene.zoom(scene.top(), 3);
  scene.settle();
  const Look wide = lookOf(*scene.view);
  scene.narrow();
  const Look narrow = lookOf(*scene.view);
  EXPECT_GT(narrow.angle, 1.2 * wide.angle);
  scene.document->save(file);
  scene.wide();
  QTest::keyClick(scene.view, Qt::Key_X);
  ASSERT_TRUE(scene.window.open(file));
  scene.wait();
  scene.settle();
  expectSame(lookOf(*scene.view), wide);
  EXPECT_FALSE(scene.window.isWindowModified());
  // A file of a program that kept no size is taken as it stands.
  auto old = oversketch_session::readSession(file.toStdString());
  old.look->size.reset();
  lookAs(*old.look, *scene.view);
  EXPECT_EQ(lookOf(*scene.view).angle, narrow.angle);
}
