// A frame about a view, in the colour of the focus while keys go there.
#ifndef oversketch_applications_studio_panels_focus_frame_h
#define oversketch_applications_studio_panels_focus_frame_h

#include <QFrame>

namespace oversketch_studio
{

class FocusFrame : public QFrame
{
  Q_OBJECT

public:
  FocusFrame(QWidget* view, QWidget* parent = nullptr);
};

} // namespace oversketch_studio
#endif
