// Models of the shared data and views of them, for the tests of this module.
#ifndef oversketch_filters_stroke_testing_surface_tools_h
#define oversketch_filters_stroke_testing_surface_tools_h

#include "Harness/data.h"
#include "Harness/promises.h"
#include "Harness/strokes.h"

#include "vtkFloatArray.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"

namespace oversketch_test
{

inline double longestSegment(vtkPolyData* curves)
{
  double longest = 0.0;
  for (vtkIdType cell = 0; cell < curves->GetNumberOfLines(); ++cell)
  {
    const std::vector<Vector3> points = pointsOfCell(curves, cell);
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      longest = std::max(longest, (points[i] - points[i - 1]).norm());
    }
  }
  return longest;
}

// A model of the shared data, e.g. "bunny_5k.obj"; null, saying so, where it is absent.
inline vtkSmartPointer<vtkPolyData> sharedModel(const std::string& name)
{
  const std::string path = sharedData("meshes/" + name);
  if (path.empty())
  {
    std::cout << name << " is absent: set OVERSKETCH_DATA\n";
    return nullptr;
  }
  auto model = vtkSmartPointer<vtkPolyData>::New();
  if (name.substr(name.size() - 4) == ".ply")
  {
    vtkNew<vtkPLYReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    model->ShallowCopy(reader->GetOutput());
  }
  else
  {
    vtkNew<vtkOBJReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    model->ShallowCopy(reader->GetOutput());
  }
  return model;
}

// The model fills most of an 800 x 600 picture, seen askew.
inline View viewOfModel(vtkPolyData* model, bool perspective)
{
  double b[6];
  model->GetBounds(b);
  const Vector3 low(b[0], b[2], b[4]), high(b[1], b[3], b[5]);
  const double size = (high - low).norm();
  const View at = perspective
                    ? perspectiveView(Vector3(0.8, 0.5, 1.2).normalized() * 1.6 * size, { 0, 1, 0 }, 40)
                    : orthographicView({ 0.3, 0.2, 1 }, { 0, 1, 0 }, 550.0 / size);
  Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
  shift.topRightCorner<3, 1>() = -0.5 * (low + high);
  return View(at.viewTransform() * shift, at.projectionTransform(), 800, 600);
}

} // namespace oversketch_test
#endif
