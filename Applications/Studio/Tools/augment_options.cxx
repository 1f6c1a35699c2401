#include "augment_options.h"

#include "flow_layout.h"
#include "length_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QInputEvent>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr double ownRadius = 0.03; // of the diagonal: the system's
constexpr ulong pause = 1000;      // ms; a hand that rests so long begins anew

} // namespace

AugmentOptions::AugmentOptions(QWidget* parent)
  : QWidget(parent)
  , Mode(new QComboBox(this))
  , Direction(new QComboBox(this))
  , RadiusBox(new LengthBox(this))
  , HeightBox(new LengthBox(this))
  , Pressure(new QCheckBox(tr("Pressure is height"), this))
{
  auto* row = new FlowLayout(this);
  row->setContentsMargins(6, 0, 0, 0);
  const auto add = [&](QWidget* widget, const char* name, const QString& spoken, const QString& help)
  {
    widget->setObjectName(name);
    widget->setAccessibleName(spoken);
    widget->setToolTip(help);
    row->addWidget(widget);
  };
  this->Mode->addItems({ tr("Surface"), tr("Outline feature") });
  add(this->Mode,
    "augment_mode",
    tr("Lines are"),
    tr("Lines on the surface that rise, or new outlines of what they are drawn beside"));
  row->addWidget(new QLabel(tr("Radius"), this));
  add(this->RadiusBox,
    "augment_radius",
    tr("Radius"),
    tr("How far from the line it rises, in lengths of the model (Ctrl + wheel)"));
  this->Direction->addItems({ tr("Raise"), tr("Carve") });
  add(this->Direction, "augment_direction", tr("Raise or carve"), tr("Outward, or into the model"));
  add(this->HeightBox,
    "augment_height",
    tr("Height"),
    tr("How high or deep it is on the line, in lengths of the model; with a minus it is carved (Shift + "
       "wheel)"));
  add(this->Pressure,
    "augment_pressure",
    tr("Pressure is height"),
    tr("Where the pen is pressed less it rises less"));
  for (QDoubleSpinBox* box : { this->RadiusBox, this->HeightBox })
  {
    box->installEventFilter(this);
  }
  connect(this->Mode, QOverload<int>::of(&QComboBox::activated), this, &AugmentOptions::chosen);
  connect(this->Direction,
    QOverload<int>::of(&QComboBox::activated),
    this,
    [this](int choice)
    {
      const double size = std::abs(this->height());
      this->Height = choice == 1 ? -size : this->Height == 0.0 ? 0.0 : size;
      this->chosen();
    });
  connect(this->RadiusBox,
    QOverload<double>::of(&QDoubleSpinBox::valueChanged),
    this,
    [this](double radius)
    {
      this->Radius = radius;
      this->changed(this->RadiusBox, this->BoxTime);
    });
  connect(this->HeightBox,
    QOverload<double>::of(&QDoubleSpinBox::valueChanged),
    this,
    [this](double height)
    {
      const double size = std::max(std::abs(height), this->RadiusBox->minimum());
      this->Height = std::copysign(size, height < 0.0 ? height : this->Height);
      this->changed(this->HeightBox, this->BoxTime);
    });
  connect(this->Pressure, &QCheckBox::clicked, this, &AugmentOptions::chosen);
  this->begin(1.0);
}

double AugmentOptions::diagonal() const
{
  return this->RadiusBox->diagonal();
}

void AugmentOptions::begin(double diagonal)
{
  const QSignalBlocker quiet(this->RadiusBox), silent(this->HeightBox);
  this->RadiusBox->begin(diagonal);
  this->HeightBox->begin(diagonal);
  this->HeightBox->setMinimum(-this->diagonal()); // a minus carves
  this->Radius = ownRadius * this->diagonal();
  this->Height = 0.0;
  this->refresh();
}

Values AugmentOptions::values() const
{
  return { { "SketchMode", this->Mode->currentIndex() },
    { "Radius", this->Radius },
    { "Height", this->height() },
    { "UsePressure", this->Pressure->isChecked() } };
}

void AugmentOptions::setValues(const Values& values)
{
  this->Mode->setCurrentIndex(valueOr(values, "SketchMode", 0));
  this->Pressure->setChecked(valueOr(values, "UsePressure", false));
  const double radius = valueOr(values, "Radius", -1.0), height = valueOr(values, "Height", 0.0);
  this->Radius = radius > 0.0 ? radius : ownRadius * this->diagonal();
  // Half the radius is what is nobody's choice, and stays so.
  const bool isOwn = height == 0.0 || std::abs(height - 0.5 * this->Radius) < 1e-12 * this->Radius;
  this->Height = isOwn ? 0.0 : height;
  this->refresh();
}

void AugmentOptions::refresh()
{
  const QSignalBlocker quiet(this->RadiusBox), silent(this->HeightBox);
  this->RadiusBox->setValue(this->Radius);
  this->HeightBox->setValue(std::abs(this->height()));
  this->Direction->setCurrentIndex(this->Height < 0.0 ? 1 : 0);
  for (QWidget* one : std::initializer_list<QWidget*>{ this->Direction, this->HeightBox, this->Pressure })
  {
    one->setEnabled(this->isOnSurface());
  }
}

bool AugmentOptions::isOnSurface() const
{
  return this->Mode->currentIndex() == 0;
}

void AugmentOptions::widen(double notches, ulong time)
{
  this->Radius = this->RadiusBox->turned(this->Radius, notches);
  this->changed(this->RadiusBox, time);
}

void AugmentOptions::heighten(double notches, ulong time)
{
  const double step = LengthBox::notch * this->Radius, least = 0.5 * step;
  double height = this->height() + notches * step;
  // There is no height of 0, which is the system's word for its own.
  height = std::abs(height) < least ? std::copysign(step, notches) : height;
  this->Height = std::clamp(height, -this->diagonal(), this->diagonal());
  this->changed(this->HeightBox, time);
}

bool AugmentOptions::eventFilter(QObject*, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      this->BoxTime = static_cast<QInputEvent*>(event)->timestamp();
      break;
    default:
      break;
  }
  return false;
}

void AugmentOptions::chosen()
{
  this->LastChanged = nullptr;
  this->refresh();
  emit this->shaped(false);
}

// By the events' own times: a busy machine may be late with them.
void AugmentOptions::changed(const QDoubleSpinBox* length, ulong time)
{
  const bool mergesIntoLast =
    length == this->LastChanged && time >= this->LastTime && time - this->LastTime < pause;
  this->LastChanged = length;
  this->LastTime = time;
  this->refresh();
  emit this->shaped(mergesIntoLast);
}

} // namespace oversketch_studio
