#include "profile_tool.h"

#include "vtkOversketchEditWidget.h"
#include "vtkOversketchProfilePlaneWidget.h"
#include "vtkOversketchProfileRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include <QLabel>

namespace oversketch_studio
{

ProfileTool::ProfileTool(const std::shared_ptr<EditHand>& hand, Viewport* viewport)
  : EditTool(hand, vtkOversketchEditWidget::Profile, viewport)
{
  this->setObjectName("cross_section");
}

ProfileTool::~ProfileTool()
{
  // The dock's window may be gone before the hand.
  this->hand().widget()->GetProfilePlaneWidget()->SetProfileRenderer(nullptr);
}

// A section, drawn higher.
QPainterPath ProfileTool::icon() const
{
  QPainterPath path;
  path.moveTo(2, 20);
  path.cubicTo(7, 20, 8, 15, 12, 15);
  path.cubicTo(16, 15, 17, 20, 22, 20);
  path.moveTo(4, 17);
  path.cubicTo(8, 16, 8, 4, 12, 4);
  path.cubicTo(16, 4, 16, 16, 20, 17);
  return path;
}

QVector<QPair<QString, QString>> ProfileTool::ways() const
{
  return {
    { tr("  On the plane"), tr("its knob, border or section: slide it along the line") },
    { tr("  In the dock"), tr("redraw the section, wholly or in part") },
    { "6  0", tr("show all planes or none") },
    { "7  8  9", tr("show one of the planes alone") },
  };
}

QString ProfileTool::way() const
{
  return tr("Draw over the section in the dock, and the model follows; orange is its left end, the arrow "
            "points outward. Drag the plane along the line. Return: done.");
}

QWidget* ProfileTool::makePanel(QWidget* parent)
{
  this->Panel = new EditPanel(this->viewport(), tr("Profile"), "profile_picture", parent);
  this->Panel->addControl(new QLabel(tr("Draw over the section: the model follows."), this->Panel));
  vtkOversketchProfilePlaneWidget* planes = this->hand().widget()->GetProfilePlaneWidget();
  planes->GetPen()->CommitOnReleaseOn(); // a stroke can be undone
  planes->SetProfileRenderer(this->Panel->renderer());
  this->Panel->fit = [planes] { planes->GetProfileRepresentation()->ResetView(); };
  this->Panel->wantsKeys = [planes] { return planes->GetPen()->IsDrawing(); };
  return this->Panel;
}

} // namespace oversketch_studio
