// The models beside the one that is worked on, in the view: a little darker.
#ifndef oversketch_applications_studio_view_resting_views_h
#define oversketch_applications_studio_view_resting_views_h

#include "mesh_picker.h"
#include "model_view.h"
#include "models.h"

#include "vtkBoundingBox.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

class vtkPolyData;
class vtkRenderer;

namespace oversketch_studio
{

class RestingViews
{
public:
  explicit RestingViews(vtkRenderer* renderer)
    : Renderer(renderer)
  {
  }

  // Those of a scene that are shown.
  void show(const oversketch_session::Session& scene);
  // As the model that is worked on.
  void setLook(const ModelLook& look);

  // A box with theirs.
  vtkBoundingBox box(const double with[6]) const;
  // What is drawn of them.
  std::vector<vtkPolyData*> drawn() const;
  // The id of the one that is seen at a place of the picture [px from its lower left corner]; none where the
  // model that is worked on is, or nothing.
  std::optional<int> at(int x, int y);

private:
  vtkRenderer* Renderer;                           // outlives it
  std::map<int, std::unique_ptr<ModelView>> Views; // by the models' ids
  oversketch::MeshPicker Picker;
  ModelLook Look; // theirs
};

} // namespace oversketch_studio
#endif
