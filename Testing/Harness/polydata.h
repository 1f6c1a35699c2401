// Test shapes as polydata, strokes with their view, and an ear for errors. Header-only.
#ifndef oversketch_testing_harness_polydata_h
#define oversketch_testing_harness_polydata_h

#include "Harness/shapes.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace oversketch_test
{

inline vtkSmartPointer<vtkPolyData> toPolyData(const Mesh& mesh,
  const std::vector<Vector3>* normals = nullptr)
{
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& p : mesh.points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> polys;
  for (const Triangle& t : mesh.triangles)
  {
    const vtkIdType ids[3] = { t[0], t[1], t[2] };
    polys->InsertNextCell(3, ids);
  }
  polyData->SetPoints(points);
  polyData->SetPolys(polys);
  if (normals)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("Normals");
    array->SetNumberOfComponents(3);
    for (const Vector3& n : *normals)
    {
      array->InsertNextTuple(n.data());
    }
    polyData->GetPointData()->SetNormals(array);
  }
  return polyData;
}

// One stroke in display coordinates, with its view.
inline vtkSmartPointer<vtkPolyData> toStroke(const std::vector<Vector2>& samples, const View& view)
{
  auto stroke = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(samples.size()));
  for (const Vector2& s : samples)
  {
    lines->InsertCellPoint(points->InsertNextPoint(s[0], s[1], 0.0));
  }
  stroke->SetPoints(points);
  stroke->SetLines(lines);
  const auto matrix = [&](const char* name, const Eigen::Matrix4d& m)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(16);
    array->SetNumberOfTuples(1);
    for (int i = 0; i < 16; ++i)
    {
      array->SetComponent(0, i, m(i / 4, i % 4));
    }
    stroke->GetCellData()->AddArray(array);
  };
  matrix("ViewTransform", view.viewTransform());
  matrix("ProjectionTransform", view.projectionTransform());
  vtkNew<vtkIntArray> size;
  size->SetName("ViewportSize");
  size->SetNumberOfComponents(2);
  size->InsertNextValue(view.width());
  size->InsertNextValue(view.height());
  stroke->GetCellData()->AddArray(size);
  return stroke;
}

// While it lives, collects the errors and warnings of a filter and of its executive instead of letting them
// be printed.
class Ear
{
public:
  explicit Ear(vtkAlgorithm* filter)
    : Filter(filter)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* text)
      {
        auto& list = event == vtkCommand::ErrorEvent ? static_cast<Ear*>(self)->errors
                                                     : static_cast<Ear*>(self)->warnings;
        list.emplace_back(static_cast<const char*>(text));
      });
    for (const unsigned long event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
    {
      filter->AddObserver(event, this->Command);
    }
    this->Executive->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Executive);
  }
  ~Ear()
  {
    this->Filter->RemoveObserver(this->Command);
    this->Filter->GetExecutive()->RemoveObserver(this->Executive);
  }
  Ear(const Ear&) = delete;
  Ear& operator=(const Ear&) = delete;

  std::vector<std::string> errors, warnings;

private:
  vtkSmartPointer<vtkAlgorithm> Filter;
  vtkNew<vtkCallbackCommand> Command, Executive;
};

} // namespace oversketch_test
#endif
