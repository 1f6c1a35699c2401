#include "heights.h"

#include "files.h"
#include "raster.h"
#include "text.h"
#include "texture.h"
#include "upright_picture.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>

namespace oversketch_files
{

const char* const heightsExtensions = ".png .tif .tiff .pgm .asc .vti";

namespace
{

// Throws Failed unless a file of so many bytes can tell so many samples.
void requireSize(const std::string& name, double width, double height, double room)
{
  if (!(width >= 1.0 && height >= 1.0 && width <= longestSide && height <= longestSide &&
        width * height <= room))
  {
    refuse(name,
      "announces more samples than 16384 a side, or than it holds, or none; the file is damaged or too "
      "large");
  }
}

template <typename Array>
Array* allocated(vtkImageData* image, double width, double height)
{
  image->SetDimensions(static_cast<int>(width), static_cast<int>(height), 1);
  vtkNew<Array> samples;
  samples->SetName("Heights");
  samples->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->SetScalars(samples);
  return samples;
}

// Samples of 16 bits, of which VTK's reader makes 8 and a gamma; null for others.
vtkSmartPointer<vtkImageData> readPng16(const std::string& bytes)
{
  constexpr std::size_t depth = 24; // where the head tells it
  return bytes.size() > depth && bytes[depth] == 16 ? rasterReader().fineSamples(bytes) : nullptr;
}

// Not vtkTIFFReader: it turns some files upside down, and knows no map.
vtkSmartPointer<vtkImageData> readTiff(const std::string& name, const std::string& bytes)
{
  const int orientation = orientationOf(bytes);
  bool isTurned = false;
  auto image = orientation == 1 || orientation == 4
                 ? rasterReader().heights(bytes, orientation == 1, isTurned)
                 : nullptr;
  if (!image)
  {
    refuse(name,
      isTurned ? "its grid is turned or mirrored against the axes of its map; lay it along them first "
                 "(gdalwarp does)"
               : "is a damaged TIFF file, or of a kind that is not read, or announces more samples than "
                 "16384 a side "
                 "or than it holds; save it with one gray value a pixel, of 8, 16, 32 or 64 bits");
  }
  return image;
}

// The next word of a PGM's head, in which '#' begins a comment.
double pgmNumber(const std::string& name, const std::string& bytes, std::size_t& at)
{
  while (at < bytes.size() && (std::isspace(static_cast<unsigned char>(bytes[at])) || bytes[at] == '#'))
  {
    at = bytes[at] == '#' ? std::min(bytes.find('\n', at), bytes.size()) : at + 1;
  }
  Words words(bytes, at);
  const std::optional<double> number = numberOf(words.next());
  at = words.at();
  if (!number)
  {
    refuse(name, "is a damaged PGM file: its head breaks off");
  }
  return *number;
}

vtkSmartPointer<vtkImageData> readPgm(const std::string& name, const std::string& bytes)
{
  std::size_t at = 2;
  const double width = pgmNumber(name, bytes, at), height = pgmNumber(name, bytes, at);
  const double most = pgmNumber(name, bytes, at);
  const bool isText = bytes[1] == '2';
  const std::size_t size = isText ? 1 : most < 256.0 ? 1 : 2; // bytes a sample, at least
  ++at;                                                       // one white space
  requireSize(name, width, height, static_cast<double>(bytes.size()) / static_cast<double>(size));
  if (!(most >= 1.0 && most <= 65535.0) ||
      (!isText && static_cast<double>(bytes.size() - std::min(at, bytes.size())) <
                    width * height * static_cast<double>(size)))
  {
    refuse(name, "is a damaged PGM file: it has fewer samples than its head says, or another range");
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  auto* samples = allocated<vtkUnsignedShortArray>(image, width, height);
  Words words(bytes, std::min(at, bytes.size()));
  const auto columns = static_cast<vtkIdType>(width);
  for (auto j = static_cast<vtkIdType>(height) - 1; j >= 0; --j) // rows from the top
  {
    for (vtkIdType i = 0; i < columns; ++i)
    {
      unsigned value = 0;
      if (isText)
      {
        const std::optional<double> number = numberOf(words.next());
        if (!number || !(*number >= 0.0 && *number <= most))
        {
          refuse(name,
            "is a damaged PGM file: sample " + std::to_string(i) + " of a row is no number of its range");
        }
        value = static_cast<unsigned>(*number);
      }
      for (std::size_t k = 0; !isText && k < size; ++k)
      {
        value = value << 8 | static_cast<unsigned char>(bytes[at++]);
      }
      samples->SetValue(j * columns + i, static_cast<unsigned short>(value));
    }
  }
  return image;
}

vtkSmartPointer<vtkImageData> readAsc(const std::string& name, const std::string& bytes)
{
  std::map<std::string, double> head;
  Words words(bytes);
  std::size_t at = 0;
  for (std::string_view word = words.next();
       !word.empty() && std::isalpha(static_cast<unsigned char>(word[0]));
       word = words.next())
  {
    const std::string key = lowerCase(word);
    const std::string_view text = words.next();
    const std::optional<double> value = numberOf(text);
    if (!value)
    {
      refuse(name, "is a damaged ASCII grid: its " + key + " is " + inQuotes(text) + ", no number");
    }
    head[key] = *value;
    at = words.at();
  }
  for (const char* key : { "ncols", "nrows" })
  {
    if (head.count(key) == 0)
    {
      refuse(
        name, std::string("is an ASCII grid without ") + key + "; its head has lines such as \"ncols 100\"");
    }
  }
  const double width = head["ncols"], height = head["nrows"];
  requireSize(name, width, height, 0.5 * static_cast<double>(bytes.size()) + 1.0);
  const double cell = head.count("cellsize") ? head["cellsize"] : 1.0;
  const double dx = head.count("dx") ? head["dx"] : cell, dy = head.count("dy") ? head["dy"] : cell;
  if (!(dx > 0.0 && dy > 0.0 && dx < 1e12 && dy < 1e12))
  {
    refuse(name, "is an ASCII grid whose cellsize is not a positive number");
  }
  const double missing = head.count("nodata_value") ? head["nodata_value"] : -9999.0;
  auto image = vtkSmartPointer<vtkImageData>::New();
  auto* samples = allocated<vtkDoubleArray>(image, width, height);
  image->SetSpacing(dx, dy, 1.0);
  const auto origin = [&head](const std::string& axis, double side)
  {
    const double corner = head.count(axis + "llcorner") ? head[axis + "llcorner"] + 0.5 * side : 0.0;
    return head.count(axis + "llcenter") ? head[axis + "llcenter"] : corner;
  };
  image->SetOrigin(origin("x", dx), origin("y", dy), 0.0);
  words = Words(bytes, at);
  const auto columns = static_cast<vtkIdType>(width), rows = static_cast<vtkIdType>(height);
  for (vtkIdType j = 0; j < rows; ++j) // rows from the top
  {
    for (vtkIdType i = 0; i < columns; ++i)
    {
      const std::string_view word = words.next();
      const std::optional<double> value = numberOf(word);
      if (!value)
      {
        refuse(name,
          word.empty() ? "is an ASCII grid that breaks off in row " + std::to_string(j)
                       : "is an ASCII grid with " + inQuotes(word) + " in row " + std::to_string(j) +
                           ", column " + std::to_string(i) + "; write a number or NODATA_value there");
      }
      samples->SetValue(
        (rows - 1 - j) * columns + i, *value == missing ? std::numeric_limits<double>::quiet_NaN() : *value);
    }
  }
  return image;
}

} // namespace

bool isHeightsExtension(const std::string& extension)
{
  return isAmong(extension, heightsExtensions);
}

std::string heightsFormatOf(const std::string& bytes)
{
  if (pictureFormatOf(bytes) == "png")
  {
    return "png";
  }
  if (rasterFormatOf(bytes) == "GTiff")
  {
    return "tif";
  }
  if (bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == '2' || bytes[1] == '5') &&
      std::isspace(static_cast<unsigned char>(bytes[2])))
  {
    return "pgm";
  }
  if (lowerCase(std::string_view(bytes).substr(0, 5)) == "ncols")
  {
    return "asc";
  }
  return bytes.substr(0, 512).find("<VTKFile") != std::string::npos ? "vti" : "";
}

vtkSmartPointer<vtkImageData> parseHeights(const std::string& name, const std::string& bytes)
{
  const std::string format = heightsFormatOf(bytes);
  if (format == "png")
  {
    const vtkSmartPointer<vtkImageData> fine = readPng16(bytes);
    const vtkSmartPointer<vtkImageData> image = fine ? fine : pictureOf(bytes);
    return image ? image : (refuse(name, std::string("is ") + notAPicture), nullptr);
  }
  if (format == "tif")
  {
    return readTiff(name, bytes);
  }
  if (format == "pgm")
  {
    return readPgm(name, bytes);
  }
  if (format == "asc")
  {
    return readAsc(name, bytes);
  }
  if (format == "vti")
  {
    return readVti(name, bytes);
  }
  refuse(name, std::string("is no grid of heights; give one of ") + heightsExtensions);
}

} // namespace oversketch_files
