#include "mesh_picker.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>

namespace oversketch
{
namespace
{

// Fewer cells are walked through in a few milliseconds.
constexpr vtkIdType manyCells = 20000;

} // namespace

const double* MeshPicker::pick(int x, int y, vtkRenderer* renderer)
{
  std::vector<vtkSmartPointer<vtkStaticCellLocator>> now;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator at;
  actors->InitTraversal(at);
  while (vtkActor* actor = actors->GetNextActor(at))
  {
    vtkMapper* mapper = actor->GetMapper();
    auto* mesh = mapper ? vtkPolyData::SafeDownCast(mapper->GetInput()) : nullptr;
    if (!mesh || mesh->GetNumberOfCells() < manyCells || !actor->GetPickable() || !actor->GetVisibility())
    {
      continue;
    }
    const auto known = std::find_if(this->Locators.begin(),
      this->Locators.end(),
      [&](const auto& locator) { return locator->GetDataSet() == mesh; });
    now.push_back(known != this->Locators.end() ? *known : vtkSmartPointer<vtkStaticCellLocator>::New());
    now.back()->SetDataSet(mesh);
    now.back()->Update(); // builds it again where the mesh has changed
  }
  this->Locators.swap(now);
  this->Picker->RemoveAllLocators();
  for (const auto& locator : this->Locators)
  {
    this->Picker->AddLocator(locator);
  }
  return this->Picker->Pick(x, y, 0.0, renderer) ? this->Picker->GetPickPosition() : nullptr;
}

vtkActor* MeshPicker::actorAt(int x, int y, vtkRenderer* renderer)
{
  return this->pick(x, y, renderer) ? this->Picker->GetActor() : nullptr;
}

} // namespace oversketch
