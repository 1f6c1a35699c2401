// Runs system A from an installed package: an empty stroke must be refused with an error code, a class of the
// library must be there to refuse it.
#include <vtkNew.h>
#include <vtkOversketchOneStroke.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyData> noStroke;
  vtkNew<vtkOversketchOneStroke> system;
  system->GlobalWarningDisplayOff();
  system->SetInputConnection(0, sphere->GetOutputPort());
  system->SetStrokeData(noStroke);
  system->Update();
  return system->GetErrorCode() != 0 && system->GetOutput()->GetNumberOfPoints() == 0 ? 0 : 1;
}
