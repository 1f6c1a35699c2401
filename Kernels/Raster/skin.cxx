#include "Raster/skin.h"

#include "Raster/nearest.h"
#include "Stroke/with_opencv.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/photo.hpp>

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double border = 1.0 / 300.0, reach = 1.0 / 64.0; // of the longest side
constexpr int opaque = 250;
constexpr int fraction = 4; // binary digits of a pixel

std::size_t count(const PictureSamples& picture)
{
  return static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
}

int squaredDistance(int width, int a, int b)
{
  const int dx = a % width - b % width, dy = a / width - b / width;
  return dx * dx + dy * dy;
}

// 255 where the triangles are.
std::vector<std::uint8_t> maskOf(const PictureSamples& picture, const std::vector<PictureTriangle>& covered)
{
  std::vector<std::uint8_t> mask(count(picture), 0);
  cv::Mat1b image(picture.height, picture.width, mask.data());
  const auto fixed = [](double place)
  { return static_cast<int>(std::lround(std::clamp((place - 0.5), -1e5, 1e5) * (1 << fraction))); };
  for (const PictureTriangle& triangle : covered)
  {
    std::array<cv::Point, 3> corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      corners[k] = { fixed(triangle[k][0]), fixed(triangle[k][1]) };
    }
    cv::fillConvexPoly(image, corners.data(), 3, cv::Scalar(255), cv::LINE_8, fraction);
  }
  return mask;
}

// Depths below the mask's border [px, to 2 %] where they are less than `deep`; what is farther in is that
// deep or more. Of tiles that the border passes through or near to alone.
struct Depths
{
  cv::Rect tile, window; // the window round the tile: what decides over its depths
  cv::Mat1f in;          // the window
  bool all = false;      // all of the window is covered
};

void findDepths(const cv::Mat1b& mask, int margin, Depths& depths)
{
  const cv::Rect whole(0, 0, mask.cols, mask.rows);
  const cv::Rect& tile = depths.tile;
  depths.window =
    cv::Rect(tile.x - margin, tile.y - margin, tile.width + 2 * margin, tile.height + 2 * margin) & whole;
  const cv::Mat1b seen = mask(depths.window);
  depths.all = cv::countNonZero(seen) == depths.window.area();
  if (!depths.all && cv::countNonZero(mask(tile)) > 0)
  {
    cv::distanceTransform(seen, depths.in, cv::DIST_L2, cv::DIST_MASK_5);
  }
}

// Whether none beside it is deeper.
bool isMiddle(const cv::Mat1f& depth, int x, int y)
{
  for (int v = std::max(0, y - 1); v <= std::min(depth.rows - 1, y + 1); ++v)
  {
    for (int u = std::max(0, x - 1); u <= std::min(depth.cols - 1, x + 1); ++u)
    {
      if (depth(v, u) > depth(y, x))
      {
        return false;
      }
    }
  }
  return true;
}

// The inside of what the mask covers, as of skinOf: 255 where a pixel keeps its colour.
std::vector<std::uint8_t> insideOf(const PictureSamples& picture, std::vector<std::uint8_t>& mask)
{
  constexpr int side = 128; // of a tile
  const int width = picture.width, height = picture.height;
  const cv::Mat1b covered(height, width, mask.data());
  const double deep = std::max(1.0, border * std::max(width, height));
  std::vector<std::uint8_t> inside(mask.size(), 0);
  for (int top = 0; top < height; top += side)
  {
    for (int left = 0; left < width; left += side)
    {
      Depths depths;
      depths.tile = cv::Rect(left, top, std::min(side, width - left), std::min(side, height - top));
      findDepths(covered, static_cast<int>(std::ceil(1.1 * deep)) + 2, depths);
      for (int y = top; y < top + depths.tile.height && (depths.all || !depths.in.empty()); ++y)
      {
        for (int x = left; x < left + depths.tile.width; ++x)
        {
          const std::size_t at = static_cast<std::size_t>(y) * width + x;
          const int u = x - depths.window.x, v = y - depths.window.y;
          const bool isIn =
            depths.all || (mask[at] && (depths.in(v, u) >= deep || isMiddle(depths.in, u, v)));
          inside[at] = isIn && picture.alpha(at) >= opaque ? 255 : 0;
        }
      }
    }
  }
  return inside;
}

// Depths below a mask's border and the image's [px].
cv::Mat1f depthsOf(const cv::Mat1b& mask)
{
  cv::Mat1b framed;
  cv::Mat1f depths;
  cv::copyMakeBorder(mask, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::distanceTransform(framed, depths, cv::DIST_L2, cv::DIST_MASK_5);
  return depths(cv::Rect(1, 1, mask.cols, mask.rows));
}

// 0 where depths are `from` or less, 1 where they are `to` or more.
cv::Mat rampOf(const cv::Mat1f& depths, double from, double to)
{
  return cv::max(cv::min((depths - from) / (to - from), 1.0), 0.0);
}

// Blurs colours where the mask is, without those beyond it.
cv::Mat blurredIn(const cv::Mat1b& mask, const cv::Mat& colours, double sigma)
{
  const auto blur = [&](const cv::Mat& image)
  {
    cv::Mat made;
    cv::GaussianBlur(image, made, cv::Size(), sigma, sigma, cv::BORDER_CONSTANT);
    return made;
  };
  cv::Mat weights, values, even;
  cv::merge(std::vector<cv::Mat>(static_cast<std::size_t>(colours.channels()), mask / 255), weights);
  weights.convertTo(weights, CV_32F);
  colours.convertTo(values, CV_32F);
  cv::divide(blur(values.mul(weights)), cv::max(blur(weights), 1e-3), even);
  even.convertTo(even, CV_8U);
  return even;
}

// Colours that go on from the rim, and how much of a pixel's colour they are.
struct Filling
{
  cv::Mat colours;
  cv::Mat1b share; // 255: all
};

// Makes those of rimSkinOf. The skin leads its colours on over `least` px of the rim.
Filling filledFromRim(const cv::Mat& skin, const cv::Mat1b& covered, double least)
{
  constexpr int most = 256, radius = 5;                // px
  constexpr double rimShare = 0.025, softening = 0.04; // of the longest side
  const double scale = std::min(1.0, 1.0 * most / std::max(skin.cols, skin.rows));
  const cv::Size size(std::max(1, cvRound(scale * skin.cols)), std::max(1, cvRound(scale * skin.rows)));
  const int longest = std::max(size.width, size.height);
  const double rim = std::max({ 2.0, 1.5 * least * scale, rimShare * longest });
  cv::Mat rough;
  cv::Mat1b mask;
  cv::resize(skin, rough, size, 0.0, 0.0, cv::INTER_AREA);
  cv::resize(covered, mask, size, 0.0, 0.0, cv::INTER_AREA);
  mask = mask >= 128;
  const cv::Mat1f depths = depthsOf(mask);
  cv::Mat filled;
  cv::inpaint(rough, depths > rim, filled, radius, cv::INPAINT_NS);
  const auto soften = [&](double sigma, double from, double to)
  {
    const cv::Mat much = rampOf(depths, from, to), blurred = blurredIn(mask, filled, sigma);
    cv::blendLinear(blurred, filled.clone(), much, 1.0 - much, filled);
  };
  soften(0.5 * rim, 0.0, 0.5 * rim);
  soften(softening * longest, rim, rim + 2.0 * softening * longest);
  Filling made;
  cv::Mat1b share;
  rampOf(depths, 0.2 * rim, 0.8 * rim).convertTo(share, CV_8U, 255.0);
  cv::resize(filled, made.colours, skin.size(), 0.0, 0.0, cv::INTER_LINEAR);
  cv::resize(share, made.share, skin.size(), 0.0, 0.0, cv::INTER_LINEAR);
  return made;
}

// The picture without alpha, each pixel's colour taken from the one that `from` says.
template <typename From>
std::vector<std::uint8_t> colouredFrom(const PictureSamples& picture,
  const From& from,
  const Context& context)
{
  const std::size_t colours = picture.colours(), each = picture.components;
  std::vector<std::uint8_t> made(count(picture) * colours);
  context.each(static_cast<int>(count(picture)),
    [&](int at) { std::copy_n(picture.samples + from(at) * each, colours, made.data() + at * colours); });
  return made;
}

} // namespace

std::vector<std::uint8_t> skinOf(const PictureSamples& picture,
  const std::vector<PictureTriangle>& covered,
  const Context& context)
{
  std::vector<std::uint8_t> inside;
  withOpenCV("lead colours on past the outline",
    [&]
    {
      std::vector<std::uint8_t> mask = maskOf(picture, covered);
      inside = insideOf(picture, mask);
    });
  context.checkpoint(0.4);
  const std::vector<int> nearest = nearestChosen(inside, picture.width, picture.height, context);
  context.checkpoint(0.8);
  const double longest = std::max(picture.width, picture.height);
  const double limit = std::max(1.0, border * longest) + std::max(2.0, reach * longest);
  const auto from = [&](std::size_t at)
  {
    const bool isLed = !inside[at] && nearest[at] >= 0 &&
                       (picture.alpha(at) < opaque ||
                         squaredDistance(picture.width, static_cast<int>(at), nearest[at]) <= limit * limit);
    return isLed ? static_cast<std::size_t>(nearest[at]) : at;
  };
  return colouredFrom(picture, from, context);
}

std::vector<std::uint8_t> rimSkinOf(const PictureSamples& picture,
  const std::vector<PictureTriangle>& covered,
  const Context& context)
{
  std::vector<std::uint8_t> made = skinOf(picture, covered, context);
  withOpenCV("fill the inside from the rim",
    [&]
    {
      std::vector<std::uint8_t> mask = maskOf(picture, covered);
      const cv::Mat1b whole(picture.height, picture.width, mask.data());
      const cv::Rect box = cv::boundingRect(whole);
      if (box.empty())
      {
        return;
      }
      cv::Mat skin = cv::Mat(whole.size(), CV_8UC(picture.colours()), made.data())(box);
      const Filling filling =
        filledFromRim(skin, whole(box), std::max(1.0, border * std::max(picture.width, picture.height)));
      context.each(box.height,
        [&](int y)
        {
          const std::uint8_t *share = filling.share.ptr(y), *fill = filling.colours.ptr(y);
          std::uint8_t* colour = skin.ptr(y);
          for (int k = 0; k < box.width * skin.channels(); ++k)
          {
            const int of = share[k / skin.channels()];
            colour[k] = static_cast<std::uint8_t>((of * fill[k] + (255 - of) * colour[k] + 127) / 255);
          }
        });
    });
  return made;
}

std::vector<std::uint8_t> opaqueOf(const PictureSamples& picture, const Context& context)
{
  constexpr int half = 128; // below it nothing of a pixel's own colour is meant to be seen
  constexpr int rim = 4;    // px: what is less opaque so near to nothing is its rim
  std::vector<std::uint8_t> whole(count(picture)), nothing(count(picture));
  for (std::size_t at = 0; at < whole.size(); ++at)
  {
    whole[at] = picture.alpha(at) >= opaque ? 255 : 0;
    nothing[at] = picture.alpha(at) < half ? 255 : 0;
  }
  const int width = picture.width;
  const std::vector<int> colour = nearestChosen(whole, width, picture.height, context);
  const std::vector<int> bare = nearestChosen(nothing, width, picture.height, context);
  const auto from = [&](std::size_t at)
  {
    const bool isRim =
      !whole[at] && bare[at] >= 0 && squaredDistance(width, static_cast<int>(at), bare[at]) <= rim * rim;
    return isRim && colour[at] >= 0 ? static_cast<std::size_t>(colour[at]) : at;
  };
  return colouredFrom(picture, from, context);
}

} // namespace oversketch
