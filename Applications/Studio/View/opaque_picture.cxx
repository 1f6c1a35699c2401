#include "opaque_picture.h"

#include "Raster/skin.h"
#include "vtkOversketchFilterTools.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace oversketch_studio
{

vtkSmartPointer<vtkImageData> opaquePicture(vtkImageData* picture)
{
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  const int parts = pixels ? pixels->GetNumberOfComponents() : 0; // of a pixel
  if (parts != 2 && parts != 4)
  {
    return picture;
  }
  const int* size = picture->GetDimensions();
  const std::vector<std::uint8_t> opaque =
    oversketch::opaqueOf({ pixels->GetPointer(0), size[0], size[1], parts }, oversketch::ThreadsOnly());
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(parts - 1);
  colours->SetNumberOfTuples(pixels->GetNumberOfTuples());
  std::copy(opaque.begin(), opaque.end(), colours->GetPointer(0));
  auto made = vtkSmartPointer<vtkImageData>::New();
  made->CopyStructure(picture);
  made->GetPointData()->SetScalars(colours);
  return made;
}

} // namespace oversketch_studio
