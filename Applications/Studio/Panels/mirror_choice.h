// The choice of a mirror plane.
#ifndef oversketch_applications_studio_panels_mirror_choice_h
#define oversketch_applications_studio_panels_mirror_choice_h

class QComboBox;
class QWidget;

namespace oversketch_studio
{

// None, x, y, z. Its index is what Document::mirrorPlane takes.
QComboBox* mirrorChoice(QWidget* parent);

} // namespace oversketch_studio
#endif
