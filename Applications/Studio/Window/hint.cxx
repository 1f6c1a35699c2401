#include "hint.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace oversketch_studio
{

namespace
{

// px as Qt counts them.
constexpr double gap = 12.0;
constexpr double dash = 14.0; // with the gap after it
constexpr int letters = 18, legible = 12, leastLetters = 7;

// On two lines of about the same length, where it has a blank.
std::string onTwoLines(std::string text)
{
  std::size_t best = std::string::npos;
  const auto off = [&](std::size_t at)
  { return std::abs(2.0 * static_cast<double>(at) - static_cast<double>(text.size())); };
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1))
  {
    best = best == std::string::npos || off(at) < off(best) ? at : best;
  }
  if (best != std::string::npos)
  {
    text[best] = '\n';
  }
  return text;
}

} // namespace

Hint::Hint()
{
  vtkTextProperty* look = this->Text->GetTextProperty();
  look->SetJustificationToCentered();
  look->SetVerticalJustificationToBottom();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Dashes);
  this->Line->SetMapper(mapper);
  this->Line->GetProperty()->SetColor(0.86, 0.13, 0.12); // the pen's
  this->setVisible(false);
}

Hint::~Hint() = default;

void Hint::addTo(vtkRenderer* renderer)
{
  renderer->AddActor2D(this->Line);
  renderer->AddActor2D(this->Text);
}

void Hint::setText(const std::string& text, HintShape shape)
{
  this->Words = text;
  this->Shape = shape;
  this->Text->SetInput(text.c_str());
  this->setVisible(!text.empty());
}

void Hint::setVisible(bool visible)
{
  this->Text->SetVisibility(visible);
  this->Line->SetVisibility(visible);
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

void Hint::place(vtkRenderer* renderer, vtkPolyData* mesh, double ratio, const std::vector<Box>& taken)
{
  if (!this->isVisible() || !mesh)
  {
    return;
  }
  oversketch::Polyline picture;
  picture.reserve(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    renderer->SetWorldPoint(p[0], p[1], p[2], 1.0);
    renderer->WorldToDisplay();
    picture.emplace_back(renderer->GetDisplayPoint()[0], renderer->GetDisplayPoint()[1]);
  }
  const oversketch::Polyline line = hintLine(this->Shape, picture, ratio);
  if (line.empty())
  {
    return;
  }
  const auto higher = [](const oversketch::Vector2& a, const oversketch::Vector2& b) { return a[1] < b[1]; };
  // Not on the model, where it would not be read.
  const oversketch::Vector2 top = *std::max_element(line.begin(), line.end(), higher);
  const double above =
    this->Shape == HintShape::Limb ? top[1] : (*std::max_element(picture.begin(), picture.end(), higher))[1];
  const std::vector<double> lengths = oversketch::arcLengths(line);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  constexpr double painted = 0.6; // of a dash and the gap after it
  const int dashes = std::max(7, static_cast<int>(lengths.back() / (dash * ratio)));
  for (int i = 0; i < dashes; ++i)
  {
    lines->InsertNextCell(2);
    for (const double end : { 0.0, painted })
    {
      const double length = lengths.back() * (i + end) / (dashes - 1 + painted);
      const oversketch::Vector2 place =
        oversketch::placeAt(lengths, static_cast<int>(line.size()), length).of(line);
      lines->InsertCellPoint(points->InsertNextPoint(place[0], place[1], 0.0));
    }
  }
  this->Dashes->SetPoints(points);
  this->Dashes->SetLines(lines);
  this->Line->GetProperty()->SetLineWidth(static_cast<float>(3.0 * ratio));
  this->placeText(renderer, { top[0], above + gap * ratio }, ratio, taken);
}

void Hint::placeText(vtkRenderer* renderer,
  const oversketch::Vector2& over,
  double ratio,
  const std::vector<Box>& taken)
{
  vtkTextProperty* look = this->Text->GetTextProperty();
  const int* size = renderer->GetSize();
  const double space = gap * ratio;
  double extent[2], low = 0.0, left = 0.0, right = 0.0;
  const auto fit = [&]
  { return static_cast<int>(letters * (right - left - 2.0 * space) / std::max(1.0, extent[0])); };
  const auto write = [&](const std::string& text)
  {
    this->Text->SetInput(text.c_str());
    look->SetFontSize(letters);
    this->Text->GetSize(renderer, extent);
    low = std::min(over[1], size[1] - extent[1] - space);
    left = 0.0;
    right = size[0];
    for (const Box& box : taken)
    {
      if (box.top > low - space && box.bottom < low + extent[1] + space)
      {
        box.left + box.right > size[0] ? right = std::min(right, box.left) : left = std::max(left, box.right);
      }
    }
  };
  write(this->Words);
  if (fit() < letters)
  {
    write(onTwoLines(this->Words));
  }
  if (fit() < legible)
  {
    for (const Box& box : taken)
    {
      low = std::min(low, box.bottom - space - extent[1]);
    }
    left = 0.0;
    right = size[0];
  }
  if (fit() < letters)
  {
    look->SetFontSize(std::max(leastLetters, fit()));
    this->Text->GetSize(renderer, extent);
  }
  const double half = 0.5 * extent[0];
  const double middle = std::max(left + half + space, std::min(over[0], right - half - space));
  this->Text->SetPosition(middle, low);
  this->Written = { middle - half, middle + half, low, low + extent[1] };
}

} // namespace oversketch_studio
