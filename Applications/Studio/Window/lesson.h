// Lessons: a hand draws by itself in the window, what it made is looked at and undone, and then it is the
// learner's turn.
#ifndef oversketch_applications_studio_window_lesson_h
#define oversketch_applications_studio_window_lesson_h

#include "Stroke/polyline.h"
#include "resources.h"

#include "vtkSmartPointer.h"

#include <QEvent>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QVector>

#include <functional>
#include <string>
#include <vector>

class QLabel;
class QTimer;
class vtkPolyData;

namespace oversketch_studio
{

class Document;
class FrameView;

struct Lesson
{
  QString title;      // with its letter for menus
  Example example;    // that it is drawn on; of a drawing the picture alone
  QString strokes;    // the file of what is drawn, each stroke in its view
  int count = 0;      // that many of them, from the first one
  std::string system; // whose tool draws them
  QString drawn;      // words while the hand draws
  QString done;       // and while one looks at what it made
};

// Those that can be played with what is installed.
QVector<Lesson> lessons();

class LessonPlayer : public QObject
{
  Q_OBJECT

public:
  LessonPlayer(Document* document, QObject* parent);

  // Plays it on a view, once that shows its example, from where the strokes were drawn. Throws Failed or
  // oversketch::Error where they cannot be read.
  void play(const Lesson& lesson, FrameView* view);
  bool isPlaying() const { return this->At != Phase::Over; }
  // The clock that it goes by [ms].
  void setClock(const std::function<double()>& clock) { this->Clock = clock; }
  // Says what goes on.
  const QString& words() const { return this->Words; }

signals:
  void says();
  // It is the learner's turn; else the learner has stopped it, and all is left as it is.
  void ended(bool whole);

protected:
  // A press of the learner's own, a key or a wheel stops it.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  enum class Phase
  {
    Opening, // until the example is seen
    Reading,
    Drawing, // a stroke, and the rest after it
    Looking, // at what was made, once it is there
    Leaving, // until that is gone
    Over
  };
  void tick();
  void draw();
  void turnTo(Phase phase, const QString& words);
  void takeStroke();
  void end(bool whole);
  void send(QEvent::Type type, const oversketch::Vector2& place);

  Document* OpenDocument;
  QTimer* Ticks;
  std::function<double()> Clock;
  double Since = 0.0; // the phase or the stroke began
  Phase At = Phase::Over;
  Lesson Taught;
  FrameView* View = nullptr;
  vtkSmartPointer<vtkPolyData> Strokes;
  QString Words;
  vtkIdType Stroke = 0;        // of them, that is drawn
  oversketch::Polyline Line;   // the same in the view [px as Qt counts them]
  std::vector<double> Lengths; // along it
  bool IsDown = false;         // the pen
  bool Rests = false;          // after the stroke
  QPointer<QLabel> Pen;
};

} // namespace oversketch_studio
#endif
