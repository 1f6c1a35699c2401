#include "CurveShapes.h"
#include "vtkOversketchClassify.h"
#include "vtkOversketchDistance.h"
#include "vtkOversketchTreatment.h"

#include "vtkImageShiftScale.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

struct Depths
{
  vtkNew<vtkOversketchClassify> classify;
  vtkNew<vtkOversketchTreatment> treatment;
  vtkNew<vtkOversketchDistance> distance;

  explicit Depths(vtkPolyData* curves)
  {
    this->classify->SetInputData(curves);
    this->treatment->SetInputConnection(this->classify->GetOutputPort());
    this->distance->SetInputConnection(this->treatment->GetOutputPort());
  }
  vtkImageData* image()
  {
    this->distance->Update();
    return this->distance->GetDistanceOutput();
  }
};

std::vector<double> valuesOf(vtkImageData* image, const char* name)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    values.push_back(array->GetComponent(i, 0));
  return values;
}

} // namespace

TEST(TreatmentFilter, NamesHolesAndTunnelsAndKeepsTheRest)
{
  const auto curves = toCurves(bodyWithFeatures());
  Depths chain(curves);
  chain.treatment->Update();
  EXPECT_EQ(cellValues(chain.treatment->GetOutput(), "Treatment"), (std::vector<int>{ 0, 0, 0, 0, 0 }));
  chain.treatment->SetHoles(" 4");
  chain.treatment->SetTunnels("1,1");
  chain.treatment->Update();
  EXPECT_EQ(cellValues(chain.treatment->GetOutput(), "Treatment"), (std::vector<int>{ 0, 2, 0, 0, 1 }));
  EXPECT_STREQ(chain.treatment->GetHoles(), " 4");
  // What the drawing itself says stands where it is not named.
  vtkNew<vtkIntArray> said;
  said->SetName("Treatment");
  for (const int value : { 0, 1, 0, 0, 2 })
    said->InsertNextValue(value);
  curves->GetCellData()->AddArray(said);
  curves->Modified();
  chain.treatment->SetHoles("");
  chain.treatment->SetTunnels("1");
  chain.treatment->Update();
  EXPECT_EQ(cellValues(chain.treatment->GetOutput(), "Treatment"), (std::vector<int>{ 0, 2, 0, 0, 2 }));
  EXPECT_EQ(said->GetValue(1), 1) << "the input is untouched";
  EXPECT_EQ(chain.classify->GetClassificationCount(), 1) << "a click classifies nothing anew";
}

TEST(TreatmentFilter, RefusesWhatIsNoClosedFeature)
{
  const auto curves = toCurves(bodyWithFeatures());
  Depths chain(curves);
  const auto filter = chain.treatment.Get();
  const struct
  {
    const char *holes, *tunnels, *words;
  } cases[] = { { "0", "", "Holes names stroke 0, which is no closed stroke inside another" },
    { "", "3", "Tunnels names stroke 3, which is no closed stroke inside another" },
    { "5", "", "Holes names stroke 5, but there are 5, numbered from 0" },
    { "-1", "", "Holes names stroke -1, but there are 5" },
    { "1", "4 1", "Tunnels names stroke 1, which Holes names too" },
    { "1 x", "", "Holes is \"1 x\"; give numbers of strokes" },
    { "1.5", "", "give numbers of strokes" },
    { "99999999999", "", "give numbers of strokes" } };
  for (const auto& each : cases)
  {
    filter->SetHoles(each.holes);
    filter->SetTunnels(each.tunnels);
    expectRefusal(filter, Failure::BadStroke, each.words);
  }
  filter->SetHoles(nullptr);
  filter->SetTunnels(nullptr);
  vtkNew<vtkIntArray> wrong;
  wrong->SetName("Treatment");
  wrong->SetNumberOfTuples(5);
  wrong->Fill(3);
  curves->GetCellData()->AddArray(wrong);
  curves->Modified();
  expectRefusal(filter, Failure::BadStroke, "Treatment of stroke 0 is none");
  filter->SetInputData(toCurves(bodyWithFeatures()));
  expectRefusal(filter, Failure::MissingArray, "no array Role: take the curves from vtkOversketchClassify");
}

TEST(DistanceFilter, TheMapsAreInTheWorldAndTheCurvesGoThrough)
{
  // A disc of radius 200 px about (500, 500) on a canvas of half a unit a pixel, far away.
  const Vector2 corner(-3000.0, 70.0);
  Polyline points = ringAt(500, 500, 200);
  for (Vector2& p : points)
    p = corner + 0.5 * p;
  Depths chain(toCurves({ closedStroke(points) }, { corner, Vector2(512.0, 512.0) }));
  vtkImageData* image = chain.image();
  ASSERT_EQ(chain.distance->GetErrorCode(), 0u);
  EXPECT_EQ(image->GetSpacing()[0], 0.5);
  double centre[3] = { corner[0] + 250.0, corner[1] + 250.0, 0.0 };
  const vtkIdType middle = image->FindPoint(centre);
  vtkPointData* data = image->GetPointData();
  EXPECT_NEAR(data->GetArray("T")->GetComponent(middle, 0), 200.0, 1.5);
  EXPECT_EQ(data->GetScalars(), data->GetArray("T"));
  EXPECT_EQ(data->GetArray("Object")->GetComponent(middle, 0), 0.0);
  EXPECT_EQ(data->GetArray("Object")->GetComponent(0, 0), -1.0);
  const std::vector<double> t = valuesOf(image, "T"), d = valuesOf(image, "LocalMax");
  for (std::size_t i = 0; i < t.size(); ++i)
    ASSERT_GE(d[i], t[i]);
  EXPECT_EQ(chain.distance->GetOutput()->GetPoints(), chain.classify->GetOutput()->GetPoints());
  EXPECT_TRUE(chain.distance->GetOutput()->GetCellData()->HasArray("Treatment"));
}

TEST(DistanceFilter, OnlyRimsComputeItAnew)
{
  std::vector<DrawnStroke> strokes = bodyWithFeatures();
  Depths chain(toCurves(strokes));
  vtkDataArray* const first = chain.image()->GetPointData()->GetArray("T");
  const std::vector<double> values = valuesOf(chain.image(), "T");
  // A new feature, a tunnel: the same arrays.
  strokes.push_back(openStroke({ { 500, 200 }, { 520, 260 } }));
  chain.classify->SetInputData(toCurves(strokes));
  EXPECT_EQ(chain.image()->GetPointData()->GetArray("T"), first);
  chain.treatment->SetTunnels("4");
  EXPECT_EQ(chain.image()->GetPointData()->GetArray("T"), first);
  EXPECT_EQ(chain.distance->GetDistanceCount(), 1);
  // A hole, and no hole again.
  chain.treatment->SetTunnels("");
  chain.treatment->SetHoles("4");
  EXPECT_NE(valuesOf(chain.image(), "T"), values);
  EXPECT_EQ(chain.distance->GetDistanceCount(), 2);
  chain.treatment->SetHoles("");
  EXPECT_EQ(valuesOf(chain.image(), "T"), values);
  chain.distance->SetLocalMaxModeToGlobal();
  const double greatest = chain.image()->GetPointData()->GetArray("T")->GetRange()[1];
  for (const double d : valuesOf(chain.image(), "LocalMax"))
    ASSERT_TRUE(d == 0.0 || d == greatest);
  EXPECT_EQ(chain.distance->GetDistanceCount(), 4);
  chain.classify->SetResolution(512);
  EXPECT_EQ(chain.image()->GetDimensions()[0], 516);
  EXPECT_EQ(chain.distance->GetDistanceCount(), 5);
}

TEST(DistanceFilter, AnImageFilterTakesTheMaps)
{
  Depths chain(toCurves(bodyWithFeatures()));
  vtkNew<vtkImageShiftScale> shift;
  shift->SetInputConnection(chain.distance->GetOutputPort(1));
  for (const int resolution : { 64, 1024, 200 })
  {
    chain.classify->SetResolution(resolution);
    shift->Update();
    EXPECT_EQ(shift->GetOutput()->GetDimensions()[0], resolution + 4);
    EXPECT_GT(shift->GetOutput()->GetScalarRange()[1], 0.1 * resolution);
  }
  EXPECT_EQ(chain.distance->GetDistanceCount(), 3);
}

TEST(DistanceFilter, WithoutAnObjectThereIsNoInside)
{
  Depths chain(toCurves({ openStroke({ { 5, 5 }, { 90, 90 } }) }));
  Ear ear(chain.classify);
  vtkImageData* image = chain.image();
  EXPECT_EQ(ear.warnings.size(), 1u);
  EXPECT_EQ(chain.distance->GetErrorCode(), 0u);
  EXPECT_EQ(image->GetPointData()->GetArray("T")->GetRange()[1], 0.0);
  EXPECT_EQ(image->GetPointData()->GetArray("Object")->GetRange()[1], -1.0);
}

TEST(DistanceFilter, OneAndTwoThreadsGiveTheSameBits)
{
  Depths one(toCurves(bodyWithFeatures())), two(toCurves(bodyWithFeatures()));
  vtkSMPTools::Initialize(1);
  vtkPointData* a = one.image()->GetPointData();
  vtkSMPTools::Initialize(2);
  vtkPointData* b = two.image()->GetPointData();
  vtkSMPTools::Initialize();
  ASSERT_EQ(a->GetNumberOfArrays(), 4);
  for (const char* name : { "T", "LocalMax", "Skeleton", "Object" })
    EXPECT_EQ(std::memcmp(a->GetArray(name)->GetVoidPointer(0),
                b->GetArray(name)->GetVoidPointer(0),
                static_cast<std::size_t>(
                  a->GetArray(name)->GetNumberOfValues() * a->GetArray(name)->GetDataTypeSize())),
      0)
      << name;
}

TEST(DistanceFilter, RefusesAndCancels)
{
  const auto curves = toCurves(bodyWithFeatures());
  Depths chain(curves);
  vtkNew<vtkOversketchDistance> filter;
  filter->SetInputData(curves);
  expectRefusal(filter, Failure::MissingArray, "no array Role");
  chain.classify->Update();
  const auto spoilt = vtkSmartPointer<vtkPolyData>::New();
  spoilt->ShallowCopy(chain.classify->GetOutput());
  const auto spoil = [&](const char* name, const std::vector<int>& values)
  {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    for (const int value : values)
      array->InsertNextValue(value);
    spoilt->ShallowCopy(chain.classify->GetOutput());
    spoilt->GetCellData()->AddArray(array);
    filter->SetInputData(spoilt);
    filter->Modified();
  };
  spoil("Role", { 0, 2, 3, 3, 2 });
  expectRefusal(filter, Failure::BadStroke, "Stroke 0 has no Role");
  spoil("RegionId", { 0, 0, 1, 7, 0 });
  expectRefusal(filter, Failure::BadStroke, "Stroke 3 lies in a region that there is not");
  spoil("RegionId", { 0, 2, 1, 0, 1 });
  expectRefusal(filter, Failure::BadStroke, "lies in a region that it is round");
  spoil("ChildRegionId", { -1, 2, -1, -1, 1 });
  expectRefusal(filter, Failure::BadStroke, "Stroke 1 does not bound the next region");
  spoil("ObjectId", { 0, 0, 0, 1, 0 });
  expectRefusal(filter, Failure::BadStroke, "Stroke 3 lies in a region that there is not");
  filter->SetInputData(chain.classify->GetOutput());
  expectCancel(filter, 0.05);
  filter->Update();
  EXPECT_GT(filter->GetDistanceOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetDistanceOutput()->GetNumberOfPoints(), 0);
}

TEST(DrawingTools, ClassificationsAndMapsComeBackAsTheyWere)
{
  std::vector<DrawnStroke> strokes = bodyWithFeatures();
  strokes.push_back(closedStroke(ringAt(350, 450, 30)));
  strokes.push_back(closedStroke(ringAt(960, 960, 40)));
  strokes.push_back(openStroke({ { 5, 5 }, { 9, 9 } }));
  const auto curves = toCurves(strokes);
  const Drawing drawing = DrawingOf(curves);
  ASSERT_EQ(drawing.Strokes.size(), strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    EXPECT_EQ(drawing.Strokes[i].points, strokes[i].points);
    EXPECT_EQ(drawing.Strokes[i].closed, strokes[i].closed);
  }
  EXPECT_EQ(drawing.Raster.width, 1028);
  EXPECT_EQ(drawing.Spacing(), 0.005 * 1024.0);
  const Classification made = classify(drawing.Raster, drawing.Strokes, 0.05, Context());
  WriteClassification(made, curves);
  const Classification read = ClassificationOf(curves);
  EXPECT_EQ(read.objects, made.objects);
  ASSERT_EQ(read.regions.size(), made.regions.size());
  for (std::size_t r = 0; r < made.regions.size(); ++r)
  {
    const Region &a = made.regions[r], &b = read.regions[r];
    EXPECT_EQ(std::tie(a.stroke, a.parent, a.object, a.depth, a.children, a.features),
      std::tie(b.stroke, b.parent, b.object, b.depth, b.children, b.features))
      << r;
  }
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    const StrokeClass &a = made.strokes[i], &b = read.strokes[i];
    EXPECT_EQ(std::tie(a.role, a.region, a.childRegion, a.object),
      std::tie(b.role, b.region, b.childRegion, b.object))
      << i;
  }
  for (const ThicknessMode mode : { ThicknessMode::Local, ThicknessMode::Global })
  {
    const DistanceMaps maps =
      distanceMaps(drawing.Raster, rimsOf(made, drawing.Strokes, drawing.Treatments), mode, Context());
    vtkNew<vtkImageData> image;
    WriteDistanceMaps(maps, image);
    const DistanceMaps back = UphillMapsOf(image, Context());
    EXPECT_EQ(back.frame.origin, maps.frame.origin);
    EXPECT_EQ(back.object, maps.object);
    EXPECT_EQ(back.distance, maps.distance);
    EXPECT_EQ(back.thickness, maps.thickness);
    EXPECT_EQ(back.skeleton, maps.skeleton);
    EXPECT_EQ(back.uphill, maps.uphill);
    EXPECT_EQ(DistanceMapsOf(image).thickness, maps.thickness);
    // Of another type, as another program may have read them from a file.
    vtkNew<vtkDoubleArray> distances;
    distances->DeepCopy(image->GetPointData()->GetArray("T"));
    distances->SetName("T");
    image->GetPointData()->AddArray(distances);
    EXPECT_EQ(DistanceMapsOf(image).distance, maps.distance);
  }
  vtkNew<vtkImageData> bare;
  WriteFrame(drawing.Raster, bare);
  EXPECT_THROW(DistanceMapsOf(bare), Error);
}
