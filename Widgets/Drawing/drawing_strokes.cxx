#include "drawing_strokes.h"

#include "Stroke/correct.h"
#include "pen_stroke.h"
#include "vtkOversketchCanvasTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace oversketch
{

namespace
{

template <typename Array>
void setValue(vtkPolyData* stroke, const char* name, double value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextTuple1(value);
  stroke->GetCellData()->AddArray(array);
}

double valueOf(vtkPolyData* stroke, const char* name, double otherwise)
{
  vtkDataArray* array = stroke->GetCellData()->GetArray(name);
  return array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, 0) : otherwise;
}

void complete(vtkPolyData* stroke, double magnetic, double radius)
{
  setValue<vtkIntArray>(stroke, "Magnetic", valueOf(stroke, "Magnetic", magnetic));
  setValue<vtkDoubleArray>(stroke, "SnapRadius", valueOf(stroke, "SnapRadius", radius));
  setValue<vtkIntArray>(stroke, "Treatment", valueOf(stroke, "Treatment", 0.0));
}

// A stroke, its samples where they were drawn and on the canvas.
struct Laid
{
  DrawnLine drawn;
  CanvasStroke curve;
};

Laid laid(vtkPolyData* stroke, const Canvas& canvas)
{
  Laid one;
  one.drawn = ReadStrokes(stroke)[0];
  one.curve.points = ontoCanvas(PenView::of(stroke).kernelView(), one.drawn.Samples);
  const std::size_t round = one.drawn.Closed ? 0 : samplesRound(one.curve.points, canvas);
  one.curve.closed = one.drawn.Closed || round > 0;
  if (round > 0 && one.drawn.Samples.size() == one.curve.points.size())
  {
    one.curve.points.resize(round);
    one.drawn.Samples.resize(round);
    one.drawn.Ids.resize(round);
  }
  return one;
}

// Values of the corrected stroke's samples, of an array that both strokes have.
void blend(const Laid& old,
  const Laid& fresh,
  const std::vector<Origin>& origins,
  vtkDataArray* before,
  vtkDataArray* after,
  vtkPointData* into)
{
  const auto valuesOf = [](const Laid& of, vtkDataArray* array)
  { return oversketch::mapped(of.drawn.Ids, [array](vtkIdType id) { return array->GetComponent(id, 0); }); };
  const std::vector<double> had = valuesOf(old, before), has = valuesOf(fresh, after);
  const auto array = vtkSmartPointer<vtkDataArray>::Take(before->NewInstance());
  array->SetName(before->GetName());
  for (const Origin& origin : origins)
  {
    array->InsertNextTuple1(origin.of(had, has));
  }
  into->AddArray(array);
}

} // namespace

void DrawingStrokes::set(vtkPolyData* drawing)
{
  std::vector<vtkSmartPointer<vtkPolyData>> all;
  if (drawing && drawing->GetNumberOfPoints() > 0)
  {
    const int strokes = static_cast<int>(ReadStrokes(drawing).size());
    for (int i = 0; i < strokes; ++i)
    {
      all.push_back(StrokeAlone(drawing, i));
      complete(all.back(), 0.0, 10.0);
      PenView::of(all.back()).kernelView();
    }
  }
  this->All = std::move(all);
}

void DrawingStrokes::putInto(vtkPolyData* drawing) const
{
  oversketch::putInto(drawing, this->All);
}

void DrawingStrokes::add(vtkPolyData* stroke, bool magnetic, double radius)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(stroke);
  complete(copy, magnetic, radius);
  for (const char* name : { "Depth", "Height", "CrossSection" })
  {
    vtkDataArray* others = this->All.empty() ? nullptr : this->All.front()->GetCellData()->GetArray(name);
    if (others && !copy->GetCellData()->HasArray(name)) // arrays that one lacks would be dropped
    {
      const auto none = vtkSmartPointer<vtkDataArray>::Take(others->NewInstance());
      none->SetName(name);
      none->InsertNextTuple1(0.0);
      copy->GetCellData()->AddArray(none);
    }
  }
  this->All.push_back(copy);
}

void DrawingStrokes::removeLast()
{
  if (!this->All.empty())
  {
    this->All.pop_back();
  }
}

int DrawingStrokes::correct(vtkPolyData* stroke, const Canvas& canvas)
{
  std::vector<Laid> lines;
  std::vector<CanvasStroke> curves;
  for (vtkPolyData* one : this->All)
  {
    lines.push_back(laid(one, canvas));
    curves.push_back(lines.back().curve);
  }
  const Laid fresh = laid(stroke, canvas);
  const Correction correction =
    corrected(curves, fresh.curve.points, 0.02 * canvas.longest(), 0.005 * canvas.longest());
  if (correction.kind == Correction::New)
  {
    return -1;
  }
  const Laid& old = lines[static_cast<std::size_t>(correction.stroke)];
  vtkPolyData* before = this->All[static_cast<std::size_t>(correction.stroke)];
  const View view = PenView::of(before).kernelView();
  // Where a sample does not meet the canvas their numbers differ, and all are put where they are seen.
  const bool same = old.curve.points.size() == old.drawn.Samples.size();
  const auto after = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lineCells;
  const std::vector<Origin>& origins = correction.result.origins;
  lineCells->InsertNextCell(static_cast<int>(origins.size()) + (old.curve.closed ? 1 : 0));
  for (std::size_t i = 0; i < origins.size(); ++i)
  {
    const Blend& from = origins[i].before;
    const bool kept = same && origins[i].weight == 0.0 && from.from == from.to;
    const Vector2& place = correction.result.points[i];
    const Vector2 at = kept ? old.drawn.Samples[static_cast<std::size_t>(from.from)]
                            : Vector2(view.toDisplay({ place[0], place[1], 0.0 }).head<2>());
    lineCells->InsertCellPoint(points->InsertNextPoint(at[0], at[1], 0.0));
  }
  if (old.curve.closed)
  {
    lineCells->InsertCellPoint(0);
  }
  after->SetPoints(points);
  after->SetLines(lineCells);
  after->GetCellData()->ShallowCopy(before->GetCellData());
  after->GetFieldData()->ShallowCopy(before->GetFieldData());
  for (const char* name : { "Pressure", "Time" })
  {
    vtkDataArray* had = before->GetPointData()->GetArray(name);
    vtkDataArray* has = stroke->GetPointData()->GetArray(name);
    if (had && has && same && fresh.curve.points.size() == fresh.drawn.Samples.size())
    {
      blend(old, fresh, origins, had, has, after->GetPointData());
    }
  }
  this->All[static_cast<std::size_t>(correction.stroke)] = after;
  return correction.stroke;
}

int DrawingStrokes::treatment(int stroke) const
{
  return static_cast<int>(valueOf(this->All[static_cast<std::size_t>(stroke)], "Treatment", 0.0));
}

void DrawingStrokes::setTreatment(int stroke, int treatment)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New(); // a drawing that was put out may share it
  copy->ShallowCopy(this->All[static_cast<std::size_t>(stroke)]);
  setValue<vtkIntArray>(copy, "Treatment", treatment);
  this->All[static_cast<std::size_t>(stroke)] = copy;
}

} // namespace oversketch
