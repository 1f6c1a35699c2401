#include "vtkOversketchStellarTools.h"

#include "Stellar/leaves.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTypeUInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>
#include <sstream>
#include <type_traits>

namespace oversketch
{

namespace
{

const char* const cellNames[] = { "StellarRoot", "StellarPath", "StellarGen" };
const char* const pointNames[] = { "StellarMoved",
  "CurveId",
  "CurveParam",
  "BaseNormal",
  "Displacement",
  "Feature" };
const char* const fieldNames[] = { "StellarVersion", "CurveDigest" };
const char* const remedy =
  "a 4-8 mesh carries all its arrays (Filters/Stellar/README.md); make one with vtkOversketchStellarBase, or "
  "leave out the filter that dropped or changed them";

// Calls read(values, count) with the array's own type.
template <class Read>
void Typed(vtkDataArray* array, const Read& read)
{
  switch (array->GetDataType())
  {
    vtkTemplateMacro(read(static_cast<const VTK_TT*>(array->GetVoidPointer(0)), array->GetNumberOfValues()));
  }
}

// Whether a value is a whole number of another type, and which.
template <class Number, class Value>
bool Fits(Value value, Number& result)
{
  if constexpr (std::is_floating_point_v<Value>)
  {
    return false;
  }
  else if constexpr (sizeof(Value) < 8)
  {
    const double exact = static_cast<double>(value);
    const bool fits = exact >= static_cast<double>(std::numeric_limits<Number>::min()) &&
                      exact <= static_cast<double>(std::numeric_limits<Number>::max());
    result = fits ? static_cast<Number>(exact) : Number(0);
    return fits;
  }
  else
  {
    result = static_cast<Number>(value);
    return static_cast<Value>(result) == value && (value < Value(0)) == (result < Number(0));
  }
}

template <class Number>
std::vector<Number> WholeOf(vtkDataArray* array)
{
  std::vector<Number> result(static_cast<std::size_t>(array->GetNumberOfValues()));
  Typed(array,
    [&](const auto* values, vtkIdType count)
    {
      for (vtkIdType i = 0; i < count; ++i)
      {
        if (!Fits(values[i], result[static_cast<std::size_t>(i)]))
        {
          std::ostringstream message;
          message << "Value " << i << " of array " << array->GetName() << ", " << array->GetVariantValue(i)
                  << ", is no whole number of its kind: " << remedy << ".";
          throw Error(Failure::BadMesh, message.str());
        }
      }
    });
  return result;
}

std::vector<double> RealsOf(vtkDataArray* array)
{
  std::vector<double> result(static_cast<std::size_t>(array->GetNumberOfValues()));
  Typed(array,
    [&](const auto* values, vtkIdType count) {
      std::transform(values, values + count, result.begin(), [](auto x) { return static_cast<double>(x); });
    });
  return result;
}

std::vector<Vector3> VectorsOf(vtkDataArray* array)
{
  const std::vector<double> values = RealsOf(array);
  std::vector<Vector3> result(values.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    result[i] = Vector3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
  }
  return result;
}

Leaves LeavesOf(vtkPolyData* mesh)
{
  RequirePolygonsOnly(mesh);
  const vtkIdType points = mesh->GetNumberOfPoints(), cells = mesh->GetNumberOfCells();
  const auto ofCells = [&](int i)
  { return RequireArray(mesh->GetCellData(), cellNames[i], 1, cells, "mesh", remedy); };
  const auto ofPoints = [&](int i, int components)
  { return RequireArray(mesh->GetPointData(), pointNames[i], components, points, "mesh", remedy); };
  const auto optional = [&](int i)
  { return mesh->GetPointData()->GetAbstractArray(pointNames[i]) != nullptr; };
  Leaves leaves;
  leaves.root = WholeOf<int>(ofCells(0));
  leaves.path = WholeOf<std::uint64_t>(ofCells(1));
  leaves.gen = WholeOf<std::uint8_t>(ofCells(2));
  leaves.moved = WholeOf<std::uint8_t>(ofPoints(0, 1));
  leaves.curveId = WholeOf<int>(ofPoints(1, 1));
  leaves.curveParam = RealsOf(ofPoints(2, 1));
  if (optional(3))
  {
    leaves.baseNormal = VectorsOf(ofPoints(3, 3));
  }
  if (optional(4))
  {
    leaves.displacement = VectorsOf(ofPoints(4, 3));
  }
  if (optional(5))
  {
    leaves.feature = RealsOf(ofPoints(5, 1));
  }
  const auto version = WholeNumber(mesh->GetFieldData(), "StellarVersion");
  if (!version)
  {
    throw Error(
      Failure::MissingArray, std::string("The mesh has no field array StellarVersion: ") + remedy + ".");
  }
  if (*version != 1)
  {
    throw Error(Failure::BadMesh,
      "StellarVersion of the mesh is " + std::to_string(*version) +
        ", which this program cannot read; use a newer one, or drop the Stellar arrays.");
  }
  Mesh shape = MeshOf(mesh);
  leaves.points = std::move(shape.points);
  leaves.triangles = std::move(shape.triangles);
  return leaves;
}

struct Register
{
  std::mutex Mutex;
  std::vector<std::pair<MeshKey, std::weak_ptr<const Forest>>> Entries;

  std::shared_ptr<const Forest> Find(const MeshKey& key)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    for (const auto& [known, forest] : this->Entries)
    {
      auto found = known == key ? forest.lock() : nullptr;
      if (found)
      {
        return found;
      }
    }
    return nullptr;
  }
  void Add(const MeshKey& key, const std::shared_ptr<const Forest>& forest)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Entries.erase(
      std::remove_if(
        this->Entries.begin(), this->Entries.end(), [](const auto& entry) { return entry.second.expired(); }),
      this->Entries.end());
    this->Entries.emplace_back(key, forest);
  }
};

Register& TheRegister()
{
  static Register instance;
  return instance;
}

// Fills tuple i of a new array by fill(i, values).
template <class Array, class Fill>
vtkSmartPointer<Array> NewArray(const char* name, int components, std::size_t tuples, const Fill& fill)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  auto* values = array->GetPointer(0);
  vtkSMPTools::For(0,
    static_cast<vtkIdType>(tuples),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        fill(static_cast<std::size_t>(i), values + i * components);
      }
    });
  return array;
}

void Put(const Vector3& from, double* to)
{
  std::copy(from.data(), from.data() + 3, to);
}

void WritePoints(const Forest& forest, vtkPolyData* mesh)
{
  vtkNew<vtkPoints> places;
  places->SetData(NewArray<vtkDoubleArray>("Points",
    3,
    forest.vertices.size(),
    [&](std::size_t i, double* to) { Put(forest.vertices[i].position, to); }));
  mesh->SetPoints(places);
  const std::size_t points = forest.vertices.size();
  const auto& vertices = forest.vertices;
  vtkPointData* data = mesh->GetPointData();
  data->AddArray(NewArray<vtkUnsignedCharArray>(
    pointNames[0], 1, points, [&](std::size_t i, unsigned char* to) { *to = vertices[i].moved; }));
  data->AddArray(NewArray<vtkIntArray>(
    pointNames[1], 1, points, [&](std::size_t i, int* to) { *to = vertices[i].curveId; }));
  data->AddArray(NewArray<vtkDoubleArray>(
    pointNames[2], 1, points, [&](std::size_t i, double* to) { *to = vertices[i].curveParam; }));
  if (forest.hasBaseNormals)
  {
    data->AddArray(NewArray<vtkDoubleArray>(
      pointNames[3], 3, points, [&](std::size_t i, double* to) { Put(vertices[i].baseNormal, to); }));
  }
  if (!forest.displacement.empty())
  {
    data->AddArray(NewArray<vtkDoubleArray>(
      pointNames[4], 3, points, [&](std::size_t i, double* to) { Put(forest.displacement[i], to); }));
  }
  if (!forest.feature.empty())
  {
    data->AddArray(NewArray<vtkDoubleArray>(
      pointNames[5], 1, points, [&](std::size_t i, double* to) { *to = forest.feature[i]; }));
  }
}

void WriteCells(const Forest& forest, vtkPolyData* mesh)
{
  const auto& faces = forest.faces;
  const auto corners = NewArray<vtkIdTypeArray>(nullptr,
    3,
    faces.size(),
    [&](std::size_t i, vtkIdType* to) { std::copy(faces[i].v, faces[i].v + 3, to); });
  corners->SetNumberOfComponents(1);
  const auto offsets = NewArray<vtkIdTypeArray>(
    nullptr, 1, faces.size() + 1, [](std::size_t i, vtkIdType* to) { *to = 3 * static_cast<vtkIdType>(i); });
  vtkNew<vtkCellArray> polys;
  polys->SetData(offsets, corners);
  mesh->SetPolys(polys);
  vtkCellData* data = mesh->GetCellData();
  data->AddArray(NewArray<vtkIntArray>(
    cellNames[0], 1, faces.size(), [&](std::size_t i, int* to) { *to = faces[i].root; }));
  data->AddArray(NewArray<vtkTypeUInt64Array>(
    cellNames[1], 1, faces.size(), [&](std::size_t i, auto* to) { *to = faces[i].path; }));
  data->AddArray(NewArray<vtkUnsignedCharArray>(
    cellNames[2], 1, faces.size(), [&](std::size_t i, unsigned char* to) { *to = faces[i].gen; }));
}

// Whether the cells are as WriteCells would have them, where they say the same.
bool SharesCells(vtkPolyData* mesh)
{
  const int types[] = { VTK_INT, VTK_TYPE_UINT64, VTK_UNSIGNED_CHAR };
  for (int i = 0; i < 3; ++i)
  {
    vtkDataArray* array = mesh->GetCellData()->GetArray(cellNames[i]);
    if (!array || array->GetDataType() != types[i])
    {
      return false;
    }
  }
  return mesh->GetPolys()->IsStorage64Bit();
}

#ifndef NDEBUG
bool SameForest(const Forest& a, const Forest& b)
{
  const auto sameFace = [](const Forest::Face& x, const Forest::Face& y)
  {
    return x.path == y.path && x.root == y.root && x.gen == y.gen && std::equal(x.v, x.v + 3, y.v) &&
           std::equal(x.n, x.n + 3, y.n);
  };
  const auto sameVertex = [&](const Forest::Vertex& x, const Forest::Vertex& y)
  {
    return x.position == y.position && (!a.hasBaseNormals || x.baseNormal == y.baseNormal) &&
           x.curveParam == y.curveParam && x.curveId == y.curveId && x.level == y.level &&
           x.moved == y.moved && x.face == y.face && std::equal(x.parents, x.parents + 2, y.parents);
  };
  return a.rootCount == b.rootCount && a.hasBaseNormals == b.hasBaseNormals &&
         a.displacement == b.displacement && a.feature == b.feature &&
         std::equal(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(), sameFace) &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), sameVertex);
}
#endif

} // namespace

bool HasSnapped(const Forest& forest)
{
  return std::any_of(
    forest.vertices.begin(), forest.vertices.end(), [](const Forest::Vertex& v) { return v.curveId >= 0; });
}

bool IsStellarArray(const char* name)
{
  const auto same = [name](const char* other) { return name && std::string(name) == other; };
  return std::any_of(std::begin(cellNames), std::end(cellNames), same) ||
         std::any_of(std::begin(pointNames), std::end(pointNames), same) ||
         std::any_of(std::begin(fieldNames), std::end(fieldNames), same);
}

bool HasStellarArrays(vtkPolyData* mesh)
{
  return mesh->GetFieldData()->GetAbstractArray(fieldNames[0]) ||
         std::any_of(std::begin(cellNames),
           std::end(cellNames),
           [mesh](const char* name) { return mesh->GetCellData()->GetAbstractArray(name) != nullptr; });
}

MeshKey StellarKey(vtkPolyData* mesh)
{
  RequirePolygonsOnly(mesh);
  std::vector<vtkDataArray*> arrays;
  for (const char* name : cellNames)
  {
    arrays.push_back(mesh->GetCellData()->GetArray(name));
  }
  for (const char* name : pointNames)
  {
    arrays.push_back(mesh->GetPointData()->GetArray(name));
  }
  for (const char* name : fieldNames)
  {
    arrays.push_back(mesh->GetFieldData()->GetArray(name));
  }
  return MeshKey(mesh, arrays);
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

std::atomic<int>& ForestsRebuilt()
{
  static std::atomic<int> count{ 0 };
  return count;
}

std::shared_ptr<const Forest> SharedForest(vtkPolyData* mesh, const Context& context)
{
  const MeshKey key = StellarKey(mesh);
  if (auto found = TheRegister().Find(key))
  {
    return found;
  }
  auto forest = std::make_shared<const Forest>(rebuild(LeavesOf(mesh), context));
  ++ForestsRebuilt();
  TheRegister().Add(key, forest);
  return forest;
}

vtkSmartPointer<vtkPolyData> StellarPolyData(const std::shared_ptr<const Forest>& forest,
  const std::optional<std::uint64_t>& digest,
  vtkPolyData* alike)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  WritePoints(*forest, mesh);
  if (alike && SharesCells(alike))
  {
    mesh->SetPolys(alike->GetPolys());
    for (const char* name : cellNames)
    {
      mesh->GetCellData()->AddArray(alike->GetCellData()->GetArray(name));
    }
  }
  else
  {
    WriteCells(*forest, mesh);
  }
  mesh->GetFieldData()->AddArray(
    NewArray<vtkIntArray>(fieldNames[0], 1, 1, [](std::size_t, int* to) { *to = 1; }));
  if (digest)
  {
    mesh->GetFieldData()->AddArray(
      NewArray<vtkTypeUInt64Array>(fieldNames[1], 1, 1, [&](std::size_t, auto* to) { *to = *digest; }));
  }
  assert(SameForest(rebuild(LeavesOf(mesh), ThreadsOnly()), *forest));
  TheRegister().Add(StellarKey(mesh), forest);
  return mesh;
}

std::optional<std::uint64_t> WholeNumber(vtkFieldData* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array)
  {
    return std::nullopt;
  }
  if (array->GetNumberOfValues() != 1)
  {
    throw Error(Failure::MissingArray, std::string("Field array ") + name + " is to hold one whole number.");
  }
  return WholeOf<std::uint64_t>(array)[0];
}

void RequireFinite(double value, const char* name)
{
  if (!std::isfinite(value))
  {
    throw Error(Failure::BadStroke, std::string(name) + " is not a finite number; set another.");
  }
}

double LengthOf(double value, double otherwise, const char* name)
{
  RequireFinite(value, name);
  return value < 0.0 ? otherwise : value;
}

void AddText(std::vector<double>& values, const std::string& text)
{
  values.push_back(static_cast<double>(text.size()));
  values.insert(values.end(), text.begin(), text.end());
}

void StellarStep::Provide(const StepKey& key,
  vtkPolyData* input,
  vtkPolyData* output,
  const std::function<Made()>& make)
{
  if (!this->Stem || this->Key != key)
  {
    *this = StellarStep(); // so that nothing stale is left when making fails
    Made made = make();
    this->After = made.forest;
    this->Arrays = CarriedArrays(std::move(made.origins));
    this->Stem = StellarPolyData(this->After, made.digest, made.sameCells ? input : nullptr);
    this->Key = key;
  }
  output->ShallowCopy(this->Stem);
  this->Arrays.Carry(input, output);
}

void StellarStep::Provide(vtkPolyData* input,
  const std::vector<MeshKey>& otherInputs,
  const std::vector<double>& values,
  const FeatureCurves* curves,
  Motion motion,
  vtkPolyData* output,
  const Context& context,
  const Change& change)
{
  std::vector<MeshKey> inputs{ StellarKey(input) };
  inputs.insert(inputs.end(), otherInputs.begin(), otherInputs.end());
  this->Provide(StepKey(inputs, values),
    input,
    output,
    [&]
    {
      this->Before = SharedForest(input, context);
      const Forest& before = *this->Before;
      if (curves)
      {
        RequireSameCurves(input, before, *curves);
      }
      Made made;
      made.forest = std::make_shared<const Forest>(change(before));
      made.origins = originsOf(before, *made.forest, motion == Motion::Slide, motion == Motion::Rise);
      made.sameCells = before.faces.size() == made.forest->faces.size();
      if (HasSnapped(*made.forest))
      {
        made.digest = curves ? digest(*curves) : WholeNumber(input->GetFieldData(), "CurveDigest");
      }
      return made;
    });
}

} // namespace oversketch
