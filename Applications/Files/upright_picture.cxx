#include "upright_picture.h"

#include "orientation.h"
#include "raster.h"
#include "texture.h"

#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

namespace oversketch_files
{

const char* const pictureExtensions = ".png .jpg .jpeg .webp .bmp .tif .tiff";
const char* const notAnUprightPicture =
  "no PNG, JPEG, WebP, BMP or TIFF picture of 8 or 16 bits, a damaged one, "
  "or one of more than 16384 pixels a side";

namespace
{

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
  else
  {
    image = rasterReader().pixels(bytes, other.c_str());
  }
  return image ? encoded(turnedUpright(image, orientation),
                   worn == "jpeg" && image->GetNumberOfScalarComponents() % 2 == 1)
               : "";
}

} // namespace oversketch_files
