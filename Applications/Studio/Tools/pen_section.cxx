#include "pen_section.h"

#include "vtkOversketchHeldStrokeWidget.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkNew.h"

#include <QTimer>

#include <utility>

namespace oversketch_studio
{

namespace
{

constexpr int rest = 100; // ms without a frame: camera and pen have come to rest

} // namespace

PenSection::PenSection(const oversketch_session::SystemRow& system,
  vtkOversketchHeldStrokeWidget* widget,
  oversketch_session::SectionFinder::Look look,
  QObject* parent)
  : QObject(parent)
  , Widget(widget)
  , Rest(new QTimer(this))
  // From the finder's thread to this object's.
  , Finder(
      system,
      [this] { QMetaObject::invokeMethod(this, &PenSection::show, Qt::QueuedConnection); },
      std::move(look))
{
  this->Rest->setSingleShot(true);
  this->Rest->setInterval(rest);
  connect(this->Rest, &QTimer::timeout, this, &PenSection::rested);
}

void PenSection::setMesh(vtkPolyData* mesh)
{
  this->Finder.setMesh(mesh);
  this->Outdated = this->Asked;
  this->Grew = true; // the line is over another mesh
}

void PenSection::setValues(const oversketch_session::Values& values)
{
  this->StrokeValues = values;
  this->Grew = true; // what it will make has changed
}

void PenSection::lineBegins()
{
  this->Outdated = this->Asked;
  this->look();
}

void PenSection::moveEnds()
{
  this->Outdated = this->Asked;
  this->Widget->GetPen()->GetStrokeRepresentation()->SetCrest(nullptr);
}

void PenSection::frameBegins()
{
  this->Waits = false;
  if (this->Grew && this->Widget->GetPen()->IsDrawing())
  {
    this->look();
  }
}

void PenSection::framePainted()
{
  this->Rest->start();
}

// The curves are made ready for the pen; what is under it is seen, also while it stands.
void PenSection::rested()
{
  if (this->Waits)
  {
    emit this->frameWanted();
  }
  else if (!this->Widget->GetPen()->IsDrawing())
  {
    this->look();
  }
}

void PenSection::look()
{
  this->Grew = false;
  if (!this->Widget->GetEnabled())
  {
    return; // nobody draws
  }
  vtkNew<vtkPolyData> stroke;
  vtkOversketchStrokeRepresentation* drawn = this->Widget->GetPen()->GetStrokeRepresentation();
  if (!drawn->IsDrawing() || drawn->GetNumberOfSamples() == 0)
  {
    drawn->PutView(stroke);
  }
  else if (!this->Widget->IsRedrawing()) // a part alone says nothing
  {
    drawn->GetPolyData(stroke);
  }
  if (stroke->GetNumberOfPoints() > 0)
  {
    this->Asked = this->Finder.find(stroke, this->StrokeValues);
  }
}

void PenSection::show()
{
  vtkOversketchStrokeWidget* pen = this->Widget->GetPen();
  const auto found = this->Finder.take();
  if (found && found->ticket > this->Outdated && (pen->IsDrawing() || this->Widget->IsMoving()))
  {
    // The next sample's frame shows it; a frame of its own would keep that one waiting.
    pen->GetStrokeRepresentation()->SetSection(found->section);
    pen->GetStrokeRepresentation()->SetCrest(found->crest);
    this->Waits = true;
    this->Rest->start();
  }
}

} // namespace oversketch_studio
