// A frame about a view, in the colour of the focus while keys go there.
#ifndef oversketch_applications_studio_panels_focus_frame_h
#define oversketch_applications_studio_panels_focus_frame_h

#include <QApplication>
#include <QFrame>
#include <QVBoxLayout>

namespace oversketch_studio
{

class FocusFrame : public QFrame
{
public:
  explicit FocusFrame(QWidget* view, QWidget* parent = nullptr)
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
};

} // namespace oversketch_studio
#endif
