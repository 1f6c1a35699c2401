// Facts of editors.md, section 13, area selection, by the filter.
#include "ShadingScenes.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// The middle of a texel of 256 x 256 on the disc.
Vector2 texel(double i, double j)
{
  return { (2.0 * i + 1.0) / 256.0 - 1.0, (2.0 * j + 1.0) / 256.0 - 1.0 };
}

struct Filled
{
  vtkNew<vtkOversketchScanFill> filter;

  explicit Filled(vtkPolyData* strokes, int resolution = 256)
  {
    this->filter->SetInputData(strokes);
    this->filter->SetResolution(resolution);
    this->filter->Update();
  }
  vtkDataArray* area() { return this->filter->GetMaskOutput()->GetPointData()->GetScalars(); }
  int count(int component = 0)
  {
    int sum = 0;
    for (vtkIdType i = 0; i < this->area()->GetNumberOfTuples(); ++i)
      sum += this->area()->GetComponent(i, component) != 0.0;
    return sum;
  }
  bool at(int i, int j, int component = 0)
  {
    return this->area()->GetComponent(static_cast<vtkIdType>(j) * 256 + i, component) != 0.0;
  }
};

std::vector<Vector2> texels(const std::vector<std::array<int, 2>>& pixels)
{
  std::vector<Vector2> outline;
  outline.reserve(pixels.size());
  for (const auto& [i, j] : pixels)
    outline.push_back(texel(i, j));
  return outline;
}

} // namespace

TEST(B7_6, ByTheFilterInOneMask)
{
  // One stroke each, all in one mask.
  Filled fill(areasOnDisc({ texels({ { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 } }),
    texels({ { 0, 0 }, { 10, 0 }, { 0, 10 } }),
    texels({ { 0, 0 }, { 10, 10 }, { 10, 0 }, { 0, 10 } }),
    texels({ { 100, 180 }, { 53, 35 }, { 176, 125 }, { 24, 125 }, { 147, 35 } }),
    texels({ { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 }, { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 } }),
    texels({ { 5, 5 }, { 90, 90 } }),
    texels({ { 7, 7 } }) }));
  ASSERT_EQ(fill.filter->GetErrorCode(), 0u);
  ASSERT_EQ(fill.area()->GetNumberOfComponents(), 7);
  const int counts[7] = { 100, 55, 50, 4935, 0, 0, 0 };
  for (int k = 0; k < 7; ++k)
    EXPECT_EQ(fill.count(k), counts[k]) << "area " << k;
  EXPECT_TRUE(fill.at(0, 0));
  EXPECT_FALSE(fill.at(10, 0));
  EXPECT_FALSE(fill.at(0, 10));
  EXPECT_FALSE(fill.at(100, 100, 3)) << "the pentagram's centre";
  // The mask lies over the disc, the areas on it are closed.
  vtkImageData* mask = fill.filter->GetMaskOutput();
  EXPECT_NEAR(mask->GetPoint(0)[0], texel(0, 0)[0], 1e-15);
  EXPECT_NEAR(mask->GetBounds()[1], texel(255, 0)[0], 1e-12);
  vtkNew<vtkIdList> ids;
  fill.filter->GetOutput()->GetLines()->GetCellAtId(1, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 4);
  EXPECT_EQ(ids->GetId(0), ids->GetId(3));
  fact("B7_6", "by the filter: 100, 55, 50, 4935 and 0 texels in one mask");
}

TEST(ScanFillFilter, AStrokeSelectsTheSameInEveryWindow)
{
  const std::vector<std::array<int, 2>> star{
    { 100, 180 }, { 53, 35 }, { 176, 125 }, { 24, 125 }, { 147, 35 }
  };
  const auto drawn = [&](double pixels, int width, bool perspective)
  {
    const View view = perspective ? perspectiveView({ 0.3, -0.4, 3.0 }, { 0, 1, 0 }, 40.0, width, width)
                                  : orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, pixels, width, width);
    std::vector<Vector2> samples;
    for (const auto& [i, j] : star)
    {
      const Vector2 place = texel(i, j);
      samples.emplace_back(view.toDisplay({ place[0], place[1], 0.0 }).head<2>());
    }
    return toStroke(samples, view);
  };
  Filled flat(areasOnDisc({ texels(star) })), small(drawn(60.0, 200, false)),
    large(drawn(700.0, 1600, false)), askew(drawn(0.0, 900, true));
  EXPECT_EQ(flat.count(), 4935);
  for (Filled* other : { &small, &large, &askew })
  {
    EXPECT_TRUE(sameBits(other->area(), flat.area()));
    EXPECT_FALSE(other->filter->GetOutput()->GetCellData()->HasArray("ViewTransform"));
    EXPECT_NEAR(other->filter->GetOutput()->GetPoint(2)[0], texel(176, 125)[0], 1e-9);
  }
}

TEST(ScanFillFilter, StrokesOfSeveralViewsStandTogether)
{
  const View near = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 400.0),
             far = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 90.0);
  const auto strokes = toStroke({ { 0, 0 } }, near);
  // Two strokes round the same place, each in its own view.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const View* view : { &near, &far })
  {
    lines->InsertNextCell(4);
    for (const Vector3& corner :
      { Vector3(-0.3, -0.3, 0), Vector3(0.3, -0.3, 0), Vector3(0.3, 0.3, 0), Vector3(-0.3, 0.3, 0) })
      lines->InsertCellPoint(points->InsertNextPoint(view->toDisplay(corner).data()));
    const auto one = toStroke({ { 0, 0 } }, *view);
    for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
      if (view == &far)
        strokes->GetCellData()->GetArray(name)->InsertNextTuple(
          one->GetCellData()->GetArray(name)->GetTuple(0));
  }
  strokes->SetPoints(points);
  strokes->SetLines(lines);
  Filled fill(strokes, 64);
  ASSERT_EQ(fill.filter->GetErrorCode(), 0u);
  EXPECT_EQ(fill.count(0), fill.count(1));
  EXPECT_NEAR(fill.count(0), 0.09 * 64 * 64, 60);
}

TEST(ScanFillFilter, BeyondTheDiscIsCutOff)
{
  Filled fill(areasOnDisc({ { { -5, -5 }, { 5, -5 }, { 5, 5 }, { -5, 5 } } }));
  EXPECT_EQ(fill.count(), 256 * 256);
  Filled half(areasOnDisc({ { { -5, -5 }, { texel(128, 0)[0], -5 }, { texel(128, 0)[0], 5 }, { -5, 5 } } }));
  EXPECT_EQ(half.count(), 128 * 256);
}

TEST(ScanFillFilter, FillsOnceForTheSameStrokes)
{
  const auto strokes = areasOnDisc({ { { 0, 0 }, { 0.5, 0 }, { 0, 0.5 } } });
  Filled fill(strokes);
  vtkDataArray* const first = fill.area();
  fill.filter->Modified();
  fill.filter->Update();
  EXPECT_EQ(fill.area(), first);
  EXPECT_EQ(fill.filter->GetFillCount(), 1);
  fill.filter->SetResolution(100);
  fill.filter->Update();
  EXPECT_EQ(fill.filter->GetMaskOutput()->GetDimensions()[0], 100);
  EXPECT_EQ(fill.filter->GetFillCount(), 2);
}

TEST(ScanFillFilter, RefusesAndCancels)
{
  const auto refused = [](vtkPolyData* strokes, Failure failure, const char* words)
  {
    vtkNew<vtkOversketchScanFill> filter;
    filter->SetInputData(strokes);
    expectRefusal(filter, failure, words);
    EXPECT_EQ(filter->GetMaskOutput()->GetNumberOfPoints(), 0);
  };
  const double nan = std::nan("");
  refused(areasOnDisc({ { { 0, 0 }, { nan, 0 }, { 0, 1 } } }), Failure::BadStroke, "not finite");
  refused(areasOnDisc({ { { 0, 0 }, { 1, 0 } }, { { 0, 0 }, { 1e9, 0 }, { 0, 1 } } }),
    Failure::BadStroke,
    "Sample 1 of area 1 lies far outside the disc");
  refused(areasOnDisc(std::vector<std::vector<Vector2>>(65, { { 0, 0 }, { 1, 0 } })),
    Failure::BadStroke,
    "There are 65 areas; there can be 64");
  refused(toPolyData(icosphere(1)), Failure::BadStroke, "");
  const View edge = orthographicView({ 0, 1, 0 }, { 0, 0, 1 }, 100.0);
  refused(toStroke({ { 10, 10 }, { 50, 10 }, { 50, 60 } }, edge),
    Failure::BadStroke,
    "Sample 0 of area 0 does not meet the disc in the view");
  const auto partly = toStroke({ { 10, 10 }, { 50, 10 }, { 50, 60 } }, edge);
  partly->GetCellData()->RemoveArray("ViewportSize");
  refused(partly, Failure::MissingArray, "no array ViewportSize");
  Filled fill(areasOnDisc({ { { 0, 0 }, { 0.5, 0 }, { 0, 0.5 } } }));
  fill.filter->SetResolution(32);
  expectCancel(fill.filter);
  fill.filter->Update();
  EXPECT_EQ(fill.filter->GetMaskOutput()->GetNumberOfPoints(), 32 * 32);
  vtkNew<vtkPolyData> nothing;
  Ear ear(fill.filter);
  fill.filter->SetInputData(nothing);
  fill.filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(fill.filter->GetMaskOutput()->GetNumberOfPoints(), 0);
  // A hundred thousand samples of a hand that trembles.
  std::vector<Vector2> many;
  many.reserve(100000);
  for (int i = 0; i < 100000; ++i)
    many.emplace_back(0.5 * std::cos(0.001 * i) + 0.01 * std::sin(7.0 * i), 0.5 * std::sin(0.001 * i));
  Filled trembling(areasOnDisc({ many }));
  EXPECT_EQ(trembling.filter->GetErrorCode(), 0u);
}
