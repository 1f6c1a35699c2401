#include "vtkOversketchProjectCurve.h"

#include "Ray/curve_projection.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchProjectCurve);

namespace
{

double lengthOf(const SurfaceCurve& run)
{
  double length = 0.0;
  for (std::size_t i = 1; i < run.samples.size(); ++i)
  {
    length += (run.samples[i].position - run.samples[i - 1].position).norm();
  }
  return length;
}

// The parameter of a curve at a place along its points, which of a closed one may run on beyond the last.
double parameterAt(const DrawnLine& line, vtkDataArray* parameters, double along)
{
  const std::size_t count = line.Ids.size();
  const auto at = [&](std::size_t i)
  {
    const std::size_t turns = i / count;
    return static_cast<double>(turns) + (parameters ? parameters->GetComponent(line.Ids[i % count], 0)
                                                    : static_cast<double>(i % count) /
                                                        static_cast<double>(line.Closed ? count : count - 1));
  };
  const std::size_t before = static_cast<std::size_t>(along);
  const double t = along - static_cast<double>(before);
  return t > 0.0 ? (1.0 - t) * at(before) + t * at(before + 1) : at(before);
}

void writeParameters(const std::vector<StrokeCurve>& curves,
  const std::vector<DrawnLine>& lines,
  vtkDataArray* parameters,
  vtkPolyData* output)
{
  const auto along = NewArray<vtkDoubleArray>("CurveT");
  const auto closed = NewArray<vtkIntArray>("Closed");
  for (const StrokeCurve& curve : curves)
  {
    const DrawnLine& line = lines[static_cast<std::size_t>(curve.Stroke)];
    for (const SurfaceSample& sample : curve.Curve.samples)
    {
      along->InsertNextValue(parameterAt(line, parameters, sample.along));
    }
    closed->InsertNextValue(line.Closed);
  }
  output->GetPointData()->AddArray(along);
  output->GetCellData()->AddArray(closed);
}

} // namespace

vtkIdType vtkOversketchProjectCurve::GetSceneCount()
{
  return this->Kept<KeptSurface>().Builds();
}

void vtkOversketchProjectCurve::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* strokes = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[1]);
  if (mesh->GetNumberOfPoints() == 0)
  {
    return;
  }
  RequirePolygonsOnly(mesh); // the key does not see other cells
  RequireFinite(this->Spacing, "Spacing");
  vtkDataArray* parameters = OptionalArray(strokes->GetPointData(),
    "CurveT",
    1,
    strokes->GetNumberOfPoints(),
    "curves",
    "take them from vtkOversketchNurbsFit, or remove it");
  this->Kept<KeptOutput>().Provide(
    StepKey({ WholeKey(strokes), MeshKey(mesh, { mesh->GetPointData()->GetNormals() }) }, { this->Spacing }),
    vtkPolyData::GetData(outputs),
    [&](vtkPolyData* result)
    {
      ++this->ProjectionCount;
      const std::vector<DrawnLine> lines = ReadStrokes(strokes);
      RefuseEndless(lines);
      const SurfaceRays& surface = this->Kept<KeptSurface>().Provide(mesh, ContextOf(this, 0.0, 0.5));
      CurveRules rules;
      rules.spacing = this->Spacing;
      const std::vector<StrokeCurve> curves = ProjectStrokes(this,
        strokes,
        lines,
        "nothing of it lies on the mesh; draw it over the model.",
        [&](const View& view, const DrawnLine& line, int stroke, const Context& context)
        {
          std::vector<SurfaceCurve> runs =
            projectCurve(surface, view, line.Samples, line.Closed, rules, context);
          if (!line.Closed && runs.size() > 1)
          {
            Warn(this,
              { "{Stroke %1} lies on the mesh in %2 parts; the longest one is taken.", stroke, runs.size() });
            runs = { *std::max_element(runs.begin(),
              runs.end(),
              [](const SurfaceCurve& a, const SurfaceCurve& b) { return lengthOf(a) < lengthOf(b); }) };
          }
          return runs;
        });
      WriteSurfaceCurves(curves, this->Kept<KeptSurface>(), strokes, lines, result);
      writeParameters(curves, lines, parameters, result);
      result->GetFieldData()->PassData(strokes->GetFieldData());
    });
}

void vtkOversketchProjectCurve::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "ProjectionCount: " << this->ProjectionCount << "\n";
  os << indent << "SceneCount: " << this->GetSceneCount() << "\n";
}
