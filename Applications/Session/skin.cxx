#include "skin.h"

#include "Raster/skin.h"
#include "texture.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <png.h>
#include <stdexcept>

namespace oversketch_session
{
namespace
{

std::string pngOf(const std::vector<std::uint8_t>& samples, int width, int height, int colours)
{
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(width);
  png.height = static_cast<png_uint_32>(height);
  png.format = colours == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
  png.flags = PNG_IMAGE_FLAG_FAST;
  const auto stride = static_cast<png_int_32>(width * colours);
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = bytes.size();
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, samples.data(), -stride, nullptr))
  {
    throw std::runtime_error(std::string("the picture cannot be written: ") + png.message);
  }
  bytes.resize(size);
  return bytes;
}

std::string jpegOf(const std::vector<std::uint8_t>& samples, int width, int height, int colours)
{
  constexpr int quality = 95;
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, colours);
  std::copy(samples.begin(), samples.end(), static_cast<std::uint8_t*>(image->GetScalarPointer()));
  vtkNew<vtkJPEGWriter> writer;
  writer->SetInputData(image);
  writer->SetQuality(quality);
  writer->ProgressiveOff();
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* made = writer->GetResult();
  return { reinterpret_cast<const char*>(made->GetPointer(0)),
    static_cast<std::size_t>(made->GetNumberOfValues()) };
}

} // namespace

std::string skinFor(vtkPolyData* mesh, int part, const std::string& bytes)
{
  using namespace oversketch;
  const vtkSmartPointer<vtkImageData> image = oversketch_files::pictureOf(bytes);
  vtkDataArray* places = mesh->GetPointData()->GetTCoords();
  if (!image || image->GetScalarType() != VTK_UNSIGNED_CHAR || !places)
  {
    return bytes;
  }
  const int *size = image->GetDimensions(), width = size[0], height = size[1];
  vtkDataArray* parts = mesh->GetCellData()->GetArray("PartId");
  std::vector<PictureTriangle> covered;
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    if (parts && parts->GetComponent(face, 0) != part)
    {
      continue;
    }
    mesh->GetPolys()->GetCellAtId(face, ids);
    const auto place = [&](vtkIdType k)
    {
      const vtkIdType point = ids->GetId(k);
      return Vector2(width * places->GetComponent(point, 0), height * places->GetComponent(point, 1));
    };
    for (vtkIdType k = 1; k + 1 < ids->GetNumberOfIds(); ++k)
    {
      covered.push_back({ place(0), place(k), place(k + 1) });
    }
  }
  const PictureSamples picture{ static_cast<const std::uint8_t*>(image->GetScalarPointer()),
    width,
    height,
    image->GetNumberOfScalarComponents() };
  const std::vector<std::uint8_t> skin = skinOf(picture, covered, Context());
  return oversketch_files::pictureFormatOf(bytes) == "jpeg" ? jpegOf(skin, width, height, picture.colours())
                                                            : pngOf(skin, width, height, picture.colours());
}

} // namespace oversketch_session
