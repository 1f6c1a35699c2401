// What the tests of vtkOversketchShapeDiameter share: runs, their values, meshes of the shared data.
#ifndef oversketch_filters_region_testing_shape_diameter_tools_h
#define oversketch_filters_region_testing_shape_diameter_tools_h

#include "Harness/data.h"
#include "Harness/promises.h"
#include "Ray/shape_diameter.h"
#include "vtkOversketchShapeDiameter.h"

#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkSTLReader.h"

#include <gtest/gtest.h>

namespace oversketch_test
{

using namespace oversketch;
using Filter = vtkOversketchShapeDiameter;

inline vtkDataArray* arrayOf(Filter* filter)
{
  return filter->GetOutput()->GetPointData()->GetArray("ShapeDiameter");
}

inline std::vector<double> valuesOf(Filter* filter)
{
  std::vector<double> values;
  vtkDataArray* array = arrayOf(filter);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

inline std::vector<double> diameters(vtkPolyData* mesh,
  int backend,
  double angle = 60.0,
  bool inverse = false)
{
  vtkNew<Filter> filter;
  filter->SetInputData(mesh);
  filter->SetBackend(backend);
  filter->SetConeAngle(angle);
  filter->SetInverseAngleWeights(inverse);
  filter->Update();
  EXPECT_EQ(filter->GetTracedRayCount(), 32 * mesh->GetNumberOfPoints());
  if (backend == Filter::Host || Device::instance())
  {
    EXPECT_EQ(filter->GetBackendUsed(), backend);
  }
  return valuesOf(filter);
}

const int backends[] = { Filter::OpenCL, Filter::Host };

// A mesh of any of the formats of the shared data, null where it is absent.
inline vtkSmartPointer<vtkPolyData> read(const std::string& name)
{
  const std::string path = sharedData("meshes/" + name);
  if (path.empty())
  {
    return nullptr;
  }
  const auto with = [&](auto reader)
  {
    reader->SetFileName(path.c_str());
    reader->Update();
    return vtkSmartPointer<vtkPolyData>(reader->GetOutput());
  };
  const std::string ending = path.substr(path.size() - 3);
  return ending == "obj"   ? with(vtkSmartPointer<vtkOBJReader>::New())
         : ending == "ply" ? with(vtkSmartPointer<vtkPLYReader>::New())
         : ending == "stl" ? with(vtkSmartPointer<vtkSTLReader>::New())
                           : nullptr;
}

} // namespace oversketch_test
#endif
