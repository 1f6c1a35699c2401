#include "Harness/drawings.h"
#include "Harness/promises.h"
#include "vtkOversketchCanvas.h"
#include "vtkOversketchMagneticSnap.h"

#include "vtkFloatArray.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr double discRadius = 60.0;
const Vector2 middle(100.0, 100.0);

// A circle 5 px outside the disc, a line beside it, and the circle again, not magnetic.
vtkSmartPointer<vtkPolyData> circleAndLine(vtkImageData* image)
{
  const View view = viewOfPicture(image);
  // Display px of a picture's own view count from its corner, samples lie half a pixel in.
  const Vector2 half(0.5, 0.5);
  auto drawing = toStrokes({ { ring(middle + half, discRadius + 5.0, 140), view },
                             { straight({ 10, 15 }, { 190, 15 }, 60), view },
                             { ring(middle + half, discRadius + 5.0, 140), view } },
    { true, false, true });
  drawing->GetCellData()->AddArray(arrayOf<vtkIntArray>("Magnetic", { 1, 1, 0 }));
  return drawing;
}

struct Snapping
{
  vtkNew<vtkOversketchCanvas> canvas;
  vtkNew<vtkOversketchMagneticSnap> snap;

  explicit Snapping(vtkImageData* image, vtkPolyData* drawing = nullptr)
  {
    this->canvas->SetInputData(drawing ? drawing : circleAndLine(image).Get());
    this->canvas->SetPictureData(image);
    this->snap->SetInputConnection(this->canvas->GetOutputPort());
    this->snap->SetPictureData(image);
  }
  // Mean distance of a curve's points to the disc's edge, in px of the picture.
  double fromEdge(vtkIdType cell)
  {
    const Vector2 spacing(vtkImageData::SafeDownCast(this->snap->GetInputDataObject(1, 0))->GetSpacing());
    const Vector2 origin(vtkImageData::SafeDownCast(this->snap->GetInputDataObject(1, 0))->GetOrigin());
    const std::vector<Vector3> points = pointsOfCell(this->snap->GetOutput(), cell);
    double sum = 0.0;
    for (const Vector3& p : points)
      sum += std::abs(((p.head<2>() - origin).cwiseQuotient(spacing) - middle).norm() - discRadius);
    return sum / static_cast<double>(points.size());
  }
};

} // namespace

TEST(MagneticSnapFilter, OnlyMagneticStrokesOnEdgesMove)
{
  const auto image = discPicture(200, discRadius, middle);
  Snapping chain(image);
  chain.snap->Update();
  ASSERT_EQ(chain.snap->GetErrorCode(), 0u);
  EXPECT_LT(chain.fromEdge(0), 1.0);
  EXPECT_NEAR(chain.fromEdge(2), 5.0, 1e-6);
  vtkPolyData* output = chain.snap->GetOutput();
  vtkPolyData* before = chain.canvas->GetOutput();
  EXPECT_EQ(pointsOfCell(output, 1), pointsOfCell(before, 1)) << "no edge there: as drawn, to the bit";
  EXPECT_EQ(pointsOfCell(output, 2), pointsOfCell(before, 2));
  vtkDataArray* snapped = output->GetPointData()->GetArray("Snapped");
  vtkNew<vtkIdList> ids;
  output->GetLines()->GetCellAtId(0, ids);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    EXPECT_EQ(snapped->GetComponent(i, 0), i < ids->GetNumberOfIds() - 1 ? 1.0 : 0.0);
  EXPECT_TRUE(output->GetCellData()->HasArray("Magnetic"));
  // Without edges in reach nothing moves, however magnetic.
  const auto narrow = circleAndLine(image);
  narrow->GetCellData()->AddArray(arrayOf("SnapRadius", { 4.0, 4.0, 4.0 }));
  Snapping near(image, narrow);
  near.snap->Update();
  EXPECT_NEAR(near.fromEdge(0), 5.0, 1e-6);
}

TEST(MagneticSnapFilter, PicturesOfAllKindsHaveTheSameEdges)
{
  const auto inside = [](int x, int y) { return (Vector2(x, y) - middle).norm() <= discRadius; };
  const std::vector<std::pair<const char*, vtkSmartPointer<vtkImageData>>> kinds{
    { "grey", picture(200, 200, 1, [&](int x, int y, int) { return inside(x, y) ? 220 : 30; }) },
    { "RGB", picture(200, 200, 3, [&](int x, int y, int) { return inside(x, y) ? 220 : 30; }) },
    { "opaque RGBA",
      picture(200,
        200,
        4,
        [&](int x, int y, int c) { return c == 3 || inside(x, y) ? (c == 3 ? 255 : 220) : 30; }) },
    { "grey of 16 bits",
      picture<vtkUnsignedShortArray>(
        200, 200, 1, [&](int x, int y, int) { return inside(x, y) ? 220 : 30; }) },
    { "RGB of 16 bits",
      picture<vtkUnsignedShortArray>(
        200, 200, 3, [&](int x, int y, int) { return inside(x, y) ? 220 : 30; }) },
    // On white, what is transparent by 190 of 255 of black looks like 65.
    { "black through alpha",
      picture(200, 200, 2, [&](int x, int y, int c) { return c == 0         ? 0
                                                             : inside(x, y) ? 35
                                                                            : 225; }) }
  };
  Snapping first(kinds[0].second);
  first.snap->Update();
  for (const auto& [name, image] : kinds)
  {
    Snapping chain(image);
    chain.snap->Update();
    ASSERT_EQ(chain.snap->GetErrorCode(), 0u) << name;
    SCOPED_TRACE(name);
    expectSameCurves(chain.snap->GetOutput(), first.snap->GetOutput());
  }
}

TEST(MagneticSnapFilter, TheSameDrawingTinyFarAndOnOblongPixels)
{
  const auto here = discPicture(200, discRadius, middle);
  Snapping home(here);
  home.snap->Update();
  const double expected = home.fromEdge(0);
  const struct
  {
    Vector2 origin, spacing;
  } places[] = {
    { { 0, 0 }, { 1e-6 / 200, 1e-6 / 200 } }, { { 5e6, -5e6 }, { 1, 1 } }, { { -3, 2 }, { 2.0, 0.5 } }
  };
  for (const auto& place : places)
  {
    const auto image = discPicture(200, discRadius, middle);
    image->SetOrigin(place.origin[0], place.origin[1], 0.0);
    image->SetSpacing(place.spacing[0], place.spacing[1], 1.0);
    Snapping chain(image);
    chain.snap->Update();
    ASSERT_EQ(chain.snap->GetErrorCode(), 0u);
    EXPECT_NEAR(chain.fromEdge(0), expected, 0.3) << place.spacing.transpose();
    EXPECT_EQ(chain.snap->GetOutput()->GetPointData()->GetArray("Snapped")->GetComponent(0, 0), 1.0);
  }
}

TEST(MagneticSnapFilter, AsPublishedNothingIsSmoothed)
{
  const auto image = discPicture(200, discRadius, middle);
  Snapping amended(image), published(image);
  published.snap->AsPublishedOn();
  for (Snapping* chain : { &amended, &published })
    chain->snap->Update();
  // Not smoothed, points are the centres of pixels.
  for (const Vector3& p : pointsOfCell(published.snap->GetOutput(), 0))
    EXPECT_NEAR((p - Vector3(p.array().round())).norm(), 0.0, 1e-9);
  EXPECT_NE(pointsOfCell(amended.snap->GetOutput(), 0), pointsOfCell(published.snap->GetOutput(), 0));
}

TEST(MagneticSnapFilter, ANewStrokeIsSearchedForAlone)
{
  const auto image = discPicture(200, discRadius, middle);
  const auto drawing = circleAndLine(image);
  Snapping chain(image, drawing);
  chain.snap->Update();
  EXPECT_EQ(chain.snap->GetEdgeCount(), 1);
  EXPECT_EQ(chain.snap->GetSnapCount(), 2);
  const std::vector<Vector3> first = pointsOfCell(chain.snap->GetOutput(), 0);
  drawing->GetCellData()->AddArray(arrayOf<vtkIntArray>("Magnetic", { 1, 1, 1 }));
  drawing->Modified();
  chain.snap->Update();
  EXPECT_EQ(chain.snap->GetEdgeCount(), 1);
  EXPECT_EQ(chain.snap->GetSnapCount(), 2) << "the third is the first once more";
  EXPECT_EQ(pointsOfCell(chain.snap->GetOutput(), 2).size(), first.size());
  drawing->GetCellData()->AddArray(arrayOf("SnapRadius", { 10, 12, 10 }));
  drawing->Modified();
  chain.snap->Update();
  EXPECT_EQ(chain.snap->GetSnapCount(), 3);
  chain.snap->AsPublishedOn();
  chain.snap->Update();
  EXPECT_EQ(chain.snap->GetEdgeCount(), 2) << "of the brightness";
  EXPECT_EQ(chain.snap->GetSnapCount(), 5);
  // An array that is not read keeps the points.
  vtkDataArray* const points = chain.snap->GetOutput()->GetPoints()->GetData();
  drawing->GetCellData()->AddArray(arrayOf<vtkIntArray>("Treatment", { 0, 0, 1 }));
  drawing->Modified();
  chain.snap->Update();
  EXPECT_EQ(chain.snap->GetOutput()->GetPoints()->GetData(), points);
  image->GetPointData()->GetScalars()->SetComponent(0, 0, 31);
  image->GetPointData()->GetScalars()->Modified();
  image->Modified();
  chain.snap->Update();
  EXPECT_EQ(chain.snap->GetEdgeCount(), 3);
}

TEST(MagneticSnapFilter, EdgesFoundAheadAreTheStrokes)
{
  const auto image = discPicture(200, discRadius, middle);
  const auto drawing = circleAndLine(image);
  Snapping ahead(image, drawing), alone(image, drawing);
  ahead.snap->Prepare();
  EXPECT_EQ(ahead.snap->GetEdgeCount(), 1);
  EXPECT_EQ(ahead.snap->GetSnapCount(), 0);
  ahead.snap->Update();
  alone.snap->Update();
  EXPECT_EQ(ahead.snap->GetEdgeCount(), 1);
  expectSameCurves(ahead.snap->GetOutput(), alone.snap->GetOutput());
}

TEST(MagneticSnapFilter, OneAndTwoThreadsGiveTheSameBits)
{
  const auto image = discPicture(200, discRadius, middle);
  Snapping one(image), two(image);
  vtkSMPTools::Initialize(1);
  one.snap->Update();
  vtkSMPTools::Initialize(2);
  two.snap->Update();
  vtkSMPTools::Initialize();
  expectSameCurves(one.snap->GetOutput(), two.snap->GetOutput());
}

TEST(MagneticSnapFilter, ASinglePixelAndStrokesBesideThePictureAreNoFault)
{
  const auto dot = picture(1, 1, 1, [](int, int, int) { return 90; });
  const View view = viewOfPicture(dot);
  const auto drawing = toStrokes({ { straight({ 0.1, 0.2 }, { 0.9, 0.7 }, 7), view },
    { straight({ 5, 5 }, { 400, 90 }, 7), view },
    { { { 0.5, 0.5 } }, view },
    { { { 0.5, 0.5 }, { 0.5, 0.5 } }, view } });
  drawing->GetCellData()->AddArray(arrayOf<vtkIntArray>("Magnetic", { 1, 1, 1, 1 }));
  Snapping chain(dot, drawing);
  chain.snap->Update();
  ASSERT_EQ(chain.snap->GetErrorCode(), 0u);
  for (vtkIdType cell = 0; cell < 4; ++cell)
    EXPECT_EQ(pointsOfCell(chain.snap->GetOutput(), cell), pointsOfCell(chain.canvas->GetOutput(), cell));
}

TEST(MagneticSnapFilter, RefusesAndCancels)
{
  const auto image = discPicture(200, discRadius, middle);
  const auto drawing = circleAndLine(image);
  Snapping chain(image, drawing);
  const auto snap = chain.snap.Get();
  snap->SetInputConnection(1, nullptr);
  expectRefusal(snap, Failure::BadStroke, "Stroke 0 cannot be used: it is magnetic, and there is no picture");
  const auto real = discPicture(200, discRadius, middle);
  real->GetPointData()->SetScalars(vtkNew<vtkFloatArray>());
  snap->SetPictureData(real);
  snap->Prepare(); // says nothing
  expectRefusal(snap, Failure::BadStroke, "scalars are of type float");
  real->GetPointData()->SetScalars(nullptr);
  real->Modified();
  expectRefusal(snap, Failure::MissingArray, "The picture has no scalars");
  snap->SetPictureData(picture(200, 200, 5, [](int, int, int) { return 0; }));
  expectRefusal(snap, Failure::BadStroke, "another number of channels");
  snap->SetPictureData(image);
  drawing->GetCellData()->AddArray(
    arrayOf("SnapRadius", { 10.0, std::numeric_limits<double>::quiet_NaN(), 1.0 }));
  drawing->Modified();
  expectRefusal(snap, Failure::BadStroke, "Stroke 1 cannot be used: its SnapRadius is not finite");
  drawing->GetCellData()->RemoveArray("SnapRadius");
  drawing->Modified();
  expectCancel(snap);
  snap->Update();
  EXPECT_LT(chain.fromEdge(0), 1.0);
  // No magnetic stroke needs no picture.
  drawing->GetCellData()->RemoveArray("Magnetic");
  drawing->Modified();
  snap->SetInputConnection(1, nullptr);
  snap->Update();
  EXPECT_EQ(snap->GetErrorCode(), 0u);
  EXPECT_EQ(snap->GetOutput()->GetPointData()->GetArray("Snapped")->GetRange()[1], 0.0);
}
