#include "viewport.h"

#include "camera_state.h"
#include "latency.h"
#include "tools.h"
#include "touch_hand.h"

#include "vtkOversketchInteractorStyle.h"
#include "vtkOversketchStrokeRepresentation.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <QKeyEvent>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <chrono>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

// The paper's colour of a silhouette section.
constexpr double sectionColour[3] = { 0.16, 0.42, 0.95 };
constexpr float sectionWidth = 3.0F; // px as Qt counts them, of the section

} // namespace

Viewport::Viewport(QWidget* parent)
  : FrameView(parent)
  , Await(new QTimer(this))
  , Clock(
      []
      {
        const std::chrono::duration<double, std::milli> now =
          std::chrono::steady_clock::now().time_since_epoch();
        return now.count();
      })
{
  this->makeScene();
  this->interactor()->SetInteractorStyle(this->Style);
  this->Style->SetDefaultRenderer(this->Renderer);
  this->Style->AddObserver(vtkCommand::StartInteractionEvent, this, &Viewport::moveBegins);
  // A size may have come during a drag.
  this->Style->AddObserver(vtkCommand::EndInteractionEvent, this, &Viewport::fitCamera);
  this->Style->AddObserver(vtkCommand::ModifiedEvent, this, &Viewport::keysShown);
  this->Await->setSingleShot(true);
  connect(this->Await,
    &QTimer::timeout,
    this,
    [this]
    {
      if (this->RenderWaits)
      {
        this->renderNow();
      }
    });
  new TouchHand(this,
    { [this] { return this->CurrentTool && this->CurrentTool->isBusy(); },
      [this](double factor, const QPointF& at) { this->zoomAt(factor, at); },
      [this](double pressure)
      {
        if (this->CurrentTool)
        {
          this->CurrentTool->setPressure(pressure);
        }
      } });
  this->setFocusPolicy(Qt::StrongFocus);
  this->setAccessibleName(tr("Model"));
  this->fitScreen();
  this->setDark(true);
}

void Viewport::makeScene()
{
  // Drawn over the surface that it lies on.
  this->Section->SetMapper(this->SectionMapper);
  this->SectionMapper->ScalarVisibilityOff();
  this->SectionMapper->SetResolveCoincidentTopologyToPolygonOffset();
  this->SectionMapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -60000.0);
  this->Section->GetProperty()->SetColor(sectionColour[0], sectionColour[1], sectionColour[2]);
  this->Section->GetProperty()->LightingOff();
  this->Section->PickableOff();
  this->Section->VisibilityOff();
  this->Renderer->AddActor(this->Section);

  this->Renderer->AddActor(this->Region.actor());

  this->Masked.addTo(this->Renderer);
  this->Mirror.addTo(this->Renderer);
  this->HintBox.addTo(this->Renderer);
}

Viewport::~Viewport()
{
  this->Style->RemoveAllObservers();
  // Tools hold parts of the window, which goes first.
  for (Tool* tool : this->findChildren<Tool*>(QString(), Qt::FindDirectChildrenOnly))
  {
    delete tool;
  }
}

void Viewport::moveBegins()
{
  this->CameraSteps = this->Style->GetState() == VTKIS_NONE; // no drag
  this->hideHint();
  emit this->cameraMoves();
}

void Viewport::setTool(Tool* tool)
{
  if (this->CurrentTool)
  {
    this->CurrentTool->stop();
  }
  this->CurrentTool = tool;
  tool->start();
  this->Style->SetKeyList(keyList(*tool, this->findChildren<Tool*>().toVector()).toUtf8().constData());
}

void Viewport::fitAll()
{
  this->fitCamera();
  emit this->cameraMoves();
  this->Looks.fitAll(this->Fitted.data());
  this->renderSoon();
}

void Viewport::setUpAxis(int axis, bool looksAnew)
{
  this->Style->SetUpAxis(axis);
  if (looksAnew || !this->mesh()) // nothing is lost where there is nothing to be seen
  {
    this->lookAnew();
    this->Renderer->ResetCameraClippingRange();
    this->renderSoon();
  }
}

// From the front, at all of the mesh.
void Viewport::lookAnew()
{
  const double unit[6] = { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 };
  this->fitCamera();
  this->Looks.lookAtAll(
    this->mesh() ? this->mesh()->GetBounds() : unit, this->Fitted.data(), this->Style->GetUpAxis());
  this->Style->SaveFirstView();
}

void Viewport::setHandCursor(Qt::CursorShape shape)
{
  this->setDefaultCursor(shape);
  this->setCursor(this->defaultCursor());
}

void Viewport::zoomAt(double factor, const QPointF& at)
{
  const double ratio = this->devicePixelRatioF();
  this->Style->ZoomAt(factor, ratio * at.x(), ratio * (this->height() - at.y()) - 1.0);
}

void Viewport::resizeGL(int width, int height)
{
  FrameView::resizeGL(width, height);
  this->interactor()->InvokeEvent(vtkCommand::ConfigureEvent); // Qt's came before the window had its size
  this->fitCamera();
  this->fitScreen();
}

// A thing that the hand holds does not jump under it; and a view that is next to nothing tells no proportion.
void Viewport::fitCamera()
{
  constexpr int least = 16; // px
  const int* size = this->Renderer->GetSize();
  const bool isHeld = this->CurrentTool && this->CurrentTool->isBusy();
  const bool isOther = size[0] != this->Fitted[0] || size[1] != this->Fitted[1];
  if (isOther && !isHeld && std::min(size[0], size[1]) >= least &&
      this->Style->FollowSize(this->Fitted.data(), size))
  {
    this->Fitted = { size[0], size[1] };
  }
}

// VTK counts the screen's own pixels.
void Viewport::fitScreen()
{
  const double ratio = this->devicePixelRatioF();
  this->Section->GetProperty()->SetLineWidth(static_cast<float>(sectionWidth * ratio));
  for (Tool* tool : this->findChildren<Tool*>())
  {
    tool->setPixelRatio(ratio);
  }
  this->placeHint();
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
  {
    emit this->returned();
  }
  FrameView::keyPressEvent(event);
}

bool Viewport::event(QEvent* event)
{
  // VTK hears of the mouse before the functions for its events do.
  const auto type = event->type();
  if (this->Gestures.holds(event) || this->Gestures.smooths(event))
  {
    return true;
  }
  if (type == QEvent::Wheel && this->CurrentTool)
  {
    auto* wheel = static_cast<QWheelEvent*>(event);
    // Some systems turn the wheel sideways while Shift is held.
    const QPoint turned = wheel->angleDelta();
    const double notches =
      (turned.y() != 0 ? turned.y() : turned.x()) / double(QWheelEvent::DefaultDeltasPerStep);
    if (notches != 0.0 && this->CurrentTool->wheel(notches, wheel->modifiers(), wheel->timestamp()))
    {
      wheel->accept();
      return true;
    }
  }
  const bool press = type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick;
  if (type == QEvent::MouseMove || type == QEvent::MouseButtonRelease)
  {
    Latency::of().hand();
  }
  const bool release = type == QEvent::MouseButtonRelease && this->CurrentTool && this->CurrentTool->draws();
  if (press || type == QEvent::Wheel || type == QEvent::KeyPress)
  {
    this->awaitNoMore();
  }
  if (press || release)
  {
    // The pen draws over what is on screen; the line's end is seen before all that a stroke's end brings.
    this->CameraSteps = false;
    if (this->RenderWaits || this->IsCoarse)
    {
      this->render();
    }
    if (this->PaintWaits)
    {
      this->paintNow();
    }
  }
  if (type == QEvent::MouseButtonRelease && this->IsCoarse)
  {
    this->renderSoon();
  }
  return this->Gestures.moves(event) || FrameView::event(event);
}

void Viewport::showMesh(vtkPolyData* mesh, bool reset)
{
  this->Model.show(mesh);
  this->Masked.show(this->Model.seen());
  this->Behind.setMesh(mesh);
  if (reset)
  {
    this->lookAnew();
    // Room for what is drawn beside the model.
    this->Renderer->SetSSAORadius(0.1 * mesh->GetLength());
    this->Renderer->SetSSAOBias(0.002 * mesh->GetLength());
  }
  this->Renderer->ResetCameraClippingRange();
  if (this->isValid())
  {
    this->Renderer->SetUseSSAO(!this->onProcessor());
    this->Window->SetMultiSamples(this->onProcessor() ? 0 : edgeSamples);
  }
  this->placeHint();
  emit this->meshShown();
  this->awaitNoMore();
  this->renderSoon();
}

void Viewport::showPreview(vtkPolyData* mesh)
{
  this->Model.preview(mesh);
  this->Masked.show(this->Model.seen());
}

void Viewport::clearMesh()
{
  this->Model.clear();
  this->Masked.show(nullptr);
  this->HintBox.setText({});
  this->showSection(nullptr);
  this->showRegion(nullptr);
  emit this->meshShown();
  this->renderSoon();
}

void Viewport::showInstead(vtkPolyData* mesh, bool coloured)
{
  this->Looks.showInstead(mesh, coloured);
  this->Section->GetProperty()->SetOpacity(mesh ? 0.0 : 1.0); // they are of the model
  this->Region.actor()->GetProperty()->SetOpacity(mesh ? 0.0 : 1.0);
  this->Masked.setVisible(!mesh);
  this->renderSoon();
}

void Viewport::hideParts(const std::set<int>& parts)
{
  this->Model.hide(parts);
  this->Masked.show(this->Model.seen());
  this->renderSoon();
}

void Viewport::showPictures(const Pictures& pictures)
{
  this->Behind.set(pictures, this->Renderer);
  this->renderSoon();
}

Lines Viewport::frameFor(int width, int height)
{
  vtkNew<vtkOversketchStrokeRepresentation> reader;
  reader->SetRenderer(this->Renderer);
  vtkNew<vtkPolyData> frame;
  reader->PutView(frame);
  const int* size = this->Renderer->GetSize();
  const double scale = std::min(double(size[0]) / width, double(size[1]) / height);
  const double half[2] = { 0.5 * scale * width, 0.5 * scale * height };
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  corners->InsertNextPoint(0.5 * size[0] - half[0], 0.5 * size[1] - half[1], 0.0);
  corners->InsertNextPoint(0.5 * size[0] + half[0], 0.5 * size[1] + half[1], 0.0);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1 });
  frame->SetPoints(corners);
  frame->SetLines(line);
  frame->GetPointData()->Initialize();
  return Lines(frame);
}

void Viewport::showSection(vtkPolyData* section)
{
  this->SectionMapper->SetInputData(section);
  this->Section->SetVisibility(section != nullptr);
  this->renderSoon();
}

void Viewport::showMirror(const std::optional<MirrorPlane>& plane)
{
  this->Mirror.show(plane, this->mesh());
  this->renderSoon();
}

void Viewport::showHint(const QString& text, HintShape shape)
{
  this->HintBox.setText(text.toStdString(), shape);
  this->placeHint();
  this->renderSoon();
}

void Viewport::placeHint()
{
  if (vtkPolyData* mesh = this->mesh())
  {
    this->HintBox.place(this->Renderer, mesh, this->devicePixelRatioF(), this->overlays());
  }
}

std::vector<Hint::Box> Viewport::overlays() const
{
  std::vector<Hint::Box> boxes;
  const double ratio = this->devicePixelRatioF();
  for (const QWidget* one : this->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
  {
    if (!one->isHidden())
    {
      const QRect at = one->geometry();
      boxes.push_back({ ratio * at.left(),
        ratio * (at.right() + 1),
        ratio * (this->height() - at.bottom() - 1),
        ratio * (this->height() - at.top()) });
    }
  }
  return boxes;
}

void Viewport::setDark(bool dark)
{
  this->setGround(dark);
  dark ? this->Looks.setPlain({ 0.78, 0.76, 0.73 }) : this->Looks.setPlain({ 0.90, 0.88, 0.85 });
  this->Looks.setDark(dark);
  this->Mirror.setDark(dark);
  this->HintBox.setDark(dark);
  this->renderSoon();
}

void Viewport::showRegion(vtkPolyData* region)
{
  const bool wasShown = this->Region.isShown();
  this->Region.show(region);
  if (wasShown || this->Region.isShown()) // no frame for nothing
  {
    this->renderSoon();
  }
}

void Viewport::lookFrom(vtkPolyData* stroke)
{
  this->Style->LookFrom(stroke);
  this->render();
}

void Viewport::showKeys(bool show)
{
  this->Style->SetShowKeys(show);
  this->HintBox.setVisible(false); // it would be under the list
  this->render();
}

bool Viewport::showsKeys() const
{
  return this->Style->GetShowKeys();
}

Look lookOf(Viewport& view)
{
  Look look = oversketch_session::lookOf(view.renderer()->GetActiveCamera());
  look.size = view.fittedSize();
  look.upAxis = view.camera()->GetUpAxis();
  return look;
}

void lookAs(const Look& look, Viewport& view)
{
  vtkCamera* camera = view.renderer()->GetActiveCamera();
  oversketch_session::lookAs(look, camera);
  if (look.size)
  {
    oversketch::CameraState state(camera);
    state.fit(look.size->data(), view.fittedSize().data());
    state.putInto(camera);
  }
  view.renderer()->ResetCameraClippingRange();
  view.renderSoon();
}

} // namespace oversketch_studio
