#include "upright_picture.h"

#include "raster.h"
#include "text.h"
#include "texture.h"

#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

namespace oversketch_files
{

const char* const pictureExtensions = ".png .jpg .jpeg .webp .bmp .tif .tiff";
const char* const notAnUprightPicture =
  "no PNG, JPEG, WebP, BMP or TIFF picture of 8 or 16 bits, a damaged one, "
  "or one of more than 16384 pixels a side";

namespace
{

constexpr std::uint64_t nowhere = ~std::uint64_t(0);

bool hasAt(const std::string& bytes, std::uint64_t at, const std::string& what)
{
  return at <= bytes.size() && bytes.compare(at, what.size(), what) == 0;
}

// Where the Exif data begins in a JPEG: in a segment before the picture's own.
std::uint64_t exifOfJpeg(const std::string& bytes)
{
  for (std::uint64_t at = 2; at + 4 <= bytes.size() && bytes[at] == '\xff' && bytes[at + 1] != '\xda';)
  {
    if (bytes[at + 1] == '\xe1' && hasAt(bytes, at + 4, std::string("Exif\0\0", 6)))
    {
      return at + 10;
    }
    at += bytes[at + 1] == '\xff' ? 1 : 2 + wholeAt(bytes, at + 2, 2, true); // fill bytes may precede
  }
  return nowhere;
}

// A PNG is a list of chunks: length, name, data, sum. So is a WebP, without sums, of even lengths.
std::uint64_t chunkOf(const std::string& bytes, bool isPng)
{
  const std::string name = isPng ? "eXIf" : "EXIF";
  for (std::uint64_t at = isPng ? 8 : 12; at + 8 <= bytes.size();)
  {
    if (hasAt(bytes, at + (isPng ? 4 : 0), name))
    {
      at += 8;
      return at + (hasAt(bytes, at, std::string("Exif\0\0", 6)) ? 6 : 0); // as some programs write it
    }
    const std::uint64_t size = wholeAt(bytes, at + (isPng ? 0 : 4), 4, isPng);
    at += isPng ? 12 + size : 8 + size + size % 2;
  }
  return nowhere;
}

// Exif data is a TIFF file without a picture.
std::uint64_t tiffOf(const std::string& bytes)
{
  if (hasAt(bytes, 0, "\xff\xd8"))
  {
    return exifOfJpeg(bytes);
  }
  if (hasAt(bytes, 0, "\x89PNG") || hasAt(bytes, 8, "WEBP"))
  {
    return chunkOf(bytes, bytes[1] == 'P');
  }
  return 0;
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

int orientationOf(const std::string& bytes)
{
  const std::uint64_t start = tiffOf(bytes);
  const bool bigEndian = hasAt(bytes, start, "MM");
  if (!bigEndian && !hasAt(bytes, start, "II"))
  {
    return 1;
  }
  const auto number = [&](std::uint64_t at, std::size_t size) { return wholeAt(bytes, at, size, bigEndian); };
  const bool isLarge = number(start + 2, 2) == 43; // BigTIFF
  const std::size_t offset = isLarge ? 8 : 4;      // bytes of one
  std::uint64_t at = start + number(start + (isLarge ? 8 : 4), offset);
  const std::uint64_t tags = number(at, isLarge ? 8 : 2);
  at += isLarge ? 8 : 2;
  for (std::uint64_t k = 0; k < tags && at < bytes.size(); ++k, at += isLarge ? 20 : 12)
  {
    if (number(at, 2) == 0x0112)
    {
      const std::uint64_t said = number(at + 4 + offset, 2);
      return said >= 1 && said <= 8 ? static_cast<int>(said) : 1;
    }
  }
  return 1;
}

vtkSmartPointer<vtkImageData> turnedUpright(vtkImageData* image, int orientation)
{
  if (orientation == 1)
  {
    return image;
  }
  const bool turns = orientation >= 5; // the file's rows are columns
  // Whether the file's first row is the lower or right one, and its first column the right or lower one.
  const bool rowsBack = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  const bool columnsBack = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const int width = image->GetDimensions()[0], height = image->GetDimensions()[1];
  auto upright = vtkSmartPointer<vtkImageData>::New();
  upright->SetDimensions(turns ? height : width, turns ? width : height, 1);
  upright->AllocateScalars(image->GetScalarType(), image->GetNumberOfScalarComponents());
  vtkDataArray* from = image->GetPointData()->GetScalars();
  vtkDataArray* to = upright->GetPointData()->GetScalars();
  for (int row = 0; row < height; ++row) // the file's, from its first one
  {
    for (int column = 0; column < width; ++column)
    {
      const int down = rowsBack ? height - 1 - row : row, right = columnsBack ? width - 1 - column : column;
      const int x = turns ? down : right, y = turns ? right : down; // from the upper left
      to->SetTuple(vtkIdType(upright->GetDimensions()[1] - 1 - y) * upright->GetDimensions()[0] + x,
        vtkIdType(height - 1 - row) * width + column,
        from);
    }
  }
  return upright;
}

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
  else
  {
    image = rasterReader().pixels(bytes, other.c_str());
  }
  return image ? encoded(turnedUpright(image, orientation),
                   worn == "jpeg" && image->GetNumberOfScalarComponents() % 2 == 1)
               : "";
}

} // namespace oversketch_files
