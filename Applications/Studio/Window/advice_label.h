// A line on what to do next, at the foot of the window: two lines high, so that the view keeps its size.
// Where it needs more its letters are a little smaller, and where that is not enough it ends in three points
// and its tool tip has the whole.
#ifndef oversketch_applications_studio_window_advice_label_h
#define oversketch_applications_studio_window_advice_label_h

#include <QLabel>

namespace oversketch_studio
{

class AdviceLabel : public QLabel
{
  Q_OBJECT

public:
  explicit AdviceLabel(QWidget* parent = nullptr);
  // The letters in which it is seen, and what is seen of it.
  QFont fitting() const;
  QString shown() const;

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  QRect room(int height) const;
  bool fits(const QString& text, const QFont& font) const;
};

} // namespace oversketch_studio
#endif
