// Settings that a person makes once, kept per user in the usual place.
#ifndef oversketch_applications_studio_window_preferences_h
#define oversketch_applications_studio_window_preferences_h

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace oversketch_studio
{

struct Preferences
{
  double stabilizer = 6.0; // how far the line trails behind the pen [px of the screen, 0 to 100]
  bool dark = true;
  bool leftHanded = false; // tools at the right, panels at the left
  // For models that are opened from now on; a session keeps its own.
  int backend = 0; // vtkOversketchSystem::BackendType

  // Those that QSettings holds; values out of range count as the nearest in range.
  static Preferences read();
  void write() const;
};

class PreferencesDialog : public QDialog
{
  Q_OBJECT

public:
  PreferencesDialog(const Preferences& preferences, QWidget* parent = nullptr);
  Preferences preferences() const;

private:
  QDoubleSpinBox* Stabilizer;
  QCheckBox *Dark, *LeftHanded;
  QComboBox* Backend;
};

} // namespace oversketch_studio
#endif
