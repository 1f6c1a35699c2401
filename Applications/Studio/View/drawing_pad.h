// The picture or the canvas that a model is drawn on, beside the model: a Qt widget about the drawing widget.
#ifndef oversketch_applications_studio_view_drawing_pad_h
#define oversketch_applications_studio_view_drawing_pad_h

#include "frame_view.h"

#include "vtkNew.h"

#include <array>

class vtkImageData;
class vtkOversketchDrawingWidget;

namespace oversketch_studio
{

class DrawingPad : public FrameView
{
  Q_OBJECT

public:
  explicit DrawingPad(QWidget* parent = nullptr);
  ~DrawingPad() override;

  // Sets what is drawn on; all of it is seen.
  void setPicture(vtkImageData* picture);
  void setCanvas(double x, double y, double width, double height);
  // Holds the strokes of the drawing, what each is and what there is to be said of them.
  vtkOversketchDrawingWidget* widget() const { return this->Widget; }
  // Shows what it says, in the words of whoever asks.
  void showText(const QString& text);
  bool isDrawing() const;

  // How far the line trails behind the pen [px as Qt counts them]; the pen's pressure.
  void setSteadiness(double pixels);
  void setDark(bool dark);

signals:
  // The hand has changed the drawing; begins, and ends, a line.
  void changed();
  void began();
  void ended();

protected:
  bool isHeld() const override { return this->isDrawing(); }
  bool event(QEvent* event) override;
  void resizeGL(int width, int height) override;

private:
  void lineEnds();
  void fit(); // to the size that it has now
  void zoom(double factor, const QPointF& about);

  vtkNew<vtkOversketchDrawingWidget> Widget;
  double Steadiness = 6.0;
  double Zoomed = 1.0;               // by fingers, less than a notch of the wheel
  bool Fits = true;                  // all of the canvas is seen, until the hand zooms or pans
  std::array<int, 2> Fitted{ 1, 1 }; // the size that the view is for [px of the screen]
};

} // namespace oversketch_studio
#endif
