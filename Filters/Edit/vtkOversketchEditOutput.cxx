// Output of an edit.
#include "vtkOversketchEditPipeline.h"

#include "Mesh/weld.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSources.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

using namespace oversketch;

void vtkOversketchEdit::Pipeline::PutPreview(vtkPolyData* edited)
{
  const double done = this->Self->GetDone();
  this->Preview.Provide(
    *this->Welding, this->Plain, this->Start, this->Weighted, ContextOf(this->Self, done, done));
  this->Preview.Write(this->Self->StageOutput(this->DeformName()), edited);
}

namespace
{

// A curve with other numbers for its vertices, by numbers of the mesh that it came from; -1 without them. Of
// moved its places.
void PutCurve(vtkPolyData* curve,
  vtkPolyData* moved,
  const std::vector<vtkIdType>& numbers,
  vtkPolyData* output)
{
  output->ShallowCopy(curve);
  vtkDataArray* before = curve->GetPointData()->GetArray("VertexId");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto vertices = NewArray<vtkIdTypeArray>("VertexId");
  for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
  {
    const auto vertex = static_cast<vtkIdType>(before->GetComponent(i, 0));
    vertices->InsertNextValue(numbers.empty() ? -1 : numbers[static_cast<std::size_t>(vertex)]);
    points->InsertNextPoint(moved->GetPoint(vertex));
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(vertices);
}

// Who reads the mesh welds what lies at one place.
void RequireApart(vtkPolyData* mesh)
{
  vtkDataArray* region = mesh->GetPointData()->GetArray("EditRegion");
  vtkBoundingBox box;
  const auto eachPlace = [mesh](const auto& visit)
  {
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      Vector3 place;
      mesh->GetPoint(i, place.data());
      visit(i, place);
    }
  };
  eachPlace(
    [&](vtkIdType i, Vector3& place)
    {
      if (region->GetComponent(i, 0) == EditLabel::Inside)
      {
        box.AddPoint(place.data());
      }
    });
  std::vector<Vector3> places;
  eachPlace(
    [&](vtkIdType, const Vector3& place)
    {
      if (box.ContainsPoint(place.data()))
      {
        places.push_back(place);
      }
    });
  const std::vector<int> vertices = weldPoints(places);
  if (!vertices.empty())
  {
    const std::size_t left =
      static_cast<std::size_t>(*std::max_element(vertices.begin(), vertices.end())) + 1;
    throw Error(Failure::Torn,
      "The edit brings %1 vertices to places where others are already, which would be one when the mesh is "
      "read again: make a smaller edit, or nearer to the origin.",
      places.size() - left);
  }
}

} // namespace

EditFigures vtkOversketchEdit::Pipeline::FiguresOf(vtkPolyData* last)
{
  EditFigures figures;
  figures.isProfile = this->HasProfile();
  vtkPolyData* rest = this->Weighted;
  const bool isMoved = this->Moved() > 0;
  const double done = this->Self->GetDone();
  const Context context = ContextOf(this->Self, done, done);
  if (isMoved)
  {
    const auto more = [&](const auto& count)
    {
      const int now = count(last);
      return now > 0 ? std::max(0, now - count(rest)) : 0;
    };
    figures.folds = more(FoldsIn);
    figures.crossings = more([&](vtkPolyData* mesh) { return CrossingsIn(mesh, context); });
  }
  if (isMoved && figures.isProfile)
  {
    figures.depth =
      DepthInThickness(this->Self->StageOutput("Section"), this->DrawnProfile, this->Ground, context);
  }
  const auto& rings = this->Boundary.Lines.All();
  if (rings.size() == 1 && !IsCurveOfEdit(rings.front()))
  {
    const double meanEdge = rest->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0);
    figures.shareSeen =
      ShareSeen(this->Boundary.Made.Curve, this->Self->StageOutput("BoundaryProject"), 0.5 * meanEdge);
  }
  return figures;
}

void vtkOversketchEdit::Pipeline::PutOutput(vtkPolyData* mesh,
  vtkPolyData* output,
  vtkPolyData* reference,
  vtkPolyData* boundary)
{
  auto made = std::make_unique<Result>();
  made->MovedPoints = this->Moved();
  made->Bridges = this->Boundary.Made.Bridges;
  made->Reference->ShallowCopy(this->Boundary.Made.Stored);
  vtkPolyData* line = this->Boundary.Made.Stored;
  vtkPolyData* ring = this->Boundary.Made.Curve;
  vtkPolyData* last = this->Self->StageOutput(this->DeformName());
  if (made->MovedPoints == 0)
  {
    output->ShallowCopy(mesh);
    PutCurve(line, last, {}, reference);
    PutCurve(ring, last, {}, boundary);
    made->Moved.assign(static_cast<std::size_t>(output->GetNumberOfPoints()), 0);
  }
  else
  {
    const double done = this->Self->GetDone();
    const Context context = ContextOf(this->Self, done, done);
    std::vector<int> vertices;
    if (this->Retriangulates())
    {
      last = this->Self->StageOutput("Retriangulate");
      RequireApart(last);
      line = this->Retriangulate->GetReferenceOutput();
      ring = this->Retriangulate->GetBoundaryOutput();
      vtkNew<vtkPolyData> sourced;
      sourced->ShallowCopy(last);
      AddSources(this->Start, sourced, context);
      vertices = this->Welding->Transfer(this->Plain, { sourced.Get() }, output);
      output->GetFieldData()->AddArray(last->GetFieldData()->GetArray("MeanEdge"));
    }
    else
    {
      RequireApart(last);
      vtkNew<vtkPolyData> edited;
      this->PutPreview(edited);
      output->ShallowCopy(edited);
      if (!this->Preview.HasNormals())
      {
        output->GetPointData()->SetNormals(nullptr);
        output->GetPointData()->RemoveArray(this->RestNormals->GetName());
      }
      vertices = this->Preview.Vertices();
    }
    vtkDataArray* region = last->GetPointData()->GetArray("EditRegion");
    std::vector<vtkIdType> numbers(static_cast<std::size_t>(last->GetNumberOfPoints()), -1);
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      vtkIdType& first = numbers[static_cast<std::size_t>(vertices[i])];
      first = first < 0 ? static_cast<vtkIdType>(i) : first;
      made->Moved.push_back(region->GetComponent(vertices[i], 0) == 2.0);
    }
    PutCurve(line, last, numbers, reference);
    PutCurve(ring, last, numbers, boundary);
  }
  made->Figures = this->FiguresOf(last);
  made->Output->ShallowCopy(output);
  this->Made = std::move(made);
}
