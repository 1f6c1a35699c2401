#include "vtkOversketchSilhouetteSketch.h"

#include "vtkOversketchKept.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>

using namespace oversketch;

namespace
{

std::vector<SilhouetteChain> readSilhouette(vtkPolyData* curves)
{
  const vtkIdType count = curves->GetNumberOfLines();
  const char* remedy = "take the output of vtkOversketchSilhouette, or of a filter after it, for this mesh";
  if (count != curves->GetNumberOfCells())
  {
    throw Error(
      Failure::BadMesh, std::string("The silhouette holds cells that are not polylines; ") + remedy + ".");
  }
  std::vector<SilhouetteChain> chains(static_cast<std::size_t>(count));
  if (count == 0)
  {
    return chains;
  }
  vtkDataArray* normals =
    RequireArray(curves->GetPointData(), "Normals", 3, curves->GetNumberOfPoints(), "silhouette", remedy);
  vtkDataArray* visible = OptionalArray(curves->GetCellData(), "Visible", 1, count, "silhouette", remedy);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    SilhouetteChain& chain = chains[static_cast<std::size_t>(cell)];
    curves->GetLines()->GetCellAtId(cell, ids);
    const vtkIdType size = ids->GetNumberOfIds();
    chain.closed = size > 2 && ids->GetId(0) == ids->GetId(size - 1);
    chain.visible = !visible || visible->GetComponent(cell, 0) != 0.0;
    for (vtkIdType i = 0; i < (chain.closed ? size - 1 : size); ++i)
    {
      const vtkIdType id = ids->GetId(i);
      Vector3 point = Vector3::Constant(std::nan("")), normal = point;
      if (id >= 0 && id < curves->GetNumberOfPoints())
      {
        curves->GetPoint(id, point.data());
        normals->GetTuple(id, normal.data());
      }
      if (!point.allFinite() || !normal.allFinite())
      {
        throw Error(Failure::BadMesh,
          "Cell %1 of the silhouette names a point that does not exist, or is not finite; %2.",
          cell,
          remedy);
      }
      chain.points.push_back(point);
      chain.normals.push_back(normal.normalized());
    }
  }
  return chains;
}

// The sketch with the points and cell of the curve.
void writeSketch(const std::vector<Vector3>& sketch, vtkPolyData* curve, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto arcs = NewArray<vtkDoubleArray>("ArcLength");
  double arc = 0.0;
  for (std::size_t k = 0; k < sketch.size(); ++k)
  {
    arc += k > 0 ? (sketch[k] - sketch[k - 1]).norm() : 0.0;
    points->InsertNextPoint(sketch[k].data());
    arcs->InsertNextValue(arc);
  }
  output->SetPoints(points);
  output->SetLines(curve->GetLines());
  output->GetPointData()->AddArray(arcs);
  for (const char* name : { "CurveId", "StrokeId" })
  {
    output->GetCellData()->AddArray(curve->GetCellData()->GetArray(name));
  }
}

} // namespace

vtkStandardNewMacro(vtkOversketchSilhouetteSketch);

vtkOversketchSilhouetteSketch::vtkOversketchSilhouetteSketch()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

vtkIdType vtkOversketchSilhouetteSketch::GetSceneCount()
{
  return this->Kept<KeptSurface>().Builds();
}

void vtkOversketchSilhouetteSketch::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* strokes = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* silhouette = vtkPolyData::GetData(inputs[2]);
  if (mesh->GetNumberOfPoints() == 0)
  {
    return;
  }
  RequirePolygonsOnly(mesh); // the key does not see other cells
  if (!std::isfinite(this->MaximumStep))
  {
    throw Error(Failure::BadStroke, "{MaximumStep} is not finite; set a length, 0 or -1.");
  }
  const StepKey key({ StrokesKey(strokes),
                      MeshKey(mesh, { mesh->GetPointData()->GetNormals() }),
                      MeshKey(silhouette,
                        { silhouette->GetPointData()->GetArray("Normals"),
                          silhouette->GetCellData()->GetArray("Visible") }) },
    { static_cast<double>(this->Projection), this->MaximumStep });
  this->Kept<KeptOutput>().Provide(key,
    { vtkPolyData::GetData(outputs, 0), vtkPolyData::GetData(outputs, 1) },
    [&](const KeptOutput::Outputs& results)
    {
      ++this->ProjectionCount;
      const std::vector<DrawnLine> lines = ReadStrokes(strokes);
      if (lines.size() != 1)
      {
        throw Error(Failure::BadStroke,
          "The stroke input holds %1 polylines; a new silhouette is exactly one stroke.",
          lines.size());
      }
      RefuseEndless(lines);
      const SurfaceRays& surface = this->Kept<KeptSurface>().Provide(mesh, ContextOf(this, 0.0, 0.5));
      SketchRules rules;
      rules.projection = static_cast<SketchProjection>(this->Projection);
      rules.maximumStep = this->MaximumStep < 0.0 ? 0.03 * surface.diagonal() : this->MaximumStep;
      const SilhouetteSketch sketch = sketchSilhouette(surface,
        ViewOfStroke(strokes, 0),
        lines[0].Samples,
        readSilhouette(silhouette),
        rules,
        ContextOf(this, 0.5, 1.0));
      WriteSurfaceCurves({ { sketch.curve, 0 } }, this->Kept<KeptSurface>(), strokes, lines, results[0]);
      results[0]->GetFieldData()->AddArray(OneValue<vtkDoubleArray>("Hidden", sketch.hidden));
      writeSketch(sketch.sketch, results[0], results[1]);
    });
}

void vtkOversketchSilhouetteSketch::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Projection: " << this->Projection << "\n";
  os << indent << "MaximumStep: " << this->MaximumStep << "\n";
  os << indent << "ProjectionCount: " << this->ProjectionCount << "\n";
  os << indent << "SceneCount: " << this->GetSceneCount() << "\n";
}
