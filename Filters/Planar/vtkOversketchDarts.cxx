#include "vtkOversketchDarts.h"

#include "vtkOversketchFilterTools.h"

#include "Planar/darts.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPlanarTools.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchDarts);

vtkOversketchDarts::vtkOversketchDarts()
{
  this->SetNumberOfInputPorts(2);
  DeclareInput(this, 1, { Port::Image, Port::Optional });
}

void vtkOversketchDarts::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* polylines = vtkPolyData::GetData(inputs[0]);
  vtkImageData* distance = vtkImageData::GetData(inputs[1]);
  if (this->AsPublished || this->DartMode == OFF)
  {
    return;
  }
  if (!distance || distance->GetNumberOfPoints() == 0)
  {
    throw Error(Failure::MissingArray,
      "There is no distance image to throw darts in: connect that of vtkOversketchDistance, or choose "
      "{DartMode Off}.");
  }
  this->Kept<KeptOutput>().Provide(
    StepKey({ PlanarKey(polylines), ImageKey(distance) },
      { static_cast<double>(this->DartMode), static_cast<double>(this->Seed) }),
    vtkPolyData::GetData(outputs),
    [&](vtkPolyData* result)
    {
      ++this->DartsCount;
      const Context context = ContextOf(this);
      const oversketch::DartMode mode =
        this->DartMode == LOCAL ? oversketch::DartMode::Local : oversketch::DartMode::Published;
      const std::vector<Vector2> darts = throwDarts(this->Kept<KeptMaps>().Of(distance),
        StrokeLinesOf(polylines),
        mode,
        static_cast<unsigned int>(this->Seed),
        context);
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      vtkNew<vtkCellArray> vertices;
      for (const Vector2& dart : darts)
      {
        const vtkIdType id = points->InsertNextPoint(dart[0], dart[1], 0.0);
        vertices->InsertNextCell(1, &id);
      }
      result->SetPoints(points);
      result->SetVerts(vertices);
    });
}

void vtkOversketchDarts::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DartMode: " << this->DartMode << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "DartsCount: " << this->DartsCount << "\n";
}
