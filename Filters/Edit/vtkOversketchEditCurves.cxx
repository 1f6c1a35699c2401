#include "vtkOversketchEditCurves.h"

#include "Ray/surface_rays.h"
#include "Stroke/polyline.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchPolylines.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

namespace oversketch
{

namespace
{

// Adds the arrays that tell InsertCurve that polylines are runs of one curve.
void AddRunArrays(vtkIdType runs, bool closed, vtkPolyData* laid)
{
  const std::pair<const char*, int> values[] = { { "StrokeId", 0 }, { "Closed", closed ? 1 : 0 } };
  for (const auto& [name, value] : values)
  {
    const auto array = NewArray<vtkIntArray>(name);
    for (vtkIdType i = 0; i < runs; ++i)
    {
      array->InsertNextValue(value);
    }
    laid->GetCellData()->AddArray(array);
  }
}

} // namespace

void DrawnLines::Read(vtkPolyData* input, const std::string& holder)
{
  const std::pair<const vtkDataObject*, vtkMTimeType> now{ input, input->GetMTime() };
  if (!this->Lines.empty() && this->Seen == now)
  {
    return;
  }
  if (input->GetNumberOfPoints() == 0 || input->GetNumberOfCells() == 0)
  {
    throw Error(Failure::BadStroke, "There is no %1 curve; draw one over the mesh.", holder);
  }
  if (input->GetNumberOfLines() != input->GetNumberOfCells())
  {
    throw Error(Failure::BadStroke,
      "The %1 input holds %2 cells that are no polylines; give the curve, and what redraws it, alone.",
      holder,
      input->GetNumberOfCells() - input->GetNumberOfLines());
  }
  std::vector<vtkSmartPointer<vtkPolyData>> lines;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < input->GetNumberOfLines(); ++i)
  {
    input->GetLines()->GetCellAtId(i, ids);
    if (std::any_of(
          ids->begin(), ids->end(), [&](vtkIdType id) { return id < 0 || id >= input->GetNumberOfPoints(); }))
    {
      throw Error(Failure::BadStroke,
        "Polyline %1 of the %2 input has points that do not exist; draw it anew.",
        i,
        holder);
    }
    vtkSmartPointer<vtkPolyData> line = StrokeAlone(input, i);
    const std::size_t k = lines.size();
    lines.push_back(k < this->Lines.size() && SameLines(line, this->Lines[k]) ? this->Lines[k] : line);
  }
  if (lines.size() > 1 && IsCurveOfEdit(input))
  {
    throw Error(Failure::BadStroke,
      "The %1 input holds %2 curves of earlier edits; give the one that is to count.",
      holder,
      lines.size());
  }
  this->Lines = std::move(lines);
  this->Seen = now;
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
  const auto triangles = NewArray<vtkIdTypeArray>("MeshCell");
  std::vector<Binding> bindings;
  for (vtkIdType i = 0; i < count; ++i)
  {
    Vector3 place;
    curve->GetPoint(i, place.data());
    const SurfaceHit hit = surface.closest(place);
    if (!hit.found())
    {
      throw Error(
        Failure::BadStroke, "Point %1 of a curve of an earlier edit is not finite; draw the curve anew.", i);
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
  AddRunArrays(1, closed, laid);
  laid->GetFieldData()->PassData(curve->GetFieldData());
}

RedrawnPart PartRedrawn(vtkPolyData* redrawn)
{
  RedrawnPart part;
  vtkDataArray* vertices = redrawn->GetPointData()->GetArray("VertexId");
  const DrawnLine line = ReadStrokes(redrawn).front();
  std::vector<int> kept;
  for (const vtkIdType id : line.Ids)
  {
    kept.push_back(static_cast<int>(vertices->GetComponent(id, 0)));
  }
  const auto isKept = [](int vertex) { return vertex >= 0; };
  const auto isNew = [](int vertex) { return vertex < 0; };
  if (std::all_of(kept.begin(), kept.end(), isKept))
  {
    return part;
  }
  part.Closed = line.Closed;
  Polyline samples = line.Samples;
  const bool isWhole = std::none_of(kept.begin(), kept.end(), isKept);
  if (line.Closed && !isWhole) // begins with the first new one after one that is kept
  {
    std::size_t first = 0;
    while (!(isNew(kept[first]) && isKept(kept[(first + kept.size() - 1) % kept.size()])))
    {
      ++first;
    }
    std::rotate(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
    std::rotate(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(first), samples.end());
  }
  const auto begin = std::find_if(kept.begin(), kept.end(), isNew);
  const auto end = std::find_if(kept.rbegin(), kept.rend(), isNew).base();
  part.Before.assign(kept.begin(), begin);
  part.After.assign(end, kept.end());
  Polyline fresh(samples.begin() + (begin - kept.begin()), samples.begin() + (end - kept.begin()));
  if (fresh.size() == 1) // no line; what is kept beside it is seen there, too
  {
    const std::size_t at = static_cast<std::size_t>(begin - kept.begin()), count = samples.size();
    if (line.Closed || at > 0)
    {
      fresh.insert(fresh.begin(), samples[(at + count - 1) % count]);
    }
    if (line.Closed || at + 1 < count)
    {
      fresh.push_back(samples[(at + 1) % count]);
    }
  }
  // What is projected is looked at each half pixel, as vtkOversketchNurbsFit has it.
  const bool isRing = line.Closed && isWhole;
  if (isRing)
  {
    fresh.push_back(fresh.front());
  }
  Polyline even = uniformPolyline(fresh, 0.5);
  if (isRing)
  {
    even.pop_back();
  }
  Polylines lines;
  lines.Add(even, isRing);
  part.Stroke = vtkSmartPointer<vtkPolyData>::New();
  lines.Put(part.Stroke);
  for (vtkDataArray* array : ViewArraysOf(redrawn))
  {
    part.Stroke->GetCellData()->AddArray(array);
  }
  return part;
}

namespace
{

// Runs of a curve on a mesh, and what is known of them.
class Laid
{
public:
  explicit Laid(const MeshData& mesh)
    : Data(mesh)
  {
    this->Points->SetDataTypeToDouble();
    this->Triangles->SetName("MeshCell");
    this->Parameters->SetName("CurveT");
  }

  void BeginRun() { this->Runs.emplace_back(); }

  void Insert(const Vector3& place, int triangle, const Binding& binding)
  {
    const vtkIdType count = this->Points->GetNumberOfPoints();
    const double step = count > 0 ? (place - Vector3(this->Points->GetPoint(count - 1))).norm() : 0.0;
    if (!this->Runs.back().empty() && !(this->Length + step > this->Length))
    {
      return; // CurveT rises along a run
    }
    this->Length += step;
    this->Runs.back().push_back(this->Points->InsertNextPoint(place.data()));
    this->Triangles->InsertNextValue(triangle);
    this->Bindings.push_back(binding);
    this->Parameters->InsertNextValue(this->Length);
  }

  void InsertVertices(const std::vector<int>& vertices)
  {
    for (const int v : vertices)
    {
      const int triangle = *this->Data.Neighbours().vertexTriangles.begin(v);
      const Triangle& corners = this->Data.Surface().triangles[triangle];
      Binding binding{ corners, { 0.0, 0.0, 0.0 } };
      binding.weights[cornerOf(corners, v)] = 1.0;
      this->Insert(this->Data.Surface().points[v], triangle, binding);
    }
  }

  void InsertRun(vtkPolyData* projected, vtkIdType cell)
  {
    const std::vector<Binding> bindings = ReadBindings(
      projected, this->Data.Surface().vertexCount(), "curves", "vtkOversketchProjectCurve makes it");
    vtkDataArray* triangles = projected->GetPointData()->GetArray("MeshCell");
    vtkNew<vtkIdList> ids;
    projected->GetLines()->GetCellAtId(cell, ids);
    const vtkIdType count = ids->GetNumberOfIds() - (ids->GetId(0) == ids->GetId(ids->GetNumberOfIds() - 1));
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType id = ids->GetId(i);
      this->Insert(Vector3(projected->GetPoint(id)),
        static_cast<int>(triangles->GetComponent(id, 0)),
        bindings[static_cast<std::size_t>(id)]);
    }
  }

  // rings: whether the only run closes by itself.
  void Write(bool closed, bool rings, vtkPolyData* views, vtkPolyData* laid) const
  {
    vtkNew<vtkCellArray> lines;
    laid->Initialize();
    laid->GetCellData()->CopyAllocate(views->GetCellData());
    for (const std::vector<vtkIdType>& run : this->Runs)
    {
      const vtkIdType cell = lines->InsertNextCell(static_cast<int>(run.size()) + rings);
      for (const vtkIdType id : run)
      {
        lines->InsertCellPoint(id);
      }
      if (rings)
      {
        lines->InsertCellPoint(run.front());
      }
      laid->GetCellData()->CopyData(views->GetCellData(), vtkIdType{ 0 }, cell);
    }
    const vtkIdType last = this->Points->GetNumberOfPoints() - 1;
    const double closing =
      (Vector3(this->Points->GetPoint(last)) - Vector3(this->Points->GetPoint(0))).norm();
    vtkNew<vtkDoubleArray> shares;
    shares->DeepCopy(this->Parameters);
    for (vtkIdType i = 0; i <= last; ++i)
    {
      shares->SetValue(i, shares->GetValue(i) / (closed ? this->Length + closing : this->Length));
    }
    laid->SetPoints(this->Points);
    laid->SetLines(lines);
    laid->GetPointData()->AddArray(shares);
    laid->GetPointData()->AddArray(this->Triangles);
    WriteBindings(this->Bindings, laid);
    AddRunArrays(static_cast<vtkIdType>(this->Runs.size()), closed, laid);
  }

private:
  const MeshData& Data;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIdTypeArray> Triangles;
  vtkNew<vtkDoubleArray> Parameters;
  std::vector<Binding> Bindings;
  std::vector<std::vector<vtkIdType>> Runs;
  double Length = 0.0;
};

} // namespace

void LayRedrawn(const RedrawnPart& part, vtkPolyData* projected, vtkPolyData* mesh, vtkPolyData* laid)
{
  const auto data = SharedMesh(mesh);
  Laid runs(*data);
  if (part.Closed && part.After.empty()) // drawn anew all the way round
  {
    vtkNew<vtkIdList> ids;
    projected->GetLines()->GetCellAtId(0, ids);
    const bool rings =
      projected->GetNumberOfLines() == 1 && ids->GetId(0) == ids->GetId(ids->GetNumberOfIds() - 1);
    for (vtkIdType cell = 0; cell < projected->GetNumberOfLines(); ++cell)
    {
      runs.BeginRun();
      runs.InsertRun(projected, cell);
    }
    runs.Write(true, rings, part.Stroke, laid);
    return;
  }
  // An open stroke has one run; what is hidden at its ends is missing there.
  vtkDataArray* along = projected->GetPointData()->GetArray("CurveT");
  const bool begins = along->GetComponent(0, 0) == 0.0;
  const bool ends = along->GetComponent(projected->GetNumberOfPoints() - 1, 0) == 1.0;
  runs.BeginRun();
  if (!part.Closed)
  {
    runs.InsertVertices(part.Before);
    runs.InsertRun(projected, 0);
    runs.InsertVertices(part.After);
    runs.Write(false, false, part.Stroke, laid);
    return;
  }
  if (!begins || ends)
  {
    runs.InsertRun(projected, 0);
    if (!ends)
    {
      runs.BeginRun();
    }
    runs.InsertVertices(part.After);
  }
  else
  {
    runs.InsertVertices(part.After);
    runs.InsertRun(projected, 0);
  }
  runs.Write(true, begins && ends, part.Stroke, laid);
}

void FollowSources(vtkPolyData* before, vtkPolyData* redrawn)
{
  vtkDataArray* places = before->GetPointData()->GetArray("CurveT");
  vtkDataArray* sources = before->GetPointData()->GetArray("SourceT");
  vtkDataArray* own = redrawn->GetPointData()->GetArray("SourceT");
  const auto followed = NewArray<vtkDoubleArray>("SourceT");
  vtkIdType k = 0; // both rise
  for (vtkIdType i = 0; i < own->GetNumberOfTuples(); ++i)
  {
    const double t = own->GetComponent(i, 0);
    while (k + 2 < places->GetNumberOfTuples() && places->GetComponent(k + 1, 0) <= t)
    {
      ++k;
    }
    const double from = places->GetComponent(k, 0), to = places->GetComponent(k + 1, 0);
    const double share = std::clamp((t - from) / (to - from), 0.0, 1.0);
    const double source =
      (1.0 - share) * sources->GetComponent(k, 0) + share * sources->GetComponent(k + 1, 0);
    followed->InsertNextValue(
      i > 0 ? std::max(source, followed->GetValue(i - 1)) : source); // but for rounding it rises
  }
  redrawn->GetPointData()->AddArray(followed);
}

} // namespace oversketch
