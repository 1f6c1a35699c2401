#include "hint_line.h"

#include <algorithm>
#include <cmath>

namespace oversketch_studio
{

namespace
{

using oversketch::Polyline;
using oversketch::Vector2;

// px as Qt counts them.
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

} // namespace oversketch_studio
