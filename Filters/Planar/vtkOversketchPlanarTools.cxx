#include "vtkOversketchPlanarTools.h"
#include "vtkOversketchPolylines.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace oversketch
{
namespace
{

// An array of a mesh, of polylines, ..., read as whole numbers or as they are.
class Values
{
public:
  Values(vtkDataSetAttributes* of, const char* name, vtkIdType count, const char* holder, const char* maker)
    : Array(RequireArray(of, name, 1, count, holder, std::string("take it from ") + maker))
  {
  }
  double at(vtkIdType i) const { return this->Array->GetComponent(i, 0); }
  int whole(vtkIdType i) const
  {
    const double value = this->at(i);
    return std::isfinite(value) ? static_cast<int>(std::clamp(value, -1e9, 1e9)) : -1;
  }

private:
  vtkDataArray* Array;
};

[[noreturn]] void badMesh(const std::string& what, vtkIdType number, const std::string& why)
{
  throw Error(
    Failure::BadMesh, "%1 %2 %3; take the mesh from vtkOversketchCoarseMesh or after.", what, number, why);
}

[[noreturn]] void badLine(vtkIdType cell, const std::string& why)
{
  throw Error(
    Failure::BadStroke, "Polyline %1 %2; take the polylines from vtkOversketchPolyline.", cell, why);
}

void readEdges(vtkPolyData* edges, PlanarMesh& mesh)
{
  const vtkIdType count = edges->GetNumberOfCells();
  const char* const maker = "vtkOversketchCoarseMesh";
  const Values stroke(edges->GetCellData(), "StrokeId", count, "edges", maker);
  const Values start(edges->GetCellData(), "ParamStart", count, "edges", maker);
  const Values end(edges->GetCellData(), "ParamEnd", count, "edges", maker);
  if (edges->GetNumberOfLines() != count)
  {
    throw Error(
      Failure::BadMesh, "The edges have cells that are no lines; take them from vtkOversketchCoarseMesh.");
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < count; ++i)
  {
    edges->GetLines()->GetCellAtId(i, ids);
    const auto inRange = [&](vtkIdType id)
    { return id >= 0 && id < static_cast<vtkIdType>(mesh.points.size()); };
    if (ids->GetNumberOfIds() != 2 || !inRange(ids->GetId(0)) || !inRange(ids->GetId(1)))
    {
      badMesh("Edge", i, "is not between two points of the mesh");
    }
    if (!std::isfinite(start.at(i)) || !std::isfinite(end.at(i)))
    {
      badMesh("Edge", i, "has no finite ParamStart and ParamEnd");
    }
    mesh.edges.push_back({ static_cast<int>(ids->GetId(0)),
      static_cast<int>(ids->GetId(1)),
      stroke.whole(i),
      start.at(i),
      end.at(i) });
  }
}

} // namespace

PlanarMesh PlanarMeshOf(vtkPolyData* faces, vtkPolyData* edges)
{
  RequirePolygonsOnly(faces);
  PlanarMesh mesh;
  const vtkIdType points = faces->GetNumberOfPoints(), cells = faces->GetNumberOfPolys();
  const char* const maker = "vtkOversketchCoarseMesh or after";
  const auto ofPoints = [&](const char* name)
  { return Values(faces->GetPointData(), name, points, "mesh", maker); };
  const auto ofCells = [&](const char* name)
  { return Values(faces->GetCellData(), name, cells, "mesh", maker); };
  const Values kind = ofPoints("BoundaryKind"), stroke = ofPoints("StrokeId"),
               param = ofPoints("StrokeParam"), isBase = ofPoints("IsBaseVertex");
  const Values region = ofCells("RegionId"), object = ofCells("ObjectId"), base = ofCells("BaseFaceId");
  for (vtkIdType i = 0; i < points; ++i)
  {
    double place[3];
    faces->GetPoint(i, place);
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(param.at(i)))
    {
      badMesh("Point", i, "is not finite");
    }
    if (kind.whole(i) < 0 || kind.whole(i) > static_cast<int>(BoundaryKind::TunnelRim))
    {
      badMesh("Point", i, "has no BoundaryKind");
    }
    mesh.points.push_back({ Vector2(place[0], place[1]),
      static_cast<BoundaryKind>(kind.whole(i)),
      stroke.whole(i),
      param.at(i),
      isBase.at(i) != 0.0 });
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; f < cells; ++f)
  {
    faces->GetPolys()->GetCellAtId(f, ids);
    const vtkIdType count = ids->GetNumberOfIds();
    if (count != 3 && count != 4)
    {
      badMesh("Face", f, "is neither a triangle nor a quad");
    }
    PlanarFace face;
    for (vtkIdType k = 0; k < count; ++k)
    {
      if (ids->GetId(k) < 0 || ids->GetId(k) >= points)
      {
        badMesh("Face", f, "has a point that there is not");
      }
      face.corners[k] = static_cast<int>(ids->GetId(k));
    }
    face.region = region.whole(f);
    face.object = object.whole(f);
    face.base = base.whole(f);
    mesh.faces.push_back(face);
  }
  if (edges)
  {
    readEdges(edges, mesh);
  }
  return mesh;
}

void WritePlanarMesh(const PlanarMesh& mesh, vtkPolyData* faces)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.points[i].place[0], mesh.points[i].place[1], 0.0);
  }
  vtkNew<vtkCellArray> polys;
  for (const PlanarFace& face : mesh.faces)
  {
    polys->InsertNextCell(face.count());
    for (int k = 0; k < face.count(); ++k)
    {
      polys->InsertCellPoint(face.corners[k]);
    }
  }
  faces->SetPoints(points);
  faces->SetPolys(polys);
  vtkDataSetAttributes *ofPoints = faces->GetPointData(), *ofCells = faces->GetCellData();
  ofPoints->AddArray(ArrayOf<vtkIntArray>("BoundaryKind", mesh.points, &PlanarPoint::kind));
  ofPoints->AddArray(ArrayOf<vtkIntArray>("StrokeId", mesh.points, &PlanarPoint::stroke));
  ofPoints->AddArray(ArrayOf<vtkDoubleArray>("StrokeParam", mesh.points, &PlanarPoint::param));
  ofPoints->AddArray(ArrayOf<vtkUnsignedCharArray>("IsBaseVertex", mesh.points, &PlanarPoint::isBase));
  ofCells->AddArray(ArrayOf<vtkIntArray>("RegionId", mesh.faces, &PlanarFace::region));
  ofCells->AddArray(ArrayOf<vtkIntArray>("ObjectId", mesh.faces, &PlanarFace::object));
  ofCells->AddArray(ArrayOf<vtkIntArray>("BaseFaceId", mesh.faces, &PlanarFace::base));
}

void WriteStrokeEdges(const PlanarMesh& mesh, vtkPolyData* faces, vtkPolyData* edges)
{
  vtkNew<vtkCellArray> lines;
  for (const StrokeEdge& edge : mesh.edges)
  {
    const vtkIdType ids[2] = { edge.from, edge.to };
    lines->InsertNextCell(2, ids);
  }
  edges->SetPoints(faces->GetPoints());
  edges->SetLines(lines);
  vtkDataSetAttributes* data = edges->GetCellData();
  data->AddArray(ArrayOf<vtkIntArray>("StrokeId", mesh.edges, &StrokeEdge::stroke));
  data->AddArray(ArrayOf<vtkDoubleArray>("ParamStart", mesh.edges, &StrokeEdge::start));
  data->AddArray(ArrayOf<vtkDoubleArray>("ParamEnd", mesh.edges, &StrokeEdge::end));
}

MeshKey PlanarKey(vtkPolyData* data)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkDataSetAttributes* of : { static_cast<vtkDataSetAttributes*>(data->GetPointData()),
         static_cast<vtkDataSetAttributes*>(data->GetCellData()) })
  {
    for (int i = 0; i < of->GetNumberOfArrays(); ++i)
    {
      arrays.push_back(of->GetArray(i));
    }
  }
  return MeshKey(data, arrays);
}

std::vector<StrokeLine> StrokeLinesOf(vtkPolyData* polylines)
{
  const vtkIdType count = polylines->GetNumberOfCells();
  const char* const maker = "vtkOversketchPolyline";
  const auto ofCells = [&](const char* name)
  { return Values(polylines->GetCellData(), name, count, "polylines", maker); };
  const Values arc(
    polylines->GetPointData(), "ArcLength", polylines->GetNumberOfPoints(), "polylines", maker);
  const Values stroke = ofCells("StrokeId"), closed = ofCells("Closed"), role = ofCells("Role"),
               region = ofCells("RegionId"), child = ofCells("ChildRegionId"), object = ofCells("ObjectId"),
               treatment = ofCells("Treatment"), length = ofCells("StrokeLength");
  if (polylines->GetNumberOfLines() != count)
  {
    throw Error(
      Failure::BadStroke, "There are cells that are no polylines; take them from vtkOversketchPolyline.");
  }
  std::vector<StrokeLine> lines;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < count; ++i)
  {
    polylines->GetLines()->GetCellAtId(i, ids);
    StrokeLine line;
    line.stroke = stroke.whole(i);
    line.closed = closed.at(i) != 0.0;
    line.length = length.at(i);
    const vtkIdType last = ids->GetNumberOfIds() - (line.closed ? 1 : 0);
    if (last < 2 || (line.closed && ids->GetId(0) != ids->GetId(last)))
    {
      badLine(i, "is too short, or Closed and does not end at its first point");
    }
    if (role.whole(i) < static_cast<int>(Role::Boundary) ||
        role.whole(i) > static_cast<int>(Role::OpenFeature) || treatment.whole(i) < 0 ||
        treatment.whole(i) > static_cast<int>(Treatment::Tunnel))
    {
      badLine(i, "has no Role or Treatment");
    }
    line.role = static_cast<Role>(role.whole(i));
    line.treatment = static_cast<Treatment>(treatment.whole(i));
    line.region = region.whole(i);
    line.childRegion = child.whole(i);
    line.object = object.whole(i);
    for (vtkIdType k = 0; k < last; ++k)
    {
      const vtkIdType id = ids->GetId(k);
      double place[3] = { NAN, NAN, NAN };
      if (id >= 0 && id < polylines->GetNumberOfPoints())
      {
        polylines->GetPoint(id, place);
      }
      if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
      {
        badLine(i, "has a point that is not finite or not there");
      }
      if (!(arc.at(id) > (k == 0 ? -1.0 : line.params.back()) && arc.at(id) <= line.length))
      {
        badLine(i, "has an ArcLength that does not ascend from 0 to its StrokeLength");
      }
      line.places.emplace_back(place[0], place[1]);
      line.params.push_back(arc.at(id));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

void WriteStrokeLines(const std::vector<StrokeLine>& lines, vtkPolyData* polylines)
{
  Polylines written;
  std::vector<double> params;
  for (const StrokeLine& line : lines)
  {
    written.Add(line.places, line.closed);
    params.insert(params.end(), line.params.begin(), line.params.end());
  }
  written.Put(polylines);
  polylines->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("ArcLength", params));
  vtkDataSetAttributes* data = polylines->GetCellData();
  data->AddArray(ArrayOf<vtkIntArray>("StrokeId", lines, &StrokeLine::stroke));
  data->AddArray(ArrayOf<vtkIntArray>("Closed", lines, &StrokeLine::closed));
  data->AddArray(ArrayOf<vtkIntArray>("Role", lines, &StrokeLine::role));
  data->AddArray(ArrayOf<vtkIntArray>("RegionId", lines, &StrokeLine::region));
  data->AddArray(ArrayOf<vtkIntArray>("ChildRegionId", lines, &StrokeLine::childRegion));
  data->AddArray(ArrayOf<vtkIntArray>("ObjectId", lines, &StrokeLine::object));
  data->AddArray(ArrayOf<vtkIntArray>("Treatment", lines, &StrokeLine::treatment));
  data->AddArray(ArrayOf<vtkDoubleArray>("StrokeLength", lines, &StrokeLine::length));
}

std::vector<StrokeSplit> SplitsOf(vtkPolyData* splits)
{
  const vtkIdType count = splits->GetNumberOfCells();
  if (count == 0)
  {
    return {}; // without arrays, too
  }
  const auto ofCells = [&](const char* name)
  { return Values(splits->GetCellData(), name, count, "splits", "vtkOversketchPlanarRefine"); };
  const Values stroke = ofCells("StrokeId"), start = ofCells("ParamStart"), end = ofCells("ParamEnd"),
               halvings = ofCells("Halvings");
  std::vector<StrokeSplit> result;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (!std::isfinite(start.at(i)) || !std::isfinite(end.at(i)) || halvings.whole(i) < 0 ||
        halvings.whole(i) > 64)
    {
      throw Error(Failure::BadStroke,
        "Split %1 has no finite ParamStart and ParamEnd, or Halvings outside 0 to 64; take the splits from "
        "vtkOversketchPlanarRefine.",
        i);
    }
    result.push_back({ stroke.whole(i), start.at(i), end.at(i), halvings.whole(i) });
  }
  return result;
}

void WriteSplits(const std::vector<StrokeSplit>& splits,
  const std::vector<DrawnStroke>& strokes,
  vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const StrokeSplit& split : splits)
  {
    const DrawnStroke& stroke = strokes[split.stroke];
    const std::vector<double> lengths = arcLengths(stroke.points, stroke.closed);
    vtkIdType ids[2];
    for (const int end : { 0, 1 })
    {
      // Past a closed stroke's first sample it begins again.
      double length = end == 0 ? split.start : split.end;
      length = stroke.closed && length > lengths.back() ? length - lengths.back() : length;
      const Vector2 place =
        placeAt(lengths, static_cast<int>(stroke.points.size()), length).of(stroke.points);
      ids[end] = points->InsertNextPoint(place[0], place[1], 0.0);
    }
    lines->InsertNextCell(2, ids);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  vtkDataSetAttributes* data = output->GetCellData();
  data->AddArray(ArrayOf<vtkIntArray>("StrokeId", splits, &StrokeSplit::stroke));
  data->AddArray(ArrayOf<vtkDoubleArray>("ParamStart", splits, &StrokeSplit::start));
  data->AddArray(ArrayOf<vtkDoubleArray>("ParamEnd", splits, &StrokeSplit::end));
  data->AddArray(ArrayOf<vtkIntArray>("Halvings", splits, &StrokeSplit::halvings));
}

} // namespace oversketch
