#include "Harness/drawings.h"
#include "Harness/promises.h"
#include "vtkOversketchCanvas.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchTrace.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr int side = 200;
const Vector2 middleOfThing(100.0, 90.0);

// A dark ring on light ground, by 8 or 16 bits; an even number of channels: all of it opaque.
template <typename Array = vtkUnsignedCharArray>
vtkSmartPointer<vtkImageData> ringPicture(int channels = 1)
{
  return picture<Array>(side,
    side,
    channels,
    [channels](int x, int y, int channel)
    {
      const double from = (Vector2(x, y) - middleOfThing).norm();
      const bool isAlpha = channels % 2 == 0 && channel + 1 == channels;
      return isAlpha ? 255 : from <= 60.0 && from > 25.0 ? 40 : 220;
    });
}

struct Tracing
{
  vtkNew<vtkOversketchTrace> trace;

  explicit Tracing(vtkImageData* image) { this->trace->SetInputData(image); }
  vtkPolyData* strokes()
  {
    this->trace->Update();
    EXPECT_EQ(this->trace->GetErrorCode(), 0u);
    return this->trace->GetOutput();
  }
};

std::vector<double> valuesOf(vtkPolyData* strokes, const char* name)
{
  std::vector<double> values;
  vtkDataArray* array = strokes->GetCellData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

} // namespace

TEST(TraceFilter, StrokesAreThoseOfADrawing)
{
  Tracing tracing(ringPicture());
  vtkPolyData* strokes = tracing.strokes();
  ASSERT_EQ(strokes->GetNumberOfLines(), 2);
  EXPECT_EQ(valuesOf(strokes, "Treatment"), (std::vector<double>{ 0.0, 2.0 }));
  EXPECT_EQ(valuesOf(strokes, "Magnetic"), (std::vector<double>{ 0.0, 0.0 }));
  EXPECT_EQ(valuesOf(strokes, "SnapRadius"), (std::vector<double>{ 10.0, 10.0 }));
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    vtkNew<vtkIdList> ids;
    strokes->GetLines()->GetCellAtId(cell, ids);
    EXPECT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1)) << "closed";
  }
  const View seen = ViewOf(strokes);
  EXPECT_EQ(seen.width(), side);
  EXPECT_EQ(seen.height(), side);
  tracing.trace->SetHolesToHole();
  EXPECT_EQ(valuesOf(tracing.strokes(), "Treatment"), (std::vector<double>{ 0.0, 1.0 }));
  tracing.trace->SetHolesToFill();
  EXPECT_EQ(valuesOf(tracing.strokes(), "Treatment"), (std::vector<double>{ 0.0 }));
}

TEST(TraceFilter, OnTheCanvasTheyLieOnTheThing)
{
  const auto image = ringPicture();
  image->SetOrigin(-3.0, 7.0, 0.0);
  image->SetSpacing(0.5, 0.25, 1.0);
  Tracing tracing(image);
  tracing.trace->SetPlace(middleOfThing[0] + 40.5, middleOfThing[1] + 0.5);
  vtkNew<vtkOversketchCanvas> canvas;
  canvas->SetInputConnection(tracing.trace->GetOutputPort());
  canvas->SetPictureData(image);
  canvas->Update();
  ASSERT_EQ(canvas->GetOutput()->GetNumberOfLines(), 2);
  EXPECT_EQ(valuesOf(canvas->GetOutput(), "Closed"), (std::vector<double>{ 1.0, 1.0 }));
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    for (const Vector3& place : pointsOfCell(canvas->GetOutput(), cell))
    {
      const Vector2 pixel = (place.head<2>() - Vector2(-3.0, 7.0)).cwiseQuotient(Vector2(0.5, 0.25));
      EXPECT_NEAR((pixel - middleOfThing).norm(), cell == 0 ? 60.0 : 25.0, 1.5);
    }
  }
}

TEST(TraceFilter, PicturesOfAllKindsHaveTheSameOutlines)
{
  Tracing usual(ringPicture());
  for (const int channels : { 1, 2, 3, 4 })
  {
    Tracing eight(ringPicture(channels)), sixteen(ringPicture<vtkUnsignedShortArray>(channels));
    expectSameCurves(eight.strokes(), usual.strokes());
    expectSameCurves(sixteen.strokes(), usual.strokes());
  }
}

TEST(TraceFilter, ThreadsChangeNothingAndOnlyWhatIsNewIsTraced)
{
  Tracing one(ringPicture()), two(ringPicture());
  vtkSMPTools::Initialize(1);
  one.strokes();
  vtkSMPTools::Initialize(2);
  expectSameCurves(one.strokes(), two.strokes());
  vtkSMPTools::Initialize(0);
  one.trace->Modified();
  one.strokes();
  EXPECT_EQ(one.trace->GetTraceCount(), 1);
  one.trace->SetPlace(middleOfThing[0] + 40.0, middleOfThing[1]);
  one.strokes();
  EXPECT_EQ(one.trace->GetTraceCount(), 2);
}

TEST(TraceFilter, WhatCannotBeTracedIsRefused)
{
  const auto even = picture(50, 40, 3, [](int, int, int) { return 90; });
  expectRefusal(Tracing(even).trace, Failure::BadStroke, "nothing to trace");
  Tracing beyond(ringPicture());
  beyond.trace->SetPlace(side + 1.0, 5.0);
  expectRefusal(beyond.trace, Failure::BadStroke, "beyond the picture");
  beyond.trace->SetPlace(std::nan(""), 5.0);
  expectRefusal(beyond.trace, Failure::BadStroke, "Place");
  const auto bare = ringPicture();
  bare->GetPointData()->SetScalars(nullptr);
  expectRefusal(Tracing(bare).trace, Failure::MissingArray, "no scalars");
  const auto numbers = ringPicture();
  vtkNew<vtkDoubleArray> reals;
  reals->SetNumberOfTuples(numbers->GetNumberOfPoints());
  reals->Fill(0.0);
  numbers->GetPointData()->SetScalars(reals);
  expectRefusal(Tracing(numbers).trace, Failure::BadStroke, "type double");
  expectRefusal(Tracing(ringPicture(5)).trace, Failure::BadStroke, "5 components");
  vtkNew<vtkImageData> thick;
  thick->SetDimensions(4, 4, 3);
  thick->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  expectRefusal(Tracing(thick).trace, Failure::BadStroke, "3 slices");
  vtkNew<vtkImageData> nothing;
  Tracing none(nothing);
  EXPECT_EQ(none.strokes()->GetNumberOfPoints(), 0);
}

TEST(TraceFilter, ACancelLeavesNothing)
{
  Tracing tracing(ringPicture());
  expectCancel(tracing.trace);
  expectCancel(tracing.trace, 0.4);
  EXPECT_EQ(tracing.strokes()->GetNumberOfLines(), 2);
}
