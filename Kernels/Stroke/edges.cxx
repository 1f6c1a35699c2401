#include "Stroke/edges.h"

#include "Mesh/context.h"
#include "Stroke/with_opencv.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double weakEdge = 50.0, strongEdge = 100.0; // Canny's

void requirePicture(bool sound)
{
  if (!sound)
  {
    throw Error(Failure::BadStroke,
      "the picture is empty or has another number of channels than 1 to 4; give grey, RGB or either with "
      "alpha");
  }
}

template <typename Value>
std::vector<std::uint8_t> brightness(const PictureView<Value>& picture)
{
  requirePicture(picture.values && picture.width > 0 && picture.height > 0 && picture.channels >= 1 &&
                 picture.channels <= 4);
  const std::size_t count = static_cast<std::size_t>(picture.width) * picture.height;
  const int channels = picture.channels;
  constexpr int shift = sizeof(Value) == 2 ? 8 : 0;
  std::vector<std::uint8_t> result(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Value* pixel = picture.values + i * channels;
    const auto channel = [&](int c) { return static_cast<int>(pixel[c] >> shift); };
    // Weights in 1 / 16384, as OpenCV has them.
    int grey =
      channels < 3 ? channel(0) : (4899 * channel(0) + 9617 * channel(1) + 1868 * channel(2) + 8192) >> 14;
    if (channels % 2 == 0)
    {
      const int alpha = channel(channels - 1);
      grey = (grey * alpha + 255 * (255 - alpha) + 127) / 255;
    }
    result[i] = static_cast<std::uint8_t>(grey);
  }
  return result;
}

} // namespace

std::vector<std::uint8_t> luminance(const PictureView<std::uint8_t>& picture)
{
  return brightness(picture);
}

std::vector<std::uint8_t> luminance(const PictureView<std::uint16_t>& picture)
{
  return brightness(picture);
}

EdgeFeatures edgeFeatures(const std::vector<std::uint8_t>& luminance, int width, int height)
{
  requirePicture(width > 0 && height > 0 && luminance.size() == static_cast<std::size_t>(width) * height);
  EdgeFeatures features;
  features.width = width;
  features.height = height;
  const std::size_t count = luminance.size();
  features.gx.resize(count);
  features.gy.resize(count);
  features.magnitude.resize(count);
  features.edges.resize(count);
  withOpenCV("find the picture's edges",
    [&]
    {
      // It only reads the picture.
      const cv::Mat grey(height, width, CV_8UC1, const_cast<std::uint8_t*>(luminance.data()));
      cv::Mat gx(height, width, CV_32FC1, features.gx.data());
      cv::Mat gy(height, width, CV_32FC1, features.gy.data());
      cv::Mat edges(height, width, CV_8UC1, features.edges.data());
      cv::Sobel(grey, gx, CV_32F, 1, 0, 3);
      cv::Sobel(grey, gy, CV_32F, 0, 1, 3);
      cv::Canny(grey, edges, weakEdge, strongEdge);
    });
  for (std::size_t i = 0; i < count; ++i)
  {
    const float x = features.gx[i], y = features.gy[i];
    features.magnitude[i] = std::sqrt(x * x + y * y);
    features.greatest = std::max(features.greatest, features.magnitude[i]);
    features.edges[i] = features.edges[i] ? 1 : 0;
  }
  return features;
}

} // namespace oversketch
