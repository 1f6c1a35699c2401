// A picture as a model wears it: there is nothing to be seen through it.
#ifndef oversketch_applications_studio_view_opaque_picture_h
#define oversketch_applications_studio_view_opaque_picture_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace oversketch_studio
{

// The picture (8 bits) without its alpha, as opaqueOf of Kernels/Raster/skin.h has it; one without alpha is
// given back itself.
vtkSmartPointer<vtkImageData> opaquePicture(vtkImageData* picture);

} // namespace oversketch_studio
#endif
