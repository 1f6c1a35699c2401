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

using oversketch::Polyline;
using oversketch::Vector2;

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

// px of the lines that are drawn, as Qt counts them.
constexpr double levelStep = 4.0; // from level to level
constexpr double deepest = 72.0;  // that the line reaches down
constexpr double further = 34.0;  // that the tip goes out
constexpr double beside = 3.0;    // the line lies so far outside the limb
constexpr double widening = 8.0;  // more than that at one level is no longer the limb
constexpr double narrowest = 8.0;
// Halves of a line on the body and of a ring round it, in widths of the picture.
constexpr double lineHalf = 0.055;
constexpr double ringHalf[2] = { 0.118, 0.063 };
constexpr int samples = 48;

// The limb's two sides at a level.
struct Level
{
  double left, right, y;
  Vector2 middle() const { return Vector2(0.5 * (this->left + this->right), this->y); }
  double half() const { return 0.5 * (this->right - this->left); }
};

// From the tip down, as far as it is one limb.
std::vector<Level> levelsUnder(const Vector2& tip, const Polyline& picture, double ratio)
{
  std::vector<Level> levels;
  Level above{ tip[0] - 0.5 * narrowest * ratio, tip[0] + 0.5 * narrowest * ratio, tip[1] };
  for (double down = levelStep; down <= deepest; down += levelStep)
  {
    Level level{ above.right, above.left, tip[1] - down * ratio };
    const double reach = widening * ratio;
    for (const Vector2& p : picture)
    {
      if (std::abs(p[1] - level.y) <= levelStep * ratio && p[0] >= above.left - 2.0 * reach &&
          p[0] <= above.right + 2.0 * reach)
      {
        level.left = std::min(level.left, p[0]);
        level.right = std::max(level.right, p[0]);
      }
    }
    const bool ends =
      level.left > level.right || level.left < above.left - reach || level.right > above.right + reach;
    if (ends)
    {
      break;
    }
    levels.push_back(level);
    above = level;
  }
  return levels;
}

} // namespace

Polyline hintLine(const Polyline& picture, double ratio)
{
  if (picture.empty())
  {
    return {};
  }
  const auto higher = [](const Vector2& a, const Vector2& b) { return a[1] < b[1]; };
  const Vector2 tip = *std::max_element(picture.begin(), picture.end(), higher);
  std::vector<Level> levels = levelsUnder(tip, picture, ratio);
  while (levels.size() < 3) // no limb: a small arch
  {
    const double y = tip[1] - levelStep * ratio * static_cast<double>(levels.size() + 1);
    levels.push_back({ tip[0] - narrowest * ratio, tip[0] + narrowest * ratio, y });
  }
  const Vector2 out = further * ratio * (tip - levels.back().middle()).normalized();
  // The half of the limb that lies farther out goes with the tip.
  const std::size_t moved = levels.size() / 2;
  Polyline left, right;
  for (std::size_t i = levels.size(); i-- > 0;)
  {
    const Vector2 shift = i < moved ? out : Vector2::Zero();
    const Vector2 across(levels[i].half() + beside * ratio, 0.0);
    left.emplace_back(levels[i].middle() - across + shift);
    right.emplace_back(levels[i].middle() + across + shift);
  }
  // Without the corner between what stays and what goes.
  Polyline line = left;
  line.emplace_back(tip + out + Vector2(0.0, beside * ratio));
  line.insert(line.end(), right.rbegin(), right.rend());
  for (int pass = 0; pass < 3; ++pass)
  {
    Polyline smooth = line;
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
    {
      smooth[i] = 0.25 * line[i - 1] + 0.5 * line[i] + 0.25 * line[i + 1];
    }
    line = smooth;
  }
  return line;
}

Polyline hintLine(HintShape shape, const Polyline& picture, double ratio)
{
  if (shape == HintShape::Limb || picture.empty())
  {
    return hintLine(picture, ratio);
  }
  Vector2 least = picture[0], most = picture[0];
  for (const Vector2& p : picture)
  {
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  const double wide = most[0] - least[0];
  const Vector2 middle = 0.5 * (least + most) + wide * Vector2(-0.0315, 0.0315); // of a body over legs
  Polyline line;
  if (shape == HintShape::Line)
  {
    for (int i = 0; i <= samples; ++i)
    {
      const double t = 2.0 * i / samples - 1.0;
      line.emplace_back(middle + wide * Vector2(lineHalf * t, 0.0));
    }
    return line;
  }
  for (int i = 0; i <= samples; ++i)
  {
    const double angle = 2.0 * static_cast<double>(EIGEN_PI) * i / samples;
    line.emplace_back(middle + wide * Vector2(ringHalf[0] * std::cos(angle), ringHalf[1] * std::sin(angle)));
  }
  return line;
}

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
  Polyline picture;
  picture.reserve(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    renderer->SetWorldPoint(p[0], p[1], p[2], 1.0);
    renderer->WorldToDisplay();
    picture.emplace_back(renderer->GetDisplayPoint()[0], renderer->GetDisplayPoint()[1]);
  }
  const Polyline line = hintLine(this->Shape, picture, ratio);
  if (line.empty())
  {
    return;
  }
  const auto higher = [](const Vector2& a, const Vector2& b) { return a[1] < b[1]; };
  // Not on the model, where it would not be read.
  const Vector2 top = *std::max_element(line.begin(), line.end(), higher);
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
      const Vector2 place = oversketch::placeAt(lengths, static_cast<int>(line.size()), length).of(line);
      lines->InsertCellPoint(points->InsertNextPoint(place[0], place[1], 0.0));
    }
  }
  this->Dashes->SetPoints(points);
  this->Dashes->SetLines(lines);
  this->Line->GetProperty()->SetLineWidth(static_cast<float>(3.0 * ratio));
  this->placeText(renderer, { top[0], above + gap * ratio }, ratio, taken);
}

void Hint::placeText(vtkRenderer* renderer, const Vector2& over, double ratio, const std::vector<Box>& taken)
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
