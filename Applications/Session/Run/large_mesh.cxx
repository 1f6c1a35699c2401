#include "large_mesh.h"

#include "vtkOversketchDetailTransfer.h"
#include "vtkOversketchProxy.h"

#include "Mesh/context.h"

#include "vtkNew.h"

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

vtkSmartPointer<vtkPolyData> proxyOf(vtkPolyData* mesh, const Progress& progress, vtkIdType triangles)
{
  vtkNew<vtkOversketchProxy> filter;
  filter->SetInputData(mesh);
  filter->SetTargetTriangles(static_cast<int>(triangles));
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
