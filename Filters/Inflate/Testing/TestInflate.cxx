// Facts of image-assisted.md, sections 12 to 14, through the filters, and what these promise.
#include "DrawingChain.h"

#include "vtkImageShiftScale.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// The polydata with a point array changed.
vtkSmartPointer<vtkPolyData> changed(vtkPolyData* mesh,
  const char* array,
  const std::function<void(vtkDataArray*)>& change)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(mesh);
  change(copy->GetPointData()->GetArray(array));
  return copy;
}

vtkSmartPointer<vtkPolyData> without(vtkPolyData* mesh, const char* array)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(mesh);
  copy->GetPointData()->RemoveArray(array);
  copy->GetCellData()->RemoveArray(array);
  copy->GetFieldData()->RemoveArray(array);
  return copy;
}

double highest(vtkPolyData* surface)
{
  return surface->GetPoints()->GetBounds()[5];
}

} // namespace

TEST(C12_1, TheFiltersMakeASphereOfACircle)
{
  DrawingChain chain;
  double least = 1e9, most = -1e9;
  for (const bool published : { false, true })
  {
    chain.Inflate->SetAsPublished(published);
    chain.Inflate->Update();
    ASSERT_EQ(chain.Inflate->GetErrorCode(), 0u);
    vtkPolyData* surface = chain.Inflate->GetOutput();
    expectClosed(surface, 2);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double off =
        (Vector3(surface->GetPoint(i)) - Vector3(canvasCentre[0], canvasCentre[1], 0.0)).norm() - 200.0;
      least = std::min(least, off);
      most = std::max(most, off);
    }
  }
  EXPECT_GE(least, -3.0);
  EXPECT_LE(most, 3.0);
  fact("C12_1",
    "curves to surface, 200 px, as published and amended: " + digits(least) + " to " + digits(most) +
      " px off");
}

TEST(C13_2, TheFilterMakesTheSquaresSlab)
{
  PlanarMesh mesh = square(512.0, false, 2);
  vtkNew<vtkOversketchExtrude> extrude;
  extrude->SetInputData(toPlanar(mesh));
  extrude->Update();
  vtkPolyData* slab = extrude->GetOutput();
  expectClosed(slab, 2);
  EXPECT_EQ(slab->GetNumberOfPolys(), 256);
  EXPECT_EQ(slab->GetNumberOfPoints(), 130);
  EXPECT_EQ(highest(slab), 102.4) << "a tenth of the canvas";
  EXPECT_NEAR(shapeOf(slab).volume, 2.0 * 102.4 * 512.0 * 512.0, 1e-9 * 512.0 * 512.0 * 204.8);
  extrude->SetWallRows(1);
  extrude->SetDepth(3.0);
  extrude->Update();
  expectClosed(extrude->GetOutput(), 2);
  EXPECT_EQ(extrude->GetOutput()->GetNumberOfPolys(), 128 + 32);
  EXPECT_EQ(highest(extrude->GetOutput()), 3.0);
  EXPECT_EQ(extrude->GetExtrudeCount(), 2);
  fact("C13_2", "by the filter: 256 triangles, 130 vertices, closed, front 0.1 L from the plane");
}

TEST(C14_1, TheFiltersSealAHole)
{
  DrawingChain chain(Treatment::Hole);
  chain.Cut->Update();
  vtkPolyData* surface = chain.Cut->GetOutput();
  expectClosed(surface, 0);
  EXPECT_NEAR(highest(surface), 50.0, 2.0);
  EXPECT_EQ(chain.Cut->GetTunnelCount(), 0);
  const std::vector<double> kinds = valuesOf(surface->GetPointData(), "BoundaryKind"),
                            heights = valuesOf(surface->GetPointData(), "Displacement");
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    EXPECT_EQ(heights[i] == 0.0, kinds[i] == 1.0 || kinds[i] == 2.0);
  }
  fact("C14_1", "through the filters: closed, chi 0, peak " + digits(highest(surface), 4) + " px");
}

TEST(C14_2, TheFiltersCutATunnel)
{
  DrawingChain filled, chain(Treatment::Tunnel);
  filled.Measure->Update();
  chain.Cut->Update();
  EXPECT_EQ(valuesOf(filled.Measure->GetDistanceOutput()->GetPointData(), "T"),
    valuesOf(chain.Measure->GetDistanceOutput()->GetPointData(), "T"));
  vtkPolyData* surface = chain.Cut->GetOutput();
  expectClosed(surface, 0);
  const std::vector<double> kinds = valuesOf(surface->GetPointData(), "BoundaryKind"),
                            heights = valuesOf(surface->GetPointData(), "Displacement"),
                            sides = valuesOf(surface->GetPointData(), "Side");
  double least = 1e9, most = 0.0;
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    if (kinds[i] == 4.0 && sides[i] != 0.0)
    {
      least = std::min(least, heights[i]);
      most = std::max(most, heights[i]);
    }
  }
  EXPECT_NEAR(least, 173.2, 3.0);
  EXPECT_NEAR(most, 173.2, 3.0);
  const std::vector<double> faceSides = valuesOf(surface->GetCellData(), "Side"),
                            bases = valuesOf(surface->GetCellData(), "BaseFaceId"),
                            regions = valuesOf(surface->GetCellData(), "RegionId");
  for (std::size_t f = 0; f < bases.size(); ++f)
  {
    EXPECT_EQ(bases[f] == -1.0, faceSides[f] == 0.0);
    EXPECT_EQ(regions[f], 0.0);
  }
  chain.Cut->TunnelWallOff();
  chain.Cut->Update();
  const Shape open = shapeOf(chain.Cut->GetOutput());
  EXPECT_EQ(open.loops, 2);
  EXPECT_EQ(open.chi, 0);
  // Of an extrusion.
  chain.Cut->SetInputConnection(chain.Extrude->GetOutputPort());
  chain.Cut->TunnelWallOn();
  chain.Cut->Update();
  expectClosed(chain.Cut->GetOutput(), 0);
  fact("C14_2",
    "through the filters: T the same, rim at " + digits(least, 5) + " to " + digits(most, 5) +
      " px, closed, chi 0; TunnelWall off: 2 loops, chi 0");
}

TEST(C14_3, TheFiltersKeepAFilledRegion)
{
  DrawingChain chain;
  chain.Cut->Update();
  expectClosed(chain.Cut->GetOutput(), 2);
  EXPECT_TRUE(sameBits(chain.Cut->GetOutput(), chain.Inflate->GetOutput()));
  fact("C14_3", "through the filters: closed, chi 2, no bit changed by the tunnel's step");
}

TEST(InflateFilter, PassesArraysAndSaysWhatIsWhere)
{
  DrawingChain chain;
  chain.Inflate->UnstretchedRimsOff();
  chain.Inflate->Update();
  vtkPolyData* surface = chain.Inflate->GetOutput();
  const std::vector<double> planar = valuesOf(surface->GetPointData(), "PlanarId"),
                            sides = valuesOf(surface->GetPointData(), "Side"),
                            heights = valuesOf(surface->GetPointData(), "Displacement");
  ASSERT_EQ(static_cast<vtkIdType>(planar.size()), surface->GetNumberOfPoints());
  const char* const arrays[] = { "BoundaryKind", "StrokeId", "StrokeParam", "IsBaseVertex" };
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const auto from = static_cast<vtkIdType>(planar[i]);
    const Vector3 there(surface->GetPoint(i)), flat(chain.Mesh->GetPoint(from));
    EXPECT_EQ(there.head<2>(), flat.head<2>());
    EXPECT_EQ(there[2], sides[i] * heights[i]);
    for (const char* name : arrays)
    {
      EXPECT_EQ(surface->GetPointData()->GetArray(name)->GetComponent(i, 0),
        chain.Mesh->GetPointData()->GetArray(name)->GetComponent(from, 0));
    }
  }
  const vtkIdType half = chain.Mesh->GetNumberOfPolys();
  ASSERT_EQ(surface->GetNumberOfPolys(), 2 * half);
  for (vtkIdType f = 0; f < 2 * half; ++f)
  {
    EXPECT_EQ(surface->GetCellData()->GetArray("Side")->GetComponent(f, 0), f < half ? 1.0 : -1.0);
    for (const char* name : { "RegionId", "ObjectId", "BaseFaceId" })
    {
      EXPECT_EQ(surface->GetCellData()->GetArray(name)->GetComponent(f, 0),
        chain.Mesh->GetCellData()->GetArray(name)->GetComponent(f % half, 0));
    }
  }
  EXPECT_NE(surface->GetFieldData()->GetArray("Canvas"), nullptr);
  EXPECT_EQ(chain.Mesh->GetPointData()->GetArray("Side"), nullptr) << "the input is untouched";
}

TEST(InflateFilter, AnImageFilterTakesTheHeights)
{
  DrawingChain chain;
  vtkNew<vtkImageShiftScale> shift;
  shift->SetInputConnection(chain.Inflate->GetOutputPort(1));
  shift->SetShift(1000.0);
  shift->Update();
  vtkImageData* distance = chain.Measure->GetDistanceOutput();
  vtkImageData* heights = chain.Inflate->GetHeightsOutput();
  EXPECT_EQ(shift->GetOutput()->GetDimensions()[0], 1028);
  EXPECT_EQ(Vector3(heights->GetOrigin()), Vector3(distance->GetOrigin()));
  EXPECT_EQ(Vector3(heights->GetSpacing()), Vector3(distance->GetSpacing()));
  const auto read = [&](const char* name)
  {
    shift->Update();
    return valuesOf(chain.Inflate->GetHeightsOutput()->GetPointData(), name);
  };
  const std::vector<double> plain = valuesOf(distance->GetPointData(), "LocalMax"),
                            t = valuesOf(distance->GetPointData(), "T");
  // Of the smoothed circle the radius of what stands on the rim and has the height.
  std::vector<double> smooth = read("LocalMaxSmooth"), ratio = read("Ratio");
  for (std::size_t i = 0; i < t.size(); ++i)
  {
    ASSERT_NEAR(smooth[i], t[i] > 0.0 ? 0.5 * (ratio[i] + t[i]) : 0.0, 1e-4);
  }
  chain.Inflate->SetProfile("linear");
  smooth = read("LocalMaxSmooth");
  EXPECT_NE(smooth, plain);
  for (std::size_t i = 0; i < t.size(); ++i)
  {
    ASSERT_GE(smooth[i], t[i]);
  }
  chain.Inflate->SetProfile("");
  chain.Inflate->AsPublishedOn();
  EXPECT_EQ(read("LocalMaxSmooth"), plain);
  ratio = read("Ratio");
  for (std::size_t i = 0; i < t.size(); ++i)
  {
    ASSERT_NEAR(ratio[i], t[i] > 0.0 ? 2.0 * plain[i] - t[i] : 1.0, 1e-3);
  }
  EXPECT_EQ(chain.Classify->GetClassificationCount(), 1);
}

TEST(InflateFilter, KeepsWhatAChangeDoesNotTouch)
{
  DrawingChain chain;
  vtkOversketchInflate* filter = chain.Inflate;
  const auto counts = [&]
  {
    filter->Update();
    return std::array<vtkIdType, 3>{
      filter->GetThicknessCount(), filter->GetRatioCount(), filter->GetInflateCount()
    };
  };
  using Counts = std::array<vtkIdType, 3>;
  EXPECT_EQ(counts(), (Counts{ 0, 1, 1 })) << "the smoothed circle asks for no thickness";
  const double before = highest(filter->GetOutput());
  filter->SetHeightFactor(0.5);
  EXPECT_EQ(counts(), (Counts{ 0, 1, 2 }));
  EXPECT_NEAR(highest(filter->GetOutput()), 0.5 * before, 1e-9);
  filter->SetProfile("linear");
  EXPECT_EQ(counts(), (Counts{ 1, 2, 3 }));
  filter->SetProfileSmoothing(0.2);
  EXPECT_EQ(counts(), (Counts{ 1, 3, 4 }));
  filter->UnstretchedRimsOff();
  EXPECT_EQ(counts(), (Counts{ 1, 3, 5 }));
  expectClosed(filter->GetOutput(), 2);
  filter->SetModeToPoisson();
  EXPECT_EQ(counts(), (Counts{ 1, 4, 6 }));
  expectClosed(filter->GetOutput(), 2);
  filter->SetProfile("step"); // not read
  EXPECT_EQ(counts(), (Counts{ 1, 4, 6 }));
  filter->SetLocalMaxSmoothing(0.3); // nor is this
  EXPECT_EQ(counts(), (Counts{ 1, 4, 6 }));
  filter->SetModeToCircular();
  filter->SetProfileSmoothing(0.0);
  EXPECT_EQ(counts(), (Counts{ 2, 5, 7 }));
  filter->Modified();
  EXPECT_EQ(counts(), (Counts{ 2, 5, 7 }));
  // A further feature: the drawing runs again, its rims are the same, so nothing is solved.
  chain.Classify->SetInputData(toCurves({ closedStroke(ringAt(canvasCentre[0], canvasCentre[1], 200.0)),
    closedStroke(ringAt(canvasCentre[0], canvasCentre[1], 100.0)),
    openStroke({ { 640, 500 }, { 650, 560 } }) }));
  EXPECT_EQ(counts(), (Counts{ 2, 5, 7 }));
  EXPECT_EQ(chain.Classify->GetClassificationCount(), 2);
  EXPECT_EQ(chain.Measure->GetDistanceCount(), 1);
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  // Another mesh is inflated by the same maps.
  filter->SetInputData(DrawingChain(Treatment::Fill, 2).Mesh);
  EXPECT_EQ(counts(), (Counts{ 2, 5, 8 }));
}

TEST(InflateFilter, TheSameForAnyNumberOfThreads)
{
  vtkNew<vtkPolyData> inflated, membrane, cut;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    DrawingChain chain(Treatment::Tunnel);
    chain.Cut->Update();
    DrawingChain other;
    other.Inflate->SetModeToPoisson();
    other.Inflate->Update();
    if (threads == 1)
    {
      inflated->DeepCopy(chain.Inflate->GetOutput());
      cut->DeepCopy(chain.Cut->GetOutput());
      membrane->DeepCopy(other.Inflate->GetOutput());
      continue;
    }
    EXPECT_TRUE(sameBits(inflated, chain.Inflate->GetOutput()));
    EXPECT_TRUE(sameBits(cut, chain.Cut->GetOutput()));
    EXPECT_TRUE(sameBits(membrane, other.Inflate->GetOutput()));
    EXPECT_FALSE(sameBits(membrane, inflated));
  }
  vtkSMPTools::Initialize();
}

TEST(InflateFilter, RefusesAndCancels)
{
  DrawingChain chain;
  vtkOversketchInflate* filter = chain.Inflate;
  expectCancel(filter);
  expectCancel(filter, 0.3);
  filter->Update();
  expectClosed(filter->GetOutput(), 2);
  filter->SetProfile("0 0, 0.5 2, 1 1");
  expectRefusal(filter, Failure::BadStroke, "Point 1 of the profile has a y");
  filter->SetProfile("");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double factor : { 0.0, -2.0 })
  {
    filter->SetHeightFactor(factor);
    expectRefusal(filter, Failure::BadStroke, "height factor must be a number above 0");
  }
  filter->SetHeightFactor(nan);
  expectRefusal(filter, Failure::BadStroke, "HeightFactor is not a finite number");
  filter->SetHeightFactor(1.0);
  filter->SetLocalMaxSmoothing(nan);
  expectRefusal(filter, Failure::BadStroke, "LocalMaxSmoothing is not a finite number");
  filter->SetLocalMaxSmoothing(0.5);
  filter->SetProfileSmoothing(nan);
  expectRefusal(filter, Failure::BadStroke, "ProfileSmoothing is not a finite number");
  filter->SetProfileSmoothing(-1.0);
  filter->SetInputData(without(chain.Mesh, "BoundaryKind"));
  expectRefusal(filter, Failure::MissingArray, "BoundaryKind");
  const auto fill = [](double value)
  { return [value](vtkDataArray* array) { array->FillComponent(0, value); }; };
  filter->SetInputData(changed(chain.Mesh, "BoundaryKind", fill(0.0)));
  expectRefusal(filter, Failure::BadMesh, "but on no rim");
  filter->SetInputData(changed(chain.Mesh, "BoundaryKind", fill(1.0)));
  expectRefusal(filter, Failure::BadMesh, "trim the holes first");
  vtkNew<vtkImageData> other;
  other->SetDimensions(9, 9, 1);
  filter->SetInputData(chain.Mesh);
  filter->SetDistanceData(other);
  expectRefusal(filter, Failure::MissingArray, "vtkOversketchDistance");
  filter->SetDistanceConnection(chain.Measure->GetOutputPort(1));
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetInputData(chain.Mesh);
  filter->Update();
  expectClosed(filter->GetOutput(), 2);
}

TEST(ExtrudeFilter, RefusesAndCancels)
{
  DrawingChain chain(Treatment::Hole, 2);
  vtkOversketchExtrude* filter = chain.Extrude;
  expectCancel(filter);
  filter->Update();
  expectClosed(filter->GetOutput(), 0);
  filter->SetDepth(-1.0);
  expectRefusal(filter, Failure::BadStroke, "depth of the extrusion must be a number above 0");
  filter->SetDepth(std::numeric_limits<double>::infinity());
  expectRefusal(filter, Failure::BadStroke, "Depth is not a finite number");
  filter->SetDepth(0.0);
  filter->SetInputData(without(chain.Mesh, "Canvas"));
  expectRefusal(filter, Failure::MissingArray, "Canvas");
  filter->SetDepth(20.0);
  filter->Update();
  expectClosed(filter->GetOutput(), 0);
  filter->SetInputData(
    changed(chain.Mesh, "IsBaseVertex", [](vtkDataArray* array) { array->FillComponent(0, 0.0); }));
  expectRefusal(filter, Failure::BadMesh, "IsBaseVertex");
}

TEST(TunnelFilter, RefusesAndCancels)
{
  DrawingChain chain(Treatment::Tunnel, 2);
  vtkOversketchTunnel* filter = chain.Cut;
  chain.Inflate->Update();
  expectCancel(filter);
  filter->Update();
  expectClosed(filter->GetOutput(), 0);
  EXPECT_EQ(filter->GetTunnelCount(), 1);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetTunnelCount(), 1);
  vtkPolyData* surface = chain.Inflate->GetOutput();
  for (const char* name : { "Side", "PlanarId", "IsBaseVertex", "RegionId" })
  {
    filter->SetInputData(without(surface, name));
    expectRefusal(filter, Failure::MissingArray, name);
  }
  filter->SetInputData(changed(surface, "Side", [](vtkDataArray* array) { array->FillComponent(0, 1.0); }));
  expectRefusal(filter, Failure::BadMesh, "reaches a rim");
  filter->SetInputData(surface);
  filter->SetCurvesData(toCurves({ closedStroke(ringAt(512, 512, 200)) })); // not classified
  expectRefusal(filter, Failure::MissingArray, "vtkOversketchClassify");
}
