// What is on screen when a stroke ends: the line first, and no frame that only keeps the next one waiting.
#include "scene.h"
#include "tool.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <QElapsedTimer>
#include <QTemporaryDir>

#include <functional>
#include <utility>

using namespace oversketch_studio;

namespace
{

// Does something at the end of each frame of a window, or of a renderer.
class AfterFrames
{
public:
  AfterFrames(vtkObject* of, std::function<void()> act)
    : Of(of)
    , Act(std::move(act))
  {
    this->Ear->SetClientData(this);
    this->Ear->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<AfterFrames*>(self)->Act(); });
    of->AddObserver(vtkCommand::EndEvent, this->Ear);
  }
  ~AfterFrames() { this->Of->RemoveObserver(this->Ear); }

private:
  vtkObject* Of;
  std::function<void()> Act;
  vtkNew<vtkCallbackCommand> Ear;
};

// Counts what is painted, or puts it off, as Qt does with what follows closely on the last.
struct Painting : QObject
{
  Painting(QWidget* view, QWidget* window)
  {
    view->installEventFilter(this);
    window->installEventFilter(this);
  }
  bool eventFilter(QObject*, QEvent* event) override
  {
    this->count += event->type() == QEvent::Paint;
    return this->putOff && event->type() == QEvent::UpdateRequest;
  }
  bool putOff = false;
  int count = 0;
};

} // namespace

TEST(Screen, TheWholeLineIsPaintedBeforeTheStrokeRuns)
{
  Scene scene;
  scene.draw();
  bool drawn = false;
  int paintedBefore = -1;
  const AfterFrames seen(scene.view->renderWindow(), [&] { drawn = true; });
  Painting painting(scene.view, &scene.window);
  QObject::connect(scene.view->tool(), &Tool::drawn, [&] { paintedBefore = painting.count; });
  painting.putOff = true;
  moveMouse(scene.view, scene.end += QPoint(3, 1));
  EXPECT_TRUE(QTest::qWaitFor([&] { return drawn; }, 60000));
  painting.putOff = false;
  painting.count = 0;
  scene.release();
  EXPECT_GT(paintedBefore, 0);
  scene.wait();
}

TEST(Screen, NoFrameIsDrawnWhileAMeshIsAwaited)
{
  Scene scene;
  const auto awaited = [&](const char* what)
  {
    int frames = 0;
    const AfterFrames counted(scene.renderer(), [&] { ++frames; });
    QElapsedTimer time;
    time.start();
    int before = -1;
    qint64 took = 0;
    const auto heard = QObject::connect(scene.document,
      &Document::shown,
      [&]
      {
        before = frames;
        took = time.elapsed();
      });
    scene.wait();
    QObject::disconnect(heard);
    EXPECT_GE(before, 1) << what << ": the mesh is not painted when it comes";
    // And nothing before it, but for each half a second a frame, whose edges are smoothed once.
    EXPECT_LE(before, 1 + 2 * (took / 500)) << what << " in " << took << " ms";
  };
  scene.draw();
  scene.release();
  awaited("a stroke");
  scene.document->undo();
  awaited("undo");
  scene.document->redo();
  awaited("redo");
}

TEST(Screen, AFrameThatWaitsIsDrawnAtThePress)
{
  Scene scene;
  scene.draw();
  scene.release();
  ASSERT_TRUE(scene.document->isBusy());
  int frames = 0;
  const AfterFrames counted(scene.renderer(), [&] { ++frames; });
  QTest::mousePress(scene.view, Qt::MiddleButton, Qt::NoModifier, { 20, 20 });
  EXPECT_GT(frames, 0);
  QTest::mouseRelease(scene.view, Qt::MiddleButton, Qt::NoModifier, { 20, 20 });
  scene.wait();
}

TEST(Screen, ASaveTakesNothingAway)
{
  Scene scene;
  scene.draw();
  scene.release();
  scene.wait();
  const QImage before = scene.pictureAtRest();
  const QTemporaryDir folder;
  scene.document->save(folder.filePath("a.oversketch"));
  EXPECT_TRUE(scene.pictureAtRest() == before);
  // The line can still be moved.
  QTest::mousePress(scene.view, Qt::LeftButton, Qt::NoModifier, scene.end);
  moveMouse(scene.view, scene.end + QPoint(30, 0));
  QTest::mouseRelease(scene.view, Qt::LeftButton, Qt::NoModifier, scene.end + QPoint(30, 0));
  scene.wait();
  EXPECT_EQ(scene.document->session().nodes.size(), 1u) << "another line was drawn";
}
