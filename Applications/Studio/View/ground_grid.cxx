#include "ground_grid.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace oversketch_studio
{

namespace
{

constexpr double across = 10.0; // lines for the model's width, about

// 1, 2 or 5 times a power of ten.
double roundNumber(double about)
{
  const double ten = std::pow(10.0, std::floor(std::log10(about)));
  const double of = about / ten;
  return ten * (of < 1.5 ? 1.0 : of < 3.5 ? 2.0 : of < 7.5 ? 5.0 : 10.0);
}

// Across the axis that is up: from places on x and the other axis.
void addLine(vtkPolyData* to, int up, double x0, double other0, double x1, double other1, double height)
{
  const auto add = [&](double x, double other)
  {
    return up == 1 ? to->GetPoints()->InsertNextPoint(x, height, other)
                   : to->GetPoints()->InsertNextPoint(x, other, height);
  };
  const vtkIdType from = add(x0, other0);
  to->GetLines()->InsertNextCell({ from, add(x1, other1) });
}

} // namespace

GroundGrid::GroundGrid(vtkRenderer* renderer)
{
  const auto show = [&](vtkPolyData* lines, vtkActor* actor)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(lines);
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    actor->VisibilityOff();
    renderer->AddActor(actor);
  };
  show(this->Lines, this->LineActor);
  show(this->Middle, this->MiddleActor);
}

GroundGrid::~GroundGrid() = default;

void GroundGrid::place(const double box[6], int up)
{
  const int beside = 3 - up;
  const double width = std::max(box[1] - box[0], box[2 * beside + 1] - box[2 * beside]);
  for (vtkPolyData* lines : { this->Lines.Get(), this->Middle.Get() })
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    lines->SetPoints(points);
    lines->SetLines(cells);
  }
  if (!(width > 0.0) || !std::isfinite(width))
  {
    return;
  }
  const double step = roundNumber(width / across), height = box[2 * up];
  const auto first = [&](int axis) { return std::floor((box[2 * axis] - 0.5 * width) / step); };
  const auto last = [&](int axis) { return std::ceil((box[2 * axis + 1] + 0.5 * width) / step); };
  const double x0 = first(0), x1 = last(0), z0 = first(beside), z1 = last(beside);
  for (double i = x0; i <= x1; ++i)
  {
    addLine(i == 0.0 ? this->Middle : this->Lines, up, i * step, z0 * step, i * step, z1 * step, height);
  }
  for (double i = z0; i <= z1; ++i)
  {
    addLine(i == 0.0 ? this->Middle : this->Lines, up, x0 * step, i * step, x1 * step, i * step, height);
  }
}

void GroundGrid::setVisible(bool visible)
{
  this->LineActor->SetVisibility(visible);
  this->MiddleActor->SetVisibility(visible);
}

void GroundGrid::setDark(bool dark)
{
  const double line = dark ? 0.30 : 0.70, middle = dark ? 0.45 : 0.52;
  this->LineActor->GetProperty()->SetColor(line, line, line);
  this->MiddleActor->GetProperty()->SetColor(middle, middle, middle);
}

} // namespace oversketch_studio
