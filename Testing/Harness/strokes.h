// Strokes of several views in one polydata, and what to read of curves. Header-only.
#ifndef oversketch_testing_harness_strokes_h
#define oversketch_testing_harness_strokes_h

#include "Harness/polydata.h"

#include "vtkIdList.h"

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

} // namespace oversketch_test
#endif
