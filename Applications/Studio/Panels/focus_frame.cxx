#include "focus_frame.h"

#include <QApplication>
#include <QVBoxLayout>

namespace oversketch_studio
{

FocusFrame::FocusFrame(QWidget* view, QWidget* parent)
  : QFrame(parent)
{
  auto* about = new QVBoxLayout(this);
  about->setContentsMargins(2, 2, 2, 2);
  about->addWidget(view);
  this->setAutoFillBackground(true);
  connect(qApp,
    &QApplication::focusChanged,
    this,
    [this, view](QWidget*, QWidget* now)
    { this->setBackgroundRole(now == view ? QPalette::Highlight : QPalette::Window); });
}

} // namespace oversketch_studio
