#include "vtkOversketchMatrixDeform.h"

#include "Matrix/moved.h"
#include "Matrix/moving_patch.h"
#include "vtkOversketchEditMotion.h"
#include "vtkOversketchEditTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchMovedPoints.h"

#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

using namespace oversketch;

// The points that follow, and what was made of them last.
struct vtkOversketchMatrixDeform::Cache
{
  std::shared_ptr<const MeshData> Data; // keeps the shared mesh alive between runs
  StepKey RegionKey;
  MovingPatch Patch;
  std::vector<double> Weights, Parameters; // of the patch's vertices
  std::vector<double> Places;              // of the handles, for which there are
  std::vector<double> Shares;              // of each vertex for each handle
  KeptOutput Kept;

  void ReadRegion(vtkPolyData* mesh);
  void FindShares(const std::vector<double>& places);
};

vtkStandardNewMacro(vtkOversketchMatrixDeform);

void vtkOversketchMatrixDeform::Cache::ReadRegion(vtkPolyData* mesh)
{
  vtkPointData* data = mesh->GetPointData();
  const StepKey key({ MeshKey(mesh,
                      { data->GetNormals(),
                        data->GetArray("EditRegion"),
                        data->GetArray("EditWeight"),
                        data->GetArray("CurveParameter") }) },
    {});
  if (this->Data && this->RegionKey == key)
  {
    return;
  }
  this->Data = nullptr;
  const auto shared = SharedMesh(mesh);
  const std::vector<int> inside = ReadInside(mesh);
  const std::vector<double> weights = ReadValues(mesh, "EditWeight", inside);
  std::vector<int> following;
  this->Weights.clear();
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    if (weights[i] > 0.0)
    {
      following.push_back(inside[i]);
      this->Weights.push_back(weights[i]);
    }
  }
  this->Parameters = ReadValues(mesh, "CurveParameter", following);
  this->Patch = MovingPatch(shared->Surface(), shared->Neighbours(), following);
  this->Places.clear();
  this->Data = shared;
  this->RegionKey = key;
}

void vtkOversketchMatrixDeform::Cache::FindShares(const std::vector<double>& places)
{
  if (this->Places == places)
  {
    return;
  }
  this->Shares.clear();
  for (std::size_t i = 0; i < this->Weights.size(); ++i)
  {
    for (const double share : tents(places, this->Parameters[i]))
    {
      this->Shares.push_back(this->Weights[i] * share);
    }
  }
  this->Places = places;
}

void vtkOversketchMatrixDeform::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* handles = vtkPolyData::GetData(inputs[1]);
  Cache& cache = this->Kept<Cache>();
  cache.Kept.Provide(StepKey({ WholeKey(mesh), WholeKey(handles) }, {}),
    vtkPolyData::GetData(outputs),
    [&](vtkPolyData* result)
    {
      ++this->DeformCount;
      this->MovedPoints = this->FoldedEdges = 0;
      cache.ReadRegion(mesh);
      const Pulls pulls = PullsOf(handles);
      if (pulls.Still())
      {
        result->ShallowCopy(mesh);
        return;
      }
      cache.FindShares(pulls.Places);
      const std::vector<Vector3> places =
        moved(cache.Patch.rest(), pulls.Logs, cache.Shares, ContextOf(this, 0.0, 0.5));
      const MoveReport report = WriteMoved(mesh, cache.Patch, places, result, ContextOf(this, 0.5, 1.0));
      this->MovedPoints = report.Moved;
      this->FoldedEdges = report.Folds;
    });
}

void vtkOversketchMatrixDeform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MovedPoints: " << this->MovedPoints << '\n';
  os << indent << "FoldedEdges: " << this->FoldedEdges << '\n';
  os << indent << "DeformCount: " << this->DeformCount << '\n';
}
