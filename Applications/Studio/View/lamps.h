// The lights that go with the eye.
#ifndef oversketch_applications_studio_view_lamps_h
#define oversketch_applications_studio_view_lamps_h

#include "model_view.h"

#include "vtkNew.h"

class vtkLight;
class vtkLightKit;
class vtkRenderer;

namespace oversketch_studio
{

class Lamps
{
public:
  explicit Lamps(vtkRenderer* renderer);
  ~Lamps();
  Lamps(const Lamps&) = delete;
  Lamps& operator=(const Lamps&) = delete;

  // Those of that light; of a matcap any, as they do not count.
  void set(Light light);

private:
  vtkRenderer* Renderer; // outlives them
  vtkNew<vtkLightKit> Kit;
  vtkNew<vtkLight> Head;
};

} // namespace oversketch_studio
#endif
