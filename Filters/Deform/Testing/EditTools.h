// What the editors' tests ask of results. Header-only.
#ifndef oversketch_filters_deform_testing_edit_tools_h
#define oversketch_filters_deform_testing_edit_tools_h

#include "Harness/promises.h"
#include "Harness/region_data.h"

#include "vtkPolyDataAlgorithm.h"
#include "vtkSMPTools.h"

#include <cstring>

namespace oversketch_test
{

// All numbers of points and point arrays, bit for bit.
inline bool sameBits(vtkPolyData* a, vtkPolyData* b)
{
  const auto same = [](vtkDataArray* one, vtkDataArray* other)
  {
    return one && other && one->GetDataType() == other->GetDataType() &&
           one->GetNumberOfValues() == other->GetNumberOfValues() &&
           (one->GetNumberOfValues() == 0 ||
             std::memcmp(one->GetVoidPointer(0),
               other->GetVoidPointer(0),
               static_cast<std::size_t>(one->GetNumberOfValues()) * one->GetDataTypeSize()) == 0);
  };
  if (!same(a->GetPoints()->GetData(), b->GetPoints()->GetData()))
  {
    return false;
  }
  for (int i = 0; i < a->GetPointData()->GetNumberOfArrays(); ++i)
  {
    if (!same(
          a->GetPointData()->GetArray(i), b->GetPointData()->GetArray(a->GetPointData()->GetArrayName(i))))
    {
      return false;
    }
  }
  return same(a->GetCellData()->GetNormals(), b->GetCellData()->GetNormals());
}

// Runs with one thread and with two: the same bits.
inline void expectSameOnTwoThreads(const std::function<vtkSmartPointer<vtkPolyDataAlgorithm>()>& make)
{
  vtkSMPTools::Initialize(1);
  const auto one = make();
  one->Update();
  vtkSMPTools::Initialize(2);
  const auto two = make();
  two->Update();
  vtkSMPTools::Initialize(0);
  ASSERT_GT(one->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(sameBits(one->GetOutput(), two->GetOutput()));
}

} // namespace oversketch_test
#endif
