// What is in the scene: the model, or each of its parts, is hidden, shown and written by itself.
#include "mesh_file.h"
#include "pieces.h"
#include "scene_panel.h"
#include "sheet.h"
#include "texture.h"

#include "vtkCellData.h"

#include <QLineEdit>

using namespace oversketch_studio;

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
  sheet.document->add(*sheet.document->partReader(sheet.file)());
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
