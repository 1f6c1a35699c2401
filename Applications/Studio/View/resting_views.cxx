#include "resting_views.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr double dim = 0.72; // of the colour of the model that is worked on

} // namespace

void RestingViews::show(const Session& scene)
{
  std::map<int, std::unique_ptr<ModelView>> before = std::exchange(this->Views, {});
  for (const auto& other : scene.others)
  {
    const int id = other->own.id;
    vtkPolyData* mesh = other->made.display;
    if (!mesh || !other->own.shown)
    {
      continue;
    }
    std::unique_ptr<ModelView>& view = this->Views[id];
    view = std::move(before[id]);
    if (!view)
    {
      view = std::make_unique<ModelView>(this->Renderer);
      view->setLook(this->Look);
    }
    view->hide(hiddenOf(other->own, other->made.parts));
    if (view->mesh() != mesh)
    {
      view->show(mesh);
    }
  }
}

void RestingViews::setLook(const ModelLook& look)
{
  this->Look = look;
  for (double& part : this->Look.plain)
  {
    part *= dim;
  }
  for (const auto& [id, view] : this->Views)
  {
    view->setLook(this->Look);
  }
}

vtkBoundingBox RestingViews::box(const double with[6]) const
{
  vtkBoundingBox box(with);
  for (const auto& [id, view] : this->Views)
  {
    box.AddBounds(view->mesh()->GetBounds());
  }
  return box;
}

std::vector<vtkPolyData*> RestingViews::drawn() const
{
  std::vector<vtkPolyData*> meshes;
  for (const auto& [id, view] : this->Views)
  {
    const std::vector<vtkPolyData*> its = view->drawn();
    meshes.insert(meshes.end(), its.begin(), its.end());
  }
  return meshes;
}

std::optional<int> RestingViews::at(int x, int y)
{
  const vtkActor* actor = this->Views.empty() ? nullptr : this->Picker.actorAt(x, y, this->Renderer);
  const auto found = std::find_if(this->Views.begin(),
    this->Views.end(),
    [actor](const auto& view) { return actor && view.second->owns(actor); });
  return found == this->Views.end() ? std::nullopt : std::optional<int>(found->first);
}

} // namespace oversketch_studio
