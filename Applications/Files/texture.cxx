#include "texture.h"

#include "raster.h"
#include "text.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <png.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <memory>

namespace oversketch_files
{

const char* const textureArray = "Texture";
const char* const notAPicture =
  "no PNG or JPEG picture, a damaged one, or one of more than 16384 pixels a side";

namespace
{

// The size that the first frame header of a JPEG tells; zeros where there is none.
std::array<std::uint64_t, 2> sizeOfJpeg(const std::string& bytes)
{
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
      return { wholeAt(bytes, at + 7, 2, true), wholeAt(bytes, at + 5, 2, true) };
    }
    at += marker == 0xff ? 1 : 2 + wholeAt(bytes, at + 2, 2, true); // fill bytes may precede a marker
  }
  return { 0, 0 };
}

// By libpng's own simple interface: vtkPNGReader of VTK 9.1 crashes on most pictures that libpng refuses.
vtkSmartPointer<vtkImageData> readPng(const std::string& bytes)
{
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> whole(&png, png_image_free);
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) ||
      !isPlausible(png.width, png.height, bytes.size()))
  {
    return nullptr;
  }
  png.format &= PNG_FORMAT_FLAG_COLOR | PNG_FORMAT_FLAG_ALPHA; // 8 bits each, no palette
  const int components = static_cast<int>(PNG_IMAGE_SAMPLE_CHANNELS(png.format));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(png.width), static_cast<int>(png.height), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  // Rows from the top; VTK's go from the bottom.
  const bool read = png_image_finish_read(&png,
                      nullptr,
                      image->GetScalarPointer(),
                      -static_cast<png_int_32>(PNG_IMAGE_ROW_STRIDE(png)),
                      nullptr) != 0;
  return read ? image : nullptr;
}

// From a file that lies in memory: of bytes in memory vtkJPEGReader reads on behind the end where a length is
// wrong. Its errors are heard from itself: those that the process takes (takeError) may be another thread's.
vtkSmartPointer<vtkImageData> readJpeg(const std::string& bytes)
{
  const int file = ::memfd_create("oversketch.jpeg", MFD_CLOEXEC);
  const std::string path = "/proc/self/fd/" + std::to_string(file);
  std::ofstream stream(path, std::ios::binary);
  stream << bytes;
  stream.close();
  bool failed = file < 0 || !stream;
  vtkNew<vtkCallbackCommand> hears;
  hears->SetClientData(&failed);
  hears->SetCallback([](vtkObject*, unsigned long, void* to, void*) { *static_cast<bool*>(to) = true; });
  vtkNew<vtkJPEGReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, hears);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, hears);
  reader->SetFileName(path.c_str());
  if (!failed)
  {
    reader->Update();
  }
  ::close(file);
  const bool good = !failed && reader->GetErrorCode() == 0 && reader->GetOutput()->GetNumberOfPoints() > 0;
  return good ? reader->GetOutput() : nullptr;
}

} // namespace

std::string textureOf(vtkPolyData* mesh, const std::string& prefix)
{
  auto* array = vtkUnsignedCharArray::SafeDownCast(
    mesh->GetFieldData()->GetAbstractArray((prefix + textureArray).c_str()));
  if (!array || array->GetNumberOfValues() == 0 || !mesh->GetPointData()->GetTCoords())
  {
    return {};
  }
  return { reinterpret_cast<const char*>(array->GetPointer(0)),
    static_cast<std::size_t>(array->GetNumberOfValues()) };
}

void setTexture(vtkPolyData* mesh, const std::string& bytes, const std::string& prefix)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName((prefix + textureArray).c_str());
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
  if (format == "png")
  {
    return readPng(bytes);
  }
  const auto [width, height] = sizeOfJpeg(bytes);
  return format == "jpeg" && isPlausible(width, height, bytes.size()) ? readJpeg(bytes) : nullptr;
}

std::string pictureIn(const std::string& file,
  const std::string& name,
  const std::string& path,
  std::vector<std::string>& notes)
{
  std::string bytes = wholeFile(file);
  if (!pictureOf(bytes))
  {
    bytes.clear();
    notes.push_back(path + ": the picture " + printable(name) + " is " + notAPicture);
  }
  return bytes;
}

} // namespace oversketch_files
