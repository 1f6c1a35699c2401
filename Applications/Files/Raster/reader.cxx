// The module oversketch_raster, all that knows GDAL.
#include "raster.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_frmts.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace oversketch_files
{

namespace
{

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
bool isSmallEnough(GDALDatasetH data, std::size_t bytes)
{
  const int width = GDALGetRasterXSize(data), height = GDALGetRasterYSize(data);
  if (width < 1 || height < 1 ||
      !isPlausible(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), bytes) ||
      GDALGetRasterCount(data) < 1)
  {
    return false;
  }
  int across = 0, down = 0;
  GDALGetBlockSize(GDALGetRasterBand(data, 1), &across, &down);
  return across <= 4 * longestSide && down <= 4 * longestSide;
}

// A file that GDAL has open, as long as this lives, which is on one thread and shorter than its bytes. GDAL
// says nothing on its own meanwhile.
class Dataset
{
public:
  // Nothing but the head is read. `format`: as rasterFormatOf names it.
  Dataset(const std::string& bytes, const char* format)
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
    if (this->Data && !isSmallEnough(this->Data, bytes.size()))
    {
      GDALClose(this->Data);
      this->Data = nullptr;
    }
  }
  ~Dataset()
  {
    if (this->Data)
    {
      GDALClose(this->Data);
    }
    VSIUnlink(this->Name.c_str());
    CPLPopErrorHandler();
  }
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
  vtkSmartPointer<vtkImageData> samples(int type, int count, bool fromTop) const
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
  // Reads a band of one byte a sample, such as a mask of the first, in the same order.
  bool readBytes(GDALRasterBandH band, unsigned char* lowerLeft, bool fromTop) const
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

private:
  std::string Name;
  GDALDatasetH Data = nullptr;
};

// Number of bands that count: the colours, where the file says that it is of these, else one.
int heightBands(const Dataset& file)
{
  const bool isColour = file.bands() >= 3 && GDALGetRasterColorInterpretation(file.band(1)) == GCI_RedBand;
  return isColour ? 3 : 1;
}

// Where a grid lies on its map.
struct Place
{
  double spacing[3] = { 1.0, 1.0, 1.0 };
  double origin[3] = { 0.0, 0.0, 0.0 }; // of the lower left sample
  bool fromTop = true;                  // whether the first row is the uppermost one
};

// Reads it from the file's geo-transform, where it has one; false where the grid does not lie along the axes.
bool placeOnMap(const Dataset& file, Place& place)
{
  double map[6]; // of a corner of the first sample: x = map[0] + column map[1] + row map[2], likewise y
  if (GDALGetGeoTransform(file.data(), map) != CE_None)
  {
    return true;
  }
  constexpr double slack = 1e-3; // of a cell, over the whole grid
  if (!(map[1] > 0.0 && std::abs(map[2]) * file.height() <= slack * map[1] &&
        std::abs(map[4]) * file.width() <= slack * std::abs(map[5]) && map[1] < 1e12 &&
        std::abs(map[5]) < 1e12))
  {
    return false;
  }
  place.fromTop = map[5] < 0.0;
  place.spacing[0] = map[1];
  place.spacing[1] = std::abs(map[5]);
  place.origin[0] = map[0] + 0.5 * map[1];
  place.origin[1] = map[3] + (place.fromTop ? file.height() - 0.5 : 0.5) * map[5];
  return true;
}

// How a file's numbers become heights.
struct Scaling
{
  explicit Scaling(GDALRasterBandH band)
  {
    int hasFactor = 0, hasOffset = 0;
    const double given[] = { GDALGetRasterScale(band, &hasFactor), GDALGetRasterOffset(band, &hasOffset) };
    factor = hasFactor ? given[0] : 1.0;
    offset = hasOffset ? given[1] : 0.0;
    const char* const kind = GDALGetMetadataItem(band, "PIXELTYPE", "IMAGE_STRUCTURE");
    isSignedByte = kind && std::string(kind) == "SIGNEDBYTE";
  }

  bool isNone() const { return factor == 1.0 && offset == 0.0 && !isSignedByte; }
  double heightOf(double sample) const
  {
    return offset + factor * (sample - (isSignedByte && sample > 127.0 ? 256.0 : 0.0));
  }

  double factor, offset;
  bool isSignedByte; // which GDAL before 3.7 gives unsigned
};

vtkSmartPointer<vtkImageData> heightsOf(const std::string& bytes, bool fromTop, bool& isTurned)
{
  const Dataset file(bytes, "GTiff");
  const GDALDataType type = file.isOpen() ? GDALGetRasterDataType(file.band(1)) : GDT_Unknown;
  Place place;
  place.fromTop = fromTop;
  if (!file.isOpen() || GDALDataTypeIsComplex(type) || (isTurned = !placeOnMap(file, place)))
  {
    return nullptr;
  }
  const int bands = heightBands(file);
  const Scaling scaling(file.band(1));
  const bool isSingle = GDALGetDataTypeSizeBits(type) <= 16 || type == GDT_Float32; // each number of it
  const bool isScaled = scaling.factor != 1.0 || scaling.offset != 0.0;
  auto image = file.samples(isSingle && !isScaled ? VTK_FLOAT : VTK_DOUBLE, bands, place.fromTop);
  // Samples without data are told by a number, by a mask or by transparency.
  std::vector<unsigned char> known(static_cast<std::size_t>(file.width()) * file.height(), 255);
  const bool isMasked = (GDALGetMaskFlags(file.band(1)) & GMF_ALL_VALID) == 0;
  if (!image || (isMasked && !file.readBytes(GDALGetMaskBand(file.band(1)), known.data(), place.fromTop)))
  {
    return nullptr;
  }
  image->SetSpacing(place.spacing);
  image->SetOrigin(place.origin);
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  heights->SetName("Heights");
  for (std::size_t i = 0; (isMasked || !scaling.isNone()) && i < known.size(); ++i)
  {
    for (int k = 0; k < bands; ++k)
    {
      const auto at = static_cast<vtkIdType>(i);
      heights->SetComponent(at,
        k,
        known[i] ? scaling.heightOf(heights->GetComponent(at, k)) : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return image;
}

vtkSmartPointer<vtkImageData> fineSamplesOf(const std::string& bytes)
{
  const Dataset file(bytes, "PNG");
  const bool isFine = file.isOpen() && GDALGetRasterDataType(file.band(1)) == GDT_UInt16;
  return isFine ? file.samples(VTK_UNSIGNED_SHORT, file.bands(), true) : nullptr;
}

// How many channels of 8 bits a palette needs.
int channelsOf(GDALColorTableH palette)
{
  for (int i = 0; i < GDALGetColorEntryCount(palette); ++i)
  {
    if (GDALGetColorEntry(palette, i)->c4 != 255)
    {
      return 4;
    }
  }
  return 3;
}

// How many bands of a file are gray or colours, and transparency where it is there.
int channelsOf(const Dataset& file)
{
  const auto isAlpha = [&file](int band)
  { return GDALGetRasterColorInterpretation(file.band(band)) == GCI_AlphaBand; };
  const int bands = file.bands(), colours = bands < 3 ? 1 : 3;
  return colours + (bands > colours && isAlpha(colours + 1) ? 1 : 0);
}

// Picture of 8 bits a channel; null for other samples than of 8 or 16 bits, and for damaged ones. GDAL makes
// colours of inks, and a palette of samples of which 0 is white.
vtkSmartPointer<vtkImageData> pixelsOf(const std::string& bytes, const char* format)
{
  const Dataset file(bytes, format);
  const GDALDataType type = file.isOpen() ? GDALGetRasterDataType(file.band(1)) : GDT_Unknown;
  if (type != GDT_Byte && type != GDT_UInt16)
  {
    return nullptr;
  }
  GDALColorTableH const palette = GDALGetRasterColorTable(file.band(1));
  const int given = palette ? 1 : channelsOf(file), made = palette ? channelsOf(palette) : given;
  const auto samples = file.samples(VTK_UNSIGNED_SHORT, given, true);
  if (!samples)
  {
    return nullptr;
  }
  const char* const bits = GDALGetMetadataItem(file.band(1), "NBITS", "IMAGE_STRUCTURE");
  const unsigned most = (1U << std::clamp(bits ? std::atoi(bits) : type == GDT_Byte ? 8 : 16, 1, 16)) - 1U;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(samples->GetDimensions());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, made);
  const auto* from = static_cast<const unsigned short*>(samples->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i, from += given, to += made)
  {
    if (palette)
    {
      const GDALColorEntry* const entry = GDALGetColorEntry(palette, *from); // null beyond its end
      const GDALColorEntry colour = entry ? *entry : GDALColorEntry{ 0, 0, 0, 255 };
      const short channels[] = { colour.c1, colour.c2, colour.c3, colour.c4 };
      std::transform(
        channels, channels + made, to, [](short value) { return static_cast<unsigned char>(value); });
      continue;
    }
    std::transform(from,
      from + given,
      to,
      [most](unsigned value) { return static_cast<unsigned char>(std::min(value, most) * 255U / most); });
  }
  return image;
}

} // namespace

} // namespace oversketch_files

extern "C" __attribute__((visibility("default")))
const oversketch_files::RasterReader oversketch_raster_reader = { oversketch_files::heightsOf,
  oversketch_files::fineSamplesOf,
  oversketch_files::pixelsOf };
