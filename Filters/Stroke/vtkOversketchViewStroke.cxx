#include "vtkOversketchViewStroke.h"

#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>

using namespace oversketch;

namespace
{

// World to camera: the rows are the picture's right and up and the direction to the eye.
Eigen::Matrix4d LookAt(const Vector3& eye, const Vector3& focus, const Vector3& up)
{
  const Vector3 back = (eye - focus).normalized();
  const Vector3 right = up.cross(back);
  if (!(back.norm() > 0.5) || !(right.norm() > 1e-9 * up.norm()))
  {
    throw Error(Failure::BadStroke,
      "The camera sees nothing: its focal point lies at its position, or its view up along the line of "
      "sight; take "
      "the camera of a view.");
  }
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.block<1, 3>(0, 0) = right.normalized().transpose();
  m.block<1, 3>(1, 0) = back.cross(right.normalized()).transpose();
  m.block<1, 3>(2, 0) = back.transpose();
  m.block<3, 1>(0, 3) = -m.block<3, 3>(0, 0) * eye;
  return m;
}

// Camera to clip. Near and far mean nothing in a stroke's view; they are an arbitrary range before the eye.
Eigen::Matrix4d Projection(bool parallel, double scale, double angle, double aspect)
{
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  if (parallel)
  {
    m.diagonal() << 1.0 / (scale * aspect), 1.0 / scale, -1.0, 1.0;
    return m;
  }
  const double near = 0.01, far = 1000.0;
  const double f = 1.0 / std::tan(vtkMath::RadiansFromDegrees(angle) / 2.0);
  m.diagonal() << f / aspect, f, -(far + near) / (far - near), 0.0;
  m(2, 3) = -2.0 * far * near / (far - near);
  m(3, 2) = -1.0;
  return m;
}

} // namespace

vtkStandardNewMacro(vtkOversketchViewStroke);

void vtkOversketchViewStroke::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (input->GetNumberOfLines() == 0 || input->GetNumberOfCells() != input->GetNumberOfLines())
  {
    throw Error(Failure::BadStroke,
      "The input holds %1 polylines and %2 other cells; give polylines alone.",
      input->GetNumberOfLines(),
      input->GetNumberOfCells() - input->GetNumberOfLines());
  }
  const int width = this->ViewSize[0];
  const int height = this->ViewSize[1];
  const View view(
    LookAt(Vector3(this->CameraPosition), Vector3(this->CameraFocalPoint), Vector3(this->CameraViewUp)),
    Projection(this->CameraParallelProjection,
      this->CameraParallelScale,
      this->CameraViewAngle,
      width > 0 && height > 0 ? static_cast<double>(width) / height : 1.0),
    width,
    height);

  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (vtkIdType line = 0; line < input->GetNumberOfLines(); ++line)
  {
    input->GetLines()->GetCellAtId(line, ids);
    lines->InsertNextCell(static_cast<int>(ids->GetNumberOfIds()));
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      Vector3 world;
      input->GetPoint(ids->GetId(i), world.data());
      if (!world.allFinite() || !view.inFront(world))
      {
        throw Error(Failure::BadStroke,
          "Point %1 of the polyline is not finite, or not before the camera; draw it where the view "
          "shows it.",
          ids->GetId(i));
      }
      const Vector3 display = view.toDisplay(world);
      lines->InsertCellPoint(points->InsertNextPoint(display[0], display[1], 0.0));
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  WriteView(view, output);
}

void vtkOversketchViewStroke::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&os, indent](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  print("CameraPosition", this->CameraPosition);
  print("CameraFocalPoint", this->CameraFocalPoint);
  print("CameraViewUp", this->CameraViewUp);
  os << indent << "CameraViewAngle: " << this->CameraViewAngle << "\n";
  os << indent << "CameraParallelScale: " << this->CameraParallelScale << "\n";
  os << indent << "CameraParallelProjection: " << this->CameraParallelProjection << "\n";
  os << indent << "ViewSize: " << this->ViewSize[0] << " " << this->ViewSize[1] << "\n";
}
