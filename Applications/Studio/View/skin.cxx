#include "skin.h"

#include "mesh_file.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
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

void Skin::dress(vtkActor* actor,
  vtkPolyDataMapper* mapper,
  vtkPolyData* mesh,
  const std::string& picture,
  const std::function<void()>& comes)
{
  if (picture != (this->Wanted ? *this->Wanted : std::string()))
  {
    this->Waits.reset();
    this->Wanted = picture.empty() ? nullptr : std::make_shared<const std::string>(picture);
    this->wear(this->Wanted ? findDecoded(picture) : nullptr);
    if (this->Wanted && !this->Picture)
    {
      this->Waits = std::make_unique<QObject>();
      whenDecoded(this->Waits.get(),
        this->Wanted,
        [this, comes, dressed = vtkSmartPointer<vtkActor>(actor)](const SharedPicture& made)
        {
          this->wear(made);
          this->put(dressed);
          comes();
        });
    }
  }
  vtkDataArray* colours = oversketch_files::coloursOf(mesh);
  this->Coloured = colours && colours->GetName() && !this->Wanted;
  if (this->Coloured)
  {
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(colours->GetName());
  }
  this->put(actor);
}

void Skin::wear(const SharedPicture& picture)
{
  this->Picture = picture;
  this->Texture->SetInputData(picture ? picture->worn() : nullptr);
  this->Textured = picture && picture->pixels;
}

void Skin::setLook(vtkActor* actor, const std::array<double, 3>& plain, bool worn)
{
  this->Plain = plain;
  this->Worn = worn;
  this->put(actor);
}

void Skin::put(vtkActor* actor)
{
  const bool isPicture = this->Worn && this->Textured;
  vtkProperty* look = actor->GetProperty();
  actor->SetTexture(isPicture ? this->Texture.Get() : nullptr);
  actor->GetMapper()->SetScalarVisibility(this->Worn && this->Coloured);
  isPicture ? look->SetColor(1.0, 1.0, 1.0) : look->SetColor(this->Plain.data()); // the picture's own
  look->SetAmbient(isPicture ? pictureAmbient : 0.0);
  look->SetDiffuse(isPicture ? pictureDiffuse : 1.0);
  look->SetSpecular(isPicture ? pictureShine : shine);
}

} // namespace oversketch_studio
