#include "vtkOversketchRegionWidget.h"

#include "drawn_curve.h"
#include "pen_stroke.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchRegionRepresentation.h"
#include "vtkOversketchStrokeWidget.h"
#include "widget_events.h"

#include "Mesh/context.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkIdList.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTrivialProducer.h"
#include "vtkWidgetCallbackMapper.h"
#include "vtkWidgetEvent.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchRegionWidget);
oversketchRepresentationMacro(Region);

struct vtkOversketchRegionWidget::Internals
{
  // One polyline each, the first as it was drawn, the others over it; and where it lies after each of them.
  struct Curve
  {
    std::vector<vtkSmartPointer<vtkPolyData>> strokes;
    std::vector<std::vector<Vector3>> laid;
    std::vector<Vector3> shown() const
    {
      return this->laid.empty() ? std::vector<Vector3>() : this->laid.back();
    }
  };
  Curve line, ring;
  std::vector<Curve*> order; // of what was drawn, since line and ring are there

  static bool isOfEdit(vtkPolyData* stroke) { return stroke->GetPointData()->HasArray("VertexId"); }
  vtkSmartPointer<vtkPolyData> model;
  MeshKey seen;
  std::shared_ptr<const SurfaceRays> rays;
  vtkNew<vtkTrivialProducer> referencePort, boundaryPort;
  vtkNew<vtkPolyData> shownLine, shownRing;

  const SurfaceRays* surface()
  {
    if (this->model && (!this->rays || MeshKey(this->model) != this->seen))
    {
      this->seen = MeshKey(this->model);
      this->rays = raysOf(this->model);
    }
    return this->model ? this->rays.get() : nullptr;
  }
};

namespace
{

constexpr double farthestEnd = 20.0; // px

// A polyline that ends with the id that it begins with.
void closeLine(vtkPolyData* stroke)
{
  vtkNew<vtkIdList> ids;
  stroke->GetLines()->GetCellAtId(0, ids);
  if (ids->GetId(0) != ids->GetId(ids->GetNumberOfIds() - 1))
  {
    ids->InsertNextId(ids->GetId(0));
  }
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(ids);
  stroke->SetLines(lines);
}

} // namespace

vtkOversketchRegionWidget::vtkOversketchRegionWidget()
  : Inner(std::make_unique<Internals>())
{
  this->Inner->referencePort->SetOutput(this->Reference);
  this->Inner->boundaryPort->SetOutput(this->Boundary);
  this->CallbackMapper->SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, Hover);
}

vtkOversketchRegionWidget::~vtkOversketchRegionWidget() = default;

vtkAlgorithmOutput* vtkOversketchRegionWidget::GetReferencePort()
{
  return this->Inner->referencePort->GetOutputPort();
}

vtkAlgorithmOutput* vtkOversketchRegionWidget::GetBoundaryPort()
{
  return this->Inner->boundaryPort->GetOutputPort();
}

void vtkOversketchRegionWidget::SetModel(vtkPolyData* mesh)
{
  if (mesh != this->Inner->model)
  {
    this->Inner->model = mesh;
    this->Inner->rays = nullptr;
    this->Modified();
  }
}

vtkPolyData* vtkOversketchRegionWidget::GetModel()
{
  return this->Inner->model;
}

bool vtkOversketchRegionWidget::HasReference() const
{
  return !this->Inner->line.strokes.empty();
}

bool vtkOversketchRegionWidget::HasBoundary() const
{
  return !this->Inner->ring.strokes.empty();
}

void vtkOversketchRegionWidget::SetRedrawOnly(bool only)
{
  if (only != this->RedrawOnly)
  {
    this->RedrawOnly = only;
    this->ReadyPen();
    this->Modified();
  }
}

void vtkOversketchRegionWidget::Publish()
{
  Internals& inner = *this->Inner;
  putInto(this->Reference, inner.line.strokes);
  putInto(this->Boundary, inner.ring.strokes);
  this->ShowCurves(nullptr, nullptr);
}

void vtkOversketchRegionWidget::ShowCurves(vtkPolyData* reference, vtkPolyData* boundary)
{
  Internals& inner = *this->Inner;
  putLine(inner.shownLine, inner.line.shown());
  putLine(inner.shownRing, inner.ring.shown(), true);
  vtkOversketchRegionRepresentation* shown = this->GetRegionRepresentation();
  shown->SetReference(reference ? reference : inner.shownLine.Get());
  shown->SetBoundary(boundary ? boundary : inner.shownRing.Get());
  this->Render();
}

bool vtkOversketchRegionWidget::SetRegion(vtkPolyData* reference, vtkPolyData* boundary)
{
  Internals& inner = *this->Inner;
  Internals::Curve line, ring;
  try
  {
    for (Internals::Curve* curve : { &line, &ring })
    {
      vtkPolyData* from = curve == &line ? reference : boundary;
      curve->strokes = strokesOf(from);
      if (from && from->GetNumberOfPoints() > 0 && curve->strokes.empty())
      {
        throw Error(Failure::BadStroke, "There is no polyline among the curves; give strokes with views.");
      }
      for (vtkPolyData* stroke : curve->strokes)
      {
        const bool isRing = curve == &ring;
        if (Internals::isOfEdit(stroke))
        {
          curve->laid.push_back(firstLineOf(stroke));
          continue;
        }
        const View view = ViewOf(stroke);
        if (isRing && stroke == curve->strokes[0])
        {
          closeLine(stroke);
        }
        const Polyline samples = flat(firstLineOf(stroke));
        const std::vector<Vector3> laid = laidOn(inner.surface(),
          view,
          samples,
          view.depth(inner.model ? Vector3(inner.model->GetCenter()) : Vector3(Vector3::Zero())));
        curve->laid.push_back(
          curve->laid.empty() ? laid : redrawn(curve->laid.back(), isRing, view, samples, laid));
      }
    }
  }
  catch (const Error& error)
  {
    this->Tell(error.what());
    return false;
  }
  if (line.strokes.empty())
  {
    ring = {};
  }
  inner.line = line;
  inner.ring = ring;
  inner.order.assign(line.strokes.size(), &inner.line);
  inner.order.insert(inner.order.end(), ring.strokes.size(), &inner.ring);
  this->Publish();
  this->ReadyPen();
  return true;
}

bool vtkOversketchRegionWidget::Wants(bool over)
{
  return over ? this->HasReference() : !this->RedrawOnly && !this->HasBoundary();
}

bool vtkOversketchRegionWidget::TakeStroke(vtkPolyData* stroke, bool over)
{
  Internals& inner = *this->Inner;
  Internals::Curve* curve = !over && this->HasReference() ? &inner.ring : &inner.line;
  try
  {
    const View view = ViewOf(stroke);
    const Polyline samples = flat(firstLineOf(stroke));
    const double* focus = this->CurrentRenderer->GetActiveCamera()->GetFocalPoint();
    std::vector<Vector3> laid = laidOn(inner.surface(), view, samples, view.depth(Vector3(focus)));
    if (over)
    {
      const auto apart = [&](const Internals::Curve& from)
      {
        const bool isRing = &from == &inner.ring;
        return from.laid.empty() ? std::numeric_limits<double>::infinity()
                                 : std::min(distanceTo(view, from.laid.back(), isRing, samples.front()),
                                     distanceTo(view, from.laid.back(), isRing, samples.back()));
      };
      const double toLine = apart(inner.line), toRing = apart(inner.ring);
      curve = toLine <= toRing ? &inner.line : &inner.ring;
      if (std::min(toLine, toRing) > farthestEnd)
      {
        this->Tell("Neither line nor ring is under the ends of this stroke: begin or end on the one that is "
                   "to be redrawn.");
        this->Render();
        return false;
      }
      if (Internals::isOfEdit(curve->strokes[0]))
      {
        this->Tell("This curve is an earlier edit's, which it follows: redraw it there.");
        this->Render();
        return false;
      }
      laid = redrawn(curve->laid.back(), curve == &inner.ring, view, samples, laid);
    }
    else if (curve == &inner.ring)
    {
      closeLine(stroke);
    }
    curve->laid.push_back(std::move(laid));
  }
  catch (const Error& error)
  {
    this->Tell(error.what());
    return false;
  }
  curve->strokes.emplace_back(stroke);
  inner.order.push_back(curve);
  this->Publish();
  return true;
}

bool vtkOversketchRegionWidget::TakeBack()
{
  Internals& inner = *this->Inner;
  if (inner.order.empty() || this->RedrawOnly)
  {
    return false;
  }
  Internals::Curve* last = inner.order.back();
  inner.order.pop_back();
  last->strokes.pop_back();
  last->laid.pop_back();
  this->Publish();
  return true;
}

void vtkOversketchRegionWidget::ShowText(const std::string& text)
{
  this->GetRegionRepresentation()->SetText(text.c_str());
}

void vtkOversketchRegionWidget::Hover(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchRegionWidget>(widget);
  const int* at = self->Interactor->GetEventPosition();
  vtkOversketchRegionRepresentation* shown = self->GetRegionRepresentation();
  const int grip = self->Interactor->GetShiftKey() && self->CurrentRenderer &&
                       self->CurrentRenderer->IsInViewport(at[0], at[1])
                     ? shown->GetGripAt(at[0], at[1])
                     : 0;
  if (!self->GetPen()->IsDrawing() && grip != shown->GetActiveGrip())
  {
    shown->SetActiveGrip(grip);
    self->Render();
  }
}

void vtkOversketchRegionWidget::SetRepresentation(vtkOversketchRegionRepresentation* representation)
{
  this->SetWidgetRepresentation(representation);
  this->ShowCurves(nullptr, nullptr);
}

void vtkOversketchRegionWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RedrawOnly: " << this->RedrawOnly << "\n";
  os << indent << "Model: " << this->Inner->model.Get() << "\n";
  os << indent << "Reference: " << this->Inner->line.strokes.size() << " strokes\n";
  os << indent << "Boundary: " << this->Inner->ring.strokes.size() << " strokes\n";
}
