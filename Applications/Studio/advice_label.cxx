#include "advice_label.h"

#include <algorithm>

namespace oversketch_studio
{

AdviceLabel::AdviceLabel(QWidget* parent)
  : QLabel(parent)
{
  this->setObjectName("advice");
  this->setIndent(6);
  this->setWordWrap(true);
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

void AdviceLabel::fit()
{
  const int two = 2 * this->fontMetrics().lineSpacing();
  this->setMinimumHeight(std::max(two, this->heightForWidth(this->width())));
}

} // namespace oversketch_studio
