// The list of what is in the scene: the model, and the pictures behind it.
#ifndef oversketch_studio_scene_panel_h
#define oversketch_studio_scene_panel_h

#include <QWidget>

class QListWidget;
class QSlider;
class QToolButton;

namespace oversketch_studio
{

class Document;

class ScenePanel : public QWidget
{
  Q_OBJECT

public:
  ScenePanel(Document* document, QWidget* parent = nullptr);

  // Brings it up to what the document is.
  void refresh();

signals:
  void addAsked();
  // The camera is to go where the picture is seen.
  void viewAsked(int picture);

private:
  // The selected picture, or -1.
  int current() const;
  void showPicture();
  void setShown(int picture, bool shown);

  Document* OpenDocument;
  QListWidget* List;
  QSlider* Opacity;
  QToolButton *Add, *View, *Remove;
  bool Filling = false;
};

} // namespace oversketch_studio
#endif
