// The skin that a model wears of the picture that it was drawn over.
#ifndef oversketch_applications_session_run_picture_skin_h
#define oversketch_applications_session_run_picture_skin_h

#include "systems.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <functional>
#include <string>

namespace oversketch_session
{

// The bytes of a picture, of which the samples are given, as the faces of a part (cell array PartId; of all
// without it) are to wear it: opaque, its colours led on past what they cover (Kernels/Raster/skin.h). As
// JPEG of one, else as PNG. The bytes themselves where there are no samples. `fromRim`: of the back, its
// picture mirrored and its inside filled from the rim.
std::string skinFor(vtkPolyData* mesh,
  int part,
  const std::string& bytes,
  vtkImageData* image,
  bool fromRim = false);

// The samples of a step's picture, by the input's name.
using DecodedInput = std::function<vtkImageData*(const std::string& name)>;
// Dresses what a step made in its pictures. Their files themselves travel with the mesh, or what of them is
// skin: a filter sees the samples alone.
void wearPictures(const Step& step, const SystemRow& row, const DecodedInput& decoded, vtkPolyData* mesh);

} // namespace oversketch_session
#endif
