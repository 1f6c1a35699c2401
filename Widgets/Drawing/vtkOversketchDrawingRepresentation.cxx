#include "vtkOversketchDrawingRepresentation.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkImageProperty.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegularPolygonSource.h"
#include "vtkSmartPointer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkOversketchDrawingRepresentation);

namespace
{

using Colour = std::array<unsigned char, 4>;

// By Role, and by Treatment.
Colour lineColour(int role)
{
  switch (role)
  {
    case 1:
      return { 217, 26, 26, 255 };
    case 2:
      return { 26, 90, 217, 255 };
    case 3:
      return { 20, 145, 60, 255 };
    case -1:
      return { 128, 128, 128, 255 };
    default:
      return { 20, 20, 20, 255 };
  }
}

constexpr Colour faultColour = { 250, 140, 20, 255 };
constexpr Colour layerColour = { 175, 30, 190, 255 }, twinColour = { 60, 10, 75, 255 };
constexpr double ringShare = 0.02; // of the canvas, the radius of the ring about a fault
constexpr int checksAcross = 32;   // of the longer side

// A picture with the proportions of a canvas.
vtkSmartPointer<vtkImageData> checkerboard(double width, double height)
{
  const double longest = std::max(width, height);
  const auto count = [&](double side)
  { return std::max(1, static_cast<int>(std::lround(checksAcross * side / longest))); };
  auto board = vtkSmartPointer<vtkImageData>::New();
  board->SetDimensions(count(width), count(height), 1);
  board->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* grey = static_cast<unsigned char*>(board->GetScalarPointer());
  for (int y = 0; y < count(height); ++y)
  {
    for (int x = 0; x < count(width); ++x)
    {
      *grey++ = (x + y) % 2 == 0 ? 205 : 235;
    }
  }
  return board;
}

Colour regionColour(int treatment)
{
  return treatment == 1 ? Colour{ 40, 40, 46, 165 } : Colour{ 120, 50, 165, 125 };
}

int labelOf(vtkPolyData* curves, const char* name, vtkIdType cell)
{
  vtkDataArray* array = curves->GetCellData()->GetArray(name);
  return array && cell < array->GetNumberOfTuples() ? static_cast<int>(array->GetComponent(cell, 0)) : 0;
}

// Polygons or lines with a colour each.
struct Coloured
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;

  explicit Coloured(vtkPolyData* curves)
  {
    this->data->SetPoints(curves->GetPoints());
    this->colours->SetName("Colour");
    this->colours->SetNumberOfComponents(4);
    this->data->GetCellData()->SetScalars(this->colours);
  }
  void add(vtkIdList* ids, const Colour& colour)
  {
    this->cells->InsertNextCell(ids);
    this->colours->InsertNextTypedTuple(colour.data());
  }
  // A line in dashes, of two colours in turn; none of the second where that is
  // transparent.
  void addDashed(vtkIdList* ids, const Colour& first, const Colour& second)
  {
    constexpr vtkIdType samples = 3;
    const vtkIdType last = ids->GetNumberOfIds() - 1;
    for (vtkIdType i = 0; i < last; i += samples)
    {
      const Colour& colour = i / samples % 2 == 0 ? first : second;
      if (colour[3] != 0)
      {
        this->cells->InsertNextCell(static_cast<int>(std::min(samples, last - i)) + 1);
        for (vtkIdType k = i; k <= std::min(i + samples, last); ++k)
        {
          this->cells->InsertCellPoint(ids->GetId(k));
        }
        this->colours->InsertNextTypedTuple(colour.data());
      }
    }
  }
};

} // namespace

struct vtkOversketchDrawingRepresentation::Internals
{
  vtkNew<vtkImageActor> picture;
  vtkNew<vtkPlaneSource> canvas;
  vtkNew<vtkActor> paper, regions, curves, mark;
  vtkNew<vtkPolyDataMapper> regionMapper, curveMapper;
  vtkNew<vtkRegularPolygonSource> ring;
  vtkNew<vtkTexture> checks;
  int fault = -1;
  vtkNew<vtkTextActor> text;
  double box[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 0.0 };

  // Regions over the canvas and curves over both, seen from straight above at any zoom.
  void layUp()
  {
    const double longest = std::max(this->box[1] - this->box[0], this->box[3] - this->box[2]);
    this->regions->SetPosition(0.0, 0.0, 1e-3 * longest);
    this->curves->SetPosition(0.0, 0.0, 2e-3 * longest);
    this->paper->SetPosition(0.0, 0.0, this->picture->GetVisibility() ? -1e-3 * longest : 0.0);
    this->ring->SetRadius(ringShare * longest);
  }
};

vtkOversketchDrawingRepresentation::vtkOversketchDrawingRepresentation()
  : Inner(std::make_unique<Internals>())
{
  Internals& inner = *this->Inner;
  inner.picture->GetMapper()->BorderOn();
  inner.picture->VisibilityOff();
  vtkNew<vtkPolyDataMapper> paper;
  paper->SetInputConnection(inner.canvas->GetOutputPort());
  inner.paper->SetMapper(paper);
  inner.regions->SetMapper(inner.regionMapper);
  inner.regions->ForceOpaqueOn(); // blended all the same, in the order of RenderOpaqueGeometry
  inner.curves->SetMapper(inner.curveMapper);
  inner.checks->InterpolateOff();
  inner.checks->SetColorModeToDirectScalars();
  inner.ring->SetNumberOfSides(32);
  inner.ring->GeneratePolygonOff();
  vtkNew<vtkPolyDataMapper> ring;
  ring->SetInputConnection(inner.ring->GetOutputPort());
  inner.mark->SetMapper(ring);
  inner.mark->GetProperty()->SetColor(faultColour[0] / 255.0, faultColour[1] / 255.0, faultColour[2] / 255.0);
  inner.mark->GetProperty()->SetLineWidth(4.0f);
  inner.mark->VisibilityOff();
  for (vtkActor* actor : { inner.paper.Get(), inner.regions.Get(), inner.curves.Get(), inner.mark.Get() })
  {
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
  }
  inner.curves->GetProperty()->SetLineWidth(3.0f);
  inner.regions->VisibilityOff();
  inner.curves->VisibilityOff();
  inner.text->SetPosition(10, 10);
  inner.text->GetTextProperty()->SetFontSize(14);
  inner.text->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
  inner.text->GetTextProperty()->SetBackgroundColor(1.0, 1.0, 1.0);
  inner.text->GetTextProperty()->SetBackgroundOpacity(0.8);
  this->SetCanvas(0.0, 0.0, 1.0, 1.0);
}

vtkOversketchDrawingRepresentation::~vtkOversketchDrawingRepresentation() = default;

void vtkOversketchDrawingRepresentation::SetPicture(vtkImageData* picture)
{
  Internals& inner = *this->Inner;
  inner.picture->SetInputData(picture);
  inner.picture->SetVisibility(picture != nullptr);
  const int parts = picture ? picture->GetNumberOfScalarComponents() : 0;
  const bool isCutOut = parts == 2 || parts == 4;
  inner.paper->SetVisibility(!picture || isCutOut);
  inner.paper->SetTexture(nullptr);
  if (picture)
  {
    picture->GetBounds(inner.box);
    for (int axis = 0; axis < 2; ++axis) // samples are squares
    {
      inner.box[2 * axis] -= 0.5 * picture->GetSpacing()[axis];
      inner.box[2 * axis + 1] += 0.5 * picture->GetSpacing()[axis];
    }
  }
  if (isCutOut)
  {
    const double* box = inner.box;
    inner.canvas->SetOrigin(box[0], box[2], 0.0);
    inner.canvas->SetPoint1(box[1], box[2], 0.0);
    inner.canvas->SetPoint2(box[0], box[3], 0.0);
    inner.checks->SetInputData(checkerboard(box[1] - box[0], box[3] - box[2]));
    inner.paper->SetTexture(inner.checks);
  }
  this->Inner->layUp();
  this->Modified();
}

void vtkOversketchDrawingRepresentation::SetCanvas(double x, double y, double width, double height)
{
  Internals& inner = *this->Inner;
  this->SetPicture(nullptr);
  inner.canvas->SetOrigin(x, y, 0.0);
  inner.canvas->SetPoint1(x + width, y, 0.0);
  inner.canvas->SetPoint2(x, y + height, 0.0);
  const std::array<double, 6> box = { x, x + width, y, y + height, 0.0, 0.0 };
  std::copy(box.begin(), box.end(), inner.box);
  inner.layUp();
}

void vtkOversketchDrawingRepresentation::SetCurves(vtkPolyData* curves)
{
  Internals& inner = *this->Inner;
  const bool any = curves && curves->GetNumberOfLines() > 0;
  inner.curves->SetVisibility(any);
  inner.regions->VisibilityOff();
  if (any)
  {
    Coloured lines(curves), regions(curves);
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < curves->GetNumberOfLines(); ++cell)
    {
      curves->GetLines()->GetCellAtId(cell, ids);
      const int role = labelOf(curves, "Role", cell), treatment = labelOf(curves, "Treatment", cell);
      const bool isFault = inner.fault >= 0 && labelOf(curves, "StrokeId", cell) == inner.fault;
      const int depth = role == 1 ? labelOf(curves, "Depth", cell) : 0;
      const Colour colour = isFault ? faultColour : depth > 0 ? layerColour : lineColour(role);
      depth > 1 ? lines.addDashed(ids, colour, depth == 3 ? twinColour : Colour{}) : lines.add(ids, colour);
      if (role == 2 && treatment != 0 && ids->GetNumberOfIds() > 3)
      {
        ids->SetNumberOfIds(ids->GetNumberOfIds() - 1); // the first one once more
        regions.add(ids, regionColour(treatment));
      }
    }
    lines.data->SetLines(lines.cells);
    regions.data->SetPolys(regions.cells);
    inner.curveMapper->SetInputData(lines.data);
    vtkNew<vtkTriangleFilter> triangles; // regions are not convex
    triangles->SetInputData(regions.data);
    triangles->Update();
    inner.regionMapper->SetInputData(triangles->GetOutput());
    inner.regions->SetVisibility(regions.cells->GetNumberOfCells() > 0);
  }
  this->Modified();
}

void vtkOversketchDrawingRepresentation::SetFault(int stroke, const double place[2])
{
  Internals& inner = *this->Inner;
  inner.fault = stroke;
  inner.mark->SetVisibility(place != nullptr);
  if (place)
  {
    inner.ring->SetCenter(place[0], place[1], 0.0);
    inner.mark->SetPosition(0.0, 0.0, inner.curves->GetPosition()[2]);
  }
  this->Modified();
}

void vtkOversketchDrawingRepresentation::SetText(const char* text)
{
  if (this->GetText() != std::string(text ? text : ""))
  {
    this->Inner->text->SetInput(text ? text : "");
    this->Modified();
  }
}

const char* vtkOversketchDrawingRepresentation::GetText()
{
  return this->Inner->text->GetInput() ? this->Inner->text->GetInput() : "";
}

vtkProperty* vtkOversketchDrawingRepresentation::GetCurveProperty()
{
  return this->Inner->curves->GetProperty();
}

void vtkOversketchDrawingRepresentation::BuildRepresentation() {}

double* vtkOversketchDrawingRepresentation::GetBounds()
{
  return this->Inner->box;
}

void vtkOversketchDrawingRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& inner = *this->Inner;
  inner.picture->ReleaseGraphicsResources(window);
  for (vtkActor* actor : { inner.paper.Get(), inner.regions.Get(), inner.curves.Get(), inner.mark.Get() })
  {
    actor->ReleaseGraphicsResources(window);
  }
  inner.text->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

int vtkOversketchDrawingRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  Internals& inner = *this->Inner;
  int drawn = inner.paper->GetVisibility() ? inner.paper->RenderOpaqueGeometry(viewport) : 0;
  if (inner.picture->GetVisibility())
  {
    inner.picture->Update();
    // A picture with alpha is see-through; it is under all else all the same, so it is drawn first.
    drawn += inner.picture->HasTranslucentPolygonalGeometry()
               ? inner.picture->RenderTranslucentPolygonalGeometry(viewport)
               : inner.picture->RenderOpaqueGeometry(viewport);
  }
  drawn += inner.regions->GetVisibility() ? inner.regions->RenderOpaqueGeometry(viewport) : 0;
  if (this->GetText()[0] != '\0')
  {
    inner.text->RenderOpaqueGeometry(viewport); // makes what its overlay shows
  }
  drawn += inner.curves->GetVisibility() ? inner.curves->RenderOpaqueGeometry(viewport) : 0;
  return drawn + (inner.mark->GetVisibility() ? inner.mark->RenderOpaqueGeometry(viewport) : 0);
}

int vtkOversketchDrawingRepresentation::RenderOverlay(vtkViewport* viewport)
{
  return this->GetText()[0] != '\0' ? this->Inner->text->RenderOverlay(viewport) : 0;
}

void vtkOversketchDrawingRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Picture: " << (this->Inner->picture->GetVisibility() ? "shown" : "(none)") << "\n";
  os << indent << "Text: " << this->GetText() << "\n";
}
