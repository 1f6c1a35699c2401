#include "vtkOversketchPolyline.h"

#include "vtkOversketchFilterTools.h"

#include "Planar/approximate.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPlanarTools.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchPolyline);

vtkOversketchPolyline::vtkOversketchPolyline()
{
  this->SetNumberOfInputPorts(3);
  DeclareInput(this, 1, { Port::Image, Port::Optional });
  DeclareInput(this, 2, { Port::Optional });
}

void vtkOversketchPolyline::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* curves = vtkPolyData::GetData(inputs[0]);
  vtkImageData* distance = vtkImageData::GetData(inputs[1]);
  vtkPolyData* splits = vtkPolyData::GetData(inputs[2]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const bool fixed = this->AsPublished || this->DeltaMode == FIXED;
  if (!fixed && !(distance && distance->GetNumberOfPoints() > 0))
  {
    throw Error(Failure::MissingArray,
      "There is no distance image, which {DeltaMode Adaptive} reads: connect that of "
      "vtkOversketchDistance, "
      "or choose Fixed.");
  }
  std::vector<MeshKey> read{ DrawingKey(curves) };
  if (!fixed)
  {
    read.push_back(ImageKey(distance));
  }
  if (splits)
  {
    read.push_back(PlanarKey(splits));
  }
  this->Kept<KeptOutput>().Provide(
    StepKey(read, { static_cast<double>(fixed), this->Tolerance, this->JoinDistance }),
    output,
    [&](vtkPolyData* result)
    {
      ++this->PolylineCount;
      const Drawing drawing = DrawingOf(curves);
      const std::vector<StrokeClass> classes = ClassificationOf(curves).strokes;
      const std::vector<StrokeSplit> parts = splits ? SplitsOf(splits) : std::vector<StrokeSplit>();
      for (const StrokeSplit& part : parts)
      {
        if (part.stroke < 0 || part.stroke >= static_cast<int>(classes.size()))
        {
          throw Error(Failure::BadStroke,
            "The splits name {stroke %1}, but there are %2; take both of one drawing.",
            part.stroke,
            classes.size());
        }
      }
      ApproximationRules rules;
      rules.mode = fixed ? DeltaMode::Fixed : DeltaMode::Adaptive;
      rules.tolerance = this->Tolerance;
      rules.joinDistance = this->JoinDistance;
      const Context context = ContextOf(this);
      const DistanceMaps none;
      const std::vector<StrokePolyline> polylines = approximate(drawing.Strokes,
        classes,
        drawing.Treatments,
        fixed ? none : this->Kept<KeptMaps>().Of(distance),
        parts,
        drawing.Rectangle.longest(),
        rules,
        context);
      WriteStrokeLines(strokeLines(polylines, drawing.Strokes, classes, drawing.Treatments), result);
    });
  output->GetFieldData()->PassData(curves->GetFieldData());
}

void vtkOversketchPolyline::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DeltaMode: " << this->DeltaMode << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "JoinDistance: " << this->JoinDistance << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "PolylineCount: " << this->PolylineCount << "\n";
}
