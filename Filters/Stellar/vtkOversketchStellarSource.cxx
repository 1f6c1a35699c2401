#include "vtkOversketchStellarSource.h"

#include "Stellar/refine.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchRegister.h"
#include "vtkOversketchStellarTools.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeUInt64Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <memory>
#include <string>

namespace oversketch
{

namespace
{

const char* const grayName = "TerrainGray";
const char* const rulesName = "TerrainRules";
constexpr int ruleCount = 10;
const char* const recordNames[] = { "SourceFaces",
  "SourceRecords",
  "SourceFlatPoints",
  "SourceFlat",
  "SourceOldFaces",
  "SourceRoots",
  "SourceDigest" };

} // namespace

HeightImage HeightsOf(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw Error(Failure::MissingArray, "The height image has no scalars; give it gray values, one a point.");
  }
  if (size[2] != 1)
  {
    throw Error(Failure::BadMesh, "The height image has %1 slices; one is needed, across z.", size[2]);
  }
  HeightImage result;
  result.width = size[0];
  result.height = size[1];
  result.spacing = Vector2(image->GetSpacing()[0], image->GetSpacing()[1]);
  result.samples.resize(static_cast<std::size_t>(image->GetNumberOfPoints()));
  const bool colour = scalars->GetNumberOfComponents() >= 3;
  for (std::size_t i = 0; i < result.samples.size(); ++i)
  {
    const auto at = [&](int component)
    { return scalars->GetComponent(static_cast<vtkIdType>(i), component); };
    result.samples[i] = colour ? 0.299 * at(0) + 0.587 * at(1) + 0.114 * at(2) : at(0);
  }
  return result;
}

void WriteTerrain(const HeightImage& image, const TerrainRules& rules, vtkPolyData* source)
{
  const auto numbers = NewArray<vtkDoubleArray>(rulesName);
  for (const double value : { static_cast<double>(image.width),
         static_cast<double>(image.height),
         image.spacing[0],
         image.spacing[1],
         static_cast<double>(rules.columns),
         static_cast<double>(rules.rows),
         rules.quad[0],
         rules.quad[1],
         rules.scale,
         rules.offset })
  {
    numbers->InsertNextValue(value);
  }
  source->SetPoints(vtkSmartPointer<vtkPoints>::New()); // readers of files complain where there are none
  source->GetFieldData()->AddArray(ArrayOf<vtkDoubleArray>(grayName, image.samples));
  source->GetFieldData()->AddArray(numbers);
}

namespace
{

enum class Kind
{
  None, // empty but for field data of others, as a base gives it that has no source
  Terrain,
  Records
};

Kind KindOf(vtkPolyData* source)
{
  const auto has = [source](const char* name)
  { return source && source->GetFieldData()->GetAbstractArray(name) != nullptr; };
  if (has(grayName) || has(rulesName))
  {
    return Kind::Terrain;
  }
  const bool records = std::any_of(std::begin(recordNames), std::end(recordNames), has);
  return records || (source && source->GetNumberOfPoints() > 0) ? Kind::Records : Kind::None;
}

// The arrays of a mesh that carries its source; null where it has none.
vtkSmartPointer<vtkPolyData> CarriedSource(vtkPolyData* mesh)
{
  vtkSmartPointer<vtkPolyData> source;
  for (const char* name : { grayName, rulesName })
  {
    if (vtkAbstractArray* array = mesh->GetFieldData()->GetAbstractArray(name))
    {
      source = source ? source : vtkSmartPointer<vtkPolyData>::New();
      source->GetFieldData()->AddArray(array);
    }
  }
  return source;
}

// Source of port 2, else what the mesh carries; null for none.
vtkSmartPointer<vtkPolyData> SourceDataOf(const CurveStep& step)
{
  return KindOf(step.third) == Kind::None ? CarriedSource(step.mesh)
                                          : vtkSmartPointer<vtkPolyData>(step.third);
}

Source TerrainSource(vtkPolyData* source)
{
  vtkDataArray* gray = source->GetFieldData()->GetArray(grayName);
  vtkDataArray* numbers = source->GetFieldData()->GetArray(rulesName);
  if (!gray || !numbers || numbers->GetNumberOfValues() != ruleCount || gray->GetNumberOfComponents() != 1)
  {
    throw Error(Failure::MissingArray,
      "The source lacks field array TerrainGray or TerrainRules, or one has another shape; pass output 1 of "
      "vtkOversketchTerrain as it is.");
  }
  double v[ruleCount];
  for (int i = 0; i < ruleCount; ++i)
  {
    v[i] = numbers->GetComponent(i / numbers->GetNumberOfComponents(), i % numbers->GetNumberOfComponents());
  }
  for (const int i : { 0, 1, 4, 5 })
  {
    if (!(v[i] >= 1.0 && v[i] <= 1e9 && v[i] == std::floor(v[i])))
    {
      throw Error(Failure::BadMesh,
        "Field array TerrainRules of the source has no count at %1; pass output 1 of vtkOversketchTerrain as "
        "it is.",
        i);
    }
  }
  HeightImage image;
  image.width = static_cast<int>(v[0]);
  image.height = static_cast<int>(v[1]);
  image.spacing = Vector2(v[2], v[3]);
  image.samples.resize(static_cast<std::size_t>(gray->GetNumberOfTuples()));
  for (std::size_t i = 0; i < image.samples.size(); ++i)
  {
    image.samples[i] = gray->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  TerrainRules rules;
  rules.columns = static_cast<int>(v[4]);
  rules.rows = static_cast<int>(v[5]);
  rules.quad = Vector2(v[6], v[7]);
  rules.scale = v[8];
  rules.offset = v[9];
  const auto terrain = std::make_shared<const Terrain>(std::move(image), rules);
  return [terrain](const SourcePlace& place)
  {
    const double z = terrain->heightAt(place.position[0], place.position[1]);
    return std::isfinite(z) ? Vector3(place.position[0], place.position[1], z) : place.position;
  };
}

vtkDataArray* RecordArray(vtkPolyData* source, const char* name, int components)
{
  vtkAbstractArray* array = source->GetFieldData()->GetAbstractArray(name);
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers || numbers->GetNumberOfComponents() != components)
  {
    throw Error(Failure::MissingArray,
      "The source %1 field array %2; pass output 1 of vtkOversketchStellarBase or vtkOversketchTerrain as it "
      "is.",
      (array ? "has another shape of" : "has no"),
      name);
  }
  return numbers;
}

template <class Tuple>
vtkSmartPointer<vtkIntArray> Integers(const char* name, int components, const std::vector<Tuple>& tuples)
{
  auto array = NewArray<vtkIntArray>(name, components, tuples.size());
  static_assert(sizeof(Tuple) % sizeof(int) == 0, "tuples of int");
  if (!tuples.empty())
  {
    std::memcpy(array->GetVoidPointer(0), tuples.data(), tuples.size() * sizeof(Tuple));
  }
  return array;
}

template <class Tuple>
std::vector<Tuple> IntegersOf(vtkPolyData* source, const char* name)
{
  constexpr std::size_t bytes = sizeof(Tuple);
  vtkDataArray* array = RecordArray(source, name, static_cast<int>(bytes / sizeof(int)));
  const std::vector<int> values = WholeNumbers(array);
  std::vector<Tuple> tuples(static_cast<std::size_t>(array->GetNumberOfTuples()));
  if (!tuples.empty())
  {
    std::memcpy(static_cast<void*>(tuples.data()), values.data(), tuples.size() * sizeof(Tuple));
  }
  return tuples;
}

// Digest of the records, with the triangles that they are of, but not of points, which may be moved with the
// mesh.
std::uint64_t DigestOf(const OriginalSurface& surface)
{
  std::uint64_t h = 0xcbf29ce484222325u;
  const auto add = [&h](const auto& values)
  {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    const std::size_t size = values.size() * sizeof(values[0]);
    for (std::size_t i = 0; i < size; i += sizeof(std::uint32_t)) // all are made of words of four bytes
    {
      std::uint32_t word = 0;
      std::memcpy(&word, bytes + i, sizeof word);
      h = (h ^ word) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
  };
  const Parametrisation& records = surface.records;
  add(records.faces);
  add(records.records);
  add(records.flatVertex);
  add(records.flat);
  add(records.oldFaces);
  add(surface.roots);
  return h;
}

Source RecordSource(vtkPolyData* source)
{
  const auto counts = IntegersOf<std::array<int, 3>>(source, recordNames[1]);
  vtkDataArray* flat = RecordArray(source, recordNames[3], 2);
  std::vector<Vector2> places(static_cast<std::size_t>(flat->GetNumberOfTuples()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    flat->GetTuple(static_cast<vtkIdType>(i), places[i].data());
  }
  auto surface = std::make_shared<OriginalSurface>();
  surface->records = readRecords(MeshOf(source),
    IntegersOf<Triangle>(source, recordNames[0]),
    counts,
    IntegersOf<int>(source, recordNames[4]),
    IntegersOf<int>(source, recordNames[2]),
    places);
  surface->roots = IntegersOf<SourceRoot>(source, recordNames[5]);
  checkRoots(*surface);
  const auto digest = WholeNumber(source->GetFieldData(), recordNames[6]);
  if (!digest || *digest != DigestOf(*surface))
  {
    throw Error(digest ? Failure::BadMesh : Failure::MissingArray,
      std::string("The source ") +
        (digest ? "has other records than its field array SourceDigest says"
                : "has no field array SourceDigest") +
        "; pass output 1 of vtkOversketchStellarBase as it is.");
  }
  return sourceOf(std::shared_ptr<const OriginalSurface>(std::move(surface)));
}

Register<Source>& TheSources()
{
  static Register<Source> instance;
  return instance;
}

} // namespace

std::shared_ptr<const Source> WriteSurface(const std::shared_ptr<const OriginalSurface>& surface,
  vtkPolyData* mesh,
  vtkPolyData* source)
{
  const Parametrisation& records = surface->records;
  std::vector<std::array<int, 3>> counts;
  counts.reserve(records.records.size());
  for (const Parametrisation::Record& record : records.records)
  {
    counts.push_back({ record.flatCount, record.oldCount, record.newCount });
  }
  vtkFieldData* data = source->GetFieldData();
  const std::vector<Triangle> made(records.faces.begin() + mesh->GetNumberOfPolys(), records.faces.end());
  data->AddArray(Integers(recordNames[0], 3, made));
  data->AddArray(Integers(recordNames[1], 3, counts));
  data->AddArray(Integers(recordNames[4], 1, records.oldFaces));
  data->AddArray(Integers(recordNames[2], 1, records.flatVertex));
  const auto flat = NewArray<vtkDoubleArray>(recordNames[3], 2, records.flat.size());
  for (std::size_t i = 0; i < records.flat.size(); ++i)
  {
    flat->SetTuple(static_cast<vtkIdType>(i), records.flat[i].data());
  }
  data->AddArray(flat);
  data->AddArray(Integers(recordNames[5], 4, surface->roots));
  data->AddArray(OneValue<vtkTypeUInt64Array>(recordNames[6], DigestOf(*surface)));
  source->SetPoints(mesh->GetPoints());
  source->SetPolys(mesh->GetPolys());
  auto shared = std::make_shared<const Source>(sourceOf(surface));
  TheSources().Add(WholeKey(source), shared);
  return shared;
}

std::shared_ptr<const Source> SharedSource(vtkPolyData* source)
{
  const Kind kind = KindOf(source);
  if (kind == Kind::None)
  {
    return nullptr;
  }
  const MeshKey key = WholeKey(source);
  std::shared_ptr<const Source> found = TheSources().Find(key);
  if (!found)
  {
    found =
      std::make_shared<const Source>(kind == Kind::Terrain ? TerrainSource(source) : RecordSource(source));
    TheSources().Add(key, found);
  }
  return found;
}

MeshKey SourceKey(const CurveStep& step)
{
  const vtkSmartPointer<vtkPolyData> source = SourceDataOf(step);
  return source ? WholeKey(source) : MeshKey();
}

Source SourceOf(const CurveStep& step, const Forest& forest, std::shared_ptr<const Source>& held)
{
  const std::shared_ptr<const Source> shared = SharedSource(SourceDataOf(step));
  held = shared;
  if (!shared)
  {
    return nullptr;
  }
  // What is displaced has left the source; of the rest one vertex that lies on it is enough, since filters in
  // between may have moved some.
  const double near = midpointRule(forest, nullptr, *shared).sourceTolerance;
  bool asked = false;
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    if (forest.vertices[v].level > 0 || forest.vertices[v].moved)
    {
      continue;
    }
    const SourcePlace at = forest.place(v);
    if (((*shared)(at)-at.position).norm() <= near)
    {
      return *shared;
    }
    asked = true;
  }
  if (asked && KindOf(step.third) == Kind::None)
  {
    return nullptr;
  }
  if (asked)
  {
    throw Error(Failure::BadMesh,
      "The source is that of another mesh: no point of the mesh's base lies on it. Connect output 1 of the "
      "filter that made the mesh, and move both where one is moved.");
  }
  return *shared;
}

} // namespace oversketch
