#include "vtkOversketchCanvas.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cmath>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchCanvas);

namespace
{

constexpr double upright = 1e-9; // how far from the axes a viewport's sides may turn

[[noreturn]] void noCanvas(const Message& why)
{
  throw Error(Failure::BadStroke, "There is no canvas: %1; give the picture, or a field array Canvas.", why);
}

// The rectangle that the one view of all strokes shows.
Canvas canvasOfView(vtkPolyData* strokes)
{
  const View first = ViewOfStroke(strokes, 0);
  for (int i = 1; i < static_cast<int>(strokes->GetNumberOfCells()); ++i)
  {
    const View other = ViewOfStroke(strokes, i);
    if (other.viewTransform() != first.viewTransform() ||
        other.projectionTransform() != first.projectionTransform() || other.width() != first.width() ||
        other.height() != first.height())
    {
      noCanvas({ "strokes 0 and %1 carry different views", i });
    }
  }
  const auto corner = ontoCanvas(first, Vector2(0.0, 0.0));
  const auto right = ontoCanvas(first, Vector2(first.width(), 0.0));
  const auto above = ontoCanvas(first, Vector2(0.0, first.height()));
  if (first.perspective() || first.normal()[2] < 1.0 - upright || !corner || !right || !above)
  {
    noCanvas("the strokes' view is in perspective or does not face the plane z = 0");
  }
  const Vector2 x = *right - *corner, y = *above - *corner;
  if (!(x[0] > 0.0) || !(y[1] > 0.0) || std::abs(x[1]) > upright * x[0] || std::abs(y[0]) > upright * y[1])
  {
    noCanvas("the strokes' view is not upright");
  }
  return { *corner, Vector2(x[0], y[1]) };
}

Canvas canvasOf(vtkPolyData* strokes, vtkImageData* picture)
{
  if (picture)
  {
    return PlaceOf(picture).Rectangle;
  }
  return strokes->GetFieldData()->HasArray("Canvas") ? CanvasOf(strokes) : canvasOfView(strokes);
}

} // namespace

vtkOversketchCanvas::vtkOversketchCanvas()
{
  this->SetNumberOfInputPorts(2);
  DeclareInput(this, 1, { Port::Image, Port::Optional });
}

void vtkOversketchCanvas::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* strokes = vtkPolyData::GetData(inputs[0]);
  const std::vector<DrawnLine> lines = ReadStrokes(strokes, 1);
  const Canvas canvas = canvasOf(strokes, vtkImageData::GetData(inputs[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->Kept<KeptOutput>().Provide(
    StepKey({ CurvesKey(strokes, { "ViewTransform", "ProjectionTransform", "ViewportSize", "Closed" }) },
      { canvas.corner[0], canvas.corner[1], canvas.size[0], canvas.size[1] }),
    output,
    [&](vtkPolyData* result)
    {
      ++this->ProjectionCount;
      const Context context = ContextOf(this);
      std::vector<CanvasStroke> curves;
      std::vector<std::vector<Blend>> places;
      for (int i = 0; i < static_cast<int>(lines.size()); ++i)
      {
        StrokeOnCanvas stroke = OntoCanvas(strokes, lines, i, canvas, "Stroke");
        curves.push_back(std::move(stroke.Curve));
        places.push_back(std::move(stroke.Places));
        context.checkpoint((i + 1.0) / static_cast<double>(lines.size()));
      }
      WriteCurves(curves, canvas, result);
      CarryPointArrays(strokes, lines, places, result);
    });
  PassDrawingArrays(strokes, output);
}

void vtkOversketchCanvas::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProjectionCount: " << this->ProjectionCount << "\n";
}
