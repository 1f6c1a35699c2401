#include "vtkOversketchStrokeThinning.h"

#include "Stroke/resample.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchStrokeThinning);

void vtkOversketchStrokeThinning::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  const std::vector<DrawnLine> strokes = ReadStrokes(input);
  const Context context = ContextOf(this);
  std::vector<std::vector<Blend>> places(strokes.size());
  std::vector<char> closed;
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    for (const int kept : thinStroke(strokes[i].Samples, this->Spacing, strokes[i].Closed))
    {
      places[i].push_back(Blend::point(kept));
    }
    closed.push_back(strokes[i].Closed && places[i].size() > 2);
    context.checkpoint(static_cast<double>(i + 1) / static_cast<double>(strokes.size()));
  }
  WriteStrokes(input, strokes, places, closed, vtkPolyData::GetData(outputs));
}

void vtkOversketchStrokeThinning::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing << "\n";
}
