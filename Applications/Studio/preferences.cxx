#include "preferences.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSettings>

#include <algorithm>

namespace oversketch_studio
{

namespace
{

constexpr double longestString = 100.0; // px, of vtkOversketchStrokeWidget

} // namespace

Preferences Preferences::read()
{
  const QSettings settings;
  const Preferences usual;
  Preferences kept;
  kept.stabilizer = std::clamp(settings.value("stabilizer", usual.stabilizer).toDouble(), 0.0, longestString);
  kept.dark = settings.value("dark", usual.dark).toBool();
  kept.backend = std::clamp(settings.value("backend", usual.backend).toInt(), 0, 2);
  return kept;
}

void Preferences::write() const
{
  QSettings settings;
  settings.setValue("stabilizer", this->stabilizer);
  settings.setValue("dark", this->dark);
  settings.setValue("backend", this->backend);
}

PreferencesDialog::PreferencesDialog(const Preferences& preferences, QWidget* parent)
  : QDialog(parent)
  , stabilizer_(new QDoubleSpinBox(this))
  , dark_(new QCheckBox(tr("&Dark window"), this))
  , backend_(new QComboBox(this))
{
  this->setWindowTitle(tr("Preferences"));
  this->stabilizer_->setRange(0.0, longestString);
  this->stabilizer_->setDecimals(0);
  this->stabilizer_->setSuffix(tr(" px"));
  this->stabilizer_->setSpecialValueText(tr("off"));
  this->stabilizer_->setValue(preferences.stabilizer);
  this->stabilizer_->setToolTip(
    tr("The line trails behind the pen by this much, so that a trembling hand leaves no trace"));
  this->dark_->setChecked(preferences.dark);
  this->backend_->addItems(
    { tr("OpenCL where there is a device"), tr("OpenCL"), tr("the processor (Embree)") });
  this->backend_->setCurrentIndex(preferences.backend);
  this->backend_->setToolTip(tr(
    "What measures the thickness of a model. The open one is computed again at once; Undo takes that back. "
    "A session keeps what it was saved with, until you choose another."));

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout(this);
  form->addRow(tr("&Steady hand"), this->stabilizer_);
  form->addRow(tr("&Compute on"), this->backend_);
  form->addRow(this->dark_);
  form->addRow(buttons);
}

Preferences PreferencesDialog::preferences() const
{
  Preferences chosen;
  chosen.stabilizer = this->stabilizer_->value();
  chosen.dark = this->dark_->isChecked();
  chosen.backend = this->backend_->currentIndex();
  return chosen;
}

} // namespace oversketch_studio
