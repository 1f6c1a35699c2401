#include "Raster/skin.h"

#include "Stroke/with_opencv.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double border = 1.0 / 300.0, reach = 1.0 / 64.0; // of the longest side
constexpr int opaque = 250;
constexpr int fraction = 4; // binary digits of a pixel

cv::Mat1b maskOf(const PictureSamples& picture, const std::vector<PictureTriangle>& covered)
{
  cv::Mat1b mask(picture.height, picture.width, std::uint8_t(0));
  const auto fixed = [](double place)
  { return static_cast<int>(std::lround(std::clamp((place - 0.5), -1e5, 1e5) * (1 << fraction))); };
  for (const PictureTriangle& triangle : covered)
  {
    std::array<cv::Point, 3> corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      corners[k] = { fixed(triangle[k][0]), fixed(triangle[k][1]) };
    }
    cv::fillConvexPoly(mask, corners.data(), 3, cv::Scalar(255), cv::LINE_8, fraction);
  }
  return mask;
}

} // namespace

std::vector<std::uint8_t> skinOf(const PictureSamples& picture,
  const std::vector<PictureTriangle>& covered,
  const Context& context)
{
  const int width = picture.width, height = picture.height, colours = picture.colours();
  const double longest = std::max(width, height);
  cv::Mat1f off; // from the inside
  cv::Mat1i nearest;
  std::vector<std::size_t> places{ 0 }; // of an inside pixel by its label
  withOpenCV("lead colours on past the outline",
    [&]
    {
      const cv::Mat1b mask = maskOf(picture, covered);
      cv::Mat1f depth;
      cv::distanceTransform(mask, depth, cv::DIST_L2, cv::DIST_MASK_PRECISE);
      context.checkpoint(0.3);
      cv::Mat1f around;
      cv::dilate(depth, around, cv::Mat1b::ones(3, 3));
      const float deep = static_cast<float>(std::max(1.0, border * longest));
      cv::Mat1b outside(height, width, std::uint8_t(255));
      context.parallelFor(height,
        [&](int begin, int end)
        {
          for (int y = begin; y < end; ++y)
          {
            for (int x = 0; x < width; ++x)
            {
              const std::size_t at = static_cast<std::size_t>(y) * width + x;
              const float t = depth(y, x);
              const bool seen =
                !picture.hasAlpha() || picture.samples[at * picture.components + colours] >= opaque;
              outside(y, x) = seen && t > 0.0f && (t >= deep || t >= around(y, x)) ? 0 : 255;
            }
          }
        });
      context.checkpoint(0.4);
      cv::distanceTransform(outside, off, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
      for (int y = 0; y < height; ++y)
      {
        for (int x = 0; x < width; ++x)
        {
          if (outside(y, x) == 0)
          {
            const auto label = static_cast<std::size_t>(nearest(y, x));
            places.resize(std::max(places.size(), label + 1), 0);
            places[label] = static_cast<std::size_t>(y) * width + x;
          }
        }
      }
    });
  context.checkpoint(0.8);
  const bool none = places.size() < 2;
  const double limit = std::max(1.0, border * longest) + std::max(2.0, reach * longest);
  std::vector<std::uint8_t> skin(static_cast<std::size_t>(width) * height * colours);
  context.parallelFor(height,
    [&](int begin, int end)
    {
      for (int y = begin; y < end; ++y)
      {
        for (int x = 0; x < width; ++x)
        {
          const std::size_t at = static_cast<std::size_t>(y) * width + x;
          const bool hidden =
            picture.hasAlpha() && picture.samples[at * picture.components + colours] < opaque;
          const bool led = !none && (hidden || off(y, x) <= limit);
          const std::size_t from = led ? places[static_cast<std::size_t>(nearest(y, x))] : at;
          std::copy_n(picture.samples + from * picture.components, colours, skin.data() + at * colours);
        }
      }
    });
  context.checkpoint(1.0);
  return skin;
}

} // namespace oversketch
