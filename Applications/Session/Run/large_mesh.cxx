#include "large_mesh.h"

#include "systems.h"

#include "vtkOversketchDetailTransfer.h"
#include "vtkOversketchProxy.h"

#include "Mesh/context.h"

#include "vtkNew.h"

#include <algorithm>

namespace oversketch_session
{

namespace
{

vtkSmartPointer<vtkPolyData> outputOf(vtkPolyDataAlgorithm* filter, const Progress& progress)
{
  try
  {
    oversketch::StepRunner(filter, progress).Run();
  }
  catch (const oversketch::Error& error)
  {
    if (error.failure() != oversketch::Failure::Cancelled)
    {
      throw;
    }
    return nullptr;
  }
  return filter->GetOutput();
}

} // namespace

bool isLarge(vtkPolyData* mesh, vtkIdType most)
{
  return mesh && mesh->GetNumberOfPolys() > most;
}

bool isMoved(const Model& model)
{
  return std::all_of(model.nodes.begin(),
    model.nodes.end(),
    [](const Node& node)
    {
      const SystemRow* row = findSystem(node.step->system);
      return !node.on || (row && row->moves);
    });
}

vtkSmartPointer<vtkPolyData> proxyOf(vtkPolyData* mesh, const Progress& progress, vtkIdType most)
{
  vtkNew<vtkOversketchProxy> filter;
  filter->SetTargetTriangles(static_cast<int>(std::min<vtkIdType>(filter->GetTargetTriangles(), most)));
  filter->SetInputData(mesh);
  return outputOf(filter, progress);
}

vtkSmartPointer<vtkPolyData> exactOf(vtkPolyData* mesh, vtkPolyData* proxyNow, const Progress& progress)
{
  vtkNew<vtkOversketchDetailTransfer> filter;
  filter->SetInputData(0, mesh);
  filter->SetInputData(1, proxyNow);
  return outputOf(filter, progress);
}

} // namespace oversketch_session
