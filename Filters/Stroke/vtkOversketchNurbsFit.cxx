#include "vtkOversketchNurbsFit.h"

#include "Stroke/fit.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <string>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchNurbsFit);

namespace
{

FittedStroke fittedLine(const DrawnLine& line, bool closed, std::size_t number, const FitRules& rules)
{
  try
  {
    return fitStroke(line.Samples, closed, rules);
  }
  catch (const Error& error)
  {
    throw Error(error.failure(), "Stroke " + std::to_string(number) + " cannot be used: " + error.what());
  }
}

// The splines themselves, curve after curve.
class SplineArrays
{
public:
  SplineArrays()
  {
    this->Degrees->SetName("NurbsDegree");
    this->Counts->SetName("NurbsPointCount");
    this->Controls->SetName("NurbsPoints");
    this->Controls->SetNumberOfComponents(2);
    this->Knots->SetName("NurbsKnots");
  }

  void Insert(const FittedStroke& fitted)
  {
    this->Degrees->InsertNextValue(fitted.degree);
    this->Counts->InsertNextValue(static_cast<int>(fitted.order.size()));
    for (const int control : fitted.order)
    {
      this->Controls->InsertNextTuple(fitted.controls[control].data());
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

int vtkOversketchNurbsFit::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      if (input->GetNumberOfPoints() == 0)
      {
        return;
      }
      RequireFinite(this->Spacing, "Spacing");
      const std::vector<DrawnLine> strokes = ReadStrokes(input);
      FitRules rules;
      rules.spacing = this->Spacing;
      rules.interpolate = this->Interpolate;
      rules.periodic = this->Periodic;
      rules.cutLoops = this->CutLoops;
      const Context context = ContextOf(this);
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      vtkNew<vtkCellArray> lines;
      vtkNew<vtkDoubleArray> parameters;
      parameters->SetName("CurveT");
      SplineArrays splines;
      vtkPointData* from = input->GetPointData();
      vtkPointData* to = output->GetPointData();
      to->InterpolateAllocate(from);
      vtkNew<vtkIdList> ids;
      for (std::size_t i = 0; i < strokes.size(); ++i)
      {
        const FittedStroke fitted = fittedLine(strokes[i], this->Closed || strokes[i].Closed, i, rules);
        lines->InsertNextCell(static_cast<int>(fitted.places.size()) + fitted.closed);
        const vtkIdType first = points->GetNumberOfPoints();
        for (std::size_t k = 0; k < fitted.places.size(); ++k)
        {
          SplinePlace place = fitted.places[k];
          const Vector2 p = place.of(fitted.controls);
          const vtkIdType id = points->InsertNextPoint(p[0], p[1], 0.0);
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
    });
}

void vtkOversketchNurbsFit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Closed: " << (this->Closed ? "On" : "Off") << "\n";
  os << indent << "Interpolate: " << (this->Interpolate ? "On" : "Off") << "\n";
  os << indent << "Periodic: " << (this->Periodic ? "On" : "Off") << "\n";
  os << indent << "CutLoops: " << (this->CutLoops ? "On" : "Off") << "\n";
}
