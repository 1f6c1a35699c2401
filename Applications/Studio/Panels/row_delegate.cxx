#include "row_delegate.h"

#include "thumbnail.h"

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QStyle>

#include <algorithm>

namespace oversketch_studio
{

using oversketch_session::Thumbnail;

namespace
{

constexpr int pictureWidth = Thumbnail::width / 2, pictureHeight = Thumbnail::height / 2; // px as Qt counts
constexpr int space = 4;                                                                  // px between things

bool isStep(const QModelIndex& index)
{
  return index.data(RowDelegate::LineRole).toInt() < 0;
}

// Without the room for the marker.
QRect rectOfRow(const QStyleOptionViewItem& option, const QModelIndex& index)
{
  const int gap = RowDelegate::gapHeight(option.fontMetrics);
  switch (index.data(RowDelegate::GapRole).toInt())
  {
    case RowDelegate::GapBelow:
      return option.rect.adjusted(0, 0, 0, -gap);
    case RowDelegate::GapAbove:
      return option.rect.adjusted(0, gap, 0, 0);
    default:
      return option.rect;
  }
}

QStyle* styleOf(const QStyleOptionViewItem& option)
{
  return option.widget ? option.widget->style() : QApplication::style();
}

struct Places
{
  QRect check, picture, name, words, mark;

  // `option` of the row without the room for the marker.
  explicit Places(const QStyleOptionViewItem& option)
  {
    const QRect row = option.rect;
    this->check =
      styleOf(option)->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, option.widget);
    this->picture = { this->check.right() + space, 0, pictureWidth, pictureHeight };
    this->picture.moveTop(row.center().y() - pictureHeight / 2);
    const int wide = option.icon.isNull() ? 0 : option.decorationSize.width();
    this->mark = { row.right() - wide - space, row.center().y() - wide / 2, wide, wide };
    const int left = this->picture.right() + 2 * space, height = option.fontMetrics.height();
    const int width = std::max(0, this->mark.left() - space - left);
    this->name = { left, row.center().y() - height, width, height };
    this->words = { left, row.center().y() + 1, width, height };
  }
};

} // namespace

QSize RowDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
  QSize size = QStyledItemDelegate::sizeHint(option, index);
  if (isStep(index))
  {
    // As narrow as need be: texts are cut off before the list scrolls sideways.
    size = { pictureWidth + 60, std::max(pictureHeight, 2 * option.fontMetrics.height()) + space };
  }
  size.rheight() += index.data(GapRole).toInt() == NoGap ? 0 : gapHeight(option.fontMetrics);
  return size;
}

void RowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given, const QModelIndex& index) const
{
  QStyleOptionViewItem option = given;
  this->initStyleOption(&option, index);
  option.rect = rectOfRow(given, index);
  QStyle* style = styleOf(option);
  painter->save();
  painter->setOpacity(index.data(HiddenRole).toBool() ? 0.45 : 1.0);
  if (!isStep(index))
  {
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
    painter->restore();
    return;
  }
  const Places places(option);
  style->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, option.widget);
  QStyleOptionViewItem check = option;
  check.rect = places.check;
  check.state &= ~QStyle::State_HasFocus;
  check.state |= option.checkState == Qt::Checked ? QStyle::State_On : QStyle::State_Off;
  style->drawPrimitive(QStyle::PE_IndicatorItemViewItemCheck, &check, painter, option.widget);
  const auto picture = index.data(PictureRole).value<QImage>();
  if (!picture.isNull())
  {
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    painter->drawImage(places.picture, picture);
  }
  const bool isSelected = option.state & QStyle::State_Selected;
  const QPalette::ColorGroup group =
    option.state & QStyle::State_Active ? QPalette::Active : QPalette::Inactive;
  QColor ink = option.palette.color(group, isSelected ? QPalette::HighlightedText : QPalette::Text);
  painter->setPen(ink);
  const auto write = [&](const QRect& place, const QString& text)
  {
    painter->drawText(place,
      Qt::AlignLeft | Qt::AlignVCenter,
      option.fontMetrics.elidedText(text, Qt::ElideRight, place.width()));
  };
  write(places.name, option.text);
  ink.setAlphaF(0.7);
  painter->setPen(ink);
  write(places.words, index.data(WordsRole).toString());
  option.icon.paint(painter, places.mark);
  if (option.state & QStyle::State_HasFocus)
  {
    QStyleOptionFocusRect focus;
    focus.QStyleOption::operator=(option);
    focus.state |= QStyle::State_KeyboardFocusChange;
    focus.backgroundColor = option.palette.color(isSelected ? QPalette::Highlight : QPalette::Base);
    style->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, painter, option.widget);
  }
  painter->restore();
}

bool RowDelegate::editorEvent(QEvent* event,
  QAbstractItemModel* model,
  const QStyleOptionViewItem& given,
  const QModelIndex& index)
{
  QStyleOptionViewItem option = given;
  option.rect = rectOfRow(given, index);
  return QStyledItemDelegate::editorEvent(event, model, option, index);
}

void RowDelegate::updateEditorGeometry(QWidget* editor,
  const QStyleOptionViewItem& given,
  const QModelIndex& index) const
{
  QStyleOptionViewItem option = given;
  this->initStyleOption(&option, index);
  option.rect = rectOfRow(given, index);
  editor->setGeometry(Places(option).name.adjusted(-space, -space, 0, space));
}

} // namespace oversketch_studio
