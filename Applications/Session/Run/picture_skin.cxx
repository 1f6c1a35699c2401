#include "picture_skin.h"

#include "png_picture.h"

#include "Raster/skin.h"
#include "texture.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkImageFlip.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace oversketch_session
{

using namespace oversketch;
namespace
{

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

std::string skinFor(vtkPolyData* mesh, int part, const std::string& bytes, vtkImageData* image, bool fromRim)
{
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
  vtkNew<vtkImageFlip> mirrored; // as the back is seen from behind
  if (fromRim)
  {
    mirrored->SetInputData(image);
    mirrored->Update();
    image = mirrored->GetOutput();
  }
  const PictureSamples picture{ static_cast<const std::uint8_t*>(image->GetScalarPointer()),
    width,
    height,
    image->GetNumberOfScalarComponents() };
  const std::vector<std::uint8_t> skin = (fromRim ? rimSkinOf : skinOf)(picture, covered, ThreadsOnly());
  return oversketch_files::pictureFormatOf(bytes) == "jpeg" ? jpegOf(skin, width, height, picture.colours())
                                                            : pngOf(skin, width, height, picture.colours());
}

void wearPictures(const Step& step, const SystemRow& row, const DecodedInput& decoded, vtkPolyData* mesh)
{
  const auto imageOf = [&](const std::string& name)
  {
    const auto given = step.inputs.find(name);
    return given == step.inputs.end() ? nullptr : std::get_if<Image>(&given->second);
  };
  const Image *front = imageOf(row.textureInput), *back = imageOf(row.backTextureInput);
  const Parameter* rim = findParameter(row, row.backFromRim);
  const bool fromRim = front && !back && rim && std::get<bool>(valueOf(step, *rim));
  const auto put = [&](const Image* image, const std::string& name, int part, const std::string& prefix)
  {
    if (image)
    {
      oversketch_files::setTexture(mesh,
        row.skin ? skinFor(mesh, part, *image->bytes, decoded(name), fromRim && part == 1) : *image->bytes,
        prefix);
    }
  };
  if (mesh->GetPointData()->GetTCoords())
  {
    put(front, row.textureInput, 0, back || fromRim ? "Part0." : "");
    put(fromRim ? front : back, fromRim ? row.textureInput : row.backTextureInput, 1, "Part1.");
  }
}

} // namespace oversketch_session
