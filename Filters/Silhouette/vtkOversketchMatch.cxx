#include "vtkOversketchMatch.h"

#include "Silhouette/match.h"
#include "Silhouette/shape_search.h"
#include "Stroke/stroke.h"
#include "vtkOversketchCurveTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPolylines.h"

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
#include "vtkPolyData.h"

#include <limits>

using namespace oversketch;

namespace
{

// A curve with what the match needs of it beside its picture.
struct Source
{
  Curve Line;
  Polyline Offsets;
  int CurveId, Connection;
};

// The values of an array of points along a cell, as many as the curve has points.
Polyline AlongCell(vtkDataArray* array, vtkPolyData* curves, vtkIdType cell, std::size_t count)
{
  vtkNew<vtkIdList> ids;
  curves->GetLines()->GetCellAtId(cell, ids);
  Polyline values(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    array->GetTuple(ids->GetId(static_cast<vtkIdType>(i)), values[i].data());
    if (!values[i].allFinite())
    {
      throw Error(Failure::BadMesh,
        "Array %1 of the curves holds a value that is not finite; run vtkOversketchOutline again.",
        array->GetName());
    }
  }
  return values;
}

// The samples as a stroke in the other one's view.
void WriteStroke(const Polyline& samples, vtkPolyData* like, vtkPolyData* stroke)
{
  stroke->Initialize();
  Polylines line;
  line.Add(samples);
  line.Put(stroke);
  stroke->GetCellData()->PassData(like->GetCellData());
  stroke->GetFieldData()->PassData(like->GetFieldData());
}

// The bindings joined where one triangle's worth of vertices carries both, else none.
Binding BlendBindings(const Binding& a, const Binding& b, double t)
{
  Binding result;
  int used = 0;
  for (const auto& [binding, share] : { std::pair(&a, 1.0 - t), std::pair(&b, t) })
  {
    for (int k = 0; k < 3; ++k)
    {
      const double weight = share * binding->weights[k];
      if (binding->vertices[k] < 0)
      {
        return Binding();
      }
      if (weight == 0.0)
      {
        continue;
      }
      int slot = 0;
      while (slot < used && result.vertices[slot] != binding->vertices[k])
      {
        ++slot;
      }
      if (slot == 3)
      {
        return Binding();
      }
      used = std::max(used, slot + 1);
      result.vertices[slot] = binding->vertices[k];
      result.weights[slot] += weight;
    }
  }
  for (int k = used; k < 3; ++k)
  {
    result.vertices[k] = result.vertices[0];
  }
  return result;
}

CurvePoint BlendPoints(const CurvePoint& a, const CurvePoint& b, double t)
{
  CurvePoint p;
  p.binding = BlendBindings(a.binding, b.binding, t);
  p.position = (1.0 - t) * a.position + t * b.position;
  p.normal = ((1.0 - t) * a.normal + t * b.normal).normalized();
  return p;
}

} // namespace

// The curves in the view of the last run, for the next stroke over them.
struct vtkOversketchMatch::Cache
{
  StepKey Key; // of the inputs
  std::vector<Source> Sources;
  std::vector<MatchCandidate> Candidates;

  void Read(vtkInformationVector* inputs, const View& view);
};

vtkStandardNewMacro(vtkOversketchMatch);

vtkOversketchMatch::vtkOversketchMatch()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  DeclareInput(this, 0, { Port::Repeatable });
}

vtkOversketchMatch::~vtkOversketchMatch() = default;

void vtkOversketchMatch::Cache::Read(vtkInformationVector* inputs, const View& view)
{
  const int connections = inputs->GetNumberOfInformationObjects();
  std::vector<MeshKey> curves;
  curves.reserve(static_cast<std::size_t>(connections));
  for (int c = 0; c < connections; ++c)
  {
    curves.push_back(CurvesKey(vtkPolyData::GetData(inputs, c)));
  }
  const StepKey key(curves, view, {});
  if (key == this->Key)
  {
    return;
  }
  this->Key = StepKey();
  this->Sources.clear();
  this->Candidates.clear();
  for (int c = 0; c < connections; ++c)
  {
    vtkPolyData* input = vtkPolyData::GetData(inputs, c);
    CurveSet set = ReadCurves(input, std::numeric_limits<int>::max(), "curves", Unbound::Allowed);
    vtkPointData* pointData = input->GetPointData();
    const auto optional = [&](const char* name)
    {
      return OptionalArray(
        pointData, name, 2, input->GetNumberOfPoints(), "curves", "vtkOversketchOutline makes it");
    };
    vtkDataArray* displays = optional("Display");
    vtkDataArray* offsets = optional("Offset");
    for (std::size_t i = 0; i < set.Curves.size(); ++i)
    {
      Curve& curve = set.Curves[i];
      const std::size_t count = curve.points.size();
      MatchCandidate candidate;
      candidate.closed = curve.closed;
      candidate.outline = input->GetCellData()->HasArray("Hole") != 0;
      bool seen = set.Visible[i] != 0;
      for (const CurvePoint& p : curve.points)
      {
        seen = seen && view.inFront(p.position);
        candidate.bound.push_back(p.binding.vertices[0] >= 0);
        candidate.display.push_back(seen ? Vector2(view.toDisplay(p.position).head<2>()) : Vector2::Zero());
      }
      if (!seen)
      {
        continue;
      }
      const vtkIdType cell = static_cast<vtkIdType>(i);
      if (displays)
      {
        candidate.display = AlongCell(displays, input, cell, count);
      }
      const Polyline offset =
        offsets ? AlongCell(offsets, input, cell, count) : Polyline(count, Vector2::Zero());
      this->Candidates.push_back(std::move(candidate));
      this->Sources.push_back({ std::move(curve), offset, set.Ids[i], c });
    }
  }
  this->Key = key;
}

int vtkOversketchMatch::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  this->NumberOfCandidates = 0;
  return RunFilter(this,
    [&]
    {
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      vtkPolyData* drawn = vtkPolyData::GetData(outputs, 1);
      const int connections = inputs[0]->GetNumberOfInformationObjects();
      vtkIdType points = 0;
      for (int c = 0; c < connections; ++c)
      {
        points += vtkPolyData::GetData(inputs[0], c)->GetNumberOfPoints();
      }
      if (points == 0)
      {
        return;
      }
      vtkPolyData* stroke = vtkPolyData::GetData(inputs[1]);
      const View view = ViewOf(stroke);
      Polyline samples = StrokeOf(stroke);
      const Vector2 moved = MovedOf(stroke);
      for (Vector2& sample : samples)
      {
        sample -= moved;
      }

      this->Internals->Read(inputs[0], view);
      const std::vector<Source>& sources = this->Internals->Sources;
      const std::vector<MatchCandidate>& candidates = this->Internals->Candidates;
      drawn->ShallowCopy(stroke);
      double done = 0.0;
      if (this->AmendedScore && this->CompareShapes && isClosedStroke(samples, StrokeRules()))
      {
        samples = openStroke(candidates, samples, ContextOf(this, 0.0, 0.5));
        Polyline opened = samples;
        for (Vector2& sample : opened)
        {
          sample += moved;
        }
        WriteStroke(opened, stroke, drawn);
        done = 0.5;
      }
      MatchRules rules;
      rules.amendedScore = this->AmendedScore;
      rules.maximumDistance = this->MaximumDistance;
      rules.maximumGap = this->MaximumGap;
      rules.compareShapes = this->CompareShapes;
      rules.rank = this->Candidate - 1;
      const MatchedSection match = matchStroke(candidates, samples, rules, ContextOf(this, done, 1.0));
      this->NumberOfCandidates = match.rivals;
      const Source& source = sources[match.candidate];
      Curve section;
      const auto displays = NewArray<vtkDoubleArray>("Display", 2);
      const auto offsets = NewArray<vtkDoubleArray>("Offset", 2);
      for (const Blend& place : match.places)
      {
        section.points.push_back(
          place.from == place.to
            ? source.Line.points[place.from]
            : BlendPoints(source.Line.points[place.from], source.Line.points[place.to], place.t));
        displays->InsertNextTuple(place.of(candidates[match.candidate].display).data());
        offsets->InsertNextTuple(place.of(source.Offsets).data());
      }
      WriteCurves({ section }, view, output);
      output->GetPointData()->AddArray(displays);
      output->GetPointData()->AddArray(offsets);
      output->GetCellData()->AddArray(OneValue<vtkIntArray>("CurveId", source.CurveId));
      for (const auto& [name, value] :
        { std::pair("Distance", match.distance), std::pair("Score", match.score) })
      {
        output->GetFieldData()->AddArray(OneValue<vtkDoubleArray>(name, value));
      }
      output->GetFieldData()->AddArray(OneValue<vtkIntArray>("Candidate", source.Connection));
    });
}

void vtkOversketchMatch::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AmendedScore: " << (this->AmendedScore ? "on" : "off") << '\n';
  os << indent << "CompareShapes: " << (this->CompareShapes ? "on" : "off") << '\n';
  os << indent << "Candidate: " << this->Candidate << '\n';
  os << indent << "NumberOfCandidates: " << this->NumberOfCandidates << '\n';
  os << indent << "MaximumDistance: " << this->MaximumDistance << '\n';
  os << indent << "MaximumGap: " << this->MaximumGap << '\n';
}
