#include "vtkOversketchProfileDeform.h"

#include "Matrix/moving_patch.h"
#include "Section/follow.h"
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

#include <optional>

using namespace oversketch;

// Work that depends on mesh, region and curve alone, and the last result.
struct vtkOversketchProfileDeform::Cache
{
  std::shared_ptr<const MeshData> Data; // keeps the shared mesh alive between runs
  StepKey RegionKey;
  std::optional<CurveOnMesh> Reference;
  MovingPatch Patch;
  RegionPlaces Region;
  std::vector<double> Sides; // see sideShares
  KeptOutput Kept;

  void ReadRegion(vtkPolyData* mesh, vtkPolyData* curve, const Context& context);
  std::vector<Vector3> Places(vtkPolyData* profile,
    vtkPolyData* drawn,
    const std::vector<double>& handles,
    const std::vector<double>& weights,
    const Context& context) const;
};

vtkStandardNewMacro(vtkOversketchProfileDeform);

void vtkOversketchProfileDeform::Cache::ReadRegion(vtkPolyData* mesh,
  vtkPolyData* curve,
  const Context& context)
{
  vtkPointData* data = mesh->GetPointData();
  const StepKey key({ MeshKey(mesh,
                        { data->GetNormals(),
                          data->GetArray("EditRegion"),
                          data->GetArray("CurveDistance"),
                          data->GetArray("CurveParameter"),
                          data->GetArray("CurveSide") }),
                      WholeKey(curve) },
    {});
  if (this->Data && this->RegionKey == key)
  {
    return;
  }
  this->Data = nullptr;
  const auto shared = SharedMesh(mesh);
  this->Reference.emplace(curve, *shared);
  RegionPlaces& region = this->Region;
  region.vertices = ReadInside(mesh);
  region.distance = ReadValues(mesh, "CurveDistance", region.vertices);
  region.parameter = ReadValues(mesh, "CurveParameter", region.vertices);
  region.side = ReadValues(mesh, "CurveSide", region.vertices, -1.0);
  this->Patch = MovingPatch(shared->Surface(), shared->Neighbours(), region.vertices);
  this->Sides =
    sideShares(shared->Surface().points, region, this->Reference->Points, this->Reference->Frames, context);
  this->Data = shared;
  this->RegionKey = key;
}

std::vector<Vector3> vtkOversketchProfileDeform::Cache::Places(vtkPolyData* profile,
  vtkPolyData* drawn,
  const std::vector<double>& handles,
  const std::vector<double>& weights,
  const Context& context) const
{
  const DrawnChange drawnChange = ReadChange(profile, drawn, handles);
  const std::vector<Vector3> moves = profileMoves(this->Data->Surface().points,
    this->Region,
    this->Sides,
    drawnChange.Change,
    drawnChange.Old.toWorld,
    drawnChange.Plane,
    this->Reference->Frames,
    drawnChange.Reach,
    weights,
    context);
  std::vector<Vector3> places = this->Patch.rest();
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    places[i] += moves[i];
  }
  return places;
}

vtkOversketchProfileDeform::vtkOversketchProfileDeform()
{
  this->SetNumberOfInputPorts(5);
  DeclareInput(this, 4, { Port::Optional });
}

void vtkOversketchProfileDeform::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* curve = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* profile = vtkPolyData::GetData(inputs[2]);
  vtkPolyData* drawn = vtkPolyData::GetData(inputs[3]);
  vtkPolyData* handles = vtkPolyData::GetData(inputs[4]);
  Cache& cache = this->Kept<Cache>();
  const StepKey key({ WholeKey(mesh),
                      WholeKey(curve),
                      WholeKey(profile),
                      WholeKey(drawn),
                      handles ? WholeKey(handles) : MeshKey() },
    { this->UseTexture ? 1.0 : 0.0 });
  cache.Kept.Provide(key,
    vtkPolyData::GetData(outputs),
    [&](vtkPolyData* result)
    {
      ++this->DeformCount;
      this->MovedPoints = this->FoldedEdges = 0;
      if (profile->GetNumberOfPoints() == 0)
      {
        result->ShallowCopy(mesh);
        return;
      }
      cache.ReadRegion(mesh, curve, ContextOf(this, 0.0, 0.3));
      const std::vector<double> weights =
        this->UseTexture ? ReadValues(mesh, "EditWeight", cache.Region.vertices) : std::vector<double>();
      const std::vector<Vector3> places = cache.Places(profile,
        drawn,
        handles ? ReadHandlePlaces(handles) : std::vector<double>(),
        weights,
        ContextOf(this, 0.3, 0.7));
      const MoveReport report = WriteMoved(mesh, cache.Patch, places, result, ContextOf(this, 0.7, 1.0));
      this->MovedPoints = report.Moved;
      this->FoldedEdges = report.Folds;
    });
}

void vtkOversketchProfileDeform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseTexture: " << this->UseTexture << '\n';
  os << indent << "MovedPoints: " << this->MovedPoints << '\n';
  os << indent << "FoldedEdges: " << this->FoldedEdges << '\n';
  os << indent << "DeformCount: " << this->DeformCount << '\n';
}
