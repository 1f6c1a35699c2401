// A picture as a model wears it: there is nothing to be seen through it.
#ifndef oversketch_applications_studio_opaque_picture_h
#define oversketch_applications_studio_opaque_picture_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace oversketch_studio
{

// The picture (8 bits) without its alpha. What was cut away, and the half-transparent pixels along its rim,
// have the colour of the next pixel that was opaque: neither a smooth nor a small picture of the texture
// shows what is under them. A picture without alpha is given back itself; one without an opaque pixel keeps
// its colours.
vtkSmartPointer<vtkImageData> opaquePicture(vtkImageData* picture);

} // namespace oversketch_studio
#endif
