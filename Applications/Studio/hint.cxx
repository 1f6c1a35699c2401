#include "hint.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace oversketch_studio
{

namespace
{

// px as Qt counts them.
constexpr double archWidth = 48.0, archHeight = 72.0, archBelow = 24.0, gap = 12.0;
constexpr int dashes = 13;

} // namespace

Hint::Hint()
{
  vtkTextProperty* look = this->Text->GetTextProperty();
  look->SetJustificationToCentered();
  look->SetVerticalJustificationToBottom();
  look->SetFontSize(18);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Dashes);
  this->Arch->SetMapper(mapper);
  this->Arch->GetProperty()->SetColor(0.86, 0.13, 0.12); // the pen's
  this->setVisible(false);
}

Hint::~Hint() = default;

void Hint::addTo(vtkRenderer* renderer)
{
  renderer->AddActor2D(this->Arch);
  renderer->AddActor2D(this->Text);
}

void Hint::setText(const std::string& text)
{
  this->Text->SetInput(text.c_str());
  this->setVisible(!text.empty());
}

void Hint::setVisible(bool visible)
{
  this->Text->SetVisibility(visible);
  this->Arch->SetVisibility(visible);
}

bool Hint::isVisible() const
{
  return this->Text->GetVisibility();
}

void Hint::setDark(bool dark)
{
  const double grey = dark ? 0.95 : 0.1;
  this->Text->GetTextProperty()->SetColor(grey, grey, grey);
}

void Hint::place(vtkRenderer* renderer, vtkPolyData* mesh, double ratio)
{
  if (!this->isVisible() || !mesh)
  {
    return;
  }
  double highest[3] = { 0.0, -VTK_DOUBLE_MAX, 0.0 };
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    renderer->SetWorldPoint(p[0], p[1], p[2], 1.0);
    renderer->WorldToDisplay();
    double display[3];
    renderer->GetDisplayPoint(display);
    if (display[1] > highest[1])
    {
      std::copy(display, display + 3, highest);
    }
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (int i = 0; i < dashes; ++i)
  {
    lines->InsertNextCell(2);
    for (const double end : { 0.0, 0.6 })
    {
      const double turn = vtkMath::Pi() * (i + end) / (dashes - 0.4);
      lines->InsertCellPoint(points->InsertNextPoint(highest[0] - 0.5 * archWidth * ratio * std::cos(turn),
        highest[1] + ratio * (archHeight * std::sin(turn) - archBelow),
        0.0));
    }
  }
  this->Dashes->SetPoints(points);
  this->Dashes->SetLines(lines);
  this->Arch->GetProperty()->SetLineWidth(static_cast<float>(3.0 * ratio));
  double extent[2];
  this->Text->GetSize(renderer, extent);
  const double half = 0.5 * extent[0] + gap * ratio;
  const int* size = renderer->GetSize();
  this->Text->SetPosition(std::max(half, std::min(highest[0], size[0] - half)),
    std::min(highest[1] + (archHeight - archBelow + gap) * ratio, size[1] - extent[1] - gap * ratio));
}

} // namespace oversketch_studio
