#include "vtkOversketchResample.h"

#include "Raster/apart.h"
#include "Stroke/resample.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchKept.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchResample);

namespace
{

std::vector<Blend> placesOf(const DrawnLine& line, int stroke, double spacing)
{
  if (HasLength(line.Samples))
  {
    try
    {
      std::vector<Blend> places = resampled(line.Samples, spacing, line.Closed);
      if (!line.Closed || places.size() > 2)
      {
        return places;
      }
    }
    catch (const Error& error)
    {
      throw Error(error.failure(), Message::unusable("Stroke", stroke, { "%1.", error.message() }));
    }
  }
  std::vector<Blend> all(line.Samples.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = Blend::point(static_cast<int>(i));
  }
  return all;
}

} // namespace

void vtkOversketchResample::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->Kept<KeptOutput>().Provide(StepKey({ CurvesKey(input) }, {}),
    output,
    [&](vtkPolyData* result)
    {
      ++this->ResamplingCount;
      const Canvas canvas = CanvasOf(input);
      const std::vector<DrawnLine> lines = ReadStrokes(input, 1);
      const Context context = ContextOf(this);
      std::vector<DrawnStroke> strokes;
      std::vector<std::vector<Blend>> places;
      for (const DrawnLine& line : lines)
      {
        places.push_back(placesOf(line, static_cast<int>(places.size()), SampleSpacing(canvas)));
        strokes.push_back({ line.Samples, line.Closed });
        context.checkpoint(0.5 * static_cast<double>(places.size()) / static_cast<double>(lines.size()));
      }
      keepApart(frameOf(canvas), strokes, SampleSpacing(canvas), places, context);
      std::vector<CanvasStroke> curves;
      for (std::size_t i = 0; i < lines.size(); ++i)
      {
        CanvasStroke curve{ {}, lines[i].Closed };
        for (const Blend& place : places[i])
        {
          curve.points.push_back(place.of(lines[i].Samples));
        }
        curves.push_back(std::move(curve));
      }
      WriteCurves(curves, canvas, result);
      CarryPointArrays(input, lines, places, result);
    });
  PassDrawingArrays(input, output);
}

void vtkOversketchResample::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ResamplingCount: " << this->ResamplingCount << "\n";
}
