#include "edit_tool.h"

#include "edit_hand.h"
#include "viewport.h"

namespace oversketch_studio
{

using namespace oversketch_session;

EditTool::EditTool(const std::shared_ptr<EditHand>& hand, int mode, Viewport* viewport)
  : Tool(viewport)
  , Hand(hand)
  , Mode(mode)
  , View(viewport)
{
  const auto isHeld = [this] { return this->View->tool() == this; };
  connect(hand.get(),
    &EditHand::drawn,
    this,
    [this, isHeld](const Step& step)
    {
      if (isHeld())
      {
        emit this->drawn(step);
      }
    });
  connect(hand.get(),
    &EditHand::remade,
    this,
    [this, isHeld](const Step& step)
    {
      if (isHeld())
      {
        emit this->remade(step);
      }
    });
  for (const auto signal : { &EditHand::left, &EditHand::arranged })
  {
    connect(hand.get(),
      signal,
      this,
      [this, isHeld]
      {
        if (isHeld())
        {
          emit this->left();
        }
      });
  }
}

EditTool::~EditTool() = default;

QVector<QPair<QString, QString>> EditTool::keys() const
{
  return QVector<QPair<QString, QString>>{ { tr("Left drag"), tr("draw a line, then a ring round it") } } +
         this->ways() +
         QVector<QPair<QString, QString>>{
           { tr("Shift + left drag"), tr("over line or ring: redraw a part of it; else: pan") },
         };
}

QString EditTool::hint() const
{
  return !this->Hand->hasLine()     ? tr("Draw a line on the body like this")
         : !this->Hand->hasRegion() ? tr("Now a ring round it, like this")
                                    : QString();
}

HintShape EditTool::hintShape() const
{
  return this->Hand->hasLine() ? HintShape::Ring : HintShape::Line;
}

QString EditTool::advice(const Situation& situation) const
{
  if (!this->Hand->message().isEmpty())
  {
    return this->Hand->message();
  }
  if (const QStringList lost = this->Hand->lost(); !lost.isEmpty())
  {
    return tr("Later steps do nothing now, or act elsewhere: %1. Their rows say more; Ctrl+Z takes the "
              "change back.")
      .arg(lost.join(", "));
  }
  if (situation.redraws)
  {
    return tr("Redraw the selected edit's line, then its ring. T leaves them as they are.");
  }
  if (!this->Hand->hasLine())
  {
    return tr(
      "Draw a line on the model, then a ring round it: what lies between follows the line. The middle "
      "button turns the model, F1 lists the keys.");
  }
  if (!this->Hand->hasRegion())
  {
    return tr("Now draw a ring round the line; it closes by itself. Escape takes the line back.");
  }
  return this->Hand->isUnderOthers() ? this->way() + ' ' + tr("Later steps follow when you let go.")
                                     : this->way();
}

bool EditTool::judges() const
{
  return !this->Hand->message().isEmpty() || !this->Hand->lost().isEmpty();
}

QString EditTool::stage(const QString& name) const
{
  if (name == "Retriangulate")
  {
    return tr("Making triangles");
  }
  if (name == "Flatten" || name == "Distance" || name == "Areas" || name == "Shading" || name == "Texture")
  {
    return tr("Shading the region");
  }
  if (name == "Handles" || name == "Deform" || name == "Bend" || name == "Planes" || name == "Section" ||
      name == "Redraw")
  {
    return tr("Deforming");
  }
  return tr("Laying line and ring on the model");
}

void EditTool::select(int)
{
  this->Hand->select();
}

void EditTool::start()
{
  this->Hand->takeUp(this->Mode);
}

void EditTool::stop()
{
  this->Hand->putDown();
}

bool EditTool::draws() const
{
  return this->Hand->draws();
}

bool EditTool::moves() const
{
  return this->Hand->moves();
}

void EditTool::offer(const Step& step, const Worker::NodeState& state, const Point&)
{
  this->Hand->offer(step, state);
}

void EditTool::offerNothing()
{
  this->Hand->offerNothing();
}

void EditTool::setMesh(vtkPolyData* mesh)
{
  if (this->View->tool() == this)
  {
    this->Hand->setMesh(mesh);
  }
}

void EditTool::setPixelRatio(double ratio)
{
  this->Hand->setPixelRatio(ratio);
}

void EditTool::setSteadiness(double pixels)
{
  this->Hand->setSteadiness(pixels);
}

void EditTool::setPressure(double pressure)
{
  this->Hand->setPressure(pressure);
}

void EditTool::showLines(bool show)
{
  this->Hand->showLines(show);
}

} // namespace oversketch_studio
