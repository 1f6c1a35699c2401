#include "edit_tool.h"

#include <QStringList>

namespace oversketch_studio
{

using namespace oversketch_session;

EditTool::EditTool(const std::shared_ptr<EditHand>& hand, int mode, Viewport* viewport)
  : Tool(viewport)
  , Hand(hand)
  , Mode(mode)
  , View(viewport)
{
  // The others have the same hand.
  const auto pass = [&](auto signal, auto own)
  {
    connect(hand.get(),
      signal,
      this,
      [this, own](const auto&... what)
      {
        if (this->isHeld())
        {
          emit(this->*own)(what...);
        }
      });
  };
  pass(&EditHand::drawn, &Tool::drawn);
  pass(&EditHand::remade, &Tool::remade);
  pass(&EditHand::left, &Tool::left);
  pass(&EditHand::arranged, &Tool::left);
}

QVector<QPair<QString, QString>> EditTool::keys() const
{
  return QVector<QPair<QString, QString>>{ { tr("Left drag"), tr("draw a line, then a ring round it") } } +
         this->ways() +
         QVector<QPair<QString, QString>>{
           { tr("Shift + left drag"), tr("over line or ring: redraw a part of it") },
         };
}

QString EditTool::hint() const
{
  return !this->Hand->hasLine()     ? tr("Draw a line on the body like this")
         : !this->Hand->hasRegion() ? tr("Now a ring round it, like this")
                                    : QString();
}

QString EditTool::advice(const Situation& situation) const
{
  if (!this->Hand->message().isEmpty())
  {
    return this->Hand->message();
  }
  if (const QStringList lost = this->Hand->lost(); !lost.isEmpty())
  {
    return tr(
      "Later steps do nothing now, or act elsewhere: %1. Their rows say more; Ctrl+Z takes the change back.")
      .arg(lost.join(", "));
  }
  if (situation.redraws)
  {
    return tr("Redraw the selected edit's line, then its ring. T leaves them as they are.");
  }
  if (!this->Hand->hasLine())
  {
    return tr("Draw a line on the model, then a ring round it: what lies between follows the line. The "
              "middle button turns the model, F1 lists the keys.");
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
  if (QStringList{ "Flatten", "Distance", "Areas", "Shading", "Texture" }.contains(name))
  {
    return tr("Shading the region");
  }
  if (QStringList{ "Handles", "Deform", "Bend", "Planes", "Section", "Redraw" }.contains(name))
  {
    return tr("Deforming");
  }
  return tr("Laying line and ring on the model");
}

void EditTool::setMesh(vtkPolyData* mesh)
{
  if (this->isHeld())
  {
    this->Hand->setMesh(mesh);
  }
}

void EditTool::setDark(bool dark)
{
  if (this->Panel)
  {
    this->Panel->setDark(dark);
  }
}

} // namespace oversketch_studio
