#include "vtkOversketchStellarTools.h"

#include "Stellar/leaves.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchRegister.h"

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
#include <limits>
#include <string>
#include <type_traits>

namespace oversketch
{

namespace
{

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
          throw Error(Failure::BadMesh,
            "Value %1 of array %2, %3, is no whole number of its kind: %4.",
            i,
            array->GetName(),
            array->GetVariantValue(i),
            remedy);
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
  { return RequireArray(mesh->GetCellData(), stellarCellArrays[i], 1, cells, "mesh", remedy); };
  const auto ofPoints = [&](int i, int components)
  { return RequireArray(mesh->GetPointData(), stellarPointArrays[i], components, points, "mesh", remedy); };
  const auto optional = [&](int i)
  { return mesh->GetPointData()->GetAbstractArray(stellarPointArrays[i]) != nullptr; };
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
      "StellarVersion of the mesh is %1, which this program cannot read; use a newer one, or drop the "
      "Stellar arrays.",
      *version);
  }
  Mesh shape = MeshOf(mesh);
  leaves.points = std::move(shape.points);
  leaves.triangles = std::move(shape.triangles);
  return leaves;
}

Register<Forest>& TheRegister()
{
  static Register<Forest> instance;
  return instance;
}

// Calls fill(i) for all numbers below the count, in threads.
template <class Fill>
void FillAll(std::size_t count, const Fill& fill)
{
  vtkSMPTools::For(0,
    static_cast<vtkIdType>(count),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        fill(static_cast<std::size_t>(i));
      }
    });
}

void Put(const Vector3& from, double* to)
{
  std::copy(from.data(), from.data() + 3, to);
}

// All arrays at once: a vertex is read from memory once. `curvesOf`: null, or a mesh whose CurveId and
// CurveParam are shared.
void WritePoints(const Forest& forest, vtkPolyData* mesh, vtkPolyData* curvesOf)
{
  const auto& vertices = forest.vertices;
  const std::size_t count = vertices.size();
  const auto positions = NewArray<vtkDoubleArray>("Points", 3, count);
  const auto moved = NewArray<vtkUnsignedCharArray>(stellarPointArrays[0], 1, count);
  const auto curves = curvesOf ? nullptr : NewArray<vtkIntArray>(stellarPointArrays[1], 1, count);
  const auto parameters = curvesOf ? nullptr : NewArray<vtkDoubleArray>(stellarPointArrays[2], 1, count);
  const auto optional = [count](bool present, const char* name, int components)
  { return present ? NewArray<vtkDoubleArray>(name, components, count) : nullptr; };
  const auto normals = optional(forest.hasBaseNormals, stellarPointArrays[3], 3);
  const auto displacements = optional(!forest.displacement.empty(), stellarPointArrays[4], 3);
  const auto features = optional(!forest.feature.empty(), stellarPointArrays[5], 1);
  const auto valuesOf = [](vtkDoubleArray* array) { return array ? array->GetPointer(0) : nullptr; };
  double *position = valuesOf(positions), *parameter = valuesOf(parameters), *normal = valuesOf(normals),
         *displacement = valuesOf(displacements), *feature = valuesOf(features);
  unsigned char* flags = moved->GetPointer(0);
  int* curve = curves ? curves->GetPointer(0) : nullptr;
  FillAll(count,
    [&](std::size_t i)
    {
      const Forest::Vertex& vertex = vertices[i];
      Put(vertex.position, position + 3 * i);
      flags[i] = vertex.moved;
      if (curve)
      {
        curve[i] = vertex.curveId;
        parameter[i] = vertex.curveParam;
      }
      if (normal)
      {
        Put(vertex.baseNormal, normal + 3 * i);
      }
      if (displacement)
      {
        Put(forest.displacement[i], displacement + 3 * i);
      }
      if (feature)
      {
        feature[i] = forest.feature[i];
      }
    });
  vtkNew<vtkPoints> places;
  places->SetData(positions);
  mesh->SetPoints(places);
  const auto shared = [curvesOf](int i)
  { return curvesOf ? curvesOf->GetPointData()->GetArray(stellarPointArrays[i]) : nullptr; };
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{
         moved, shared(1), shared(2), curves, parameters, normals, displacements, features })
  {
    if (array)
    {
      mesh->GetPointData()->AddArray(array);
    }
  }
}

void WriteCells(const Forest& forest, vtkPolyData* mesh)
{
  const auto& faces = forest.faces;
  const auto corners = NewArray<vtkIdTypeArray>(nullptr, 1, 3 * faces.size()),
             offsets = NewArray<vtkIdTypeArray>(nullptr, 1, faces.size() + 1);
  const auto roots = NewArray<vtkIntArray>(stellarCellArrays[0], 1, faces.size());
  const auto paths = NewArray<vtkTypeUInt64Array>(stellarCellArrays[1], 1, faces.size());
  const auto generations = NewArray<vtkUnsignedCharArray>(stellarCellArrays[2], 1, faces.size());
  vtkIdType *corner = corners->GetPointer(0), *offset = offsets->GetPointer(0);
  int* root = roots->GetPointer(0);
  vtkTypeUInt64* path = paths->GetPointer(0);
  unsigned char* generation = generations->GetPointer(0);
  FillAll(faces.size(),
    [&](std::size_t i)
    {
      const Forest::Face& face = faces[i];
      std::copy(face.v, face.v + 3, corner + 3 * i);
      offset[i] = 3 * static_cast<vtkIdType>(i);
      root[i] = face.root;
      path[i] = face.path;
      generation[i] = face.gen;
    });
  offset[faces.size()] = 3 * static_cast<vtkIdType>(faces.size());
  vtkNew<vtkCellArray> polys;
  polys->SetData(offsets, corners);
  mesh->SetPolys(polys);
  mesh->GetCellData()->AddArray(roots);
  mesh->GetCellData()->AddArray(paths);
  mesh->GetCellData()->AddArray(generations);
}

// Whether the cells are as WriteCells would have them, where they say the same.
bool SharesCells(vtkPolyData* mesh)
{
  const int types[] = { VTK_INT, VTK_TYPE_UINT64, VTK_UNSIGNED_CHAR };
  for (int i = 0; i < 3; ++i)
  {
    vtkDataArray* array = mesh->GetCellData()->GetArray(stellarCellArrays[i]);
    if (!array || array->GetDataType() != types[i])
    {
      return false;
    }
  }
  return mesh->GetPolys()->IsStorage64Bit();
}

// Whether points and their arrays are shared.
bool SharesPoints(vtkPolyData* mesh)
{
  const int types[] = { VTK_UNSIGNED_CHAR, VTK_INT, VTK_DOUBLE, VTK_DOUBLE, VTK_DOUBLE, VTK_DOUBLE };
  for (int i = 0; i < 6; ++i)
  {
    vtkDataArray* array = mesh->GetPointData()->GetArray(stellarPointArrays[i]);
    if (array ? array->GetDataType() != types[i] : i < 3)
    {
      return false;
    }
  }
  return mesh->GetPoints()->GetDataType() == VTK_DOUBLE;
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
  // Most are new vertices, which come last.
  return std::any_of(
    forest.vertices.rbegin(), forest.vertices.rend(), [](const Forest::Vertex& v) { return v.curveId >= 0; });
}

bool HasStellarArrays(vtkPolyData* mesh)
{
  return mesh->GetFieldData()->GetAbstractArray(stellarFieldArrays[0]) ||
         std::any_of(std::begin(stellarCellArrays),
           std::end(stellarCellArrays),
           [mesh](const char* name) { return mesh->GetCellData()->GetAbstractArray(name) != nullptr; });
}

MeshKey StellarKey(vtkPolyData* mesh)
{
  RequirePolygonsOnly(mesh);
  std::vector<vtkDataArray*> arrays;
  for (const char* name : stellarCellArrays)
  {
    arrays.push_back(mesh->GetCellData()->GetArray(name));
  }
  for (const char* name : stellarPointArrays)
  {
    arrays.push_back(mesh->GetPointData()->GetArray(name));
  }
  for (const char* name : stellarFieldArrays)
  {
    arrays.push_back(mesh->GetFieldData()->GetArray(name));
  }
  return MeshKey(mesh, arrays);
}

std::atomic<int>& ForestsRebuilt()
{
  static std::atomic<int> count{ 0 };
  return count;
}

Forest TakeForest(std::shared_ptr<const Forest>& forest)
{
  const std::shared_ptr<Forest> taken = TheRegister().Take(forest);
  return taken ? std::move(*taken) : Forest();
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
  vtkPolyData* alike,
  bool same,
  vtkPolyData* curvesOf)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  if (alike && same && SharesPoints(alike))
  {
    mesh->SetPoints(alike->GetPoints());
    for (const char* name : stellarPointArrays)
    {
      if (vtkDataArray* array = alike->GetPointData()->GetArray(name))
      {
        mesh->GetPointData()->AddArray(array);
      }
    }
  }
  else
  {
    WritePoints(*forest, mesh, curvesOf);
  }
  if (alike && SharesCells(alike))
  {
    mesh->SetPolys(alike->GetPolys());
    for (const char* name : stellarCellArrays)
    {
      mesh->GetCellData()->AddArray(alike->GetCellData()->GetArray(name));
    }
  }
  else
  {
    WriteCells(*forest, mesh);
  }
  mesh->GetFieldData()->AddArray(OneValue<vtkIntArray>(stellarFieldArrays[0], 1));
  if (digest)
  {
    mesh->GetFieldData()->AddArray(OneValue<vtkTypeUInt64Array>(stellarFieldArrays[1], *digest));
  }
  assert(ReachOf(mesh) > LargestCoordinate || SameForest(rebuild(LeavesOf(mesh), ThreadsOnly()), *forest));
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
    throw Error(Failure::MissingArray, "Field array %1 is to hold one whole number.", name);
  }
  return WholeOf<std::uint64_t>(array)[0];
}

std::vector<int> WholeNumbers(vtkDataArray* array)
{
  return WholeOf<int>(array);
}

double LengthOf(double value, double share, const Forest& forest, const char* name)
{
  RequireFinite(value, name);
  return value < 0.0 ? share * forest.diagonal() : value;
}

std::vector<int> PartsOf(vtkPolyData* mesh, const Forest& forest)
{
  vtkCellData* cells = mesh->GetCellData();
  if (!cells->GetArray("Chart"))
  {
    return {};
  }
  const std::vector<int> charts = WholeNumbers(
    RequireArray(cells, "Chart", 1, mesh->GetNumberOfCells(), "mesh", "one chart number per triangle"));
  const std::vector<int> roots = WholeNumbers(
    RequireArray(cells, "StellarRoot", 1, mesh->GetNumberOfCells(), "mesh", "the steps carry it"));
  std::vector<int> parts(static_cast<std::size_t>(forest.rootCount), 0);
  for (std::size_t f = charts.size(); f-- > 0;)
  {
    parts[roots[f]] = charts[f];
  }
  return parts;
}

MeshKey PartsKey(vtkPolyData* mesh)
{
  return MeshKey(mesh, { mesh->GetCellData()->GetArray("Chart") });
}

namespace
{

Register<Raised>& TheRaised()
{
  static Register<Raised> instance;
  return instance;
}

} // namespace

void AddRaised(vtkPolyData* mesh, const std::shared_ptr<const Raised>& raised)
{
  TheRaised().Add(StellarKey(mesh), raised);
}

std::shared_ptr<const Raised> RaisedOf(vtkPolyData* mesh)
{
  return TheRaised().Find(StellarKey(mesh));
}

} // namespace oversketch
