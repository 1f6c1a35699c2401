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
Shades shadesOf(const PictureView<Value>& picture)
{
  requirePicture(picture.values && picture.width > 0 && picture.height > 0 && picture.channels >= 1 &&
                 picture.channels <= 4);
  const std::size_t count = static_cast<std::size_t>(picture.width) * picture.height;
  const int channels = picture.channels;
  constexpr int shift = sizeof(Value) == 2 ? 8 : 0;
  Shades result;
  result.channels = channels < 3 ? 1 : 3;
  result.values.reserve(count * result.channels);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Value* pixel = picture.values + i * channels;
    const int alpha = channels % 2 == 0 ? static_cast<int>(pixel[channels - 1] >> shift) : 255;
    for (int c = 0; c < result.channels; ++c)
    {
      const int value = static_cast<int>(pixel[c] >> shift);
      result.values.push_back(
        static_cast<std::uint8_t>(alpha == 255 ? value : (value * alpha + 255 * (255 - alpha) + 127) / 255));
    }
  }
  return result;
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

Shades shades(const PictureView<std::uint8_t>& picture)
{
  return shadesOf(picture);
}

Shades shades(const PictureView<std::uint16_t>& picture)
{
  return shadesOf(picture);
}

EdgeFeatures edgeFeatures(const std::vector<std::uint8_t>& luminance, int width, int height)
{
  return edgeFeatures(Shades{ luminance, 1 }, width, height);
}

EdgeFeatures edgeFeatures(const Shades& shades, int width, int height)
{
  const int channels = shades.channels;
  requirePicture(width > 0 && height > 0 && (channels == 1 || channels == 3) &&
                 shades.values.size() == static_cast<std::size_t>(width) * height * channels);
  EdgeFeatures features;
  features.width = width;
  features.height = height;
  const std::size_t count = static_cast<std::size_t>(width) * height;
  features.gx.resize(count);
  features.gy.resize(count);
  features.magnitude.resize(count);
  features.edges.resize(count);
  cv::Mat gx, gy;
  withOpenCV("find the picture's edges",
    [&]
    {
      // It only reads the picture.
      const cv::Mat values(height, width, CV_8UC(channels), const_cast<std::uint8_t*>(shades.values.data()));
      cv::Mat edges(height, width, CV_8UC1, features.edges.data());
      cv::Sobel(values, gx, CV_16S, 1, 0, 3);
      cv::Sobel(values, gy, CV_16S, 0, 1, 3);
      cv::Canny(values, edges, weakEdge, strongEdge);
    });
  const auto* x = gx.ptr<std::int16_t>();
  const auto* y = gy.ptr<std::int16_t>();
  for (std::size_t i = 0; i < count; ++i, x += channels, y += channels)
  {
    float greatest = -1.0f;
    for (int c = 0; c < channels; ++c)
    {
      const float dx = x[c], dy = y[c];
      const float square = dx * dx + dy * dy;
      if (square > greatest)
      {
        greatest = square;
        features.gx[i] = dx;
        features.gy[i] = dy;
      }
    }
    features.magnitude[i] = std::sqrt(greatest);
    features.greatest = std::max(features.greatest, features.magnitude[i]);
    features.edges[i] = features.edges[i] ? 1 : 0;
  }
  return features;
}

} // namespace oversketch
