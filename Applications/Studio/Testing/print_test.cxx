// Export for print: what the dialogue says, what the view shows meanwhile, and the file.
#include "mesh_file.h"
#include "print_dialog.h"
#include "scene.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>

using namespace oversketch_studio;

namespace
{

bool isThinRed(const QColor& pixel)
{
  return pixel.red() > 2 * pixel.blue() && pixel.red() > 60;
}

struct PrintScene : Scene
{
  PrintScene()
  {
    QSettings().remove("printHeight");
    QSettings().remove("printWall");
    this->action(QString::fromUtf8("Export &for print…"))->trigger();
    this->dialog = this->window.findChild<PrintDialog*>();
  }
  QDoubleSpinBox* field(const char* name) { return this->dialog->findChild<QDoubleSpinBox*>(name); }
  QString text(const char* name) { return this->dialog->findChild<QLabel*>(name)->text(); }
  // Writes by the dialogue's button, under that name.
  void write(const QString& path)
  {
    QTimer look;
    QObject::connect(&look,
      &QTimer::timeout,
      [&path]
      {
        if (auto* name = qobject_cast<QFileDialog*>(QApplication::activeModalWidget()))
        {
          name->selectFile(path); // leaves no file of that folder selected that the dialogue proposed
          static_cast<QDialog*>(name)->accept();
        }
      });
    look.start(5);
    for (auto* button : this->dialog->findChildren<QPushButton*>())
    {
      if (button->text().startsWith("&Write"))
      {
        button->click();
      }
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path); }, 60000));
  }

  QPointer<PrintDialog> dialog;
};

} // namespace

TEST(Print, TheDialogueSaysWhatTheCheckFoundAndTheViewShowsIt)
{
  PrintScene scene;
  ASSERT_TRUE(scene.dialog && scene.dialog->isVisible());
  EXPECT_EQ(scene.field("printHeight")->value(), 100.0);
  EXPECT_EQ(scene.field("printWall")->value(), 0.8);
  EXPECT_TRUE(scene.text("words").contains("Size: ")) << qPrintable(scene.text("words"));
  EXPECT_TRUE(scene.text("words").contains("Closed: no edge is open.")) << qPrintable(scene.text("words"));
  const QString verdict = scene.text("verdict");
  scene.field("printWall")->setValue(0.0);
  const int none = count(scene.pictureAtRest(), isThinRed);
  scene.field("printWall")->setValue(500.0);
  EXPECT_TRUE(scene.text("words").contains("Walls thinner than 500 mm")) << qPrintable(scene.text("words"));
  EXPECT_TRUE(scene.text("verdict").startsWith("Not ready to print.")) << qPrintable(scene.text("verdict"));
  EXPECT_GT(count(scene.pictureAtRest(), isThinRed), none + 3000);
  // Twice as high is twice as thick.
  const auto area = [&] { return scene.text("words").section("mm: ", 1).section(' ', 0, 0).toDouble(); };
  scene.field("printWall")->setValue(5.0);
  scene.field("printHeight")->setValue(50.0);
  const double before = area();
  scene.field("printWall")->setValue(10.0);
  scene.field("printHeight")->setValue(100.0);
  EXPECT_GT(before, 0.0);
  EXPECT_NEAR(area() / before, 4.0, 0.05) << qPrintable(verdict);
  scene.dialog->reject();
  EXPECT_LT(count(scene.pictureAtRest(), isThinRed), none + 100) << "the model is as it was";
}

TEST(Print, WritesInMillimetresAsItStandsOnATable)
{
  const QTemporaryDir folder;
  PrintScene scene;
  ASSERT_TRUE(scene.dialog);
  scene.field("printHeight")->setValue(42.0);
  scene.write(folder.filePath("dog.stl"));
  oversketch_files::Notes notes;
  const auto printed = oversketch_files::readMesh(folder.filePath("dog.stl").toStdString(), notes);
  vtkPolyData* model = scene.document->result().mesh;
  double is[6], was[6];
  printed->GetBounds(is);
  model->GetBounds(was);
  const double unit = 42.0 / (was[3] - was[2]);
  EXPECT_NEAR(is[5], 42.0, 1e-4) << "what was up along y is along z";
  EXPECT_NEAR(is[1], unit * (was[1] - was[0]), 1e-4);
  EXPECT_NEAR(is[3], unit * (was[5] - was[4]), 1e-4);
  EXPECT_NEAR(std::abs(is[0]) + std::abs(is[2]) + std::abs(is[4]), 0.0, 1e-4);
  EXPECT_EQ(printed->GetNumberOfPolys(), model->GetNumberOfPolys());
  EXPECT_FALSE(scene.dialog && scene.dialog->isVisible());
}

TEST(Print, AChangeOfTheModelEndsIt)
{
  const QTemporaryDir folder;
  PrintScene scene;
  ASSERT_TRUE(scene.dialog && scene.dialog->isVisible());
  scene.write(folder.filePath("dog.3mf"));
  QFile file(folder.filePath("dog.3mf"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().startsWith("PK"));
  scene.action(QString::fromUtf8("Export &for print…"))->trigger();
  scene.dialog = scene.window.findChild<PrintDialog*>();
  ASSERT_TRUE(scene.dialog && scene.dialog->isVisible());
  scene.draw();
  scene.release();
  scene.wait();
  EXPECT_FALSE(scene.dialog && scene.dialog->isVisible());
  EXPECT_FALSE(scene.view->display().instead());
}
