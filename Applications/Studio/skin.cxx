#include "skin.h"

#include "mesh_file.h"
#include "texture.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

namespace oversketch_studio
{

Skin::Skin()
{
  this->texture_->SetColorModeToDirectScalars();
  this->texture_->InterpolateOn();
  this->texture_->MipmapOn();
  this->texture_->RepeatOn();
}

Skin::~Skin() = default;

void Skin::dress(vtkActor* actor, vtkPolyDataMapper* mapper, vtkPolyData* mesh)
{
  std::string bytes = oversketch_files::textureOf(mesh);
  if (bytes != this->bytes_)
  {
    this->texture_->SetInputData(oversketch_files::pictureOf(bytes));
    this->bytes_ = std::move(bytes);
  }
  this->textured_ = !this->bytes_.empty() && this->texture_->GetInput();
  actor->SetTexture(this->textured_ ? this->texture_.Get() : nullptr);
  vtkDataArray* colours = oversketch_files::coloursOf(mesh);
  const bool coloured = colours && colours->GetName() && !this->textured_;
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
  this->plain_[0] = red;
  this->plain_[1] = green;
  this->plain_[2] = blue;
  this->colour(actor);
}

void Skin::colour(vtkActor* actor)
{
  if (this->textured_)
  {
    actor->GetProperty()->SetColor(1.0, 1.0, 1.0); // the picture's own
  }
  else
  {
    actor->GetProperty()->SetColor(this->plain_);
  }
}

} // namespace oversketch_studio
