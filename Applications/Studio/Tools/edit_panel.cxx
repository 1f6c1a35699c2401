#include "edit_panel.h"

#include "frame_view.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace oversketch_studio
{

namespace
{

constexpr int leastWidth = 190, leastHeight = 90;

} // namespace

EditPanel::EditPanel(QWidget* canvas, const QString& title, const QString& name, QWidget* parent)
  : QWidget(parent)
  , Canvas(canvas)
  , Picture(new FrameView(this))
  , Controls(new QHBoxLayout)
{
  this->Picture->setObjectName(name);
  this->Picture->setAccessibleName(title);
  this->Picture->setMinimumSize(leastWidth, leastHeight);
  this->Picture->setFocusPolicy(Qt::NoFocus);
  auto* column = new QVBoxLayout(this);
  column->addWidget(this->Picture, 1);
  column->addLayout(this->Controls);
  this->Picture->installEventFilter(this);
  this->Canvas->installEventFilter(this);
  this->setDark(true);
}

EditPanel::~EditPanel()
{
  if (this->Canvas)
  {
    this->Canvas->removeEventFilter(this);
  }
}

vtkRenderer* EditPanel::renderer()
{
  return this->Picture->renderer();
}

void EditPanel::addControl(QWidget* control)
{
  this->Controls->addWidget(control);
}

// Paper: what is drawn on it has dark and light parts.
void EditPanel::setDark(bool dark)
{
  dark ? this->renderer()->SetBackground(0.44, 0.45, 0.48)
       : this->renderer()->SetBackground(0.84, 0.85, 0.87);
  this->Picture->renderWindow()->Render();
}

// A dock that floats is a window of its own, which has the keys while it is in front.
bool EditPanel::event(QEvent* event)
{
  if (event->type() == QEvent::ParentChange && this->parentWidget())
  {
    this->parentWidget()->installEventFilter(this);
  }
  return QWidget::event(event);
}

bool EditPanel::eventFilter(QObject* watched, QEvent* event)
{
  const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
  if (watched == this->Picture)
  {
    if (event->type() == QEvent::Resize && this->fit)
    {
      this->fit();
    }
  }
  else if (isKey && watched == this->Canvas && this->wantsKeys && this->wantsKeys())
  {
    return QCoreApplication::sendEvent(this->Picture, event);
  }
  else if (isKey && this->Canvas && watched == this->parentWidget())
  {
    return QCoreApplication::sendEvent(this->Canvas, event);
  }
  return false;
}

} // namespace oversketch_studio
