#include "vtkOversketchRegionBorder.h"

#include "Region/border.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

using namespace oversketch;

namespace
{

void takeOut(const std::vector<char>& masked, std::vector<char>& chosen)
{
  for (std::size_t v = 0; v < masked.size(); ++v)
  {
    chosen[v] = chosen[v] && !masked[v];
  }
}

} // namespace

struct vtkOversketchRegionBorder::Cache
{
  std::shared_ptr<const MeshData> Data;
  KeptValue<vtkSmartPointer<vtkUnsignedCharArray>> Region;
};

vtkStandardNewMacro(vtkOversketchRegionBorder);

void vtkOversketchRegionBorder::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const vtkIdType count = input->GetNumberOfPoints();
  Cache& cache = this->Kept<Cache>();
  cache.Data = SharedMesh(input);
  const std::string remedy = "find the region with vtkOversketchMixtureRegion";
  vtkDataArray* region = RequireArray(input->GetPointData(), "Region", 1, count, "mesh", remedy);
  vtkDataArray* seeds = RequireArray(input->GetPointData(), "RegionSeed", 1, count, "mesh", remedy);
  const int rings = this->Confine ? this->Rings : 0;
  vtkDataArray* mask = input->GetPointData()->GetArray(maskName);
  vtkDataArray* border =
    cache.Region.Provide(StepKey({ MeshKey(input, { region, seeds, mask }) }, { 1.0 * rings }),
      [&]
      {
        ++this->SmoothingCount;
        const std::vector<char> masked = MaskedPointsOf(input);
        std::vector<char> seed = LabelsOf(seeds), chosen = LabelsOf(region);
        const bool isSeeded = std::find(seed.begin(), seed.end(), 1) != seed.end();
        takeOut(masked, seed);
        takeOut(masked, chosen);
        if (isSeeded && std::find(seed.begin(), seed.end(), 1) == seed.end())
        {
          throw Error(Failure::BadRegion,
            "All of what the stroke was drawn beside is masked, so nothing may follow it; free it, or draw "
            "beside a part that is free.");
        }
        std::vector<char> smooth = smoothBorder(cache.Data->Neighbours(), seed, chosen, rings);
        takeOut(masked, smooth); // the rules may have taken some in again
        const auto selected = std::count(smooth.begin(), smooth.end(), 1);
        if (selected == 0 || selected == count)
        {
          throw Error(Failure::BadRegion,
            selected == 0
              ? "The region is empty; draw a stroke on a part of the model with more vertices."
              : "The region reaches the whole model, so nothing is left to hold it; draw a shorter stroke.");
        }
        return ArrayOf<vtkUnsignedCharArray>("Region", smooth);
      });
  output->ShallowCopy(input);
  output->GetPointData()->AddArray(border);
}

void vtkOversketchRegionBorder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Confine: " << (this->Confine ? "On" : "Off") << '\n'
     << indent << "Rings: " << this->Rings << '\n'
     << indent << "SmoothingCount: " << this->SmoothingCount << '\n';
}
