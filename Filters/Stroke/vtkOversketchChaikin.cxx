#include "vtkOversketchChaikin.h"

#include "Stroke/resample.h"
#include "Stroke/stroke.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

namespace
{

constexpr double closingDistance = 8.0; // px

// The stroke as it is, closed where it comes back; a last sample upon the first is the first.
std::vector<Blend> ringPlaces(const DrawnLine& stroke, double closingDistance, char& closed)
{
  std::vector<Blend> places;
  places.reserve(stroke.Samples.size());
  for (int i = 0; i < static_cast<int>(stroke.Samples.size()); ++i)
  {
    places.push_back(Blend::point(i));
  }
  closed = stroke.Closed || comesBack(stroke.Samples, closingDistance);
  while (closed && places.size() > 1 && places.back().of(stroke.Samples) == stroke.Samples.front())
  {
    places.pop_back();
  }
  closed = closed && places.size() > 2;
  return places;
}

} // namespace

vtkStandardNewMacro(vtkOversketchChaikin);

void vtkOversketchChaikin::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  const Context context = ContextOf(this);
  vtkNew<vtkPolyData> now;
  now->ShallowCopy(input);
  for (int pass = 0; pass <= this->Iterations; ++pass)
  {
    const std::vector<DrawnLine> strokes = ReadStrokes(now);
    std::vector<std::vector<Blend>> places;
    std::vector<char> closed(strokes.size());
    for (std::size_t i = 0; i < strokes.size(); ++i)
    {
      closed[i] = strokes[i].Closed;
      places.push_back(pass == 0
                         ? ringPlaces(strokes[i], closingDistance, closed[i])
                         : chaikinPass(static_cast<int>(strokes[i].Samples.size()), strokes[i].Closed));
    }
    vtkNew<vtkPolyData> next;
    WriteStrokes(now, strokes, places, closed, next);
    now->ShallowCopy(next);
    context.checkpoint((pass + 1.0) / (this->Iterations + 1.0));
  }
  vtkPolyData::GetData(outputs)->ShallowCopy(now);
}

void vtkOversketchChaikin::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Iterations: " << this->Iterations << "\n";
}
