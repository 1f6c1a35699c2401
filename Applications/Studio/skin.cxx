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

// So that what faces the eye is as light as the picture itself: the lights alone give it little more than
// half.
constexpr double pictureLight = 0.4;

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
    this->Texture->SetInputData(this->Picture ? this->Picture->pixels.Get() : nullptr);
  }
  this->Textured = this->Picture && this->Picture->pixels;
  actor->SetTexture(this->Textured ? this->Texture.Get() : nullptr);
  vtkDataArray* colours = oversketch_files::coloursOf(mesh);
  const bool coloured = colours && colours->GetName() && !this->Textured;
  mapper->SetScalarVisibility(coloured);
  if (coloured)
  {
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(colours->GetName());
  }
  this->colour(actor);
}

void Skin::setPlain(vtkActor* actor, double red, double green, double blue)
{
  this->Plain[0] = red;
  this->Plain[1] = green;
  this->Plain[2] = blue;
  this->colour(actor);
}

void Skin::colour(vtkActor* actor)
{
  if (this->Textured)
  {
    actor->GetProperty()->SetColor(1.0, 1.0, 1.0); // the picture's own
    actor->GetProperty()->SetAmbient(pictureLight);
  }
  else
  {
    actor->GetProperty()->SetColor(this->Plain);
    actor->GetProperty()->SetAmbient(0.0);
  }
}

} // namespace oversketch_studio
