#include "advice_label.h"

#include <QPainter>
#include <QStyle>

#include <algorithm>

namespace oversketch_studio
{

namespace
{

constexpr int narrowest = 100; // px; before it has its place

} // namespace

AdviceLabel::AdviceLabel(QWidget* parent)
  : QLabel(parent)
{
  this->setObjectName("advice");
  this->setIndent(6);
  this->setTextFormat(Qt::PlainText);                                // names of files may look like markup
  this->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // no text widens the window
}

void AdviceLabel::setText(const QString& text)
{
  if (text != this->text())
  {
    QLabel::setText(text);
    this->fit();
  }
}

void AdviceLabel::resizeEvent(QResizeEvent* event)
{
  QLabel::resizeEvent(event);
  this->fit();
}

// A label that wraps asks its window for more height than it needs.
void AdviceLabel::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
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

void AdviceLabel::fit()
{
  const auto high = [this](const QString& text)
  { return this->fontMetrics().boundingRect(this->room(QWIDGETSIZE_MAX), Qt::TextWordWrap, text).height(); };
  const int usual = high("x\nx"); // two lines are less than twice as high as one
  this->setMinimumHeight(this->width() < narrowest ? usual : std::max(usual, high(this->text())));
}

} // namespace oversketch_studio
