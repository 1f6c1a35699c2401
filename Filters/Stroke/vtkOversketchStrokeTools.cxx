#include "vtkOversketchStrokeTools.h"

#include "Ray/surface_rays.h"
#include "Stroke/stroke.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchCarriedArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace oversketch
{

namespace
{

// Arrays that a curve takes over from the stroke's cell, also those that tell of the feature that it draws.
std::vector<vtkDataArray*> passedArrays(vtkPolyData* strokes)
{
  return ViewArraysOf(strokes, { "Radius", "Height", "Sharpness" });
}

vtkDataArray* pressureOf(vtkPolyData* strokes)
{
  vtkDataArray* pressure = strokes->GetPointData()->GetArray("Pressure");
  return pressure && pressure->GetNumberOfComponents() == 1 &&
             pressure->GetNumberOfTuples() == strokes->GetNumberOfPoints()
           ? pressure
           : nullptr;
}

// The triangles that have one of some vertices, in the mesh's order, as a mesh of their own.
struct TrianglesAt
{
  TrianglesAt(const Mesh& mesh, const std::vector<int>& vertices)
    : Number(mesh.points.size(), -1)
  {
    std::vector<char> wanted(mesh.points.size(), 0);
    for (const int v : vertices)
    {
      wanted[static_cast<std::size_t>(v)] = 1;
    }
    for (const Triangle& t : mesh.triangles)
    {
      if (std::none_of(
            t.begin(), t.end(), [&wanted](int v) { return wanted[static_cast<std::size_t>(v)] != 0; }))
      {
        continue;
      }
      Triangle own{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        int& number = this->Number[static_cast<std::size_t>(t[k])];
        if (number < 0)
        {
          number = this->Part.vertexCount();
          this->Part.points.push_back(mesh.points[static_cast<std::size_t>(t[k])]);
        }
        own[k] = number;
      }
      this->Part.triangles.push_back(own);
    }
  }

  Mesh Part;
  std::vector<int> Number; // of the mesh's vertices there; -1: none
};

// Point data of one curve after another.
struct CurvePoints
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> arcs, normals, room;
  vtkNew<vtkIdTypeArray> cells;
  vtkSmartPointer<vtkDataArray> pressure;
  std::vector<Binding> bindings;

  explicit CurvePoints(vtkDataArray* strokesPressure)
  {
    this->points->SetDataTypeToDouble();
    this->arcs->SetName("ArcLength");
    this->normals->SetName("Normals");
    this->normals->SetNumberOfComponents(3);
    this->room->SetName("Room");
    this->room->SetNumberOfComponents(2);
    this->cells->SetName("MeshCell");
    if (strokesPressure)
    {
      this->pressure = LikeArray(strokesPressure, 0);
    }
  }

  // Normals turn with the surface; where they cancel, that of the facet.
  void addNormals(const KeptSurface& surface)
  {
    std::vector<int> corners;
    for (const Binding& binding : this->bindings)
    {
      corners.insert(corners.end(), binding.vertices.begin(), binding.vertices.end());
    }
    const std::vector<Vector3> at = surface.NormalsOf(corners);
    for (std::size_t i = 0; i < this->bindings.size(); ++i)
    {
      const auto& weights = this->bindings[i].weights;
      const Vector3 normal = weights[0] * at[3 * i] + weights[1] * at[3 * i + 1] + weights[2] * at[3 * i + 2];
      const int triangle = static_cast<int>(this->cells->GetValue(static_cast<vtkIdType>(i)));
      this->normals->InsertNextTuple((
        normal.norm() > 1e-6 ? Vector3(normal.normalized()) : facetNormal(surface.Mesh().Surface(), triangle))
                                       .data());
    }
  }

  void addRoom(const KeptSurface& surface)
  {
    for (vtkIdType i = 0; i < this->points->GetNumberOfPoints(); ++i)
    {
      const Room found =
        roomAt(surface.Scene(), Vector3(this->points->GetPoint(i)), Vector3(this->normals->GetTuple3(i)));
      this->room->InsertNextTuple2(std::isfinite(found.inward) ? found.inward : -1.0,
        std::isfinite(found.outward) ? found.outward : -1.0);
    }
  }

  vtkIdType insert(const SurfaceSample& sample, double arc, const MeshData& mesh)
  {
    this->arcs->InsertNextValue(arc);
    this->cells->InsertNextValue(sample.at.triangle);
    this->bindings.push_back({ mesh.Surface().triangles[sample.at.triangle], sample.at.weights });
    return this->points->InsertNextPoint(sample.position.data());
  }
};

} // namespace

void RefuseEndless(const std::vector<DrawnLine>& strokes)
{
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    const double length = arcLengths(strokes[i].Samples, strokes[i].Closed).back();
    if (!(length <= longestStroke))
    {
      throw Error(Failure::BadStroke,
        Message::unusable("Stroke",
          static_cast<long long>(i),
          { "it is %1 px long; at most %2 px are taken: record the stroke again.", length, longestStroke }));
    }
  }
}

StrokeOnCanvas OntoCanvas(vtkPolyData* strokes,
  const std::vector<DrawnLine>& lines,
  int stroke,
  const Canvas& canvas,
  const char* what)
{
  const DrawnLine& line = lines[static_cast<std::size_t>(stroke)];
  const View view = ViewOfStroke(strokes, stroke);
  StrokeOnCanvas result;
  Polyline& points = result.Curve.points;
  for (int i = 0; i < static_cast<int>(line.Samples.size()); ++i)
  {
    if (const std::optional<Vector2> place = ontoCanvas(view, line.Samples[i]))
    {
      points.push_back(*place);
      result.Places.push_back(Blend::point(i));
    }
  }
  if (points.empty())
  {
    throw Error(Failure::BadStroke,
      Message::unusable(
        what, stroke, "its view shows the plane z = 0 at none of its samples; draw it over the canvas."));
  }
  vtkDataArray* said = strokes->GetCellData()->GetArray("Closed");
  const double value =
    said && said->GetNumberOfTuples() == strokes->GetNumberOfCells() ? said->GetComponent(stroke, 0) : -1.0;
  const bool told = value == 0.0 || value == 1.0;
  const std::size_t round = line.Closed || told ? points.size() : samplesRound(points, canvas);
  result.Curve.closed = points.size() > 2 && (line.Closed || (round > 0 && value != 0.0));
  if (result.Curve.closed)
  {
    points.resize(round);
    result.Places.resize(round);
  }
  if (result.Curve.closed && points.size() > 3 && points.back() == points.front())
  {
    points.pop_back();
    result.Places.pop_back();
  }
  return result;
}

void WriteStrokes(vtkPolyData* input,
  const std::vector<DrawnLine>& strokes,
  const std::vector<std::vector<Blend>>& places,
  const std::vector<char>& closed,
  vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkPointData* from = input->GetPointData();
  vtkPointData* to = output->GetPointData();
  to->InterpolateAllocate(from);
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    lines->InsertNextCell(static_cast<int>(places[i].size()) + closed[i]);
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Blend& place : places[i])
    {
      const Vector2 p = place.of(strokes[i].Samples);
      const vtkIdType id = points->InsertNextPoint(p[0], p[1], 0.0);
      lines->InsertCellPoint(id);
      to->InterpolateEdge(from, id, strokes[i].Ids[place.from], strokes[i].Ids[place.to], place.t);
    }
    if (closed[i])
    {
      lines->InsertCellPoint(first);
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->PassData(input->GetCellData());
  output->GetFieldData()->PassData(input->GetFieldData());
}

MeshKey StrokesKey(vtkPolyData* strokes)
{
  std::vector<vtkDataArray*> arrays = passedArrays(strokes);
  arrays.push_back(pressureOf(strokes));
  return MeshKey(strokes, arrays);
}

void WriteSurfaceCurves(const std::vector<StrokeCurve>& curves,
  const KeptSurface& surface,
  vtkPolyData* strokes,
  const std::vector<DrawnLine>& lines,
  vtkPolyData* output)
{
  vtkDataArray* pressure = pressureOf(strokes);
  CurvePoints to(pressure);
  vtkNew<vtkCellArray> cells;
  const auto curveIds = NewArray<vtkIntArray>("CurveId");
  const auto strokeIds = NewArray<vtkIntArray>("StrokeId");
  output->GetCellData()->AddArray(curveIds);
  output->GetCellData()->AddArray(strokeIds);
  const std::vector<vtkDataArray*> passed = passedArrays(strokes);
  std::vector<vtkSmartPointer<vtkDataArray>> taken;
  for (vtkDataArray* array : passed)
  {
    taken.push_back(LikeArray(array, 0));
    output->GetCellData()->AddArray(taken.back());
  }
  for (const StrokeCurve& curve : curves)
  {
    const std::vector<SurfaceSample>& samples = curve.Curve.samples;
    const std::vector<vtkIdType>& ids = lines[static_cast<std::size_t>(curve.Stroke)].Ids;
    cells->InsertNextCell(static_cast<int>(samples.size()) + curve.Curve.closed);
    const vtkIdType first = to.points->GetNumberOfPoints();
    double arc = 0.0;
    for (std::size_t k = 0; k < samples.size(); ++k)
    {
      arc += k > 0 ? (samples[k].position - samples[k - 1].position).norm() : 0.0;
      cells->InsertCellPoint(to.insert(samples[k], arc, surface.Mesh()));
      if (pressure)
      {
        const std::size_t before = static_cast<std::size_t>(samples[k].along);
        const double t = samples[k].along - static_cast<double>(before);
        to.pressure->InsertNextTuple1((1.0 - t) * pressure->GetComponent(ids[before % ids.size()], 0) +
                                      t * pressure->GetComponent(ids[(before + 1) % ids.size()], 0));
      }
    }
    if (curve.Curve.closed)
    {
      cells->InsertCellPoint(first);
    }
    curveIds->InsertNextValue(static_cast<int>(curveIds->GetNumberOfTuples()));
    strokeIds->InsertNextValue(curve.Stroke);
    for (std::size_t a = 0; a < passed.size(); ++a)
    {
      taken[a]->InsertNextTuple(curve.Stroke, passed[a]);
    }
  }
  to.addNormals(surface);
  to.addRoom(surface);
  output->SetPoints(to.points);
  output->SetLines(cells);
  vtkPointData* data = output->GetPointData();
  data->AddArray(to.arcs);
  data->AddArray(to.cells);
  WriteBindings(to.bindings, output);
  data->SetNormals(to.normals);
  data->AddArray(to.room);
  if (to.pressure)
  {
    data->AddArray(to.pressure);
  }
}

std::vector<StrokeCurve> ProjectStrokes(vtkAlgorithm* filter,
  vtkPolyData* strokes,
  const std::vector<DrawnLine>& lines,
  const char* missed,
  const ProjectStroke& project)
{
  std::vector<StrokeCurve> curves;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const int stroke = static_cast<int>(i);
    const double share = 0.5 / static_cast<double>(lines.size());
    const std::vector<SurfaceCurve> made = project(ViewOfStroke(strokes, stroke),
      lines[i],
      stroke,
      ContextOf(filter, 0.5 + share * stroke, 0.5 + share * (stroke + 1)));
    if (made.empty())
    {
      throw Error(Failure::BadStroke, Message::unusable("Stroke", stroke, missed));
    }
    for (const SurfaceCurve& curve : made)
    {
      curves.push_back({ curve, stroke });
    }
  }
  return curves;
}

const SurfaceRays& KeptSurface::Provide(vtkPolyData* mesh, const Context& context)
{
  this->Data = SharedMesh(mesh);
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  this->BringsNormals = normals && normals->GetNumberOfComponents() == 3 &&
                        normals->GetNumberOfTuples() == mesh->GetNumberOfPoints(); // as SharedMesh has it
  if (!this->Rays || this->Shape != this->Data->KeptSurface())
  {
    this->Rays = nullptr;
    this->Shape = this->Data->KeptSurface();
    this->Rays = sharedRays(this->Shape, context);
    ++this->BuildCount;
  }
  return *this->Rays;
}

std::vector<Vector3> KeptSurface::NormalsOf(const std::vector<int>& vertices) const
{
  std::vector<Vector3> normals;
  normals.reserve(vertices.size());
  if (this->BringsNormals)
  {
    for (const int v : vertices)
    {
      normals.push_back(this->Data->Normals()[static_cast<std::size_t>(v)]);
    }
    return normals;
  }
  const TrianglesAt part(this->Data->Surface(), vertices);
  const Lists around = trianglesAround(part.Part);
  for (const int v : vertices)
  {
    normals.push_back(vertexNormal(part.Part, around, part.Number[static_cast<std::size_t>(v)]));
  }
  return normals;
}

} // namespace oversketch
