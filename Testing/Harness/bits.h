// Meshes compared to the bit. Header-only.
#ifndef oversketch_testing_harness_bits_h
#define oversketch_testing_harness_bits_h

#include "Harness/copies.h"
#include "Harness/shipped.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cstring>

namespace oversketch_test
{

inline bool sameValues(vtkDataArray* a, vtkDataArray* b)
{
  return a && b && a->GetNumberOfValues() == b->GetNumberOfValues() && a->GetDataType() == b->GetDataType() &&
         std::memcmp(a->GetVoidPointer(0),
           b->GetVoidPointer(0),
           static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())) == 0;
}

// Points, polygons and arrays of points and cells, to the bit.
inline void expectSameBits(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_GT(a->GetNumberOfPolys(), 0);
  ASSERT_TRUE(sameValues(a->GetPoints()->GetData(), b->GetPoints()->GetData()));
  ASSERT_TRUE(identical(a, b));
  for (const bool ofPoints : { true, false })
  {
    vtkFieldData* left = ofPoints ? static_cast<vtkFieldData*>(a->GetPointData()) : a->GetCellData();
    vtkFieldData* right = ofPoints ? static_cast<vtkFieldData*>(b->GetPointData()) : b->GetCellData();
    ASSERT_EQ(left->GetNumberOfArrays(), right->GetNumberOfArrays());
    for (int i = 0; i < left->GetNumberOfArrays(); ++i)
    {
      EXPECT_TRUE(sameValues(left->GetArray(i), right->GetArray(left->GetArrayName(i))))
        << left->GetArrayName(i);
    }
  }
}

} // namespace oversketch_test
#endif
