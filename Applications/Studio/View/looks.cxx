#include "looks.h"

#include <QProxyStyle>
#include <QStyleFactory>

namespace oversketch_studio
{

namespace
{

class PlainStyle : public QProxyStyle
{
public:
  PlainStyle()
    : QProxyStyle(QStyleFactory::create("Fusion"))
  {
  }
  int styleHint(StyleHint hint,
    const QStyleOption* option,
    const QWidget* widget,
    QStyleHintReturn* answer) const override
  {
    return hint == SH_EtchDisabledText ? 0 : QProxyStyle::styleHint(hint, option, widget, answer);
  }
};

} // namespace

QStyle* plainStyle()
{
  return new PlainStyle;
}

QPalette darkPalette()
{
  QPalette palette;
  const QColor window(45, 48, 52), base(35, 37, 40), text(225, 226, 228), dim(130, 133, 138);
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, window);
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::Button, window);
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::Highlight, QColor(64, 120, 200));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(110, 170, 250));
  for (const QPalette::ColorRole role : { QPalette::WindowText, QPalette::Text, QPalette::ButtonText })
  {
    palette.setColor(QPalette::Disabled, role, dim);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(70, 74, 80));
  return palette;
}

} // namespace oversketch_studio
