#include "vtkOversketchAreaSelectWidget.h"

#include "vtkOversketchAreaSelectRepresentation.h"
#include "vtkOversketchStrokeWidget.h"
#include "widget_events.h"

#include "Mesh/context.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchAreaSelectWidget);
oversketchRepresentationMacro(AreaSelect);

struct vtkOversketchAreaSelectWidget::Internals
{
  vtkNew<vtkTrivialProducer> port;
};

namespace
{

constexpr int mostAreas = 64; // of vtkOversketchScanFill
constexpr double texels = 512.0;

// The first `count` polylines of some, and all of another, with points of their own.
void putTogether(vtkPolyData* some, vtkIdType count, vtkPolyData* another, vtkPolyData* result)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdList> ids;
  const auto add = [&](vtkPolyData* from, vtkIdType number)
  {
    for (vtkIdType i = 0; from && i < std::min(number, from->GetNumberOfLines()); ++i)
    {
      from->GetLines()->GetCellAtId(i, ids);
      lines->InsertNextCell(static_cast<int>(ids->GetNumberOfIds()));
      for (const vtkIdType id : *ids)
      {
        lines->InsertCellPoint(points->InsertNextPoint(from->GetPoint(id)));
      }
    }
  };
  add(some, count);
  add(another, mostAreas);
  result->Initialize();
  if (points->GetNumberOfPoints() > 0)
  {
    result->SetPoints(points);
    result->SetLines(lines);
  }
}

} // namespace

vtkOversketchAreaSelectWidget::vtkOversketchAreaSelectWidget()
  : Inner(std::make_unique<Internals>())
{
  this->Inner->port->SetOutput(this->Areas);
}

vtkOversketchAreaSelectWidget::~vtkOversketchAreaSelectWidget() = default;

vtkAlgorithmOutput* vtkOversketchAreaSelectWidget::GetAreasPort()
{
  return this->Inner->port->GetOutputPort();
}

bool vtkOversketchAreaSelectWidget::SetRegion(vtkPolyData* mesh)
{
  this->GetPen()->CancelStroke();
  const bool fits = this->GetAreaSelectRepresentation()->SetRegion(mesh);
  this->ReadyPen();
  return fits;
}

void vtkOversketchAreaSelectWidget::Publish(vtkPolyData* areas)
{
  this->Areas->ShallowCopy(areas);
  this->Areas->Modified();
  vtkOversketchAreaSelectRepresentation* shown = this->GetAreaSelectRepresentation();
  shown->SetAreas(this->Areas);
  shown->SetArea(static_cast<int>(this->Areas->GetNumberOfLines()) - 1);
  this->Render();
}

void vtkOversketchAreaSelectWidget::SetAreas(vtkPolyData* areas)
{
  vtkNew<vtkPolyData> copy;
  putTogether(areas, mostAreas, nullptr, copy);
  this->Publish(copy);
}

bool vtkOversketchAreaSelectWidget::Wants(bool over)
{
  return !over && this->GetAreaSelectRepresentation()->HasRegion();
}

bool vtkOversketchAreaSelectWidget::TakeStroke(vtkPolyData* stroke, bool)
{
  vtkNew<vtkPolyData> area;
  try
  {
    this->GetAreaSelectRepresentation()->PutOnDisc(stroke, area);
  }
  catch (const Error& error)
  {
    this->Tell(error.what());
    return false;
  }
  std::set<std::array<long, 2>> distinct; // texels
  for (vtkIdType i = 0; i < area->GetNumberOfPoints(); ++i)
  {
    const double* p = area->GetPoint(i);
    distinct.insert({ std::lround(0.5 * texels * p[0]), std::lround(0.5 * texels * p[1]) });
  }
  if (distinct.size() < 3 || this->Areas->GetNumberOfLines() >= mostAreas)
  {
    this->Tell(distinct.size() < 3
                 ? "This lasso holds nothing of the region: draw it round a part of the region."
                 : "There are 64 areas, as many as can be: take one back first.");
    this->Render();
    return false;
  }
  vtkNew<vtkPolyData> all;
  putTogether(this->Areas, mostAreas, area, all);
  this->Publish(all);
  return true;
}

bool vtkOversketchAreaSelectWidget::TakeBack()
{
  const vtkIdType count = this->Areas->GetNumberOfLines();
  if (count == 0)
  {
    return false;
  }
  vtkNew<vtkPolyData> all;
  putTogether(this->Areas, count - 1, nullptr, all);
  this->Publish(all);
  return true;
}

void vtkOversketchAreaSelectWidget::ShowText(const std::string& text)
{
  this->GetAreaSelectRepresentation()->SetText(text.c_str());
}

void vtkOversketchAreaSelectWidget::SetRepresentation(vtkOversketchAreaSelectRepresentation* representation)
{
  this->SetWidgetRepresentation(representation);
  this->GetAreaSelectRepresentation()->SetAreas(this->Areas);
}

void vtkOversketchAreaSelectWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Areas: " << this->Areas->GetNumberOfLines() << "\n";
}
