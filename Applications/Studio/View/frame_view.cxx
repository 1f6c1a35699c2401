#include "frame_view.h"

#include "latency.h"

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <QTimer>

#include <cstring>

namespace oversketch_studio
{

bool drawsOnProcessor(vtkRenderWindow* window)
{
  const char* about = window->ReportCapabilities();
  return about && (std::strstr(about, "llvmpipe") || std::strstr(about, "softpipe"));
}

FrameView::FrameView(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
  , Rest(new QTimer(this))
{
  this->setRenderWindow(this->Window);
  this->Window->AddRenderer(this->Renderer);
  this->Window->SetMultiSamples(edgeSamples);
  this->interactor()->SetInteractorStyle(nullptr);
  this->interactor()->EnableRenderOff();
  this->Observer = this->interactor()->AddObserver(vtkCommand::RenderEvent, this, &FrameView::asked);
  this->Rest->setSingleShot(true);
  this->Rest->setInterval(restTime);
  connect(this->Rest,
    &QTimer::timeout,
    this,
    [this]
    {
      if (this->isHeld())
      {
        this->Rest->start();
        return;
      }
      this->renderSmooth();
      this->repaint();
    });
}

FrameView::~FrameView()
{
  this->interactor()->RemoveObserver(this->Observer);
}

void FrameView::asked()
{
  if (!this->interactor()->GetEnableRender())
  {
    this->renderSoon();
  }
}

void FrameView::renderSoon()
{
  if (this->RenderWaits)
  {
    return;
  }
  this->RenderWaits = true;
  QTimer::singleShot(0,
    this,
    [this]
    {
      if (this->RenderWaits && !this->awaits())
      {
        this->renderNow();
      }
    });
}

// Painted at once (Qt puts a repaint off that follows closely on the last), and all of it on the screen
// before the hand is heard again: the processor draws behind the program's back, and frames that it is late
// with would pile up behind the pen.
void FrameView::renderNow()
{
  this->RenderWaits = false;
  if (this->onProcessor())
  {
    this->Window->SetMultiSamples(0);
    this->Rest->start();
  }
  Latency::of().frameBegins();
  this->Window->Render();
  this->repaint();
  if (this->onProcessor() && this->isValid())
  {
    this->makeCurrent();
    this->Window->WaitForCompletion();
  }
}

void FrameView::renderSmooth()
{
  this->Window->SetMultiSamples(edgeSamples);
  this->Window->Render();
}

void FrameView::setGround(bool dark)
{
  dark ? this->Renderer->SetBackground(0.13, 0.14, 0.16) : this->Renderer->SetBackground(0.80, 0.82, 0.84);
  dark ? this->Renderer->SetBackground2(0.22, 0.24, 0.27) : this->Renderer->SetBackground2(0.95, 0.96, 0.97);
  this->Renderer->GradientBackgroundOn();
}

bool FrameView::onProcessor()
{
  if (!this->OnProcessor && this->isValid())
  {
    this->OnProcessor = drawsOnProcessor(this->Window);
  }
  return this->OnProcessor.value_or(false);
}

void FrameView::paintGL()
{
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
