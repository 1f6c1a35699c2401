// Connected areas of a raster without lines.
#ifndef oversketch_kernels_raster_blobs_h
#define oversketch_kernels_raster_blobs_h

#include "Raster/frame.h"

namespace oversketch
{

struct Blobs
{
  // Of each sample: the area it is in, 4-connected, numbered by their first samples, so that 0 is the one at
  // the raster's border; -1 on a line.
  std::vector<int> labels;
  std::vector<int> sizes; // samples of each area
  int count() const { return static_cast<int>(this->sizes.size()); }
};

// lines: 1 on a line, else 0; the raster's first sample is on none. Why not OpenCV: its areas' order is the
// algorithm's, and 8 neighbours, which leak through diagonal lines, are its default.
Blobs blobsOf(const Frame& frame, const std::vector<std::uint8_t>& lines);

// How many samples of a line are beside an area, over one of their four sides.
struct Contact
{
  int blob = 0, pixels = 0;
};

// The contacts of a line's samples, each sample once however often the line passes it, by ascending area.
// `stamps` has an entry for each sample of the raster that differs from `stamp`.
std::vector<Contact> contactsOf(const Frame& frame,
  const Blobs& blobs,
  const std::vector<Place>& pixels,
  std::vector<int>& stamps,
  int stamp);

} // namespace oversketch
#endif
