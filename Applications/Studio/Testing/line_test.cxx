// The tool Line on surface, as a person uses it.
#include "augment_options.h"
#include "evaluator.h"
#include "files.h"
#include "profile_editor.h"
#include "scene.h"
#include "step_panel.h"
#include "tool.h"

#include "vtkCamera.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMessageBox>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <set>

using namespace oversketch_studio;
using oversketch_session::Step;
using oversketch_session::Values;

namespace
{

bool isOrange(const QColor& c)
{
  return c.red() > 220 && c.green() > 120 && c.green() < 190 && c.blue() < 110;
}

struct LineScene : Scene
{
  LineScene()
  {
    QApplication::setActiveWindow(&this->window);
    QTest::keyClick(this->view, Qt::Key_B);
  }

  // Along the middle of the model's body, the pen left down at its end.
  void drawOn(int up = 0)
  {
    this->settle();
    const QPoint from = this->seen(this->document->result().mesh->GetCenter()) - QPoint(60, up);
    const auto at = [&](int i)
    { return from + QPoint(4 * i, static_cast<int>(std::lround(8.0 * std::sin(0.3 * i)))); };
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, at(0));
    sweepMouse(this->view, 1, 30, at);
    this->end = at(30);
  }
  void line(int up = 0)
  {
    this->drawOn(up);
    this->release();
    this->wait();
  }
  // A notch each 20 ms, the first so long after the last one before.
  void wheel(int notches, Qt::KeyboardModifiers modifiers, ulong rest = 20)
  {
    for (int i = 0; i < std::abs(notches); ++i)
    {
      const QPoint at(10, 10);
      QWheelEvent turn(at,
        this->view->mapToGlobal(at),
        {},
        { 0, notches > 0 ? 120 : -120 },
        Qt::NoButton,
        modifiers,
        Qt::NoScrollPhase,
        false);
      this->time += i == 0 ? rest : 20;
      turn.setTimestamp(this->time);
      QApplication::sendEvent(this->view, &turn);
    }
    QApplication::processEvents();
  }
  const Step& step(int node) { return *this->document->session().nodes[indexOf(node)].step; }
  double number(int node, const char* name) { return std::get<double>(this->step(node).values.at(name)); }
  std::string text(int node, const char* name)
  {
    return std::get<std::string>(this->step(node).values.at(name));
  }
  double diagonal() { return this->document->session().mesh->GetLength(); }
  std::string failures()
  {
    std::string all;
    for (const auto& node : this->document->result().nodes)
    {
      all += node.failure.text();
    }
    return all;
  }
  int orange() { return orangeIn(this->view->grabFramebuffer()); }
  static int orangeIn(const QImage& image)
  {
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
    {
      for (int x = 0; x < image.width(); ++x)
      {
        found += isOrange(image.pixelColor(x, y));
      }
    }
    return found;
  }
  vtkIdType triangles() { return this->document->result().mesh->GetNumberOfPolys(); }

  ulong time = 5000; // of the wheel's last event [ms]
};

} // namespace

TEST(Line, IsSeenBeforeItRisesAndKeepsItsLengths)
{
  LineScene scene;
  EXPECT_EQ(scene.orange(), 0);
  const vtkIdType before = scene.triangles();
  scene.drawOn();
  EXPECT_TRUE(scene.comes([](const QImage& image) { return LineScene::orangeIn(image) > 200; }))
    << "no crest under the pen";
  scene.release();
  scene.wait();
  EXPECT_EQ(scene.failures(), "");
  EXPECT_EQ(scene.orange(), 0) << "the crest stays";
  EXPECT_GT(scene.triangles(), before);
  ASSERT_EQ(scene.document->session().nodes.size(), 1u);
  EXPECT_EQ(scene.step(0).system, "Augment");
  EXPECT_NEAR(scene.number(0, "Radius"), 0.03 * scene.diagonal(), 1e-12);
  EXPECT_NEAR(scene.number(0, "Height"), 0.015 * scene.diagonal(), 1e-12);
  EXPECT_EQ(scene.document->digest(), replayed(scene.document->session()));
}

TEST(Line, TheWheelTurnsItsWidthAndHeightInOneStepOfUndo)
{
  LineScene scene;
  scene.line();
  const std::string first = scene.document->digest();
  const double radius = scene.number(0, "Radius");
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  const auto seen = [camera] { return std::make_pair(camera->GetViewAngle(), camera->GetDistance()); };
  const auto looked = seen();
  scene.wheel(3, Qt::ShiftModifier);
  scene.wait();
  EXPECT_NEAR(scene.number(0, "Height"), 0.8 * radius, 1e-9 * radius);
  const std::string higher = scene.document->digest();
  EXPECT_NE(higher, first);
  scene.wheel(2, Qt::ControlModifier);
  scene.wait();
  EXPECT_NEAR(scene.number(0, "Radius"), 1.21 * radius, 1e-9 * radius);
  EXPECT_NEAR(scene.number(0, "Height"), 0.8 * radius, 1e-9 * radius);
  const std::string wider = scene.document->digest();
  EXPECT_NE(wider, higher);
  EXPECT_EQ(seen(), looked) << "the camera takes the tool's wheel";
  EXPECT_EQ(scene.document->session().nodes.size(), 1u);
  for (const std::string& wanted : { higher, first })
  {
    QTest::keyClick(scene.view, Qt::Key_Z, Qt::ControlModifier);
    scene.wait();
    EXPECT_EQ(scene.document->digest(), wanted);
  }
  for (const std::string& wanted : { higher, wider })
  {
    QTest::keyClick(scene.view, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    scene.wait();
    EXPECT_EQ(scene.document->digest(), wanted);
  }
  // A hand that rests for a second begins another step: by the events' own times, whenever they come.
  const double wide = scene.number(0, "Radius");
  const auto isUndoneTo = [&](double notches)
  {
    QTest::keyClick(scene.view, Qt::Key_Z, Qt::ControlModifier);
    scene.wait();
    EXPECT_NEAR(scene.number(0, "Radius"), std::pow(1.1, notches) * wide, 1e-9 * radius);
  };
  scene.wheel(1, Qt::ControlModifier, 5000);
  scene.wheel(1, Qt::ControlModifier, 999);
  QTest::qWait(1100);
  scene.wheel(1, Qt::ControlModifier, 20);
  scene.wheel(1, Qt::ControlModifier, 1000);
  EXPECT_NEAR(scene.number(0, "Radius"), std::pow(1.1, 4) * wide, 1e-9 * radius);
  isUndoneTo(3);
  isUndoneTo(0);
  // So it is over the box of the length.
  auto* box = scene.window.findChild<QDoubleSpinBox*>("augment_radius");
  const auto turnOver = [&](ulong rest)
  {
    const QPointF at = box->rect().center();
    QWheelEvent turn(at,
      box->mapToGlobal(at.toPoint()),
      {},
      { 0, 120 },
      Qt::NoButton,
      Qt::NoModifier,
      Qt::NoScrollPhase,
      false);
    turn.setTimestamp(scene.time += rest);
    QApplication::sendEvent(box, &turn);
    return box->value();
  };
  turnOver(5000);
  const double two = turnOver(999);
  EXPECT_GT(turnOver(1000), two);
  QTest::keyClick(scene.view, Qt::Key_Z, Qt::ControlModifier);
  scene.wait();
  EXPECT_NEAR(scene.number(0, "Radius"), two, 1e-9 * radius);
  isUndoneTo(0);
  // Through to carving; the options say so.
  scene.wheel(-20, Qt::ShiftModifier);
  scene.wait();
  EXPECT_LT(scene.number(0, "Height"), 0.0);
  EXPECT_EQ(scene.window.findChild<QComboBox*>("augment_direction")->currentIndex(), 1);
  scene.wheel(1, Qt::NoModifier);
  EXPECT_NE(seen(), looked) << "the plain wheel is the camera's";
}

TEST(Line, TheWheelInTheAirIsForTheLineThatComes)
{
  LineScene scene;
  const double radius = 0.03 * scene.diagonal();
  scene.wheel(1, Qt::ControlModifier);
  scene.line();
  EXPECT_NEAR(scene.number(0, "Radius"), 1.1 * radius, 1e-9 * radius);
  const Values first = scene.step(0).values;
  // While the pen is on the model, too; the line before keeps what it has.
  scene.drawOn(-40);
  EXPECT_TRUE(scene.comes([](const QImage& image) { return LineScene::orangeIn(image) > 100; }));
  scene.wheel(-2, Qt::ControlModifier);
  scene.wheel(3, Qt::ShiftModifier);
  scene.release();
  scene.wait();
  ASSERT_EQ(scene.document->session().nodes.size(), 2u);
  EXPECT_EQ(scene.step(0).values, first);
  EXPECT_NEAR(scene.number(1, "Radius"), radius / 1.1, 1e-9 * radius);
  EXPECT_GT(scene.number(1, "Height"), 0.75 * scene.number(1, "Radius"));
  EXPECT_EQ(scene.failures(), "");
}

TEST(Line, OptionsAreThoseOfTheRedLine)
{
  LineScene scene;
  scene.line();
  auto* radius = scene.window.findChild<QDoubleSpinBox*>("augment_radius");
  auto* direction = scene.window.findChild<QComboBox*>("augment_direction");
  radius->setValue(0.02 * scene.diagonal());
  scene.wait();
  EXPECT_NEAR(scene.number(0, "Radius"), 0.02 * scene.diagonal(), 1e-3 * scene.diagonal());
  direction->setCurrentIndex(1);
  emit direction->activated(1);
  scene.wait();
  EXPECT_LT(scene.number(0, "Height"), 0.0);
  EXPECT_EQ(scene.failures(), "");
  // Left alone, it keeps what it has.
  QTest::keyClick(scene.view, Qt::Key_Return);
  const Values before = scene.step(0).values;
  direction->setCurrentIndex(0);
  emit direction->activated(0);
  scene.wait();
  EXPECT_EQ(scene.step(0).values, before);
  scene.line(-40);
  EXPECT_GT(scene.number(1, "Height"), 0.0);
  // The selected one's are shown, and changed.
  scene.window.findChild<QListWidget*>("history")->setCurrentRow(0);
  EXPECT_EQ(direction->currentIndex(), 1);
  scene.wheel(1, Qt::ControlModifier);
  scene.wait();
  EXPECT_GT(scene.number(0, "Radius"), std::get<double>(before.at("Radius")));
  EXPECT_EQ(scene.document->digest(), replayed(scene.document->session()));
}

TEST(Line, AMinusBeforeItsHeightCarves)
{
  LineScene scene;
  scene.line();
  auto* height = scene.window.findChild<QDoubleSpinBox*>("augment_height");
  auto* direction = scene.window.findChild<QComboBox*>("augment_direction");
  const double typed = 0.02 * scene.diagonal(), least = 1e-3 * scene.diagonal();
  const auto type = [&](const QString& text)
  {
    height->selectAll();
    QTest::keyClicks(height, text);
    QTest::keyClick(height, Qt::Key_Return);
    scene.wait();
  };
  type(height->textFromValue(-typed));
  EXPECT_NEAR(scene.number(0, "Height"), -typed, least);
  EXPECT_EQ(direction->currentIndex(), 1);
  EXPECT_NEAR(height->value(), typed, least) << "the direction says it";
  EXPECT_EQ(scene.failures(), "");
  // Carved it stays until the direction is another; nothing is the least height, not the system's word.
  type(height->textFromValue(0.5 * typed));
  EXPECT_NEAR(scene.number(0, "Height"), -0.5 * typed, least);
  type("0");
  EXPECT_LT(scene.number(0, "Height"), -0.5 * least);
  direction->setCurrentIndex(0);
  emit direction->activated(0);
  scene.wait();
  EXPECT_GT(scene.number(0, "Height"), 0.0);
}

TEST(Line, ItsProfileIsDrawn)
{
  LineScene scene;
  scene.line();
  auto* presets = scene.window.findChild<QComboBox*>("profile_presets");
  EXPECT_EQ(presets->currentText(), "Round") << "what a new line has";
  presets->setCurrentIndex(0);
  emit presets->activated(0);
  scene.wait();
  const std::string crease = scene.document->digest();
  EXPECT_EQ(scene.text(0, "Profile"), "");
  auto* curve = scene.window.findChild<ProfileCurve*>("profile_curve");
  ASSERT_TRUE(curve->isVisible());
  // A point is dragged, live, in one step of undo.
  const QPoint from = curve->placeOf(2);
  QTest::mousePress(curve, Qt::LeftButton, Qt::NoModifier, from);
  std::string live;
  for (int i = 1; i <= 5; ++i)
  {
    const QPoint at = from - QPoint(0, 3 * i);
    QMouseEvent move(
      QEvent::MouseMove, at, curve->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(curve, &move);
    scene.wait();
    EXPECT_NE(scene.document->digest(), live) << "the model does not follow";
    live = scene.document->digest();
  }
  QTest::mouseRelease(curve, Qt::LeftButton, Qt::NoModifier, from - QPoint(0, 15));
  const std::string dragged = scene.text(0, "Profile");
  EXPECT_EQ(std::count(dragged.begin(), dragged.end(), ','), 6);
  EXPECT_EQ(presets->currentIndex(), presets->count() - 1) << "it is nobody's but its own";
  // Added by a click, taken away by another.
  const QPoint beside = (curve->placeOf(0) + curve->placeOf(1)) / 2 + QPoint(0, 14);
  QTest::mouseClick(curve, Qt::LeftButton, Qt::NoModifier, beside);
  scene.wait();
  const std::string added = scene.text(0, "Profile");
  EXPECT_EQ(std::count(added.begin(), added.end(), ','), 7);
  QTest::mouseClick(curve, Qt::RightButton, Qt::NoModifier, curve->placeOf(1));
  scene.wait();
  EXPECT_EQ(scene.text(0, "Profile"), dragged);
  for (int i = 0; i < 3; ++i)
  {
    QTest::keyClick(scene.view, Qt::Key_Z, Qt::ControlModifier);
  }
  scene.wait();
  EXPECT_EQ(scene.document->digest(), crease);
  EXPECT_EQ(presets->currentIndex(), 0) << "undo is not seen in the profile";
  // Each shape to begin with makes another model.
  std::set<std::string> made;
  for (int preset = 0; preset + 1 < presets->count(); ++preset)
  {
    presets->setCurrentIndex(preset);
    emit presets->activated(preset);
    scene.wait();
    EXPECT_EQ(scene.failures(), "");
    made.insert(scene.document->digest());
  }
  EXPECT_EQ(made.size(), 5u);
}

TEST(Line, ItsProfileIsDrawnByKeys)
{
  LineScene scene;
  auto* curve = scene.window.findChild<ProfileCurve*>("profile_curve");
  auto* editor = scene.window.findChild<ProfileEditor*>();
  const std::string before = editor->profile();
  QTest::keyClick(curve, Qt::Key_Up); // none is chosen
  QTest::keyClick(curve, Qt::Key_Delete);
  EXPECT_EQ(editor->profile(), before);
  editor->setShape("0 1, 0.5 0.5, 1 0", 1.5);
  QTest::keyClick(curve, Qt::Key_PageDown);
  QTest::keyClick(curve, Qt::Key_PageDown);
  QTest::keyClick(curve, Qt::Key_Up);
  EXPECT_EQ(editor->profile(), "0 1, 0.5 0.55, 1 0");
  QTest::keyClick(curve, Qt::Key_Left);
  EXPECT_EQ(editor->profile(), "0 1, 0.45 0.55, 1 0");
  QTest::keyClick(curve, Qt::Key_Insert);
  EXPECT_EQ(editor->profile(), "0 1, 0.45 0.55, 0.725 0.275, 1 0");
  QTest::keyClick(curve, Qt::Key_Delete);
  EXPECT_EQ(editor->profile(), "0 1, 0.45 0.55, 1 0");
  // The line's own point goes up and down alone, and cannot be taken away.
  QTest::keyClick(curve, Qt::Key_PageDown);
  QTest::keyClick(curve, Qt::Key_PageUp);
  QTest::keyClick(curve, Qt::Key_Left);
  QTest::keyClick(curve, Qt::Key_Delete);
  QTest::keyClick(curve, Qt::Key_Down);
  EXPECT_EQ(editor->profile(), "0 0.95, 0.45 0.55, 1 0");
}

TEST(Line, StandsInOneHistoryWithOutlines)
{
  LineScene scene;
  QTest::keyClick(scene.view, Qt::Key_D);
  EXPECT_FALSE(scene.window.findChild<ProfileEditor*>()->isVisible());
  scene.draw();
  scene.release();
  scene.wait();
  QTest::keyClick(scene.view, Qt::Key_B);
  scene.line();
  QTest::keyClick(scene.view, Qt::Key_D);
  scene.wheel(1, Qt::ShiftModifier); // not the outline's
  ASSERT_EQ(scene.document->session().nodes.size(), 2u);
  EXPECT_EQ(scene.step(0).system, "OneStroke");
  EXPECT_EQ(scene.step(1).system, "Augment");
  EXPECT_EQ(scene.failures(), "");
  // One list of them, each with its tick and its picture, and a form of its kind.
  auto* list = scene.window.findChild<QListWidget*>("history");
  ASSERT_EQ(list->count(), 2);
  const auto* form = scene.window.findChild<StepPanel*>();
  std::set<const QWidget*> forms;
  for (int row = 0; row < 2; ++row)
  {
    const auto hasPicture = [&] { return scene.document->result().nodes[indexOf(row)].picture != nullptr; };
    EXPECT_TRUE(QTest::qWaitFor(hasPicture, 60000));
    EXPECT_EQ(list->item(row)->checkState(), Qt::Checked);
    list->setCurrentRow(row);
    forms.insert(form->currentWidget());
  }
  EXPECT_EQ(forms.size(), 2u);
  list->setCurrentRow(-1);
  const std::string both = scene.document->digest();
  const Values lengths = scene.step(1).values;
  // The outline is edited, the line follows in its own lengths.
  scene.document->setOn(0, false);
  scene.wait();
  EXPECT_EQ(scene.failures(), "");
  EXPECT_EQ(scene.step(1).values, lengths);
  EXPECT_NE(scene.document->digest(), both);
  EXPECT_EQ(scene.document->digest(), replayed(scene.document->session()));
  scene.document->setOn(0, true);
  scene.wait();
  EXPECT_EQ(scene.document->digest(), both);
  // The line is edited with the tool, whatever is in the hand: its form, or B and the wheel.
  QTest::keyClick(scene.view, Qt::Key_B);
  scene.wheel(-2, Qt::ShiftModifier);
  scene.wait();
  EXPECT_NE(scene.document->digest(), both);
  EXPECT_EQ(scene.step(0).values, Values());
  EXPECT_EQ(scene.document->digest(), replayed(scene.document->session()));
}

TEST(Line, ARedLineIsMoved)
{
  LineScene scene;
  scene.line();
  const std::string before = scene.document->digest();
  const QPoint on = scene.end;
  moveMouse(scene.view, on, Qt::NoButton);
  QTest::mousePress(scene.view, Qt::LeftButton, Qt::NoModifier, on);
  for (int i = 1; i <= 10; ++i)
  {
    moveMouse(scene.view, on + QPoint(0, 3 * i));
    QApplication::processEvents();
  }
  EXPECT_TRUE(scene.comes([](const QImage& image) { return LineScene::orangeIn(image) > 100; }))
    << "no crest where it is now";
  QTest::mouseRelease(scene.view, Qt::LeftButton, Qt::NoModifier, on + QPoint(0, 30));
  scene.wait();
  ASSERT_EQ(scene.document->session().nodes.size(), 1u) << "a new line was begun";
  EXPECT_NE(scene.document->digest(), before);
  EXPECT_EQ(scene.failures(), "");
}

TEST(Line, ActsOnBothSides)
{
  LineScene scene;
  auto* augment = scene.window.findChild<Tool*>("augment");
  ASSERT_TRUE(augment);
  QComboBox* mirror = nullptr;
  for (QComboBox* one : scene.window.findChildren<QComboBox*>("mirror"))
  {
    mirror = one->isVisible() ? one : mirror;
  }
  ASSERT_TRUE(mirror);
  const vtkIdType before = scene.triangles();
  scene.line();
  const vtkIdType one = scene.triangles() - before;
  QTest::keyClick(scene.view, Qt::Key_Z, Qt::ControlModifier);
  scene.wait();
  mirror->setCurrentIndex(3);
  emit mirror->activated(3);
  scene.line();
  EXPECT_EQ(scene.failures(), "");
  EXPECT_GT(scene.triangles() - before, one + one / 2) << "the other side stays as it was";
}

TEST(Line, AnOutlineFeatureHasNoHeight)
{
  LineScene scene;
  auto* mode = scene.window.findChild<QComboBox*>("augment_mode");
  mode->setCurrentIndex(1);
  emit mode->activated(1);
  for (const char* name : { "augment_height", "augment_direction", "augment_pressure" })
  {
    EXPECT_FALSE(scene.window.findChild<QWidget*>(name)->isEnabled()) << name;
  }
  EXPECT_TRUE(scene.window.findChild<QWidget*>("augment_radius")->isEnabled());
  // A low arch beside the back.
  scene.draw();
  scene.release();
  scene.wait();
  ASSERT_EQ(scene.document->session().nodes.size(), 1u);
  EXPECT_EQ(std::get<int>(scene.step(0).values.at("SketchMode")), 1);
}

TEST(Line, HeightsBeginASessionToDrawOn)
{
  LineScene scene;
  // It is asked what a picture is for; nothing happens where nobody says.
  const auto opens = [&](const QString& answer)
  {
    QTimer::singleShot(0,
      &scene.window,
      [answer]
      {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_TRUE(box);
        const auto all = box->buttons();
        const auto one = std::find_if(
          all.begin(), all.end(), [&](const QAbstractButton* button) { return button->text() == answer; });
        ASSERT_NE(one, all.end());
        (*one)->click();
      });
    return scene.window.open(OVERSKETCH_DATA_FOLDER "/Terrain/valley.png");
  };
  EXPECT_FALSE(opens("&Cancel"));
  EXPECT_TRUE(scene.document->session().mesh);
  ASSERT_TRUE(opens("Take it as &heights"));
  scene.wait();
  ASSERT_TRUE(QTest::qWaitFor([&] { return scene.document->result().mesh != nullptr; }, 60000));
  ASSERT_EQ(scene.document->session().nodes.size(), 1u);
  EXPECT_EQ(scene.step(0).system, "Terrain");
  EXPECT_EQ(scene.triangles(), 2 * 64 * 64);
  const double* bounds = scene.document->result().mesh->GetBounds();
  EXPECT_DOUBLE_EQ(bounds[1] - bounds[0], 192.0);
  const double relief = bounds[5] - bounds[4]; // a fifth of what the samples make, which the grid may miss
  EXPECT_GT(relief, 30.0);
  EXPECT_LE(relief, 0.2 * 192.0 + 1e-9);
  // A line over it has lengths of the terrain's size.
  scene.line();
  ASSERT_EQ(scene.document->session().nodes.size(), 2u);
  EXPECT_EQ(scene.failures(), "");
  EXPECT_GT(scene.number(1, "Radius"), 3.0);
  EXPECT_GT(scene.triangles(), 2 * 64 * 64 + 100);
  // Fewer quads: the line stays on what is now there.
  const vtkIdType fine = scene.triangles();
  Values values = scene.step(0).values;
  values["Columns"] = 32;
  scene.document->setParameters(0, values, std::nullopt);
  scene.wait();
  EXPECT_EQ(scene.failures(), "");
  EXPECT_GT(scene.triangles(), 2 * 32 * 32 + 100);
  EXPECT_LT(scene.triangles(), fine - 2 * 32 * 32);
}
