// The strip at the view's upper left corner: perspective, shading, what is switched on and off. All of it is
// in the View menu as well.
#ifndef oversketch_applications_studio_panels_view_bar_h
#define oversketch_applications_studio_panels_view_bar_h

#include <QList>
#include <QWidget>

class QAction;
class QMenu;
class QToolButton;

namespace oversketch_studio
{

class ViewBar : public QWidget
{
  Q_OBJECT

public:
  ViewBar(QMenu* projections, QMenu* shadings, const QList<QAction*>& switches, QWidget* view);
  // Sets the texts of the buttons of the two menus.
  void setTexts(const QString& projection, const QString& shading);
  // In a view that has so much room for it: in one line, or as many as that takes.
  void fit(int width);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  QToolButton* add(QMenu* menu);

  QToolButton *Projection, *Shade;
  int Width = QWIDGETSIZE_MAX;
};

} // namespace oversketch_studio
#endif
