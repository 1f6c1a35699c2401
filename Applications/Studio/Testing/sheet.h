// A picture and a hand that draws over it, in the window.
#ifndef oversketch_applications_studio_testing_sheet_h
#define oversketch_applications_studio_testing_sheet_h

#include "drawing_lines.h"
#include "drawing_pad.h"
#include "evaluator.h"
#include "scene.h"
#include "session_file.h"

#include "vtkFeatureEdges.h"
#include "vtkNew.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QPainter>
#include <QTemporaryDir>

#include <string>
#include <vector>

namespace oversketch_studio
{

using namespace oversketch_session;

using Places = std::vector<QPointF>; // in the picture, px from its lower left corner

constexpr int width = 400, height = 300;

// A ring's places, the first one once more at the end.
inline Places ring(const QPointF& middle, double radius, int count = 60)
{
  Places places;
  for (int i = 0; i <= count; ++i)
  {
    const double angle = 2.0 * M_PI * i / count;
    places.push_back(middle + radius * QPointF(std::cos(angle), std::sin(angle)));
  }
  return places;
}

// A body of 240 x 120 with a leg of 40 x 80 below, about its left half.
inline Places beast()
{
  Places places;
  const auto line = [&places](QPointF from, QPointF to)
  {
    for (int i = 0; i < 12; ++i)
    {
      places.push_back(from + (to - from) * (i / 12.0));
    }
  };
  const Places corners{ { 80, 240 },
    { 80, 130 },
    { 120, 120 },
    { 120, 40 },
    { 160, 40 },
    { 160, 120 },
    { 320, 130 },
    { 320, 240 },
    { 80, 240 } };
  for (std::size_t i = 1; i < corners.size(); ++i)
  {
    line(corners[i - 1], corners[i]);
  }
  places.push_back(corners.front());
  return places;
}

struct Sheet : Scene
{
  Sheet()
    : pad(this->window.findChild<DrawingPad*>())
    , list(this->window.findChild<QListWidget*>("history"))
    , advice(this->window.findChild<QLabel*>("advice"))
  {
    this->file = this->folder.filePath("beast.png");
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(QColor(235, 230, 220));
    QPainter painter(&image);
    QPolygonF shape;
    for (const QPointF& place : beast())
    {
      shape << QPointF(place.x(), height - place.y());
    }
    painter.setBrush(QColor(190, 60, 40));
    painter.drawPolygon(shape);
    painter.end();
    EXPECT_TRUE(image.save(this->file));
  }

  void open()
  {
    QApplication::setActiveWindow(&this->window);
    EXPECT_TRUE(this->window.openPicture(this->file));
    this->settle();
  }
  void settle()
  {
    QApplication::processEvents();
    this->wait();
    QApplication::processEvents();
  }
  QPoint onPad(const QPointF& place)
  {
    vtkRenderer* from = this->pad->renderWindow()->GetRenderers()->GetFirstRenderer();
    from->SetWorldPoint(place.x(), place.y(), 0.0, 1.0);
    from->WorldToDisplay();
    const double* at = from->GetDisplayPoint();
    return { static_cast<int>(std::lround(at[0])),
      this->pad->height() - 1 - static_cast<int>(std::lround(at[1])) };
  }
  void line(const Places& places, Qt::KeyboardModifiers held = Qt::NoModifier)
  {
    QApplication::processEvents();
    const auto send = [this, held](QEvent::Type type, const QPointF& place, Qt::MouseButton button)
    {
      const QPoint at = this->onPad(place);
      const Qt::MouseButtons down = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
      QMouseEvent event(type, at, this->pad->mapToGlobal(at), button, down, held);
      QApplication::sendEvent(
        this->pad, &event); // the server's own would run together while frames are drawn
      QApplication::processEvents();
    };
    send(QEvent::MouseButtonPress, places.front(), Qt::LeftButton);
    sweepMouse(
      this->pad, 0, static_cast<int>(places.size()) - 1, [&](int i) { return this->onPad(places[i]); }, held);
    send(QEvent::MouseButtonRelease, places.back(), Qt::LeftButton);
    this->settle();
  }
  // Triggers an action that asks for a file, and types its name.
  void choose(const QString& entry, const QString& path)
  {
    QTimer timer;
    QObject::connect(&timer,
      &QTimer::timeout,
      [path]
      {
        QWidget* dialog = QApplication::activeModalWidget();
        if (auto* name = dialog ? dialog->findChild<QLineEdit*>() : nullptr)
        {
          name->setText(path);
          QTest::keyClick(name, Qt::Key_Return);
        }
      });
    timer.start(100);
    this->action(entry)->trigger();
    this->settle();
    QApplication::setActiveWindow(&this->window); // no longer the one that asked
  }
  void click(const QPointF& place)
  {
    QTest::mouseClick(this->pad, Qt::LeftButton, Qt::NoModifier, this->onPad(place));
    this->settle();
  }
  const Session& session() { return this->document->session(); }
  vtkPolyData* mesh() { return this->document->result().mesh; }
  const Step& step(int node) { return *this->session().nodes[indexOf(node)].step; }
  std::vector<DrawnStroke> strokes() { return strokesOf(linesOf(this->step(0), "Strokes")); }
  oversketch::Message failure(int node = 0) { return this->document->result().nodes[indexOf(node)].failure; }
  QString row(int at) { return this->list->item(at)->text().trimmed(); }
  // A line beside the end of the leg, further down, drawn on the model by system A's tool.
  void pullTheLeg()
  {
    QTest::keyClick(this->view, Qt::Key_D);
    QApplication::processEvents();
    this->pictureAtRest();
    const double ends[3][3] = { { 116, 70, 0 }, { 140, 12, 0 }, { 164, 70, 0 } };
    const auto at = [&](int i)
    {
      const double t = i / 30.0, a = (1 - t) * (1 - t), b = 2 * t * (1 - t), c = t * t;
      const double side = 140.0 + (t - 0.5) * 56.0, low = a * 70.0 + b * -40.0 + c * 70.0;
      const double place[3] = { side, low, ends[0][2] };
      return this->seen(place);
    };
    moveMouse(this->view, at(0), Qt::NoButton);
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, at(0));
    sweepMouse(this->view, 1, 30, at);
    QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, at(30));
    this->settle();
  }

  QTemporaryDir folder;
  QString file;
  DrawingPad* pad;
  QListWidget* list;
  QLabel* advice;
};

inline int openEdges(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOn();
  edges->ManifoldEdgesOff();
  edges->Update();
  return static_cast<int>(edges->GetOutput()->GetNumberOfCells());
}

// Points - edges + faces of a closed mesh of triangles.
inline vtkIdType eulerOf(vtkPolyData* mesh)
{
  return mesh->GetNumberOfPoints() - mesh->GetNumberOfPolys() / 2;
}

} // namespace oversketch_studio
#endif
