#include "vtkOversketchStrokeView.h"

#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <string>

namespace oversketch
{

std::vector<vtkDataArray*> ViewArraysOf(vtkPolyData* strokes)
{
  std::vector<vtkDataArray*> arrays;
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
  {
    vtkDataArray* array = strokes->GetCellData()->GetArray(name);
    if (array && array->GetNumberOfTuples() == strokes->GetNumberOfCells())
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

View ViewOfStroke(vtkPolyData* strokes, vtkIdType stroke)
{
  vtkNew<vtkPolyData> one;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ points->InsertNextPoint(0.0, 0.0, 0.0) });
  one->SetPoints(points);
  one->SetLines(lines);
  for (vtkDataArray* array : ViewArraysOf(strokes))
  {
    one->GetCellData()->AddArray(CarriedArray(array, std::vector<vtkIdType>{ stroke }));
  }
  try
  {
    return ViewOf(one);
  }
  catch (const Error& error)
  {
    throw Error(error.failure(), Message::unusable("Stroke", stroke, error.message()));
  }
}

} // namespace oversketch
