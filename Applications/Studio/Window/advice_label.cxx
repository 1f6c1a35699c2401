#include "advice_label.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStyle>
#include <QToolTip>

#include <algorithm>

namespace oversketch_studio
{

namespace
{

constexpr double smallest = 0.85; // of the window's letters

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
  for (double size = whole; !this->fits(this->text(), font) && size > smallest * whole;)
  {
    size = std::max(size - 0.5, smallest * whole);
    font.setPointSizeF(size);
  }
  return font;
}

QString AdviceLabel::shown() const
{
  const QFont font = this->fitting();
  QString text = this->text();
  if (this->fits(text, font))
  {
    return text;
  }
  int most = 0; // words, each with the space before it
  for (int end = text.indexOf(' '); end >= 0 && this->fits(text.left(end) + QChar(0x2026), font);
       end = text.indexOf(' ', end + 1))
  {
    most = end;
  }
  return text.left(most) + QChar(0x2026);
}

bool AdviceLabel::event(QEvent* event)
{
  if (event->type() != QEvent::ToolTip)
  {
    return QLabel::event(event);
  }
  // The whole, where it is not seen; names of files may look like markup.
  const QString whole =
    this->shown() == this->text() ? QString() : "<p>" + this->text().toHtmlEscaped() + "</p>";
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), whole, this);
  return true;
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
    this->shown(),
    this->foregroundRole());
}

bool AdviceLabel::fits(const QString& text, const QFont& font) const
{
  return QFontMetrics(font).boundingRect(this->room(QWIDGETSIZE_MAX), Qt::TextWordWrap, text).height() <=
         this->height();
}

QRect AdviceLabel::room(int height) const
{
  return { this->indent(), 0, std::max(0, this->width() - this->indent()), height };
}

} // namespace oversketch_studio
