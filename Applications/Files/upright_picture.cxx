#include "upright_picture.h"

#include "orientation.h"
#include "raster.h"
#include "texture.h"

#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <gdal.h>

#include <algorithm>
#include <cstdlib>

namespace oversketch_files
{

const char* const pictureExtensions = ".png .jpg .jpeg .webp .bmp .tif .tiff";
const char* const notAnUprightPicture =
  "no PNG, JPEG, WebP, BMP or TIFF picture of 8 or 16 bits, a damaged one, "
  "or one of more than 16384 pixels a side";

namespace
{

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
int channelsOf(const Raster& raster)
{
  const auto isAlpha = [&raster](int band)
  { return GDALGetRasterColorInterpretation(raster.band(band)) == GCI_AlphaBand; };
  const int bands = raster.bands(), colours = bands < 3 ? 1 : 3;
  return colours + (bands > colours && isAlpha(colours + 1) ? 1 : 0);
}

// Of 8 bits a channel; null for other samples than of 8 or 16 bits, and for damaged ones. GDAL makes colours
// of inks, and a palette of samples of which 0 is white.
vtkSmartPointer<vtkImageData> pixelsOf(const Raster& raster)
{
  const GDALDataType type = GDALGetRasterDataType(raster.band(1));
  if (type != GDT_Byte && type != GDT_UInt16)
  {
    return nullptr;
  }
  GDALColorTableH const palette = GDALGetRasterColorTable(raster.band(1));
  const int given = palette ? 1 : channelsOf(raster), made = palette ? channelsOf(palette) : given;
  const auto samples = raster.samples(VTK_UNSIGNED_SHORT, given, true);
  if (!samples)
  {
    return nullptr;
  }
  const char* const bits = GDALGetMetadataItem(raster.band(1), "NBITS", "IMAGE_STRUCTURE");
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

std::string encoded(vtkImageData* image, bool asJpeg)
{
  const auto bytesOf = [image](auto* writer)
  {
    writer->SetInputData(image);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* const bytes = writer->GetResult();
    return bytes ? std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                     static_cast<std::size_t>(bytes->GetNumberOfValues()))
                 : std::string();
  };
  if (!asJpeg)
  {
    return bytesOf(vtkNew<vtkPNGWriter>().Get());
  }
  vtkNew<vtkJPEGWriter> writer;
  writer->SetQuality(95);
  return bytesOf(writer.Get());
}

} // namespace

std::string uprightPicture(const std::string& bytes)
{
  const std::string worn = pictureFormatOf(bytes), other = rasterFormatOf(bytes);
  const int orientation = orientationOf(bytes);
  if ((!worn.empty() && orientation == 1) || (worn.empty() && other.empty()))
  {
    return bytes;
  }
  vtkSmartPointer<vtkImageData> image;
  if (!worn.empty())
  {
    image = pictureOf(bytes);
  }
  else if (const Raster raster(bytes, other.c_str()); raster.isOpen())
  {
    image = pixelsOf(raster);
  }
  return image ? encoded(turnedUpright(image, orientation),
                   worn == "jpeg" && image->GetNumberOfScalarComponents() % 2 == 1)
               : "";
}

} // namespace oversketch_files
