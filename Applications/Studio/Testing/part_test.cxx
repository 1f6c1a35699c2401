// A further part of a model: a picture is added, drawn over, and put at its place by the handles of its box.
#include "files.h"
#include "part_drag.h"
#include "picture_files.h"
#include "pieces.h"
#include "sheet.h"
#include "texture.h"

#include "pen_view.h"

#include "vtkOversketchDrawingWidget.h"

#include "vtkCamera.h"
#include "vtkCellData.h"

#include <QProgressDialog>
#include <QPushButton>
#include <QThreadPool>

#include <array>
#include <cmath>
#include <future>
#include <string>

using namespace oversketch_studio;
using oversketch::Vector2;
using oversketch::Vector3;
using oversketch::View;

namespace
{

const PartPlace place{ { 10.0, 20.0, 50.0, 40.0 }, 5.0 };

// A camera at a distance from the box's middle, turned about the upright axis [degrees].
View turnedView(double turn, bool perspective)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetSize(400, 300);
  window->SetOffScreenRendering(1);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(30.0, 30.0, 5.0);
  camera->SetPosition(30.0, 30.0, 105.0);
  camera->Azimuth(turn);
  camera->SetParallelProjection(!perspective);
  camera->SetParallelScale(40.0);
  camera->SetClippingRange(1.0, 500.0);
  return oversketch::PenView::of(renderer).kernelView();
}

std::array<Vector2, 6> handlesOf(const View& view, const PartPlace& of)
{
  std::array<Vector2, 6> seen;
  EXPECT_TRUE(seeHandles(view, of, 50.0, seen));
  return seen;
}

double apart(const PartPlace& a, const PartPlace& b)
{
  double most = std::abs(a.depth - b.depth);
  for (std::size_t i = 0; i < 4; ++i)
  {
    most = std::max(most, std::abs(a.box[i] - b.box[i]));
  }
  return most;
}

// The window with a body over the first picture, and a second picture added.
struct Desk : Sheet
{
  Desk()
  {
    this->open();
    this->line(beast());
    this->choose("Add a pict&ure as a part…", this->file);
  }
  const std::optional<PartPlace>& part() { return this->step(1).part; }
  // Where a handle is, as Qt counts.
  QPoint handle(PartHandle which)
  {
    const auto seen = handlesOf(oversketch::PenView::of(this->renderer()).kernelView(), *this->part());
    const Vector2& at = seen[static_cast<std::size_t>(which)];
    // That of the depth is farther away in the window than handlesOf says.
    const Vector2& middle = seen[4];
    const Vector2 place =
      which == PartHandle::Depth ? Vector2(middle + 56.0 * (at - middle).normalized()) : at;
    return { static_cast<int>(std::lround(place[0])),
      this->view->height() - 1 - static_cast<int>(std::lround(place[1])) };
  }
  void drag(PartHandle which, const QPoint& by, bool release = true)
  {
    this->pictureAtRest(); // the handles are where the last frame showed them
    const QPoint from = this->handle(which);
    moveMouse(this->view, from, Qt::NoButton);
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, from);
    sweepMouse(this->view, 1, 10, [&](int i) { return from + by * i / 10; });
    if (release)
    {
      QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, from + by);
    }
    this->settle();
  }
};

} // namespace

TEST(PartDrag, TheMiddleFollowsTheHandInItsPlane)
{
  for (const bool perspective : { false, true })
  {
    for (const double turn : { 0.0, 40.0, -60.0 })
    {
      const View view = turnedView(turn, perspective);
      const Vector2 from = handlesOf(view, place)[4], by(33.0, -21.0);
      const PartPlace moved = dragged(view, place, PartHandle::Middle, from, from + by, false);
      EXPECT_LT((handlesOf(view, moved)[4] - from - by).norm(), 1e-6) << turn;
      EXPECT_EQ(moved.depth, place.depth);
      EXPECT_NEAR(moved.box[2] - moved.box[0], 40.0, 1e-9);
      EXPECT_NEAR(moved.box[3] - moved.box[1], 20.0, 1e-9);
    }
  }
  // Seen from the side its plane is a line: it stays.
  const View side = turnedView(90.0, false);
  const Vector2 from = handlesOf(side, place)[4];
  EXPECT_LT(apart(dragged(side, place, PartHandle::Middle, from, from + Vector2(30, 0), false), place), 1e-9);
}

TEST(PartDrag, ACornerKeepsTheOppositeOne)
{
  const View view = turnedView(30.0, true);
  for (int corner = 0; corner < 4; ++corner)
  {
    const auto handle = static_cast<PartHandle>(corner);
    const auto before = handlesOf(view, place);
    const auto at = static_cast<std::size_t>(corner), opposite = (at + 2) % 4;
    const Vector2& from = before[at];
    const Vector2 to = from + 0.3 * (from - before[opposite]) + Vector2(4.0, -3.0);
    const PartPlace free = dragged(view, place, handle, from, to, true);
    EXPECT_LT((handlesOf(view, free)[at] - to).norm(), 1e-6) << corner;
    EXPECT_LT((handlesOf(view, free)[opposite] - before[opposite]).norm(), 1e-6) << corner;
    const PartPlace kept = dragged(view, place, handle, from, to, false);
    EXPECT_NEAR((kept.box[2] - kept.box[0]) / (kept.box[3] - kept.box[1]), 2.0, 1e-9);
    EXPECT_LT((handlesOf(view, kept)[opposite] - before[opposite]).norm(), 1e-6) << corner;
    EXPECT_GT(kept.box[2] - kept.box[0], 40.0);
    // Through the opposite corner and far beyond: small, and not turned over.
    const PartPlace small =
      dragged(view, place, handle, from, from + 5.0 * (before[opposite] - from), corner % 2 == 0);
    EXPECT_GT(small.box[2] - small.box[0], 0.0);
    EXPECT_LT(small.box[2] - small.box[0], 2.0);
    EXPECT_GT(small.box[3] - small.box[1], 0.0);
  }
}

TEST(PartDrag, TheDepthFollowsAlongItsAxis)
{
  for (const bool perspective : { false, true })
  {
    for (const double turn : { 25.0, 90.0, -70.0 })
    {
      const View view = turnedView(turn, perspective);
      const auto before = handlesOf(view, place);
      const Vector2 direction = (before[5] - before[4]).normalized();
      const PartPlace moved =
        dragged(view, place, PartHandle::Depth, before[5], before[5] + 20.0 * direction, false);
      EXPECT_GT(moved.depth, place.depth) << turn;
      EXPECT_EQ(moved.box, place.box);
      const PartPlace back =
        dragged(view, place, PartHandle::Depth, before[5], before[5] - 20.0 * direction, false);
      EXPECT_LT(back.depth, place.depth) << turn;
      if (!perspective)
      {
        // The middle goes as far as the hand.
        EXPECT_LT((handlesOf(view, moved)[4] - before[4] - 20.0 * direction).norm(), 1e-6) << turn;
      }
    }
  }
  // Along the axis itself: so many px, so many world units.
  const View front = turnedView(0.0, false);
  const auto seen = handlesOf(front, place);
  const Vector2 away = seen[5] - seen[4];
  EXPECT_NEAR(away.norm(), 50.0, 1e-9);
  const PartPlace moved =
    dragged(front, place, PartHandle::Depth, seen[5], seen[5] + 10.0 * away.normalized(), false);
  EXPECT_NEAR(moved.depth - place.depth, 10.0 * 80.0 / 300.0, 1e-9);
}

TEST(PartDrag, NothingLeavesTheWorld)
{
  PartPlace far = place;
  far.box = { 1e9 - 40.0, 0.0, 1e9, 20.0 };
  const View view = turnedView(0.0, false);
  const PartPlace moved = dragged(view, far, PartHandle::Middle, { 0, 0 }, { 300, 0 }, false);
  EXPECT_TRUE(moved == far);
  std::array<Vector2, 6> seen;
  EXPECT_FALSE(seeHandles(turnedView(0.0, true), { place.box, 1000.0 }, 50.0, seen))
    << "it is behind the eye";
}

TEST(Part, ASecondPictureIsAPartOfTheModel)
{
  Desk desk;
  ASSERT_EQ(desk.session().nodes.size(), 2u);
  ASSERT_TRUE(desk.part());
  EXPECT_FALSE(desk.step(0).part);
  const std::string alone = desk.document->digest();
  EXPECT_EQ(desk.pad->widget()->GetDrawing()->GetNumberOfLines(), 0) << "the first picture is still drawn on";
  EXPECT_EQ(desk.list->currentRow(), 2) << "the new row is not selected";
  // Its size, on the middle of the model.
  double box[6];
  desk.mesh()->GetBounds(box);
  EXPECT_NEAR(desk.part()->box[2] - desk.part()->box[0], width, 1e-9);
  EXPECT_NEAR(desk.part()->box[3] - desk.part()->box[1], height, 1e-9);
  // Where the surface is seen there, not before its foremost point.
  const double middle[2] = { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]) };
  double nearest = 1e9, surface = 0.0;
  for (vtkIdType i = 0; i < desk.mesh()->GetNumberOfPoints(); ++i)
  {
    const double* p = desk.mesh()->GetPoint(i);
    const double far = std::hypot(p[0] - middle[0], p[1] - middle[1]);
    if (p[2] > 0.0 && far < nearest)
    {
      nearest = far;
      surface = p[2];
    }
  }
  EXPECT_NEAR(desk.part()->depth, surface, 1.5 * nearest) << "a point " << nearest << " px beside";
  EXPECT_NEAR(desk.part()->box[0] + desk.part()->box[2], box[0] + box[1], 1e-9);

  desk.line(ring({ 200, 150 }, 60));
  EXPECT_EQ(desk.failure(1), "");
  const std::string both = desk.document->digest();
  EXPECT_NE(both, alone);
  EXPECT_EQ(eulerOf(desk.mesh()), 4) << "two closed surfaces";
  EXPECT_EQ(openEdges(desk.mesh()), 0);
  EXPECT_EQ(oversketch_files::piecesOf(desk.mesh()).size(), 2u);
  EXPECT_EQ(replayed(desk.session()), both);
  // Rows choose what is drawn on.
  desk.list->setCurrentRow(0);
  EXPECT_EQ(desk.pad->widget()->GetDrawing()->GetNumberOfPoints(),
    linesOf(desk.step(0), "Strokes")->GetNumberOfPoints());
  desk.line(ring({ 240, 185 }, 28));
  desk.click({ 240, 185 });
  EXPECT_EQ(strokesOf(linesOf(desk.step(0), "Strokes")).size(), 2u);
  EXPECT_EQ(strokesOf(linesOf(desk.step(1), "Strokes")).size(), 1u);
  EXPECT_EQ(eulerOf(desk.mesh()), 2) << "a torus and a ball";
}

TEST(Part, ItsHandlesPutItElsewhereAndOneDragIsOneStepOfUndo)
{
  Desk desk;
  desk.line(ring({ 200, 150 }, 60));
  const std::string before = desk.document->digest();
  const PartPlace first = *desk.part();

  desk.drag(PartHandle::Middle, { 60, -40 });
  const PartPlace moved = *desk.part();
  EXPECT_GT(moved.box[0], first.box[0]);
  EXPECT_GT(moved.box[1], first.box[1]) << "up on the screen is up in the world";
  EXPECT_EQ(moved.depth, first.depth);
  const std::string digest = desk.document->digest();
  EXPECT_EQ(replayed(desk.session()), digest);

  desk.drag(PartHandle::RightTop, { -30, 25 });
  const PartPlace smaller = *desk.part();
  EXPECT_EQ(smaller.box[0], moved.box[0]);
  EXPECT_EQ(smaller.box[1], moved.box[1]);
  EXPECT_LT(smaller.box[2], moved.box[2]);
  EXPECT_NEAR(
    (smaller.box[2] - smaller.box[0]) / (smaller.box[3] - smaller.box[1]), double(width) / height, 1e-9);

  desk.drag(PartHandle::Depth, { -30, 30 }); // from the front, nearer is down and to the left
  const PartPlace nearer = *desk.part();
  EXPECT_GT(nearer.depth, smaller.depth);
  EXPECT_EQ(nearer.box, smaller.box);
  const std::string last = desk.document->digest();
  EXPECT_EQ(replayed(desk.session()), last);
  // Its rim lies at its depth.
  const auto pieces = oversketch_files::piecesOf(desk.mesh());
  ASSERT_EQ(pieces.size(), 2u);
  double box[6];
  pieces[1].mesh->GetBounds(box);
  EXPECT_NEAR(0.5 * (box[4] + box[5]), nearer.depth, 1e-6);

  for (const PartPlace& place : { smaller, moved, first })
  {
    desk.document->undo();
    desk.settle();
    EXPECT_TRUE(*desk.part() == place);
  }
  EXPECT_EQ(desk.document->digest(), before);
  for (int i = 0; i < 3; ++i)
  {
    desk.document->redo();
    desk.settle();
  }
  EXPECT_EQ(desk.document->digest(), last);

  // Escape gives a drag up.
  desk.drag(PartHandle::Middle, { 20, 20 }, false);
  EXPECT_FALSE(*desk.part() == nearer);
  QTest::keyClick(desk.view, Qt::Key_Escape);
  desk.settle();
  EXPECT_TRUE(*desk.part() == nearer);
  QTest::mouseRelease(desk.view, Qt::LeftButton);
  desk.settle();
  EXPECT_EQ(desk.document->digest(), last);
  // Beside the handles the camera is turned, and nothing is moved.
  const double* position = desk.renderer()->GetActiveCamera()->GetPosition();
  const Vector3 stood(position);
  const QPoint from = desk.handle(PartHandle::Middle) + QPoint(20, 20);
  QTest::mousePress(desk.view, Qt::LeftButton, Qt::NoModifier, from);
  for (int i = 1; i <= 10; ++i)
  {
    moveMouse(desk.view, from + QPoint(8 * i, 0));
  }
  QTest::mouseRelease(desk.view, Qt::LeftButton, Qt::NoModifier, from + QPoint(80, 0));
  desk.settle();
  EXPECT_GT((Vector3(desk.renderer()->GetActiveCamera()->GetPosition()) - stood).norm(), 1.0);
  EXPECT_TRUE(*desk.part() == nearer);
  // From aside the depth goes along its axis.
  desk.drag(PartHandle::Depth, 2 * (desk.handle(PartHandle::Depth) - desk.handle(PartHandle::Middle)) / 3);
  EXPECT_GT(desk.part()->depth, nearer.depth);
  EXPECT_EQ(desk.part()->box, nearer.box);
}

TEST(Part, ItsBoxGoesWithTheTool)
{
  Desk desk;
  desk.line(ring({ 200, 150 }, 60));
  const auto orange = [&]
  {
    return count(desk.pictureAtRest(),
      [](const QColor& c) { return c.red() > 230 && std::abs(c.green() - 158) < 12 && c.blue() < 80; });
  };
  EXPECT_GT(orange(), 40) << "no handle";
  for (const Qt::Key other : { Qt::Key_7, Qt::Key_D, Qt::Key_B })
  {
    QTest::keyClick(desk.view, other);
    desk.settle();
    EXPECT_LT(orange(), 10) << static_cast<char>(other);
    QTest::keyClick(desk.view, Qt::Key_G);
    desk.settle();
    EXPECT_GT(orange(), 40) << "gone for good";
  }
}

// Wherever the model is seen from.
TEST(Part, ItIsNoLargerThanTheModel)
{
  Sheet sheet;
  const QString photo = sheet.folder.filePath("photo.png");
  QImage large(3200, 2400, QImage::Format_RGB32);
  large.fill(Qt::white);
  ASSERT_TRUE(large.save(photo));
  QApplication::setActiveWindow(&sheet.window);
  QTest::keyClick(sheet.view, Qt::Key_3, Qt::ControlModifier);
  sheet.settle();
  // A model that was opened, in units of its own.
  double box[6];
  sheet.mesh()->GetBounds(box);
  const double side = std::max(box[1] - box[0], box[3] - box[2]), deep = box[5] - box[4];
  sheet.choose("Add a pict&ure as a part…", sheet.file);
  ASSERT_EQ(sheet.session().nodes.size(), 1u);
  const PartPlace opened = *sheet.step(0).part;
  EXPECT_NEAR(opened.box[2] - opened.box[0], side, 1e-9 * side);
  EXPECT_NEAR(opened.box[3] - opened.box[1], side * height / width, 1e-9 * side);
  EXPECT_NEAR(opened.box[0] + opened.box[2], box[0] + box[1], 1e-9 * side);
  sheet.line(ring({ 200, 150 }, 60));
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_EQ(oversketch_files::partsOf(sheet.mesh()).size(), 2u);
  sheet.mesh()->GetBounds(box);
  EXPECT_LT(box[5] - box[4], deep + side);
  EXPECT_LT(box[3] - box[2], 1.5 * side);
  // Over a picture of more pixels than the first one; and of fewer, which are counted as the first one's.
  QTest::keyClick(sheet.view, Qt::Key_Z, Qt::ControlModifier);
  QTest::keyClick(sheet.view, Qt::Key_Z, Qt::ControlModifier);
  sheet.settle();
  sheet.open();
  sheet.line(beast());
  sheet.choose("Add a pict&ure as a part…", photo);
  ASSERT_EQ(sheet.session().nodes.size(), 2u);
  const PartPlace drawn = *sheet.step(1).part;
  EXPECT_NEAR(drawn.box[2] - drawn.box[0], width, 1e-9);
  EXPECT_NEAR(drawn.box[3] - drawn.box[1], height, 1e-9);
  ASSERT_TRUE(large.scaled(80, 60).save(photo));
  sheet.choose("Add a pict&ure as a part…", photo);
  const PartPlace small = *sheet.step(2).part;
  EXPECT_NEAR(small.box[2] - small.box[0], 80.0, 1e-9);
}

TEST(Part, WhatIsNoPictureIsSaidAndAddsNothing)
{
  Sheet sheet;
  sheet.open();
  sheet.line(beast());
  EXPECT_THROW(sheet.document->partReader(OVERSKETCH_DATA_FOLDER "/Models/dog.ply")(), std::exception);
  EXPECT_THROW(sheet.document->partReader("/nowhere.png")(), std::exception);
  EXPECT_EQ(sheet.session().nodes.size(), 1u);
}

TEST(Part, APictureThatIsTakenUpLaterIsReadWithAWordAndCanBeGivenUp)
{
  Sheet sheet;
  sheet.open();
  sheet.line(beast());
  // Of a part that nothing is drawn over yet: no model wears it.
  const QString path = sheet.folder.filePath("other.png");
  QImage other(width, height, QImage::Format_RGB32);
  other.fill(Qt::magenta);
  ASSERT_TRUE(other.save(path));
  const std::string bytes = oversketch_files::wholeFile(path.toStdString());
  sheet.document->add(*sheet.document->partReader(path)().step);
  sheet.settle();
  EXPECT_FALSE(findDecoded(bytes));
  auto* pool = QThreadPool::globalInstance();
  const int threads = pool->maxThreadCount();
  pool->setMaxThreadCount(1);
  std::promise<void> go;
  pool->start([mayGo = go.get_future().share()] { mayGo.wait(); });
  bool given = false;
  QTimer timer;
  QObject::connect(&timer,
    &QTimer::timeout,
    [&given]
    {
      auto* dialog = qobject_cast<QProgressDialog*>(QApplication::activeModalWidget());
      if (dialog && !given)
      {
        given = true;
        EXPECT_TRUE(dialog->labelText().startsWith("Reading other.png")) << qPrintable(dialog->labelText());
        QTest::mouseClick(dialog->findChild<QPushButton*>(), Qt::LeftButton);
      }
    });
  timer.start(50);
  sheet.list->setCurrentRow(2);
  ASSERT_TRUE(QTest::qWaitFor([&] { return given; }, 60000));
  sheet.settle();
  EXPECT_FALSE(sheet.pad->isEnabled()) << "drawn on what is not seen";
  EXPECT_EQ(sheet.advice->text(), "The picture under this drawing has not been read. G reads it.");
  go.set_value();
  pool->waitForDone();
  pool->setMaxThreadCount(threads);
  timer.stop();
  EXPECT_FALSE(findDecoded(bytes)) << "kept for ever";
  QApplication::setActiveWindow(&sheet.window); // no longer the one that asked
  QTest::keyClick(sheet.view, Qt::Key_G);
  ASSERT_TRUE(QTest::qWaitFor([&] { return sheet.pad->isEnabled(); }, 60000));
  // The other drawing's is read as well.
  sheet.list->setCurrentRow(0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return sheet.pad->isEnabled(); }, 60000));
  sheet.list->setCurrentRow(2);
  ASSERT_TRUE(QTest::qWaitFor([&] { return sheet.pad->isEnabled(); }, 60000));
  sheet.settle();
  EXPECT_TRUE(findDecoded(bytes));
  sheet.line(ring({ 200, 150 }, 60));
  EXPECT_EQ(sheet.document->result().nodes.at(1).failure, "");
  EXPECT_EQ(oversketch_files::partsOf(sheet.mesh()).size(), 2u);
}
