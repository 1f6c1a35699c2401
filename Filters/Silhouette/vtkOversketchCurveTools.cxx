#include "vtkOversketchCurveTools.h"

#include "vtkOversketchBindings.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace oversketch
{

void WriteCurves(const std::vector<Curve>& curves, const View& view, vtkPolyData* output)
{
  vtkIdType pointCount = 0, closedCount = 0;
  for (const Curve& curve : curves)
  {
    pointCount += static_cast<vtkIdType>(curve.points.size());
    closedCount += curve.closed;
  }
  const auto sized = [pointCount](vtkDataArray* array, const char* name, int components)
  {
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(pointCount);
  };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(pointCount);
  vtkNew<vtkIdTypeArray> offsets, connectivity;
  vtkNew<vtkDoubleArray> normals, dots;
  std::vector<Binding> bindings;
  bindings.reserve(static_cast<std::size_t>(pointCount));
  sized(normals, "Normals", 3);
  sized(dots, "NormalDotView", 1);
  offsets->SetNumberOfValues(static_cast<vtkIdType>(curves.size()) + 1);
  connectivity->SetNumberOfValues(pointCount + closedCount);
  double* position = static_cast<double*>(points->GetVoidPointer(0));
  double* normal = normals->GetPointer(0);
  double* dot = dots->GetPointer(0);
  vtkIdType* offset = offsets->GetPointer(0);
  vtkIdType* id = connectivity->GetPointer(0);
  vtkIdType next = 0;
  *offset = 0;
  for (const Curve& curve : curves)
  {
    const vtkIdType first = next;
    for (const CurvePoint& p : curve.points)
    {
      *id++ = next++;
      position = std::copy_n(p.position.data(), 3, position);
      bindings.push_back(p.binding);
      normal = std::copy_n(p.normal.data(), 3, normal);
      *dot++ = p.normal.dot(view.towardsViewer(p.position).normalized());
    }
    if (curve.closed)
    {
      *id++ = first;
    }
    offset[1] = offset[0] + (next - first) + (curve.closed ? 1 : 0);
    ++offset;
  }
  vtkNew<vtkCellArray> lines;
  lines->SetData(offsets, connectivity);
  output->SetPoints(points);
  output->SetLines(lines);
  WriteBindings(bindings, output);
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->AddArray(dots);
}

CurveSet ReadCurves(vtkPolyData* input, int meshVertices, const std::string& holder, Unbound unbound)
{
  const std::string remedy =
    "take the output of vtkOversketchSilhouette, or of a filter after it, for this mesh";
  const auto refuse = [&](const char* what, vtkIdType index, const char* problem)
  { throw Error(Failure::BadMesh, "%1 %2 of the %3 %4", what, index, holder, problem); };
  const vtkIdType pointCount = input->GetNumberOfPoints();
  const vtkIdType cellCount = input->GetNumberOfLines();
  CurveSet set;
  if (input->GetNumberOfCells() != cellCount)
  {
    throw Error(Failure::BadMesh,
      "The %1 hold cells that are not polylines; connect the output of a silhouette filter.",
      holder);
  }
  if (cellCount == 0)
  {
    return set;
  }
  vtkPointData* pointData = input->GetPointData();
  const std::vector<Binding> bindings = ReadBindings(input, meshVertices, holder, remedy, unbound);
  vtkDataArray* normals = RequireArray(pointData, "Normals", 3, pointCount, holder, remedy);
  std::vector<CurvePoint> points(static_cast<std::size_t>(pointCount));
  for (vtkIdType i = 0; i < pointCount; ++i)
  {
    CurvePoint& p = points[static_cast<std::size_t>(i)];
    input->GetPoint(i, p.position.data());
    normals->GetTuple(i, p.normal.data());
    p.binding = bindings[static_cast<std::size_t>(i)];
    if (!p.position.allFinite() || !p.normal.allFinite())
    {
      refuse("Point", i, "or its normal is not finite; run the silhouette filter again.");
    }
  }
  vtkCellArray* lines = input->GetLines();
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(lines->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    Curve curve;
    curve.closed = size > 2 && ids[0] == ids[size - 1];
    for (vtkIdType k = 0; k < (curve.closed ? size - 1 : size); ++k)
    {
      if (ids[k] < 0 || ids[k] >= pointCount)
      {
        refuse("Cell",
          it->GetCurrentCellId(),
          "names a point that does not exist; run the silhouette filter again.");
      }
      curve.points.push_back(points[static_cast<std::size_t>(ids[k])]);
    }
    set.Curves.push_back(std::move(curve));
  }
  set.Visible.assign(set.Curves.size(), 1);
  for (int i = 0; i < static_cast<int>(cellCount); ++i)
  {
    set.Ids.push_back(i);
  }
  vtkCellData* cellData = input->GetCellData();
  vtkDataArray* curveIds = OptionalArray(cellData, "CurveId", 1, cellCount, holder, remedy);
  vtkDataArray* visible = OptionalArray(cellData, "Visible", 1, cellCount, holder, remedy);
  for (vtkIdType i = 0; i < cellCount; ++i)
  {
    if (curveIds)
    {
      set.Ids[static_cast<std::size_t>(i)] = static_cast<int>(curveIds->GetComponent(i, 0));
    }
    if (visible)
    {
      set.Visible[static_cast<std::size_t>(i)] = visible->GetComponent(i, 0) != 0.0;
    }
  }
  return set;
}

MeshKey CurvesKey(vtkPolyData* curves)
{
  std::vector<vtkDataArray*> arrays;
  for (const char* name : { "MeshVertices", "MeshWeights", "Normals", "Display", "Offset" })
  {
    arrays.push_back(curves->GetPointData()->GetArray(name));
  }
  for (const char* name : { "CurveId", "Visible", "Hole" })
  {
    arrays.push_back(curves->GetCellData()->GetArray(name));
  }
  return MeshKey(curves, arrays);
}

MeshKey SurfaceKey(vtkPolyData* mesh)
{
  return MeshKey(mesh, { mesh->GetPointData()->GetNormals() });
}

} // namespace oversketch
