#include "step_list.h"

#include "row_delegate.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolTip>

#include <algorithm>
#include <utility>

namespace oversketch_studio
{

namespace
{

constexpr int border = 16; // px, where a drag scrolls the list

} // namespace

StepList::StepList(QWidget* parent)
  : QListWidget(parent)
{
  this->setItemDelegate(new RowDelegate(this));
  this->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  this->setResizeMode(QListView::Adjust);
  this->viewport()->setMouseTracking(true);
}

void StepList::arrange(int steps, int shown)
{
  if (std::exchange(this->Line, -1) >= 0) // may be gone
  {
    this->Slot = -1;
    this->hold(Held::Nothing);
  }
  this->Steps = steps;
  this->Shown = shown;
  this->First.assign(static_cast<std::size_t>(steps) + 1, this->count());
  for (int i = this->count() - 1; i >= 0; --i)
  {
    this->First[static_cast<std::size_t>(this->item(i)->data(RowDelegate::NodeRole).toInt())] = i;
  }
  for (int i = 0; i < this->count(); ++i)
  {
    const auto stepOf = [this](int row)
    { return row < this->count() ? this->item(row)->data(RowDelegate::NodeRole).toInt() : this->Steps; };
    const bool isLast = stepOf(i) < shown && stepOf(i + 1) >= shown;
    const RowDelegate::Gap gap = isLast                 ? RowDelegate::GapBelow
                                 : i == 0 && shown == 0 ? RowDelegate::GapAbove
                                                        : RowDelegate::NoGap;
    this->item(i)->setData(RowDelegate::GapRole, gap);
    this->item(i)->setData(
      RowDelegate::HiddenRole, stepOf(i) >= shown || this->item(i)->checkState() == Qt::Unchecked);
  }
  this->viewport()->update();
}

void StepList::scrollBack(int value, int come)
{
  this->doItemsLayout();
  this->verticalScrollBar()->setValue(value);
  if (QListWidgetItem* row = come >= 0 ? this->itemOf(come) : nullptr)
  {
    this->scrollToItem(row);
  }
}

// Without the room for the marker.
QRect StepList::rectOf(int step) const
{
  const auto at = static_cast<std::size_t>(step);
  const QRect whole = this->visualItemRect(this->item(this->First[at])) |
                      this->visualItemRect(this->item(this->First[at + 1] - 1));
  const int gap = RowDelegate::gapHeight(this->fontMetrics());
  const bool isAbove = step == 0 && this->Shown == 0, isBelow = step == this->Shown - 1;
  return whole.adjusted(0, isAbove ? gap : 0, 0, isBelow ? -gap : 0);
}

QRect StepList::markerRect() const
{
  if (this->Steps == 0)
  {
    return {};
  }
  const int gap = RowDelegate::gapHeight(this->fontMetrics());
  const int top = this->Shown > 0 ? this->rectOf(this->Shown - 1).bottom() + 1 : this->rectOf(0).top() - gap;
  return { 0, top, this->viewport()->width(), gap };
}

int StepList::places() const
{
  const auto at = static_cast<std::size_t>(this->Step);
  return this->Line < 0 ? this->Steps : this->First[at + 1] - this->First[at] - 1;
}

QRect StepList::placeRect(int place) const
{
  return this->Line < 0
           ? this->rectOf(place)
           : this->visualItemRect(this->item(this->First[static_cast<std::size_t>(this->Step)] + 1 + place)) &
               this->rectOf(this->Step);
}

int StepList::slotAt(int y) const
{
  int above = 0;
  while (above < this->places() && this->placeRect(above).center().y() < y)
  {
    ++above;
  }
  return above;
}

void StepList::hold(Held what)
{
  this->Hand = what;
  what == Held::Row      ? this->viewport()->setCursor(Qt::ClosedHandCursor)
  : what == Held::Marker ? this->viewport()->setCursor(Qt::SplitVCursor)
                         : this->viewport()->unsetCursor();
  this->viewport()->update();
}

void StepList::mousePressEvent(QMouseEvent* event)
{
  this->Press = event->pos();
  if (event->button() == Qt::LeftButton && this->markerRect().contains(event->pos()))
  {
    this->ShownBefore = this->Shown;
    this->Line = -1;
    this->hold(Held::Marker);
    return;
  }
  QListWidget::mousePressEvent(event);
  const QListWidgetItem* pressed = this->itemAt(event->pos());
  if (!pressed)
  {
    this->setCurrentRow(-1); // a click on the void
  }
  else if (event->button() == Qt::LeftButton)
  {
    this->Step = pressed->data(RowDelegate::NodeRole).toInt();
    this->Line = pressed->data(RowDelegate::LineRole).toInt();
    this->hold(Held::Pressed);
  }
}

void StepList::drag(const QPoint& at)
{
  QScrollBar* bar = this->verticalScrollBar();
  const int low = this->viewport()->height() - border;
  const bool up = border > at.y(), down = low < at.y();
  bar->setValue(bar->value() + (int(down) - int(up)) * border / 2);
  const int slot = this->slotAt(at.y());
  if (this->Hand == Held::Marker)
  {
    if (slot != this->Shown)
    {
      emit this->markerAsked(slot);
    }
    return;
  }
  const int to = slot > this->Step ? slot - 1 : slot;
  if (std::exchange(this->Slot, slot) != slot)
  {
    const bool can = this->Line >= 0 || to == this->Step || !this->MayMove || this->MayMove(this->Step, to);
    this->Slot = can ? slot : -1;
    this->viewport()->setCursor(can ? Qt::ClosedHandCursor : Qt::ForbiddenCursor);
    this->viewport()->update();
  }
}

void StepList::mouseMoveEvent(QMouseEvent* event)
{
  if (this->Hand == Held::Pressed)
  {
    const int far = (event->pos() - this->Press).manhattanLength();
    if (!(event->buttons() & Qt::LeftButton) || far < QApplication::startDragDistance())
    {
      return; // no row is selected by the way
    }
    this->Slot = -1;
    this->hold(Held::Row);
  }
  if (this->Hand != Held::Nothing)
  {
    this->drag(event->pos());
    return;
  }
  this->markerRect().contains(event->pos()) ? this->viewport()->setCursor(Qt::SplitVCursor)
                                            : this->viewport()->unsetCursor();
  QListWidget::mouseMoveEvent(event);
}

void StepList::mouseReleaseEvent(QMouseEvent* event)
{
  const Held held = this->Hand;
  const int from = this->Line < 0 ? this->Step : this->Line;
  const int to = this->Slot > from ? this->Slot - 1 : this->Slot;
  this->hold(Held::Nothing);
  if (held == Held::Nothing || held == Held::Pressed)
  {
    QListWidget::mouseReleaseEvent(event);
  }
  else if (held == Held::Row && this->Slot >= 0 && to != from)
  {
    this->Line < 0 ? emit this->moveAsked(from, to) : emit this->lineMoveAsked(this->Step, from, to);
  }
  this->Slot = -1;
}

// Takes a drag back.
void StepList::giveUp()
{
  const Held held = this->Hand;
  this->Slot = -1;
  this->hold(Held::Nothing);
  if (held == Held::Marker && this->ShownBefore != this->Shown)
  {
    emit this->markerAsked(this->ShownBefore);
  }
}

void StepList::keyPressEvent(QKeyEvent* event)
{
  if (event->key() != Qt::Key_Escape)
  {
    QListWidget::keyPressEvent(event);
  }
  else if (this->Hand == Held::Row || this->Hand == Held::Marker)
  {
    this->giveUp();
  }
  else
  {
    this->setCurrentRow(-1);
  }
}

// A list that has no current row takes its first one with the focus, which nobody chose.
void StepList::focusInEvent(QFocusEvent* event)
{
  const bool none = !this->currentItem();
  const QSignalBlocker quiet(this);
  QListWidget::focusInEvent(event);
  if (none)
  {
    this->setCurrentRow(-1);
  }
}

void StepList::paintEvent(QPaintEvent* event)
{
  QListWidget::paintEvent(event);
  QPainter painter(this->viewport());
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = this->palette().color(QPalette::Highlight);
  const QRect marker = this->markerRect();
  if (!marker.isEmpty())
  {
    // Quiet while all is shown.
    const bool isQuiet = this->Shown == this->Steps && this->Hand != Held::Marker;
    QColor ink = isQuiet ? this->palette().color(QPalette::Text) : accent;
    ink.setAlphaF(isQuiet ? 0.4 : 1.0);
    const QString text = tr("shown to here");
    const int y = marker.center().y(), half = this->fontMetrics().horizontalAdvance(text) / 2 + 8;
    const int middle = marker.center().x();
    painter.setPen(QPen(ink, isQuiet ? 1.0 : 2.0));
    painter.drawLine(marker.left() + 4, y, middle - half, y);
    painter.drawLine(middle + half, y, marker.right() - 4, y);
    painter.setPen(ink);
    painter.drawText(marker, Qt::AlignCenter, text);
  }
  if (this->Hand == Held::Row && this->Slot >= 0)
  {
    painter.setPen(QPen(this->palette().color(QPalette::Text), 3.0)); // also beside the selected row
    const int y = std::clamp(this->edgeOf(this->Slot), 2, this->viewport()->height() - 2);
    painter.drawLine(4, y, this->viewport()->width() - 4, y);
  }
}

bool StepList::viewportEvent(QEvent* event)
{
  if (event->type() == QEvent::ToolTip)
  {
    const auto* help = static_cast<QHelpEvent*>(event);
    if (this->markerRect().contains(help->pos()))
    {
      QToolTip::showText(help->globalPos(),
        tr("Drag it: the model is shown as of this place, and what is drawn then comes here."),
        this);
      return true;
    }
  }
  return QListWidget::viewportEvent(event);
}

} // namespace oversketch_studio
