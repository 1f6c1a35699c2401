// The pictures of a scene, behind the model: each stands in the world, where its frame says, and is seen from
// the frame's view alone.
#ifndef oversketch_applications_studio_view_backdrop_h
#define oversketch_applications_studio_view_backdrop_h

#include "session.h"

#include <memory>
#include <vector>

class vtkPolyData;
class vtkRenderer;

namespace oversketch_studio
{

class Backdrop
{
public:
  Backdrop();
  ~Backdrop();

  void set(const oversketch_session::Pictures& pictures, vtkRenderer* renderer);
  // Puts them behind the mesh, where there is one.
  void setMesh(vtkPolyData* mesh);
  // A frame begins: shows those of the renderer's present view.
  void look(vtkRenderer* renderer);

private:
  struct Card;
  void place(Card& card) const;

  std::vector<std::unique_ptr<Card>> Cards;
  double Box[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }; // of the mesh
};

} // namespace oversketch_studio
#endif
