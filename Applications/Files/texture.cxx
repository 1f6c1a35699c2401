#include "texture.h"

#include "files.h"

#include "vtkFieldData.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>

namespace oversketch_files
{

const char* const textureArray = "Texture";
const char* const notAPicture =
  "no PNG or JPEG picture, a damaged one, or one of more than 16384 pixels a side";

namespace
{

std::uint32_t bigWord(const std::string& bytes, std::size_t at)
{
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  }
  return value;
}

// The sum that ends each chunk of a PNG (ISO 3309).
std::uint32_t checksum(const std::string& bytes, std::size_t from, std::size_t to)
{
  std::uint32_t sum = 0xffffffff;
  for (std::size_t i = from; i < to; ++i)
  {
    sum ^= static_cast<unsigned char>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit)
    {
      sum = (sum >> 1) ^ (sum & 1 ? 0xedb88320 : 0);
    }
  }
  return ~sum;
}

// Every chunk whole, up to the end's: VTK 9.1 crashes on a PNG that breaks off.
bool isWholePng(const std::string& bytes)
{
  for (std::size_t at = 8; at + 12 <= bytes.size();)
  {
    const std::size_t length = bigWord(bytes, at);
    if (length > bytes.size() - at - 12 ||
        checksum(bytes, at + 4, at + 8 + length) != bigWord(bytes, at + 8 + length))
    {
      return false;
    }
    if (bytes.compare(at + 4, 4, "IEND") == 0)
    {
      return true;
    }
    at += 12 + length;
  }
  return false;
}

// The size that the first frame header of a JPEG tells; zeros where there is none.
std::array<std::uint32_t, 2> sizeOfJpeg(const std::string& bytes)
{
  const auto half = [&bytes](std::size_t at) { return static_cast<std::uint32_t>(bigWord(bytes, at) >> 16); };
  for (std::size_t at = 2; at + 12 <= bytes.size();)
  {
    const auto marker = static_cast<unsigned char>(bytes[at + 1]);
    if (static_cast<unsigned char>(bytes[at]) != 0xff)
    {
      break;
    }
    const bool isFrame =
      marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (isFrame)
    {
      return { half(at + 7), half(at + 5) };
    }
    at += marker == 0xff ? 1 : 2 + half(at + 2); // fill bytes may precede a marker
  }
  return { 0, 0 };
}

// Decoders make what a header says of the first bytes on; no packing makes more than this of a byte.
bool isPlausible(const std::array<std::uint32_t, 2>& size, std::size_t bytes)
{
  constexpr std::uint32_t longest = 16384;
  constexpr std::uint64_t mostPixels = 8192;
  return size[0] > 0 && size[1] > 0 && size[0] <= longest && size[1] <= longest &&
         std::uint64_t(size[0]) * size[1] <= mostPixels * bytes;
}

vtkSmartPointer<vtkImageData> updated(vtkImageReader2* reader)
{
  reader->Update();
  const bool good =
    takeError().empty() && reader->GetErrorCode() == 0 && reader->GetOutput()->GetNumberOfPoints() > 0;
  return good ? reader->GetOutput() : nullptr;
}

vtkSmartPointer<vtkImageData> readPng(const std::string& bytes)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
  return updated(reader);
}

// From a file that lies in memory: of bytes in memory vtkJPEGReader reads on behind the end where a length is
// wrong.
vtkSmartPointer<vtkImageData> readJpeg(const std::string& bytes)
{
  const int file = ::memfd_create("oversketch.jpeg", MFD_CLOEXEC);
  const std::string path = "/proc/self/fd/" + std::to_string(file);
  std::ofstream stream(path, std::ios::binary);
  stream << bytes;
  stream.close();
  vtkSmartPointer<vtkImageData> image;
  if (file >= 0 && stream)
  {
    vtkNew<vtkJPEGReader> reader;
    reader->SetFileName(path.c_str());
    image = updated(reader);
  }
  ::close(file);
  return image;
}

} // namespace

std::string textureOf(vtkPolyData* mesh)
{
  auto* array = vtkUnsignedCharArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(textureArray));
  if (!array || array->GetNumberOfValues() == 0 || !mesh->GetPointData()->GetTCoords())
  {
    return {};
  }
  return { reinterpret_cast<const char*>(array->GetPointer(0)),
    static_cast<std::size_t>(array->GetNumberOfValues()) };
}

void setTexture(vtkPolyData* mesh, const std::string& bytes)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(textureArray);
  array->SetNumberOfValues(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), array->GetPointer(0));
  mesh->GetFieldData()->AddArray(array);
}

std::string pictureFormatOf(const std::string& bytes)
{
  if (bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") == 0)
  {
    return "png";
  }
  return bytes.compare(0, 3, "\xff\xd8\xff") == 0 ? "jpeg" : "";
}

vtkSmartPointer<vtkImageData> pictureOf(const std::string& bytes)
{
  const std::string format = pictureFormatOf(bytes);
  takeError();
  if (format == "png" && isWholePng(bytes) && bytes.size() > 33 &&
      isPlausible({ bigWord(bytes, 16), bigWord(bytes, 20) }, bytes.size()))
  {
    return readPng(bytes);
  }
  if (format == "jpeg" && isPlausible(sizeOfJpeg(bytes), bytes.size()))
  {
    return readJpeg(bytes);
  }
  return nullptr;
}

} // namespace oversketch_files
