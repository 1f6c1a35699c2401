#include "vtkOversketchHierarchy.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace oversketch
{

bool IsStellarArray(const char* name)
{
  const auto same = [name](const char* other) { return name && std::string(name) == other; };
  return std::any_of(std::begin(stellarCellArrays), std::end(stellarCellArrays), same) ||
         std::any_of(std::begin(stellarPointArrays), std::end(stellarPointArrays), same) ||
         std::any_of(std::begin(stellarFieldArrays), std::end(stellarFieldArrays), same);
}

void RemoveStellarArrays(vtkPolyData* mesh)
{
  for (const char* name : stellarPointArrays)
  {
    mesh->GetPointData()->RemoveArray(name);
  }
  for (const char* name : stellarCellArrays)
  {
    mesh->GetCellData()->RemoveArray(name);
  }
  for (const char* name : stellarFieldArrays)
  {
    mesh->GetFieldData()->RemoveArray(name);
  }
}

void DropHierarchy(vtkPolyData* mesh)
{
  if (mesh->GetCellData()->HasArray("StellarPath"))
  {
    RemoveStellarArrays(mesh);
  }
}

} // namespace oversketch
