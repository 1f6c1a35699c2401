// A field for a length of the model, which keys and the wheel change by shares of it.
#ifndef oversketch_applications_studio_tools_length_box_h
#define oversketch_applications_studio_tools_length_box_h

#include <QDoubleSpinBox>

namespace oversketch_studio
{

class LengthBox : public QDoubleSpinBox
{
public:
  static constexpr double notch = 0.1; // share that a notch of the wheel adds

  explicit LengthBox(QWidget* parent);
  // Begins anew for a model whose box has that diagonal: from a thousandth of it to all, in three digits of
  // the least.
  void begin(double diagonal);
  double diagonal() const { return this->Diagonal; }
  // A length after so many notches, within those bounds.
  double turned(double length, double notches) const;

private:
  double Diagonal = 1.0;
};

} // namespace oversketch_studio
#endif
