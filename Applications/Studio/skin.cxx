#include "skin.h"

#include "mesh_file.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

namespace oversketch_studio
{

namespace
{

// What faces the eye is nearly as light as the picture itself; what faces the key light is not brighter than
// white, so that the form is seen on white paper, too.
constexpr double pictureAmbient = 0.22, pictureDiffuse = 0.78, pictureShine = 0.03, shine = 0.15;

} // namespace

Skin::Skin()
{
  this->Texture->SetColorModeToDirectScalars();
  this->Texture->InterpolateOn();
  this->Texture->MipmapOn();
  this->Texture->RepeatOn();
}

Skin::~Skin() = default;

void Skin::dress(vtkActor* actor, vtkPolyDataMapper* mapper, vtkPolyData* mesh, const std::string& picture)
{
  if (picture != (this->Picture ? *this->Picture->bytes : std::string()))
  {
    this->Picture = picture.empty() ? nullptr : decoded(std::make_shared<const std::string>(picture));
    this->Texture->SetInputData(this->Picture ? this->Picture->worn() : nullptr);
  }
  this->Textured = this->Picture && this->Picture->pixels;
  vtkDataArray* colours = oversketch_files::coloursOf(mesh);
  this->Coloured = colours && colours->GetName() && !this->Textured;
  if (this->Coloured)
  {
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(colours->GetName());
  }
  this->put(actor);
}

void Skin::setPlain(vtkActor* actor, double red, double green, double blue)
{
  this->Plain[0] = red;
  this->Plain[1] = green;
  this->Plain[2] = blue;
  this->put(actor);
}

void Skin::setWorn(vtkActor* actor, bool worn)
{
  this->Worn = worn;
  this->put(actor);
}

void Skin::put(vtkActor* actor)
{
  const bool isPicture = this->Worn && this->Textured;
  vtkProperty* look = actor->GetProperty();
  actor->SetTexture(isPicture ? this->Texture.Get() : nullptr);
  actor->GetMapper()->SetScalarVisibility(this->Worn && this->Coloured);
  isPicture ? look->SetColor(1.0, 1.0, 1.0) : look->SetColor(this->Plain); // the picture's own
  look->SetAmbient(isPicture ? pictureAmbient : 0.0);
  look->SetDiffuse(isPicture ? pictureDiffuse : 1.0);
  look->SetSpecular(isPicture ? pictureShine : shine);
}

} // namespace oversketch_studio
