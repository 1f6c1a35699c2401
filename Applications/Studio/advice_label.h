// What to do next, at the foot of the window: two lines high, so that the view keeps its size, in smaller
// letters where it needs more.
#ifndef oversketch_studio_advice_label_h
#define oversketch_studio_advice_label_h

#include <QLabel>

namespace oversketch_studio
{

class AdviceLabel : public QLabel
{
  Q_OBJECT

public:
  explicit AdviceLabel(QWidget* parent = nullptr);
  // The letters in which all of it is seen.
  QFont fitting() const;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  QRect room(int height) const;
};

} // namespace oversketch_studio
#endif
