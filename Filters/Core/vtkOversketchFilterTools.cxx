#include "vtkOversketchFilterTools.h"
#include "vtkOversketchCarriedArrays.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationStringVectorKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>

namespace oversketch
{

namespace
{

Eigen::Matrix4d MatrixOf(vtkDataArray* array)
{
  Eigen::Matrix4d m;
  for (int i = 0; i < 16; ++i)
  {
    m(i / 4, i % 4) = array->GetComponent(0, i);
  }
  return m;
}

// vtkAlgorithm keeps SetErrorCode to its heirs; naming it through one makes it reachable from here.
struct ErrorCodeAccess : vtkAlgorithm
{
  static void Set(vtkAlgorithm* self, unsigned long code) { (self->*&ErrorCodeAccess::SetErrorCode)(code); }
};

// The message that an event of this thread tells, for as long as it does.
class Told
{
public:
  explicit Told(const Message& message)
    : Before(Now)
  {
    Now = &message;
  }
  ~Told() { Now = this->Before; }
  Told(const Told&) = delete;
  Told& operator=(const Told&) = delete;
  static const Message* now() { return Now; }

private:
  const Message* Before;
  static thread_local const Message* Now;
};
thread_local const Message* Told::Now = nullptr;

void Fail(vtkAlgorithm* self, Failure failure, const Message& message)
{
  if (failure != Failure::Cancelled)
  {
    const Told told(message);
    vtkErrorWithObjectMacro(self, << message.text());
  }
  ErrorCodeAccess::Set(self, vtkErrorCode::UserError + static_cast<unsigned long>(failure));
  for (int port = 0; port < self->GetNumberOfOutputPorts(); ++port)
  {
    if (vtkDataObject* output = self->GetOutputDataObject(port))
    {
      output->Initialize();
    }
  }
}

// Calls convert(i) for all of [0, count), in threads; returns the first one that it refused, or count.
template <class Convert>
vtkIdType FirstRefused(vtkIdType count, const Convert& convert)
{
  std::atomic<vtkIdType> first{ count };
  vtkSMPTools::For(0,
    count,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType i = begin;
      while (i < end && convert(i))
      {
        ++i;
      }
      vtkIdType known = first;
      while (i < end && i < known && !first.compare_exchange_weak(known, i))
      {
      }
    });
  return first;
}

std::vector<Vector3> PointsOf(vtkPolyData* polyData)
{
  std::vector<Vector3> points(static_cast<std::size_t>(polyData->GetNumberOfPoints()));
  if (points.empty())
  {
    return points;
  }
  vtkDataArray* array = polyData->GetPoints()->GetData();
  const auto convert = [&points](const auto* values)
  {
    return FirstRefused(static_cast<vtkIdType>(points.size()),
      [&points, values](vtkIdType i)
      {
        Vector3& point = points[static_cast<std::size_t>(i)];
        point = Vector3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
        return std::abs(point[0]) <= LargestCoordinate && std::abs(point[1]) <= LargestCoordinate &&
               std::abs(point[2]) <= LargestCoordinate;
      });
  };
  vtkIdType bad = 0;
  if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(array))
  {
    bad = convert(floats->GetPointer(0));
  }
  else if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array))
  {
    bad = convert(doubles->GetPointer(0));
  }
  else
  {
    vtkNew<vtkDoubleArray> copy;
    copy->DeepCopy(array);
    bad = convert(copy->GetPointer(0));
  }
  if (bad < polyData->GetNumberOfPoints())
  {
    throw Error(Failure::BadMesh,
      points[static_cast<std::size_t>(bad)].allFinite()
        ? "Point %1 of the mesh lies beyond %2, the largest coordinate that is taken; scale the mesh."
        : "Point %1 of the mesh is not finite; repair or remove it.",
      bad,
      LargestCoordinate);
  }
  return points;
}

std::vector<Triangle> TrianglesOf(vtkPolyData* polyData)
{
  const vtkIdType points = polyData->GetNumberOfPoints();
  vtkCellArray* polys = polyData->GetPolys();
  std::vector<Triangle> triangles(static_cast<std::size_t>(polys->GetNumberOfCells()));
  const auto convert = [&triangles, points](const auto* offsets, const auto* ids)
  {
    return FirstRefused(static_cast<vtkIdType>(triangles.size()),
      [&triangles, points, offsets, ids](vtkIdType i)
      {
        Triangle& triangle = triangles[static_cast<std::size_t>(i)];
        bool good = offsets[i + 1] - offsets[i] == 3;
        for (int k = 0; good && k < 3; ++k)
        {
          const vtkIdType id = ids[offsets[i] + k];
          triangle[k] = static_cast<int>(id);
          good = id >= 0 && id < points;
        }
        return good;
      });
  };
  const vtkIdType bad =
    polys->IsStorage64Bit()
      ? convert(polys->GetOffsetsArray64()->GetPointer(0), polys->GetConnectivityArray64()->GetPointer(0))
      : convert(polys->GetOffsetsArray32()->GetPointer(0), polys->GetConnectivityArray32()->GetPointer(0));
  if (bad < polys->GetNumberOfCells())
  {
    throw Error(Failure::BadMesh,
      "Cell %1 of the mesh %2",
      bad,
      (polys->GetCellSize(bad) == 3 ? "names a point that does not exist; repair the mesh."
                                    : "is not a triangle; pass the mesh through vtkTriangleFilter."));
  }
  return triangles;
}

} // namespace

int RunFilter(vtkAlgorithm* self, const std::function<void()>& body)
{
  ErrorCodeAccess::Set(self, vtkErrorCode::NoError);
  self->SetAbortExecute(0); // VTK 9.1's executive has done that, 9.3's leaves a flag set after the last run
  try
  {
    body();
    if (!self->GetAbortExecute())
    {
      return 1;
    }
    // Set after the body last looked at it, if it looks at all: a cancelled filter has no output all the
    // same.
    Fail(self, Failure::Cancelled, "cancelled");
  }
  catch (const Error& error)
  {
    Fail(self, error.failure(), error.message());
  }
  catch (const std::bad_alloc&)
  {
    Fail(self, Failure::Unexpected, "Out of memory; use a smaller mesh.");
  }
  catch (const std::exception& error)
  {
    Fail(self, Failure::Unexpected, { "Unexpected failure: %1", error.what() });
  }
  return 0;
}

void DeclareInput(vtkAlgorithm* self, int port, const std::vector<Port>& is)
{
  vtkInformation* information = self->GetInputPortInformation(port);
  for (const Port one : is)
  {
    if (one == Port::Image)
    {
      information->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
      information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
    }
    else
    {
      information->Set(
        one == Port::Optional ? vtkAlgorithm::INPUT_IS_OPTIONAL() : vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
    }
  }
}

void DeclareOutput(vtkAlgorithm* self, int port, const std::vector<Port>& is)
{
  const bool isImage = std::find(is.begin(), is.end(), Port::Image) != is.end();
  self->GetOutputPortInformation(port)->Set(
    vtkDataObject::DATA_TYPE_NAME(), isImage ? "vtkImageData" : "vtkPolyData");
}

void Warn(vtkObject* self, const Message& message)
{
  const Told told(message);
  vtkWarningWithObjectMacro(self, << message.text());
}

Message MessageOf(const void* eventData)
{
  if (Told::now())
  {
    return *Told::now();
  }
  std::string text = eventData ? static_cast<const char*>(eventData) : "";
  const std::size_t marker = text.find("): ");
  if (marker != std::string::npos)
  {
    text.erase(0, marker + 3);
  }
  text.erase(text.find_last_not_of(" \n") + 1);
  return text;
}

Context ThreadsOnly()
{
  Context context;
  context.parallelFor = [](int count, const Context::Body& body)
  {
    vtkSMPTools::For(0,
      count,
      [&body](vtkIdType begin, vtkIdType end) { body(static_cast<int>(begin), static_cast<int>(end)); });
  };
  return context;
}

void SetText(vtkAlgorithm* self, std::string& value, const char* text)
{
  const std::string wanted = text ? text : "";
  if (wanted != value)
  {
    value = wanted;
    self->Modified();
  }
}

Context ContextOf(vtkAlgorithm* self, double from, double to)
{
  Context context = ThreadsOnly();
  // Parts of a step may overlap; what is shown never falls back.
  context.progress = [self, from, to](double done)
  { self->UpdateProgress(std::max(self->GetProgress(), from + done * (to - from))); };
  context.cancelled = [self] { return self->GetAbortExecute() != 0; };
  return context;
}

void RequirePolygonsOnly(vtkPolyData* polyData)
{
  if (polyData->GetNumberOfVerts() + polyData->GetNumberOfLines() + polyData->GetNumberOfStrips() > 0)
  {
    throw Error(Failure::BadMesh,
      "The mesh holds vertices, lines or strips besides polygons; pass it through vtkTriangleFilter with "
      "PassVerts and PassLines off.");
  }
}

MeshWork& MeshWorkDone()
{
  static MeshWork work;
  return work;
}

double ReachOf(vtkPolyData* polyData)
{
  double bounds[6];
  polyData->GetPoints()->GetBounds(bounds);
  double reach = 0.0;
  for (const double bound : bounds)
  {
    reach = std::max(reach, std::abs(bound));
  }
  return reach;
}

Mesh MeshOf(vtkPolyData* polyData)
{
  RequirePolygonsOnly(polyData);
  ++MeshWorkDone().Conversions;
  return { PointsOf(polyData), TrianglesOf(polyData) };
}

View ViewOf(vtkPolyData* stroke)
{
  const vtkIdType cells = stroke->GetNumberOfCells();
  if (cells == 0)
  {
    throw Error(Failure::BadStroke, "There is no stroke: the stroke input holds no polyline.");
  }
  const std::string remedy = "a stroke carries the view it was drawn in, see the stroke format";
  vtkCellData* data = stroke->GetCellData();
  vtkDataArray* arrays[3] = { RequireArray(data, "ViewTransform", 16, cells, "stroke", remedy),
    RequireArray(data, "ProjectionTransform", 16, cells, "stroke", remedy),
    RequireArray(data, "ViewportSize", 2, cells, "stroke", remedy) };
  for (vtkDataArray* array : arrays)
  {
    for (vtkIdType cell = 1; cell < cells; ++cell)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        if (array->GetComponent(cell, c) != array->GetComponent(0, c))
        {
          throw Error(Failure::BadStroke,
            "Strokes 0 and %1 carry different views (array %2); give strokes of one view.",
            cell,
            array->GetName());
        }
      }
    }
  }
  for (int k = 0; k < 2; ++k)
  {
    if (!(arrays[2]->GetComponent(0, k) <= 1e6))
    {
      throw Error(Failure::BadStroke,
        "The stroke's ViewportSize is larger than a million pixels; record the stroke again.");
    }
  }
  return View(MatrixOf(arrays[0]),
    MatrixOf(arrays[1]),
    static_cast<int>(arrays[2]->GetComponent(0, 0)),
    static_cast<int>(arrays[2]->GetComponent(0, 1)));
}

std::vector<Vector2> StrokeOf(vtkPolyData* stroke)
{
  if (stroke->GetNumberOfCells() != 1 || stroke->GetNumberOfLines() != 1)
  {
    throw Error(Failure::BadStroke,
      "The stroke input holds %1 polylines and %2 other cells; exactly one polyline is needed.",
      stroke->GetNumberOfLines(),
      stroke->GetNumberOfCells() - stroke->GetNumberOfLines());
  }
  vtkNew<vtkIdList> ids;
  stroke->GetLines()->GetCellAtId(0, ids);
  std::vector<Vector2> samples;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    Vector3 p = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
    if (ids->GetId(i) >= 0 && ids->GetId(i) < stroke->GetNumberOfPoints())
    {
      stroke->GetPoint(ids->GetId(i), p.data());
    }
    samples.push_back(p.head<2>());
    if (!samples.back().allFinite())
    {
      throw Error(Failure::BadStroke,
        "Sample %1 of the stroke is not finite or does not exist; record the stroke again.",
        i);
    }
  }
  if (samples.size() < 2)
  {
    throw Error(Failure::BadStroke, "The stroke has fewer than two samples; draw a longer one.");
  }
  return samples;
}

Vector2 MovedOf(vtkPolyData* stroke)
{
  vtkDataArray* array = stroke->GetCellData()->GetArray("Moved");
  Vector2 moved = Vector2::Zero();
  if (array && array->GetNumberOfComponents() == 2 && array->GetNumberOfTuples() == 1)
  {
    array->GetTuple(0, moved.data());
  }
  else if (array)
  {
    moved[0] = std::numeric_limits<double>::quiet_NaN();
  }
  if (!moved.allFinite())
  {
    throw Error(Failure::BadStroke,
      "Cell array Moved of the stroke must be two finite numbers, in pixels; remove it or draw the stroke "
      "again.");
  }
  return moved;
}

vtkDataArray* RequireArray(vtkDataSetAttributes* attributes,
  const char* name,
  int components,
  vtkIdType tuples,
  const std::string& holder,
  const std::string& remedy)
{
  vtkDataArray* array = attributes->GetArray(name);
  if (!array)
  {
    throw Error(Failure::MissingArray,
      holder.back() == 's' ? "The %1 have no array %2: %3." : "The %1 has no array %2: %3.",
      holder,
      name,
      remedy);
  }
  if (array->GetNumberOfComponents() != components || (tuples >= 0 && array->GetNumberOfTuples() != tuples))
  {
    throw Error(Failure::MissingArray,
      tuples >= 0 ? "Array %1 of the %2 has %3 tuples of %4 components; %7 of %5 are needed: %6."
                  : "Array %1 of the %2 has %3 tuples of %4 components; tuples of %5 are needed: %6.",
      name,
      holder,
      array->GetNumberOfTuples(),
      array->GetNumberOfComponents(),
      components,
      remedy,
      tuples);
  }
  return array;
}

vtkDataArray* OptionalArray(vtkDataSetAttributes* attributes,
  const char* name,
  int components,
  vtkIdType tuples,
  const std::string& holder,
  const std::string& remedy)
{
  return attributes->HasArray(name) ? RequireArray(attributes, name, components, tuples, holder, remedy)
                                    : nullptr;
}

void RequireFinite(double value, const char* name)
{
  if (!std::isfinite(value))
  {
    throw Error(Failure::BadStroke, "{%1} is not a finite number; set another.", name);
  }
}

std::vector<char> LabelsOf(vtkDataArray* labels)
{
  std::vector<char> chosen(static_cast<std::size_t>(labels->GetNumberOfTuples()));
  if (auto* bytes = vtkAOSDataArrayTemplate<unsigned char>::FastDownCast(labels);
      bytes && bytes->GetNumberOfComponents() == 1)
  {
    std::transform(bytes->GetPointer(0),
      bytes->GetPointer(0) + chosen.size(),
      chosen.begin(),
      [](unsigned char label) { return static_cast<char>(label != 0); });
    return chosen;
  }
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    chosen[static_cast<std::size_t>(i)] = labels->GetComponent(i, 0) != 0.0;
  }
  return chosen;
}

MeshKey::MeshKey(vtkPolyData* mesh, const std::vector<vtkDataArray*>& arrays)
{
  const auto add = [this](vtkObject* object)
  { this->Key.emplace_back(object, object ? object->GetMTime() : vtkMTimeType(0)); };
  add(mesh->GetPoints());
  for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    add(cells);
  }
  for (vtkDataArray* array : arrays)
  {
    add(array);
  }
}

MeshKey WholeKey(vtkPolyData* data)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkFieldData* of : { static_cast<vtkFieldData*>(data->GetPointData()),
         static_cast<vtkFieldData*>(data->GetCellData()),
         data->GetFieldData() })
  {
    for (int i = 0; i < of->GetNumberOfArrays(); ++i)
    {
      arrays.push_back(of->GetArray(i));
    }
  }
  return MeshKey(data, arrays);
}

std::vector<vtkDataArray*> ViewArraysOf(vtkPolyData* strokes, const std::vector<const char*>& others)
{
  std::vector<const char*> names{ "ViewTransform", "ProjectionTransform", "ViewportSize" };
  names.insert(names.end(), others.begin(), others.end());
  std::vector<vtkDataArray*> arrays;
  for (const char* name : names)
  {
    vtkDataArray* array = strokes->GetCellData()->GetArray(name);
    if (array && array->GetNumberOfTuples() == strokes->GetNumberOfCells())
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

View ViewOfStroke(vtkPolyData* strokes, vtkIdType stroke)
{
  vtkNew<vtkPolyData> one;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ points->InsertNextPoint(0.0, 0.0, 0.0) });
  one->SetPoints(points);
  one->SetLines(lines);
  for (vtkDataArray* array : ViewArraysOf(strokes))
  {
    one->GetCellData()->AddArray(CarriedArray(array, std::vector<vtkIdType>{ stroke }));
  }
  try
  {
    return ViewOf(one);
  }
  catch (const Error& error)
  {
    throw Error(error.failure(), Message::unusable("Stroke", stroke, error.message()));
  }
}

double FieldValue(vtkDataObject* object,
  const char* name,
  const std::string& holder,
  const std::string& remedy)
{
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  const bool single = array && array->GetNumberOfTuples() == 1 && array->GetNumberOfComponents() == 1;
  const double value = single ? array->GetComponent(0, 0) : 0.0;
  if (!(value > 0.0) || !std::isfinite(value))
  {
    throw Error(Failure::MissingArray,
      "Field array %1 of the %2 must hold one positive value: %3.",
      name,
      holder,
      remedy);
  }
  return value;
}

} // namespace oversketch
