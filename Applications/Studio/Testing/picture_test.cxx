// Pictures behind the model: listed, seen in their view alone, undone, kept.
#include "drawing_lines.h"
#include "picture_files.h"
#include "scene.h"
#include "scene_panel.h"

#include <QDropEvent>
#include <QFile>
#include <QListWidget>
#include <QMimeData>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUrl>

using namespace oversketch_studio;

namespace
{

// Pixels of magenta that the view shows, pure but for so much of 255.
int magenta(Scene& scene, int faded = 4)
{
  const QImage image = scene.pictureAtRest();
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      const QColor c = image.pixelColor(x, y);
      found += c.red() >= 255 - faded && c.green() <= faded && c.blue() >= 255 - faded;
    }
  }
  return found;
}

void drop(MainWindow& window, const QString& path)
{
  QMimeData files;
  files.setUrls({ QUrl::fromLocalFile(path) });
  QDragEnterEvent entered({ 100, 100 }, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &entered);
  QDropEvent dropped({ 100, 100 }, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &dropped);
}

} // namespace

// A photograph of a phone is stored on its side, and says so.
TEST(Pictures, AreDrawnOverAsTheyWereTaken)
{
  const QTemporaryDir folder;
  QImage wide(64, 32, QImage::Format_RGB32);
  wide.fill(Qt::red);
  const auto canvasOver = [&](const QString& name)
  {
    const ReadPicture read = readPicture(folder.filePath(name));
    const auto canvas = oversketch_session::canvasOf(*oversketch_session::drawingOver(read.image));
    const int* size = read.decoded->pixels->GetDimensions();
    EXPECT_EQ(canvas[2] - canvas[0], size[0]);
    return QSize(size[0], size[1]);
  };
  for (const char* name : { "a.jpg", "a.bmp", "a.png" })
  {
    ASSERT_TRUE(wide.save(folder.filePath(name)));
    EXPECT_EQ(canvasOver(name), QSize(64, 32)) << name;
  }
  QFile file(folder.filePath("a.jpg"));
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  QByteArray bytes = file.readAll();
  bytes.insert(2,
    QByteArray("\xff\xe1\0\x22"
               "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
      36));
  file.seek(0);
  file.write(bytes);
  file.close();
  EXPECT_EQ(canvasOver("a.jpg"), QSize(32, 64));
  for (const char* kind : { "png", "jpg", "jpeg", "webp", "bmp", "tif", "tiff" })
  {
    EXPECT_TRUE(pictureExtensions().contains(kind)) << kind;
  }
}

TEST(Pictures, AreSeenInTheirViewAndKept)
{
  const QTemporaryDir folder;
  const QString path = folder.filePath("front.png");
  QImage square(64, 64, QImage::Format_RGB32);
  square.fill(Qt::magenta);
  ASSERT_TRUE(square.save(path));
  Scene scene;
  auto* list = scene.window.findChild<QListWidget*>("scene");
  ASSERT_EQ(list->count(), 1);
  EXPECT_EQ(magenta(scene), 0);
  drop(scene.window, path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return list->count() == 2; }, 60000));
  EXPECT_EQ(list->item(1)->text(), "front.png");
  const int seen = magenta(scene);
  const int edges = seen / 100; // which are smoothed at rest where the processor draws
  // A square as high as the view, but for the model before it.
  EXPECT_GT(seen, scene.view->height() * scene.view->height() / 3);
  EXPECT_LT(seen, scene.view->height() * scene.view->height());
  // From elsewhere it is not seen; its own view shows it again.
  QTest::keyClick(scene.view, Qt::Key_X);
  EXPECT_EQ(magenta(scene), 0);
  QTest::keyClick(scene.view, Qt::Key_W);
  EXPECT_NEAR(magenta(scene), seen, edges);
  QTest::keyClick(scene.view, Qt::Key_X);
  EXPECT_EQ(magenta(scene), 0);
  QToolButton *its = nullptr, *lock = nullptr, *remove = nullptr;
  for (auto* button : scene.window.findChild<ScenePanel*>()->findChildren<QToolButton*>())
  {
    its = button->text() == "Its view" ? button : its;
    lock = button->text() == "Lock" ? button : lock;
    remove = button->text() == "Remove" ? button : remove;
  }
  ASSERT_TRUE(its && lock && remove);
  QTest::mouseClick(its, Qt::LeftButton);
  EXPECT_NEAR(magenta(scene), seen, edges);
  // Fainter, down to nothing; each a step of undo.
  auto* opacity = scene.window.findChild<ScenePanel*>()->findChild<QSlider*>();
  const auto given = [&] { return scene.document->session().pictures.at(0)->opacity; };
  QTest::keyClick(opacity, Qt::Key_PageDown);
  EXPECT_EQ(given(), 0.9);
  EXPECT_EQ(magenta(scene), 0);
  EXPECT_NEAR(magenta(scene, 50), seen, edges);
  QTest::keyClick(opacity, Qt::Key_Home);
  EXPECT_EQ(given(), 0.0);
  EXPECT_EQ(magenta(scene, 100), 0);
  scene.document->undo();
  scene.document->undo();
  scene.wait();
  EXPECT_EQ(given(), 1.0);
  EXPECT_EQ(opacity->value(), 100);
  EXPECT_NEAR(magenta(scene), seen, edges);
  // A locked one stays as it is; it can be hidden as a model can.
  QTest::mouseClick(lock, Qt::LeftButton);
  EXPECT_TRUE(scene.document->session().pictures[0]->locked);
  EXPECT_EQ(list->item(1)->text(), "front.png (locked)");
  EXPECT_TRUE(its->isEnabled());
  QTest::keyClick(opacity, Qt::Key_Home);
  QTest::mouseClick(remove, Qt::LeftButton);
  ASSERT_EQ(scene.document->session().pictures.size(), 1u);
  EXPECT_EQ(given(), 1.0);
  QTest::mouseClick(lock, Qt::LeftButton);
  EXPECT_FALSE(scene.document->session().pictures[0]->locked);
  QTest::mouseClick(remove, Qt::LeftButton);
  EXPECT_TRUE(scene.document->session().pictures.empty());
  for (int i = 0; i < 3; ++i)
  {
    scene.document->undo();
  }
  scene.wait();
  EXPECT_EQ(list->item(1)->text(), "front.png");
  list->item(1)->setCheckState(Qt::Unchecked);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !scene.document->session().pictures[0]->shown; }, 60000));
  EXPECT_EQ(magenta(scene), 0);
  scene.document->undo();
  scene.wait();
  EXPECT_NEAR(magenta(scene), seen, edges);
  // Kept with the session; taken away by undo.
  const QString file = folder.filePath("a.oversketch");
  scene.document->save(file);
  scene.document->undo();
  scene.wait();
  EXPECT_EQ(list->count(), 1);
  EXPECT_EQ(magenta(scene), 0);
  scene.document->discardAutosave();
  scene.document->open(Document::read(file, 0));
  scene.wait();
  ASSERT_EQ(scene.document->session().pictures.size(), 1u);
  EXPECT_EQ(list->count(), 2);
  EXPECT_NEAR(magenta(scene), seen, edges);
}
