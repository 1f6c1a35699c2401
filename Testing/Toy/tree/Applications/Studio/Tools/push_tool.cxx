#include "push_tool.h"

#include "document.h"
#include "viewport.h"

#include "vtkOversketchStrokeWidget.h"

#include "vtkCallbackCommand.h"
#include "vtkRenderWindowInteractor.h"

namespace oversketch_studio
{

using namespace oversketch_session;

PushTool::PushTool(Viewport* viewport, const Document* document)
  : Tool(viewport)
  , viewport_(viewport)
  , document_(document)
{
  this->pen_->SetInteractor(viewport->interactor());
  this->pen_->SetDefaultRenderer(viewport->renderer());
  this->observer_->SetClientData(this);
  this->observer_->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<PushTool*>(self)->strokeEnds(); });
  this->pen_->AddObserver(vtkCommand::WidgetValueChangedEvent, this->observer_);
}

PushTool::~PushTool()
{
  this->pen_->RemoveObserver(this->observer_);
  this->pen_->SetEnabled(0);
  this->pen_->SetInteractor(nullptr);
}

QString PushTool::title() const
{
  return tr("&Push");
}

QKeySequence PushTool::key() const
{
  return tr("P");
}

QString PushTool::help() const
{
  return tr("Draw two lines round a part; the picture pushes it (P)");
}

QString PushTool::mode() const
{
  return tr("push");
}

QPainterPath PushTool::icon() const
{
  QPainterPath path;
  path.addRect(4, 6, 4, 12);
  path.addRect(16, 6, 4, 12);
  return path;
}

QVector<QPair<QString, QString>> PushTool::keys() const
{
  return { { tr("Left drag"), tr("draw the first line, then the second") } };
}

QString PushTool::advice(const Situation&) const
{
  return tr("Put a picture into the scene, then draw two lines round a part of the model.");
}

void PushTool::start()
{
  this->pen_->SetEnabled(1);
  this->viewport_->setHandCursor(Qt::CrossCursor);
}

void PushTool::stop()
{
  this->pen_->SetEnabled(0);
  this->first_ = {};
}

bool PushTool::draws() const
{
  return this->pen_->IsDrawing();
}

void PushTool::strokeEnds()
{
  const Lines drawn(this->pen_->GetStroke());
  const Pictures& pictures = this->document_->session().pictures;
  if (!this->first_ || pictures.empty())
  {
    this->first_ = drawn;
    return;
  }
  Step step;
  step.system = this->system();
  step.inputs["FirstStroke"] = this->first_;
  step.inputs["SecondStroke"] = drawn;
  step.inputs["Brightness"] = pictures.front()->image;
  this->first_ = {};
  emit this->drawn(step);
}

} // namespace oversketch_studio
