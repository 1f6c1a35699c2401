#include "stroke_list.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace oversketch
{

std::vector<vtkSmartPointer<vtkPolyData>> strokesOf(vtkPolyData* all)
{
  std::vector<vtkSmartPointer<vtkPolyData>> strokes;
  vtkNew<vtkIdList> from;
  for (vtkIdType i = 0; all && i < all->GetNumberOfLines(); ++i)
  {
    all->GetLines()->GetCellAtId(i, from);
    const vtkIdType count = from->GetNumberOfIds();
    const bool closed = count > 2 && from->GetId(0) == from->GetId(count - 1);
    auto one = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    one->GetPointData()->CopyAllocate(all->GetPointData());
    one->GetCellData()->CopyAllocate(all->GetCellData());
    lines->InsertNextCell(static_cast<int>(count));
    for (vtkIdType k = 0; k < count - closed; ++k)
    {
      lines->InsertCellPoint(points->InsertNextPoint(all->GetPoint(from->GetId(k))));
      one->GetPointData()->CopyData(all->GetPointData(), from->GetId(k), k);
    }
    if (closed)
    {
      lines->InsertCellPoint(0);
    }
    one->GetCellData()->CopyData(all->GetCellData(), i, 0);
    one->SetPoints(points);
    one->SetLines(lines);
    strokes.push_back(one);
  }
  return strokes;
}

void putInto(vtkPolyData* all, const std::vector<vtkSmartPointer<vtkPolyData>>& strokes)
{
  vtkNew<vtkPolyData> joined;
  if (!strokes.empty())
  {
    vtkNew<vtkAppendPolyData> append;
    append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    for (vtkPolyData* stroke : strokes)
    {
      append->AddInputData(stroke);
    }
    append->Update();
    joined->ShallowCopy(append->GetOutput());
  }
  all->ShallowCopy(joined);
  all->Modified();
}

} // namespace oversketch
