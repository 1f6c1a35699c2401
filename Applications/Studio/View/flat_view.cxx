#include "flat_view.h"

#include "draws_on_processor.h"
#include "latency.h"

#include "vtkCallbackCommand.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <QTimer>

namespace oversketch_studio
{

FlatView::FlatView(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
  , Rest(new QTimer(this))
{
  this->setRenderWindow(this->Window);
  this->Window->AddRenderer(this->Renderer);
  this->Window->SetMultiSamples(edgeSamples);
  this->interactor()->SetInteractorStyle(nullptr);
  this->interactor()->EnableRenderOff();
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<FlatView*>(self)->renderSoon(); });
  this->interactor()->AddObserver(vtkCommand::RenderEvent, this->Observer);
  this->Rest->setSingleShot(true);
  this->Rest->setInterval(restTime);
  connect(this->Rest, &QTimer::timeout, this, &FlatView::renderSmooth);
}

FlatView::~FlatView()
{
  this->interactor()->RemoveObserver(this->Observer);
}

void FlatView::renderSoon()
{
  if (this->RenderWaits || this->interactor()->GetEnableRender())
  {
    return;
  }
  this->RenderWaits = true;
  QTimer::singleShot(0,
    this,
    [this]
    {
      if (this->RenderWaits)
      {
        this->renderNow();
      }
    });
}

// Painted at once (Qt puts a repaint off that follows closely on the last), and all of it on the screen
// before the hand is heard again: the processor draws behind the program's back, and frames that it is late
// with would pile up behind the pen.
void FlatView::renderNow()
{
  this->RenderWaits = false;
  if (this->OnProcessor.value_or(false))
  {
    this->Window->SetMultiSamples(0);
    this->Rest->start();
  }
  Latency::of().frameBegins();
  this->Window->Render();
  this->repaint();
  if (this->OnProcessor.value_or(false) && this->isValid())
  {
    this->makeCurrent();
    this->Window->WaitForCompletion();
  }
}

void FlatView::renderSmooth()
{
  if (this->isHeld())
  {
    this->Rest->start();
    return;
  }
  this->Window->SetMultiSamples(edgeSamples);
  this->Window->Render();
}

void FlatView::paintGL()
{
  if (!this->OnProcessor)
  {
    this->OnProcessor = drawsOnProcessor(this->Window);
  }
  this->interactor()->EnableRenderOn(); // what Qt asks for is drawn now
  QVTKOpenGLNativeWidget::paintGL();
  this->interactor()->EnableRenderOff();
  if (Latency::of().isOn())
  {
    this->Window->WaitForCompletion();
    Latency::of().framePainted();
  }
}

} // namespace oversketch_studio
