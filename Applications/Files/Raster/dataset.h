// A file that GDAL has open.
#ifndef oversketch_applications_files_raster_dataset_h
#define oversketch_applications_files_raster_dataset_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <gdal.h>

#include <string>

namespace oversketch_files
{

// Open as long as this lives, which is on one thread and shorter than its bytes. GDAL says nothing on its own
// meanwhile.
class Dataset
{
public:
  // Nothing but the head is read. `format`: as rasterFormatOf names it.
  Dataset(const std::string& bytes, const char* format);
  ~Dataset();
  Dataset(const Dataset&) = delete;
  Dataset& operator=(const Dataset&) = delete;

  // False where it is none of that format or damaged, where it says to be larger than 16384 samples a side or
  // than so few bytes can make it, and where it has no samples.
  bool isOpen() const { return this->Data != nullptr; }
  int width() const { return GDALGetRasterXSize(this->Data); }
  int height() const { return GDALGetRasterYSize(this->Data); }
  int bands() const { return GDALGetRasterCount(this->Data); }
  GDALDatasetH data() const { return this->Data; }
  GDALRasterBandH band(int number) const { return GDALGetRasterBand(this->Data, number); } // from 1

  // The first bands as scalars of VTK's `type`, rows from the bottom; null where the samples are damaged.
  // `fromTop`: whether the file's first row is the uppermost one.
  vtkSmartPointer<vtkImageData> samples(int type, int count, bool fromTop) const;
  // Reads a band of one byte a sample, such as a mask of the first, in the same order.
  bool readBytes(GDALRasterBandH band, unsigned char* lowerLeft, bool fromTop) const;

private:
  std::string Name;
  GDALDatasetH Data = nullptr;
};

} // namespace oversketch_files
#endif
