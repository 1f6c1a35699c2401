#include "stroke_list.h"

#include "vtkOversketchCanvasTools.h"

#include "vtkAppendPolyData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace oversketch
{

std::vector<vtkSmartPointer<vtkPolyData>> strokesOf(vtkPolyData* all)
{
  std::vector<vtkSmartPointer<vtkPolyData>> strokes;
  for (vtkIdType i = 0; all && i < all->GetNumberOfLines(); ++i)
  {
    strokes.push_back(StrokeAlone(all, i));
    strokes.back()->GetFieldData()->Initialize();
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
