#include "vtkOversketchResketch.h"

#include "Stroke/correct.h"
#include "Stroke/resketch.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPolylines.h"
#include "vtkOversketchStrokeTools.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>

using namespace oversketch;

namespace
{

DrawnLine oneLine(vtkPolyData* curve, const char* what)
{
  std::vector<DrawnLine> lines = ReadStrokes(curve);
  if (lines.size() != 1)
  {
    throw Error(
      Failure::BadStroke, "There are %1 polylines where the %2 is one: give that one.", lines.size(), what);
  }
  return std::move(lines.front());
}

void requireLength(const Polyline& points, const char* what)
{
  if (!HasLength(points))
  {
    throw Error(
      Failure::BadStroke, std::string("The ") + what + " has no two places that differ: draw a longer one.");
  }
}

// A curve on a mesh as the stroke's view shows it.
void seeInPicture(vtkPolyData* curve, const View& view, DrawnLine& line)
{
  for (std::size_t i = 0; i < line.Ids.size(); ++i)
  {
    const Vector3 world(curve->GetPoint(line.Ids[i]));
    if (!world.allFinite() || !view.inFront(world))
    {
      throw Error(Failure::BadStroke,
        "The curve's sample %1 is not in front of the eye in the stroke's view: look at the whole curve and "
        "draw again.",
        i);
    }
    line.Samples[i] = view.toDisplay(world).head<2>();
  }
}

double meanStep(const DrawnLine& line)
{
  const std::size_t steps = line.Samples.size() - (line.Closed ? 0 : 1);
  return arcLengths(line.Samples, line.Closed).back() / static_cast<double>(steps);
}

bool isPoint(const Blend& place)
{
  return place.from == place.to || place.t == 0.0;
}

// Numbers that both curves have on their points, but what is written anew.
void blendArrays(vtkPolyData* curve,
  const DrawnLine& old,
  vtkPolyData* stroke,
  const DrawnLine& fresh,
  const std::vector<Origin>& origins,
  vtkPolyData* output)
{
  const auto valuesOf = [](vtkDataArray* array, const std::vector<vtkIdType>& ids)
  {
    std::vector<double> values;
    std::transform(ids.begin(),
      ids.end(),
      std::back_inserter(values),
      [array](vtkIdType id) { return array->GetComponent(id, 0); });
    return values;
  };
  for (int i = 0; i < curve->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* first = curve->GetPointData()->GetArray(i);
    const char* name = first ? first->GetName() : nullptr;
    vtkDataArray* second = name ? stroke->GetPointData()->GetArray(name) : nullptr;
    const auto plain = [](vtkDataArray* array)
    {
      return array->GetNumberOfComponents() == 1 &&
             (array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT);
    };
    if (!second || !plain(first) || !plain(second) || output->GetPointData()->HasArray(name))
    {
      continue;
    }
    const std::vector<double> before = valuesOf(first, old.Ids), after = valuesOf(second, fresh.Ids);
    auto blended = vtkSmartPointer<vtkDataArray>::Take(first->NewInstance());
    blended->SetName(name);
    for (const Origin& origin : origins)
    {
      blended->InsertNextTuple1(origin.of(before, after));
    }
    output->GetPointData()->AddArray(blended);
  }
}

void writeCurve(const Polyline& curve, bool closed, vtkPolyData* output)
{
  Polylines line;
  line.Add(curve, closed);
  line.Put(output);
  const auto shares = NewArray<vtkDoubleArray>("CurveT");
  const std::vector<double> lengths = arcLengths(curve, closed);
  for (std::size_t i = 0; i < curve.size(); ++i)
  {
    shares->InsertNextValue(lengths[i] / lengths.back());
  }
  output->GetPointData()->AddArray(shares);
}

// Samples upon the one before them are none: CurveT rises.
void dropRepeated(Resketched& result, bool closed)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < result.points.size(); ++i)
  {
    const bool repeats =
      kept > 0 && (result.points[i] == result.points[kept - 1] ||
                    (closed && i + 1 == result.points.size() && result.points[i] == result.points[0]));
    if (!repeats)
    {
      result.points[kept] = result.points[i];
      result.origins[kept++] = result.origins[i];
    }
  }
  result.points.resize(kept);
  result.origins.resize(kept);
}

} // namespace

vtkStandardNewMacro(vtkOversketchResketch);

void vtkOversketchResketch::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* curve = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* stroke = vtkPolyData::GetData(inputs[1]);
  if (stroke->GetNumberOfPoints() == 0)
  {
    return;
  }
  this->Kept<KeptOutput>().Provide(
    StepKey({ WholeKey(curve), WholeKey(stroke) },
      { this->K, static_cast<double>(this->Middle), this->RawTangents ? 1.0 : 0.0 }),
    vtkPolyData::GetData(outputs),
    [&](vtkPolyData* result)
    {
      ++this->ResketchCount;
      DrawnLine old = oneLine(curve, "curve");
      const DrawnLine fresh = oneLine(stroke, "stroke");
      vtkDataArray* vertices = nullptr;
      if (curve->GetPointData()->HasArray("VertexId"))
      {
        vertices = RequireArray(curve->GetPointData(),
          "VertexId",
          1,
          curve->GetNumberOfPoints(),
          "curve",
          "take it from vtkOversketchInsertCurve");
        seeInPicture(curve, ViewOf(stroke), old);
      }
      requireLength(old.Samples, "curve");
      requireLength(fresh.Samples, "stroke");
      ResketchRules rules;
      rules.reach = this->K;
      rules.spacing = std::min(meanStep(old), meanStep(fresh));
      rules.middle =
        this->Middle == Closest ? ResketchRules::Middle::Closest : ResketchRules::Middle::ArcLength;
      rules.rawTangents = this->RawTangents;
      Resketched drawn = old.Closed ? resketchClosed(old.Samples, fresh.Samples, rules)
                                    : resketch(old.Samples, fresh.Samples, rules);
      if (drawn.points == old.Samples)
      {
        Warn(this, "The stroke replaces nothing of the curve: draw it along a part of the curve.");
      }
      dropRepeated(drawn, old.Closed);
      ContextOf(this).checkpoint(0.9);

      writeCurve(drawn.points, old.Closed, result);
      const auto sources = NewArray<vtkDoubleArray>("SourceT");
      const auto kept = NewArray<vtkIdTypeArray>("VertexId");
      for (const double share : sourcesOf(drawn.origins, old.Samples, old.Closed))
      {
        sources->InsertNextValue(share);
      }
      for (const Origin& origin : drawn.origins)
      {
        const bool stays = origin.weight == 0.0 && isPoint(origin.before);
        kept->InsertNextValue(
          stays && vertices ? static_cast<vtkIdType>(vertices->GetComponent(old.Ids[origin.before.from], 0))
                            : -1);
      }
      result->GetPointData()->AddArray(sources);
      if (vertices)
      {
        result->GetPointData()->AddArray(kept);
      }
      blendArrays(curve, old, stroke, fresh, drawn.origins, result);
      result->GetCellData()->PassData(curve->GetCellData());
      result->GetCellData()->PassData(stroke->GetCellData());
      result->GetFieldData()->PassData(curve->GetFieldData());
    });
}

void vtkOversketchResketch::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "K: " << this->K << '\n'
     << indent << "Middle: " << (this->Middle == Closest ? "Closest" : "ArcLength") << '\n'
     << indent << "RawTangents: " << (this->RawTangents ? "On" : "Off") << '\n'
     << indent << "ResketchCount: " << this->ResketchCount << '\n';
}
