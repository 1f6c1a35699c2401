// Strokes of several views in one polydata, models of the shared data and views of them, for the tests of
// this module.
#ifndef SurfaceTools_h
#define SurfaceTools_h

#include "Harness/data.h"
#include "Harness/promises.h"

#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"

namespace oversketch_test
{

// Strokes one after the other, each with its own view; closed ones repeat their first id.
inline vtkSmartPointer<vtkPolyData> toStrokes(
  const std::vector<std::pair<std::vector<Vector2>, View>>& strokes,
  const std::vector<bool>& closed = {})
{
  auto all = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  all->SetPoints(points);
  all->SetLines(lines);
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    const auto one = toStroke(strokes[i].first, strokes[i].second);
    const bool ring = i < closed.size() && closed[i];
    const vtkIdType first = points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(one->GetNumberOfPoints()) + ring);
    for (vtkIdType k = 0; k < one->GetNumberOfPoints(); ++k)
    {
      lines->InsertCellPoint(points->InsertNextPoint(one->GetPoint(k)));
    }
    if (ring)
    {
      lines->InsertCellPoint(first);
    }
    for (int a = 0; a < one->GetCellData()->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* from = one->GetCellData()->GetArray(a);
      vtkDataArray* to = all->GetCellData()->GetArray(from->GetName());
      if (to)
      {
        to->InsertNextTuple(0, from);
      }
      else
      {
        all->GetCellData()->AddArray(from);
      }
    }
  }
  return all;
}

inline std::vector<Vector2> straight(const Vector2& a, const Vector2& b, int count)
{
  std::vector<Vector2> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    samples.emplace_back(a + (b - a) * i / (count - 1));
  }
  return samples;
}

// The points of one cell; a closed one repeats its first.
inline std::vector<Vector3> pointsOfCell(vtkPolyData* curves, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  curves->GetLines()->GetCellAtId(cell, ids);
  std::vector<Vector3> points;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    points.emplace_back(curves->GetPoint(ids->GetId(i)));
  }
  return points;
}

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
