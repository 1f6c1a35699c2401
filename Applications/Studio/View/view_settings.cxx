#include "view_settings.h"

#include <QSettings>

namespace oversketch_studio
{

ViewSettings ViewSettings::read()
{
  const QSettings settings;
  ViewSettings kept;
  const int shading = settings.value("view/shading", 0).toInt();
  kept.shading = shading > 0 && shading < shadings ? static_cast<Shading>(shading) : Shading::Smooth;
  kept.parallel = settings.value("view/parallel", kept.parallel).toBool();
  kept.free = settings.value("view/free", kept.free).toBool();
  kept.ground = settings.value("view/ground", kept.ground).toBool();
  return kept;
}

void ViewSettings::write() const
{
  QSettings settings;
  settings.setValue("view/shading", static_cast<int>(this->shading));
  settings.setValue("view/parallel", this->parallel);
  settings.setValue("view/free", this->free);
  settings.setValue("view/ground", this->ground);
}

} // namespace oversketch_studio
