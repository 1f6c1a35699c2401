// How a person likes to look at models, kept per user.
#ifndef oversketch_applications_studio_view_view_settings_h
#define oversketch_applications_studio_view_view_settings_h

#include "shading.h"

namespace oversketch_studio
{

struct ViewSettings
{
  Shading shading = Shading::Smooth;
  bool parallel = false; // orthographic
  bool free = false;     // turns as a ball does; else upright
  bool ground = false;

  // What QSettings holds; what it cannot be counts as usual.
  static ViewSettings read();
  void write() const;
};

} // namespace oversketch_studio
#endif
