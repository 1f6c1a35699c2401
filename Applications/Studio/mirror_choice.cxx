#include "mirror_choice.h"

#include <QComboBox>
#include <QCoreApplication>

namespace oversketch_studio
{

namespace
{

struct Texts
{
  Q_DECLARE_TR_FUNCTIONS(MirrorChoice)
};

} // namespace

QComboBox* mirrorChoice(QWidget* parent)
{
  auto* choice = new QComboBox(parent);
  choice->addItems(
    { Texts::tr("Off"), Texts::tr("Left–right (x)"), Texts::tr("Up–down (y)"), Texts::tr("Front–back (z)") });
  return choice;
}

} // namespace oversketch_studio
