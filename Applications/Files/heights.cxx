#include "heights.h"

#include "files.h"
#include "text.h"
#include "texture.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedShortArray.h"

#include <png.h>
#include <tiffio.h>

#include <algorithm>
#include <cctype>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <vector>

namespace oversketch_files
{

const char* const heightsExtensions = ".png .tif .tiff .pgm .asc .vti";

namespace
{

constexpr int longest = 16384;         // samples a side
constexpr double mostSamples = 8192.0; // a byte: no packing makes more of one

[[noreturn]] void refuse(const std::string& name, const std::string& why)
{
  throw Failed(name + ": " + why);
}

// Throws Failed unless a file of so many bytes can tell so many samples.
void requireSize(const std::string& name, double width, double height, double room)
{
  if (!(width >= 1.0 && height >= 1.0 && width <= longest && height <= longest && width * height <= room))
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

struct PngReader
{
  explicit PngReader(const std::string& file)
    : bytes(file)
  {
  }
  ~PngReader() { png_destroy_read_struct(&this->png, &this->info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  static void give(png_structp png, png_bytep to, std::size_t count)
  {
    auto* self = static_cast<PngReader*>(png_get_io_ptr(png));
    if (count > self->bytes.size() - self->at)
    {
      png_error(png, "truncated");
    }
    std::memcpy(to, self->bytes.data() + self->at, count);
    self->at += count;
  }

  // What comes between libpng's jumps lives here, not on the stack.
  const std::string& bytes;
  std::size_t at = 0;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::vector<png_bytep> rows;

  // Both false where libpng refuses the bytes.
  bool readHead()
  {
    this->png = png_create_read_struct(
      PNG_LIBPNG_VER_STRING,
      nullptr,
      [](png_structp p, png_const_charp) { png_longjmp(p, 1); }, // quiet
      [](png_structp, png_const_charp) {});
    this->info = png_create_info_struct(this->png);
    if (setjmp(png_jmpbuf(this->png)))
    {
      return false;
    }
    png_set_read_fn(this->png, this, give);
    png_read_info(this->png, this->info);
    png_set_swap(this->png); // of 16 bits, whose order in the file is big-endian
    png_set_interlace_handling(this->png);
    png_read_update_info(this->png, this->info);
    return true;
  }
  bool readRows()
  {
    if (setjmp(png_jmpbuf(this->png)))
    {
      return false;
    }
    png_read_image(this->png, this->rows.data());
    return true;
  }
};

// Of 16 bits; raw samples, whatever the file says of gamma. Those of 8 bits are read as pictures are.
vtkSmartPointer<vtkImageData> readPng16(const std::string& name, const std::string& bytes)
{
  PngReader reader(bytes);
  if (!reader.readHead())
  {
    refuse(name, "is a damaged PNG file");
  }
  if (png_get_bit_depth(reader.png, reader.info) != 16)
  {
    return nullptr;
  }
  const int width = static_cast<int>(png_get_image_width(reader.png, reader.info));
  const int height = static_cast<int>(png_get_image_height(reader.png, reader.info));
  requireSize(name, width, height, mostSamples * static_cast<double>(bytes.size()));
  const int channels = png_get_channels(reader.png, reader.info);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_SHORT, channels);
  auto* samples = static_cast<png_bytep>(image->GetScalarPointer());
  const std::size_t stride = std::size_t(2) * static_cast<std::size_t>(width * channels);
  for (int j = height - 1; j >= 0; --j) // rows from the top
  {
    reader.rows.push_back(samples + static_cast<std::size_t>(j) * stride);
  }
  if (!reader.readRows())
  {
    refuse(name, "is a damaged PNG file");
  }
  return image;
}

struct TiffBytes
{
  const std::string& bytes;
  std::size_t at = 0;
};

// libtiff's view of bytes in memory, that says nothing on its own.
TIFF* openTiff(TiffBytes& file)
{
  TIFFSetErrorHandler(nullptr);
  TIFFSetWarningHandler(nullptr);
  const auto read = [](thandle_t handle, void* to, tmsize_t count) -> tmsize_t
  {
    auto& from = *static_cast<TiffBytes*>(handle);
    const std::size_t left = from.bytes.size() - std::min(from.at, from.bytes.size());
    const std::size_t given = std::min(left, static_cast<std::size_t>(std::max<tmsize_t>(count, 0)));
    std::memcpy(to, from.bytes.data() + std::min(from.at, from.bytes.size()), given);
    from.at += given;
    return static_cast<tmsize_t>(given);
  };
  const auto seek = [](thandle_t handle, toff_t to, int whence) -> toff_t
  {
    auto& from = *static_cast<TiffBytes*>(handle);
    from.at = to + (whence == SEEK_CUR ? from.at : whence == SEEK_END ? from.bytes.size() : 0);
    return from.at;
  };
  return TIFFClientOpen(
    "heights",
    "rm", // not mapped
    &file,
    read,
    [](thandle_t, void*, tmsize_t) -> tmsize_t { return 0; },
    seek,
    [](thandle_t) { return 0; },
    [](thandle_t handle) -> toff_t { return static_cast<TiffBytes*>(handle)->bytes.size(); },
    nullptr,
    nullptr);
}

// VTK's type of samples of so many bits, -1 for what is not read.
int typeOfTiff(int bits, int format)
{
  const bool isSigned = format == SAMPLEFORMAT_INT, isReal = format == SAMPLEFORMAT_IEEEFP;
  switch (bits)
  {
    case 8:
      return isReal ? -1 : isSigned ? VTK_TYPE_INT8 : VTK_TYPE_UINT8;
    case 16:
      return isReal ? -1 : isSigned ? VTK_TYPE_INT16 : VTK_TYPE_UINT16;
    case 32:
      return isReal ? VTK_TYPE_FLOAT32 : isSigned ? VTK_TYPE_INT32 : VTK_TYPE_UINT32;
    default:
      return bits == 64 && isReal ? VTK_TYPE_FLOAT64 : -1;
  }
}

// Not vtkTIFFReader: it turns some files upside down.
vtkSmartPointer<vtkImageData> readTiff(const std::string& name, const std::string& bytes)
{
  const std::string fault = "is a damaged TIFF file, or of a kind that is not read; save it with one gray "
                            "value a pixel, of 8, 16 or 32 bits";
  TiffBytes file{ bytes };
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(openTiff(file), TIFFClose);
  std::uint32_t width = 0, height = 0;
  std::uint16_t bits = 1, channels = 1, format = SAMPLEFORMAT_UINT, planes = PLANARCONFIG_CONTIG,
                turn = ORIENTATION_TOPLEFT;
  if (!tiff || !TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width) ||
      !TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height))
  {
    refuse(name, fault);
  }
  requireSize(name, width, height, mostSamples * static_cast<double>(bytes.size()));
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &channels);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLEFORMAT, &format);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_PLANARCONFIG, &planes);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_ORIENTATION, &turn);
  const int type = typeOfTiff(bits, format);
  const bool fromTop = turn == ORIENTATION_TOPLEFT;
  if (type < 0 || channels < 1 || channels > 4 || (channels > 1 && planes != PLANARCONFIG_CONTIG) ||
      (!fromTop && turn != ORIENTATION_BOTLEFT))
  {
    refuse(name, fault);
  }
  const std::size_t size = std::size_t(bits / 8) * channels, stride = size * width; // of a pixel, a row
  // Pixels come in tiles, or in strips, which are tiles as wide as the image.
  std::uint32_t across = width, down = 1;
  const bool isTiled = TIFFIsTiled(tiff.get()) != 0;
  if (isTiled)
  {
    TIFFGetField(tiff.get(), TIFFTAG_TILEWIDTH, &across);
    TIFFGetField(tiff.get(), TIFFTAG_TILELENGTH, &down);
  }
  const tmsize_t block = isTiled ? TIFFTileSize(tiff.get()) : TIFFScanlineSize(tiff.get());
  if (across < 1 || down < 1 || across > 4 * longest || down > 4 * longest ||
      static_cast<std::size_t>(block) != size * across * down)
  {
    refuse(name, fault);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(width), static_cast<int>(height), 1);
  image->AllocateScalars(type, channels);
  auto* const samples = static_cast<char*>(image->GetScalarPointer());
  std::vector<char> read(static_cast<std::size_t>(block));
  for (std::uint32_t y = 0; y < height; y += down)
  {
    for (std::uint32_t x = 0; x < width; x += across)
    {
      const bool good = isTiled ? TIFFReadTile(tiff.get(), read.data(), x, y, 0, 0) >= 0
                                : TIFFReadScanline(tiff.get(), read.data(), y, 0) >= 0;
      if (!good)
      {
        refuse(name, fault);
      }
      for (std::uint32_t k = 0; k < down && y + k < height; ++k)
      {
        const std::uint32_t row = fromTop ? height - 1 - y - k : y + k;
        std::memcpy(samples + row * stride + x * size,
          read.data() + k * across * size,
          std::min(across, width - x) * size);
      }
    }
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

std::string lowerCase(std::string_view word)
{
  std::string text(word);
  std::transform(text.begin(),
    text.end(),
    text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
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
  Words words(heightsExtensions);
  for (std::string_view word = words.next(); !word.empty(); word = words.next())
  {
    if (word == extension)
    {
      return true;
    }
  }
  return false;
}

std::string heightsFormatOf(const std::string& bytes)
{
  if (pictureFormatOf(bytes) == "png")
  {
    return "png";
  }
  if (bytes.compare(0, 4, std::string("II*\0", 4)) == 0 || bytes.compare(0, 4, std::string("MM\0*", 4)) == 0)
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
    const vtkSmartPointer<vtkImageData> fine = readPng16(name, bytes);
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
