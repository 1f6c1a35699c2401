#include "lesson.h"

#include "document.h"
#include "frame_view.h"
#include "mesh_file.h"
#include "systems.h"
#include "viewport.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCamera.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <utility>

namespace oversketch_studio
{

namespace
{

using oversketch::Vector2;
using oversketch::Vector3;

constexpr int lessonTick = 16;                        // ms
constexpr double readingTime = 2500.0;                // ms, before the hand begins
constexpr double restOfHand = 500.0;                  // ms, between two strokes
constexpr double lookingTime = 5000.0;                // ms, at what was made
constexpr double handSpeed = 0.2;                     // px as Qt counts them a ms
constexpr double shortest = 1200.0, longest = 4000.0; // ms a stroke
constexpr int penSize = 28;                           // px as Qt counts them

constexpr const char* lineSystem = "Augment";

struct LessonRow
{
  const char* title;
  const char* model; // in Models, or a picture in Drawings
  const char* strokes;
  int count;
  const char* system;
  const char* drawn;
  const char* done;
  bool isDrawing = false;
};
const LessonRow lessonRows[] = {
  { QT_TRANSLATE_NOOP("Lessons", "A longer &leg"),
    "Models/dog.ply",
    "Strokes/dog_longer_leg.vtp",
    1,
    "OneStroke",
    QT_TRANSLATE_NOOP("Lessons", "One line beside a limb says how its outline is to be."),
    QT_TRANSLATE_NOOP("Lessons", "The leg follows the line, and nothing else has moved.") },
  { QT_TRANSLATE_NOOP("Lessons", "A &raised line"),
    "Models/dog.ply",
    "Strokes/dog_back.vtp",
    1,
    lineSystem,
    QT_TRANSLATE_NOOP("Lessons", "A line on the surface rises where it is drawn."),
    QT_TRANSLATE_NOOP("Lessons", "The mesh is finer along the line, and only there.") },
  { QT_TRANSLATE_NOOP("Lessons", "A model from a &picture"),
    "Drawings/fish.png",
    "Drawings/fish.vtp",
    1,
    "InflateDrawing",
    QT_TRANSLATE_NOOP("Lessons", "A line round a shape in the picture makes it a model."),
    QT_TRANSLATE_NOOP("Lessons", "The model is round, and wears the picture on both sides."),
    true },
};

// A pen whose tip is the lower left corner.
QPixmap penPicture(qreal ratio)
{
  QPixmap picture(QSize(penSize, penSize) * ratio);
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Qt::white, 1.5));
  painter.setBrush(QColor(40, 40, 40));
  painter.drawPolygon(QPolygonF({ { 1, 27 }, { 4, 18 }, { 21, 1 }, { 27, 7 }, { 10, 24 } }));
  return picture;
}

} // namespace

QVector<Lesson> lessons()
{
  QVector<Lesson> found;
  for (const LessonRow& row : lessonRows)
  {
    Lesson one;
    one.title = QCoreApplication::translate("Lessons", row.title);
    (row.isDrawing ? one.example.picture : one.example.file) = shippedFile(row.model);
    one.example.title = QString(one.title).remove('&');
    one.strokes = shippedFile(row.strokes);
    one.count = row.count;
    one.system = row.system;
    one.drawn = QCoreApplication::translate("Lessons", row.drawn);
    one.done = QCoreApplication::translate("Lessons", row.done);
    const bool isThere = !one.strokes.isEmpty() && !(one.example.file + one.example.picture).isEmpty();
    if (isThere && oversketch_session::findSystem(one.system))
    {
      found << one;
    }
  }
  return found;
}

LessonPlayer::LessonPlayer(Document* document, QObject* parent)
  : QObject(parent)
  , OpenDocument(document)
  , Ticks(new QTimer(this))
  , Clock(
      []
      {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
          .count();
      })
{
  this->Ticks->setInterval(lessonTick);
  connect(this->Ticks, &QTimer::timeout, this, &LessonPlayer::tick);
}

void LessonPlayer::play(const Lesson& lesson, FrameView* view)
{
  this->Strokes = oversketch_files::readStroke(lesson.strokes.toStdString());
  oversketch::ViewOf(this->Strokes); // they have one
  this->Taught = lesson;
  this->View = view;
  this->Stroke = 0;
  QCoreApplication::instance()->installEventFilter(this);
  this->turnTo(Phase::Opening, lesson.example.title);
  this->Ticks->start();
}

void LessonPlayer::turnTo(Phase phase, const QString& words)
{
  this->At = phase;
  this->Words = words;
  this->Since = this->Clock();
  emit this->says();
}

void LessonPlayer::tick()
{
  if (!this->OpenDocument->isSettled())
  {
    this->Since = this->Clock(); // what comes is seen for the whole time
    return;
  }
  const double time = this->Clock() - this->Since;
  switch (this->At)
  {
    case Phase::Opening:
      if (auto* view = qobject_cast<Viewport*>(this->View))
      {
        view->lookFrom(this->Strokes);
      }
      this->turnTo(Phase::Reading, this->Taught.drawn);
      break;
    case Phase::Reading:
      if (time > readingTime)
      {
        this->turnTo(Phase::Drawing, this->Taught.drawn);
        this->takeStroke();
      }
      break;
    case Phase::Drawing:
      this->draw();
      break;
    case Phase::Looking:
      if (time > lookingTime)
      {
        while (this->OpenDocument->canUndo())
        {
          this->OpenDocument->undo();
        }
        this->turnTo(Phase::Leaving, tr("Now you."));
      }
      break;
    case Phase::Leaving:
      this->end(true);
      break;
    case Phase::Over:
      break;
  }
}

// The next stroke, as it lies in the view.
void LessonPlayer::takeStroke()
{
  const oversketch::View drawnIn = oversketch::ViewOf(this->Strokes);
  vtkRenderer* seen = this->View->renderer();
  const Vector3 focus(seen->GetActiveCamera()->GetFocalPoint());
  const double depth = drawnIn.depth(focus), ratio = this->View->devicePixelRatioF();
  vtkNew<vtkIdList> samples;
  this->Strokes->GetCellPoints(this->Stroke, samples);
  this->Line.clear();
  for (vtkIdType i = 0; i < samples->GetNumberOfIds(); ++i)
  {
    const double* sample = this->Strokes->GetPoint(samples->GetId(i));
    const Vector3 world = drawnIn.toWorld({ sample[0], sample[1] }, depth);
    seen->SetWorldPoint(world[0], world[1], world[2], 1.0);
    seen->WorldToDisplay();
    const double* place = seen->GetDisplayPoint();
    this->Line.emplace_back(place[0] / ratio, this->View->height() - 1 - place[1] / ratio);
  }
  this->Lengths = oversketch::arcLengths(this->Line);
  this->Rests = false;
  this->Since = this->Clock();
}

void LessonPlayer::draw()
{
  const double passed = this->Clock() - this->Since;
  if (this->Rests)
  {
    if (passed > restOfHand)
    {
      ++this->Stroke;
      this->Stroke < std::min<vtkIdType>(this->Taught.count, this->Strokes->GetNumberOfCells())
        ? this->takeStroke()
        : this->turnTo(Phase::Looking, this->Taught.done);
    }
    return;
  }
  const double whole = this->Lengths.back(),
               share = std::min(1.0, passed / std::clamp(whole / handSpeed, shortest, longest));
  const Vector2 place =
    oversketch::placeAt(this->Lengths, static_cast<int>(this->Line.size()), share * whole).of(this->Line);
  if (!this->IsDown)
  {
    this->send(QEvent::MouseMove, place);
    this->send(QEvent::MouseButtonPress, place);
  }
  this->send(QEvent::MouseMove, place);
  if (share == 1.0)
  {
    this->send(QEvent::MouseButtonRelease, place);
    this->Rests = true;
    this->Since = this->Clock();
  }
}

void LessonPlayer::send(QEvent::Type type, const Vector2& place)
{
  const QPointF at(place[0], place[1]);
  const bool isMove = type == QEvent::MouseMove;
  this->IsDown = isMove ? this->IsDown : type == QEvent::MouseButtonPress;
  QMouseEvent event(type,
    at,
    this->View->mapToGlobal(at.toPoint()),
    isMove ? Qt::NoButton : Qt::LeftButton,
    this->IsDown ? Qt::LeftButton : Qt::NoButton,
    Qt::NoModifier);
  QCoreApplication::sendEvent(this->View, &event);
  if (!this->Pen)
  {
    this->Pen = new QLabel(this->View);
    this->Pen->setObjectName("lesson_pen");
    this->Pen->setAttribute(Qt::WA_TransparentForMouseEvents);
    this->Pen->setPixmap(penPicture(this->View->devicePixelRatioF()));
    this->Pen->resize(penSize, penSize);
  }
  this->Pen->move(at.toPoint() - QPoint(0, penSize));
  this->Pen->setVisible(type != QEvent::MouseButtonRelease);
}

void LessonPlayer::end(bool whole)
{
  this->Ticks->stop();
  QCoreApplication::instance()->removeEventFilter(this);
  delete this->Pen;
  this->At = Phase::Over;
  if (std::exchange(this->IsDown, false)) // the line is given up
  {
    QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    QCoreApplication::sendEvent(this->View, &escape);
  }
  emit this->ended(whole);
}

bool LessonPlayer::eventFilter(QObject* watched, QEvent* event)
{
  if (!event->spontaneous() || this->At == Phase::Over)
  {
    return false;
  }
  switch (event->type())
  {
    case QEvent::MouseButtonPress:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
    case QEvent::Wheel:
    case QEvent::KeyPress:
      this->end(false);
      return false;
    case QEvent::MouseMove: // the learner's mouse draws nothing
      return watched == this->View;
    default:
      return false;
  }
}

} // namespace oversketch_studio
