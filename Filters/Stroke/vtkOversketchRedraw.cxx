#include "vtkOversketchRedraw.h"

#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchRedraw);

namespace
{

constexpr double nearness = 0.02; // r_o of the specification, of the canvas's longest side

// Array that says what a stroke is, and its value where there is none.
struct StrokeArray
{
  const char* Name;
  double Otherwise;
};
constexpr StrokeArray strokeArrays[] = { { "Magnetic", 0.0 }, { "SnapRadius", 10.0 }, { "Treatment", 0.0 } };

double otherwise(const char* name)
{
  const auto found = std::find_if(std::begin(strokeArrays),
    std::end(strokeArrays),
    [&](const StrokeArray& each) { return name && std::strcmp(each.Name, name) == 0; });
  return found == std::end(strokeArrays) ? 0.0 : found->Otherwise;
}

// Array of the same name of another polydata, of the same size of tuples.
vtkDataArray* counterpart(vtkDataArray* array, vtkDataSetAttributes* other)
{
  vtkDataArray* found = array->GetName() ? other->GetArray(array->GetName()) : nullptr;
  return found && found->GetNumberOfComponents() == array->GetNumberOfComponents() ? found : nullptr;
}

// Numbers at the samples of one curve, one list for each component of each array.
using Values = std::vector<std::vector<double>>;

Values valuesAt(const std::vector<vtkDataArray*>& arrays, const std::vector<vtkIdType>& ids)
{
  Values values;
  for (vtkDataArray* array : arrays)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      values.emplace_back();
      for (const vtkIdType id : ids)
      {
        values.back().push_back(array->GetComponent(id, c));
      }
    }
  }
  return values;
}

// The curves as corrections change them.
struct Redrawn
{
  std::vector<CanvasStroke> Curves;
  std::vector<Values> Numbers; // of each curve
  std::vector<int> Sources;    // of each new curve, the correction

  void Apply(const StrokeOnCanvas& fresh, const Values& freshNumbers, int number, const Canvas& canvas)
  {
    Correction correction;
    try
    {
      correction =
        corrected(this->Curves, fresh.Curve.points, nearness * canvas.longest(), SampleSpacing(canvas));
    }
    catch (const Error& error)
    {
      throw Error(error.failure(), Message::unusable("Correction", number, { "%1.", error.message() }));
    }
    if (correction.kind == Correction::New)
    {
      this->Curves.push_back(fresh.Curve);
      this->Numbers.push_back(freshNumbers);
      this->Sources.push_back(number);
      return;
    }
    this->Curves[correction.stroke].points = correction.result.points;
    Values& numbers = this->Numbers[correction.stroke];
    for (std::size_t k = 0; k < numbers.size(); ++k)
    {
      numbers[k] = mapped(correction.result.origins,
        [&](const Origin& origin) { return origin.of(numbers[k], freshNumbers[k]); });
    }
  }
};

void writePointArrays(const std::vector<vtkDataArray*>& arrays, const Redrawn& redrawn, vtkPolyData* output)
{
  std::size_t list = 0;
  for (vtkDataArray* array : arrays)
  {
    const auto written = LikeArray(array, static_cast<std::size_t>(output->GetNumberOfPoints()));
    for (int c = 0; c < array->GetNumberOfComponents(); ++c, ++list)
    {
      vtkIdType id = 0;
      for (const Values& numbers : redrawn.Numbers)
      {
        for (const double value : numbers[list])
        {
          written->SetComponent(id++, c, value);
        }
      }
    }
    output->GetPointData()->AddArray(written);
  }
}

// A cell array with the tuples of the curves, which may be none, and those of new strokes.
void writeCellArray(vtkDataArray* model,
  vtkDataArray* old,
  vtkDataArray* fresh,
  const Redrawn& redrawn,
  vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(redrawn.Curves.size());
  const vtkIdType before = count - static_cast<vtkIdType>(redrawn.Sources.size());
  const auto written = LikeArray(model, redrawn.Curves.size());
  written->Fill(otherwise(model->GetName()));
  for (vtkIdType i = 0; i < count; ++i)
  {
    vtkDataArray* from = i < before ? old : fresh;
    if (from)
    {
      written->SetTuple(i, i < before ? i : redrawn.Sources[static_cast<std::size_t>(i - before)], from);
    }
  }
  output->GetCellData()->AddArray(written);
}

void writeCellArrays(vtkCellData* curves,
  vtkCellData* corrections,
  const Redrawn& redrawn,
  vtkPolyData* output)
{
  for (int i = 0; i < curves->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = curves->GetArray(i);
    if (array && array->GetName() && !output->GetCellData()->HasArray(array->GetName()))
    {
      writeCellArray(array, array, counterpart(array, corrections), redrawn, output);
    }
  }
  for (const StrokeArray& each : strokeArrays)
  {
    vtkDataArray* array = corrections->GetArray(each.Name);
    if (array && !output->GetCellData()->HasArray(each.Name))
    {
      writeCellArray(array, nullptr, array, redrawn, output);
    }
  }
}

MeshKey wholeKey(vtkPolyData* polyData)
{
  std::vector<const char*> names;
  for (int i = 0; i < polyData->GetCellData()->GetNumberOfArrays(); ++i)
  {
    if (const char* name = polyData->GetCellData()->GetArrayName(i))
    {
      names.push_back(name);
    }
  }
  return CurvesKey(polyData, names);
}

} // namespace

vtkOversketchRedraw::vtkOversketchRedraw()
{
  this->SetNumberOfInputPorts(2);
  DeclareInput(this, 1, { Port::Optional });
}

void vtkOversketchRedraw::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* curves = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* corrections = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (!corrections || corrections->GetNumberOfPoints() == 0)
  {
    output->ShallowCopy(curves);
    return;
  }
  this->Kept<KeptOutput>().Provide(StepKey({ wholeKey(curves), wholeKey(corrections) }, {}),
    output,
    [&](vtkPolyData* result)
    {
      ++this->CorrectionCount;
      const Canvas canvas = CanvasOf(curves);
      std::vector<vtkDataArray*> oldArrays, freshArrays;
      for (int i = 0; i < curves->GetPointData()->GetNumberOfArrays(); ++i)
      {
        vtkDataArray* array = curves->GetPointData()->GetArray(i);
        vtkDataArray* other = array ? counterpart(array, corrections->GetPointData()) : nullptr;
        if (other && std::strcmp(array->GetName(), "ArcLength") != 0)
        {
          oldArrays.push_back(array);
          freshArrays.push_back(other);
        }
      }
      Redrawn redrawn;
      for (const DrawnLine& line : ReadStrokes(curves, 1))
      {
        redrawn.Curves.push_back({ line.Samples, line.Closed });
        redrawn.Numbers.push_back(valuesAt(oldArrays, line.Ids));
      }
      const std::vector<DrawnLine> lines = ReadStrokes(corrections, 1);
      const Context context = ContextOf(this);
      for (int i = 0; i < static_cast<int>(lines.size()); ++i)
      {
        const StrokeOnCanvas fresh = OntoCanvas(corrections, lines, i, canvas, "Correction");
        const auto ids = mapped(fresh.Places, [&](const Blend& place) { return lines[i].Ids[place.from]; });
        redrawn.Apply(fresh, valuesAt(freshArrays, ids), i, canvas);
        context.checkpoint((i + 1.0) / static_cast<double>(lines.size()));
      }
      WriteCurves(redrawn.Curves, canvas, result);
      writePointArrays(oldArrays, redrawn, result);
      writeCellArrays(curves->GetCellData(), corrections->GetCellData(), redrawn, result);
      PassDrawingArrays(curves, result);
    });
}

void vtkOversketchRedraw::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CorrectionCount: " << this->CorrectionCount << "\n";
}
