// Grids and pictures in the files that GDAL reads, from bytes in memory. GDAL is loaded with the first of
// them: its libraries take 60 ms and 27 MB to start, and Debian's build of it stands on some that are under
// the GPL.
#ifndef oversketch_applications_files_raster_h
#define oversketch_applications_files_raster_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>

namespace oversketch_files
{

constexpr int longestSide = 16384; // samples

// Whether so few bytes can tell a picture of that size: decoders make what a header says of the first bytes
// on, and no packing makes more than this of a byte.
inline bool isPlausible(std::uint64_t width, std::uint64_t height, std::size_t bytes)
{
  constexpr std::uint64_t mostPixels = 8192;
  return width > 0 && height > 0 && width <= longestSide && height <= longestSide &&
         width * height <= mostPixels * bytes;
}

// GDAL's name of the format that such bytes have, "GTiff", "PNG", "BMP" or "WEBP"; "" for others.
std::string rasterFormatOf(const std::string& bytes);

// Functions of the module oversketch_raster. Each gives null for files that are damaged or of another kind,
// that say to be larger than 16384 samples a side or than so few bytes can make them, and that have no
// samples. Rows are from the bottom.
struct RasterReader
{
  // Heights of a GeoTIFF in units of its map, with its spacing and origin: one band, or three colours as
  // "Heights", NaN where the file has no data. `fromTop`: where its first row is unless its map says. Null
  // with `isTurned` where the grid does not lie along the axes of the map.
  vtkSmartPointer<vtkImageData> (*heights)(const std::string& bytes, bool fromTop, bool& isTurned);
  // Samples of a PNG of 16 bits, raw.
  vtkSmartPointer<vtkImageData> (*fineSamples)(const std::string& bytes);
  // A picture of `format`, which rasterFormatOf names, of 8 bits a channel, as it lies in the file.
  vtkSmartPointer<vtkImageData> (*pixels)(const std::string& bytes, const char* format);
};

// Throws Failed where the module cannot be loaded.
const RasterReader& rasterReader();

} // namespace oversketch_files
#endif
