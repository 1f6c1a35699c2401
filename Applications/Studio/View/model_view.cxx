#include "model_view.h"

#include "back_faces.h"
#include "models.h"
#include "pieces.h"
#include "sharp_edges.h"
#include "skin.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <utility>

namespace oversketch_studio
{

struct ModelView::Part
{
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  Skin skin;
  oversketch_files::SharpEdges edges;
  BackFaces backs;

  Part()
  {
    this->actor->SetMapper(this->mapper);
    this->actor->GetProperty()->SetSpecularPower(20.0);
    this->actor->ForceOpaqueOn();
    makeOpaque(this->actor);
  }
};

ModelView::ModelView(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->resize(1);
}

ModelView::~ModelView()
{
  this->resize(0);
}

void ModelView::resize(std::size_t count)
{
  while (this->Parts.size() > count)
  {
    this->Renderer->RemoveActor(this->Parts.back()->actor);
    this->Parts.pop_back();
  }
  while (this->Parts.size() < count)
  {
    this->Parts.push_back(std::make_unique<Part>());
    Part& part = *this->Parts.back();
    this->shadePart(part);
    part.actor->SetVisibility(this->Visible);
    this->Renderer->AddActor(part.actor);
  }
}

void ModelView::show(vtkPolyData* mesh)
{
  this->Shown = mesh;
  if (this->Dressed && oversketch_session::isShallowCopy(this->Dressed, mesh))
  {
    return;
  }
  this->Dressed = mesh;
  const std::vector<oversketch_files::Piece> pieces = oversketch_files::piecesOf(this->seen(mesh));
  this->resize(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    Part& part = *this->Parts[i];
    part.mapper->SetInputData(part.edges.look(pieces[i].mesh));
    part.actor->SetVisibility(this->Visible);
    part.skin.dress(part.actor,
      part.mapper,
      pieces[i].mesh,
      pieces[i].picture,
      [this] { this->Renderer->GetRenderWindow()->GetInteractor()->Render(); });
  }
}

vtkSmartPointer<vtkPolyData> ModelView::seen(vtkPolyData* mesh) const
{
  if (this->Hidden.empty())
  {
    return mesh;
  }
  if (this->Hidden.count(-1) == 0)
  {
    return oversketch_files::withoutParts(mesh, this->Hidden);
  }
  auto none = vtkSmartPointer<vtkPolyData>::New();
  none->SetPoints(mesh->GetPoints());
  return none;
}

void ModelView::hide(const std::set<int>& parts)
{
  if (std::exchange(this->Hidden, parts) != parts && this->Shown)
  {
    this->Dressed = nullptr;
    this->show(this->Shown);
  }
}

void ModelView::clear()
{
  this->Dressed = nullptr;
  this->Shown = nullptr;
  this->resize(0); // with what it wore
  this->resize(1);
  this->Parts[0]->actor->VisibilityOff();
}

void ModelView::preview(vtkPolyData* mesh)
{
  this->Dressed = nullptr;
  this->Shown = mesh;
  if (this->Parts.size() == 1)
  {
    this->Parts[0]->mapper->SetInputData(this->Parts[0]->edges.lookMoved(this->seen(mesh)));
    return;
  }
  const std::vector<oversketch_files::Piece> pieces = oversketch_files::piecesOf(this->seen(mesh));
  this->resize(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    this->Parts[i]->mapper->SetInputData(this->Parts[i]->edges.lookMoved(pieces[i].mesh));
  }
}

bool ModelView::owns(const vtkActor* actor) const
{
  return std::any_of(
    this->Parts.begin(), this->Parts.end(), [actor](const auto& part) { return part->actor == actor; });
}

void ModelView::setLook(const ModelLook& look)
{
  this->Look = look;
  for (const auto& part : this->Parts)
  {
    this->shadePart(*part);
  }
}

// Clay shows the form alone.
void ModelView::shadePart(Part& part) const
{
  shade(part.actor, this->Look.shading);
  part.skin.setLook(
    part.actor, this->Look.plain, this->Look.pictures && this->Look.shading != Shading::Matcap);
}

void ModelView::setVisible(bool visible)
{
  this->Visible = visible;
  for (const auto& part : this->Parts)
  {
    part->actor->SetVisibility(visible && this->Shown);
  }
}

void ModelView::hideBacks(bool hide)
{
  for (const auto& part : this->Parts)
  {
    vtkPolyData* mesh = hide && this->Shown ? part->mapper->GetInput() : nullptr;
    part->actor->GetProperty()->SetBackfaceCulling(mesh && part->backs.areHidden(mesh, this->Renderer));
  }
}

} // namespace oversketch_studio
