// How the model is looked at, in a menu and in a strip over the view: camera, shading and
// light, ground, what it was.
#ifndef oversketch_applications_studio_window_view_menu_h
#define oversketch_applications_studio_window_view_menu_h

#include "model_view.h"

#include <QObject>
#include <QVector>

#include <functional>
#include <memory>

class QAction;
class QLabel;
class QMenu;

namespace oversketch_studio
{

class AxisGizmo;
class Document;
class ViewBar;
class Viewport;

// How a person likes to look at models, kept per user.
struct ViewSettings
{
  Shading shading = Shading::Smooth;
  Light light = Light::Three;
  bool parallel = false; // orthographic
  bool free = false;     // turns as a ball does; else upright
  bool ground = false;
  bool shadow = false;

  // Those that QSettings holds; what it cannot be counts as usual.
  static ViewSettings read();
  void write() const;
};

class ViewMenu : public QObject
{
  Q_OBJECT

public:
  // `node` says which step is meant: the selected one, else the last; -1: none.
  ViewMenu(Viewport* view, Document* document, std::function<int()> node, QWidget* parent);
  ~ViewMenu() override;

  void addTo(QMenu* menu);
  // How many triangles the model has, for the status bar.
  QLabel* triangles() const { return this->Triangles; }
  void setDark(bool dark);
  // Sets that of the model that is opened next.
  void setUpAxis(int axis);

signals:
  // Says what is shown instead of the model; empty: the model again.
  void told(const QString& text);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void makeCamera();
  void makeShadings();
  void makeLights();
  QAction* addToggle(const QString& text, const QString& key, const std::function<void(bool)>& run);
  void apply();
  void setTexts();
  void refresh();
  void placeOverlays();
  void showOnion();
  void showBefore(bool shown);

  Viewport* View;
  Document* Shown;
  std::function<int()> Node;
  ViewSettings Settings;
  std::unique_ptr<QMenu> Camera, Model;
  QVector<QAction*> Shadings, Lights; // in their order
  QAction *Parallel, *Free, *UpZ, *Picture, *Ground, *Shadow, *Onion, *Before;
  ViewBar* Bar;
  AxisGizmo* Gizmo;
  QLabel* Triangles;
};

} // namespace oversketch_studio
#endif
