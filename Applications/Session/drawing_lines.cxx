#include "drawing_lines.h"

#include "files.h"
#include "texture.h"

#include "vtkOversketchCanvasTools.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"

#include <algorithm>

namespace oversketch_session
{

namespace
{

constexpr const char* isOn = "On";
constexpr const char* pictureInput = "Picture";

vtkDataArray* onArray(vtkPolyData* drawing)
{
  vtkDataArray* array = drawing->GetCellData()->GetArray(isOn);
  return array && array->GetNumberOfTuples() == drawing->GetNumberOfCells() ? array : nullptr;
}

bool isOfLines(vtkPolyData* drawing)
{
  return drawing && drawing->GetNumberOfLines() > 0 &&
         drawing->GetNumberOfLines() == drawing->GetNumberOfCells();
}

} // namespace

const char* const drawingSystem = "InflateDrawing";
const char* const strokesInput = "Strokes";

std::vector<DrawnStroke> strokesOf(vtkPolyData* drawing)
{
  std::vector<DrawnStroke> strokes;
  for (vtkIdType i = 0; isOfLines(drawing) && i < drawing->GetNumberOfLines(); ++i)
  {
    DrawnStroke stroke;
    stroke.line = oversketch::StrokeAlone(drawing, i);
    stroke.on = !onArray(drawing) || onArray(drawing)->GetComponent(i, 0) != 0.0;
    stroke.line->GetCellData()->RemoveArray(isOn);
    strokes.push_back(stroke);
  }
  return strokes;
}

vtkSmartPointer<vtkPolyData> drawingOf(const std::vector<DrawnStroke>& strokes, vtkPolyData* like)
{
  auto drawing = vtkSmartPointer<vtkPolyData>::New();
  if (!strokes.empty())
  {
    vtkNew<vtkAppendPolyData> append;
    append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    vtkNew<vtkIntArray> on;
    on->SetName(isOn);
    for (const DrawnStroke& stroke : strokes)
    {
      append->AddInputData(stroke.line);
      on->InsertNextValue(stroke.on);
    }
    append->Update();
    drawing->ShallowCopy(append->GetOutput());
    const auto isOff = [](const DrawnStroke& stroke) { return !stroke.on; };
    if (std::any_of(strokes.begin(), strokes.end(), isOff))
    {
      drawing->GetCellData()->AddArray(on);
    }
  }
  drawing->GetFieldData()->ShallowCopy(like->GetFieldData());
  return drawing;
}

vtkSmartPointer<vtkPolyData> strokesThatAreOn(vtkPolyData* drawing)
{
  if (!isOfLines(drawing) || !onArray(drawing))
  {
    return drawing;
  }
  std::vector<DrawnStroke> strokes = strokesOf(drawing);
  strokes.erase(
    std::remove_if(strokes.begin(), strokes.end(), [](const DrawnStroke& stroke) { return !stroke.on; }),
    strokes.end());
  return drawingOf(strokes, drawing);
}

int treatmentOf(vtkPolyData* line)
{
  vtkDataArray* array = line->GetCellData()->GetArray("Treatment");
  return array && array->GetNumberOfTuples() == 1 ? static_cast<int>(array->GetComponent(0, 0)) : 0;
}

std::shared_ptr<const Step> drawingOver(const Image& picture)
{
  if (!oversketch_files::pictureOf(*picture.bytes))
  {
    throw oversketch_files::Failed(picture.name + " is no PNG or JPEG picture, or a damaged one.");
  }
  auto step = std::make_shared<Step>();
  step->system = drawingSystem;
  step->inputs[strokesInput] = Lines(vtkNew<vtkPolyData>());
  step->inputs[pictureInput] = picture;
  return step;
}

std::shared_ptr<const Step> drawingOn(double width, double height)
{
  vtkNew<vtkPolyData> empty;
  oversketch::WriteCanvas({ { 0.0, 0.0 }, { width, height } }, empty);
  auto step = std::make_shared<Step>();
  step->system = drawingSystem;
  step->inputs[strokesInput] = Lines(empty);
  return step;
}

Step withDrawing(const Step& step, vtkPolyData* drawing)
{
  Step next = step;
  next.inputs[strokesInput] = Lines(drawing);
  return next;
}

} // namespace oversketch_session
