// Strokes stay clear of each other and of themselves when they are resampled.
#ifndef oversketch_kernels_raster_apart_h
#define oversketch_kernels_raster_apart_h

#include "Raster/classify.h"

#include <vector>

namespace oversketch
{

// A departure from image-assisted modelling, section 4: where a sample is dropped the stroke becomes a chord,
// and at the tip of a limb that is thinner than half of the spacing that chord may cross the limb's other
// side. A drawing that crosses nothing would be refused for a crossing of ours. The samples that were dropped
// between the ends of such a piece are put back, so it is what was drawn; there samples lie nearer than half
// of the spacing to each other. What is drawn across itself stays so.
//
// places: of each stroke, of resampled(); strokes that leave the raster are not looked at. The same in any
// order of the strokes, up to numbers. Throws Error(Failure::Cancelled) when cancelled.
void keepApart(const Frame& frame,
  const std::vector<DrawnStroke>& strokes,
  double spacing,
  std::vector<std::vector<Blend>>& places,
  const Context& context);

} // namespace oversketch
#endif
