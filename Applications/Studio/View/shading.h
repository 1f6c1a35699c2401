// How the model's surface is drawn.
#ifndef oversketch_applications_studio_view_shading_h
#define oversketch_applications_studio_view_shading_h

#include <array>

class vtkActor;

namespace oversketch_studio
{

enum class Shading
{
  Smooth,
  Flat,  // each face by itself
  Wire,  // smooth, and its edges
  Matcap // as a ball of clay is lit, without what the model wears; shows dents and creases
};
constexpr int shadings = 4;

// How a model is seen.
struct ModelLook
{
  Shading shading = Shading::Smooth;
  bool pictures = true;                         // and colours that it wears are seen
  std::array<double, 3> plain{ 1.0, 1.0, 1.0 }; // the colour of what wears nothing
};

// Draws an actor's surface so.
void shade(vtkActor* actor, Shading shading);
// Nothing is seen through it, whatever the alpha of its points' colours is.
void makeOpaque(vtkActor* actor);

} // namespace oversketch_studio
#endif
