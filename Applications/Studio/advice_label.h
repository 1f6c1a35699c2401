// What to do next, at the foot of the window: in as many lines as it needs, at least two, so that the view
// seldom changes its size with it.
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
  void setText(const QString& text);

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  QRect room(int height) const;
  void fit();
};

} // namespace oversketch_studio
#endif
