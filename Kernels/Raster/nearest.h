// Which of some pixels is nearest to each pixel of a picture.
#ifndef oversketch_kernels_raster_nearest_h
#define oversketch_kernels_raster_nearest_h

#include "Mesh/context.h"

#include <cstdint>
#include <vector>

namespace oversketch
{

// Number, for each pixel, of the chosen one (not 0) that is nearest to it, between centres and exactly; -1
// where none is chosen. Of equally near ones it takes the same on any number of threads.
//
// Source: Felzenszwalb, Huttenlocher, Distance transforms of sampled functions, Theory of Computing 8 (2012):
// the nearest of its column, and of these, the nearest by the lower envelope of the row's parabolas. OpenCV's
// distanceTransform says which pixel only with its mask of 5, which is not exact, and on one thread.
std::vector<int> nearestChosen(const std::vector<std::uint8_t>& chosen,
  int width,
  int height,
  const Context& context);

} // namespace oversketch
#endif
