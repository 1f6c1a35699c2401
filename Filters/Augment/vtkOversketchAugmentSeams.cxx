#include "vtkOversketchAugmentSeams.h"

#include "vtkOversketchCarriedArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace oversketch
{

void CopyStellarArrays(vtkPolyData* source, const std::vector<vtkIdType>& from, vtkPolyData* to)
{
  for (const char* name : stellarPointArrays)
  {
    if (vtkDataArray* array = source->GetPointData()->GetArray(name))
    {
      to->GetPointData()->AddArray(CarriedArray(array, from));
    }
  }
  for (const char* name : stellarCellArrays)
  {
    if (vtkDataArray* array = source->GetCellData()->GetArray(name))
    {
      to->GetCellData()->AddArray(array);
    }
  }
  for (const char* name : stellarFieldArrays)
  {
    if (vtkDataArray* array = source->GetFieldData()->GetArray(name))
    {
      to->GetFieldData()->AddArray(array);
    }
  }
}

std::vector<vtkIdType> PutSplit(vtkPolyData* split,
  const std::vector<int>& vertices,
  vtkPolyData* augmented,
  vtkPolyData* output)
{
  const vtkIdType vertexCount = augmented->GetNumberOfPoints();
  std::vector<vtkIdType> order(static_cast<std::size_t>(vertexCount), -1), repeated, number(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    vtkIdType& first = order[vertices[i]];
    const auto point = static_cast<vtkIdType>(i);
    if (first < 0)
    {
      first = point;
      number[i] = vertices[i];
    }
    else
    {
      number[i] = vertexCount + static_cast<vtkIdType>(repeated.size());
      repeated.push_back(point);
    }
  }
  order.insert(order.end(), repeated.begin(), repeated.end());

  const auto count = static_cast<vtkIdType>(order.size());
  std::vector<vtkIdType> vertexOf(order.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  CopyElements(split->GetPointData(), order, output->GetPointData());
  for (vtkIdType i = 0; i < count; ++i)
  {
    vertexOf[i] = vertices[order[i]];
    points->SetPoint(i, augmented->GetPoint(vertexOf[i]));
  }
  output->SetPoints(points);
  const vtkIdType cells = split->GetNumberOfPolys();
  vtkNew<vtkCellArray> polys;
  polys->AllocateExact(cells, 3 * cells);
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; f < cells; ++f)
  {
    split->GetPolys()->GetCellAtId(f, ids);
    const vtkIdType corners[3] = { number[ids->GetId(0)], number[ids->GetId(1)], number[ids->GetId(2)] };
    polys->InsertNextCell(3, corners);
  }
  output->SetPolys(polys);
  output->GetCellData()->ShallowCopy(split->GetCellData());
  output->GetFieldData()->ShallowCopy(split->GetFieldData());
  CopyStellarArrays(augmented, vertexOf, output);
  return vertexOf;
}

} // namespace oversketch
