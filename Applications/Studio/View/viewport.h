// The model in a Qt widget: window, light, camera, frames. What the left button does is a tool's.
#ifndef oversketch_applications_studio_view_viewport_h
#define oversketch_applications_studio_view_viewport_h

#include "backdrop.h"
#include "display.h"
#include "frame_view.h"
#include "hand_gestures.h"
#include "hint.h"
#include "look.h"
#include "mask_sheet.h"
#include "mirror_sheet.h"
#include "model_view.h"
#include "moved_region.h"
#include "session.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <vector>

class QTimer;
class vtkActor;
class vtkImageData;
class vtkOversketchInteractorStyle;
class vtkPolyData;
class vtkPolyDataMapper;

namespace oversketch_studio
{

class Tool;

class Viewport : public FrameView
{
  Q_OBJECT

public:
  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  // Takes a tool up, instead of the last.
  void setTool(Tool* tool);
  Tool* tool() const { return this->CurrentTool; }

  // Shows a mesh instead of the last; with `reset` the camera looks at all of it from the front.
  void showMesh(vtkPolyData* mesh, bool reset);
  // Shows none.
  void clearMesh();
  // The mesh as a tool shows it meanwhile, with the same skin.
  void showPreview(vtkPolyData* mesh);
  // Null where none is shown.
  vtkPolyData* mesh() const { return this->Model.mesh(); }
  // Parts of the mesh that are not drawn (ModelView::hide).
  void hideParts(const std::set<int>& parts);
  // A mesh is being made: frames that are asked for wait for it, unless it takes long or the hand does
  // something.
  void awaitMesh();
  // Another mesh instead of it, to compare; null shows it again. `coloured`: in its colours in any case.
  void showInstead(vtkPolyData* mesh, bool coloured = false);
  // Where a step took hold (blue); null shows none.
  void showSection(vtkPolyData* section);
  // The part of the model that a step moved (orange); null shows none.
  void showRegion(vtkPolyData* region);
  void showMirror(const std::optional<oversketch_session::MirrorPlane>& plane);
  // The pictures behind the model, each in the view that it was put there in.
  void showPictures(const oversketch_session::Pictures& pictures);
  // Where a picture of that size [px] fills the present view.
  oversketch_session::Lines frameFor(int width, int height);
  // Where to draw, with a line of text; empty shows none.
  void showHint(const QString& text, HintShape shape = HintShape::Limb);
  // The one that is seen; empty where none is.
  QString hint() const
  {
    return this->HintBox.isVisible() ? QString::fromStdString(this->HintBox.text()) : QString();
  }
  const Hint& hintBox() const { return this->HintBox; }
  void hideHint() { this->HintBox.setVisible(false); }
  void setDark(bool dark);
  // The camera that a stroke was drawn in, or a picture was put into the scene in.
  void lookFrom(vtkPolyData* stroke);
  // The camera goes so far off, or so near, that all is seen.
  void fitAll();
  // The world's axis that is up: 1 for y, 2 for z; it is looked at from the front, or as it was.
  void setUpAxis(int axis, bool looksAnew);
  void showKeys(bool show);
  bool showsKeys() const;
  // Writes what the window shows; without overlays only the model. Throws Failed.
  void screenshot(const QString& path, bool overlays);
  // Writes a film (oversketch_files::writeFilm), without lines, while the eye goes round the middle of all
  // that is shown once, about the axis that is up, counter-clockwise seen from above; its first frame is the
  // present view. `goesOn` is asked before each frame, of the share that is done; returns false where it says
  // no, and nothing is written. Throws Failed.
  bool writeTurn(const QString& path, int frames, const std::function<bool(double)>& goesOn);

  // The part of the model that is masked, dark.
  const MaskSheet& masked() const { return this->Masked; }

  // For tools.
  Display& display() { return this->Looks; }
  vtkOversketchInteractorStyle* camera() { return this->Style; }
  // The size of the view that the camera is for [px of the screen]: what was whole in view stays whole when
  // it becomes narrower than high (vtkOversketchInteractorStyle::FollowSize). It changes once the hand rests.
  const std::array<int, 2>& fittedSize() const { return this->Fitted; }
  void zoomAt(double factor, const QPointF& at); // a place of the widget
  void setHandCursor(Qt::CursorShape shape);
  void renderNow() override;
  // The clock that frames are timed with [ms].
  void setClock(const std::function<double()>& clock) { this->Clock = clock; }
  // The widgets that are seen over the view, the strip at its upper left corner, the axes, in the screen's
  // pixels.
  std::vector<Hint::Box> overlays() const;

signals:
  // Key Return; the camera is about to be moved.
  void returned();
  void cameraMoves();
  // Another mesh is shown, or none; the list of keys is, or no more.
  void meshShown();
  void keysShown();
  // Lines over the model are to be shown, or not, for a picture.
  void linesShown(bool show);

protected:
  bool isHeld() const override;
  bool awaits() const override;
  void renderSmooth() override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintGL() override;
  void resizeGL(int width, int height) override;

private:
  class Bare; // the view without lines, for a picture
  vtkSmartPointer<vtkImageData> grabbed();
  void makeScene();
  void moveBegins(); // of the camera
  void render();
  void drawFrame();
  bool handMoves() const; // the camera, or what a tool holds
  void paintNow();
  void awaitNoMore();
  void placeHint();
  void fitScreen();
  void lookAnew();
  void fitCamera();

  ModelView Model{ this->Renderer };
  Display Looks{ this->Renderer, this->Model };
  HandGestures Gestures{ this };
  vtkNew<vtkPolyDataMapper> SectionMapper;
  vtkNew<vtkActor> Section;
  oversketch::MovedRegion Region;
  MirrorSheet Mirror;
  MaskSheet Masked;
  Backdrop Behind;
  Hint HintBox;
  vtkNew<vtkOversketchInteractorStyle> Style;
  Tool* CurrentTool = nullptr;
  std::array<int, 2> Fitted{ 1, 1 };
  QTimer* Await; // runs while a mesh is awaited
  bool PaintWaits = false;
  std::function<double()> Clock;
  double WholeFrame = 0.0;  // ms, of the last frame of the whole model
  vtkMTimeType Drawn = 0;   // the mesh in it
  bool CameraSteps = false; // a wheel or a key moves it, until it rests
  bool IsCoarse = false;    // the last frame is
};

// The view's camera as a session keeps it.
oversketch_session::Look lookOf(Viewport& view);
void lookAs(const oversketch_session::Look& look, Viewport& view);

} // namespace oversketch_studio
#endif
