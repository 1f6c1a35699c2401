#include "vtkOversketchHierarchy.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace oversketch
{

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
