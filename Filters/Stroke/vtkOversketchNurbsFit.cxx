#include "vtkOversketchNurbsFit.h"

#include "vtkOversketchFilterTools.h"

#include "Stroke/fit.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchNurbsFit);

namespace
{

// Where the samples' lines of sight meet the surface. One that misses it is as far away as the nearest one
// along the stroke that does not.
SpaceSamples onSurface(const SurfaceRays& surface, const View& view, const Polyline& samples)
{
  std::vector<double> depths;
  std::vector<int> met;
  SpaceSamples space{ view, std::vector<Vector3>(samples.size()) };
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const SurfaceHit hit = surface.nearest(lineOfSight(view, samples[i], surface));
    if (hit.found())
    {
      met.push_back(static_cast<int>(i));
      depths.push_back(view.depth(hit.position));
      space.points[i] = hit.position;
    }
  }
  if (met.empty())
  {
    throw Error(Failure::BadStroke, "nothing of it lies on the mesh; draw it over the model.");
  }
  std::size_t k = 0;
  for (int i = 0; i < static_cast<int>(samples.size()); ++i)
  {
    while (k + 1 < met.size() && std::abs(met[k + 1] - i) < std::abs(met[k] - i))
    {
      ++k;
    }
    if (met[k] != i)
    {
      space.points[i] = view.toWorld(samples[i], depths[k]);
    }
  }
  return space;
}

FittedStroke fittedLine(const DrawnLine& line,
  bool closed,
  std::size_t number,
  const FitRules& rules,
  const SurfaceRays* surface,
  vtkPolyData* strokes)
{
  try
  {
    if (!surface)
    {
      return fitStroke(line.Samples, closed, rules);
    }
    const SpaceSamples space =
      onSurface(*surface, ViewOfStroke(strokes, static_cast<vtkIdType>(number)), line.Samples);
    return fitStroke(line.Samples, closed, rules, &space);
  }
  catch (const Error& error)
  {
    throw Error(error.failure(), Message::unusable("Stroke", number, error.message()));
  }
}

// The splines themselves, curve after curve.
class SplineArrays
{
public:
  explicit SplineArrays(bool inSpace)
  {
    this->Degrees->SetName("NurbsDegree");
    this->Counts->SetName("NurbsPointCount");
    this->Controls->SetName("NurbsPoints");
    this->Controls->SetNumberOfComponents(inSpace ? 3 : 2);
    this->Knots->SetName("NurbsKnots");
  }

  void Insert(const FittedStroke& fitted)
  {
    this->Degrees->InsertNextValue(fitted.degree);
    this->Counts->InsertNextValue(static_cast<int>(fitted.order.size()));
    for (const int control : fitted.order)
    {
      this->Controls->InsertNextTuple(fitted.spaceControls.empty() ? fitted.controls[control].data()
                                                                   : fitted.spaceControls[control].data());
    }
    for (const double knot : fitted.knots)
    {
      this->Knots->InsertNextValue(knot);
    }
  }

  void Write(vtkPolyData* output) const
  {
    for (vtkDataArray* array :
      std::initializer_list<vtkDataArray*>{ this->Degrees, this->Counts, this->Controls, this->Knots })
    {
      output->GetFieldData()->AddArray(array);
    }
  }

private:
  vtkNew<vtkIntArray> Degrees, Counts;
  vtkNew<vtkDoubleArray> Controls, Knots;
};

} // namespace

vtkOversketchNurbsFit::vtkOversketchNurbsFit()
{
  this->SetNumberOfInputPorts(2);
  DeclareInput(this, 1, { Port::Optional });
}

void vtkOversketchNurbsFit::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  RequireFinite(this->Spacing, "Spacing");
  const std::vector<DrawnLine> strokes = ReadStrokes(input);
  FitRules rules;
  rules.spacing = this->Spacing;
  rules.interpolate = this->Interpolate;
  rules.periodic = this->Periodic;
  rules.cutLoops = this->CutLoops;
  const SurfaceRays* surface = nullptr;
  if (this->FitSpace == World)
  {
    if (!mesh || mesh->GetNumberOfPoints() == 0)
    {
      throw Error(Failure::BadMesh,
        "There is no mesh to fit splines in space on; give it on port 1, or set {FitSpace Picture}.");
    }
    RequirePolygonsOnly(mesh);
    surface = &this->Kept<KeptSurface>().Provide(mesh, ContextOf(this, 0.0, 0.5));
  }
  const Context context = ContextOf(this, surface ? 0.5 : 0.0, 1.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  const auto parameters = NewArray<vtkDoubleArray>("CurveT");
  SplineArrays splines(surface != nullptr);
  vtkPointData* from = input->GetPointData();
  vtkPointData* to = output->GetPointData();
  to->InterpolateAllocate(from);
  vtkNew<vtkIdList> ids;
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    const FittedStroke fitted =
      fittedLine(strokes[i], this->Closed || strokes[i].Closed, i, rules, surface, input);
    lines->InsertNextCell(static_cast<int>(fitted.places.size()) + fitted.closed);
    const vtkIdType first = points->GetNumberOfPoints();
    for (std::size_t k = 0; k < fitted.places.size(); ++k)
    {
      SplinePlace place = fitted.places[k];
      const vtkIdType id = points->InsertNextPoint(fitted.seen[k][0], fitted.seen[k][1], 0.0);
      lines->InsertCellPoint(id);
      parameters->InsertNextValue(fitted.parameters[k]);
      ids->SetNumberOfIds(place.count);
      for (int c = 0; c < place.count; ++c)
      {
        ids->SetId(c, strokes[i].Ids[fitted.kept[place.points[c]]]);
      }
      to->InterpolatePoint(from, id, ids, place.weights.data());
    }
    if (fitted.closed)
    {
      lines->InsertCellPoint(first);
    }
    splines.Insert(fitted);
    context.checkpoint(static_cast<double>(i + 1) / static_cast<double>(strokes.size()));
  }
  output->SetPoints(points);
  output->SetLines(lines);
  to->AddArray(parameters);
  output->GetCellData()->PassData(input->GetCellData());
  output->GetFieldData()->PassData(input->GetFieldData());
  splines.Write(output);
}

void vtkOversketchNurbsFit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FitSpace: " << this->FitSpace << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Closed: " << (this->Closed ? "On" : "Off") << "\n";
  os << indent << "Interpolate: " << (this->Interpolate ? "On" : "Off") << "\n";
  os << indent << "Periodic: " << (this->Periodic ? "On" : "Off") << "\n";
  os << indent << "CutLoops: " << (this->CutLoops ? "On" : "Off") << "\n";
}
