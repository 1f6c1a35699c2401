// The strokes of the history on the surface that they shaped: all of them while the left button turns the
// model, a click on one names its step; with a tool that draws the chosen one alone, where it is not seen
// from where it was drawn.
#ifndef oversketch_applications_studio_view_stroke_lines_h
#define oversketch_applications_studio_view_stroke_lines_h

#include "shared_data.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <QObject>
#include <QPoint>

#include <vector>

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

namespace oversketch_studio
{

class Viewport;

class StrokeLines : public QObject
{
  Q_OBJECT

public:
  explicit StrokeLines(Viewport* viewport);
  ~StrokeLines() override;

  // By step; null where there is none.
  void set(const std::vector<oversketch_session::SharedData>& lines);
  // The chosen step, -1 none, and its stroke with its view, null where that is not shown by itself.
  void choose(int step, vtkPolyData* stroke);
  // Whether all are shown, and can be clicked.
  void showAll(bool all);
  // None, for a picture without lines.
  void setVisible(bool visible) { this->Visible = visible; }
  // The step whose line is seen there [px of the widget], else -1.
  int at(const QPoint& place) const;

signals:
  // The left button has gone down and up at one place, without a key; the step whose line is there, else -1.
  void clicked(const QPoint& place, int line);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void show();
  void frameBegins();
  void hover(int step);
  bool isHeld() const; // by its tool
  bool isShown() const;
  bool isSeen(const double place[3]) const;

  struct Drawn
  {
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  void look(Drawn& drawn, float width, double opacity) const;

  Viewport* View;
  vtkWeakPointer<vtkRenderer> Renderer; // of the view
  std::vector<oversketch_session::SharedData> Lines;
  int Chosen = -1, Hovered = -1;
  vtkSmartPointer<vtkPolyData> Stroke;
  bool All = false, Visible = true;
  Drawn Others, Marked; // thin; the chosen or hovered one
  unsigned long Observer = 0;
  QPoint Press;
  bool Pressed = false;
};

} // namespace oversketch_studio
#endif
