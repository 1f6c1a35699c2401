#include "vtkOversketchShapeDiameter.h"

#include "Ray/shape_diameter.h"
#include "vtkOversketchDiametersOnDemand.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <tuple>

using namespace oversketch;

// The array and what it was made from.
struct vtkOversketchShapeDiameter::Cache
{
  using Parameters = std::tuple<int, double, bool, bool, bool, int>;

  MeshKey Key;
  Parameters Values{};
  std::shared_ptr<const MeshData> Mesh; // kept for the steps that follow on the same mesh
  vtkSmartPointer<vtkDoubleArray> Array;
};

vtkStandardNewMacro(vtkOversketchDiametersOnDemand);

void vtkOversketchDiametersOnDemand::Open(const std::shared_ptr<const MeshData>& mesh,
  const ShapeDiameterOptions& options,
  const Context& context)
{
  this->Mesh = mesh;
  this->Diameters.emplace(mesh->Surface(), mesh->Neighbours(), mesh->Normals(), options, context);
  this->SetNumberOfTuples(mesh->Surface().vertexCount());
  this->Fill(0.0);
}

void vtkOversketchDiametersOnDemand::Require(const std::vector<int>& points, const Context& context)
{
  this->Diameters->require(points, context);
  for (const int v : points)
  {
    this->SetValue(v, this->Diameters->values()[v]);
  }
}

vtkStandardNewMacro(vtkOversketchShapeDiameter);

void vtkOversketchShapeDiameter::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  RequirePolygonsOnly(input); // the key does not see other cells
  const MeshKey key(input, { input->GetPointData()->GetNormals() });
  const Cache::Parameters values(this->RayCount,
    this->ConeAngle,
    this->InverseAngleWeights,
    this->TurnCones,
    this->OnDemand,
    this->GetBackend());
  Cache& cache = this->Kept<Cache>();
  if (!cache.Array || cache.Key != key || cache.Values != values)
  {
    cache.Array = nullptr;
    cache.Mesh = SharedMesh(input);
    ShapeDiameterOptions options;
    options.rayCount = this->RayCount;
    options.coneAngle = this->ConeAngle;
    options.inverseAngleWeights = this->InverseAngleWeights;
    options.turnCones = this->TurnCones;
    options.backend = this->KernelBackend();
    ++this->RayCastCount;
    const auto made = [this](const ShapeDiameter& result)
    {
      if (!result.warning.empty())
      {
        Warn(this, result.warning);
      }
      this->UsedBackend(result.used);
    };
    if (this->OnDemand)
    {
      auto array = vtkSmartPointer<vtkOversketchDiametersOnDemand>::New();
      array->SetName("ShapeDiameter");
      array->Open(cache.Mesh, options, ContextOf(this));
      made(array->Result());
      cache.Array = array;
    }
    else
    {
      const ShapeDiameter result = computeShapeDiameter(
        cache.Mesh->Surface(), cache.Mesh->Neighbours(), cache.Mesh->Normals(), options, ContextOf(this));
      made(result);
      this->TracedRayCount = static_cast<vtkIdType>(result.raysCast);
      cache.Array = ArrayOf<vtkDoubleArray>("ShapeDiameter", result.diameter);
    }
    cache.Key = key;
    cache.Values = values;
  }
  output->ShallowCopy(input);
  output->GetPointData()->AddArray(cache.Array);
}

vtkIdType vtkOversketchShapeDiameter::GetTracedRayCount()
{
  auto* array = vtkOversketchDiametersOnDemand::SafeDownCast(this->Kept<Cache>().Array);
  return array ? static_cast<vtkIdType>(array->Result().raysCast) : this->TracedRayCount;
}

void vtkOversketchShapeDiameter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RayCount: " << this->RayCount << "\n"
     << indent << "ConeAngle: " << this->ConeAngle << "\n"
     << indent << "InverseAngleWeights: " << this->InverseAngleWeights << "\n"
     << indent << "TurnCones: " << this->TurnCones << "\n"
     << indent << "OnDemand: " << this->OnDemand << "\n"
     << indent << "RayCastCount: " << this->RayCastCount << "\n"
     << indent << "TracedRayCount: " << this->GetTracedRayCount() << "\n";
}
