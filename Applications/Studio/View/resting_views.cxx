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

RestingViews::RestingViews(vtkRenderer* renderer)
  : Renderer(renderer)
{
}

RestingViews::~RestingViews() = default;

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
      view->setPlain(dim * this->Plain[0], dim * this->Plain[1], dim * this->Plain[2]);
      view->setShading(this->Look, this->Pictures);
    }
    view->hide(hiddenOf(other->own, other->made.parts));
    if (view->mesh() != mesh)
    {
      view->show(mesh);
    }
  }
}

void RestingViews::setShading(Shading shading, bool pictures)
{
  this->Look = shading;
  this->Pictures = pictures;
  for (const auto& [id, view] : this->Views)
  {
    view->setShading(shading, pictures);
  }
}

void RestingViews::setPlain(double red, double green, double blue)
{
  this->Plain = { red, green, blue };
  for (const auto& [id, view] : this->Views)
  {
    view->setPlain(dim * red, dim * green, dim * blue);
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

std::optional<int> RestingViews::at(int x, int y)
{
  const vtkActor* actor = this->Views.empty() ? nullptr : this->Picker.actorAt(x, y, this->Renderer);
  const auto found = std::find_if(this->Views.begin(),
    this->Views.end(),
    [actor](const auto& view) { return actor && view.second->owns(actor); });
  return found == this->Views.end() ? std::nullopt : std::optional<int>(found->first);
}

} // namespace oversketch_studio
