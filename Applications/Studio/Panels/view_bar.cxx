#include "view_bar.h"

#include "flow_layout.h"

#include <QAction>
#include <QMenu>
#include <QPainter>
#include <QToolButton>

#include <algorithm>

namespace oversketch_studio
{

ViewBar::ViewBar(QMenu* projections, QMenu* shadings, const QList<QAction*>& switches, QWidget* view)
  : QWidget(view)
{
  this->setObjectName("view_bar");
  this->setCursor(Qt::ArrowCursor);
  auto* row = new FlowLayout(this);
  row->setContentsMargins(3, 2, 3, 2);
  row->setSpacing(2);
  this->Projection = this->add(projections);
  this->Shade = this->add(shadings);
  for (QAction* one : switches)
  {
    this->add(nullptr)->setDefaultAction(one);
  }
  this->Projection->setToolTip(projections->title().remove('&'));
  this->Shade->setToolTip(shadings->title().remove('&'));
}

QToolButton* ViewBar::add(QMenu* menu)
{
  auto* button = new QToolButton(this);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::NoFocus); // keys stay the model's; the View menu has the same
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  if (menu)
  {
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
  }
  this->layout()->addWidget(button);
  return button;
}

void ViewBar::setTexts(const QString& projection, const QString& shading)
{
  this->Projection->setText(projection);
  this->Shade->setText(shading);
  this->fit(this->Width);
}

void ViewBar::fit(int width)
{
  this->Width = width;
  const int wide = std::min(this->layout()->sizeHint().width(), width);
  this->resize(wide, this->layout()->heightForWidth(wide));
}

void ViewBar::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = this->palette().color(QPalette::Window);
  ground.setAlpha(215);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(this->rect(), 4, 4);
}

} // namespace oversketch_studio
