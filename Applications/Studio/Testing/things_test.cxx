// What is in the scene: the model, or each of its parts, is hidden, shown and written by itself.
#include "mesh_file.h"
#include "pieces.h"
#include "scene_panel.h"
#include "sheet.h"
#include "texture.h"

#include "vtkCellData.h"

#include <QLineEdit>

#include <functional>

using namespace oversketch_studio;

namespace
{

// A body over the picture, and rings of other pictures beside it.
struct Pieces : Sheet
{
  explicit Pieces(int count)
  {
    this->open();
    this->line(beast());
    auto* rows = this->window.findChild<QListWidget*>("history");
    for (int i = 1; i < count; ++i)
    {
      this->document->add(*this->document->partReader(this->file)().step);
      this->settle();
      this->document->setPlacement(i, { { 500.0 * i, 0.0, 500.0 * i + 400.0, 300.0 }, 0.0 }, false);
      this->settle();
      rows->setCurrentRow(2 * i); // below each is its line's
      this->settle();
      this->line(ring({ 200, 150 }, 60));
    }
    rows->setCurrentRow(0); // no box of a part is in the view
    this->view->display().showWhole(this->view->fittedSize().data());
  }
  QImage tick(int row, bool on)
  {
    this->things->item(row)->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    return this->picture();
  }
  QImage picture()
  {
    this->settle();
    this->view->renderSoon();
    return this->pictureAtRest();
  }
  bool isTicked(int row) { return this->things->item(row)->checkState() == Qt::Checked; }

  QListWidget* things = this->window.findChild<QListWidget*>("scene");
};

} // namespace

TEST(Things, PartsAreHiddenAndWrittenByThemselves)
{
  Sheet sheet;
  auto* list = sheet.window.findChild<QListWidget*>("scene");
  ASSERT_EQ(list->count(), 1);
  const auto tick = [&](int row, bool on)
  {
    list->item(row)->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    QApplication::processEvents();
    return sheet.pictureAtRest();
  };
  // A model of one part.
  const QImage whole = sheet.pictureAtRest();
  const QImage empty = tick(0, false);
  EXPECT_GT(differing(whole, empty), 10000) << "the model is not hidden";
  EXPECT_TRUE(sheet.document->isModified()) << "kept with the session";
  EXPECT_EQ(differing(tick(0, true), empty), differing(whole, empty));
  sheet.document->undo();
  sheet.document->undo();
  EXPECT_FALSE(sheet.document->isModified());
  // Of two: each by itself, also by the file.
  sheet.open();
  sheet.line(beast());
  sheet.document->add(*sheet.document->partReader(sheet.file)().step);
  sheet.settle();
  auto* rows = sheet.window.findChild<QListWidget*>("history");
  rows->setCurrentRow(2);
  sheet.settle();
  sheet.line(ring({ 200, 150 }, 60));
  ASSERT_EQ(oversketch_files::partsOf(sheet.mesh()).size(), 2u);
  ASSERT_EQ(list->count(), 2);
  EXPECT_EQ(list->item(0)->text().toStdString(), sheet.session().nodes[0].name);
  EXPECT_EQ(list->item(1)->text().toStdString(), sheet.session().nodes[1].name);
  const std::string digest = sheet.document->digest();
  const QImage none = (tick(0, false), tick(1, false));
  const int second = differing(tick(1, true), none), both = differing(tick(0, true), none);
  EXPECT_GT(second, 300);
  EXPECT_GT(both, second);
  EXPECT_EQ(sheet.document->digest(), digest) << "a look changes the model";
  for (int part = 0; part < 2; ++part)
  {
    const auto alone = oversketch_files::partAlone(sheet.mesh(), part);
    EXPECT_EQ(openEdges(alone), 0);
    EXPECT_EQ(eulerOf(alone), 2) << "one closed surface";
    EXPECT_FALSE(oversketch_files::textureOf(alone).empty());
    const auto rest = oversketch_files::withoutParts(sheet.mesh(), { 1 - part });
    EXPECT_EQ(rest->GetNumberOfPolys(), alone->GetNumberOfPolys());
    EXPECT_EQ(rest->GetNumberOfPoints(), sheet.mesh()->GetNumberOfPoints());
    EXPECT_EQ(rest->GetCellData()->GetNumberOfTuples(), rest->GetNumberOfPolys());
  }
  list->setCurrentRow(1);
  const QString path = sheet.folder.filePath("one.ply");
  QTimer timer;
  QObject::connect(&timer,
    &QTimer::timeout,
    [&]
    {
      QWidget* asked = QApplication::activeModalWidget();
      if (auto* name = asked ? asked->findChild<QLineEdit*>() : nullptr)
      {
        name->setText(path);
        QTest::keyClick(name, Qt::Key_Return);
      }
      else if (asked) // what the format drops
      {
        asked->close();
      }
    });
  timer.start(100);
  sheet.window.findChild<ScenePanel*>()->exporting()->trigger();
  timer.stop();
  oversketch_files::Notes notes;
  const auto written = oversketch_files::readMesh(path.toStdString(), notes);
  EXPECT_EQ(written->GetNumberOfPolys(), oversketch_files::partAlone(sheet.mesh(), 1)->GetNumberOfPolys());
}

TEST(Things, PartsThatAreHiddenStaySo)
{
  Pieces all(3);
  ASSERT_EQ(all.things->count(), 3);
  const QImage whole = all.picture();
  const QString plain = all.folder.filePath("plain.oversketch"), file = all.folder.filePath("a.oversketch");
  all.document->save(plain);
  const QImage hidden = all.tick(2, false);
  const int seen = differing(whole, hidden);
  EXPECT_GT(seen, 300);
  EXPECT_TRUE(all.document->isModified()) << "kept with the session";
  // As a model that is hidden, one step of undo.
  all.document->undo();
  EXPECT_LT(differing(all.picture(), whole), 20);
  EXPECT_TRUE(all.isTicked(2));
  EXPECT_FALSE(all.document->isModified());
  all.document->redo();
  EXPECT_LT(differing(all.picture(), hidden), 20);
  EXPECT_FALSE(all.isTicked(2));
  // It has another number while a step before it is off.
  all.document->setOn(1, false);
  const QImage two = all.picture();
  ASSERT_EQ(all.things->count(), 2);
  EXPECT_TRUE(all.isTicked(0));
  EXPECT_FALSE(all.isTicked(1));
  all.document->setOn(1, true);
  EXPECT_LT(differing(all.picture(), hidden), 20);
  EXPECT_FALSE(all.isTicked(2));
  EXPECT_GT(differing(two, hidden), 300);
  // What a hand goes on with after it is a step of undo by itself.
  const std::string before = all.document->digest();
  all.document->setPlacement(1, { { 500.0, 50.0, 900.0, 350.0 }, 0.0 }, false);
  all.settle();
  const std::string moved = all.document->digest();
  EXPECT_TRUE((all.tick(2, true), all.isTicked(2)));
  all.document->setPlacement(1, { { 500.0, 90.0, 900.0, 390.0 }, 0.0 }, true);
  all.settle();
  all.document->undo();
  all.settle();
  EXPECT_EQ(all.document->digest(), moved);
  EXPECT_TRUE(all.isTicked(2));
  all.document->undo();
  all.document->undo();
  all.settle();
  EXPECT_EQ(all.document->digest(), before);
  EXPECT_FALSE(all.isTicked(2));
  // In the file, and of that session alone.
  all.document->save(file);
  ASSERT_TRUE(all.window.open(plain));
  EXPECT_LT(differing(all.picture(), whole), 20);
  ASSERT_TRUE(all.window.open(file));
  EXPECT_LT(differing(all.picture(), hidden), 20);
  ASSERT_EQ(all.things->count(), 3);
  EXPECT_FALSE(all.isTicked(2));
  EXPECT_FALSE(all.document->isModified());
  // While another model is worked on, too.
  all.document->addModels(Document::readModels(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", 0));
  all.settle();
  ASSERT_EQ(all.document->session().place, 1u);
  const QImage rests = all.picture();
  all.document->undo();
  all.settle();
  all.tick(2, true);
  all.document->addModels(Document::readModels(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", 0));
  all.settle();
  EXPECT_GT(differing(all.picture(), rests), seen / 2);
  all.document->chooseModel(0);
  all.settle();
  EXPECT_TRUE(all.isTicked(3));
}
