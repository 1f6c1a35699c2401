// System A in a window of the program's own: consumer MODEL.ply STROKE.vtp PICTURE.png
// Shows the deformed model in the stroke's view, writes the picture, prints how many points moved and by how
// much at most.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOversketchOneStroke.h>
#include <vtkPLYReader.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{

void aim(vtkCamera* camera, vtkCellData* view)
{
  vtkNew<vtkMatrix4x4> toWorld;
  double values[16];
  view->GetArray("ViewTransform")->GetTuple(0, values);
  vtkMatrix4x4::Invert(values, toWorld->GetData());
  const double* m = toWorld->GetData();
  camera->SetPosition(m[3], m[7], m[11]);
  camera->SetFocalPoint(m[3] - m[2], m[7] - m[6], m[11] - m[10]);
  camera->SetViewUp(m[1], m[5], m[9]);
  view->GetArray("ProjectionTransform")->GetTuple(0, values);
  camera->SetParallelProjection(values[14] == 0.0);
  camera->SetParallelScale(1.0 / values[5]);
  camera->SetViewAngle(vtkMath::DegreesFromRadians(2.0 * std::atan(1.0 / values[5])));
}

} // namespace

int main(int count, char** values)
{
  if (count != 4)
  {
    std::fputs("usage: consumer MODEL.ply STROKE.vtp PICTURE.png\n", stderr);
    return 2;
  }
  vtkNew<vtkPLYReader> model;
  model->SetFileName(values[1]);
  vtkNew<vtkXMLPolyDataReader> stroke;
  stroke->SetFileName(values[2]);
  vtkNew<vtkOversketchOneStroke> system;
  system->SetBackendToHost();
  system->SetRemeshToOff();
  system->SetInputConnection(0, model->GetOutputPort());
  system->SetStrokeConnection(stroke->GetOutputPort());
  system->Update();
  if (system->GetErrorCode() != 0 || system->GetOutput()->GetNumberOfPoints() == 0)
  {
    return 1; // VTK has said why
  }

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(system->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.8, 0.6, 0.4);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  aim(renderer->GetActiveCamera(), stroke->GetOutput()->GetCellData());
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(400, 300);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grabber->GetOutputPort());
  writer->SetFileName(values[3]);
  writer->Write();

  int moved = 0;
  double furthest = 0.0;
  for (vtkIdType i = 0; i < system->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double before[3], after[3];
    model->GetOutput()->GetPoint(i, before);
    system->GetOutput()->GetPoint(i, after);
    const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(before, after));
    moved += distance > 0.0 ? 1 : 0;
    furthest = std::max(furthest, distance);
  }
  std::printf("%d %.3f\n", moved, furthest);
  return 0;
}
