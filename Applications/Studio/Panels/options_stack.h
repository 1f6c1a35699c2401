// The tools' options, of which one tool's are seen, in as many lines as the window's width asks for.
#ifndef oversketch_applications_studio_panels_options_stack_h
#define oversketch_applications_studio_panels_options_stack_h

#include <QStackedWidget>

namespace oversketch_studio
{

class OptionsStack : public QStackedWidget
{
  Q_OBJECT

public:
  explicit OptionsStack(QWidget* parent = nullptr);
  // The sizes of the page that is seen alone.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  // The height of the highest page in one line: the view beside the bar, and what is drawn in it, stays as
  // large when another tool is taken.
  int lineHeight() const;
  void fit();
};

} // namespace oversketch_studio
#endif
