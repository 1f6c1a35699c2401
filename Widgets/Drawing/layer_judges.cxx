#include "layer_judges.h"

#include "pen_stroke.h"
#include "vtkOversketchArrange.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchClassify.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchStepRunner.h"
#include "vtkOversketchTreatment.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <map>

namespace oversketch
{

using Lines = std::vector<vtkSmartPointer<vtkPolyData>>;

struct LayerJudges::Judge
{
  vtkNew<vtkPolyData> lines, curves;
  vtkNew<vtkOversketchArrange> arrange;
  vtkNew<vtkOversketchClassify> classify;
  vtkNew<vtkOversketchTreatment> treatment;

  Judge()
  {
    this->arrange->SetInputData(0, this->lines);
    this->treatment->SetInputConnection(0, this->classify->GetOutputPort());
  }
  void run(bool arranges, const StepRunner::Listener& listener)
  {
    this->curves->ShallowCopy(this->lines);
    arranges ? this->classify->SetInputConnection(0, this->arrange->GetOutputPort())
             : this->classify->SetInputData(0, this->lines);
    std::vector<vtkPolyDataAlgorithm*> steps{ this->classify, this->treatment };
    if (arranges)
    {
      steps.insert(steps.begin(), this->arrange);
    }
    for (vtkPolyDataAlgorithm* step : steps)
    {
      StepRunner(step, listener).Run();
      this->curves->ShallowCopy(step->GetOutput());
    }
  }
};

LayerJudges::LayerJudges() = default;
LayerJudges::~LayerJudges() = default;

std::vector<Message> LayerJudges::judge(vtkPolyData* lines,
  const std::vector<int>& layers,
  bool arranges,
  vtkPolyData* curves)
{
  const auto putAll = [](vtkPolyData* into, const Lines& all)
  {
    putInto(into, all);
    into->GetFieldData()->ShallowCopy(all.front()->GetFieldData());
  };
  std::map<int, Lines> parts;
  vtkDataArray* strokes = lines->GetCellData()->GetArray("StrokeId");
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    parts[layers.at(static_cast<std::size_t>(strokes->GetComponent(i, 0)))].push_back(StrokeAlone(lines, i));
  }
  std::vector<Message> warnings, errors;
  StepRunner::Listener listener;
  listener.warning = [&](const Message& message) { warnings.push_back(message); };
  Lines made;
  for (const auto& [layer, part] : parts)
  {
    if (made.size() == this->All.size())
    {
      this->All.push_back(std::make_unique<Judge>());
    }
    Judge& judge = *this->All[made.size()];
    putAll(judge.lines, part);
    try
    {
      judge.run(arranges, listener);
    }
    catch (const Error& error)
    {
      errors.push_back(error.message());
      const auto unknown = NewArray<vtkIntArray>("Role", 1, part.size());
      unknown->FillValue(0); // an array that one lacks would be dropped
      judge.curves->GetCellData()->AddArray(unknown);
    }
    made.push_back(judge.curves);
  }
  putAll(curves, made);
  return errors.empty() ? warnings : errors;
}

} // namespace oversketch
