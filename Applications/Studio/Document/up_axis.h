// Which way up a model is: files do not say.
#ifndef oversketch_applications_studio_document_up_axis_h
#define oversketch_applications_studio_document_up_axis_h

class vtkPolyData;

namespace oversketch_studio
{

// 1 for y, which glTF and most modelling programs have, 2 for z. It is z where the model would stand on its
// lowest points along z, its middle well over them, and not, or on far less, along y.
int upAxisOf(vtkPolyData* mesh);

} // namespace oversketch_studio
#endif
