#include "length_box.h"

#include <algorithm>
#include <cmath>

namespace oversketch_studio
{

namespace
{

constexpr double leastShare = 1e-3;

} // namespace

LengthBox::LengthBox(QWidget* parent)
  : QDoubleSpinBox(parent)
{
  this->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  this->setKeyboardTracking(false);
}

void LengthBox::begin(double diagonal)
{
  this->Diagonal = diagonal > 0.0 ? diagonal : 1.0;
  const double least = leastShare * this->Diagonal;
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(least))), 0, 12);
  this->setDecimals(std::max(decimals - 1, 0));
  this->setRange(least, this->Diagonal);
}

double LengthBox::turned(double length, double notches) const
{
  return std::clamp(length * std::pow(1.0 + notch, notches), leastShare * this->Diagonal, this->Diagonal);
}

} // namespace oversketch_studio
