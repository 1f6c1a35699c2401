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
  kept.leftHanded = settings.value("leftHanded", usual.leftHanded).toBool();
  kept.backend = std::clamp(settings.value("backend", usual.backend).toInt(), 0, 2);
  return kept;
}

void Preferences::write() const
{
  QSettings settings;
  settings.setValue("stabilizer", this->stabilizer);
  settings.setValue("dark", this->dark);
  settings.setValue("leftHanded", this->leftHanded);
  settings.setValue("backend", this->backend);
}

PreferencesDialog::PreferencesDialog(const Preferences& preferences, QWidget* parent)
  : QDialog(parent)
  , Stabilizer(new QDoubleSpinBox(this))
  , Dark(new QCheckBox(tr("&Dark window"), this))
  , LeftHanded(new QCheckBox(tr("&Left-handed"), this))
  , Backend(new QComboBox(this))
{
  this->setWindowTitle(tr("Preferences"));
  this->Stabilizer->setRange(0.0, longestString);
  this->Stabilizer->setDecimals(0);
  this->Stabilizer->setSuffix(tr(" px"));
  this->Stabilizer->setSpecialValueText(tr("off"));
  this->Stabilizer->setValue(preferences.stabilizer);
  this->Stabilizer->setToolTip(
    tr("The line trails behind the pen by this much, so that a trembling hand leaves no trace"));
  this->Dark->setChecked(preferences.dark);
  this->LeftHanded->setChecked(preferences.leftHanded);
  this->LeftHanded->setToolTip(
    tr("Tools at the right and panels at the left, so that the hand does not lie over them"));
  this->Backend->addItems(
    { tr("OpenCL where there is a device"), tr("OpenCL"), tr("the processor (Embree)") });
  this->Backend->setCurrentIndex(preferences.backend);
  this->Backend->setToolTip(
    tr("What measures the thickness of a model. The open one is computed again at once; Undo takes that "
       "back. A session keeps what it was saved with, until you choose another."));

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout(this);
  form->addRow(tr("&Steady hand"), this->Stabilizer);
  form->addRow(tr("&Compute on"), this->Backend);
  form->addRow(this->Dark);
  form->addRow(this->LeftHanded);
  form->addRow(buttons);
}

Preferences PreferencesDialog::preferences() const
{
  Preferences chosen;
  chosen.stabilizer = this->Stabilizer->value();
  chosen.dark = this->Dark->isChecked();
  chosen.leftHanded = this->LeftHanded->isChecked();
  chosen.backend = this->Backend->currentIndex();
  return chosen;
}

} // namespace oversketch_studio
