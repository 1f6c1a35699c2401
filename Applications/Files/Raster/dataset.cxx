#include "dataset.h"

#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_frmts.h>

#include <atomic>
#include <cstdint>

namespace oversketch_files
{

namespace
{

constexpr int longest = 16384;         // samples a side
constexpr double mostSamples = 8192.0; // a byte: no packing makes more of one

// Those alone that are asked for: all of GDAL's would take longer than to read most files.
void registerFormats()
{
  GDALRegister_GTiff();
  GDALRegister_PNG();
  GDALRegister_BMP();
  GDALRegister_WEBP();
}

GDALDataType gdalType(int type)
{
  switch (type)
  {
    case VTK_UNSIGNED_CHAR:
      return GDT_Byte;
    case VTK_UNSIGNED_SHORT:
      return GDT_UInt16;
    default:
      return type == VTK_FLOAT ? GDT_Float32 : GDT_Float64;
  }
}

// Whether decoding it makes no more than so many bytes can tell, block by block.
bool isPlausible(GDALDatasetH data, std::size_t bytes)
{
  const int width = GDALGetRasterXSize(data), height = GDALGetRasterYSize(data);
  if (width < 1 || height < 1 || width > longest || height > longest ||
      1.0 * width * height > mostSamples * static_cast<double>(bytes) || GDALGetRasterCount(data) < 1)
  {
    return false;
  }
  int across = 0, down = 0;
  GDALGetBlockSize(GDALGetRasterBand(data, 1), &across, &down);
  return across <= 4 * longest && down <= 4 * longest;
}

} // namespace

Dataset::Dataset(const std::string& bytes, const char* format)
{
  static const bool registered = (registerFormats(), true);
  static std::atomic<std::uint64_t> count{ 0 };
  CPLPushErrorHandler(CPLQuietErrorHandler); // of this thread
  this->Name = "/vsimem/oversketch/" + std::to_string(++count);
  auto* const first = reinterpret_cast<GByte*>(const_cast<char*>(bytes.data())); // read alone
  VSILFILE* const file = VSIFileFromMemBuffer(this->Name.c_str(), first, bytes.size(), FALSE);
  if (!registered || !file)
  {
    return;
  }
  VSIFCloseL(file);
  const char* const formats[] = { format, nullptr };
  const char* const beside[] = { nullptr }; // no file beside it is looked for
  this->Data = GDALOpenEx(this->Name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, formats, nullptr, beside);
  if (this->Data && !isPlausible(this->Data, bytes.size()))
  {
    GDALClose(this->Data);
    this->Data = nullptr;
  }
}

Dataset::~Dataset()
{
  if (this->Data)
  {
    GDALClose(this->Data);
  }
  VSIUnlink(this->Name.c_str());
  CPLPopErrorHandler();
}

vtkSmartPointer<vtkImageData> Dataset::samples(int type, int count, bool fromTop) const
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(this->width(), this->height(), 1);
  image->AllocateScalars(type, count);
  const GSpacing size = image->GetScalarSize(), stride = size * count * this->width();
  auto* const lowest = static_cast<char*>(image->GetScalarPointer());
  const CPLErr done = GDALDatasetRasterIOEx(this->Data,
    GF_Read,
    0,
    0,
    this->width(),
    this->height(),
    fromTop ? lowest + stride * (this->height() - 1) : lowest,
    this->width(),
    this->height(),
    gdalType(type),
    count,
    nullptr, // the first ones
    size * count,
    fromTop ? -stride : stride,
    size,
    nullptr);
  return done == CE_None ? image : nullptr;
}

bool Dataset::readBytes(GDALRasterBandH band, unsigned char* lowerLeft, bool fromTop) const
{
  const GSpacing stride = this->width();
  return GDALRasterIOEx(band,
           GF_Read,
           0,
           0,
           this->width(),
           this->height(),
           fromTop ? lowerLeft + stride * (this->height() - 1) : lowerLeft,
           this->width(),
           this->height(),
           GDT_Byte,
           1,
           fromTop ? -stride : stride,
           nullptr) == CE_None;
}

} // namespace oversketch_files
