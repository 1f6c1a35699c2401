#include "overlays.h"

#include <QWidget>

namespace oversketch_studio
{

std::vector<Hint::Box> overlaysOf(const QWidget& view)
{
  std::vector<Hint::Box> boxes;
  const double ratio = view.devicePixelRatioF();
  for (const QWidget* one : view.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
  {
    if (!one->isHidden())
    {
      const QRect at = one->geometry();
      boxes.push_back({ ratio * at.left(),
        ratio * (at.right() + 1),
        ratio * (view.height() - at.bottom() - 1),
        ratio * (view.height() - at.top()) });
    }
  }
  return boxes;
}

} // namespace oversketch_studio
