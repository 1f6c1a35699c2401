#include "push_tool.h"

#include "document.h"
#include "picture_files.h"
#include "systems.h"
#include "viewport.h"

#include "vtkOversketchStrokeWidget.h"
#include "vtkOversketchSystem.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindowInteractor.h"

#include <cmath>

namespace oversketch_studio
{

using namespace oversketch_session;

PushTool::PushTool(Viewport* viewport, const Document* document)
  : Tool(viewport)
  , View(viewport)
  , OpenDocument(document)
{
  this->Pen->SetInteractor(viewport->interactor());
  this->Pen->SetDefaultRenderer(viewport->renderer());
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<PushTool*>(self)->strokeEnds(); });
  this->Pen->AddObserver(vtkCommand::WidgetValueChangedEvent, this->Observer);
}

PushTool::~PushTool()
{
  this->Pen->RemoveObserver(this->Observer);
  this->Pen->SetEnabled(0);
  this->Pen->SetInteractor(nullptr);
}

QString PushTool::title() const
{
  return tr("&Push");
}

QKeySequence PushTool::key() const
{
  return tr("P");
}

QString PushTool::help() const
{
  return tr("Draw two lines round a part; the picture pushes it (P)");
}

QPainterPath PushTool::icon() const
{
  QPainterPath path;
  path.addRect(4, 6, 4, 12);
  path.addRect(16, 6, 4, 12);
  return path;
}

QVector<QPair<QString, QString>> PushTool::keys() const
{
  return { { tr("Left drag"), tr("draw the first line, then the second") },
    { tr("Ctrl + wheel"), tr("push further") } };
}

QString PushTool::advice(const Situation&) const
{
  return tr("Put a picture into the scene, then draw two lines round a part of the model.");
}

void PushTool::start()
{
  this->Pen->SetEnabled(1);
  this->View->setHandCursor(Qt::CrossCursor);
}

void PushTool::stop()
{
  this->Pen->SetEnabled(0);
  this->First = {};
}

bool PushTool::draws() const
{
  return this->Pen->IsDrawing();
}

void PushTool::offer(const Step& step, const Worker::NodeState& state, const Point&)
{
  this->Offered = step;
  const SystemRow& row = *findSystem(this->system());
  this->Hand = row.make();
  for (const SystemInput& input : row.inputs)
  {
    const auto given = step.inputs.find(input.name);
    const Image* image = given == step.inputs.end() ? nullptr : std::get_if<Image>(&given->second);
    const SharedPicture picture = image ? decoded(image->bytes) : nullptr;
    vtkSmartPointer<vtkDataObject> data = linesOf(step, input.name);
    data = picture ? vtkSmartPointer<vtkDataObject>(picture->pixels) : data;
    data = input.kind == SystemInput::Kind::Mesh ? vtkSmartPointer<vtkDataObject>(state.before.own()) : data;
    this->Hand->SetInputDataObject(input.port, data);
  }
  for (const Parameter& one : row.parameters)
  {
    one.set(this->Hand, valueOf(step, one));
  }
}

bool PushTool::wheel(double notches, Qt::KeyboardModifiers modifiers, ulong)
{
  if (!this->Offered || modifiers != Qt::ControlModifier)
  {
    return false;
  }
  const Parameter& length = *findParameter(*findSystem(this->system()), "Length");
  Value& value = this->Offered->values["Length"];
  value = std::get<double>(length.get(this->Hand)) * std::pow(1.1, notches);
  length.set(this->Hand, value);
  this->Hand->Update();
  this->View->showPreview(this->Hand->GetOutput());
  this->View->renderSoon();
  emit this->shaped(this->Offered->values, true);
  return true;
}

void PushTool::strokeEnds()
{
  const Lines drawn(this->Pen->GetStroke());
  const Pictures& pictures = this->OpenDocument->session().pictures;
  if (!this->First || pictures.empty())
  {
    this->First = drawn;
    return;
  }
  Step step;
  step.system = this->system();
  step.inputs["FirstStroke"] = this->First;
  step.inputs["SecondStroke"] = drawn;
  step.inputs["Brightness"] = pictures.front()->image;
  this->First = {};
  emit this->drawn(step);
}

} // namespace oversketch_studio
