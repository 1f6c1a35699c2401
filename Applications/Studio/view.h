// The model, the pen and the camera in a Qt widget.
#ifndef oversketch_studio_view_h
#define oversketch_studio_view_h

#include "session.h"
#include "skin.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <QVTKOpenGLNativeWidget.h>

#include <optional>

class vtkActor;
class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;
class vtkLightKit;
class vtkOversketchInteractorStyle;
class vtkOversketchStrokeWidget;
class vtkPlaneSource;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;
class vtkTextActor;

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
  // Where a stroke took hold (blue); null shows none.
  void showSection(vtkPolyData* section);
  void showMirror(const std::optional<oversketch_session::MirrorPlane>& plane);
  // A line at the top of the model that says where to draw; empty shows none.
  void showHint(const QString& text);
  void setDark(bool dark);
  // Pen or camera: whose the left button is.
  void setDrawing(bool drawing);
  bool isDrawing() const { return this->drawing_; }
  // How far the line trails behind the pen [px as Qt counts them].
  void setStabilizer(double pixels);
  // Takes the line of the last stroke away.
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
  void quitAsked();

protected:
  void mousePressEvent(QMouseEvent* event) override;
  void paintGL() override;
  void resizeGL(int width, int height) override;
  void tabletEvent(QTabletEvent* event) override;

private:
  void render();
  void renderSoon();
  void placeHint();
  void fitScreen();

  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkLightKit> lights_;
  vtkNew<vtkPolyDataMapper> meshMapper_, sectionMapper_, mirrorMapper_;
  vtkNew<vtkActor> mesh_, section_, mirror_;
  Skin skin_; // of the mesh
  vtkNew<vtkPlaneSource> mirrorPlane_;
  vtkNew<vtkTextActor> hint_;
  vtkNew<vtkOversketchInteractorStyle> style_;
  vtkNew<vtkOversketchStrokeWidget> pen_;
  vtkNew<vtkCallbackCommand> ear_;
  double stabilizer_ = 6.0;
  bool drawing_ = true;
  bool occlusionAsked_ = false;
  bool renderWaits_ = false;
};

} // namespace oversketch_studio
#endif
