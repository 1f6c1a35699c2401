// What a model wears of the picture that it was drawn over.
#ifndef oversketch_applications_session_skin_h
#define oversketch_applications_session_skin_h

#include "vtkPolyData.h"

#include <string>

namespace oversketch_session
{

// The bytes of a picture as the faces of a part (cell array PartId; of all without it) are to wear it:
// opaque, its colours led on past what they cover (Kernels/Raster/skin.h). As JPEG of one, else as PNG. The
// bytes themselves where they are no picture.
std::string skinFor(vtkPolyData* mesh, int part, const std::string& bytes);

} // namespace oversketch_session
#endif
