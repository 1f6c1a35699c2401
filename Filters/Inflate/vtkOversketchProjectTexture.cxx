#include "vtkOversketchProjectTexture.h"

#include "Inflate/texture.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchKept.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchProjectTexture::Cache
{
  KeptOutput Mesh;
};

vtkStandardNewMacro(vtkOversketchProjectTexture);

vtkOversketchProjectTexture::vtkOversketchProjectTexture()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(2);
}

vtkOversketchProjectTexture::~vtkOversketchProjectTexture() = default;

void vtkOversketchProjectTexture::SetPictureData(vtkImageData* picture)
{
  this->SetInputData(1, picture);
}

int vtkOversketchProjectTexture::FillInputPortInformation(int port, vtkInformation* information)
{
  return FillPicturePort(port, information) ? 1
                                            : this->Superclass::FillInputPortInformation(port, information);
}

int vtkOversketchProjectTexture::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
      vtkImageData* picture = vtkImageData::GetData(inputs[1]);
      if (mesh->GetNumberOfPoints() == 0)
      {
        return;
      }
      ContextOf(this).checkpoint(0.0);
      const Canvas canvas = picture ? PlaceOf(picture).Rectangle : CanvasOf(mesh);
      this->Internals->Mesh.Provide(
        StepKey({ WholeKey(mesh) }, { canvas.corner[0], canvas.corner[1], canvas.size[0], canvas.size[1] }),
        vtkPolyData::GetData(outputs),
        [&](vtkPolyData* result)
        {
          vtkNew<vtkDoubleArray> coordinates;
          coordinates->SetName("TCoords");
          coordinates->SetNumberOfComponents(2);
          coordinates->SetNumberOfTuples(mesh->GetNumberOfPoints());
          for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
          {
            const Vector2 place = textureCoordinates(canvas, Vector2(mesh->GetPoint(i)));
            coordinates->SetTuple(i, place.data());
          }
          result->ShallowCopy(mesh);
          result->GetPointData()->SetTCoords(coordinates);
        });
    });
}

void vtkOversketchProjectTexture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
