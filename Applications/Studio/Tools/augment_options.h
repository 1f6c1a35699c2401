// The values that a line on the surface is made with: the bar above the viewport.
#ifndef oversketch_applications_studio_tools_augment_options_h
#define oversketch_applications_studio_tools_augment_options_h

#include "step.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace oversketch_studio
{

class LengthBox;

class AugmentOptions : public QWidget
{
  Q_OBJECT

public:
  explicit AugmentOptions(QWidget* parent = nullptr);

  double diagonal() const;
  // For a model whose box has that diagonal: radius and height begin as the system's own are there.
  void begin(double diagonal);
  // Lengths are those of the model, whatever becomes of it: SketchMode, Radius, Height, UsePressure.
  oversketch_session::Values values() const;
  // Shows those of a step; of lengths that it leaves to the system, what they are on that model.
  void setValues(const oversketch_session::Values& values);

  // A notch is a tenth, of the radius more and of the radius in height, through to carving and back. Times
  // are those of the events [ms].
  void widen(double notches, ulong time);
  void heighten(double notches, ulong time);
  bool isOnSurface() const;

signals:
  // By the hand; `mergesIntoLast`: so soon after the last change of the same length that it is one with it.
  void shaped(bool mergesIntoLast);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  double height() const { return this->Height == 0.0 ? 0.5 * this->Radius : this->Height; }
  void refresh();
  void chosen();
  void changed(const QDoubleSpinBox* length, ulong time);

  double Radius = 0.03;
  double Height = 0.0; // 0: half the radius; below 0 inward
  QComboBox *Mode, *Direction;
  LengthBox *RadiusBox, *HeightBox;
  QCheckBox* Pressure;
  const QDoubleSpinBox* LastChanged = nullptr;
  ulong LastTime = 0, BoxTime = 0; // of that change; of the last event that came to a box
};

} // namespace oversketch_studio
#endif
