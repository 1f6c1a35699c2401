#include "drawing_pad.h"

#include "latency.h"
#include "system_strings.h"
#include "touch_hand.h"

#include "camera_state.h"

#include "vtkOversketchDrawingRepresentation.h"
#include "vtkOversketchDrawingWidget.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkProperty.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>

namespace oversketch_studio
{

namespace
{

// px as Qt counts them
constexpr double strokeLineWidth = 3.0, snapRadius = 10.0;
constexpr int leastSide = 120, letterWidth = 8;

} // namespace

DrawingPad::DrawingPad(QWidget* parent)
  : FrameView(parent)
{
  this->setObjectName("drawing_pad");
  this->Widget->SetInteractor(this->interactor());
  this->Widget->SetDefaultRenderer(this->renderer());
  this->Widget->SetEnabled(1);
  this->Widget->AddObserver(vtkCommand::StartInteractionEvent, this, &DrawingPad::began);
  this->Widget->AddObserver(vtkCommand::InteractionEvent, &Latency::of(), &Latency::sample);
  this->Widget->AddObserver(vtkCommand::EndInteractionEvent, this, &DrawingPad::lineEnds);
  this->Widget->AddObserver(vtkCommand::WidgetValueChangedEvent, this, &DrawingPad::changed);
  this->setMinimumSize(leastSide, leastSide);
  this->setFocusPolicy(Qt::StrongFocus);
  this->setAccessibleName(tr("Picture"));
  this->setDefaultCursor(Qt::CrossCursor);
  this->setCursor(Qt::CrossCursor);
  new TouchHand(this,
    { [this] { return this->isDrawing(); },
      [this](double factor, const QPointF& about) { this->zoom(factor, about); },
      [this](double pressure) { this->Widget->GetPen()->SetPressure(pressure); } });
  this->setDark(true);
}

DrawingPad::~DrawingPad()
{
  this->Widget->RemoveAllObservers();
  this->Widget->SetEnabled(0);
  this->Widget->SetInteractor(nullptr);
}

// As many notches of the wheel as it is.
void DrawingPad::zoom(double factor, const QPointF& about)
{
  constexpr double notch = 1.15; // of the widget
  this->Zoomed *= factor;
  for (const bool isIn : { true, false })
  {
    for (; isIn ? this->Zoomed > notch : this->Zoomed < 1.0 / notch;
         this->Zoomed *= isIn ? 1.0 / notch : notch)
    {
      const int turned = isIn ? QWheelEvent::DefaultDeltasPerStep : -QWheelEvent::DefaultDeltasPerStep;
      QWheelEvent wheel(about,
        this->mapToGlobal(about.toPoint()),
        {},
        { 0, turned },
        Qt::NoButton,
        Qt::NoModifier,
        Qt::NoScrollPhase,
        false);
      QApplication::sendEvent(this, &wheel);
    }
  }
}

void DrawingPad::lineEnds()
{
  this->fit(); // to a size that came during the line
  emit this->ended();
}

void DrawingPad::setPicture(vtkImageData* picture)
{
  this->Widget->SetPicture(picture);
  this->Fits = true;
}

void DrawingPad::setCanvas(double x, double y, double width, double height)
{
  this->Widget->SetCanvas(x, y, width, height);
  this->Fits = true;
}

void DrawingPad::showText(const QString& text)
{
  // In lines that the widget has room for.
  const int room = std::max(20, this->width() / letterWidth);
  const QString lines = wrapped(text.simplified(), room - 1).join('\n');
  this->Widget->GetDrawingRepresentation()->SetText(lines.toUtf8().constData());
  this->renderWindow()->Render();
}

bool DrawingPad::isDrawing() const
{
  return this->Widget->GetPen()->IsDrawing();
}

void DrawingPad::setSteadiness(double pixels)
{
  this->Steadiness = pixels;
  this->Widget->GetPen()->SetStabilizer(pixels * this->devicePixelRatioF());
}

void DrawingPad::setDark(bool dark)
{
  this->setGround(dark); // the model's
  this->renderWindow()->Render();
}

bool DrawingPad::event(QEvent* event)
{
  const auto* mouse = event->type() == QEvent::MouseButtonPress ? static_cast<QMouseEvent*>(event) : nullptr;
  if (event->type() == QEvent::Wheel || (mouse && mouse->button() == Qt::MiddleButton))
  {
    this->Fits = false;
  }
  return FrameView::event(event);
}

// VTK counts the screen's own pixels.
void DrawingPad::resizeGL(int width, int height)
{
  FrameView::resizeGL(width, height);
  const double ratio = this->devicePixelRatioF();
  this->Widget->GetDrawingRepresentation()->GetCurveProperty()->SetLineWidth(
    static_cast<float>(strokeLineWidth * ratio));
  this->Widget->GetPen()->GetStrokeRepresentation()->GetProperty()->SetLineWidth(
    static_cast<float>(strokeLineWidth * ratio));
  this->Widget->SetSnapRadius(snapRadius * ratio);
  this->setSteadiness(this->Steadiness);
  this->fit();
}

// A line keeps the view that it was begun in. What was enlarged stays as large across the smaller side.
void DrawingPad::fit()
{
  const int* size = this->renderer()->GetSize();
  if (this->isDrawing() || (size[0] == this->Fitted[0] && size[1] == this->Fitted[1]))
  {
    return;
  }
  const std::array<int, 2> now{ size[0], size[1] };
  if (this->Fits)
  {
    this->Widget->ResetView();
  }
  else
  {
    vtkCamera* camera = this->renderer()->GetActiveCamera();
    oversketch::CameraState state(camera);
    state.fit(this->Fitted.data(), now.data());
    state.putInto(camera);
  }
  this->Fitted = now;
}

} // namespace oversketch_studio
