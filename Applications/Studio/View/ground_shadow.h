// The shadow of models on the ground under them, as of a wide light from above: soft, and dark where they
// touch it.
#ifndef oversketch_applications_studio_view_ground_shadow_h
#define oversketch_applications_studio_view_ground_shadow_h

#include "vtkNew.h"
#include "vtkType.h"

#include <utility>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkPlaneSource;
class vtkPolyData;
class vtkRenderer;
class vtkTexture;

namespace oversketch_studio
{

class GroundShadow
{
public:
  explicit GroundShadow(vtkRenderer* renderer);
  ~GroundShadow();

  void setShown(bool shown) { this->Shown = shown; }
  // Says where the ground is: its height along the axis that is up, 1 for y, 2 for z.
  void setGround(int up, double height);
  // Casts that of these meshes, where it is not the one that is there.
  void cast(const std::vector<vtkPolyData*>& meshes);
  // A frame begins: from below the ground the shadow is faint.
  void look();

private:
  vtkRenderer* Renderer; // outlives it
  vtkNew<vtkPlaneSource> Plane;
  vtkNew<vtkImageData> Picture;
  vtkNew<vtkTexture> Texture;
  vtkNew<vtkActor> Actor;
  std::vector<std::pair<vtkPolyData*, vtkMTimeType>> Of; // what it was cast of; told by the times as well
  int Up = 1;
  double Height = 0.0;
  bool Shown = false, Stale = true;
};

} // namespace oversketch_studio
#endif
