#include "vtkOversketchRetriangulate.h"

#include "Remesh/retriangulate.h"
#include "vtkOversketchChains.h"
#include "vtkOversketchEditRegion.h"
#include "vtkOversketchFieldValue.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchRetriangulateTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <string>

using namespace oversketch;

struct vtkOversketchRetriangulate::Cache
{
  StepKey Key;
  std::shared_ptr<const Motion> Known;     // held, so that another one has another address
  vtkSmartPointer<vtkPolyData> Outputs[3]; // null: nothing is kept
  std::shared_ptr<const MeshData> Rest;

  void Make(vtkOversketchRetriangulate* self,
    vtkPolyData* mesh,
    vtkPolyData* rest,
    vtkPolyData* const (&curves)[2]);
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

} // namespace

void vtkOversketchRetriangulate::Cache::Make(vtkOversketchRetriangulate* self,
  vtkPolyData* mesh,
  vtkPolyData* rest,
  vtkPolyData* const (&curves)[2])
{
  for (vtkSmartPointer<vtkPolyData>& output : this->Outputs)
  {
    output = nullptr;
  }
  ++self->RetriangulationCount;
  const double meanEdge =
    FieldValue(mesh, "MeanEdge", "mesh", "pass the mesh through vtkOversketchMeanEdge when it is loaded");
  const std::vector<char> region = ReadEditRegion(mesh);
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
      { moved->Surface(), moved->Surface().points, region, vertices, meanEdge, asFloats }, ContextOf(self));
  }
  else
  {
    this->Rest = restOf(rest, moved->Surface());
    const Mesh& before = this->Rest->Surface();
    const Motion motion =
      self->Known ? *self->Known
                  : motionBetween(before, this->Rest->Neighbours(), moved->Surface().points, ContextOf(self));
    result = retriangulateEdit(
      { before, moved->Surface().points, region, vertices, meanEdge, asFloats, sizesOf(mesh) },
      motion,
      ContextOf(self));
  }
  self->OperationCount = result.splits + result.collapses + result.flips;

  vtkSmartPointer<vtkPolyData> made[3];
  for (vtkSmartPointer<vtkPolyData>& output : made)
  {
    output = vtkSmartPointer<vtkPolyData>::New();
  }
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
  std::copy(std::begin(made), std::end(made), std::begin(this->Outputs));
}

vtkStandardNewMacro(vtkOversketchRetriangulate);

vtkOversketchRetriangulate::vtkOversketchRetriangulate()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(3);
  DeclareInput(this, 3, { Port::Optional });
}

vtkOversketchRetriangulate::~vtkOversketchRetriangulate() = default;

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
  Cache& cache = *this->Internals;
  const StepKey key(
    { WholeKey(mesh), WholeKey(curves[0]), WholeKey(curves[1]), rest ? MeshKey(rest) : MeshKey() },
    { static_cast<double>(this->Rule) });
  if (!cache.Outputs[0] || cache.Key != key || cache.Known != this->Known)
  {
    cache.Make(this, mesh, rest, curves);
    cache.Key = key;
    cache.Known = this->Known;
  }
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData::GetData(outputs, port)->ShallowCopy(cache.Outputs[port]);
  }
}

void vtkOversketchRetriangulate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rule: " << (this->Rule == Edit ? "Edit" : "Curvature") << "\n";
  os << indent << "OperationCount: " << this->OperationCount << "\n";
  os << indent << "RetriangulationCount: " << this->RetriangulationCount << "\n";
}
