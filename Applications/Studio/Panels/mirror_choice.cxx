#include "mirror_choice.h"

#include <QComboBox>
#include <QCoreApplication>

namespace oversketch_studio
{

namespace
{

struct MirrorTexts
{
  Q_DECLARE_TR_FUNCTIONS(MirrorChoice)
};

} // namespace

QComboBox* mirrorChoice(QWidget* parent)
{
  auto* choice = new QComboBox(parent);
  choice->addItems({ MirrorTexts::tr("Off"),
    MirrorTexts::tr("Left–right (x)"),
    MirrorTexts::tr("Up–down (y)"),
    MirrorTexts::tr("Front–back (z)") });
  return choice;
}

} // namespace oversketch_studio
