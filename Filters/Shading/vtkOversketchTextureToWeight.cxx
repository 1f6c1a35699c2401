#include "vtkOversketchTextureToWeight.h"

#include "vtkOversketchFilterTools.h"

#include "Shading/texels.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchShadingTools.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchTextureToWeight);

namespace
{

// Samples as weights.
class GreyImage
{
public:
  explicit GreyImage(vtkImageData* image)
    : Scalars(image->GetPointData()->GetScalars())
  {
    const auto [columns, rows] = SidesOf(image, "weight");
    this->Columns = columns;
    this->Rows = rows;
    const int type = this->Scalars ? this->Scalars->GetDataType() : VTK_VOID;
    const bool real = type == VTK_FLOAT || type == VTK_DOUBLE;
    if (!(real || type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT) ||
        this->Scalars->GetNumberOfComponents() > 4)
    {
      throw Error(Failure::BadStroke,
        "The weight image has no scalars that are greys or colours; give unsigned char, unsigned short, or "
        "numbers from 0 to 1, of 1 to 4 components.");
    }
    this->White = real ? 1.0 : type == VTK_UNSIGNED_CHAR ? 255.0 : 65535.0;
  }

  double At(const Vector2& uv) const
  {
    const TexelMix mix = texelsRound(uv, this->Columns, this->Rows);
    double greys[4];
    for (int k = 0; k < 4; ++k)
    {
      greys[k] = this->Sample(mix.texels[k]);
    }
    return mix.of(greys);
  }

private:
  double Sample(std::size_t texel) const
  {
    double channels[4] = {};
    const int count = this->Scalars->GetNumberOfComponents();
    for (int c = 0; c < count; ++c)
    {
      channels[c] = this->Scalars->GetComponent(static_cast<vtkIdType>(texel), c) / this->White;
      if (!(channels[c] >= 0.0 && channels[c] <= 1.0))
      {
        const auto columns = static_cast<std::size_t>(this->Columns);
        throw Error(Failure::BadStroke,
          "Sample (%1, %2) of the weight image is not within 0, black, and 1, white; scale its numbers.",
          texel % columns,
          texel / columns);
      }
    }
    // A grey's own value whichever way it is stored.
    const double brightness =
      count < 3 ? channels[0]
                : channels[1] + 0.299 * (channels[0] - channels[1]) + 0.114 * (channels[2] - channels[1]);
    return count % 2 == 0 ? brightness * channels[count - 1] : brightness;
  }

  vtkDataArray* Scalars;
  int Columns = 0, Rows = 0;
  double White = 1.0;
};

} // namespace

vtkOversketchTextureToWeight::vtkOversketchTextureToWeight()
{
  this->SetNumberOfInputPorts(2);
  DeclareInput(this, 1, { Port::Image });
}

int vtkOversketchTextureToWeight::RequestUpdateExtent(vtkInformation* request,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  RequestWholeImage(inputs[1]);
  return done;
}

void vtkOversketchTextureToWeight::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkImageData* image = vtkImageData::GetData(inputs[1]);
  ContextOf(this).checkpoint(0.0);
  const GreyImage greys(image);
  vtkPointData* data = mesh->GetPointData();
  const StepKey key(
    { ArraysKey(
      { data->GetArray("EditRegion"), data->GetArray("DiscCoords"), image->GetPointData()->GetScalars() }) },
    { static_cast<double>(image->GetDimensions()[0]) });
  vtkDataArray* weights = this->Kept<KeptValue<vtkSmartPointer<vtkDoubleArray>>>().Provide(key,
    [&]
    {
      const std::vector<char> labels = ReadEditRegion(mesh);
      const std::vector<Vector2> coordinates = DiscCoordsOf(mesh, labels);
      auto made = NewArray<vtkDoubleArray>("EditWeight", 1, mesh->GetNumberOfPoints());
      for (std::size_t v = 0; v < labels.size(); ++v)
      {
        made->SetValue(
          static_cast<vtkIdType>(v), labels[v] == EditLabel::Inside ? greys.At(coordinates[v]) : 0.0);
      }
      return made;
    });
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(mesh);
  output->GetPointData()->AddArray(weights);
}
