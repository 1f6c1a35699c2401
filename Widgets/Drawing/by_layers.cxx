#include "by_layers.h"

#include "pen_stroke.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchStepRunner.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <map>

namespace oversketch
{

std::vector<Message> runByLayers(const std::vector<vtkPolyDataAlgorithm*>& steps,
  vtkPolyData* lines,
  const std::vector<int>& layers,
  vtkPolyData* curves)
{
  std::map<int, std::vector<vtkSmartPointer<vtkPolyData>>> parts;
  vtkDataArray* strokes = lines->GetCellData()->GetArray("StrokeId");
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    parts[layers.at(static_cast<std::size_t>(strokes->GetComponent(i, 0)))].push_back(StrokeAlone(lines, i));
  }
  std::vector<Message> warnings, errors;
  StepRunner::Listener listener;
  listener.warning = [&](const Message& message) { warnings.push_back(message); };
  std::vector<vtkSmartPointer<vtkPolyData>> made;
  for (const auto& [layer, part] : parts)
  {
    auto last = vtkSmartPointer<vtkPolyData>::New();
    putInto(last, part);
    last->GetFieldData()->ShallowCopy(lines->GetFieldData());
    steps.front()->SetInputData(0, last);
    made.push_back(last);
    try
    {
      for (vtkPolyDataAlgorithm* step : steps)
      {
        StepRunner(step, listener).Run();
        made.back() = vtkSmartPointer<vtkPolyData>::New();
        made.back()->ShallowCopy(step->GetOutput());
      }
    }
    catch (const Error& error)
    {
      errors.push_back(error.message());
      const auto unknown = NewArray<vtkIntArray>("Role", 1, made.back()->GetNumberOfCells());
      unknown->FillValue(0); // arrays that one lacks are dropped
      made.back()->GetCellData()->AddArray(unknown);
    }
  }
  putInto(curves, made);
  curves->GetFieldData()->ShallowCopy(made.front()->GetFieldData());
  return errors.empty() ? warnings : errors;
}

} // namespace oversketch
