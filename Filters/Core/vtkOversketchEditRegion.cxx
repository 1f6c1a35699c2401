#include "vtkOversketchEditRegion.h"

#include "vtkOversketchFilterTools.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

namespace oversketch
{

std::vector<char> ReadEditRegion(vtkPolyData* mesh)
{
  const std::string remedy = "find the region with vtkOversketchEnclose";
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkDataArray* array = RequireArray(mesh->GetPointData(), "EditRegion", 1, count, "mesh", remedy);
  std::vector<char> labels;
  labels.reserve(static_cast<std::size_t>(count));
  for (vtkIdType v = 0; v < count; ++v)
  {
    const double label = array->GetComponent(v, 0);
    if (label != EditLabel::Outside && label != EditLabel::Rim && label != EditLabel::Inside)
    {
      throw Error(Failure::BadRegion,
        "EditRegion of vertex %1 is not 0 (outside), 1 (on the rim) or 2 (inside): %2.",
        v,
        remedy);
    }
    labels.push_back(static_cast<char>(label));
  }
  return labels;
}

std::vector<int> ReadInside(vtkPolyData* mesh)
{
  const std::vector<char> labels = ReadEditRegion(mesh);
  std::vector<int> inside;
  for (std::size_t v = 0; v < labels.size(); ++v)
  {
    if (labels[v] == EditLabel::Inside)
    {
      inside.push_back(static_cast<int>(v));
    }
  }
  if (inside.empty())
  {
    throw Error(Failure::BadRegion,
      "No vertex lies strictly inside {the boundary}; draw it larger, or refine the mesh there.");
  }
  return inside;
}

} // namespace oversketch
