// A positive number that a mesh or handles carry in their field data, for the filters of this module. Not
// installed.
#ifndef vtkOversketchFieldValue_h
#define vtkOversketchFieldValue_h

#include <string>

class vtkDataObject;

namespace oversketch
{

// The one value of a field array. Throws Error(MissingArray), naming the array and its holder ("mesh"), where
// it is not one finite positive number.
double FieldValue(vtkDataObject* object,
  const char* name,
  const std::string& holder,
  const std::string& remedy);

} // namespace oversketch
#endif
