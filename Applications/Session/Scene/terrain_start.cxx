#include "terrain_start.h"

#include "files.h"
#include "heights.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace oversketch_session
{

namespace
{

// The scale by the first component; 1 where that says nothing.
double scaleFor(vtkImageData* heights)
{
  constexpr double share = 0.2, least = 1e-3; // of the longer side
  vtkDataArray* gray = heights->GetPointData()->GetScalars();
  double lowest = 0.0, highest = 0.0;
  bool any = false;
  for (vtkIdType i = 0; i < gray->GetNumberOfTuples(); ++i)
  {
    const double value = gray->GetComponent(i, 0);
    if (std::isfinite(value))
    {
      lowest = any ? std::min(lowest, value) : value;
      highest = any ? std::max(highest, value) : value;
      any = true;
    }
  }
  const double relief = highest - lowest;
  const double side = std::max(heights->GetSpacing()[0] * (heights->GetDimensions()[0] - 1),
    heights->GetSpacing()[1] * (heights->GetDimensions()[1] - 1));
  return relief > side || (relief > 0.0 && relief < least * side) ? share * side / relief : 1.0;
}

} // namespace

std::shared_ptr<const Step> terrainOf(const std::string& path)
{
  oversketch_files::requireReadable(path);
  const Image image{ std::filesystem::path(path).filename().string(),
    std::make_shared<const std::string>(oversketch_files::wholeFile(path)) };
  const double scale = scaleFor(oversketch_files::parseHeights(path, *image.bytes));
  auto step = std::make_shared<Step>();
  step->system = "Terrain";
  step->inputs["Heights"] = image;
  if (scale != 1.0)
  {
    step->values["Scale"] = scale;
  }
  return step;
}

} // namespace oversketch_session
