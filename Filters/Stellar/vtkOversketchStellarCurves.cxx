#include "vtkOversketchStellarCurves.h"

#include "Stellar/refine.h"
#include "vtkOversketchStellarTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <limits>

namespace oversketch
{

namespace
{

// One curve without what its cell says.
FeatureCurve CurveOf(vtkPolyData* curves,
  vtkIdList* ids,
  vtkDataArray* normals,
  vtkDataArray* pressure,
  vtkDataArray* room)
{
  FeatureCurve curve;
  vtkIdType count = ids->GetNumberOfIds();
  curve.closed = count > 2 && ids->GetId(0) == ids->GetId(count - 1);
  count -= curve.closed;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType id = ids->GetId(i);
    if (id < 0 || id >= curves->GetNumberOfPoints())
    {
      throw Error(
        Failure::BadStroke, "A feature curve names point %1, which is not there; draw the stroke again.", id);
    }
    Vector3 x;
    curves->GetPoint(id, x.data());
    curve.points.push_back(x);
    if (normals)
    {
      normals->GetTuple(id, x.data());
      curve.normals.push_back(x);
    }
    if (pressure)
    {
      curve.pressure.push_back(pressure->GetComponent(id, 0));
    }
    if (room)
    {
      const auto length = [&](int side)
      {
        const double value = room->GetComponent(id, side);
        return value >= 0.0 ? value : std::numeric_limits<double>::infinity();
      };
      curve.room.push_back({ length(0), length(1) });
    }
  }
  curve.measure();
  return curve;
}

} // namespace

FeatureCurves CurvesOf(vtkPolyData* curves, double height)
{
  if (curves->GetNumberOfCells() != curves->GetNumberOfLines() || curves->GetNumberOfLines() == 0)
  {
    throw Error(Failure::BadStroke,
      "The curves are to be polylines and nothing else; take them from vtkOversketchSurfaceStroke.");
  }
  const vtkIdType cells = curves->GetNumberOfCells();
  const auto ofCells = [&](const char* name)
  { return OptionalArray(curves->GetCellData(), name, 1, cells, "curves", "one number a curve"); };
  const auto ofPoints = [&](const char* name, int components)
  {
    return OptionalArray(curves->GetPointData(),
      name,
      components,
      curves->GetNumberOfPoints(),
      "curves",
      "project the stroke again");
  };
  vtkDataArray *normals = ofPoints("Normals", 3), *pressure = ofPoints("Pressure", 1),
               *room = ofPoints("Room", 2);
  vtkDataArray *ids = ofCells("CurveId"), *strokes = ofCells("StrokeId"), *radii = ofCells("Radius"),
               *heights = ofCells("Height"), *sharpnesses = ofCells("Sharpness");
  FeatureCurves result;
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < cells; ++i)
  {
    if (ids && ids->GetComponent(i, 0) != static_cast<double>(i))
    {
      throw Error(Failure::BadStroke,
        "CurveId of curve %1 is another number; a filter reordered the curves. Take them from "
        "vtkOversketchSurfaceStroke.",
        i);
    }
    curves->GetLines()->GetCellAtId(i, points);
    FeatureCurve curve = CurveOf(curves, points, normals, pressure, room);
    const auto value = [i](vtkDataArray* array)
    { return array ? std::optional<double>(array->GetComponent(i, 0)) : std::nullopt; };
    curve.stroke = strokes ? static_cast<int>(strokes->GetComponent(i, 0)) : static_cast<int>(i);
    curve.radius = value(radii);
    curve.height = value(heights);
    curve.sharpness = value(sharpnesses);
    if (height == 0.0 && curve.radius && !curve.height)
    {
      curve.height = 0.5 * *curve.radius;
    }
    result.push_back(std::move(curve));
  }
  checkCurves(result);
  return result;
}

void RequireSameCurves(vtkPolyData* mesh, const Forest& forest, const FeatureCurves& curves)
{
  const auto known = WholeNumber(mesh->GetFieldData(), "CurveDigest");
  if (!known && HasSnapped(forest))
  {
    throw Error(Failure::MissingArray,
      "The mesh has no field array CurveDigest, which says what curves its CurveId means; keep field data "
      "with the mesh.");
  }
  if (known && *known != digest(curves))
  {
    throw Error(Failure::BadStroke,
      "The mesh is snapped to other curves than these (field array CurveDigest); give those, or end that "
      "stroke with vtkOversketchStellarDisplace.");
  }
  checkSnapped(forest, curves);
}

} // namespace oversketch
