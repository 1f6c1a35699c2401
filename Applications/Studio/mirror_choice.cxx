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
  choice->addItems({ Texts::tr("One side"),
    Texts::tr("Both sides of x"),
    Texts::tr("Both sides of y"),
    Texts::tr("Both sides of z") });
  return choice;
}

} // namespace oversketch_studio
