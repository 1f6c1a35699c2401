// The model, the pen and the camera in a Qt widget.
#ifndef oversketch_studio_view_h
#define oversketch_studio_view_h

#include "evaluator.h"
#include "hint.h"
#include "pen_section.h"
#include "preview.h"
#include "session.h"
#include "skin.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <QVTKOpenGLNativeWidget.h>

#include <memory>
#include <optional>

class QTimer;
class vtkActor;
class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;
class vtkLightKit;
class vtkOversketchInteractorStyle;
class vtkOversketchHeldStrokeWidget;
class vtkOversketchStrokeWidget;
class vtkPlaneSource;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkPolyDataNormals;
class vtkRenderer;

namespace oversketch_studio
{

class View : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  explicit View(QWidget* parent = nullptr);
  ~View() override;

  // Shows a mesh instead of the last; with `reset` the camera looks at all of it from the front.
  void showMesh(vtkPolyData* mesh, bool reset);
  // A mesh is being made: frames that are asked for wait for it, unless it takes long or the hand does
  // something.
  void awaitMesh();
  // Where a stroke took hold (blue); null shows none.
  void showSection(vtkPolyData* section);
  // The part of the model that a stroke moved (orange); null shows none.
  void showRegion(vtkPolyData* region);
  // The stroke that can be taken hold of, a place in the plane that it stands in, and how the mesh that is
  // shown follows it (null: the line goes alone); a null stroke offers none. Return in the view ends the
  // offer, so that the next stroke can begin on it.
  void offerStroke(vtkPolyData* stroke,
    const oversketch_session::Point& place,
    const std::shared_ptr<const oversketch_session::Following>& following);
  // How it follows, where that is known only now.
  void setFollowing(const std::shared_ptr<const oversketch_session::Following>& following);
  void showMirror(const std::optional<oversketch_session::MirrorPlane>& plane);
  // Where to draw, with a line of text; empty shows none.
  void showHint(const QString& text);
  void setDark(bool dark);
  // Pen or camera: whose the left button is.
  void setDrawing(bool drawing);
  bool isDrawing() const { return this->drawing_; }
  // How far the line trails behind the pen [px as Qt counts them].
  void setStabilizer(double pixels);
  // Takes the line of the last stroke away; it is offered no more.
  void clearStroke();
  // The camera that a stroke was drawn in.
  void lookFrom(vtkPolyData* stroke);
  void showKeys(bool show);
  bool showsKeys() const;
  // Writes what the window shows; without overlays only the model. Throws Failed.
  void screenshot(const QString& path, bool overlays);
  vtkOversketchInteractorStyle* camera() { return this->style_; }

signals:
  void strokeDrawn(vtkPolyData* stroke);
  // The stroke that was offered has been moved or drawn anew in part.
  void strokeChanged(vtkPolyData* stroke);
  // The hand moves a stroke that the mesh cannot follow before it is let go; it lets go.
  void lineMovesAlone();
  void lineLeft();
  void quitAsked();

protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintGL() override;
  void resizeGL(int width, int height) override;
  void tabletEvent(QTabletEvent* event) override;

private:
  void render();
  void renderSoon();
  void renderNow();
  void paintNow();
  void awaitNoMore();
  void placeHint();
  void fitScreen();
  void followHand();
  void letGo();
  vtkOversketchStrokeWidget* pen() const;

  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkLightKit> lights_;
  vtkNew<vtkPolyDataMapper> meshMapper_, sectionMapper_, regionMapper_, mirrorMapper_;
  vtkNew<vtkActor> mesh_, section_, region_, mirror_;
  vtkNew<vtkPolyDataNormals> regionNormals_;
  Skin skin_; // of the mesh
  vtkNew<vtkPlaneSource> mirrorPlane_;
  Hint hint_;
  vtkNew<vtkOversketchInteractorStyle> style_;
  vtkNew<vtkOversketchHeldStrokeWidget> widget_; // shows and moves strokes; the document runs them
  PenSection penSection_;
  std::shared_ptr<const oversketch_session::Following> following_;
  std::unique_ptr<Preview> preview_; // while a stroke is moved
  vtkNew<vtkCallbackCommand> ear_;
  double stabilizer_ = 6.0;
  bool drawing_ = true;
  bool occlusionAsked_ = false;
  QTimer* await_; // runs while a mesh is awaited
  bool renderWaits_ = false, paintWaits_ = false;
};

} // namespace oversketch_studio
#endif
