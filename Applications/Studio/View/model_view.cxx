#include "model_view.h"

#include "back_faces.h"
#include "coarse_skin.h"
#include "mesh_file.h"
#include "models.h"
#include "picture_files.h"
#include "pieces.h"
#include "sharp_edges.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"

#include <QObject>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace oversketch_studio
{

namespace
{

// A surface that faces the eye is nearly as light as the picture itself; one that faces the key light is not
// brighter than white, so that the form is seen on white paper, too.
constexpr double pictureAmbient = 0.22, pictureDiffuse = 0.78, pictureShine = 0.03, shine = 0.15;
// Triangles: a model of fewer is drawn whole however late its frames are, as is each small part; what stands
// in for a large one.
constexpr vtkIdType largeModel = 100000, smallPart = 5000, coarseModel = 40000;
constexpr const char* place = "//VTK::Light::Impl";

// A colour by the way the surface faces, seen from the eye, as it is on a ball: how far it is lit by a warm
// light from above and the left, by a cool one from below and the right, and how near the ball's rim it is.
// Lights of the scene do not count. Reflected, so that a perspective shows flat faces alike wherever they
// are.
constexpr const char* ball = R"(//VTK::Light::Impl
  {
    vec3 seen = cameraParallel == 1 ? vec3(0.0, 0.0, -1.0) : normalize(vertexVC.xyz);
    vec3 away = reflect(seen, normalVCVSOutput);
    float m = 2.0 * sqrt(away.x * away.x + away.y * away.y + (away.z + 1.0) * (away.z + 1.0));
    vec2 on = 2.0 * away.xy / max(m, 1e-6); // the ball's picture [-1 to 1]
    float high = sqrt(max(0.0, 1.0 - dot(on, on)));
    vec3 ball = vec3(on, high);
    float warm = max(0.0, dot(ball, normalize(vec3(-0.45, 0.65, 0.61))));
    float cool = max(0.0, dot(ball, normalize(vec3(0.70, -0.55, 0.45))));
    float rim = pow(1.0 - high, 3.0);
)";
// Clay, with a bright rim; colours and pictures do not count.
constexpr const char* clay = R"(
    float shine = pow(max(0.0, dot(ball, normalize(vec3(-0.28, 0.42, 0.86)))), 28.0);
    vec3 colour = vec3(0.16, 0.09, 0.08) + warm * vec3(0.66, 0.40, 0.31) + cool * vec3(0.10, 0.13, 0.18);
    gl_FragData[0].rgb = colour + 0.30 * shine + rim * vec3(0.22, 0.20, 0.22);
  }
)";
// Plaster in the surface's own colour; a picture is laid over it afterwards. The sum is at most 0.94.
constexpr const char* plaster = R"(
    vec3 lit = vec3(0.22, 0.22, 0.24) + warm * vec3(0.70, 0.66, 0.60) + cool * vec3(0.12, 0.16, 0.22) + rim * vec3(0.03, 0.06, 0.10);
    gl_FragData[0].rgb = (ambientColor + diffuseColor) * lit;
  }
)";

// Draws an actor's surface so.
void shade(vtkActor* actor, Shading shading, Light light)
{
  vtkProperty* look = actor->GetProperty();
  shading == Shading::Flat ? look->SetInterpolationToFlat() : look->SetInterpolationToGouraud();
  look->SetEdgeVisibility(shading == Shading::Wire);
  look->SetEdgeColor(0.33, 0.34, 0.36);
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  shaders->ClearFragmentShaderReplacement(place, false);
  const bool isClay = shading == Shading::Matcap;
  if (isClay || light == Light::Matcap)
  {
    shaders->AddFragmentShaderReplacement(place, false, std::string(ball) + (isClay ? clay : plaster), false);
  }
}

} // namespace

// A piece that is drawn by itself, in what it wears: a picture, else its own colours, else none.
struct ModelView::Part
{
  vtkNew<vtkPolyDataMapper> mapper, coarse; // of the mesh, and of what stands in for it
  vtkNew<vtkActor> actor;
  CoarseSkin skin;
  oversketch_files::SharpEdges edges;
  BackFaces backs;
  vtkNew<vtkTexture> texture;
  SharedPicture picture;          // of the texture; null: none
  PictureBytes wanted;            // of the picture that is to come, or has come
  std::unique_ptr<QObject> waits; // for it
  bool isColoured = false;
  ModelLook look;

  Part()
  {
    this->actor->SetMapper(this->mapper);
    this->actor->GetProperty()->SetSpecularPower(20.0);
    this->actor->ForceOpaqueOn();
    // Nothing is seen through it, whatever the alpha of its points' colours is. Without a picture this place
    // is free; a picture has no alpha here (opaquePicture).
    this->actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::TCoord::Impl", false, "//VTK::TCoord::Impl\n  gl_FragData[0].a = 1.0;\n", false);
    this->texture->SetColorModeToDirectScalars();
    this->texture->InterpolateOn();
    this->texture->MipmapOn();
    this->texture->RepeatOn();
  }

  // With the bytes of the mesh's picture, if any. One that nobody has decoded yet comes later; then it calls
  // `comes`.
  void dress(vtkPolyData* mesh, const std::string& bytes, const std::function<void()>& comes)
  {
    if (bytes != (this->wanted ? *this->wanted : std::string()))
    {
      this->waits = std::make_unique<QObject>();
      this->wanted = bytes.empty() ? nullptr : std::make_shared<const std::string>(bytes);
      const auto come = [this, comes](const SharedPicture& made)
      {
        this->wear(made);
        this->put();
        comes();
      };
      this->wear(this->wanted ? whenDecoded(this->waits.get(), this->wanted, come) : nullptr);
    }
    vtkDataArray* ofPoints = oversketch_files::coloursOf(mesh);
    vtkDataArray* colours = ofPoints ? ofPoints : oversketch_files::faceColoursOf(mesh);
    this->isColoured = colours && colours->GetName() && !this->wanted;
    for (vtkPolyDataMapper* one : { this->mapper.Get(), this->coarse.Get() })
    {
      if (this->isColoured)
      {
        one->SetColorModeToDirectScalars();
        ofPoints ? one->SetScalarModeToUsePointFieldData() : one->SetScalarModeToUseCellFieldData();
        one->SelectColorArray(colours->GetName());
      }
    }
    this->put();
  }
  void setLook(const ModelLook& now)
  {
    this->look = now;
    shade(this->actor, now.shading, now.light);
    this->put();
  }
  void wear(const SharedPicture& made)
  {
    this->picture = made;
    this->texture->SetInputData(made ? made->worn() : nullptr);
  }
  // Clay shows the form alone.
  void put()
  {
    const bool isWorn = this->look.pictures && this->look.shading != Shading::Matcap;
    const bool isPicture = isWorn && this->picture && this->picture->pixels;
    vtkProperty* surface = this->actor->GetProperty();
    this->actor->SetTexture(isPicture ? this->texture.Get() : nullptr);
    this->mapper->SetScalarVisibility(isWorn && this->isColoured);
    this->coarse->SetScalarVisibility(isWorn && this->isColoured);
    isPicture ? surface->SetColor(1.0, 1.0, 1.0)
              : surface->SetColor(this->look.plain.data()); // the picture's own
    surface->SetAmbient(isPicture ? pictureAmbient : 0.0);
    surface->SetDiffuse(isPicture ? pictureDiffuse : 1.0);
    surface->SetSpecular(isPicture ? pictureShine : shine);
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
    part.setLook(this->Look);
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
    part.skin.clear();
    part.actor->SetVisibility(this->Visible);
    part.dress(pieces[i].mesh,
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

std::vector<vtkPolyData*> ModelView::drawn() const
{
  std::vector<vtkPolyData*> meshes;
  for (const auto& part : this->Parts)
  {
    if (vtkPolyData* mesh = part->actor->GetVisibility() ? part->mapper->GetInput() : nullptr)
    {
      meshes.push_back(mesh);
    }
  }
  return meshes;
}

void ModelView::setLook(const ModelLook& look)
{
  this->Look = look;
  for (const auto& part : this->Parts)
  {
    part->setLook(look);
  }
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

void ModelView::makeCoarse()
{
  const auto trianglesOf = [](const auto& part)
  {
    vtkPolyData* mesh = part->mapper->GetInput();
    return mesh ? mesh->GetNumberOfPolys() : vtkIdType{ 0 };
  };
  vtkIdType all = 0;
  for (const auto& part : this->Parts)
  {
    all += trianglesOf(part);
  }
  for (const auto& part : this->Parts)
  {
    const vtkIdType count = trianglesOf(part);
    if (all >= largeModel && count >= smallPart)
    {
      part->skin.make(part->mapper->GetInput(), coarseModel * count / all);
    }
  }
}

// Edges that are drawn would be other ones.
bool ModelView::drawCoarse(bool coarse)
{
  bool any = false;
  for (const auto& part : this->Parts)
  {
    const bool may = coarse && this->Look.shading != Shading::Wire;
    vtkPolyData* skin = may ? part->skin.of(part->mapper->GetInput()) : nullptr;
    if (skin && part->coarse->GetInput() != skin)
    {
      part->coarse->SetInputData(skin);
    }
    part->actor->SetMapper(skin ? part->coarse : part->mapper);
    any = any || skin;
  }
  return any;
}

} // namespace oversketch_studio
