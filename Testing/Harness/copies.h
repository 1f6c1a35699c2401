// Copies of polydata that keep nothing of the original. Header-only.
#ifndef oversketch_testing_harness_copies_h
#define oversketch_testing_harness_copies_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace oversketch_test
{

inline vtkSmartPointer<vtkPolyData> deepCopy(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

} // namespace oversketch_test
#endif
