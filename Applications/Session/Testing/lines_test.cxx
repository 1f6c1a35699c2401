// Packed lines: every bit comes back.
#include "lines.h"
#include "mesh_file.h"

#include "Harness/shipped.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

template <typename Array>
vtkSmartPointer<Array> arrayOf(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < components * tuples; ++i)
  {
    array->SetVariantValue(i, vtkVariant(static_cast<int>(i % 2)));
  }
  return array;
}

} // namespace

TEST(Lines, ShippedStrokesComeBack)
{
  for (const char* name : { "dog_longer_leg", "dog_curled_tail", "octopus_bent_arm" })
  {
    const auto stroke = shippedStroke(name);
    const Lines lines(stroke);
    EXPECT_EQ(oversketch_files::bytesOf(lines.own()), oversketch_files::bytesOf(stroke)) << name;
    EXPECT_NE(lines.own(), lines.own()) << "each is its owner's";
    EXPECT_EQ(Lines(lines).identity(), lines.identity());
  }
}

TEST(Lines, CellsAndArraysOfEveryKindComeBack)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  for (int i = 0; i < 7; ++i)
  {
    points->InsertNextPoint(i / 3.0, -i, 1e30 * i);
  }
  vtkNew<vtkCellArray> verts, lines, polys, strips;
  verts->InsertNextCell({ 6 });
  lines->InsertNextCell({ 0, 1, 2, 3 });
  lines->InsertNextCell({ 3, 1, 5 });
  polys->InsertNextCell({ 0, 2, 1 });
  strips->InsertNextCell({ 0, 1, 2, 3 });
  data->SetPoints(points);
  data->SetVerts(verts);
  data->SetLines(lines);
  data->SetPolys(polys);
  data->SetStrips(strips);
  data->GetPointData()->SetScalars(arrayOf<vtkFloatArray>("Pressure", 1, 7));
  data->GetPointData()->AddArray(arrayOf<vtkIdTypeArray>("Ids", 2, 7));
  data->GetPointData()->AddArray(arrayOf<vtkBitArray>("Bits", 1, 7));
  const auto named = arrayOf<vtkIntArray>("Named", 2, 6);
  named->SetComponentName(1, "second");
  data->GetCellData()->AddArray(named);
  vtkNew<vtkStringArray> texts;
  texts->SetName("Texts");
  texts->InsertNextValue("a");
  texts->InsertNextValue("");
  data->GetFieldData()->AddArray(texts);

  const vtkSmartPointer<vtkPolyData> back = Lines(data).own();
  EXPECT_EQ(back->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(std::string(back->GetPointData()->GetScalars()->GetName()), "Pressure");
  EXPECT_EQ(std::string(back->GetCellData()->GetArray("Named")->GetComponentName(1)), "second");
  EXPECT_EQ(back->GetCellData()->GetArray("Named")->GetComponentName(0), nullptr);
  auto* told = vtkStringArray::SafeDownCast(back->GetFieldData()->GetAbstractArray("Texts"));
  ASSERT_TRUE(told && told->GetNumberOfValues() == 2);
  EXPECT_EQ(told->GetValue(0), "a");
  EXPECT_EQ(back->GetPointData()->GetArray("Bits")->GetDataType(), VTK_BIT);
  EXPECT_EQ(oversketch_files::bytesOf(back), oversketch_files::bytesOf(data));
}

TEST(Lines, NothingIsNothing)
{
  EXPECT_FALSE(Lines());
  EXPECT_EQ(Lines().own(), nullptr);
  EXPECT_FALSE(Lines(nullptr));
  const Lines empty(vtkNew<vtkPolyData>().Get());
  EXPECT_TRUE(empty);
  EXPECT_EQ(empty.own()->GetNumberOfPoints(), 0);
}
