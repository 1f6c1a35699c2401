#include "colours.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace oversketch_files
{

namespace
{

bool haveComponents(vtkDataArray* array)
{
  return array && (array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4);
}

// Floats are colours by their name alone, and where all are from 0 to 1.
bool areShares(vtkDataArray* array)
{
  bool are = array->GetDataType() == VTK_FLOAT && array->GetNumberOfTuples() > 0;
  for (int k = 0; are && k < array->GetNumberOfComponents(); ++k)
  {
    double range[2];
    array->GetRange(range, k);
    are = range[0] >= 0.0 && range[1] <= 1.0;
  }
  return are;
}

vtkDataArray* coloursIn(vtkDataSetAttributes* data)
{
  if (haveComponents(data->GetScalars()) && areBytes(data->GetScalars()))
  {
    return data->GetScalars();
  }
  for (const char* name : { "RGB", "RGBA", "Colors", "Color", "COLOR_0" })
  {
    vtkDataArray* array = data->GetArray(name);
    if (haveComponents(array) && (areBytes(array) || areShares(array)))
    {
      return array;
    }
  }
  return nullptr;
}

} // namespace

vtkDataArray* coloursOf(vtkPolyData* mesh)
{
  return coloursIn(mesh->GetPointData());
}

vtkDataArray* faceColoursOf(vtkPolyData* mesh)
{
  return coloursIn(mesh->GetCellData());
}

bool areBytes(vtkDataArray* colours)
{
  return colours->GetDataType() == VTK_UNSIGNED_CHAR;
}

vtkDataArray* usable(vtkDataArray* array, int components, vtkIdType count)
{
  return array && array->GetNumberOfComponents() >= components && array->GetNumberOfTuples() == count
           ? array
           : nullptr;
}

double colourShare(vtkDataArray* colours, vtkIdType at, int component)
{
  return component >= colours->GetNumberOfComponents()
           ? 1.0
           : colours->GetComponent(at, component) / (areBytes(colours) ? 255.0 : 1.0);
}

unsigned char colourByte(vtkDataArray* colours, vtkIdType at, int component)
{
  return static_cast<unsigned char>(std::lround(255.0 * colourShare(colours, at, component)));
}

void setColours(vtkDataSetAttributes* data, const std::vector<double>& values, int components)
{
  // Files round what was a byte to six digits or so.
  const bool bytes = std::all_of(values.begin(),
    values.end(),
    [](double value) { return std::abs(255.0 * value - std::round(255.0 * value)) < 1e-3; });
  const auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(bytes ? VTK_UNSIGNED_CHAR : VTK_FLOAT));
  array->SetName(components == 4 ? "RGBA" : "RGB");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double share = values[i] > 0.0 ? std::min(values[i], 1.0) : 0.0; // also what is no number
    array->SetComponent(static_cast<vtkIdType>(i) / components,
      static_cast<int>(i) % components,
      bytes ? std::round(255.0 * share) : share);
  }
  data->SetScalars(array);
}

} // namespace oversketch_files
