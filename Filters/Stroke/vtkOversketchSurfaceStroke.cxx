#include "vtkOversketchSurfaceStroke.h"

#include "vtkOversketchKept.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkAlgorithmOutput.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchSurfaceStroke);

void vtkOversketchSurfaceStroke::Prepare()
{
  if (this->GetNumberOfInputConnections(1) == 0)
  {
    return;
  }
  vtkAlgorithmOutput* source = this->GetInputConnection(1, 0);
  source->GetProducer()->Update(source->GetIndex());
  auto* mesh = vtkPolyData::SafeDownCast(this->GetInputDataObject(1, 0));
  if (mesh && mesh->GetNumberOfPoints() > 0)
  {
    RunFilter(this,
      [&]
      {
        RequirePolygonsOnly(mesh);
        this->Kept<KeptSurface>().Provide(mesh, ContextOf(this));
      });
  }
}

vtkIdType vtkOversketchSurfaceStroke::GetSceneCount()
{
  return this->Kept<KeptSurface>().Builds();
}

void vtkOversketchSurfaceStroke::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* strokes = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[1]);
  if (mesh->GetNumberOfPoints() == 0)
  {
    return;
  }
  RequirePolygonsOnly(mesh); // the key does not see other cells
  if (!std::isfinite(this->Tolerance))
  {
    throw Error(Failure::BadStroke, "{Tolerance} is not finite; set a length, 0 or -1.");
  }
  this->Kept<KeptOutput>().Provide(
    StepKey(
      { StrokesKey(strokes), MeshKey(mesh, { mesh->GetPointData()->GetNormals() }) }, { this->Tolerance }),
    vtkPolyData::GetData(outputs),
    [&](vtkPolyData* result)
    {
      ++this->ProjectionCount;
      const std::vector<DrawnLine> lines = ReadStrokes(strokes);
      RefuseEndless(lines);
      const SurfaceRays& surface = this->Kept<KeptSurface>().Provide(mesh, ContextOf(this, 0.0, 0.5));
      const double tolerance = this->Tolerance < 0.0 ? 6e-4 * surface.diagonal() : this->Tolerance;
      const std::vector<StrokeCurve> curves = ProjectStrokes(this,
        strokes,
        lines,
        "no two samples in succession lie on the mesh; draw it over the model.",
        [&](const View& view, const DrawnLine& line, int, const Context& context)
        { return projectStroke(surface, view, line.Samples, line.Closed, tolerance, context); });
      WriteSurfaceCurves(curves, this->Kept<KeptSurface>(), strokes, lines, result);
    });
}

void vtkOversketchSurfaceStroke::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "ProjectionCount: " << this->ProjectionCount << "\n";
  os << indent << "SceneCount: " << this->GetSceneCount() << "\n";
}
