#include "options_stack.h"

#include <QLayout>

#include <algorithm>

namespace oversketch_studio
{

OptionsStack::OptionsStack(QWidget* parent)
  : QStackedWidget(parent)
{
  // All of the bar that is left, whichever page is shown: the height of the next one is known before it is
  // laid out.
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  connect(this, &QStackedWidget::currentChanged, this, &OptionsStack::fit);
}

int OptionsStack::lineHeight() const
{
  int height = 0;
  for (int i = 0; i < this->count(); ++i)
  {
    height = std::max(height, this->widget(i)->sizeHint().height());
  }
  return height;
}

QSize OptionsStack::sizeHint() const
{
  return this->currentWidget() ? QSize(this->currentWidget()->sizeHint().width(), this->lineHeight())
                               : QSize(0, 0);
}

QSize OptionsStack::minimumSizeHint() const
{
  // One line high: how many there are is known with the width.
  const QWidget* shown = this->currentWidget();
  return shown ? QSize(shown->minimumSizeHint().width(), this->lineHeight()) : QSize(0, 0);
}

void OptionsStack::resizeEvent(QResizeEvent* event)
{
  QStackedWidget::resizeEvent(event);
  this->fit();
}

// A tool bar does not ask how high things are in the width that they have.
void OptionsStack::fit()
{
  constexpr int narrowest = 200; // px; before it has its place
  const QLayout* layout =
    this->currentWidget() && this->width() >= narrowest ? this->currentWidget()->layout() : nullptr;
  this->setMinimumHeight(layout && layout->hasHeightForWidth()
                           ? std::max(this->lineHeight(), layout->totalHeightForWidth(this->width()))
                           : this->lineHeight());
  this->updateGeometry();
}

} // namespace oversketch_studio
