#include "vtkOversketchMixable.h"

#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

namespace
{

bool mixable(const char* name, int type, int components = 1)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return oversketch::IsMixable(array);
}

} // namespace

TEST(Mixable, MeasuresAndColoursAre)
{
  EXPECT_TRUE(mixable("RegionId", VTK_DOUBLE));
  EXPECT_TRUE(mixable("RGB", VTK_UNSIGNED_CHAR, 3));
  EXPECT_TRUE(mixable("Colour of the region", VTK_UNSIGNED_SHORT, 4));
  EXPECT_TRUE(mixable("intensity", VTK_UNSIGNED_CHAR));
  EXPECT_TRUE(mixable("Identity", VTK_SHORT)) << "no word of it is id";
  EXPECT_TRUE(mixable("width", VTK_INT));
  EXPECT_TRUE(mixable(nullptr, VTK_UNSIGNED_INT));
}

TEST(Mixable, IdsAndLabelsAreNot)
{
  for (const char* name :
    { "RegionId", "id", "ids", "PART_ID", "point_labels", "material", "Classes", "group2", "vertexIndices" })
  {
    EXPECT_FALSE(mixable(name, VTK_INT)) << name;
    EXPECT_FALSE(mixable(name, VTK_UNSIGNED_CHAR)) << name;
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Original");
  vtkNew<vtkBitArray> bits;
  bits->SetName("Heat");
  vtkNew<vtkStringArray> words;
  EXPECT_FALSE(oversketch::IsMixable(ids));
  EXPECT_FALSE(oversketch::IsMixable(bits));
  EXPECT_FALSE(oversketch::IsMixable(words));
  EXPECT_FALSE(oversketch::IsMixable(nullptr));
}
