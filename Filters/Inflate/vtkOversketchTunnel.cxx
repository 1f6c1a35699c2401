#include "vtkOversketchTunnel.h"

#include "Inflate/solid.h"
#include "Planar/planar_mesh.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchSolidTools.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchTunnel);

void vtkOversketchTunnel::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* surface = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* curves = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const Context context = ContextOf(this);
  context.checkpoint(0.0);
  const std::vector<char> tunnels = regionsInTunnels(ClassificationOf(curves), TreatmentsOf(curves));
  if (std::count(tunnels.begin(), tunnels.end(), 1) == 0)
  {
    output->ShallowCopy(surface);
    return;
  }
  std::vector<double> values(tunnels.begin(), tunnels.end());
  values.push_back(this->TunnelWall);
  this->Kept<KeptOutput>().Provide(StepKey({ WholeKey(surface) }, values),
    output,
    [&](vtkPolyData* result)
    {
      ++this->TunnelCount;
      const Solid solid = SolidOf(surface);
      vtkDataArray* regions = RequireArray(surface->GetCellData(),
        "RegionId",
        1,
        surface->GetNumberOfCells(),
        "surface",
        "take the mesh from vtkOversketchPlanarRefine");
      std::vector<char> removed;
      for (vtkIdType f = 0; f < regions->GetNumberOfTuples(); ++f)
      {
        const int region = wholeRegion(static_cast<int>(regions->GetComponent(f, 0)));
        removed.push_back(region >= 0 && region < static_cast<int>(tunnels.size()) && tunnels[region] != 0);
      }
      context.checkpoint(0.3);
      const Solid cut = tunnel(solid, removed, this->TunnelWall);
      context.checkpoint(0.7);
      WriteSolid(cut, surface, result);
    });
}

void vtkOversketchTunnel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TunnelWall: " << this->TunnelWall << "\n";
  os << indent << "TunnelCount: " << this->TunnelCount << "\n";
}
