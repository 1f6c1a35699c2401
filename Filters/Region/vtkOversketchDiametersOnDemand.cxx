#include "vtkOversketchDiametersOnDemand.h"

#include "vtkOversketchSharedMesh.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOversketchDiametersOnDemand);

void vtkOversketchDiametersOnDemand::Open(const std::shared_ptr<const oversketch::MeshData>& mesh,
  const oversketch::ShapeDiameterOptions& options,
  const oversketch::Context& context)
{
  this->Mesh = mesh;
  this->Diameters.emplace(mesh->Surface(), mesh->Neighbours(), mesh->Normals(), options, context);
  this->SetNumberOfTuples(mesh->Surface().vertexCount());
  this->Fill(0.0);
}

void vtkOversketchDiametersOnDemand::Require(const std::vector<int>& points,
  const oversketch::Context& context)
{
  this->Diameters->require(points, context);
  for (const int v : points)
  {
    this->SetValue(v, this->Diameters->values()[v]);
  }
}
