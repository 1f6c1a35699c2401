#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchPolylines.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace oversketch
{
namespace
{

// Whether an array says of a stroke how it was seen.
bool isViewArray(const char* name)
{
  const char* const names[] = { "ViewTransform", "ProjectionTransform", "ViewportSize", "Moved" };
  return name && std::any_of(std::begin(names),
                   std::end(names),
                   [&](const char* each) { return std::strcmp(each, name) == 0; });
}

bool sameValues(vtkDataArray* a, vtkDataArray* b)
{
  return a && b && a->GetDataType() == b->GetDataType() &&
         a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
         a->GetNumberOfTuples() == b->GetNumberOfTuples() &&
         std::memcmp(a->GetVoidPointer(0),
           b->GetVoidPointer(0),
           static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())) == 0;
}

bool sameArrays(vtkFieldData* a, vtkFieldData* b)
{
  bool same = a->GetNumberOfArrays() == b->GetNumberOfArrays();
  for (int i = 0; same && i < a->GetNumberOfArrays(); ++i)
  {
    const char* name = a->GetArrayName(i);
    same = name && sameValues(a->GetArray(i), b->GetArray(name));
  }
  return same;
}

void passMissing(vtkFieldData* from, vtkFieldData* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    if (!isViewArray(array->GetName()) && !(array->GetName() && to->HasArray(array->GetName())))
    {
      to->AddArray(array);
    }
  }
}

} // namespace

std::vector<DrawnLine> ReadStrokes(vtkPolyData* strokes, int least)
{
  const vtkIdType count = strokes->GetNumberOfLines();
  if (count == 0 || count != strokes->GetNumberOfCells())
  {
    throw Error(Failure::BadStroke,
      "The stroke input must hold polylines and no other cells: a stroke is one polyline.");
  }
  std::vector<DrawnLine> lines(static_cast<std::size_t>(count));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    DrawnLine& line = lines[static_cast<std::size_t>(cell)];
    strokes->GetLines()->GetCellAtId(cell, ids);
    const vtkIdType size = ids->GetNumberOfIds();
    line.Closed = size > 3 && ids->GetId(0) == ids->GetId(size - 1);
    for (vtkIdType i = 0; i < (line.Closed ? size - 1 : size); ++i)
    {
      const vtkIdType id = ids->GetId(i);
      Vector3 p = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
      if (id >= 0 && id < strokes->GetNumberOfPoints())
      {
        strokes->GetPoint(id, p.data());
      }
      if (!p.head<2>().allFinite())
      {
        throw Error(Failure::BadStroke,
          Message::unusable(
            "Stroke", cell, { "sample %1 is not finite or does not exist; record the stroke again.", i }));
      }
      line.Ids.push_back(id);
      line.Samples.push_back(p.head<2>());
    }
    if (static_cast<int>(line.Samples.size()) < least)
    {
      throw Error(Failure::BadStroke,
        Message::unusable("Stroke",
          cell,
          { line.Samples.size() == 1 ? "it has %1 sample; at least %2 are needed: draw a longer stroke."
                                     : "it has %1 samples; at least %2 are needed: draw a longer stroke.",
            line.Samples.size(),
            least }));
    }
  }
  return lines;
}

void WriteView(const View& view, vtkPolyData* strokes)
{
  const auto add = [&](vtkDataArray* array, const std::vector<double>& values)
  {
    for (vtkIdType cell = 0; cell < strokes->GetNumberOfCells(); ++cell)
    {
      array->InsertNextTuple(values.data());
    }
    strokes->GetCellData()->AddArray(array);
  };
  const auto rows = [](const Eigen::Matrix4d& m)
  {
    std::vector<double> values(16);
    Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data()) = m;
    return values;
  };
  add(NewArray<vtkDoubleArray>("ViewTransform", 16), rows(view.viewTransform()));
  add(NewArray<vtkDoubleArray>("ProjectionTransform", 16), rows(view.projectionTransform()));
  add(NewArray<vtkIntArray>("ViewportSize", 2),
    { static_cast<double>(view.width()), static_cast<double>(view.height()) });
}

MeshKey CurvesKey(vtkPolyData* curves, const std::vector<const char*>& cellArrays)
{
  std::vector<vtkDataArray*> arrays{ curves->GetFieldData()->GetArray("Canvas") };
  for (int i = 0; i < curves->GetPointData()->GetNumberOfArrays(); ++i)
  {
    arrays.push_back(curves->GetPointData()->GetArray(i));
  }
  for (const char* name : cellArrays)
  {
    arrays.push_back(curves->GetCellData()->GetArray(name));
  }
  return MeshKey(curves, arrays);
}

Canvas CanvasOf(vtkPolyData* curves)
{
  vtkDataArray* array = curves->GetFieldData()->GetArray("Canvas");
  if (!array || array->GetNumberOfComponents() * array->GetNumberOfTuples() != 4)
  {
    throw Error(Failure::MissingArray,
      "The curves have no field array Canvas of four numbers: take them from vtkOversketchCanvas.");
  }
  double values[4];
  for (int i = 0; i < 4; ++i)
  {
    values[i] = array->GetComponent(i / array->GetNumberOfComponents(), i % array->GetNumberOfComponents());
  }
  Canvas canvas{ Vector2(values[0], values[1]), Vector2(values[2], values[3]) };
  if (!canvas.corner.allFinite() || !canvas.size.allFinite() || canvas.size.minCoeff() <= 0.0)
  {
    throw Error(Failure::BadStroke,
      "Field array Canvas has no extent or is not finite; it is x and y of the lower left corner, width and "
      "height.");
  }
  return canvas;
}

void WriteCanvas(const Canvas& canvas, vtkPolyData* curves)
{
  const auto array = NewArray<vtkDoubleArray>("Canvas", 4);
  const double values[4] = { canvas.corner[0], canvas.corner[1], canvas.size[0], canvas.size[1] };
  array->InsertNextTuple(values);
  curves->GetFieldData()->AddArray(array);
}

PicturePlace PlaceOf(vtkImageData* picture)
{
  const int* dimensions = picture->GetDimensions();
  if (dimensions[2] > 1)
  {
    throw Error(Failure::BadStroke, "The picture has %1 slices; give one slice across z.", dimensions[2]);
  }
  if (!picture->GetDirectionMatrix()->IsIdentity())
  {
    throw Error(Failure::BadStroke,
      "The picture's direction matrix is not the identity; resample the picture along the axes.");
  }
  PicturePlace place;
  const int* extent = picture->GetExtent();
  place.Spacing = Vector2(picture->GetSpacing());
  place.Origin = Vector2(picture->GetOrigin()) + place.Spacing.cwiseProduct(Vector2(extent[0], extent[2]));
  place.Columns = picture->GetNumberOfPoints() > 0 ? dimensions[0] : 0;
  place.Rows = dimensions[1];
  place.Rectangle = pictureCanvas(place.Origin, place.Spacing, place.Columns, place.Rows);
  return place;
}

double SampleSpacing(const Canvas& canvas)
{
  return 0.005 * canvas.longest();
}

bool HasLength(const Polyline& points)
{
  return std::any_of(points.begin(), points.end(), [&](const Vector2& p) { return p != points.front(); });
}

void WriteCurves(const std::vector<CanvasStroke>& curves, const Canvas& canvas, vtkPolyData* output)
{
  Polylines lines;
  std::vector<double> arcs;
  std::vector<int> ids;
  for (const CanvasStroke& curve : curves)
  {
    lines.Add(curve.points, curve.closed);
    const std::vector<double> lengths = arcLengths(curve.points);
    arcs.insert(arcs.end(), lengths.begin(), lengths.end());
    ids.push_back(static_cast<int>(ids.size()));
  }
  lines.Put(output);
  output->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("ArcLength", arcs));
  output->GetCellData()->AddArray(ArrayOf<vtkIntArray>("StrokeId", ids));
  output->GetCellData()->AddArray(ArrayOf<vtkIntArray>("Closed", curves, &CanvasStroke::closed));
  WriteCanvas(canvas, output);
}

void CarryPointArrays(vtkPolyData* input,
  const std::vector<DrawnLine>& curves,
  const std::vector<std::vector<Blend>>& places,
  vtkPolyData* output)
{
  vtkNew<vtkPointData> carried;
  vtkPointData* from = input->GetPointData();
  vtkPointData* to = output->GetPointData();
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    carried->CopyFieldOff(to->GetArrayName(i));
  }
  carried->InterpolateAllocate(from);
  vtkIdType id = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (const Blend& place : places[i])
    {
      carried->InterpolateEdge(from, id++, curves[i].Ids[place.from], curves[i].Ids[place.to], place.t);
    }
  }
  for (int i = 0; i < carried->GetNumberOfArrays(); ++i)
  {
    to->AddArray(carried->GetAbstractArray(i));
  }
}

void PassDrawingArrays(vtkPolyData* input, vtkPolyData* output)
{
  passMissing(input->GetCellData(), output->GetCellData());
  passMissing(input->GetFieldData(), output->GetFieldData());
}

vtkSmartPointer<vtkPolyData> StrokeAlone(vtkPolyData* strokes, vtkIdType cell)
{
  auto alone = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkIdList> ids;
  strokes->GetLines()->GetCellAtId(cell, ids);
  const vtkIdType count = ids->GetNumberOfIds();
  const bool closed = count > 2 && ids->GetId(0) == ids->GetId(count - 1);
  const vtkIdType samples = count - (closed ? 1 : 0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(count));
  alone->GetPointData()->CopyAllocate(strokes->GetPointData(), samples);
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (i < samples)
    {
      points->InsertNextPoint(strokes->GetPoint(ids->GetId(i)));
      alone->GetPointData()->CopyData(strokes->GetPointData(), ids->GetId(i), i);
    }
    lines->InsertCellPoint(i % samples);
  }
  alone->SetPoints(points);
  alone->SetLines(lines);
  alone->GetCellData()->CopyAllocate(strokes->GetCellData(), 1);
  alone->GetCellData()->CopyData(strokes->GetCellData(), cell, 0);
  alone->GetFieldData()->ShallowCopy(strokes->GetFieldData());
  return alone;
}

bool SameLines(vtkPolyData* a, vtkPolyData* b)
{
  bool same =
    a->GetNumberOfLines() == b->GetNumberOfLines() && a->GetNumberOfPoints() == b->GetNumberOfPoints() &&
    (a->GetNumberOfPoints() == 0 || sameValues(a->GetPoints()->GetData(), b->GetPoints()->GetData()));
  vtkNew<vtkIdList> ids, others;
  for (vtkIdType i = 0; same && i < a->GetNumberOfLines(); ++i)
  {
    a->GetLines()->GetCellAtId(i, ids);
    b->GetLines()->GetCellAtId(i, others);
    same = std::equal(ids->begin(), ids->end(), others->begin(), others->end());
  }
  return same && sameArrays(a->GetPointData(), b->GetPointData()) &&
         sameArrays(a->GetCellData(), b->GetCellData()) && sameArrays(a->GetFieldData(), b->GetFieldData());
}

} // namespace oversketch
