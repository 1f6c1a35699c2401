// The window on the shipped model, and a hand that draws over its highest place.
#ifndef oversketch_applications_studio_testing_scene_h
#define oversketch_applications_studio_testing_scene_h

#include "document.h"
#include "evaluator.h"
#include "main_window.h"
#include "mouse.h"
#include "viewport.h"

#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <QAction>
#include <QApplication>
#include <QColor>
#include <QElapsedTimer>
#include <QImage>
#include <QSize>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace oversketch_studio
{

// Pixels of the view that differ.
inline int differing(const QImage& a, const QImage& b)
{
  int found = 0;
  for (int y = 0; y < a.height(); ++y)
  {
    for (int x = 0; x < a.width(); ++x)
    {
      const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
      found += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) > 30;
    }
  }
  return found;
}

// Pixels that are such.
inline int count(const QImage& image, const std::function<bool(const QColor&)>& isSuch)
{
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      found += isSuch(image.pixelColor(x, y));
    }
  }
  return found;
}

// Sizes of the window. The processor draws the small one in less time. A hand that goes by pixels takes the
// whole one, in which the program opens.
const QSize smallWindow(1000, 700), wholeWindow(1200, 800);

struct Scene
{
  explicit Scene(const QSize& size = smallWindow)
  {
    this->window.resize(size);
    this->window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&this->window, 60000));
    this->window.openShippedModel();
    this->view = this->window.findChild<Viewport*>();
    this->document = this->window.findChild<Document*>();
    this->wait();
    EXPECT_TRUE(QTest::qWaitFor(
      [this] { return this->document->result().mesh && this->document->isSettled(); }, 600000));
  }
  ~Scene() { this->document->discardAutosave(); }

  void wait()
  {
    EXPECT_TRUE(QTest::qWaitFor([this] { return this->document->isSettled(); }, 600000));
  }
  // Until the view has the size that the options of the tool in the hand leave it: a line that is drawn
  // meanwhile is given up.
  void settle()
  {
    QSize size;
    do
    {
      size = this->view->size();
      QApplication::processEvents();
      QApplication::processEvents();
    } while (size != this->view->size());
  }
  // Once the view's timers have run out: a frame's edges are smoothed some time after it is drawn.
  QImage pictureAtRest()
  {
    const auto rests = [this]
    {
      const auto timers = this->view->findChildren<QTimer*>();
      return std::none_of(timers.begin(), timers.end(), [](QTimer* timer) { return timer->isActive(); });
    };
    QApplication::processEvents();
    EXPECT_TRUE(QTest::qWaitFor(rests, 60000));
    return this->view->grabFramebuffer();
  }
  // Whether a picture comes that is such. It is asked for now and then: each look paints a frame, and what
  // the pen takes hold of waits for some time without one.
  bool comes(const std::function<bool(const QImage&)>& isSuch)
  {
    QElapsedTimer time;
    for (time.start(); time.elapsed() < 60000; QTest::qWait(400))
    {
      if (isSuch(this->view->grabFramebuffer()))
      {
        return true;
      }
    }
    return false;
  }
  QAction* action(const QString& text)
  {
    for (QAction* one : this->window.findChildren<QAction*>())
    {
      if (one->text() == text)
      {
        return one;
      }
    }
    ADD_FAILURE() << "no action " << text.toStdString();
    return nullptr;
  }
  vtkRenderer* renderer() { return this->view->renderWindow()->GetRenderers()->GetFirstRenderer(); }
  // Where a place of the world is in the view, in pixels as Qt counts them from its upper left corner.
  QPoint seen(const double place[3])
  {
    vtkRenderer* renderer = this->renderer();
    renderer->SetWorldPoint(place[0], place[1], place[2], 1.0);
    renderer->WorldToDisplay();
    double at[3];
    renderer->GetDisplayPoint(at);
    const double ratio = this->view->devicePixelRatioF(); // VTK counts the screen's own
    return { static_cast<int>(std::lround(at[0] / ratio)),
      this->view->height() - 1 - static_cast<int>(std::lround(at[1] / ratio)) };
  }
  QPoint top()
  {
    vtkPolyData* mesh = this->document->result().mesh;
    QPoint highest(0, this->view->height());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const QPoint at = this->seen(mesh->GetPoint(i));
      highest = at.y() < highest.y() ? at : highest;
    }
    return highest;
  }
  // An arch over the model's highest place, the pen left down at its end.
  void draw()
  {
    this->settle();
    const QPoint over = this->top();
    const auto at = [&](int i)
    { return over + QPoint(3 * i, static_cast<int>(std::lround(20.0 - 45.0 * std::cos(0.08 * i)))); };
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, at(-15));
    sweepMouse(this->view, -14, 15, at);
    this->end = at(15);
  }
  void release() { QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, this->end); }

  MainWindow window;
  Viewport* view = nullptr;
  Document* document = nullptr;
  QPoint end;
};

// Digest of the mesh of a session that is run without a window; empty of a drawing without lines.
inline std::string replayed(const oversketch_session::Session& session)
{
  std::vector<oversketch_session::Outcome> outcomes;
  oversketch_session::Evaluator evaluator;
  EXPECT_TRUE(evaluator.run(session, {}, outcomes));
  vtkPolyData* made = oversketch_session::resultOf(session, outcomes);
  return made ? oversketch_session::digestOf(made) : std::string();
}

} // namespace oversketch_studio
#endif
