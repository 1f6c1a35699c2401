// Keys are the view's wherever the focus is: after a choice in a box, x, y, z still turn the model.
#ifndef oversketch_applications_studio_view_view_keys_h
#define oversketch_applications_studio_view_view_keys_h

#include <QObject>

#include <functional>

class QKeyEvent;
class QWidget;

namespace oversketch_studio
{

// Letters, digits and signs that no text is written with go on to the view; so does Escape, but from lists.
// Other keys of a widget stay its own. Return and Escape in a number give the keys back.
// Shortcuts wait until the hand lets go: what it then makes is for what was there when it began.
class ViewKeys : public QObject
{
  Q_OBJECT

public:
  // Hears the widgets of the view's window; `isBusy` tells whether the hand holds something in it.
  ViewKeys(QWidget* view, std::function<bool()> isBusy);

signals:
  // Escape, before the view has it.
  void escaped();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool isForView(const QWidget* focus, const QKeyEvent& event) const;

  QWidget* View;
  std::function<bool()> IsBusy;
};

} // namespace oversketch_studio
#endif
