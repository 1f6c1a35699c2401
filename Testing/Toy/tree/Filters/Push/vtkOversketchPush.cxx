#include "vtkOversketchPush.h"

#include "Push/push.h"
#include "vtkOversketchFilterTools.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchPush);

namespace
{

Brightness brightnessOf(vtkImageData* image)
{
  Brightness brightness;
  brightness.width = image->GetDimensions()[0];
  brightness.height = image->GetDimensions()[1];
  const int components = std::min(3, image->GetNumberOfScalarComponents());
  for (int y = 0; y < brightness.height; ++y)
  {
    for (int x = 0; x < brightness.width; ++x)
    {
      double sum = 0.0;
      for (int k = 0; k < components; ++k)
      {
        sum += image->GetScalarComponentAsDouble(x, y, 0, k);
      }
      brightness.values.push_back(sum / (255.0 * components));
    }
  }
  return brightness;
}

} // namespace

vtkOversketchPush::vtkOversketchPush()
{
  this->SetNumberOfInputPorts(4);
}

int vtkOversketchPush::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 3 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

void vtkOversketchPush::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* first = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const Mesh mesh = MeshOf(input);
  const double length = (this->Sense == Out ? 1.0 : -1.0) * this->Length * boundingDiagonal(mesh);
  const std::vector<Vector3> moved = pushBetween(mesh,
    ViewOf(first),
    StrokeOf(first),
    StrokeOf(vtkPolyData::GetData(inputs[2])),
    brightnessOf(vtkImageData::GetData(inputs[3])),
    length,
    ContextOf(this));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& p : moved)
  {
    points->InsertNextPoint(p.data());
  }
  output->ShallowCopy(input);
  output->SetPoints(points);
}

void vtkOversketchPush::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sense: " << this->Sense << "\n";
  os << indent << "Length: " << this->Length << "\n";
}
