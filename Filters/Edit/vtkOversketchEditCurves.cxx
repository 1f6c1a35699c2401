#include "vtkOversketchEditCurves.h"

#include "Ray/surface_rays.h"
#include "Stroke/canvas.h"
#include "Stroke/polyline.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"
#include "vtkOversketchStrokeView.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <memory>
#include <vector>

namespace oversketch
{

namespace
{

// Steps of a drawn profile; a section has some tens of points.
constexpr int profileSteps = 400;

} // namespace

void RequireOneCurve(vtkPolyData* curve, const std::string& holder)
{
  if (curve->GetNumberOfPoints() == 0 || curve->GetNumberOfCells() == 0)
  {
    throw Error(Failure::BadStroke, "There is no " + holder + " curve; draw one over the mesh.");
  }
  if (curve->GetNumberOfLines() != 1 || curve->GetNumberOfCells() != 1)
  {
    throw Error(Failure::BadStroke,
      "The " + holder + " input holds " + std::to_string(curve->GetNumberOfLines()) + " polylines and " +
        std::to_string(curve->GetNumberOfCells() - curve->GetNumberOfLines()) +
        " other cells; give the one polyline that is to count.");
  }
}

bool IsCurveOfEdit(vtkPolyData* curve)
{
  return curve->GetPointData()->HasArray("VertexId") != 0;
}

void LayOnMesh(vtkPolyData* curve, vtkPolyData* mesh, bool closed, const Context& context, vtkPolyData* laid)
{
  const auto data = SharedMesh(mesh);
  const SurfaceRays surface(data->KeptSurface(), context);
  const vtkIdType count = curve->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> triangles;
  triangles->SetName("MeshCell");
  std::vector<Binding> bindings;
  for (vtkIdType i = 0; i < count; ++i)
  {
    Vector3 place;
    curve->GetPoint(i, place.data());
    const SurfaceHit hit = surface.closest(place);
    if (!hit.found())
    {
      throw Error(Failure::BadStroke,
        "Point " + std::to_string(i) + " of a curve of an earlier edit is not finite; draw the curve anew.");
    }
    points->InsertNextPoint(hit.position.data());
    triangles->InsertNextValue(hit.at.triangle);
    bindings.push_back({ data->Surface().triangles[hit.at.triangle], hit.at.weights });
  }
  laid->Initialize();
  laid->SetPoints(points);
  laid->SetLines(curve->GetLines());
  laid->GetPointData()->PassData(curve->GetPointData());
  laid->GetPointData()->RemoveArray("VertexId");
  laid->GetPointData()->AddArray(triangles);
  WriteBindings(bindings, laid);
  laid->GetCellData()->PassData(curve->GetCellData());
  const std::pair<const char*, int> values[] = { { "StrokeId", 0 }, { "Closed", closed ? 1 : 0 } };
  for (const auto& [name, value] : values)
  {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    laid->GetCellData()->AddArray(array);
  }
  laid->GetFieldData()->PassData(curve->GetFieldData());
}

void LayInPlane(vtkPolyData* profile, vtkPolyData* drawn)
{
  RequireOneCurve(profile, "profile");
  Polyline samples = StrokeOf(profile);
  if (!ViewArraysOf(profile).empty())
  {
    const View view = ViewOf(profile);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const auto place = ontoCanvas(view, samples[i]);
      if (!place)
      {
        throw Error(Failure::BadStroke,
          "Sample " + std::to_string(i) +
            " of the profile does not meet the section's plane in the view that it was drawn in; draw the "
            "profile again.");
      }
      samples[i] = *place;
    }
  }
  const double length = arcLengths(samples).back();
  if (!(length > 0.0))
  {
    throw Error(Failure::BadStroke, "The profile has no length; draw it from side to side.");
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  const Polyline even = uniformPolyline(samples, length / profileSteps);
  lines->InsertNextCell(static_cast<int>(even.size()));
  for (const Vector2& p : even)
  {
    lines->InsertCellPoint(points->InsertNextPoint(p[0], p[1], 0.0));
  }
  drawn->Initialize();
  drawn->SetPoints(points);
  drawn->SetLines(lines);
}

} // namespace oversketch
