// The tool Image to model, as a person uses it: a picture, lines drawn over it, and the model beside it.
// First: it brings the headers of TBB, which name a function as Qt names its word emit.
#include "vtkImplicitPolyDataDistance.h"

#include "files.h"
#include "mesh_file.h"
#include "message_text.h"
#include "sheet.h"
#include "step_panel.h"
#include "texture.h"
#include "tool.h"

#include "vtkOversketchDrawingWidget.h"
#include "vtkOversketchInteractorStyle.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <QCheckBox>
#include <QComboBox>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QSplitter>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace oversketch_studio;
using namespace oversketch_session;

TEST(Drawing, APictureBecomesAModelThatWearsIt)
{
  Sheet sheet;
  EXPECT_FALSE(sheet.pad->isVisible());
  sheet.open();
  ASSERT_TRUE(sheet.pad->isVisible());
  EXPECT_EQ(sheet.view->tool()->system(), "InflateDrawing");
  EXPECT_FALSE(sheet.view->mesh()) << "the dog is still there";
  EXPECT_TRUE(sheet.advice->text().contains("Draw round")) << sheet.advice->text().toStdString();
  sheet.line(beast());
  ASSERT_TRUE(sheet.mesh()) << sheet.failure();
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_EQ(openEdges(sheet.mesh()), 0);
  EXPECT_EQ(eulerOf(sheet.mesh()), 2);
  EXPECT_TRUE(sheet.mesh()->GetPointData()->GetTCoords());
  const auto skin = oversketch_files::pictureOf(oversketch_files::textureOf(sheet.mesh()));
  ASSERT_TRUE(skin);
  EXPECT_EQ(skin->GetNumberOfScalarComponents(), 3) << "opaque";
  ASSERT_EQ(sheet.list->count(), 2);
  EXPECT_EQ(sheet.row(1), "Line 1");
  EXPECT_TRUE(sheet.advice->text().contains("feature")) << sheet.advice->text().toStdString();
  // It is seen beside the picture, in the picture's colour.
  const QImage seen = sheet.pictureAtRest();
  int red = 0;
  for (int y = 0; y < seen.height(); ++y)
  {
    for (int x = 0; x < seen.width(); ++x)
    {
      const QColor c = seen.pixelColor(x, y);
      red += c.red() > 2 * c.green() && c.red() > 60;
    }
  }
  EXPECT_GT(red, seen.width() * seen.height() / 20);
  // Saved, opened again, replayed, undone and redone: the same.
  const std::string made = sheet.document->digest();
  const QString saved = sheet.folder.filePath("a.oversketch");
  sheet.document->save(saved);
  EXPECT_EQ(replayed(readSession(saved.toStdString()).session), made);
  sheet.document->undo();
  sheet.settle();
  EXPECT_FALSE(sheet.mesh());
  EXPECT_FALSE(sheet.view->mesh()) << "a drawing without lines has a model";
  EXPECT_EQ(sheet.pad->widget()->GetDrawing()->GetNumberOfLines(), 0);
  sheet.document->redo();
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), made);
  sheet.document->save(saved);
  ASSERT_TRUE(sheet.window.open(saved));
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), made);
  EXPECT_TRUE(sheet.pad->isVisible());
  EXPECT_EQ(sheet.pad->widget()->GetDrawing()->GetNumberOfLines(), 1);
}

TEST(Drawing, AClickMakesAHoleAndATunnel)
{
  Sheet sheet;
  sheet.open();
  sheet.line(beast());
  sheet.line(ring({ 240, 185 }, 28));
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_EQ(eulerOf(sheet.mesh()), 2);
  EXPECT_TRUE(sheet.advice->text().contains("hole")) << sheet.advice->text().toStdString();
  const std::string filled = sheet.document->digest();
  sheet.click({ 240, 185 });
  EXPECT_EQ(sheet.row(2), "Line 2, hole");
  EXPECT_EQ(eulerOf(sheet.mesh()), 0) << sheet.failure();
  EXPECT_EQ(openEdges(sheet.mesh()), 0);
  sheet.click({ 240, 185 });
  EXPECT_EQ(sheet.row(2), "Line 2, tunnel");
  EXPECT_EQ(eulerOf(sheet.mesh()), 0) << sheet.failure();
  sheet.click({ 240, 185 });
  EXPECT_EQ(sheet.row(2), "Line 2");
  EXPECT_EQ(sheet.document->digest(), filled);
  // The line is switched off, and taken away.
  sheet.list->item(2)->setCheckState(Qt::Unchecked);
  sheet.settle();
  EXPECT_EQ(sheet.pad->widget()->GetDrawing()->GetNumberOfLines(), 1);
  EXPECT_NE(sheet.document->digest(), filled);
  EXPECT_EQ(sheet.document->digest(), replayed(sheet.session()));
  EXPECT_EQ(sheet.strokes().size(), 2u);
  // What is drawn meanwhile comes after it, and it comes back as it was.
  sheet.line({ { 200, 150 }, { 210, 160 }, { 220, 150 } });
  ASSERT_EQ(sheet.strokes().size(), 3u);
  EXPECT_FALSE(sheet.strokes()[1].on);
  sheet.list->setCurrentRow(3);
  sheet.action("De&lete")->trigger();
  sheet.settle();
  sheet.list->item(2)->setCheckState(Qt::Checked);
  sheet.settle();
  ASSERT_EQ(sheet.strokes().size(), 2u);
  EXPECT_EQ(sheet.document->digest(), filled);
}

TEST(Drawing, AClickOnAShapeTracesIt)
{
  Sheet sheet;
  sheet.open();
  sheet.click({ 200, 185 }); // in the body
  ASSERT_TRUE(sheet.mesh()) << sheet.failure();
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_EQ(openEdges(sheet.mesh()), 0);
  EXPECT_EQ(eulerOf(sheet.mesh()), 2);
  ASSERT_EQ(sheet.strokes().size(), 1u);
  const double* bounds = sheet.mesh()->GetBounds();
  const double rim[4] = { 80.0, 320.0, 40.0, 240.0 };
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(bounds[k], rim[k], 4.0);
  }
  // A thing that has its outline is traced no more: a click in it says nothing, one beside it why.
  const std::string made = sheet.document->digest();
  sheet.click({ 200, 185 });
  sheet.click({ 360, 60 });
  EXPECT_EQ(sheet.document->digest(), made);
  EXPECT_EQ(sheet.strokes().size(), 1u);
  EXPECT_NE(std::string(sheet.pad->widget()->GetText()), "");
  // A line is drawn in it, as in one that a hand drew, and the outline redrawn.
  sheet.line(ring({ 240, 185 }, 28));
  sheet.click({ 240, 185 });
  EXPECT_EQ(eulerOf(sheet.mesh()), 0) << sheet.failure();
  sheet.document->undo();
  sheet.document->undo();
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), made);
  sheet.document->undo(); // one click, one step
  sheet.settle();
  EXPECT_FALSE(sheet.mesh());
  EXPECT_EQ(sheet.pad->widget()->GetDrawing()->GetNumberOfLines(), 0);
  EXPECT_FALSE(sheet.document->canUndo());
}

TEST(Drawing, ALegIsPulledAndTheDrawingChangedAfterwards)
{
  Sheet sheet;
  sheet.open();
  sheet.line(beast());
  const std::string drawn = sheet.document->digest();
  sheet.pullTheLeg();
  EXPECT_FALSE(sheet.pad->isVisible());
  ASSERT_EQ(sheet.session().nodes.size(), 2u);
  ASSERT_EQ(sheet.step(1).system, "OneStroke");
  ASSERT_EQ(sheet.failure(1), "");
  const std::string pulled = sheet.document->digest();
  EXPECT_NE(pulled, drawn);
  EXPECT_LT(sheet.mesh()->GetBounds()[2], 38.0) << "the leg is no longer";
  EXPECT_EQ(openEdges(sheet.mesh()), 0);
  EXPECT_TRUE(sheet.mesh()->GetPointData()->GetTCoords());
  EXPECT_FALSE(oversketch_files::textureOf(sheet.mesh()).empty());
  // The back is raised, by a line over it: the leg is pulled again.
  QTest::keyClick(sheet.view, Qt::Key_G);
  sheet.settle();
  ASSERT_TRUE(sheet.pad->isVisible());
  const Session before = sheet.session();
  std::set<int> ran;
  QObject::connect(
    sheet.document, &Document::progressed, [&ran](int node, const QString&, double) { ran.insert(node); });
  Places hump;
  for (int i = 0; i <= 20; ++i)
  {
    hump.emplace_back(280.0 - 8.0 * i, 240.0 + 25.0 * std::sin(M_PI * i / 20.0));
  }
  sheet.line(hump, Qt::ShiftModifier);
  ASSERT_EQ(sheet.strokes().size(), 1u);
  EXPECT_EQ(sheet.failure(0), "");
  EXPECT_EQ(sheet.failure(1), "");
  EXPECT_EQ(ran, (std::set<int>{ 0, 1 }));
  EXPECT_GT(sheet.mesh()->GetBounds()[3], 255.0);
  EXPECT_LT(sheet.mesh()->GetBounds()[2], 38.0);
  const std::string both = sheet.document->digest();
  EXPECT_EQ(both, replayed(sheet.session()));
  // Counted: both steps for another line of the drawing, the pulled leg alone for another line of that.
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  ASSERT_TRUE(evaluator.run(before, {}, outcomes));
  EXPECT_EQ(evaluator.runs(), 2u);
  ASSERT_TRUE(evaluator.run(sheet.session(), {}, outcomes));
  EXPECT_EQ(evaluator.runs(), 4u);
  Session other = sheet.session();
  auto again = std::make_shared<Step>(*other.nodes[1].step);
  again->values["AsPublished"] = true;
  other.nodes[1].step = again;
  ASSERT_TRUE(evaluator.run(other, {}, outcomes));
  EXPECT_EQ(evaluator.runs(), 5u);
  // To the start and back.
  int undone = 0;
  for (; sheet.document->canUndo(); ++undone)
  {
    sheet.document->undo();
  }
  sheet.settle();
  EXPECT_EQ(undone, 3);
  EXPECT_FALSE(sheet.mesh());
  sheet.document->redo();
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), drawn);
  sheet.document->redo();
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), pulled);
  sheet.document->redo();
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), both);
  const QString saved = sheet.folder.filePath("a.oversketch");
  sheet.document->save(saved);
  EXPECT_EQ(replayed(readSession(saved.toStdString()).session), both);
}

TEST(Drawing, ALineOnTheSurfaceStaysWhenTheDrawingChangesUnderIt)
{
  Sheet sheet;
  sheet.open();
  sheet.line(beast());
  const std::string whole = sheet.document->digest();
  // A ridge along the body, by system D's tool.
  QTest::keyClick(sheet.view, Qt::Key_B);
  sheet.pictureAtRest();
  const auto at = [&](int i)
  {
    const double place[3] = { 120.0 + 4.0 * i, 185.0, 40.0 };
    return sheet.seen(place);
  };
  moveMouse(sheet.view, at(0), Qt::NoButton);
  QTest::mousePress(sheet.view, Qt::LeftButton, Qt::NoModifier, at(0));
  sweepMouse(sheet.view, 1, 40, at);
  QTest::mouseRelease(sheet.view, Qt::LeftButton, Qt::NoModifier, at(40));
  sheet.settle();
  ASSERT_EQ(sheet.session().nodes.size(), 2u);
  EXPECT_EQ(sheet.step(1).system, "Augment");
  // Closed, one piece, and as high as the line says above what it was drawn on.
  const auto expectRidge = [&]
  {
    EXPECT_EQ(sheet.failure(0), "");
    EXPECT_EQ(sheet.failure(1), "");
    EXPECT_EQ(openEdges(sheet.mesh()), 0);
    EXPECT_EQ(eulerOf(sheet.mesh()), 2);
    EXPECT_TRUE(sheet.mesh()->GetPointData()->GetTCoords());
    EXPECT_EQ(sheet.document->digest(), replayed(sheet.session()));
    Session alone = sheet.session();
    alone.nodes[1].on = false;
    std::vector<Outcome> outcomes;
    EXPECT_TRUE(Evaluator().run(alone, {}, outcomes));
    vtkPolyData* bare = outcomes[1].mesh;
    const double height = 0.5 * 0.03 * bare->GetLength(); // of the defaults
    // All along the line, between its ends.
    vtkNew<vtkImplicitPolyDataDistance> above;
    above->SetInput(bare);
    std::vector<double> risen(8, 0.0);
    for (vtkIdType i = 0; i < sheet.mesh()->GetNumberOfPoints(); ++i)
    {
      double place[3];
      sheet.mesh()->GetPoint(i, place);
      const int share = static_cast<int>(std::floor((place[0] - 136.0) / 16.0));
      if (share >= 0 && share < 8)
      {
        risen[share] = std::max(risen[share], std::abs(above->EvaluateFunction(place)));
      }
    }
    EXPECT_GT(*std::min_element(risen.begin(), risen.end()), 0.9 * height);
    EXPECT_LT(*std::max_element(risen.begin(), risen.end()), 1.1 * height);
    EXPECT_NEAR(sheet.mesh()->GetBounds()[4], bare->GetBounds()[4], 1e-6) << "its back";
  };
  expectRidge();
  const std::string ridge = sheet.document->digest();
  EXPECT_NE(ridge, whole);
  // The outline's upper side is drawn anew, higher.
  QTest::keyClick(sheet.view, Qt::Key_G);
  QApplication::processEvents();
  Places higher;
  for (int i = 0; i <= 24; ++i)
  {
    const double t = i / 24.0;
    higher.push_back({ 270.0 - 140.0 * t, 241.0 + 24.0 * std::sin(M_PI * t) });
  }
  QTest::keyClick(&sheet.window, Qt::Key_F4); // no edge is there
  sheet.line(higher, Qt::ShiftModifier);
  EXPECT_EQ(sheet.strokes().size(), 1u);
  EXPECT_GT(sheet.mesh()->GetBounds()[3], 255.0);
  expectRidge();
  const std::string both = sheet.document->digest();
  EXPECT_NE(both, ridge);
  for (const std::string& earlier : { ridge, whole })
  {
    sheet.document->undo();
    sheet.settle();
    EXPECT_EQ(sheet.document->digest(), earlier);
  }
  sheet.document->redo();
  sheet.document->redo();
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), both);
}

TEST(Drawing, ALineIsDrawnAnewWhole)
{
  Sheet sheet;
  sheet.open();
  sheet.line(beast());
  sheet.line(ring({ 240, 185 }, 28));
  sheet.click({ 240, 185 });
  sheet.list->setCurrentRow(2);
  sheet.action("&Redraw")->trigger();
  EXPECT_TRUE(sheet.advice->text().contains("line 2")) << sheet.advice->text().toStdString();
  sheet.line(ring({ 180, 190 }, 24));
  ASSERT_EQ(sheet.strokes().size(), 2u);
  EXPECT_EQ(sheet.row(2), "Line 2, hole") << "it is filled";
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_EQ(eulerOf(sheet.mesh()), 0);
  EXPECT_EQ(sheet.pad->widget()->GetDrawing()->GetNumberOfLines(), 2);
  EXPECT_EQ(sheet.pad->widget()->GetSaid().text(), "");
  sheet.line({ { 280, 180 }, { 290, 190 }, { 300, 180 } });
  EXPECT_EQ(sheet.strokes().size(), 3u) << "the next line still replaces it";
}

TEST(Drawing, ABadHandIsToldAndKeepsTheModel)
{
  Sheet sheet;
  sheet.open();
  // An open scribble is no outline.
  Places open = beast();
  open.resize(open.size() / 2);
  sheet.line(open);
  EXPECT_FALSE(sheet.mesh());
  EXPECT_TRUE(sheet.advice->text().contains("lose")) << sheet.advice->text().toStdString();
  sheet.document->undo();
  sheet.settle();
  // A dot is no line but a click, which traces what is there; so does one in nothing.
  for (const bool isDot : { true, false })
  {
    isDot ? sheet.line({ { 200, 200 }, { 200.4, 200 } }) : sheet.click({ 30, 30 });
    EXPECT_EQ(sheet.strokes().size(), 1u);
    sheet.document->undo();
    sheet.settle();
  }
  EXPECT_TRUE(sheet.strokes().empty());
  EXPECT_FALSE(sheet.document->canUndo());
  sheet.line(beast());
  const std::string made = sheet.document->digest();
  vtkPolyData* shown = sheet.view->mesh();
  // A line in the void: told in the picture and below, the model is the same.
  sheet.line({ { 350, 40 }, { 370, 60 }, { 380, 90 } });
  EXPECT_FALSE(sheet.pad->widget()->GetSaid().empty());
  EXPECT_TRUE(sheet.advice->text().contains("Ctrl+Z")) << sheet.advice->text().toStdString();
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_EQ(sheet.document->digest(), made);
  sheet.document->undo();
  sheet.settle();
  // One across the outline: no model, the last one stays.
  sheet.line({ { 60, 180 }, { 200, 185 }, { 350, 190 } });
  EXPECT_FALSE(sheet.mesh());
  EXPECT_TRUE(sheet.view->mesh());
  EXPECT_TRUE(
    sheet.advice->text().startsWith("Line 1 crosses line 2") && sheet.advice->text().contains("Ctrl+Z"))
    << sheet.advice->text().toStdString();
  EXPECT_EQ(askedFor(sheet.failure()), "Arrange");
  EXPECT_TRUE(plainWords(sheet.failure()).contains("tick Strokes may cross")); // as the form calls it
  // It is orange, with a ring where it is wrong, and a button lets it be.
  const auto isOrange = [](const QColor& c)
  { return c.red() > 220 && c.green() > 100 && c.green() < 180 && c.blue() < 80; };
  const QImage wrong = sheet.pad->grabFramebuffer();
  int orange = 0;
  for (int y = 0; y < wrong.height(); ++y)
  {
    for (int x = 0; x < wrong.width(); ++x)
    {
      orange += isOrange(wrong.pixelColor(x, y));
    }
  }
  EXPECT_GT(orange, 300);
  const auto* anyway = sheet.window.findChild<QPushButton*>("anyway");
  EXPECT_TRUE(anyway->isVisible());
  EXPECT_EQ(anyway->text(), "&Let lines cross");
  sheet.document->undo();
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), made);
  shown = sheet.view->mesh();
  // What is no picture is said, and changes nothing.
  const QString bad = sheet.folder.filePath("bad.png");
  {
    QFile file(bad);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("no picture");
  }
  QString said;
  QTimer look;
  QObject::connect(&look,
    &QTimer::timeout,
    [&said]
    {
      if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
      {
        said = box->text();
        box->close();
      }
    });
  look.start(20);
  EXPECT_FALSE(sheet.window.openPicture(bad));
  EXPECT_TRUE(said.contains("bad.png")) << said.toStdString();
  EXPECT_EQ(sheet.view->mesh(), shown);
  EXPECT_EQ(sheet.document->digest(), made);
}

TEST(Drawing, ItsFormAndItsKeys)
{
  Sheet sheet;
  sheet.open();
  sheet.line(beast());
  const std::string inflated = sheet.document->digest();
  Values values = sheet.step(0).values;
  values["Quads"] = true;
  sheet.document->setParameters(0, values, std::nullopt);
  sheet.settle();
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_EQ(sheet.mesh()->GetMaxCellSize(), 4);
  EXPECT_TRUE(sheet.view->mesh());
  values["Quads"] = false;
  values["ExtrudeDepth"] = 20.0;
  sheet.document->setParameters(0, values, std::nullopt);
  sheet.settle();
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_NEAR(sheet.mesh()->GetBounds()[5], 20.0, 1e-9);
  EXPECT_NE(sheet.document->digest(), inflated);
  // Keys of its own: sides change, the magnet goes.
  auto* sides = sheet.window.findChild<QSplitter*>();
  EXPECT_LT(sides->indexOf(sheet.pad->parentWidget()), sides->indexOf(sheet.view->parentWidget()));
  QTest::keyClick(&sheet.window, Qt::Key_V);
  EXPECT_GT(sides->indexOf(sheet.pad->parentWidget()), sides->indexOf(sheet.view->parentWidget()));
  QTest::keyClick(&sheet.window, Qt::Key_F4);
  auto* magnetic = sheet.window.findChild<QAction*>("magnetic");
  EXPECT_FALSE(magnetic->isChecked());
  sheet.line(ring({ 240, 185 }, 20));
  const auto strokes = sheet.strokes();
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_EQ(strokes[0].line->GetCellData()->GetArray("Magnetic")->GetComponent(0, 0), 1.0);
  EXPECT_EQ(strokes[1].line->GetCellData()->GetArray("Magnetic")->GetComponent(0, 0), 0.0);
  QTest::keyClick(&sheet.window, Qt::Key_F4);
  EXPECT_TRUE(magnetic->isChecked());
  const QString listed = QString::fromUtf8(sheet.view->camera()->GetKeyList());
  EXPECT_TRUE(listed.contains("\nF4, V ") && listed.contains("\nF5 ") && listed.contains("In the picture:\n"))
    << listed.toStdString();
}

TEST(Drawing, ItsBackWearsAPictureOfItsOwn)
{
  Sheet sheet;
  QAction *with = sheet.action("Picture of the &back…"),
          *without = sheet.action("&Without a picture of the back");
  EXPECT_FALSE(with->isEnabled()) << "there is no drawing";
  sheet.open();
  sheet.line(beast());
  const std::string before = sheet.document->digest();
  EXPECT_FALSE(without->isEnabled());
  const QString path = sheet.folder.filePath("back.png");
  QImage leaf(width, height, QImage::Format_RGB32);
  leaf.fill(QColor(40, 170, 60));
  ASSERT_TRUE(leaf.save(path));
  sheet.choose(with->text(), path);
  EXPECT_EQ(sheet.failure(), "");
  const auto& inputs = [&]() -> const auto&
  {
    return sheet.step(0).inputs;
  };
  ASSERT_EQ(inputs().count("BackPicture"), 1u);
  EXPECT_EQ(std::get<Image>(inputs().at("BackPicture")).name, "back.png");
  EXPECT_EQ(oversketch_files::picturesOf(sheet.mesh()).size(), 2u);
  const std::string both = sheet.document->digest();
  EXPECT_NE(both, before);
  EXPECT_EQ(replayed(sheet.session()), both);
  // Seen from behind, and not from the front.
  const auto green = [](const QImage& seen)
  { return count(seen, [](const QColor& c) { return c.green() > 2 * c.red() && c.green() > 60; }); };
  EXPECT_LT(green(sheet.pictureAtRest()), 200);
  QTest::keyClick(sheet.view, Qt::Key_4, Qt::ControlModifier);
  EXPECT_TRUE(
    sheet.comes([&](const QImage& seen) { return green(seen) > seen.width() * seen.height() / 20; }));
  // One step of undo each.
  QTest::keyClick(sheet.view, Qt::Key_Z, Qt::ControlModifier);
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), before);
  EXPECT_FALSE(without->isEnabled());
  QTest::keyClick(sheet.view, Qt::Key_Y, Qt::ControlModifier);
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), both);
  ASSERT_TRUE(without->isEnabled());
  without->trigger();
  sheet.settle();
  EXPECT_EQ(inputs().count("BackPicture"), 0u);
  EXPECT_EQ(sheet.document->digest(), before);
  QTest::keyClick(sheet.view, Qt::Key_Z, Qt::ControlModifier);
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), both);
}

TEST(Drawing, AGreyFormHasTheValuesOfWhatIsShown)
{
  Sheet sheet;
  sheet.open();
  sheet.line(beast());
  Values values = sheet.step(0).values;
  values["ExtrudeDepth"] = 65.0;
  sheet.document->setParameters(0, values, std::nullopt);
  sheet.settle();
  auto* form = sheet.window.findChild<StepPanel*>();
  const auto field = [form](const char* spoken) -> QWidget*
  {
    const auto all = form->currentWidget()->findChildren<QWidget*>();
    const auto one = std::find_if(
      all.begin(), all.end(), [spoken](QWidget* widget) { return widget->accessibleName() == spoken; });
    return one == all.end() ? nullptr : *one;
  };
  const auto extruded = [&] { return qobject_cast<QSlider*>(field("Extruded by")); };
  ASSERT_TRUE(extruded());
  const int set = extruded()->value();
  EXPECT_GT(set, 0);
  sheet.list->setCurrentRow(-1);
  ASSERT_TRUE(extruded());
  EXPECT_FALSE(extruded()->isEnabled());
  EXPECT_EQ(extruded()->value(), set);
  // Another tool has its own form, with what the hand made by it last.
  sheet.list->setCurrentRow(0);
  QTest::keyClick(sheet.view, Qt::Key_7);
  sheet.settle();
  EXPECT_FALSE(extruded()) << "the form is still the drawing's";
  auto* copy = qobject_cast<QComboBox*>(field("Copy"));
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->currentIndex(), 0);
  sheet.pictureAtRest();
  const double middle[3] = { 140.0, 180.0, 0.0 };
  QTest::mouseDClick(sheet.view, Qt::LeftButton, Qt::NoModifier, sheet.seen(middle));
  sheet.settle();
  ASSERT_EQ(sheet.session().nodes.size(), 2u);
  EXPECT_EQ(sheet.list->currentRow(), -1);
  EXPECT_EQ(copy->currentIndex(), 1);
  EXPECT_FALSE(copy->isEnabled());
}

TEST(Drawing, AnEmptyCanvasIsDrawnOn)
{
  Sheet sheet;
  QApplication::setActiveWindow(&sheet.window);
  sheet.action("New on an empty &canvas")->trigger();
  sheet.settle();
  ASSERT_TRUE(sheet.pad->isVisible());
  sheet.line(ring({ 500, 400 }, 200, 120));
  EXPECT_EQ(sheet.failure(), "");
  ASSERT_TRUE(sheet.mesh());
  EXPECT_EQ(eulerOf(sheet.mesh()), 2);
  EXPECT_EQ(openEdges(sheet.mesh()), 0);
  EXPECT_TRUE(oversketch_files::textureOf(sheet.mesh()).empty());
  EXPECT_EQ(sheet.document->digest(), replayed(sheet.session()));
  // A model that is opened then is drawn on itself.
  sheet.document->discardAutosave();
  sheet.document->open(Document::read(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", 0));
  sheet.settle();
  EXPECT_FALSE(sheet.pad->isVisible());
  EXPECT_TRUE(sheet.view->mesh());
}
