#include "pen_section.h"

#include "vtkOversketchHeldStrokeWidget.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkNew.h"

#include <QTimer>

namespace oversketch_studio
{

namespace
{

constexpr int rest = 100; // ms without a frame: camera and pen have come to rest

} // namespace

PenSection::PenSection(const oversketch_session::SystemRow& system,
  vtkOversketchHeldStrokeWidget* widget,
  QObject* parent)
  : QObject(parent)
  , widget_(widget)
  , rest_(new QTimer(this))
  // From the finder's thread to this object's.
  , finder_(system, [this] { QMetaObject::invokeMethod(this, &PenSection::show, Qt::QueuedConnection); })
{
  this->rest_->setSingleShot(true);
  this->rest_->setInterval(rest);
  connect(this->rest_, &QTimer::timeout, this, &PenSection::rested);
}

PenSection::~PenSection() = default;

void PenSection::setMesh(vtkPolyData* mesh)
{
  this->finder_.setMesh(mesh);
  this->outdated_ = this->asked_;
  this->grew_ = true; // the line is over another mesh
}

void PenSection::lineBegins()
{
  this->outdated_ = this->asked_;
  this->look();
}

void PenSection::frameBegins()
{
  this->waits_ = false;
  if (this->grew_ && this->widget_->GetPen()->IsDrawing())
  {
    this->look();
  }
}

void PenSection::framePainted()
{
  this->rest_->start();
}

// The curves are made ready for the pen; what is under it is seen, also while it stands.
void PenSection::rested()
{
  if (this->waits_)
  {
    emit this->frameWanted();
  }
  else if (!this->widget_->GetPen()->IsDrawing())
  {
    this->look();
  }
}

void PenSection::look()
{
  this->grew_ = false;
  if (!this->widget_->GetEnabled())
  {
    return; // nobody draws
  }
  vtkNew<vtkPolyData> stroke;
  vtkOversketchStrokeRepresentation* drawn = this->widget_->GetPen()->GetStrokeRepresentation();
  if (!drawn->IsDrawing() || drawn->GetNumberOfSamples() == 0)
  {
    drawn->PutView(stroke);
  }
  else if (!this->widget_->IsRedrawing()) // a part alone says nothing
  {
    drawn->GetPolyData(stroke);
  }
  if (stroke->GetNumberOfPoints() > 0)
  {
    this->asked_ = this->finder_.find(stroke);
  }
}

void PenSection::show()
{
  vtkOversketchStrokeWidget* pen = this->widget_->GetPen();
  const auto found = this->finder_.take();
  if (found && found->ticket > this->outdated_ && pen->IsDrawing())
  {
    // The next sample's frame shows it; a frame of its own would keep that one waiting.
    pen->GetStrokeRepresentation()->SetSection(found->section);
    this->waits_ = true;
    this->rest_->start();
  }
}

} // namespace oversketch_studio
