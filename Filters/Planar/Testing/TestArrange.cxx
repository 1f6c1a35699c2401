// vtkOversketchArrange: what its output says, hostile input, what is computed anew. The laws are in
// Kernels/Planar/arrange_test.cxx.
#include "CurveShapes.h"
#include "vtkOversketchArrange.h"
#include "vtkOversketchClassify.h"

using namespace oversketch;
using namespace oversketch_test;

namespace
{

std::vector<DrawnStroke> overlapping()
{
  return { closedStroke(ringAt(400, 500, 200)),
    closedStroke(ringAt(620, 500, 200)),
    closedStroke(ringAt(100, 900, 50)) };
}

} // namespace

TEST(Arrange, SaysWhatCurvesAreOf)
{
  auto drawing = toCurves(overlapping());
  vtkNew<vtkIntArray> treatment;
  treatment->SetName("Treatment");
  for (const int value : { 0, 0, 2 })
  {
    treatment->InsertNextValue(value);
  }
  drawing->GetCellData()->AddArray(treatment);
  vtkNew<vtkOversketchArrange> arrange;
  arrange->SetInputData(drawing);
  arrange->Update();
  ASSERT_EQ(arrange->GetErrorCode(), 0u);
  vtkPolyData* made = arrange->GetOutput();
  EXPECT_EQ(cellValues(made, "StrokeId"), (std::vector<int>{ 0, 0, 1, 2 }));
  EXPECT_EQ(cellValues(made, "Closed"), (std::vector<int>{ 0, 1, 0, 1 }));
  EXPECT_EQ(cellValues(made, "Treatment"), (std::vector<int>{ 0, 0, 0, 2 }));
  EXPECT_NE(made->GetFieldData()->GetArray("Canvas"), nullptr);
  vtkDataArray* nodes = made->GetPointData()->GetArray("Node");
  ASSERT_EQ(nodes->GetNumberOfTuples(), made->GetNumberOfPoints());
  int count = 0;
  for (vtkIdType i = 0; i < nodes->GetNumberOfTuples(); ++i)
  {
    count += nodes->GetComponent(i, 0) != 0.0;
  }
  EXPECT_EQ(count, 6) << "two places, each on three curves";
  // And messages call them by their strokes.
  vtkNew<vtkOversketchClassify> classify;
  classify->SetInputConnection(arrange->GetOutputPort());
  classify->Update();
  EXPECT_EQ(cellValues(classify->GetOutput(), "Role"), (std::vector<int>{ 3, 1, 3, 1 }));
}

TEST(Arrange, RefusesWhatIsNoDrawing)
{
  vtkNew<vtkOversketchArrange> arrange;
  vtkNew<vtkPolyData> nothing;
  arrange->SetInputData(nothing);
  arrange->Update();
  EXPECT_EQ(arrange->GetErrorCode(), 0u);
  EXPECT_EQ(arrange->GetOutput()->GetNumberOfPoints(), 0);
  auto drawing = toCurves(overlapping());
  drawing->GetFieldData()->RemoveArray("Canvas");
  arrange->SetInputData(drawing);
  expectRefusal(arrange, Failure::MissingArray, "Canvas");
  drawing = toCurves(overlapping());
  drawing->GetPoints()->SetPoint(7, std::nan(""), 0.0, 0.0);
  arrange->SetInputData(drawing);
  expectRefusal(arrange, Failure::BadStroke, "Stroke 0");
  arrange->SetInputData(toCurves(overlapping()));
  expectCancel(arrange);
  arrange->Update();
  EXPECT_EQ(arrange->GetOutput()->GetNumberOfCells(), 4);
}

TEST(Arrange, IsMadeAnewWhereItIsReadOtherwise)
{
  auto drawing = toCurves(overlapping());
  vtkNew<vtkOversketchArrange> arrange;
  arrange->SetInputData(drawing);
  arrange->Update();
  EXPECT_EQ(arrange->GetArrangementCount(), 1);
  drawing->Modified();
  arrange->Update();
  EXPECT_EQ(arrange->GetArrangementCount(), 1) << "the same points";
  arrange->SetJoinDistance(0.05);
  arrange->Update();
  EXPECT_EQ(arrange->GetArrangementCount(), 2);
  drawing->GetPoints()->SetPoint(7, 590.0, 560.0, 0.0);
  drawing->GetPoints()->Modified();
  drawing->Modified();
  arrange->Update();
  EXPECT_EQ(arrange->GetArrangementCount(), 3);
}
