#include "vtkOversketchRetriangulate.h"

#include "Remesh/retriangulate.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

using namespace oversketch;

struct vtkOversketchRetriangulate::Cache
{
  KeptOutput Kept;
  std::shared_ptr<const Motion> Known; // held, so that another one has another address
  std::shared_ptr<const MeshData> Rest;

  void Make(vtkOversketchRetriangulate* self,
    vtkPolyData* mesh,
    vtkPolyData* rest,
    vtkPolyData* const (&curves)[2],
    const KeptOutput::Outputs& made);
};

namespace
{

const char* const sizeName = "EdgeLength";

std::vector<double> sizesOf(vtkPolyData* mesh)
{
  std::vector<double> sizes;
  if (mesh->GetPointData()->HasArray(sizeName))
  {
    const vtkIdType count = mesh->GetNumberOfPoints();
    vtkDataArray* lengths =
      RequireArray(mesh->GetPointData(), sizeName, 1, count, "mesh", "remove it, and MeanEdge counts");
    for (vtkIdType i = 0; i < count; ++i)
    {
      sizes.push_back(lengths->GetComponent(i, 0));
      if (!(sizes.back() > 0.0 && std::isfinite(sizes.back())))
      {
        throw Error(Failure::BadMesh,
          "Vertex %1 of the mesh has EdgeLength %2, which is no positive length: remove the array, and "
          "MeanEdge counts.",
          i,
          sizes.back());
      }
    }
  }
  return sizes;
}

std::shared_ptr<const MeshData> restOf(vtkPolyData* rest, const Mesh& moved)
{
  if (!rest || rest->GetNumberOfPoints() == 0)
  {
    throw Error(Failure::BadMesh,
      "{Rule Edit} needs the mesh before the edit: connect it to input Rest, or set the rule to Curvature.");
  }
  std::shared_ptr<const MeshData> data = SharedMesh(rest);
  if (data->Surface().triangles != moved.triangles || data->Surface().points.size() != moved.points.size())
  {
    throw Error(Failure::BadMesh,
      "The mesh before the edit (input Rest) has other triangles than the mesh: connect what the edit "
      "moved.");
  }
  return data;
}

const char* const regionName = "EditRegion";

// Writes the new triangles with the arrays of the mesh as it was: floating point arrays mixed (active normals
// normalised), others from the vertex of largest weight, EditRegion 2 where a vertex that it is mixed of has
// that; cell arrays from the triangle below. Field data is passed, global ids and the arrays of a 4-8 mesh
// are dropped.
void WriteRetriangulated(const Retriangulated& result, vtkPolyData* mesh, vtkPolyData* output)
{
  std::vector<std::size_t> numbers(result.pointSource.size(), 0); // of the mixes
  std::size_t count = 0;
  for (std::size_t v = 0; v < numbers.size(); ++v)
  {
    numbers[v] = count;
    count += result.pointSource[v] < 0;
  }
  const auto mixOf = [&](vtkIdType point) -> const Mix&
  { return result.mixes[numbers[static_cast<std::size_t>(point)]]; };
  vtkDataArray* labels = mesh->GetPointData()->GetArray(regionName);
  const auto inside = [&, one = Mix(1)](vtkIdType point) mutable -> const Mix&
  {
    const Mix& mix = mixOf(point);
    const auto found = std::find_if(mix.begin(),
      mix.end(),
      [labels](const auto& entry) { return labels->GetComponent(entry.first, 0) == EditLabel::Inside; });
    if (found == mix.end())
    {
      return mix;
    }
    one[0] = *found;
    return one;
  };
  WriteCarried(
    result.mesh, { result.pointSource, mixOf, regionName, inside }, result.triangleSource, mesh, output);
}

// Writes curves with their vertices' new ids and places; `first` is the number of the first one in the
// result. Floating arrays of new points lie between their neighbours', others are the nearer one's; cell and
// field data is passed.
void WriteChains(const Retriangulated& result,
  std::size_t first,
  const std::vector<Chain>& chains,
  vtkPolyData* curves,
  vtkPolyData* output)
{
  struct Source // of a point: between two of the input's
  {
    vtkIdType a, b;
    double t;
    bool closes; // b is the first of a closed curve
    int vertex;
  };
  std::vector<Source> sources;
  vtkNew<vtkPoints> points;
  points->SetDataType(curves->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> lines;
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    const std::vector<CurveVertex>& curve = result.curves[first + i];
    const std::vector<vtkIdType>& ids = chains[i].Ids;
    const bool closed = ids.size() > 2 && ids.front() == ids.back();
    const vtkIdType begin = points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(curve.size()));
    for (std::size_t k = 0; k < curve.size(); ++k)
    {
      if (closed && k + 1 == curve.size())
      {
        lines->InsertCellPoint(begin);
        continue;
      }
      const std::size_t from = static_cast<std::size_t>(curve[k].from);
      const std::size_t to = std::min(from + 1, ids.size() - 1);
      sources.push_back({ ids[from], ids[to], curve[k].t, closed && to + 1 == ids.size(), curve[k].vertex });
      lines->InsertCellPoint(points->InsertNextPoint(result.mesh.points[curve[k].vertex].data()));
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  const auto made = [&](vtkAbstractArray* array, bool)
  {
    auto carried = LikeArray(array, sources.size());
    auto* numbers = vtkDataArray::SafeDownCast(carried);
    for (std::size_t k = 0; k < sources.size(); ++k)
    {
      const Source& source = sources[k];
      const vtkIdType point = static_cast<vtkIdType>(k);
      if (IsNamed(array, "VertexId"))
      {
        numbers->SetComponent(point, 0, source.vertex);
      }
      else if (IsMixable(array) && source.t > 0.0)
      {
        carried->InterpolateTuple(point, source.a, array, source.b, array, source.t);
        if (source.closes && IsNamed(array, "CurveT"))
        {
          // The curve's first point, 0, is also its end, 1.
          const double before = vtkDataArray::SafeDownCast(array)->GetComponent(source.a, 0);
          numbers->SetComponent(point, 0, before + source.t * (1.0 - before));
        }
      }
      else
      {
        carried->SetTuple(point, source.t < 0.5 ? source.a : source.b, array);
      }
    }
    return carried;
  };
  CarryArrays(curves->GetPointData(), output->GetPointData(), made);
  output->GetCellData()->PassData(curves->GetCellData());
  output->GetFieldData()->PassData(curves->GetFieldData());
}

} // namespace

void vtkOversketchRetriangulate::Cache::Make(vtkOversketchRetriangulate* self,
  vtkPolyData* mesh,
  vtkPolyData* rest,
  vtkPolyData* const (&curves)[2],
  const KeptOutput::Outputs& made)
{
  ++self->RetriangulationCount;
  const double meanEdge =
    FieldValue(mesh, "MeanEdge", "mesh", "pass the mesh through vtkOversketchMeanEdge when it is loaded");
  const std::vector<char> region = ReadEditRegion(mesh), left = MaskedPointsOf(mesh);
  const std::shared_ptr<const MeshData> moved = SharedMesh(mesh);
  const int count = moved->Surface().vertexCount();
  const std::vector<Chain> chains[2] = { ReadChains(curves[0], count, "reference curve"),
    ReadChains(curves[1], count, "boundary curve") };
  std::vector<std::vector<int>> vertices;
  for (const std::vector<Chain>& some : chains)
  {
    for (const Chain& chain : some)
    {
      vertices.push_back(chain.Vertices);
    }
  }
  const bool asFloats = mesh->GetPoints()->GetDataType() != VTK_DOUBLE;
  Retriangulated result;
  if (self->Rule == Curvature)
  {
    result = retriangulateByCurvature(
      { moved->Surface(), moved->Surface().points, region, vertices, meanEdge, asFloats, {}, left },
      ContextOf(self));
  }
  else
  {
    this->Rest = restOf(rest, moved->Surface());
    const Mesh& before = this->Rest->Surface();
    const Motion motion =
      self->Known ? *self->Known
                  : motionBetween(before, this->Rest->Neighbours(), moved->Surface().points, ContextOf(self));
    result = retriangulateEdit(
      { before, moved->Surface().points, region, vertices, meanEdge, asFloats, sizesOf(mesh), left },
      motion,
      ContextOf(self));
  }
  self->OperationCount = result.splits + result.collapses + result.flips;
  if (self->OperationCount == 0 && result.mixes.empty())
  {
    made[0]->ShallowCopy(mesh);
    made[1]->ShallowCopy(curves[0]);
    made[2]->ShallowCopy(curves[1]);
  }
  else
  {
    WriteRetriangulated(result, mesh, made[0]);
    WriteChains(result, 0, chains[0], curves[0], made[1]);
    WriteChains(result, chains[0].size(), chains[1], curves[1], made[2]);
  }
}

vtkStandardNewMacro(vtkOversketchRetriangulate);

vtkOversketchRetriangulate::vtkOversketchRetriangulate()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(3);
  DeclareInput(this, 3, { Port::Optional });
}

void vtkOversketchRetriangulate::SetMotion(std::shared_ptr<const Motion> motion)
{
  if (motion != this->Known)
  {
    this->Known = std::move(motion);
    this->Modified();
  }
}

void vtkOversketchRetriangulate::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* const curves[2] = { vtkPolyData::GetData(inputs[1]), vtkPolyData::GetData(inputs[2]) };
  vtkPolyData* rest = this->Rule == Edit ? vtkPolyData::GetData(inputs[3]) : nullptr;
  Cache& cache = this->Kept<Cache>();
  const StepKey key(
    { WholeKey(mesh), WholeKey(curves[0]), WholeKey(curves[1]), rest ? MeshKey(rest) : MeshKey() },
    { static_cast<double>(this->Rule) });
  if (cache.Known != this->Known)
  {
    cache.Kept = KeptOutput();
    cache.Known = this->Known;
  }
  cache.Kept.Provide(key,
    { vtkPolyData::GetData(outputs, 0), vtkPolyData::GetData(outputs, 1), vtkPolyData::GetData(outputs, 2) },
    [&](const KeptOutput::Outputs& made) { cache.Make(this, mesh, rest, curves, made); });
}

void vtkOversketchRetriangulate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rule: " << (this->Rule == Edit ? "Edit" : "Curvature") << "\n";
  os << indent << "OperationCount: " << this->OperationCount << "\n";
  os << indent << "RetriangulationCount: " << this->RetriangulationCount << "\n";
}
