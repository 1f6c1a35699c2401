// Edges of a picture, what the livewire follows.
#ifndef oversketch_kernels_stroke_edges_h
#define oversketch_kernels_stroke_edges_h

#include <cstdint>
#include <vector>

namespace oversketch
{

// A picture in memory, row by row, channels side by side: 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha.
template <typename Value>
struct PictureView
{
  const Value* values = nullptr;
  int width = 0, height = 0, channels = 1;
};

// Brightness in 8 bits, 0.299 R + 0.587 G + 0.114 B, of a transparent pixel as it looks on white; of 16 bits
// the upper ones count. Throws Error(Failure::BadStroke) for an empty picture or another number of channels.
std::vector<std::uint8_t> luminance(const PictureView<std::uint8_t>& picture);
std::vector<std::uint8_t> luminance(const PictureView<std::uint16_t>& picture);

// Shades without mixing: one value a pixel of a grey picture, three of a coloured one.
struct Shades
{
  std::vector<std::uint8_t> values;
  int channels = 1;
};
Shades shades(const PictureView<std::uint8_t>& picture);
Shades shades(const PictureView<std::uint16_t>& picture);

struct EdgeFeatures
{
  int width = 0, height = 0;
  std::vector<float> gx, gy;       // gradient by Sobel's 3 x 3, of the channel that changes most there
  std::vector<float> magnitude;    // its length g
  std::vector<std::uint8_t> edges; // 1 on Canny's edges, thresholds 50 and 100
  float greatest = 0.0f;           // g_max, of the whole picture
};

// Source: image-assisted modelling, section 3, step 1: once for the whole picture, since g_max is the whole
// picture's. Sobel and Canny are OpenCV's. That takes the brightness; colours are a departure: where dark
// green meets black, or a stem a fur as bright, brightness has no edge, and the pen went to the next one
// inside. Throws Error(Failure::BadStroke) for an empty picture, Error(Failure::Unexpected) when OpenCV
// fails.
EdgeFeatures edgeFeatures(const Shades& shades, int width, int height);
EdgeFeatures edgeFeatures(const std::vector<std::uint8_t>& luminance, int width, int height);

} // namespace oversketch
#endif
