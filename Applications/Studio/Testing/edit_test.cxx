// The tools Direct, Profile and Shade, as a person uses them.
#include "Harness/polydata.h"
#include "edits.h"

#include "vtkOversketchAxisHandleRepresentation.h"

#include "vtkCamera.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkStaticCellLocator.h"

#include <QAction>
#include <QDockWidget>
#include <QSpinBox>
#include <QToolButton>
#include <QVTKOpenGLNativeWidget.h>

#include <cmath>
#include <vector>

using namespace oversketch_studio;
using namespace oversketch_session;

TEST(Edit, AllOfItIsUndoneAndRedone)
{
  Edits scene;
  const std::string bare = scene.digest();
  scene.drawBoth();
  EXPECT_EQ(scene.digest(), bare) << "a region alone moves something";
  std::vector<std::string> made{ bare };
  const auto isAnother = [&](const char* what)
  {
    EXPECT_EQ(scene.failures(), "") << what << ": " << scene.said();
    EXPECT_NE(scene.digest(), made.back()) << what << ": " << scene.said();
    made.push_back(scene.digest());
  };
  scene.shot("region");

  // The line is dragged: the region follows, and the last preview is the result without new triangles.
  const Way pull = Edits::straight(scene.middle, scene.middle - QPoint(0, 25));
  scene.drag(scene.view, pull, Qt::NoModifier, false);
  scene.shot("line_dragged");
  vtkNew<vtkPolyData> preview;
  preview->DeepCopy(scene.shown());
  scene.letGo(scene.view, pull.back());
  isAnother("the line dragged");
  EXPECT_NE(scene.text(0, "Operations").find("move"), std::string::npos);
  EXPECT_EQ(digestOf(preview), replayed(scene.document->session(), ruleOff));
  EXPECT_EQ(scene.digest(), replayed(scene.document->session()));
  EXPECT_EQ(scene.nodes().size(), 1u);

  // An axis of its handle: the same one changes its row, another one makes one.
  const auto rows = [&]
  {
    const std::string all = scene.text(0, "Operations");
    return std::count(all.begin(), all.end(), ';') + 1;
  };
  scene.shot("axes");
  using Axes = vtkOversketchAxisHandleRepresentation;
  for (const int axis : { scene.axisSeen(), scene.axisSeen(), scene.axisSeen(true) })
  {
    ASSERT_GE(axis, 0);
    const auto before = rows();
    const bool isThere = scene.text(0, "Operations").find(std::string("scale ")) != std::string::npos;
    const QPoint from = scene.placeOn(axis, Axes::Scale);
    scene.drag(Edits::straight(from, from + (from - scene.placeOn(axis, Axes::Move)) / 2));
    isAnother("an axis dragged");
    const bool isOther = axis != scene.lastAxis;
    EXPECT_EQ(rows(), before + (isOther || !isThere)) << scene.text(0, "Operations");
    scene.lastAxis = axis;
  }
  const auto before = rows();
  scene.press(Qt::Key_Escape); // no handle is selected

  // The ring redrawn in part, with Shift: its upper right.
  scene.drag(Edits::ring(scene.middle, 88.0, 48.0, -0.2 * M_PI, 0.2 * M_PI), Qt::ShiftModifier);
  isAnother("the ring redrawn");
  EXPECT_EQ(linesOf(scene.step(0), "Boundary")->GetNumberOfLines(), 2) << scene.said();
  EXPECT_EQ(rows(), before);
  scene.shot("ring_redrawn");

  // A layer, on the disc: gone, and back.
  scene.press(Qt::Key_S);
  QWidget* disc = scene.dockPicture("disc_picture");
  ASSERT_TRUE(disc && disc->isVisible());
  scene.shot("shade");
  const QPoint centre = disc->rect().center(), out = centre + QPoint(0, disc->height() * 3 / 10);
  scene.drag(disc, Edits::straight(out, centre), Qt::NoModifier, false);
  scene.shot("layer_dragged");
  preview->DeepCopy(scene.shown());
  scene.letGo(disc, centre);
  isAnother("a layer gone");
  EXPECT_EQ(digestOf(preview), replayed(scene.document->session(), ruleOff));
  const std::string gone = scene.text(0, "Layers");
  EXPECT_NE(gone, "");
  scene.drag(disc, Edits::straight(centre, out));
  EXPECT_NE(scene.text(0, "Layers"), gone);
  isAnother("a layer back");
  EXPECT_EQ(scene.digest(), made[made.size() - 3])
    << "it is not back where it was: " << scene.text(0, "Layers");

  // A lasso on the model, and a layer of what it holds.
  auto* lasso = scene.window.findChild<QToolButton*>("disc_lasso");
  ASSERT_TRUE(lasso->isEnabled());
  const auto greens = [&]
  {
    const QImage seen = scene.pictureAtRest();
    int count = 0;
    for (int y = 0; y < seen.height(); ++y)
    {
      for (int x = 0; x < seen.width(); ++x)
      {
        const QColor pixel = seen.pixelColor(x, y);
        count += pixel.green() > pixel.red() + 60 && pixel.green() > pixel.blue() + 40;
      }
    }
    return count;
  };
  EXPECT_EQ(greens(), 0);
  lasso->click();
  scene.drag(Edits::ring(scene.middle + QPoint(30, 10), 20.0, 14.0));
  ASSERT_EQ(linesOf(scene.step(0), "Areas")->GetNumberOfLines(), 1) << scene.said();
  EXPECT_FALSE(lasso->isChecked());
  EXPECT_GT(greens(), 100) << "the lasso is seen on the disc alone";
  scene.shot("lasso");
  made.push_back(scene.digest());
  scene.drag(Edits::straight(scene.middle + QPoint(30, 14), scene.middle + QPoint(30, 22)));
  EXPECT_NE(scene.text(0, "Layers").find("area 0"), std::string::npos) << scene.text(0, "Layers");
  isAnother("a layer of the lasso's area");
  scene.shot("area_layers");

  // A profile is a step of its own, of the same line and ring where the first has left them.
  scene.press(Qt::Key_A);
  QWidget* profile = scene.dockPicture("profile_picture");
  ASSERT_TRUE(profile && profile->isVisible());
  EXPECT_FALSE(disc->isVisible());
  scene.shot("profile");
  ASSERT_EQ(scene.nodes().size(), 1u) << "a tool alone makes a step";
  const int w = profile->width(), h = profile->height();
  scene.drawProfile();
  ASSERT_EQ(scene.nodes().size(), 2u) << scene.said();
  EXPECT_TRUE(std::holds_alternative<StepOutput>(scene.step(1).inputs.at("Reference")));
  isAnother("a profile");
  scene.shot("profile_drawn");
  const vtkIdType strokes = linesOf(scene.step(1), "Profile")->GetNumberOfLines();
  scene.drag(profile, Edits::straight({ w * 4 / 10, h / 4 }, { w * 6 / 10, h / 4 }));
  EXPECT_EQ(linesOf(scene.step(1), "Profile")->GetNumberOfLines(), strokes + 1);
  isAnother("the profile redrawn");
  // One that crosses itself is taken back, and why is said.
  Way loop;
  const QPoint corners[] = {
    { w * 3 / 10, h / 2 }, { w * 6 / 10, h * 3 / 10 }, { w * 4 / 10, h * 3 / 10 }, { w * 7 / 10, h / 2 }
  };
  for (int i = 0; i < 3; ++i)
  {
    const Way side = Edits::straight(corners[i], corners[i + 1]);
    loop.insert(loop.end(), side.begin(), side.end());
  }
  scene.drag(profile, loop);
  EXPECT_EQ(linesOf(scene.step(1), "Profile")->GetNumberOfLines(), strokes + 1);
  EXPECT_EQ(scene.digest(), made.back());
  EXPECT_TRUE(scene.said().find("crosses itself") != std::string::npos) << scene.said();
  EXPECT_TRUE(scene.said().find("taken back") != std::string::npos) << scene.said();

  EXPECT_EQ(scene.digest(), replayed(scene.document->session()));

  // Undone and redone, each with the same bits.
  int steps = 0;
  for (; scene.document->canUndo(); ++steps)
  {
    scene.press(Qt::Key_Z, Qt::ControlModifier);
  }
  EXPECT_EQ(scene.digest(), bare);
  EXPECT_TRUE(scene.nodes().empty());
  EXPECT_GE(steps, 9);
  for (; steps > 0; --steps)
  {
    scene.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  }
  EXPECT_EQ(scene.digest(), made.back());
}

// What moves is made with the same bits as if it had been drawn at once, and made once.
TEST(Edit, ARegionAloneMovesNothing)
{
  Edits scene;
  QStringList stages; // that the history's thread goes through
  QObject::connect(scene.document,
    &Document::progressed,
    &scene.window,
    [&stages](int, const QString& stage, double) { stages << stage; });
  const std::string bare = scene.digest();
  scene.drawBoth();
  scene.drag(Edits::ring(scene.middle, 88.0, 48.0, -0.2 * M_PI, 0.2 * M_PI), Qt::ShiftModifier);
  ASSERT_EQ(linesOf(scene.step(0), "Boundary")->GetNumberOfLines(), 2) << scene.said();
  EXPECT_EQ(scene.failures(), "");
  EXPECT_EQ(scene.digest(), bare);
  const auto& node = scene.document->result().nodes[0];
  ASSERT_TRUE(node.section && node.hold && node.region && node.before);
  const std::string once = replayed(scene.document->session());
  EXPECT_EQ(scene.digest(), once);
  stages.clear();
  scene.drag(Edits::straight(scene.middle, scene.middle - QPoint(0, 25)));
  EXPECT_FALSE(stages.isEmpty());
  const std::string moved = scene.digest();
  EXPECT_NE(moved, bare);
  EXPECT_EQ(moved, replayed(scene.document->session()));
  stages.clear();
  scene.press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene.digest(), once);
  scene.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(scene.digest(), moved);
  EXPECT_EQ(stages.join(", ").toStdString(), "");
}

TEST(Edit, ThePlaneSlidesAndAnAxisIsDragged)
{
  Edits scene(Qt::Key_A);
  scene.drawBoth();
  scene.drawProfile();
  ASSERT_EQ(scene.nodes().size(), 1u);
  ASSERT_TRUE(scene.step(0).inputs.count("Profile")) << scene.said();
  const std::string first = scene.digest();
  scene.shot("profile_first");
  // The section is where the middle of the line is.
  const Way slide = Edits::straight(scene.middle + QPoint(0, 15), scene.middle + QPoint(22, 15));
  scene.drag(scene.view, slide, Qt::NoModifier, false);
  scene.shot("plane_slid");
  vtkNew<vtkPolyData> preview;
  preview->DeepCopy(scene.shown());
  scene.letGo(scene.view, slide.back());
  ASSERT_TRUE(scene.step(0).values.count("ProfileAt")) << "the plane does not slide";
  EXPECT_NE(scene.digest(), first);
  EXPECT_EQ(digestOf(preview), replayed(scene.document->session(), ruleOff));
  EXPECT_EQ(scene.digest(), replayed(scene.document->session()));

  // E on the same region: operations are another step.
  scene.press(Qt::Key_E);
  scene.drag(Edits::straight(scene.middle, scene.middle + QPoint(0, 12)));
  ASSERT_EQ(scene.nodes().size(), 2u) << scene.said();
  EXPECT_EQ(scene.failures(), "");
  EXPECT_EQ(scene.digest(), replayed(scene.document->session()));
}

TEST(Edit, ABadHandIsToldWhatAndHow)
{
  Edits scene;
  const std::string bare = scene.digest();
  // In the void.
  scene.drag(Edits::straight({ 20, 20 }, { 90, 25 }));
  EXPECT_EQ(scene.nodes().size(), 0u);
  EXPECT_NE(scene.said().find("taken back"), std::string::npos) << scene.said();
  scene.shot("void");
  // Too short.
  scene.drag(Edits::straight(scene.middle, scene.middle + QPoint(2, 0), 2));
  EXPECT_NE(scene.said().find("taken back"), std::string::npos) << scene.said();
  // A ring that does not hold the line.
  scene.drawLine();
  EXPECT_NE(scene.said().find("ring"), std::string::npos) << scene.said();
  scene.drag(Edits::ring(scene.middle + QPoint(10, 0), 15.0, 15.0));
  EXPECT_NE(scene.said().find("taken back"), std::string::npos) << scene.said();
  EXPECT_EQ(
    scene.said(), "The line is not all inside the ring. It is taken back: draw a ring round the whole line.");
  scene.shot("bad_ring");
  EXPECT_EQ(scene.nodes().size(), 0u);
  EXPECT_EQ(scene.digest(), bare);
  // The line is still there: a ring mends it.
  scene.drawRing();
  ASSERT_EQ(scene.nodes().size(), 1u) << scene.said();
  EXPECT_EQ(scene.failures(), "");
  // A stroke with Shift that is over neither.
  scene.drag(
    Edits::straight(scene.middle + QPoint(120, 80), scene.middle + QPoint(160, 90)), Qt::ShiftModifier);
  EXPECT_NE(scene.said().find("Neither line nor ring"), std::string::npos) << scene.said();
  // Return is done with it: the next line begins there.
  scene.press(Qt::Key_Return);
  scene.drawLine();
  scene.drawRing(60.0, 35.0);
  ASSERT_EQ(scene.nodes().size(), 2u) << scene.said();

  // On both sides of a plane: both follow the hand, and the result is where they were.
  const MirrorPlane plane = *scene.document->mirrorPlane(3); // which the model's two sides are alike about
  scene.document->setParameters(1, scene.step(1).values, plane);
  scene.settle();
  ASSERT_EQ(scene.failures(), "");
  const Way pull = Edits::straight(scene.middle, scene.middle - QPoint(0, 20));
  scene.drag(scene.view, { pull.front(), pull[1] }, Qt::NoModifier, false);
  vtkNew<vtkPolyData> begun;
  begun->DeepCopy(scene.shown());
  for (const QPoint& at : pull)
  {
    scene.send(scene.view, QEvent::MouseMove, at, Qt::NoModifier);
  }
  scene.shot("both_sides");
  vtkNew<vtkPolyData> preview;
  preview->DeepCopy(scene.shown());
  ASSERT_EQ(preview->GetNumberOfPoints(), begun->GetNumberOfPoints());
  scene.letGo(scene.view, pull.back());
  EXPECT_EQ(scene.failures(), "");
  ASSERT_TRUE(scene.step(1).mirror) << "the hand has forgotten the plane";
  EXPECT_EQ(scene.digest(), replayed(scene.document->session()));
  vtkNew<vtkStaticCellLocator> result;
  result->SetDataSet(scene.document->result().mesh);
  result->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  double way[2] = { 0.0, 0.0 }, off[2] = { 0.0, 0.0 };
  int moved[2] = { 0, 0 };
  for (vtkIdType i = 0; i < preview->GetNumberOfPoints(); ++i)
  {
    double from[3], to[3], nearest[3], squared = 0.0;
    begun->GetPoint(i, from);
    preview->GetPoint(i, to);
    const double length = std::sqrt(vtkMath::Distance2BetweenPoints(from, to));
    if (length > 0.0)
    {
      vtkIdType id = -1;
      int part = 0;
      result->FindClosestPoint(to, nearest, cell, id, part, squared);
      const int side = from[plane.axis] > plane.offset ? 1 : 0;
      ++moved[side];
      way[side] = std::max(way[side], length);
      off[side] += std::sqrt(squared);
    }
  }
  for (const int side : { 0, 1 })
  {
    EXPECT_GT(moved[side], 20) << side;
    EXPECT_LT(off[side] / moved[side], 0.1 * way[side]) << side;
  }
  EXPECT_NEAR(way[0], way[1], 0.2 * std::max(way[0], way[1]));
}

TEST(Edit, KeysOfADockAreTheCanvass)
{
  Edits scene(Qt::Key_S);
  scene.drawBoth();
  auto* dock = scene.window.findChild<QDockWidget*>("shade_dock");
  ASSERT_TRUE(dock && dock->isVisible());
  dock->setFloating(true);
  QApplication::processEvents();
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  const double before = camera->GetPosition()[0];
  QTest::keyClick(dock, Qt::Key_J);
  QApplication::processEvents();
  EXPECT_NE(camera->GetPosition()[0], before) << "a key over a dock that floats is lost";
  EXPECT_EQ(scene.dockPicture("disc_picture")->focusPolicy(), Qt::NoFocus);
  auto* levels = scene.window.findChild<QSpinBox*>("disc_levels");
  levels->setValue(9);
  scene.settle();
  EXPECT_EQ(std::get<int>(scene.step(0).values.at("Levels")), 9);
  EXPECT_EQ(scene.failures(), "");
  dock->setFloating(false);
  // It is as dark as the rest of the window.
  const auto paper = [&]
  {
    auto* picture = static_cast<QVTKOpenGLNativeWidget*>(scene.dockPicture("disc_picture"));
    return picture->renderWindow()->GetRenderers()->GetFirstRenderer()->GetBackground()[0];
  };
  const double dark = paper();
  for (QAction* action : scene.window.findChildren<QAction*>())
  {
    if (action->text() == "&Dark")
    {
      action->trigger();
    }
  }
  EXPECT_GT(paper(), dark);
  scene.shot("light");
}
