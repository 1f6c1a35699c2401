// Rows of edits that later steps act on, changed by the hand as a person changes them.
#include "edits.h"
#include "history_panel.h"

#include "vtkOversketchEdit.h"

using namespace oversketch_studio;
using namespace oversketch_session;

namespace
{

struct Rows : Edits
{
  using Edits::Edits;

  EditHand& hand() { return static_cast<EditTool*>(this->view->tool())->hand(); }
  void select(int row)
  {
    this->window.findChild<HistoryPanel*>()->selectStep(row);
    QApplication::processEvents();
    this->settle();
  }
  // Once what it acts on has come.
  void selectEarlier(int row)
  {
    this->select(row);
    EXPECT_TRUE(QTest::qWaitFor([this] { return this->hand().hasRegion(); }, 60000)) << this->said();
    EXPECT_TRUE(this->hand().isUnderOthers());
    this->settle();
  }
  // Of keys that change, hide or reorder rows none does while the hand pulls the only one.
  void keysWaitForTheHand()
  {
    this->select(0);
    const auto before = this->nodes()[0].step;
    const Way pull = straight(this->lineSeen(), this->lineSeen() - QPoint(0, 15));
    this->drag(this->view, pull, Qt::NoModifier, false);
    for (const Qt::Key key : { Qt::Key_D, Qt::Key_H, Qt::Key_Down, Qt::Key_R })
    {
      QTest::keyClick(this->view, key, Qt::ControlModifier);
    }
    for (const Qt::Key key : { Qt::Key_Delete, Qt::Key_B })
    {
      QTest::keyClick(this->view, key);
    }
    QApplication::processEvents();
    EXPECT_EQ(this->nodes().size(), 1u) << "a row changed under the hand";
    EXPECT_TRUE(this->hand().moves()) << "the hand has lost the line";
    this->letGo(this->view, pull.back());
    ASSERT_EQ(this->nodes().size(), 1u);
    EXPECT_NE(this->nodes()[0].step, before) << "the drag is lost";
    EXPECT_EQ(this->failures(), "");
    this->press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(this->nodes()[0].step, before);
  }
  // Another row of the kind comes under the hand, in whatever way.
  void nothingGoesIntoAnotherRow()
  {
    const auto before = this->nodes()[0].step;
    const Way pull = straight(this->lineSeen(), this->lineSeen() - QPoint(0, 15));
    this->drag(this->view, pull, Qt::NoModifier, false);
    this->document->duplicate(0);
    this->settle();
    ASSERT_EQ(this->nodes().size(), 2u);
    const auto copy = this->nodes()[1].step;
    this->window.findChild<HistoryPanel*>()->selectStep(1);
    this->letGo(this->view, pull.back());
    ASSERT_EQ(this->nodes().size(), 2u);
    EXPECT_EQ(this->nodes()[0].step, before);
    EXPECT_EQ(this->nodes()[1].step, copy) << "the copy has what the hand made of the first";
    this->press(Qt::Key_Z, Qt::ControlModifier);
    ASSERT_EQ(this->nodes().size(), 1u);
    this->select(-1);
  }
  // The middle of the line that the hand has.
  QPoint lineSeen()
  {
    vtkPolyData* line = this->hand().widget()->GetEdit()->GetReferenceOutput();
    return this->seen(line->GetPoint(line->GetNumberOfPoints() / 2));
  }
};

} // namespace

TEST(EditRows, HistoryWaitsForTheHandAndNothingGoesIntoAnotherStep)
{
  Edits scene(Qt::Key_B);
  scene.drawLine();
  ASSERT_EQ(scene.nodes().size(), 1u) << scene.said();
  const auto line = scene.nodes()[0].step;
  scene.press(Qt::Key_E);
  scene.drawLine();
  scene.drawRing();
  ASSERT_EQ(scene.nodes().size(), 2u) << scene.said();

  const Way pull = Edits::straight(scene.middle, scene.middle - QPoint(0, 25));
  scene.drag(scene.view, pull, Qt::NoModifier, false);
  QTest::keyClick(scene.view, Qt::Key_Z, Qt::ControlModifier);
  QApplication::processEvents();
  EXPECT_EQ(scene.nodes().size(), 2u) << "undone under the hand";
  scene.letGo(scene.view, pull.back());
  ASSERT_EQ(scene.nodes().size(), 2u);
  EXPECT_EQ(scene.nodes()[0].step, line);
  EXPECT_NE(scene.text(1, "Operations"), "");
  EXPECT_EQ(scene.failures(), "");

  // The row goes in another way.
  const Way back = Edits::straight(pull.back(), scene.middle);
  scene.drag(scene.view, back, Qt::NoModifier, false);
  scene.document->remove(1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !scene.document->isBusy(); }, 60000));
  scene.letGo(scene.view, back.back());
  ASSERT_EQ(scene.nodes().size(), 1u);
  EXPECT_EQ(scene.nodes()[0].step, line) << "the line's step has what the edit's hand made";
  EXPECT_EQ(scene.failures(), "");
  scene.press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene.nodes().size(), 2u) << "the hand is free";
}

TEST(EditRows, AnEarlierOneIsChangedAndTheLaterFollow)
{
  Rows scene(Qt::Key_E, wholeWindow);
  scene.drawBoth();
  scene.keysWaitForTheHand();
  scene.nothingGoesIntoAnotherRow();
  scene.drag(Edits::straight(scene.middle, scene.middle - QPoint(0, 18)));
  ASSERT_EQ(scene.failures(), "");
  scene.press(Qt::Key_Return);
  // Another one on the same body, which is last.
  scene.drag(Edits::straight(scene.middle - QPoint(20, 30), scene.middle + QPoint(20, -30)));
  scene.drag(Edits::ring(scene.middle - QPoint(0, 30), 40.0, 22.0));
  ASSERT_EQ(scene.nodes().size(), 2u) << scene.said();
  scene.drag(Edits::straight(scene.middle - QPoint(0, 30), scene.middle - QPoint(0, 40)));
  ASSERT_EQ(scene.failures(), "");
  ASSERT_NE(scene.text(1, "Operations"), "");
  const std::string before = scene.digest(), first = scene.text(0, "Operations");
  const auto later = scene.nodes()[1].step;

  scene.selectEarlier(0);
  EXPECT_EQ(scene.digest(), before) << "a look changes the model";
  EXPECT_NE(scene.said().find("Later steps follow"), std::string::npos) << scene.said();
  scene.shot("rows_first");

  // Its line: the model as of this step follows the hand, the later step once it is let go.
  const QPoint on = scene.lineSeen();
  const Way pull = Edits::straight(on, on + QPoint(0, 12));
  scene.drag(scene.view, pull, Qt::NoModifier, false);
  scene.shot("rows_first_dragged");
  vtkNew<vtkPolyData> preview;
  preview->DeepCopy(scene.shown());
  scene.letGo(scene.view, pull.back());
  ASSERT_EQ(scene.nodes().size(), 2u);
  EXPECT_NE(scene.text(0, "Operations"), first);
  EXPECT_EQ(scene.nodes()[1].step, later) << "the hand has changed another row";
  EXPECT_EQ(scene.failures(), "");
  EXPECT_NE(scene.digest(), before);
  EXPECT_EQ(scene.digest(), replayed(scene.document->session()));
  Session until = scene.document->session();
  until.nodes.resize(1);
  EXPECT_EQ(digestOf(preview), replayed(until, ruleOff));
  EXPECT_TRUE(scene.hand().isUnderOthers() && scene.hand().hasRegion()) << "the hand has lost the row";

  // Its layers: one is gone.
  scene.press(Qt::Key_S);
  scene.shot("rows_first_shaded");
  QWidget* disc = scene.dockPicture("disc_picture");
  const QPoint centre = disc->rect().center(), out = centre + QPoint(0, disc->height() * 3 / 10);
  scene.drag(disc, Edits::straight(out, centre), Qt::NoModifier);
  EXPECT_NE(scene.text(0, "Layers"), "");
  EXPECT_EQ(scene.nodes()[1].step, later);
  EXPECT_EQ(scene.digest(), replayed(scene.document->session()));
  scene.press(Qt::Key_Z, Qt::ControlModifier);
  scene.press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene.digest(), before);
  EXPECT_EQ(scene.text(0, "Operations"), first);

  // What is drawn for its line and ring comes last, and is what the hand has from there on.
  scene.press(Qt::Key_A);
  QWidget* profile = scene.dockPicture("profile_picture");
  const int w = profile->width(), h = profile->height();
  scene.drawProfile();
  ASSERT_EQ(scene.nodes().size(), 3u) << scene.said();
  EXPECT_TRUE(scene.step(2).inputs.count("Profile"));
  scene.drag(profile, Edits::straight({ w * 4 / 10, h * 3 / 10 }, { w * 6 / 10, h * 3 / 10 }));
  EXPECT_EQ(scene.nodes().size(), 3u) << "another step for the same profile";
  EXPECT_EQ(scene.failures(), "") << scene.said();
  EXPECT_EQ(scene.digest(), replayed(scene.document->session()));
  scene.shot("rows_profile");
  // A row that takes its line and ring of another, under a further one.
  scene.press(Qt::Key_E);
  scene.drag(Edits::straight(scene.lineSeen(), scene.lineSeen() - QPoint(0, 8)));
  ASSERT_EQ(scene.nodes().size(), 4u) << scene.said();
  scene.press(Qt::Key_A);
  scene.selectEarlier(2);
  const vtkIdType strokes = linesOf(scene.step(2), "Profile")->GetNumberOfLines();
  scene.drag(profile, Edits::straight({ w * 4 / 10, h * 4 / 10 }, { w * 6 / 10, h * 4 / 10 }));
  EXPECT_EQ(linesOf(scene.step(2), "Profile")->GetNumberOfLines(), strokes + 1) << scene.said();
  EXPECT_EQ(scene.nodes().size(), 4u);
  EXPECT_EQ(scene.failures(), "");
  EXPECT_EQ(scene.digest(), replayed(scene.document->session()));
}

TEST(EditRows, AnEarlierSectionSlides)
{
  Rows scene(Qt::Key_A);
  scene.drawBoth();
  QWidget* profile = scene.dockPicture("profile_picture");
  const int w = profile->width(), h = profile->height();
  scene.drag(profile, Edits::ring({ w / 2, h / 2 }, 0.28 * w, 0.3 * h, M_PI, 2.0 * M_PI));
  ASSERT_TRUE(scene.step(0).inputs.count("Profile")) << scene.said();
  // Operations of the same line and ring are a later step, which takes them from this one.
  scene.press(Qt::Key_E);
  scene.drag(Edits::straight(scene.middle, scene.middle - QPoint(0, 12)));
  ASSERT_EQ(scene.nodes().size(), 2u) << scene.said();
  ASSERT_TRUE(std::holds_alternative<StepOutput>(scene.step(1).inputs.at("Reference")));
  const auto later = scene.nodes()[1].step;
  const std::string before = scene.digest();

  scene.press(Qt::Key_A);
  scene.selectEarlier(0);
  scene.shot("rows_section");
  const Way slide = Edits::straight(scene.middle + QPoint(0, 15), scene.middle + QPoint(22, 15));
  scene.drag(slide);
  ASSERT_TRUE(scene.step(0).values.count("ProfileAt")) << "the plane does not slide";
  EXPECT_EQ(scene.nodes()[1].step, later);
  EXPECT_NE(scene.digest(), before);
  EXPECT_EQ(scene.failures(), "");
  EXPECT_EQ(scene.digest(), replayed(scene.document->session()));
}

TEST(EditRows, WhatTakesNoHoldAnyMoreIsSaid)
{
  Rows scene;
  scene.middle -= QPoint(0, 18);
  scene.drawBoth();
  const QPoint rest = scene.lineSeen(), top = rest - QPoint(0, 120);
  scene.drag(Edits::straight(rest, top)); // beyond the back
  scene.press(Qt::Key_Return);
  const QPoint above = rest - QPoint(0, 70);
  scene.drag(Edits::straight(above - QPoint(15, 0), above + QPoint(15, 0)));
  scene.drag(Edits::ring(above, 28.0, 18.0));
  ASSERT_EQ(scene.nodes().size(), 2u) << scene.said();
  ASSERT_EQ(scene.failures(), "");
  const std::string before = scene.digest();

  scene.selectEarlier(0);
  scene.drag(Edits::straight(scene.lineSeen(), rest));
  EXPECT_NE(scene.failures(), "") << "a line in the void takes hold";
  EXPECT_NE(scene.said().find("Later steps do nothing now, or act elsewhere: Edit 2."), std::string::npos)
    << scene.said();
  scene.shot("rows_lost");
  scene.press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene.failures(), "");
  EXPECT_EQ(scene.digest(), before);
  EXPECT_EQ(scene.said().find("do nothing now"), std::string::npos) << scene.said();
}
