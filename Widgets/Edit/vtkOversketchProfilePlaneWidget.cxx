#include "vtkOversketchProfilePlaneWidget.h"

#include "drawn_curve.h"
#include "hosted_system.h"
#include "pen_stroke.h"
#include "vtkOversketchCrossSection.h"
#include "vtkOversketchProfilePlaneRepresentation.h"
#include "vtkOversketchProfilePlanes.h"
#include "vtkOversketchProfileRepresentation.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"
#include "widget_events.h"

#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTrivialProducer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>

using namespace oversketch;
using PlanesShown = vtkOversketchProfilePlaneRepresentation;

vtkStandardNewMacro(vtkOversketchProfilePlaneWidget);
oversketchRepresentationMacro(ProfilePlane);

struct vtkOversketchProfilePlaneWidget::Internals
{
  vtkNew<vtkTrivialProducer> port;
  vtkNew<vtkPolyData> mesh, reference, boundary; // no points while there is no region
  vtkNew<vtkOversketchProfilePlanes> planes;
  vtkNew<vtkOversketchCrossSection> section;
  vtkNew<vtkPolyData> flat, onModel;
  vtkSmartPointer<vtkPolyData> moved;
  vtkNew<vtkOversketchProfileRepresentation> profile;
  vtkWeakPointer<vtkRenderer> window;
  vtkWeakPointer<vtkRenderWindowInteractor> heard;
  unsigned long keyTag = 0;
};

namespace
{

// The box of a region, all of a mesh where it says nothing.
void boxOf(vtkPolyData* mesh, double box[6])
{
  vtkDataArray* labels = mesh->GetPointData()->GetArray("EditRegion");
  vtkBoundingBox region;
  for (vtkIdType i = 0; labels && i < mesh->GetNumberOfPoints(); ++i)
  {
    if (labels->GetComponent(i, 0) > 0.0)
    {
      region.AddPoint(mesh->GetPoint(i));
    }
  }
  region.IsValid() ? region.GetBounds(box) : mesh->GetBounds(box);
}

} // namespace

vtkOversketchProfilePlaneWidget::vtkOversketchProfilePlaneWidget()
  : Inner(std::make_unique<Internals>())
{
  Internals& inner = *this->Inner;
  inner.port->SetOutput(this->Profile);
  inner.planes->SetInputData(0, inner.mesh);
  inner.planes->SetReferenceData(inner.reference);
  inner.section->SetInputData(0, inner.mesh);
  inner.section->SetBoundaryData(inner.boundary);
  inner.section->SetPlanesConnection(inner.planes->GetOutputPort());
  this->Pen->CommitOnReleaseOff();
  this->Pen->AddObserver(
    vtkCommand::WidgetValueChangedEvent, this, &vtkOversketchProfilePlaneWidget::TakeStroke);
}

vtkOversketchProfilePlaneWidget::~vtkOversketchProfilePlaneWidget()
{
  this->vtkOversketchProfilePlaneWidget::SetEnabled(0);
  this->vtkOversketchProfilePlaneWidget::SetProfileRenderer(nullptr);
}

bool vtkOversketchProfilePlaneWidget::SetRegion(vtkPolyData* mesh,
  vtkPolyData* reference,
  vtkPolyData* boundary)
{
  this->StopDragging(false);
  Internals& inner = *this->Inner;
  const bool any = mesh && reference && boundary;
  const auto copy = [any](vtkPolyData* from, vtkPolyData* to)
  {
    any ? to->ShallowCopy(from) : to->Initialize();
    to->Modified();
  };
  inner.moved = nullptr;
  copy(mesh, inner.mesh);
  copy(reference, inner.reference);
  copy(boundary, inner.boundary);
  this->ShowRegion();
  const bool cut = this->Cut();
  inner.profile->ResetView();
  return cut || !any;
}

void vtkOversketchProfilePlaneWidget::ShowRegion()
{
  double box[6];
  boxOf(this->Inner->mesh, box);
  this->GetProfilePlaneRepresentation()->SetCurve(this->Inner->reference, box);
}

bool vtkOversketchProfilePlaneWidget::Cut()
{
  Internals& inner = *this->Inner;
  PlanesShown* shown = this->GetProfilePlaneRepresentation();
  Message message;
  inner.flat->Initialize();
  inner.onModel->Initialize();
  vtkPolyData* planes = nullptr;
  if (inner.mesh->GetNumberOfPoints() > 0)
  {
    inner.planes->SetT(this->ProfileAt);
    const auto [placed, aboutPlanes] = runAndReport(inner.planes);
    message = aboutPlanes;
    if (placed)
    {
      planes = inner.planes->GetOutput();
      const auto [cut, aboutSection] = runAndReport(inner.section);
      message = aboutSection.empty() ? message : aboutSection;
      if (cut)
      {
        inner.flat->ShallowCopy(inner.section->GetOutput());
        inner.onModel->ShallowCopy(inner.section->GetSectionOutput());
      }
    }
  }
  this->ShowSection(planes);
  shown->SetText("");
  if (!message.empty())
  {
    this->Tell(message.text());
  }
  this->ShowProfile();
  return inner.flat->GetNumberOfPoints() > 0;
}

// Its places hang on vertices of the mesh, wherever these have gone.
void vtkOversketchProfilePlaneWidget::ShowSection(vtkPolyData* planes)
{
  Internals& inner = *this->Inner;
  vtkNew<vtkPolyData> section;
  section->ShallowCopy(inner.onModel);
  const bool fits = inner.moved && inner.moved->GetNumberOfPoints() == inner.mesh->GetNumberOfPoints();
  if (fits && section->GetNumberOfPoints() > 0)
  {
    vtkDataArray* vertices = section->GetPointData()->GetArray("MeshVertices");
    vtkDataArray* weights = section->GetPointData()->GetArray("MeshWeights");
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < section->GetNumberOfPoints(); ++i)
    {
      double place[3] = { 0.0, 0.0, 0.0 };
      for (int k = 0; k < 3; ++k)
      {
        const double* corner = inner.moved->GetPoint(static_cast<vtkIdType>(vertices->GetComponent(i, k)));
        for (int axis = 0; axis < 3; ++axis)
        {
          place[axis] += weights->GetComponent(i, k) * corner[axis];
        }
      }
      points->InsertNextPoint(place);
    }
    section->SetPoints(points);
  }
  this->GetProfilePlaneRepresentation()->SetSection(planes, section);
}

void vtkOversketchProfilePlaneWidget::ShowSectionOn(vtkPolyData* moved)
{
  Internals& inner = *this->Inner;
  inner.moved = moved;
  const bool any = inner.mesh->GetNumberOfPoints() > 0;
  this->ShowSection(any ? inner.planes->GetOutput() : nullptr);
}

void vtkOversketchProfilePlaneWidget::ShowProfile()
{
  Internals& inner = *this->Inner;
  inner.profile->SetProfile(inner.flat, this->Profile);
  this->ReadyPen();
  if (inner.window && inner.window->GetRenderWindow() && inner.window->GetRenderWindow()->GetInteractor())
  {
    inner.window->GetRenderWindow()->GetInteractor()->Render();
  }
}

void vtkOversketchProfilePlaneWidget::SetProfileAt(double t)
{
  const double at = std::clamp(t, 0.0, 1.0);
  if (at != this->ProfileAt && std::isfinite(at))
  {
    this->StopDragging(false);
    this->ProfileAt = at;
    this->Cut();
    this->Modified();
  }
}

vtkAlgorithmOutput* vtkOversketchProfilePlaneWidget::GetProfilePort()
{
  return this->Inner->port->GetOutputPort();
}

void vtkOversketchProfilePlaneWidget::SetProfile(vtkPolyData* strokes)
{
  putInto(this->Profile, strokesOf(strokes));
  this->ShowProfile();
}

vtkPolyData* vtkOversketchProfilePlaneWidget::GetSectionProfile()
{
  return this->Inner->flat;
}

vtkPolyData* vtkOversketchProfilePlaneWidget::GetSection()
{
  return this->Inner->onModel;
}

vtkOversketchProfileRepresentation* vtkOversketchProfilePlaneWidget::GetProfileRepresentation()
{
  return this->Inner->profile;
}

vtkOversketchStrokeWidget* vtkOversketchProfilePlaneWidget::GetPen()
{
  return this->Pen;
}

vtkRenderer* vtkOversketchProfilePlaneWidget::GetProfileRenderer()
{
  return this->Inner->window;
}

void vtkOversketchProfilePlaneWidget::SetProfileRenderer(vtkRenderer* renderer)
{
  Internals& inner = *this->Inner;
  if (renderer == inner.window)
  {
    return;
  }
  this->Pen->SetEnabled(0);
  if (inner.heard)
  {
    inner.heard->RemoveObserver(inner.keyTag);
  }
  if (inner.window)
  {
    inner.window->RemoveViewProp(inner.profile);
  }
  this->Pen->SetInteractor(nullptr);
  inner.window = renderer;
  inner.heard =
    renderer && renderer->GetRenderWindow() ? renderer->GetRenderWindow()->GetInteractor() : nullptr;
  inner.profile->SetRenderer(renderer);
  if (inner.heard)
  {
    renderer->AddViewProp(inner.profile);
    inner.profile->ResetView();
    inner.keyTag = inner.heard->AddObserver( // after the pen
      vtkCommand::KeyPressEvent,
      this,
      &vtkOversketchProfilePlaneWidget::TakeBack,
      0.4f);
    workIn(renderer, inner.heard, this->Pen);
  }
  this->ReadyPen();
}

void vtkOversketchProfilePlaneWidget::ReadyPen()
{
  if (!this->Pen->IsDrawing())
  {
    this->Pen->SetEnabled(this->Enabled && this->Inner->heard && this->Inner->flat->GetNumberOfPoints() > 0);
  }
}

void vtkOversketchProfilePlaneWidget::SetEnabled(int enabling)
{
  const bool before = this->Enabled;
  if (!enabling && before)
  {
    this->Pen->SetEnabled(0);
    this->Pen->Drop();
  }
  this->Superclass::SetEnabled(enabling);
  if (!before && this->Enabled)
  {
    this->ReadyPen();
  }
}

void vtkOversketchProfilePlaneWidget::TakeStroke()
{
  const vtkSmartPointer<vtkOversketchProfilePlaneWidget> alive(this); // an observer may let go of it
  auto stroke = vtkSmartPointer<vtkPolyData>::New();
  stroke->DeepCopy(this->Pen->GetStroke());
  this->Pen->GetStrokeRepresentation()->Clear(); // from here on it is this widget's
  std::vector<vtkSmartPointer<vtkPolyData>> strokes = strokesOf(this->Profile);
  strokes.push_back(stroke);
  putInto(this->Profile, strokes);
  this->ShowProfile();
  this->ValueChanged();
}

void vtkOversketchProfilePlaneWidget::TakeBack()
{
  const vtkSmartPointer<vtkOversketchProfilePlaneWidget> alive(this); // an observer may let go of it
  std::vector<vtkSmartPointer<vtkPolyData>> strokes = strokesOf(this->Profile);
  if (oversketch::keyOf(this->Inner->heard) == "Escape" && this->Enabled && !strokes.empty() &&
      !this->Pen->IsDrawing() && !this->Pen->IsWaiting())
  {
    strokes.pop_back();
    putInto(this->Profile, strokes);
    this->ShowProfile();
    this->ValueChanged();
  }
}

bool vtkOversketchProfilePlaneWidget::Grasp(int grip, const int at[2])
{
  if (grip == 0)
  {
    return false;
  }
  this->Before = this->ProfileAt;
  std::copy_n(at, 2, this->From);
  this->GetProfilePlaneRepresentation()->SetActiveGrip(grip);
  return true;
}

void vtkOversketchProfilePlaneWidget::Pull(const int at[2])
{
  const bool stays = at[0] == this->From[0] && at[1] == this->From[1];
  const double t =
    stays ? this->Before : this->GetProfilePlaneRepresentation()->GetSlid(this->Before, this->From, at);
  if (t != this->ProfileAt)
  {
    this->ProfileAt = t;
    this->Cut();
  }
}

bool vtkOversketchProfilePlaneWidget::LetGo(bool keep)
{
  if (!keep && this->ProfileAt != this->Before)
  {
    this->ProfileAt = this->Before;
    this->Cut();
  }
  this->GetProfilePlaneRepresentation()->SetActiveGrip(0);
  return this->ProfileAt != this->Before;
}

bool vtkOversketchProfilePlaneWidget::UseKey(const std::string& key)
{
  const std::string digit = key.rfind("KP_", 0) == 0 ? key.substr(3) : key;
  const std::size_t which = std::string("67890").find(digit);
  if (digit.size() != 1 || which == std::string::npos || this->Interactor->GetControlKey() ||
      this->Interactor->GetAltKey() || this->Interactor->GetShiftKey())
  {
    return false;
  }
  for (const int plane : { PlanesShown::N, PlanesShown::T, PlanesShown::B })
  {
    this->GetProfilePlaneRepresentation()->SetPlaneVisibility(
      plane, digit == "6" || (digit != "0" && plane == static_cast<int>(which) - 1));
  }
  this->Render();
  return true;
}

void vtkOversketchProfilePlaneWidget::SetRepresentation(
  vtkOversketchProfilePlaneRepresentation* representation)
{
  this->StopDragging(false);
  this->SetWidgetRepresentation(representation);
  this->ShowRegion();
  this->Cut();
}

void vtkOversketchProfilePlaneWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProfileAt: " << this->ProfileAt << "\n";
  os << indent << "Profile: " << this->Profile->GetNumberOfLines() << " strokes\n";
}
