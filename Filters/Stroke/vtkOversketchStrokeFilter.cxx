#include "vtkOversketchStrokeFilter.h"

#include "Stroke/stroke.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <limits>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchStrokeFilter);

void vtkOversketchStrokeFilter::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const vtkIdType strokes = input->GetNumberOfLines();
  if (strokes == 0 || strokes != input->GetNumberOfCells())
  {
    throw Error(Failure::BadStroke,
      "The stroke input must hold polylines and no other cells: a stroke is one polyline.");
  }
  StrokeRules rules;
  rules.minimumSpacing = this->MinimumSpacing;
  rules.spacing = this->Spacing;
  rules.minimumLength = this->MinimumLength;
  rules.refuseClosed = this->RefuseClosed;
  rules.maximumLength = this->MaximumLength;
  vtkDataArray* viewports = input->GetCellData()->GetArray("ViewportSize");
  const bool sized = viewports && viewports->GetNumberOfComponents() == 2 &&
                     viewports->GetNumberOfTuples() == input->GetNumberOfCells();
  std::vector<DrawnLine> lines(static_cast<std::size_t>(strokes));
  std::vector<std::vector<Blend>> places(lines.size());
  vtkNew<vtkIdList> ids;
  for (vtkIdType stroke = 0; stroke < strokes; ++stroke)
  {
    input->GetLines()->GetCellAtId(stroke, ids);
    DrawnLine& line = lines[static_cast<std::size_t>(stroke)];
    line.Ids.assign(ids->begin(), ids->end());
    for (const vtkIdType id : line.Ids)
    {
      // An id out of range makes a sample that is not finite, and is refused as such.
      Vector3 p = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
      if (id >= 0 && id < input->GetNumberOfPoints())
      {
        input->GetPoint(id, p.data());
      }
      line.Samples.push_back(p.head<2>());
    }
    if (sized)
    {
      viewports->GetTuple(stroke, rules.viewport.data());
    }
    try
    {
      places[static_cast<std::size_t>(stroke)] = cleanStroke(line.Samples, rules);
    }
    catch (const Error& error)
    {
      throw Error(error.failure(), Message::unusable("Stroke", stroke, error.message()));
    }
  }
  WriteStrokes(input, lines, places, std::vector<char>(lines.size(), 0), output);
}

void vtkOversketchStrokeFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MinimumSpacing: " << this->MinimumSpacing << '\n';
  os << indent << "Spacing: " << this->Spacing << '\n';
  os << indent << "MinimumLength: " << this->MinimumLength << '\n';
  os << indent << "RefuseClosed: " << (this->RefuseClosed ? "on" : "off") << '\n';
  os << indent << "MaximumLength: " << this->MaximumLength << '\n';
}
