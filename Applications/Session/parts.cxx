#include "parts.h"

#include "Inflate/placement.h"
#include "Mesh/context.h"
#include "vtkOversketchAssemble.h"
#include "vtkOversketchStepRunner.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <cmath>

namespace oversketch_session
{

namespace
{

constexpr double farthest = 1e9;   // that a part is moved
constexpr double narrowest = 1e-9; // of a box

} // namespace

Eigen::Vector4d rectangleOf(vtkPolyData* mesh)
{
  vtkDataArray* canvas = mesh->GetFieldData()->GetArray("Canvas");
  if (canvas && canvas->GetNumberOfValues() == 4)
  {
    const int components = canvas->GetNumberOfComponents();
    const auto value = [&](int i) { return canvas->GetComponent(i / components, i % components); };
    return { value(0), value(1), value(0) + value(2), value(1) + value(3) };
  }
  double bounds[6];
  mesh->GetBounds(bounds);
  return { bounds[0], bounds[2], bounds[1], bounds[3] };
}

vtkSmartPointer<vtkPolyData> placedBy(const Eigen::Matrix4d& matrix, vtkPolyData* mesh)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(mesh);
  vtkNew<vtkFieldData> fields; // the mesh's own is shared
  fields->ShallowCopy(mesh->GetFieldData());
  vtkNew<vtkDoubleArray> placement;
  placement->SetName("Placement");
  placement->SetNumberOfComponents(16);
  placement->SetNumberOfTuples(1);
  for (int i = 0; i < 16; ++i)
  {
    placement->SetComponent(0, i, matrix(i / 4, i % 4));
  }
  fields->AddArray(placement);
  result->SetFieldData(fields);
  result->GetCellData()->RemoveArray("MaterialIds");
  return result;
}

vtkSmartPointer<vtkPolyData> withPart(vtkPolyData* mesh, vtkPolyData* part, const PartPlace& place)
{
  vtkNew<vtkOversketchAssemble> assemble;
  if (mesh)
  {
    assemble->AddInputData(placedBy(Eigen::Matrix4d::Identity(), mesh));
  }
  const Eigen::Vector4d box(place.box[0], place.box[1], place.box[2], place.box[3]);
  assemble->AddInputData(placedBy(oversketch::intoBox(rectangleOf(part), box, place.depth), part));
  oversketch::StepRunner(assemble, {}).Run();
  return assemble->GetOutput();
}

std::string faultOf(const PartPlace& place)
{
  for (const double value : { place.box[0], place.box[1], place.box[2], place.box[3], place.depth })
  {
    if (!(std::abs(value) <= farthest))
    {
      return "has a number beyond 1e9, or none";
    }
  }
  const bool isBox = place.box[2] - place.box[0] >= narrowest && place.box[3] - place.box[1] >= narrowest;
  return isBox ? "" : "is an empty box; right must be greater than left and top than bottom";
}

} // namespace oversketch_session
