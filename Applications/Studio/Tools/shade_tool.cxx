#include "shade_tool.h"

#include "vtkOversketchAreaSelectWidget.h"
#include "vtkOversketchEdit.h"
#include "vtkOversketchEditWidget.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkCamera.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace oversketch_studio
{

namespace
{

constexpr int fewestLevels = 2, mostLevels = 16; // as the step's form has them
constexpr double room = 1.08;                    // round the disc, in radii

// All of the disc is seen.
void lookAtDisc(vtkRenderer* renderer)
{
  const int* size = renderer->GetSize();
  const double wide = size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.0;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(5.0, 15.0);
  camera->SetParallelScale(room / std::min(1.0, std::max(wide, 0.1)));
}

} // namespace

ShadeTool::ShadeTool(const std::shared_ptr<EditHand>& hand, Viewport* viewport)
  : EditTool(hand, vtkOversketchEditWidget::Shade, viewport)
{
  this->setObjectName("shade");
  connect(hand.get(), &EditHand::arranged, this, &ShadeTool::follow);
  connect(hand.get(), &EditHand::left, this, &ShadeTool::follow);
}

ShadeTool::~ShadeTool()
{
  // The dock's window may be gone before the hand.
  this->hand().widget()->SetDiscRenderer(nullptr);
}

// Layers round a line.
QPainterPath ShadeTool::icon() const
{
  QPainterPath path;
  path.addEllipse(QPointF(12, 12), 10, 9.5);
  path.addEllipse(QPointF(12, 12), 6.5, 5.5);
  path.moveTo(9, 12);
  path.lineTo(15, 12);
  return path;
}

QVector<QPair<QString, QString>> ShadeTool::ways() const
{
  return {
    { tr("  On a layer"), tr("outward: more follows, inward: less; in the dock as on the model") },
    { tr("Delete"), tr("take the last handle away") },
    { tr("  With the lasso"), tr("round a part: it has layers of its own") },
  };
}

QString ShadeTool::way() const
{
  return this->Lasso && this->Lasso->isChecked()
           ? tr("Draw a lasso round a part of the region, on the model or on the disc: layers that you drag "
                "then are that part's.")
           : tr("Drag a layer outward and more of the model follows the line, inward less, here or on the "
                "disc. E drags the line. Return: done.");
}

QWidget* ShadeTool::makePanel(QWidget* parent)
{
  this->Panel = new EditPanel(this->viewport(), tr("Disc"), "disc_picture", parent);
  this->Lasso = new QToolButton(this->Panel);
  this->Lasso->setObjectName("disc_lasso");
  this->Lasso->setText(tr("Lasso"));
  this->Lasso->setToolTip(tr("The next line is a lasso: what it holds has layers of its own"));
  this->Lasso->setCheckable(true);
  this->Lasso->setFocusPolicy(Qt::NoFocus);
  auto* label = new QLabel(tr("Levels"), this->Panel);
  this->Levels = new QSpinBox(this->Panel);
  this->Levels->setObjectName("disc_levels");
  this->Levels->setAccessibleName(tr("Grey levels"));
  this->Levels->setToolTip(tr("How many greys are shown; what follows does not depend on it"));
  this->Levels->setRange(fewestLevels, mostLevels);
  this->Levels->setKeyboardTracking(false);
  label->setBuddy(this->Levels);
  for (QWidget* one : std::initializer_list<QWidget*>{ this->Lasso, label, this->Levels })
  {
    this->Panel->addControl(one);
  }
  connect(this->Lasso,
    &QToolButton::toggled,
    this,
    [this](bool on)
    {
      if (this->isHeld())
      {
        this->hand().setMode(on ? vtkOversketchEditWidget::Areas : vtkOversketchEditWidget::Shade);
      }
    });
  connect(this->Levels,
    QOverload<int>::of(&QSpinBox::valueChanged),
    this,
    [this](int levels)
    {
      this->hand().setLevels(levels);
      this->viewport()->setFocus();
    });
  vtkOversketchEditWidget* edit = this->hand().widget();
  edit->SetDiscRenderer(this->Panel->renderer());
  this->Panel->fit = [this] { lookAtDisc(this->Panel->renderer()); };
  this->Panel->wantsKeys = [edit] { return edit->GetDiscAreaWidget()->GetPen()->IsDrawing(); };
  this->follow();
  return this->Panel;
}

void ShadeTool::start()
{
  EditTool::start();
  if (this->Lasso && this->Lasso->isChecked())
  {
    this->hand().setMode(vtkOversketchEditWidget::Areas);
  }
}

void ShadeTool::follow()
{
  if (!this->Panel)
  {
    return;
  }
  const bool isThere = this->hand().hasRegion();
  this->Lasso->setEnabled(isThere);
  this->Levels->setEnabled(isThere);
  const QSignalBlocker quiet(this->Levels);
  this->Levels->setValue(this->hand().widget()->GetEdit()->GetLevels());
  // A lasso has been drawn: its layers come next.
  const int areas =
    static_cast<int>(this->hand().widget()->GetAreaSelectWidget()->GetAreas()->GetNumberOfLines());
  if (std::exchange(this->Areas, areas) < areas && this->isHeld() && !this->hand().draws())
  {
    this->Lasso->setChecked(false);
  }
}

} // namespace oversketch_studio
