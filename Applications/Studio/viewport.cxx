#include "viewport.h"

#include "files.h"
#include "key_list.h"
#include "latency.h"
#include "tool.h"

#include "vtkOversketchInteractorStyle.h"
#include "vtkOversketchStrokeRepresentation.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkLightKit.h"
#include "vtkPNGWriter.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QTabletEvent>
#include <QTimer>

#include <algorithm>
#include <cstring>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

// The paper's colour of a silhouette section.
constexpr double sectionColour[3] = { 0.16, 0.42, 0.95 };
constexpr float sectionWidth = 3.0F; // px as Qt counts them, of the section
constexpr int awaitTime = 500;       // ms; what takes longer shows its progress

// Ambient occlusion would make a picture drawn by the processor wait.
bool drawsOnProcessor(vtkRenderWindow* window)
{
  const char* about = window->ReportCapabilities();
  return about && (std::strstr(about, "llvmpipe") || std::strstr(about, "softpipe"));
}

} // namespace

Viewport::Viewport(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
  , await_(new QTimer(this))
{
  this->setRenderWindow(this->window_);
  this->window_->AddRenderer(this->renderer_);
  this->window_->SetMultiSamples(4);
  this->makeScene();
  this->listen();
  this->await_->setSingleShot(true);
  connect(this->await_,
    &QTimer::timeout,
    this,
    [this]
    {
      if (this->renderWaits_)
      {
        this->renderNow();
      }
    });
  this->setFocusPolicy(Qt::StrongFocus);
  this->setAccessibleName(tr("Model"));
  this->fitScreen();
  this->setDark(true);
}

void Viewport::makeScene()
{
  this->lights_->AddLightsToRenderer(this->renderer_);
  this->lights_->SetKeyLightWarmth(0.55);
  this->lights_->SetKeyToFillRatio(2.5);

  this->mesh_->SetMapper(this->meshMapper_);
  this->mesh_->GetProperty()->SetInterpolationToGouraud();
  this->mesh_->GetProperty()->SetSpecular(0.15);
  this->mesh_->GetProperty()->SetSpecularPower(20.0);
  this->renderer_->AddActor(this->mesh_);

  // Drawn over the surface that it lies on.
  this->section_->SetMapper(this->sectionMapper_);
  this->sectionMapper_->ScalarVisibilityOff();
  this->sectionMapper_->SetResolveCoincidentTopologyToPolygonOffset();
  this->sectionMapper_->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -60000.0);
  this->section_->GetProperty()->SetColor(sectionColour[0], sectionColour[1], sectionColour[2]);
  this->section_->GetProperty()->LightingOff();
  this->section_->PickableOff();
  this->section_->VisibilityOff();
  this->renderer_->AddActor(this->section_);

  this->makeRegion();

  this->mirrorMapper_->SetInputConnection(this->mirrorPlane_->GetOutputPort());
  this->mirror_->SetMapper(this->mirrorMapper_);
  this->mirror_->GetProperty()->SetOpacity(0.15);
  this->mirror_->GetProperty()->SetEdgeVisibility(true);
  this->mirror_->GetProperty()->LightingOff();
  this->mirror_->PickableOff();
  this->mirror_->VisibilityOff();
  this->renderer_->AddActor(this->mirror_);

  this->hint_.addTo(this->renderer_);
}

void Viewport::makeRegion()
{
  this->regionNormals_->SplittingOff();
  this->regionMapper_->SetInputConnection(this->regionNormals_->GetOutputPort());
  this->regionMapper_->ScalarVisibilityOff();
  // Over the surface that it is a part of.
  this->regionMapper_->SetResolveCoincidentTopologyToPolygonOffset();
  this->regionMapper_->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, -200.0);
  this->region_->SetMapper(this->regionMapper_);
  this->region_->GetProperty()->SetColor(0.98, 0.62, 0.20);
  this->region_->GetProperty()->SetAmbient(0.12);
  this->region_->GetProperty()->SetDiffuse(0.85);
  this->region_->PickableOff();
  this->region_->VisibilityOff();
  this->renderer_->AddActor(this->region_);
}

void Viewport::listen()
{
  this->interactor()->SetInteractorStyle(this->style_);
  this->style_->SetDefaultRenderer(this->renderer_);
  this->observer_->SetClientData(this);
  this->observer_->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*) { static_cast<Viewport*>(self)->heard(event); });
  // One frame for all events that have come, so that a quick hand does not wait for each of its samples.
  this->interactor()->EnableRenderOff();
  this->interactor()->AddObserver(vtkCommand::RenderEvent, this->observer_);
  // Key q, by the style.
  this->interactor()->AddObserver(vtkCommand::ExitEvent, this->observer_);
  this->style_->AddObserver(vtkCommand::StartInteractionEvent, this->observer_);
}

Viewport::~Viewport()
{
  this->interactor()->RemoveObserver(this->observer_);
  this->style_->RemoveObserver(this->observer_);
  // Tools hold parts of the window, which goes first.
  for (Tool* tool : this->findChildren<Tool*>(QString(), Qt::FindDirectChildrenOnly))
  {
    delete tool;
  }
}

void Viewport::heard(unsigned long event)
{
  if (event == vtkCommand::StartInteractionEvent)
  {
    this->hideHint();
    emit this->cameraMoves();
  }
  else if (event == vtkCommand::ExitEvent)
  {
    emit this->quitAsked();
  }
  else if (!this->interactor()->GetEnableRender())
  {
    this->renderSoon();
  }
}

void Viewport::setTool(Tool* tool)
{
  if (this->tool_)
  {
    this->tool_->stop();
  }
  this->tool_ = tool;
  tool->start();
  this->style_->SetKeyList(keyList(*tool, this->findChildren<Tool*>().toVector()).toUtf8().constData());
}

void Viewport::setHandCursor(Qt::CursorShape shape)
{
  this->setDefaultCursor(shape);
  this->setCursor(this->defaultCursor());
}

void Viewport::render()
{
  this->await_->stop();
  this->renderWaits_ = false;
  if (this->tool_)
  {
    this->tool_->frameBegins();
  }
  this->backdrop_.look(this->renderer_);
  Latency::of().frameBegins();
  this->window_->Render();
  this->paintWaits_ = true;
}

// And paints it, so that no frame is drawn that nobody sees.
void Viewport::renderNow()
{
  this->render();
  this->repaint();
}

// Qt puts a repaint off that follows closely on the last.
void Viewport::paintNow()
{
  this->update();
  QEvent now(QEvent::UpdateRequest);
  QCoreApplication::sendEvent(this->window(), &now);
}

void Viewport::awaitMesh()
{
  this->await_->start(awaitTime);
}

void Viewport::awaitNoMore()
{
  this->await_->stop();
  if (std::exchange(this->renderWaits_, false))
  {
    this->renderSoon();
  }
}

void Viewport::renderSoon()
{
  if (this->await_->isActive())
  {
    this->renderWaits_ = true;
  }
  else if (!this->renderWaits_)
  {
    this->renderWaits_ = true;
    QTimer::singleShot(0,
      this,
      [this]
      {
        if (this->renderWaits_ && !this->await_->isActive())
        {
          this->renderNow();
        }
      });
  }
}

void Viewport::paintGL()
{
  this->paintWaits_ = false;
  // What Qt asks for is drawn now.
  this->backdrop_.look(this->renderer_);
  this->interactor()->EnableRenderOn();
  QVTKOpenGLNativeWidget::paintGL();
  this->interactor()->EnableRenderOff();
  if (this->tool_)
  {
    this->tool_->framePainted();
  }
  if (Latency::of().isOn())
  {
    this->window_->WaitForCompletion();
    Latency::of().framePainted();
  }
}

void Viewport::resizeGL(int width, int height)
{
  QVTKOpenGLNativeWidget::resizeGL(width, height);
  this->fitScreen();
}

// VTK counts the screen's own pixels.
void Viewport::fitScreen()
{
  const double ratio = this->devicePixelRatioF();
  this->section_->GetProperty()->SetLineWidth(static_cast<float>(sectionWidth * ratio));
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
  QVTKOpenGLNativeWidget::keyPressEvent(event);
}

bool Viewport::event(QEvent* event)
{
  // VTK hears of the mouse before the functions for its events do.
  const auto type = event->type();
  const bool press = type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick;
  const bool release = type == QEvent::MouseButtonRelease && this->tool_ && this->tool_->draws();
  if (press || type == QEvent::Wheel || type == QEvent::KeyPress)
  {
    this->awaitNoMore();
  }
  if (press || release)
  {
    // The pen draws over what is on screen; the line's end is seen before all that a stroke's end brings.
    if (this->renderWaits_)
    {
      this->render();
    }
    if (this->paintWaits_)
    {
      this->paintNow();
    }
  }
  return QVTKOpenGLNativeWidget::event(event);
}

void Viewport::showMesh(vtkPolyData* mesh, bool reset)
{
  this->meshMapper_->SetInputData(mesh);
  this->skin_.dress(this->mesh_, this->meshMapper_, mesh);
  this->backdrop_.setMesh(mesh);
  if (reset)
  {
    vtkCamera* camera = this->renderer_->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 1.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    this->renderer_->ResetCamera(mesh->GetBounds());
    this->style_->SaveFirstView();
    // Room for what is drawn beside the model.
    this->renderer_->SetSSAORadius(0.1 * mesh->GetLength());
    this->renderer_->SetSSAOBias(0.002 * mesh->GetLength());
  }
  this->renderer_->ResetCameraClippingRange();
  if (!this->occlusionAsked_ && this->isValid())
  {
    this->occlusionAsked_ = true;
    this->renderer_->SetUseSSAO(!drawsOnProcessor(this->window_));
  }
  this->placeHint();
  this->awaitNoMore();
  this->renderSoon();
}

void Viewport::showPreview(vtkPolyData* mesh)
{
  this->meshMapper_->SetInputData(mesh);
}

vtkPolyData* Viewport::mesh() const
{
  return this->meshMapper_->GetInput();
}

void Viewport::showPictures(const Pictures& pictures)
{
  this->backdrop_.set(pictures, this->renderer_);
  this->renderSoon();
}

Lines Viewport::frameFor(int width, int height)
{
  vtkNew<vtkOversketchStrokeRepresentation> reader;
  reader->SetRenderer(this->renderer_);
  vtkNew<vtkPolyData> frame;
  reader->PutView(frame);
  const int* size = this->renderer_->GetSize();
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
  this->sectionMapper_->SetInputData(section);
  this->section_->SetVisibility(section != nullptr);
  this->renderSoon();
}

void Viewport::showMirror(const std::optional<MirrorPlane>& plane)
{
  vtkPolyData* mesh = this->meshMapper_->GetInput();
  this->mirror_->SetVisibility(plane && mesh);
  if (plane && mesh)
  {
    // A little larger than the model, in the plane.
    double box[6];
    mesh->GetBounds(box);
    const int a = (plane->axis + 1) % 3, b = (plane->axis + 2) % 3;
    const double margin = 0.1 * mesh->GetLength();
    double origin[3], first[3], second[3];
    origin[plane->axis] = plane->offset;
    origin[a] = box[2 * a] - margin;
    origin[b] = box[2 * b] - margin;
    std::copy(origin, origin + 3, first);
    std::copy(origin, origin + 3, second);
    first[a] = box[2 * a + 1] + margin;
    second[b] = box[2 * b + 1] + margin;
    this->mirrorPlane_->SetOrigin(origin);
    this->mirrorPlane_->SetPoint1(first);
    this->mirrorPlane_->SetPoint2(second);
  }
  this->renderSoon();
}

void Viewport::showHint(const QString& text)
{
  this->hint_.setText(text.toStdString());
  this->placeHint();
  this->renderSoon();
}

void Viewport::hideHint()
{
  this->hint_.setVisible(false);
}

void Viewport::placeHint()
{
  this->hint_.place(this->renderer_, this->meshMapper_->GetInput(), this->devicePixelRatioF());
}

void Viewport::setDark(bool dark)
{
  if (dark)
  {
    this->renderer_->SetBackground(0.13, 0.14, 0.16);
    this->renderer_->SetBackground2(0.22, 0.24, 0.27);
    this->skin_.setPlain(this->mesh_, 0.78, 0.76, 0.73);
    this->mirror_->GetProperty()->SetColor(0.6, 0.8, 1.0);
    this->hint_.setDark(true);
  }
  else
  {
    this->renderer_->SetBackground(0.80, 0.82, 0.84);
    this->renderer_->SetBackground2(0.95, 0.96, 0.97);
    this->skin_.setPlain(this->mesh_, 0.90, 0.88, 0.85);
    this->mirror_->GetProperty()->SetColor(0.2, 0.4, 0.7);
    this->hint_.setDark(false);
  }
  this->renderer_->GradientBackgroundOn();
  this->renderSoon();
}

void Viewport::showRegion(vtkPolyData* region)
{
  const bool any = region && region->GetNumberOfPolys() > 0;
  this->regionNormals_->SetInputData(any ? region : nullptr);
  this->region_->SetVisibility(any);
  this->renderSoon();
}

void Viewport::lookFrom(vtkPolyData* stroke)
{
  this->style_->LookFrom(stroke);
  this->render();
}

void Viewport::showKeys(bool show)
{
  this->style_->SetShowKeys(show);
  this->hint_.setVisible(false); // it would be under the list
  this->render();
}

bool Viewport::showsKeys() const
{
  return this->style_->GetShowKeys();
}

void Viewport::screenshot(const QString& path, bool overlays)
{
  const int section = this->section_->GetVisibility(), region = this->region_->GetVisibility(),
            mirror = this->mirror_->GetVisibility(), hint = this->hint_.isVisible();
  const bool keys = this->style_->GetShowKeys();
  if (!overlays)
  {
    for (Tool* tool : this->findChildren<Tool*>())
    {
      tool->showLines(false);
    }
    this->section_->VisibilityOff();
    this->region_->VisibilityOff();
    this->mirror_->VisibilityOff();
    this->hint_.setVisible(false);
    this->style_->SetShowKeys(false);
  }
  this->render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(this->window_);
  picture->ReadFrontBufferOff();
  picture->Update();
  this->section_->SetVisibility(section);
  this->region_->SetVisibility(region);
  this->mirror_->SetVisibility(mirror);
  this->hint_.setVisible(hint);
  this->style_->SetShowKeys(keys);
  for (Tool* tool : this->findChildren<Tool*>())
  {
    tool->showLines(true);
  }
  this->render();
  oversketch_files::writeWhole(path.toStdString(),
    [&](const std::string& file)
    {
      vtkNew<vtkPNGWriter> writer;
      writer->SetInputConnection(picture->GetOutputPort());
      writer->SetFileName(file.c_str());
      writer->Write();
      if (writer->GetErrorCode() != 0)
      {
        throw oversketch_files::Failed(
          tr("%1 could not be written. Is the disk full?").arg(path).toStdString());
      }
    });
}

void Viewport::tabletEvent(QTabletEvent* event)
{
  // Qt makes a mouse event of what is left to it; the pen takes the pressure from here.
  if (this->tool_)
  {
    this->tool_->setPressure(event->type() == QEvent::TabletRelease ? 1.0 : event->pressure());
  }
  event->ignore();
}

} // namespace oversketch_studio
