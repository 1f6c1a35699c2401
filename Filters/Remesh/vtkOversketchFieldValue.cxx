#include "vtkOversketchFieldValue.h"

#include "Mesh/context.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"

#include <cmath>

namespace oversketch
{

double FieldValue(vtkDataObject* object,
  const char* name,
  const std::string& holder,
  const std::string& remedy)
{
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  const bool single = array && array->GetNumberOfTuples() == 1 && array->GetNumberOfComponents() == 1;
  const double value = single ? array->GetComponent(0, 0) : 0.0;
  if (!(value > 0.0) || !std::isfinite(value))
  {
    throw Error(Failure::MissingArray,
      "Field array %1 of the %2 must hold one positive value: %3.",
      name,
      holder,
      remedy);
  }
  return value;
}

} // namespace oversketch
