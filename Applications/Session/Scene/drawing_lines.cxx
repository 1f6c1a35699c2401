#include "drawing_lines.h"

#include "files.h"
#include "shared_data.h"
#include "texture.h"

#include "vtkOversketchCanvasTools.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"

#include <algorithm>

namespace oversketch_session
{

namespace
{

constexpr const char* isOn = "On";

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
const char* const pictureInput = "Picture";

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

std::vector<DrawnStroke> strokesOf(const Step& step)
{
  return step.system == drawingSystem ? strokesOf(linesOf(step, strokesInput)) : std::vector<DrawnStroke>();
}

namespace
{

// Arrays in which a stroke says what it is, and their values where it has none.
constexpr struct
{
  const char* name;
  double otherwise;
} ofStrokes[] = { { "Magnetic", 0.0 },
  { "SnapRadius", 10.0 },
  { treatmentArray, 0.0 },
  { depthArray, 0.0 },
  { heightArray, 0.0 },
  { sectionArray, 0.0 } };

// Strokes that are appended keep the arrays that all have: one that lacks an array gets what it means
// without.
std::vector<vtkSmartPointer<vtkPolyData>> alike(const std::vector<DrawnStroke>& strokes)
{
  std::vector<vtkSmartPointer<vtkPolyData>> lines;
  lines.reserve(strokes.size());
  for (const DrawnStroke& stroke : strokes)
  {
    lines.push_back(stroke.line);
  }
  for (const auto& array : ofStrokes)
  {
    const auto has = [&](vtkPolyData* line) { return line->GetCellData()->GetArray(array.name); };
    const auto it = std::find_if(lines.begin(), lines.end(), has);
    for (std::size_t i = 0; it != lines.end() && i < lines.size(); ++i)
    {
      if (!has(lines[i]))
      {
        const auto value = vtkSmartPointer<vtkDataArray>::Take(has(*it)->NewInstance());
        value->SetName(array.name);
        value->InsertNextTuple1(array.otherwise);
        lines[i] = shallowCopyOf(lines[i].Get());
        lines[i]->GetCellData()->AddArray(value);
      }
    }
  }
  return lines;
}

} // namespace

vtkSmartPointer<vtkPolyData> drawingOf(const std::vector<DrawnStroke>& strokes, vtkPolyData* like)
{
  auto drawing = vtkSmartPointer<vtkPolyData>::New();
  if (!strokes.empty())
  {
    vtkNew<vtkAppendPolyData> append;
    append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    vtkNew<vtkIntArray> on;
    on->SetName(isOn);
    for (vtkPolyData* line : alike(strokes))
    {
      append->AddInputData(line);
    }
    for (const DrawnStroke& stroke : strokes)
    {
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

namespace
{

double saidOf(vtkPolyData* line, const char* name)
{
  vtkDataArray* array = line->GetCellData()->GetArray(name);
  return array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, 0) : 0.0;
}

template <typename Array, typename Value>
void say(vtkPolyData* line, const char* name, Value value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(value);
  line->GetCellData()->AddArray(array);
}

} // namespace

int treatmentOf(vtkPolyData* line)
{
  return static_cast<int>(saidOf(line, treatmentArray));
}

int depthOf(vtkPolyData* line)
{
  return static_cast<int>(saidOf(line, depthArray));
}

double heightOf(vtkPolyData* line)
{
  return saidOf(line, heightArray);
}

int crossSectionOf(vtkPolyData* line)
{
  return static_cast<int>(saidOf(line, sectionArray));
}

vtkSmartPointer<vtkPolyData> withDepth(vtkPolyData* line, int depth, double height, int crossSection)
{
  const vtkSmartPointer<vtkPolyData> next = shallowCopyOf(line);
  say<vtkIntArray>(next, depthArray, depth);
  say<vtkDoubleArray>(next, heightArray, height);
  say<vtkIntArray>(next, sectionArray, crossSection);
  return next;
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

std::shared_ptr<const Step> partOver(const Image& picture, const std::array<double, 3>& place, double unit)
{
  auto step = std::make_shared<Step>(*drawingOver(picture));
  const std::array<double, 4> canvas = canvasOf(*step);
  const double half[2] = { 0.5 * unit * (canvas[2] - canvas[0]), 0.5 * unit * (canvas[3] - canvas[1]) };
  step->part = { { place[0] - half[0], place[1] - half[1], place[0] + half[0], place[1] + half[1] },
    place[2] };
  return step;
}

const Image* pictureUnder(const Step& step)
{
  const auto given = step.inputs.find(pictureInput);
  return given == step.inputs.end() ? nullptr : std::get_if<Image>(&given->second);
}

std::array<double, 4> canvasOf(const Step& step)
{
  const Image* image = pictureUnder(step);
  oversketch::Canvas canvas;
  if (const auto picture = image ? oversketch_files::pictureOf(*image->bytes) : nullptr)
  {
    canvas = oversketch::PlaceOf(picture).Rectangle;
  }
  else if (const auto drawing = linesOf(step, strokesInput);
           drawing && drawing->GetFieldData()->GetArray("Canvas"))
  {
    canvas = oversketch::CanvasOf(drawing);
  }
  else
  {
    return {};
  }
  const oversketch::Vector2 end = canvas.corner + canvas.size;
  return { canvas.corner[0], canvas.corner[1], end[0], end[1] };
}

Step withDrawing(const Step& step, vtkPolyData* drawing)
{
  Step next = step;
  next.inputs[strokesInput] = Lines(drawing);
  return next;
}

} // namespace oversketch_session
