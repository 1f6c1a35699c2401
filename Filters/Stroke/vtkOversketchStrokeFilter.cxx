#include "vtkOversketchStrokeFilter.h"

#include "Stroke/stroke.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <limits>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchStrokeFilter);

int vtkOversketchStrokeFilter::RequestData(vtkInformation*,
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
      const vtkIdType strokes = input->GetNumberOfLines();
      if (strokes == 0 || strokes != input->GetNumberOfCells())
      {
        throw Error(Failure::BadStroke,
          "The stroke input must hold polylines and no other cells: a stroke is one polyline.");
      }
      StrokeRules rules;
      rules.minimumSpacing = this->MinimumSpacing;
      rules.spacing = this->Spacing;
      rules.minimumLength = this->MinimumLength;
      rules.refuseClosed = this->RefuseClosed;
      rules.maximumLength = this->MaximumLength;
      vtkDataArray* viewports = input->GetCellData()->GetArray("ViewportSize");
      const bool sized = viewports && viewports->GetNumberOfComponents() == 2 &&
                         viewports->GetNumberOfTuples() == input->GetNumberOfCells();
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      vtkNew<vtkCellArray> lines;
      vtkPointData* from = input->GetPointData();
      vtkPointData* to = output->GetPointData();
      to->InterpolateAllocate(from);
      vtkNew<vtkIdList> ids;
      for (vtkIdType stroke = 0; stroke < strokes; ++stroke)
      {
        input->GetLines()->GetCellAtId(stroke, ids);
        Polyline samples;
        for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
        {
          // An id out of range makes a sample that is not finite, and is refused as such.
          Vector3 p = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
          if (ids->GetId(i) >= 0 && ids->GetId(i) < input->GetNumberOfPoints())
          {
            input->GetPoint(ids->GetId(i), p.data());
          }
          samples.push_back(p.head<2>());
        }
        if (sized)
        {
          viewports->GetTuple(stroke, rules.viewport.data());
        }
        std::vector<Blend> places;
        try
        {
          places = cleanStroke(samples, rules);
        }
        catch (const Error& error)
        {
          throw Error(error.failure(), Message::unusable("Stroke", stroke, error.message()));
        }
        lines->InsertNextCell(static_cast<int>(places.size()));
        for (const Blend& place : places)
        {
          const Vector2 p = place.of(samples);
          const vtkIdType id = points->InsertNextPoint(p[0], p[1], 0.0);
          lines->InsertCellPoint(id);
          to->InterpolateEdge(from, id, ids->GetId(place.from), ids->GetId(place.to), place.t);
        }
      }
      output->SetPoints(points);
      output->SetLines(lines);
      output->GetCellData()->PassData(input->GetCellData());
      output->GetFieldData()->PassData(input->GetFieldData());
    });
}

void vtkOversketchStrokeFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MinimumSpacing: " << this->MinimumSpacing << '\n';
  os << indent << "Spacing: " << this->Spacing << '\n';
  os << indent << "MinimumLength: " << this->MinimumLength << '\n';
  os << indent << "RefuseClosed: " << (this->RefuseClosed ? "on" : "off") << '\n';
  os << indent << "MaximumLength: " << this->MaximumLength << '\n';
}
