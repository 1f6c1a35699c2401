#include "advice_label.h"

#include <QPainter>
#include <QStyle>

#include <algorithm>

namespace oversketch_studio
{

namespace
{

constexpr double smallest = 0.6; // of the window's letters

} // namespace

AdviceLabel::AdviceLabel(QWidget* parent)
  : QLabel(parent)
{
  this->setObjectName("advice");
  this->setIndent(6);
  this->setTextFormat(Qt::PlainText);                                // names of files may look like markup
  this->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // no text widens the window
  this->setFixedHeight(2 * this->fontMetrics().lineSpacing());
}

QFont AdviceLabel::fitting() const
{
  QFont font = this->font();
  const double whole = font.pointSizeF();
  const auto isWhole = [&]
  {
    return QFontMetrics(font)
             .boundingRect(this->room(QWIDGETSIZE_MAX), Qt::TextWordWrap, this->text())
             .height() <= this->height();
  };
  for (double size = whole; size > smallest * whole && !isWhole(); size -= 0.5)
  {
    font.setPointSizeF(size);
  }
  return font;
}

// A label that wraps by itself asks its window for more height than it needs.
void AdviceLabel::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setFont(this->fitting());
  this->style()->drawItemText(&painter,
    this->room(this->height()),
    Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
    this->palette(),
    this->isEnabled(),
    this->text(),
    this->foregroundRole());
}

QRect AdviceLabel::room(int height) const
{
  return { this->indent(), 0, std::max(0, this->width() - this->indent()), height };
}

} // namespace oversketch_studio
