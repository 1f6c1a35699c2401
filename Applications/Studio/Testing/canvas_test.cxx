// The canvas of the tool Image to model: how what is drawn over, and drawn, is seen.
#include "mouse.h"
#include "sheet.h"

#include "vtkOversketchDrawingWidget.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <QElapsedTimer>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <set>
#include <vector>

using namespace oversketch_studio;

// The view becomes narrower: the smaller side of what it shows stays whole.
TEST(Drawing, AnEnlargedPictureIsFitted)
{
  DrawingPad pad;
  pad.resize(400, 400);
  pad.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&pad, 60000));
  pad.setCanvas(0.0, 0.0, 1000.0, 1000.0);
  QApplication::processEvents();
  const QPoint middle(200, 200);
  for (int i = 0; i < 5; ++i)
  {
    QWheelEvent wheel(middle,
      pad.mapToGlobal(middle),
      {},
      { 0, 120 },
      Qt::NoButton,
      Qt::NoModifier,
      Qt::NoScrollPhase,
      false);
    QApplication::sendEvent(&pad, &wheel);
  }
  const auto across = [&]
  {
    return 2.0 * pad.renderer()->GetActiveCamera()->GetParallelScale() *
           std::min(1.0, double(pad.width()) / pad.height());
  };
  const double before = across();
  EXPECT_LT(before, 700.0) << "it is not enlarged";
  for (const QSize& size : { QSize(200, 400), QSize(400, 200), QSize(400, 400) })
  {
    pad.resize(size);
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(across() - before) < 0.01 * before; }, 10000))
      << size.width() << " x " << size.height() << ": " << across() << " of " << before;
  }
}

// A sample's line is painted at once, however large the picture is: while the pen draws nothing else is drawn
// anew.
TEST(Drawing, ALineOverALargePictureDoesNotLag)
{
  DrawingPad pad;
  pad.widget()->SetMagnetic(false); // looks for edges when the pen goes up
  pad.resize(480, 640);
  pad.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&pad, 60000));
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(4096, 4096, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(picture->GetScalarPointer()), 3 * 4096 * 4096, 200);
  pad.setPicture(picture);
  QApplication::processEvents();
  const auto at = [](int i)
  { return QPoint(60 + 3 * i, 300 + static_cast<int>(std::lround(60 * std::sin(0.1 * i)))); };
  QTest::mousePress(&pad, Qt::LeftButton, Qt::NoModifier, at(0));
  QApplication::processEvents();
  int frames = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&frames);
  count->SetCallback([](vtkObject*, unsigned long, void* of, void*) { ++*static_cast<int*>(of); });
  pad.renderWindow()->AddObserver(vtkCommand::EndEvent, count);
  std::vector<double> waited, worked; // ms
  for (int i = 1; i <= 100; ++i)
  {
    const std::clock_t before = std::clock();
    QElapsedTimer time;
    time.start();
    const int last = frames;
    moveMouse(&pad, at(i));
    while (frames == last && time.elapsed() < 1000)
    {
      QApplication::processEvents();
    }
    waited.push_back(1e-6 * static_cast<double>(time.nsecsElapsed()));
    worked.push_back(1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  }
  EXPECT_EQ(frames, 100);
  // One frame shows all that has come meanwhile.
  for (int i = 101; i <= 120; ++i)
  {
    moveMouse(&pad, at(i));
  }
  for (int i = 0; i < 10; ++i)
  {
    QApplication::processEvents();
  }
  EXPECT_EQ(frames, 101);
  QTest::mouseRelease(&pad, Qt::LeftButton, Qt::NoModifier, at(120));
  std::sort(waited.begin(), waited.end());
  std::sort(worked.begin(), worked.end());
  RecordProperty("p95_ms", static_cast<int>(std::lround(waited[95])));
  std::printf("sample to painted line: median %.1f ms, p95 %.1f ms; of processors %.1f, %.1f\n",
    waited[50],
    waited[95],
    worked[50],
    worked[95]);
  // By the processors' time, which other programs do not make longer.
  EXPECT_LT(worked[95], 33.0);
}

// One frame more is drawn when nothing moves, and then none, where the processor draws.
TEST(Drawing, AMirrorPlaneGoesThroughWhatWasDrawn)
{
  Sheet sheet;
  sheet.open();
  EXPECT_FALSE(sheet.document->mirrorPlane(1)) << "nothing is drawn yet";
  sheet.line(beast());
  const auto across = sheet.document->mirrorPlane(1), along = sheet.document->mirrorPlane(3);
  ASSERT_TRUE(across && along);
  EXPECT_NEAR(across->offset, 200.0, 3.0);
  EXPECT_EQ(along->offset, 0.0);
}

TEST(Drawing, ItsEdgesAreSmoothedOnceTheHandRests)
{
  Sheet sheet;
  sheet.open();
  vtkRenderWindow* window = sheet.pad->renderWindow();
  if (!drawsOnProcessor(window))
  {
    GTEST_SKIP() << "edges are always smoothed";
  }
  const QPointF from(20, 20), to(100, 50); // over plain paper
  const auto colours = [&]
  {
    const QImage seen = sheet.pad->grabFramebuffer();
    const QRect part = QRect(sheet.onPad(from), sheet.onPad(to)).normalized();
    std::set<QRgb> found;
    for (int y = part.top(); y <= part.bottom(); ++y)
    {
      for (int x = part.left(); x <= part.right(); ++x)
      {
        found.insert(seen.pixel(x, y));
      }
    }
    return found.size();
  };
  std::vector<int> samples; // a pixel, of each frame
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&samples);
  observer->SetCallback(
    [](vtkObject* of, unsigned long, void* all, void*) {
      static_cast<std::vector<int>*>(all)->push_back(vtkRenderWindow::SafeDownCast(of)->GetMultiSamples());
    });
  window->AddObserver(vtkCommand::EndEvent, observer);
  sheet.line({ from, 0.5 * (from + to), to });
  ASSERT_FALSE(samples.empty());
  EXPECT_EQ(samples.front(), 0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return samples.back() == edgeSamples; }, 60000));
  const std::size_t smooth = colours();
  samples.clear();
  QTest::qWait(3 * restTime);
  EXPECT_TRUE(samples.empty()) << samples.size() << " frames of what does not move";
  window->SetMultiSamples(0);
  window->Render();
  const std::size_t rough = colours();
  EXPECT_EQ(rough, 2U) << "the paper's and the line's";
  EXPECT_GT(smooth, rough);
}
