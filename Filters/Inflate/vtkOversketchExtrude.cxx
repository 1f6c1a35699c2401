#include "vtkOversketchExtrude.h"

#include "Inflate/solid.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPlanarTools.h"
#include "vtkOversketchSolidTools.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchExtrude);

void vtkOversketchExtrude::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  RequireFinite(this->Depth, "Depth");
  const Context context = ContextOf(this);
  context.checkpoint(0.0);
  const double depth = this->Depth == 0.0 ? 0.1 * CanvasOf(mesh).longest() : this->Depth;
  this->Kept<KeptOutput>().Provide(StepKey({ WholeKey(mesh) }, { depth, 1.0 * this->WallRows }),
    vtkPolyData::GetData(outputs),
    [&](vtkPolyData* result)
    {
      ++this->ExtrudeCount;
      const PlanarMesh planar = PlanarMeshOf(mesh);
      context.checkpoint(0.3);
      const Solid solid = extrude(
        planar, depth, this->WallRows == 1 ? oversketch::WallRows::One : oversketch::WallRows::Refined);
      context.checkpoint(0.7);
      WriteSolid(solid, mesh, result);
    });
}

void vtkOversketchExtrude::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Depth: " << this->Depth << "\n";
  os << indent << "WallRows: " << this->WallRows << "\n";
  os << indent << "ExtrudeCount: " << this->ExtrudeCount << "\n";
}
