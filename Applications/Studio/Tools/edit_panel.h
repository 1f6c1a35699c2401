// A second view of an edit, for a dock: a flat picture that the hand changes as it changes the model. It
// takes no keys: they are the canvas's, also while the dock floats.
#ifndef oversketch_applications_studio_tools_edit_panel_h
#define oversketch_applications_studio_tools_edit_panel_h

#include <QPointer>
#include <QWidget>

#include <functional>

class QHBoxLayout;
class vtkRenderer;

namespace oversketch_studio
{

class FrameView;

constexpr int panelSide = 240; // px, of a panel that opens

class EditPanel : public QWidget
{
  Q_OBJECT

public:
  // The name is that of the picture, for whoever looks for it.
  EditPanel(QWidget* canvas, const QString& title, const QString& name, QWidget* parent);
  ~EditPanel() override;

  // Its window has an interactor.
  QSize sizeHint() const override { return { panelSide, panelSide }; }
  vtkRenderer* renderer();
  void setDark(bool dark);
  // Under the picture.
  void addControl(QWidget* control);

  // The camera is to show all, in a picture of another size; whether keys belong to what is drawn here now.
  std::function<void()> fit;
  std::function<bool()> wantsKeys;

protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QPointer<QWidget> Canvas; // it may go first
  FrameView* Picture;
  QHBoxLayout* Controls;
};

} // namespace oversketch_studio
#endif
