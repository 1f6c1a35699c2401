// Pictures behind the model: listed, seen in their view alone, undone, kept.
#include "scene.h"

#include <QDropEvent>
#include <QListWidget>
#include <QMimeData>
#include <QTemporaryDir>
#include <QUrl>

using namespace oversketch_studio;

namespace
{

// Pixels of pure magenta that the view shows.
int magenta(Viewport* view)
{
  QTest::qWait(50); // the frame that was asked for
  const QImage image = view->grabFramebuffer();
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      const QColor c = image.pixelColor(x, y);
      found += c.red() > 250 && c.green() < 5 && c.blue() > 250;
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
  EXPECT_EQ(magenta(scene.view), 0);
  drop(scene.window, path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return list->count() == 2; }, 60000));
  EXPECT_EQ(list->item(1)->text(), "front.png");
  const int seen = magenta(scene.view);
  const int edges = seen / 100; // which are smoothed at rest where the processor draws
  // A square as high as the view, but for the model before it.
  EXPECT_GT(seen, scene.view->height() * scene.view->height() / 3);
  EXPECT_LT(seen, scene.view->height() * scene.view->height());
  // From elsewhere it is not seen; its own view shows it again.
  QTest::keyClick(scene.view, Qt::Key_X);
  EXPECT_EQ(magenta(scene.view), 0);
  QTest::keyClick(scene.view, Qt::Key_W);
  EXPECT_NEAR(magenta(scene.view), seen, edges);
  list->item(1)->setCheckState(Qt::Unchecked);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !scene.document->session().pictures[0]->shown; }, 60000));
  EXPECT_EQ(magenta(scene.view), 0);
  scene.document->undo();
  scene.wait();
  EXPECT_NEAR(magenta(scene.view), seen, edges);
  // Kept with the session; taken away by undo.
  const QString file = folder.filePath("a.oversketch");
  scene.document->save(file);
  scene.document->undo();
  scene.wait();
  EXPECT_EQ(list->count(), 1);
  EXPECT_EQ(magenta(scene.view), 0);
  scene.document->discardAutosave();
  scene.document->open(Document::read(file, 0));
  scene.wait();
  ASSERT_EQ(scene.document->session().pictures.size(), 1u);
  EXPECT_EQ(list->count(), 2);
  EXPECT_NEAR(magenta(scene.view), seen, edges);
}
