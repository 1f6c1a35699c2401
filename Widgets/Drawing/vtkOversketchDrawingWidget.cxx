#include "vtkOversketchDrawingWidget.h"

#include "by_layers.h"
#include "drawing_strokes.h"
#include "pen_view.h"
#include "plane_camera.h"
#include "vtkOversketchArrange.h"
#include "vtkOversketchCanvas.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchClassify.h"
#include "vtkOversketchDrawingRepresentation.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchMagneticSnap.h"
#include "vtkOversketchResample.h"
#include "vtkOversketchStepRunner.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"
#include "vtkOversketchTrace.h"
#include "vtkOversketchTreatment.h"
#include "widget_events.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTrivialProducer.h"
#include "vtkWidgetCallbackMapper.h"
#include "vtkWidgetEvent.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchDrawingWidget);
oversketchRepresentationMacro(Drawing);

struct vtkOversketchDrawingWidget::Internals
{
  DrawingStrokes strokes;
  vtkSmartPointer<vtkImageData> picture;
  oversketch::Canvas rectangle{ Vector2::Zero(), { 1024.0, 768.0 } };
  vtkNew<vtkTrivialProducer> producer;

  vtkNew<vtkOversketchTrace> trace;
  vtkNew<vtkOversketchCanvas> canvas;
  vtkNew<vtkOversketchMagneticSnap> snap;
  vtkNew<vtkOversketchResample> resample;
  vtkNew<vtkOversketchArrange> arrange;
  vtkNew<vtkOversketchClassify> classify;
  vtkNew<vtkOversketchTreatment> treatment;
  vtkNew<vtkPolyData> curves;
  Message said;
  std::string text;
};

namespace
{

constexpr double clickLength = 3.0; // px
constexpr double notch = 1.15;      // zoom of a notch of the wheel

// Farthest that a stroke goes from its first sample [px].
double extentOf(vtkPolyData* stroke)
{
  double extent = 0.0;
  for (vtkIdType i = 1; i < stroke->GetNumberOfPoints(); ++i)
  {
    double first[3], point[3];
    stroke->GetPoint(0, first);
    stroke->GetPoint(i, point);
    extent = std::max(extent, std::hypot(point[0] - first[0], point[1] - first[1]));
  }
  return extent;
}

// The area that a curve's polygon covers, negative where the place is not in it.
double areaRound(vtkPolyData* curves, vtkIdType cell, const Vector2& place)
{
  vtkNew<vtkIdList> ids;
  curves->GetLines()->GetCellAtId(cell, ids);
  std::vector<double> corners;
  for (const vtkIdType id : *ids)
  {
    const double* p = curves->GetPoint(id);
    corners.insert(corners.end(), { p[0], p[1], 0.0 });
  }
  const int count = static_cast<int>(ids->GetNumberOfIds()) - 1; // its first id stands again at the end
  double area = 0.0, box[6] = { corners[0], corners[0], corners[1], corners[1], 0.0, 0.0 };
  for (int i = 0; i < count; ++i)
  {
    const double* a = &corners[3 * static_cast<std::size_t>(i)];
    area += 0.5 * (a[0] * a[4] - a[3] * a[1]);
    box[0] = std::min(box[0], a[0]);
    box[1] = std::max(box[1], a[0]);
    box[2] = std::min(box[2], a[1]);
    box[3] = std::max(box[3], a[1]);
  }
  double at[3] = { place[0], place[1], 0.0 }, normal[3] = { 0.0, 0.0, 1.0 };
  return count > 2 && vtkPolygon::PointInPolygon(at, count, corners.data(), box, normal) == 1 ? std::abs(area)
                                                                                              : -1.0;
}

// The smallest curve round a place of which an array says this, -1 where there is none.
vtkIdType smallestRound(vtkPolyData* curves, const char* name, double value, const Vector2& place)
{
  vtkDataArray* array = curves->GetCellData()->GetArray(name);
  vtkIdType found = -1;
  double least = std::numeric_limits<double>::infinity();
  for (vtkIdType cell = 0; array && cell < curves->GetNumberOfLines(); ++cell)
  {
    const double area = array->GetComponent(cell, 0) == value ? areaRound(curves, cell, place) : -1.0;
    if (area >= 0.0 && area < least)
    {
      least = area;
      found = cell;
    }
  }
  return found;
}

// Whether a closed curve runs where a stroke does, which is in the picture's own view.
bool hasCurveAt(vtkPolyData* curves, vtkPolyData* stroke, const Canvas& canvas)
{
  vtkDataArray* closed = curves->GetCellData()->GetArray("Closed");
  if (!closed)
  {
    return false;
  }
  const Polyline outline = ontoCanvas(PenView::of(stroke).kernelView(), ReadStrokes(stroke)[0].Samples);
  const std::vector<DrawnLine> lines = ReadStrokes(curves, 1);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    if (closed->GetComponent(static_cast<vtkIdType>(i), 0) != 0.0 &&
        NearestPlace(lines[i].Samples, true).meanDistance(outline) < 0.01 * canvas.longest())
    {
      return true;
    }
  }
  return false;
}

} // namespace

vtkOversketchDrawingWidget::vtkOversketchDrawingWidget()
  : Inner(std::make_unique<Internals>())
{
  this->CallbackMapper->SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, MoveTo);
  this->CallbackMapper->SetCallbackMethod(
    vtkCommand::MouseWheelForwardEvent, vtkWidgetEvent::Up, this, Forward);
  this->CallbackMapper->SetCallbackMethod(
    vtkCommand::MouseWheelBackwardEvent, vtkWidgetEvent::Down, this, Backward);
  this->CallbackMapper->SetCallbackMethod(
    vtkCommand::MiddleButtonPressEvent, vtkWidgetEvent::Translate, this, PanBegins);
  this->CallbackMapper->SetCallbackMethod(
    vtkCommand::MiddleButtonReleaseEvent, vtkWidgetEvent::EndTranslate, this, PanEnds);
  Internals& inner = *this->Inner;
  inner.producer->SetOutput(this->Drawing);
  inner.canvas->SetInputData(0, this->Drawing);
  inner.snap->SetInputConnection(0, inner.canvas->GetOutputPort());
  inner.resample->SetInputConnection(0, inner.snap->GetOutputPort());
  inner.treatment->SetInputConnection(0, inner.classify->GetOutputPort());
  vtkProperty2D* corridor = this->GetPen()->GetStrokeRepresentation()->GetSectionProperty();
  corridor->SetColor(0.20, 0.50, 0.95);
  corridor->SetOpacity(0.25);
  this->SetCanvas(0.0, 0.0, 1024.0, 768.0);
}

vtkOversketchDrawingWidget::~vtkOversketchDrawingWidget() = default;

vtkAlgorithmOutput* vtkOversketchDrawingWidget::GetOutputPort()
{
  return this->Inner->producer->GetOutputPort();
}

vtkPolyData* vtkOversketchDrawingWidget::GetCurves()
{
  return this->Inner->curves;
}

vtkImageData* vtkOversketchDrawingWidget::GetPicture()
{
  return this->Inner->picture;
}

const Message& vtkOversketchDrawingWidget::GetSaid() const
{
  return this->Inner->said;
}

const char* vtkOversketchDrawingWidget::GetText()
{
  return this->Inner->text.c_str();
}

void vtkOversketchDrawingWidget::SetPicture(vtkImageData* picture)
{
  Internals& inner = *this->Inner;
  if (picture)
  {
    try
    {
      inner.rectangle = PlaceOf(picture).Rectangle;
    }
    catch (const Error& error)
    {
      vtkErrorMacro(<< error.what());
      return;
    }
  }
  inner.picture = picture;
  inner.canvas->SetPictureData(picture);
  inner.snap->SetPictureData(picture);
  inner.trace->SetInputData(picture);
  if (this->Magnetic)
  {
    inner.snap->Prepare(); // no stroke's release waits for it
  }
  picture ? this->GetDrawingRepresentation()->SetPicture(picture)
          : this->GetDrawingRepresentation()->SetCanvas(inner.rectangle.corner[0],
              inner.rectangle.corner[1],
              inner.rectangle.size[0],
              inner.rectangle.size[1]);
  this->ResetView();
  this->Publish();
}

void vtkOversketchDrawingWidget::SetCanvas(double x, double y, double width, double height)
{
  if (!(width > 0.0 && height > 0.0 && std::isfinite(x + y + width + height)))
  {
    vtkErrorMacro("The canvas has no extent; give its lower left corner, a width and a height above 0.");
    return;
  }
  this->Inner->rectangle = { { x, y }, { width, height } };
  this->SetPicture(nullptr);
}

void vtkOversketchDrawingWidget::SetArrange(bool arrange)
{
  if (arrange != this->Arrange)
  {
    this->Arrange = arrange;
    this->Classify();
    this->Render();
    this->Modified();
  }
}

void vtkOversketchDrawingWidget::ResetView()
{
  if (this->CurrentRenderer)
  {
    lookAtCanvas(this->CurrentRenderer, this->Inner->rectangle);
  }
}

bool vtkOversketchDrawingWidget::SetDrawing(vtkPolyData* drawing)
{
  try
  {
    this->Inner->strokes.set(drawing);
  }
  catch (const Error& error)
  {
    this->Tell(error.message());
    return false;
  }
  this->Publish();
  return true;
}

void vtkOversketchDrawingWidget::RemoveLastStroke()
{
  this->Inner->strokes.removeLast();
  this->Publish();
}

bool vtkOversketchDrawingWidget::CycleTreatment(double x, double y)
{
  Internals& inner = *this->Inner;
  const vtkIdType cell = smallestRound(inner.curves, "Role", 2.0, { x, y });
  if (cell < 0)
  {
    return false;
  }
  const int found =
    static_cast<int>(inner.curves->GetCellData()->GetArray("StrokeId")->GetComponent(cell, 0));
  inner.strokes.setTreatment(found, (inner.strokes.treatment(found) + 1) % 3);
  this->Publish();
  return true;
}

bool vtkOversketchDrawingWidget::Trace(double x, double y)
{
  Internals& inner = *this->Inner;
  try
  {
    if (!inner.picture)
    {
      throw Error(Failure::BadStroke, "There is no picture to trace in; draw the outline.");
    }
    const PicturePlace picture = PlaceOf(inner.picture);
    const Vector2 at = picture.ToPixels({ x, y }) + Vector2(0.5, 0.5);
    inner.trace->SetPlace(std::max(at[0], 0.0), std::max(at[1], 0.0));
    StepRunner(inner.trace, {}).Run();
    vtkPolyData* outlines = inner.trace->GetOutput();
    if (hasCurveAt(inner.curves, outlines, inner.rectangle))
    {
      throw Error(Failure::BadStroke, "What is there has its outline; click on another thing, or draw.");
    }
    for (vtkIdType i = 0; i < outlines->GetNumberOfLines(); ++i)
    {
      inner.strokes.add(StrokeAlone(outlines, i), false, 10.0);
    }
  }
  catch (const Error& error)
  {
    this->Tell(error.message());
    this->Show();
    return false;
  }
  this->Publish();
  return true;
}

void vtkOversketchDrawingWidget::Publish()
{
  Internals& inner = *this->Inner;
  inner.strokes.putInto(this->Drawing);
  if (!inner.picture)
  {
    WriteCanvas(inner.rectangle, this->Drawing);
  }
  this->Classify();
  this->Show();
}

void vtkOversketchDrawingWidget::Show()
{
  if (!this->PenDraws)
  {
    this->Render();
  }
}

void vtkOversketchDrawingWidget::Classify()
{
  Internals& inner = *this->Inner;
  std::vector<Message> said;
  StepRunner::Listener listener;
  listener.warning = [&](const Message& message) { said.push_back(message); };
  inner.curves->Initialize();
  if (inner.strokes.count() > 0)
  {
    try
    {
      const std::vector<vtkPolyDataAlgorithm*> lines{ inner.canvas, inner.snap, inner.resample };
      for (vtkPolyDataAlgorithm* step : lines)
      {
        StepRunner(step, listener).Run();
        inner.curves->ShallowCopy(step->GetOutput());
      }
      std::vector<vtkPolyDataAlgorithm*> judges{ inner.classify, inner.treatment };
      if (this->Arrange)
      {
        judges.insert(judges.begin(), inner.arrange);
        inner.classify->SetInputConnection(0, inner.arrange->GetOutputPort());
      }
      const std::vector<Message> more = runByLayers(
        judges, inner.resample->GetOutput(), LayersOfStrokes(inner.canvas->GetOutput()), inner.curves);
      said.insert(said.end(), more.begin(), more.end());
    }
    catch (const Error& error) // curves are those of the step before
    {
      said = { error.message() };
    }
  }
  const Message all = Message::joined(said, "\n");
  this->ShowFault(all);
  this->GetDrawingRepresentation()->SetCurves(inner.curves);
  this->Tell(all);
}

// Shows the first stroke that the message names, and the first place.
void vtkOversketchDrawingWidget::ShowFault(const Message& message)
{
  int stroke = -1;
  bool hasPlace = false;
  double place[2] = { 0.0, 0.0 };
  for (const std::string& named : message.first().named())
  {
    if (stroke < 0)
    {
      std::sscanf(named.c_str(), "Stroke %d", &stroke);
    }
    hasPlace = hasPlace || std::sscanf(named.c_str(), "(%lf, %lf)", &place[0], &place[1]) == 2;
  }
  this->GetDrawingRepresentation()->SetFault(stroke, stroke >= 0 && hasPlace ? place : nullptr);
}

void vtkOversketchDrawingWidget::Tell(const Message& message)
{
  std::string& text = this->Inner->text;
  const bool isNew = message != this->Inner->said;
  this->Inner->said = message;
  text = message.text();
  this->GetDrawingRepresentation()->SetText(text.c_str());
  if (isNew && !message.empty())
  {
    this->InvokeEvent(vtkCommand::MessageEvent, const_cast<char*>(text.c_str()));
  }
}

void vtkOversketchDrawingWidget::SetRepresentation(vtkOversketchDrawingRepresentation* representation)
{
  this->SetWidgetRepresentation(representation);
  this->SetPicture(this->Inner->picture);
}

void vtkOversketchDrawingWidget::SetEnabled(int enabling)
{
  const bool before = this->Enabled;
  this->Panning = this->Panning && enabling;
  this->Superclass::SetEnabled(enabling);
  if (!before && this->Enabled)
  {
    this->ResetView();
    this->Render();
  }
}

void vtkOversketchDrawingWidget::Heard(vtkObject* pen, unsigned long event, void* data)
{
  const vtkSmartPointer<vtkOversketchDrawingWidget> alive(this); // an observer may let go of it
  if (event == vtkCommand::InteractionEvent)
  {
    this->LineGrows();
  }
  this->PenDraws = event == vtkCommand::WidgetValueChangedEvent;
  this->Superclass::Heard(pen, event, data);
  if (event == vtkCommand::EndInteractionEvent && !this->GetPen()->WasDropped() &&
      this->GetPen()->GetStrokeRepresentation()->GetNumberOfSamples() < 2)
  {
    this->PenDraws = true;
    if (this->Click())
    {
      this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
    }
  }
  this->PenDraws = false;
}

void vtkOversketchDrawingWidget::LineGrows()
{
  vtkOversketchStrokeRepresentation* line = this->GetPen()->GetStrokeRepresentation();
  if (line->GetNumberOfSamples() == 1)
  {
    vtkNew<vtkPolyData> sample;
    line->GetPolyData(sample);
    std::copy_n(sample->GetPoint(0), 2, this->Begun);
  }
  const bool hasCorridor = this->Magnetic && this->Inner->picture;
  if (hasCorridor != line->GetSectionFollows())
  {
    line->GetSectionProperty()->SetLineWidth(static_cast<float>(2.0 * this->SnapRadius));
    line->SetSectionFollows(hasCorridor);
  }
}

bool vtkOversketchDrawingWidget::Click()
{
  if (this->IsOver() || !this->CurrentRenderer)
  {
    return false;
  }
  const auto at =
    ontoCanvas(PenView::of(this->CurrentRenderer).kernelView(), Vector2(this->Begun[0], this->Begun[1]));
  const Internals& inner = *this->Inner;
  const auto isIn = [&](const Canvas& canvas)
  {
    const Vector2 share = textureCoordinates(canvas, *at);
    return share.minCoeff() >= 0.0 && share.maxCoeff() <= 1.0;
  };
  return at && (this->CycleTreatment((*at)[0], (*at)[1]) ||
                 (inner.picture && isIn(inner.rectangle) &&
                   smallestRound(inner.curves, "Closed", 1.0, *at) < 0 && this->Trace((*at)[0], (*at)[1])));
}

bool vtkOversketchDrawingWidget::TakeStroke(vtkPolyData* stroke, bool over)
{
  Internals& inner = *this->Inner;
  if (extentOf(stroke) <= clickLength)
  {
    return this->Click();
  }
  if (over && inner.strokes.correct(stroke, inner.rectangle) < 0)
  {
    this->Tell(
      "No stroke is under the ends of this one: begin and end on the stroke that is to be corrected.");
    this->Show();
    return false;
  }
  if (!over)
  {
    double radius = this->SnapRadius;
    if (inner.picture && this->CurrentRenderer) // in the picture's pixels
    {
      const Vector2 right =
        placeUnder(this->CurrentRenderer, { 1.0, 0.0 }) - placeUnder(this->CurrentRenderer, { 0.0, 0.0 });
      radius *= right.norm() / inner.picture->GetSpacing()[0];
    }
    inner.strokes.add(stroke, this->Magnetic && inner.picture, radius);
  }
  this->Publish();
  return true;
}

void vtkOversketchDrawingWidget::PanBegins(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchDrawingWidget>(widget);
  const int* at = self->Interactor->GetEventPosition();
  if (!self->GetPen()->IsDrawing() && self->CurrentRenderer &&
      self->CurrentRenderer->IsInViewport(at[0], at[1]))
  {
    self->Panning = true;
    std::copy_n(at, 2, self->At);
    self->GrabFocus(self->EventCallbackCommand);
    self->EventCallbackCommand->SetAbortFlag(1);
  }
}

void vtkOversketchDrawingWidget::MoveTo(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchDrawingWidget>(widget);
  if (self->Panning)
  {
    const int* at = self->Interactor->GetEventPosition();
    pan(self->CurrentRenderer, Vector2(self->At[0], self->At[1]), Vector2(at[0], at[1]));
    std::copy_n(at, 2, self->At);
    self->EventCallbackCommand->SetAbortFlag(1);
    self->Render();
  }
}

void vtkOversketchDrawingWidget::PanEnds(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchDrawingWidget>(widget);
  if (self->Panning)
  {
    MoveTo(widget);
    self->Panning = false;
    self->ReleaseFocus();
    self->EventCallbackCommand->SetAbortFlag(1);
  }
}

void vtkOversketchDrawingWidget::Forward(vtkAbstractWidget* widget)
{
  oversketch::called<vtkOversketchDrawingWidget>(widget)->Zoom(notch);
}

void vtkOversketchDrawingWidget::Backward(vtkAbstractWidget* widget)
{
  oversketch::called<vtkOversketchDrawingWidget>(widget)->Zoom(1.0 / notch);
}

void vtkOversketchDrawingWidget::Zoom(double factor)
{
  const int* at = this->Interactor->GetEventPosition();
  if (!this->Panning && this->CurrentRenderer && this->CurrentRenderer->IsInViewport(at[0], at[1]))
  {
    zoomAbout(this->CurrentRenderer, this->Inner->rectangle, Vector2(at[0], at[1]), factor);
    this->EventCallbackCommand->SetAbortFlag(1);
    this->Render();
  }
}

void vtkOversketchDrawingWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Magnetic: " << (this->Magnetic ? "on" : "off") << "\n";
  os << indent << "Arrange: " << (this->Arrange ? "on" : "off") << "\n";
  os << indent << "SnapRadius: " << this->SnapRadius << "\n";
  os << indent << "Drawing: " << this->Inner->strokes.count() << " strokes\n";
  os << indent << "Text: " << this->Inner->text << "\n";
}
