#include "vtkOversketchWeldedInput.h"

#include "Ray/surface_rays.h"
#include "vtkOversketchMaskArray.h"

#include "vtkPoints.h"

namespace oversketch
{

void WeldedInput::Feed(vtkPolyData* mesh)
{
  RequirePolygonsOnly(mesh); // the key does not see other cells
  if (this->Welding && this->Seen == MeshKey(mesh))
  {
    return;
  }
  vtkNew<vtkPolyData> bare; // of attributes, which would have to be told apart at seams
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  this->Welding = std::make_unique<Weld>(bare);
  this->Welded->ShallowCopy(this->Welding->Welded());
  this->Shared = SharedMesh(this->Welded);
  this->Scene = nullptr;
  this->Seen = MeshKey(mesh);
}

const SurfaceRays& WeldedInput::Rays(const Context& context)
{
  this->Scene = this->Scene ? this->Scene : sharedRays(this->Shared->KeptSurface(), context);
  return *this->Scene;
}

std::vector<double> WeldedInput::MaskOfVertices(vtkPolyData* mesh) const
{
  vtkNew<vtkPolyData> masked;
  masked->ShallowCopy(this->Welded);
  this->Welding->PutMask(mesh, masked);
  return MaskOf(masked);
}

void WeldedInput::Move(vtkPolyData* mesh,
  const std::vector<int>& vertices,
  const std::vector<Vector3>& places,
  vtkPolyData* output) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(this->Welded->GetPoints());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    points->SetPoint(vertices[i], places[i].data());
  }
  vtkNew<vtkPolyData> moved;
  moved->SetPoints(points);
  this->Welding->Move(mesh, moved, output);
}

} // namespace oversketch
