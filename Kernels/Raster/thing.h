// Pixels that a thing in a picture covers.
#ifndef oversketch_kernels_raster_thing_h
#define oversketch_kernels_raster_thing_h

#include "Mesh/context.h"
#include "Raster/skin.h"

#include <opencv2/core.hpp>

#include <optional>

namespace oversketch
{

// 255 in it, 0 elsewhere.
struct Thing
{
  cv::Mat1b mask;
  cv::Mat1b solid; // the same with what it encloses, where it may be a drawing of lines; else empty
  cv::Mat1b alpha; // its coverage, where the picture says it; else empty
  cv::Mat3b colours;
  int off = 0; // px by which the mask's rim may be off
};

// Chooses and finds it by the rules of trace.h, but for the connected part under the place. The mask may be
// empty of pixels. Calls OpenCV: for withOpenCV.
Thing thingIn(const PictureSamples& picture, const std::optional<cv::Point>& place, const Context& context);

// Coverage of pixels [0 to 255] by what a mask says roughly. Near its rim, as far as that may be off, it is
// the share of a pixel's colour between the mean colours well outside and well inside beside it; the colour
// that differs most, where it is too thin to have an inside. Where nothing is outside, or colours are alike,
// it is the mask's own.
cv::Mat1b coverage(const cv::Mat3b& colours, const cv::Mat1b& mask, int off, const Context& context);

} // namespace oversketch
#endif
