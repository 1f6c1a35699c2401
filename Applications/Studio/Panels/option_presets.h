// Sets of a tool's options by names that the user gives, kept per user.
#ifndef oversketch_applications_studio_panels_option_presets_h
#define oversketch_applications_studio_panels_option_presets_h

#include "step.h"

#include <QMenu>
#include <QStringList>

namespace oversketch_studio
{

class Tool;

class OptionPresets : public QMenu
{
  Q_OBJECT

public:
  explicit OptionPresets(QWidget* parent = nullptr);

  // Whose options they are from here on.
  void setTool(Tool* tool);

  // Those of the tool, in the alphabet's order; kept, and taken up again. A name that is there is replaced;
  // one that is not is of no effect.
  QStringList names() const;
  void keep(const QString& name) const;
  void choose(const QString& name) const;
  void remove(const QString& name) const;

private:
  void fill();
  void keepAsked();

  Tool* Of = nullptr;
};

} // namespace oversketch_studio
#endif
