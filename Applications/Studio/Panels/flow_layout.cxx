#include "flow_layout.h"

#include <algorithm>

namespace oversketch_studio
{

namespace
{

constexpr int usualGap = 6; // px

bool isThere(const QLayoutItem* item)
{
  return !item->isEmpty(); // hidden
}

int gapOf(const QLayout& layout)
{
  return layout.spacing() < 0 ? usualGap : layout.spacing();
}

} // namespace

// In one line.
QSize FlowLayout::sizeHint() const
{
  QSize size(0, 0);
  for (const QLayoutItem* item : this->Items)
  {
    if (isThere(item))
    {
      const QSize one = item->sizeHint();
      size = { size.width() + one.width() + (size.isEmpty() ? 0 : gapOf(*this)),
        std::max(size.height(), one.height()) };
    }
  }
  return size.grownBy(this->contentsMargins());
}

// The widest alone.
QSize FlowLayout::minimumSize() const
{
  QSize size;
  for (const QLayoutItem* item : this->Items)
  {
    if (isThere(item))
    {
      size = size.expandedTo(item->minimumSize());
    }
  }
  return size.grownBy(this->contentsMargins());
}

void FlowLayout::setGeometry(const QRect& place)
{
  QLayout::setGeometry(place);
  this->arrange(place, true);
}

int FlowLayout::arrange(const QRect& place, bool moves) const
{
  const QMargins margins = this->contentsMargins();
  const QRect room = place.marginsRemoved(margins);
  const int gap = gapOf(*this);
  QVector<QLayoutItem*> line;
  int x = room.x(), y = room.y(), high = 0;
  const auto height = [](const QLayoutItem* item, int wide)
  { return item->hasHeightForWidth() ? item->heightForWidth(wide) : item->sizeHint().height(); };
  const auto width = [&room](const QLayoutItem* item)
  { return std::max(item->minimumSize().width(), std::min(item->sizeHint().width(), room.width())); };
  const auto endLine = [&]
  {
    int left = room.x();
    for (QLayoutItem* item : line)
    {
      const int wide = width(item), tall = height(item, wide);
      if (moves)
      {
        item->setGeometry({ left, y + (high - tall) / 2, wide, tall });
      }
      left += wide + gap;
    }
    line.clear();
    y += high + gap;
    x = room.x();
    high = 0;
  };
  for (QLayoutItem* item : this->Items)
  {
    if (!isThere(item))
    {
      continue;
    }
    const int wide = width(item);
    if (!line.isEmpty() && x + wide > room.x() + room.width())
    {
      endLine();
    }
    line << item;
    x += wide + gap;
    high = std::max(high, height(item, wide));
  }
  if (!line.isEmpty())
  {
    endLine();
  }
  return y - gap - place.y() + margins.bottom();
}

} // namespace oversketch_studio
