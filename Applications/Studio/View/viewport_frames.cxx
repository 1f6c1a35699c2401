// Frames of the view: when one is drawn, and how much of the model is in it.
#include "viewport.h"

#include "latency.h"
#include "tool.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <QCoreApplication>
#include <QEvent>
#include <QTimer>

#include <utility>

namespace oversketch_studio
{

namespace
{

constexpr int awaitTime = 500; // ms; what takes longer shows its progress
constexpr double frameBudget =
  20.0; // ms; longer is late under the hand: of 33, painting and work take the rest

} // namespace

void Viewport::render()
{
  this->Await->stop();
  this->RenderWaits = false;
  this->fitCamera();
  if (this->CurrentTool)
  {
    this->CurrentTool->frameBegins();
  }
  this->Behind.look(this->Renderer);
  this->Looks.castShadow(this->CurrentTool && this->CurrentTool->isBusy());
  if (this->onProcessor())
  {
    this->Renderer->UseFXAAOff();
    this->Model.hideBacks(true);
  }
  Latency::of().frameBegins();
  this->drawFrame();
  if (this->onProcessor() || this->WholeFrame > frameBudget)
  {
    this->Rest->start();
  }
  this->PaintWaits = true;
}

// While the hand moves a coarser model is drawn, where the last frame of the whole one was late. Only while
// it is drawn: what is asked of the scene is asked of the whole one. A frame in which a graphics processor is
// given another mesh tells nothing of the next.
void Viewport::drawFrame()
{
  this->IsCoarse = this->WholeFrame > frameBudget && this->handMoves() && this->Model.drawCoarse(true);
  const double begin = this->Clock();
  this->Window->Render();
  if (this->onProcessor() && this->isValid())
  {
    this->Window->WaitForCompletion(); // it draws behind the program's back
  }
  const double time = this->Clock() - begin;
  this->Model.drawCoarse(false);
  const vtkMTimeType mesh = this->mesh() ? this->mesh()->GetMTime() : 0;
  if (!this->IsCoarse && (std::exchange(this->Drawn, mesh) == mesh || this->onProcessor()))
  {
    this->WholeFrame = time;
    if (time > frameBudget && this->handMoves())
    {
      this->Model.makeCoarse(); // of faces that came under the hand
    }
  }
}

// Not a pen: what it draws after is seen as it is.
bool Viewport::handMoves() const
{
  if (this->CurrentTool && this->CurrentTool->isBusy())
  {
    return this->CurrentTool->moves();
  }
  return this->CameraSteps || this->Style->GetState() != VTKIS_NONE;
}

bool Viewport::awaits() const
{
  return this->Await->isActive();
}

bool Viewport::isHeld() const
{
  return this->awaits() || (this->CurrentTool && this->CurrentTool->draws());
}

// Where the processor draws, edges are smoothed and all faces drawn once nothing moves any more; the whole
// model is wherever it was not, and a coarse one made for the next movement.
void Viewport::renderSmooth()
{
  this->CameraSteps = false;
  if (this->onProcessor())
  {
    this->Renderer->UseFXAAOn();
    this->Model.hideBacks(false);
  }
  if (std::exchange(this->IsCoarse, false) || this->onProcessor())
  {
    this->Window->Render();
  }
  if (this->WholeFrame > frameBudget)
  {
    this->Model.makeCoarse();
  }
}

// And paints it, so that no frame is drawn that nobody sees.
void Viewport::renderNow()
{
  this->render();
  this->repaint();
}

// Qt puts a repaint off that follows closely on the last.
void Viewport::paintNow()
{
  this->update();
  QEvent now(QEvent::UpdateRequest);
  QCoreApplication::sendEvent(this->window(), &now);
}

void Viewport::awaitMesh()
{
  this->Await->start(awaitTime);
}

void Viewport::awaitNoMore()
{
  this->Await->stop();
  if (std::exchange(this->RenderWaits, false))
  {
    this->renderSoon();
  }
}

void Viewport::paintGL()
{
  this->PaintWaits = false;
  this->Behind.look(this->Renderer);
  FrameView::paintGL();
  if (this->CurrentTool)
  {
    this->CurrentTool->framePainted();
  }
}

} // namespace oversketch_studio
