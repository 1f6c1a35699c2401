#include "Raster/thing.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace oversketch
{
namespace
{

constexpr int halfCovered = 128;
constexpr double evenGround = 12.0, groundShare = 0.6; // of Lab; of the border's pixels
constexpr int marked = 77;                             // neither 0 nor 255

// Colours as CIE Lab in bytes, without specks of a pixel.
cv::Mat3b labOf(const cv::Mat3b& colours)
{
  cv::Mat3b calm, lab;
  cv::medianBlur(colours, calm, 3);
  cv::cvtColor(calm, lab, cv::COLOR_RGB2Lab);
  return lab;
}

double difference(const cv::Vec3b& one, const cv::Vec3b& other)
{
  const double light = (one[0] - other[0]) * (100.0 / 255.0), red = one[1] - other[1],
               yellow = one[2] - other[2];
  return std::sqrt(light * light + red * red + yellow * yellow);
}

// How far pixels are from a colour, in halves of a unit of Lab.
constexpr double halves = 2.0;

cv::Mat1b differences(const cv::Mat3b& lab, const cv::Vec3b& colour, const Context& context)
{
  cv::Mat1b made(lab.size());
  context.each(lab.rows,
    [&](int y)
    {
      for (int x = 0; x < lab.cols; ++x)
      {
        made(y, x) = cv::saturate_cast<std::uint8_t>(halves * difference(lab(y, x), colour));
      }
    });
  return made;
}

// An even ground at the picture's border: its colour, and how far its pixels differ from that.
struct Ground
{
  cv::Vec3b colour;
  double spread = 0.0;
};

std::optional<Ground> groundOf(const cv::Mat3b& lab)
{
  std::vector<cv::Vec3b> border;
  for (int x = 0; x < lab.cols; ++x)
  {
    border.insert(border.end(), { lab(0, x), lab(lab.rows - 1, x) });
  }
  for (int y = 0; y < lab.rows; ++y)
  {
    border.insert(border.end(), { lab(y, 0), lab(y, lab.cols - 1) });
  }
  Ground ground;
  const auto middle = border.begin() + static_cast<std::ptrdiff_t>(border.size() / 2);
  for (int k = 0; k < 3; ++k)
  {
    std::nth_element(border.begin(),
      middle,
      border.end(),
      [k](const cv::Vec3b& a, const cv::Vec3b& b) { return a[k] < b[k]; });
    ground.colour[k] = (*middle)[k];
  }
  std::vector<double> near;
  for (const cv::Vec3b& pixel : border)
  {
    const double differs = difference(pixel, ground.colour);
    if (differs <= evenGround)
    {
      near.push_back(differs);
    }
  }
  if (static_cast<double>(near.size()) < groundShare * static_cast<double>(border.size()))
  {
    return std::nullopt;
  }
  const auto most = near.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(near.size() - 1));
  std::nth_element(near.begin(), most, near.end());
  ground.spread = *most;
  return ground;
}

// 255 in shut-in parts most of which are as near to the ground's colour as the ground itself: what is only
// paler than the rest is of the thing.
cv::Mat1b groundAmong(const cv::Mat1b& shutIn, const cv::Mat1b& differs)
{
  constexpr int own = static_cast<int>(8.0 * halves);
  cv::Mat1i parts;
  const int count = cv::connectedComponents(shutIn, parts, 4);
  std::vector<int> balance(
    static_cast<std::size_t>(count), 0); // pixels that are near, less those that are not
  for (int y = 0; y < parts.rows; ++y)
  {
    for (int x = 0; x < parts.cols; ++x)
    {
      balance[static_cast<std::size_t>(parts(y, x))] += differs(y, x) <= own ? 1 : -1;
    }
  }
  cv::Mat1b ground(shutIn.size());
  for (int y = 0; y < parts.rows; ++y)
  {
    for (int x = 0; x < parts.cols; ++x)
    {
      const int part = parts(y, x);
      ground(y, x) = part > 0 && balance[static_cast<std::size_t>(part)] > 0 ? 255 : 0;
    }
  }
  return ground;
}

// What differs from the ground.
Thing beforeGround(const cv::Mat3b& lab,
  const Ground& ground,
  const std::optional<cv::Point>& place,
  const Context& context)
{
  // Half way to the thing a shadow is ground; a thing that is pale in parts would lose them at more than
  // `most`.
  constexpr double least = 6.0, most = 25.0;
  const cv::Mat1b differs = differences(lab, ground.colour, context);
  cv::Mat1b split;
  const double between =
    cv::threshold(differs, split, 0.0, 255.0, cv::THRESH_BINARY | cv::THRESH_OTSU) / halves;
  const double noise = std::max(least, 4.0 + 1.5 * ground.spread);
  const cv::Mat1b like(differs <= halves * std::clamp(between, noise, std::max(noise, most)));
  cv::Mat1b framed;
  cv::copyMakeBorder(like, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
  cv::floodFill(framed, { 0, 0 }, cv::Scalar(marked));
  const cv::Mat1b reached(framed(cv::Rect(1, 1, like.cols, like.rows)) == marked);
  const cv::Mat1b shutIn = groundAmong(cv::Mat1b(like & ~reached), differs);
  Thing thing;
  if (place && shutIn(*place))
  {
    cv::Mat1b spot = shutIn.clone();
    cv::floodFill(spot, *place, cv::Scalar(marked));
    thing.mask = spot == marked;
    return thing;
  }
  thing.solid = ~reached;
  thing.mask = thing.solid & ~shutIn;
  return thing;
}

cv::Mat smaller(const cv::Mat& picture, int longest)
{
  const double share = std::min(1.0, static_cast<double>(longest) / std::max(picture.cols, picture.rows));
  const cv::Size size(std::max(1, static_cast<int>(std::lround(share * picture.cols))),
    std::max(1, static_cast<int>(std::lround(share * picture.rows))));
  cv::Mat made;
  cv::resize(picture, made, size, 0.0, 0.0, cv::INTER_AREA);
  return made;
}

cv::Point inSmaller(const cv::Point& place, const cv::Mat& whole, const cv::Mat& small)
{
  return { place.x * small.cols / whole.cols, place.y * small.rows / whole.rows };
}

// What is coloured evenly under a place; empty where colours run on into what is beside it.
cv::Mat1b spotAt(const cv::Mat3b& lab, const cv::Point& place, const Context& context)
{
  constexpr int reduced = 512, steps = 10;
  constexpr double step = 4.0, largest = 0.6; // of Lab; of the picture's area
  const cv::Rect window = cv::Rect(place.x - 2, place.y - 2, 5, 5) & cv::Rect({ 0, 0 }, lab.size());
  const cv::Scalar mean = cv::mean(lab(window));
  const cv::Vec3b colour(cv::saturate_cast<std::uint8_t>(mean[0]),
    cv::saturate_cast<std::uint8_t>(mean[1]),
    cv::saturate_cast<std::uint8_t>(mean[2]));
  const cv::Mat3b small = smaller(lab, reduced);
  const cv::Point at = inSmaller(place, lab, small);
  const cv::Mat1b smallDiffers = differences(small, colour, context);
  std::vector<double> areas;
  for (int i = 1; i <= steps; ++i)
  {
    cv::Mat1b like(smallDiffers <= halves * step * i);
    areas.push_back(like(at) ? cv::floodFill(like, at, cv::Scalar(marked)) : 0);
  }
  double tolerance = 0.0, least = 1.0;
  for (std::size_t i = 0; i + 2 < areas.size(); ++i)
  {
    // Smooth rims, too, take in some pixels.
    const double growth = (areas[i + 2] - areas[i]) / (0.03 * areas[i] + 2.0 * std::sqrt(areas[i]) + 1e-9);
    if (areas[i] > 0.0 && areas[i + 2] <= largest * static_cast<double>(small.total()) && growth < least)
    {
      least = growth;
      tolerance = step * (static_cast<double>(i) + 2.0);
    }
  }
  if (tolerance == 0.0)
  {
    return {};
  }
  cv::Mat1b like(differences(lab, colour, context) <= halves * tolerance);
  if (!like(place))
  {
    return {};
  }
  cv::floodFill(like, place, cv::Scalar(marked));
  return cv::Mat1b(like == marked);
}

// GrabCut draws numbers of OpenCV's generator of this thread: they are the same each time, and it goes on as
// if none had been drawn.
struct SameNumbers
{
  cv::RNG before = cv::theRNG();
  SameNumbers() { cv::theRNG() = cv::RNG(1); }
  SameNumbers(const SameNumbers&) = delete;
  SameNumbers& operator=(const SameNumbers&) = delete;
  ~SameNumbers() { cv::theRNG() = this->before; }
};

// What GrabCut takes for the foreground of a photograph; empty of a picture that is too small.
Thing cutFrom(const cv::Mat3b& colours, const std::optional<cv::Point>& place)
{
  constexpr int reduced = 256, border = 5, leastSide = 4 * border, rounds = 3;
  const cv::Mat3b small = smaller(colours, reduced);
  Thing thing;
  if (std::min(small.cols, small.rows) < leastSide)
  {
    return thing;
  }
  cv::Mat1b labels(small.size(), std::uint8_t(place ? cv::GC_PR_BGD : cv::GC_PR_FGD));
  const cv::Point at = place ? inSmaller(*place, colours, small) : cv::Point();
  if (place)
  {
    cv::circle(labels, at, 3 * std::max(small.cols, small.rows) / 20, cv::GC_PR_FGD, cv::FILLED);
  }
  cv::rectangle(labels, cv::Rect({ 0, 0 }, small.size()), cv::GC_BGD, 2 * border - 1);
  if (place)
  {
    cv::circle(labels, at, 2, cv::GC_FGD, cv::FILLED);
  }
  const SameNumbers same;
  cv::Mat behind, before;
  cv::grabCut(small, labels, {}, behind, before, rounds, cv::GC_INIT_WITH_MASK);
  const cv::Mat1b found((labels & 1) * 255);
  cv::Mat1b whole;
  cv::resize(found, whole, colours.size(), 0.0, 0.0, cv::INTER_LINEAR);
  thing.mask = whole >= halfCovered;
  thing.off = 1 + static_cast<int>(std::ceil(static_cast<double>(colours.cols) / small.cols));
  return thing;
}

// Colours of pixels round one that are well outside or well inside.
struct Side
{
  cv::Vec3d sum;
  int count = 0;

  cv::Vec3d mean() const { return this->sum * (1.0 / this->count); }
};

} // namespace

cv::Mat1b coverage(const cv::Mat3b& colours, const cv::Mat1b& mask, int off, const Context& context)
{
  constexpr double leastContrast = 10.0;
  const int reach = off + 3, stride = std::max(1, off / 2);
  const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, { 2 * off + 1, 2 * off + 1 });
  cv::Mat1b inside, around;
  cv::erode(mask, inside, square);
  cv::dilate(mask, around, square);
  const auto covered = [&](int x, int y)
  {
    Side in, out;
    for (int v = std::max(0, y - reach); v <= std::min(mask.rows - 1, y + reach); v += stride)
    {
      for (int u = std::max(0, x - reach); u <= std::min(mask.cols - 1, x + reach); u += stride)
      {
        if (inside(v, u) || !around(v, u))
        {
          Side& side = inside(v, u) ? in : out;
          side.sum += cv::Vec3d(colours(v, u));
          ++side.count;
        }
      }
    }
    if (out.count == 0)
    {
      return mask(y, x);
    }
    cv::Vec3d thin = out.mean(); // where the thing is too thin to have an inside
    for (int v = std::max(0, y - off); in.count == 0 && v <= std::min(mask.rows - 1, y + off); ++v)
    {
      for (int u = std::max(0, x - off); u <= std::min(mask.cols - 1, x + off); ++u)
      {
        const cv::Vec3d colour(colours(v, u));
        const bool isFarther = cv::norm(colour - out.mean()) > cv::norm(thin - out.mean());
        thin = mask(v, u) && isFarther ? colour : thin;
      }
    }
    const cv::Vec3d way = (in.count == 0 ? thin : in.mean()) - out.mean();
    const double share = (cv::Vec3d(colours(y, x)) - out.mean()).dot(way) / way.dot(way);
    return way.dot(way) < leastContrast * leastContrast ? mask(y, x)
                                                        : cv::saturate_cast<std::uint8_t>(255.0 * share);
  };
  cv::Mat1b cover = inside.clone();
  context.eachUntilCancelled(mask.rows,
    [&](int y)
    {
      for (int x = 0; x < mask.cols; ++x)
      {
        if (around(y, x) && !inside(y, x))
        {
          cover(y, x) = covered(x, y);
        }
      }
    });
  return cover;
}

Thing thingIn(const PictureSamples& picture, const std::optional<cv::Point>& place, const Context& context)
{
  // OpenCV has no picture that is only read.
  const cv::Mat samples(
    picture.height, picture.width, CV_8UC(picture.components), const_cast<std::uint8_t*>(picture.samples));
  Thing thing;
  if (picture.hasAlpha())
  {
    constexpr double cutAway = 0.01; // of the pixels: fewer are a fault of the picture
    cv::extractChannel(samples, thing.alpha, picture.components - 1);
    thing.mask = thing.alpha >= halfCovered;
    const auto all = static_cast<double>(thing.mask.total());
    const int covered = cv::countNonZero(thing.mask);
    if (covered > 0 && covered <= (1.0 - cutAway) * all)
    {
      return thing;
    }
  }
  cv::Mat3b colours;
  if (picture.colours() == 3)
  {
    picture.hasAlpha() ? cv::cvtColor(samples, colours, cv::COLOR_RGBA2RGB) : samples.copyTo(colours);
  }
  else
  {
    cv::Mat1b grey;
    cv::extractChannel(samples, grey, 0);
    cv::cvtColor(grey, colours, cv::COLOR_GRAY2RGB);
  }
  const cv::Mat3b lab = labOf(colours);
  context.checkpoint(0.1);
  if (const std::optional<Ground> ground = groundOf(lab))
  {
    thing = beforeGround(lab, *ground, place, context);
  }
  else
  {
    thing = Thing();
    if (place)
    {
      thing.mask = spotAt(lab, *place, context);
    }
    context.checkpoint(0.2);
    if (thing.mask.empty())
    {
      thing = cutFrom(colours, place);
    }
  }
  thing.off = std::max(thing.off, 2);
  thing.colours = colours;
  return thing;
}

} // namespace oversketch
