// Grids of samples in the files that GDAL reads, from bytes in memory.
#ifndef oversketch_applications_files_raster_h
#define oversketch_applications_files_raster_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace oversketch_files
{

// GDAL's name of the format that such bytes have, "GTiff", "PNG", "BMP" or "WEBP"; "" for others.
std::string rasterFormatOf(const std::string& bytes);

// A file that is open as long as this lives, which is on one thread and shorter than its bytes. GDAL says
// nothing on its own meanwhile.
class Raster
{
public:
  // Nothing but the head is read. `format`: as rasterFormatOf names it.
  Raster(const std::string& bytes, const char* format);
  ~Raster();
  Raster(const Raster&) = delete;
  Raster& operator=(const Raster&) = delete;

  // False where it is none of that format or damaged, where it says to be larger than 16384 samples a side or
  // than so few bytes can make it, and where it has no samples.
  bool isOpen() const { return this->Data != nullptr; }
  int width() const;
  int height() const;
  int bands() const;
  void* data() const { return this->Data; } // GDALDatasetH
  void* band(int number) const;             // GDALRasterBandH, from 1

  // The first bands as scalars of VTK's `type`, rows from the bottom; null where the samples are damaged.
  // `fromTop`: whether the file's first row is the uppermost one.
  vtkSmartPointer<vtkImageData> samples(int type, int count, bool fromTop) const;
  // The same of any band that is one byte a sample, such as a mask of the first.
  bool readBytes(void* band, unsigned char* lowerLeft, bool fromTop) const;

private:
  std::string Name;
  void* Data = nullptr;
};

} // namespace oversketch_files
#endif
