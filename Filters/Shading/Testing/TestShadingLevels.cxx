// Facts of editors.md, section 13, handles and pipeline, by the filters.
#include "ShadingScenes.h"

#include "vtkImageShiftScale.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A pentagram round a place of the disc, which crosses itself.
std::vector<Vector2> star(const Vector2& middle, double radius)
{
  std::vector<Vector2> outline;
  outline.reserve(5);
  for (int k = 0; k < 5; ++k)
    outline.push_back(middle + radius * Vector2(std::sin(0.8 * pi * k), std::cos(0.8 * pi * k)));
  return outline;
}

// Per vertex whether its texel is selected in the mask.
std::vector<char> selected(ShadingChain& chain, int area = 0)
{
  chain.levels->Update();
  const std::vector<double> uv = pointValues(chain.flatten->GetOutput(), "DiscCoords");
  vtkImageData* mask = chain.fill->GetMaskOutput();
  const int size = mask->GetDimensions()[0];
  std::vector<char> result;
  for (std::size_t v = 0; 2 * v < uv.size(); ++v)
  {
    const auto texel = [&](double share)
    { return std::clamp(static_cast<int>(std::floor(share * size)), 0, size - 1); };
    result.push_back(uv[2 * v] >= 0.0 &&
                     mask->GetPointData()->GetScalars()->GetComponent(
                       static_cast<vtkIdType>(texel(uv[2 * v + 1])) * size + texel(uv[2 * v]), area) != 0.0);
  }
  return result;
}

double largestEdgeStep(const Scene& scene, const std::vector<double>& w)
{
  double largest = 0.0;
  for (const MeshEdge& e : buildAdjacency(scene.mesh).edges)
    largest = std::max(largest, std::abs(w[e.v0] - w[e.v1]));
  return largest;
}

// Boundaries of layers as the display shows them: of neighbouring greys along the shares of its texels, the
// share between.
std::vector<double> boundariesShown(ShadingChain& chain)
{
  const std::vector<double> greys = chain.greys();
  // Shares on the texels, from weights that fall linearly without handles.
  vtkNew<vtkOversketchShadingLevels> plain;
  plain->SetInputConnection(chain.field->GetOutputPort());
  plain->SetDiscConnection(chain.flatten->GetOutputPort(1));
  plain->SetFalloffToLinear();
  plain->SetResolution(chain.levels->GetResolution());
  plain->Update();
  const std::vector<double> weights = pointValues(plain->GetWeightsOutput(), "Weight");
  std::map<double, std::pair<double, double>> shares; // of each grey
  for (std::size_t i = 0; i < greys.size(); ++i)
  {
    const double s = 1.0 - weights[i];
    if (s > 0.0 && s < 1.0)
    {
      auto& range = shares.emplace(greys[i], std::make_pair(1.0, 0.0)).first->second;
      range = { std::min(range.first, s), std::max(range.second, s) };
    }
  }
  std::vector<double> boundaries;
  for (auto grey = shares.rbegin(); std::next(grey) != shares.rend(); ++grey)
  {
    EXPECT_LE(grey->second.second, std::next(grey)->second.first + 1e-6) << "layers follow each other";
    boundaries.push_back(0.5 * (grey->second.second + std::next(grey)->second.first));
  }
  return boundaries;
}

void expectNear(const std::vector<double>& found, const std::vector<double>& expected, double within)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], within) << i;
}

} // namespace

TEST(B6_2, ByTheFiltersAStripFallsEvenly)
{
  const Drawn drawn = strip(200, 20);
  ShadingChain chain(sceneOf(drawn));
  chain.field->SetMeasureToEuclidean();
  double worst = 0.0;
  for (const bool linear : { true, false })
  {
    chain.levels->SetFalloff(linear ? 1 : 0);
    const std::vector<double> w = chain.weights();
    for (int v = 0; v < drawn.patch.vertexCount(); ++v)
    {
      const double x = drawn.patch.points[v][0], y = std::abs(drawn.patch.points[v][1]);
      if (std::abs(x) <= 5.0)
      {
        worst = std::max(
          worst, std::abs(w[v] - (linear ? 1.0 - y : 1.0 - y * y * y * (10.0 - 15.0 * y + 6.0 * y * y))));
      }
    }
  }
  const std::vector<double> greys = chain.greys();
  EXPECT_LT(worst, 2e-6);
  EXPECT_EQ(std::set<double>(greys.begin(), greys.end()), (std::set<double>{ 255, 191, 128, 64, 0 }));
  fact("B6_2",
    "by the filters: weights of a strip within " + std::to_string(worst * 1e9) + "e-9, linear and smooth");
  chain.levels->AsPublishedOn();
  const std::vector<double> published = chain.weights();
  chain.levels->AsPublishedOff();
  chain.levels->SetFalloffToLinear();
  EXPECT_EQ(chain.weights(), published);
}

TEST(B6_3, ByTheFilterMoreLevelsAreAnotherPicture)
{
  ShadingChain chain(capScene());
  const std::vector<double> weights = chain.weights(), greys = chain.greys();
  chain.levels->SetLevels(9);
  EXPECT_EQ(chain.weights(), weights);
  EXPECT_NE(chain.greys(), greys);
  fact("B6_3", "by the filter: 9 levels, the same weights to the bit, another display image");
}

TEST(ShadingLevelsFilter, TheImageIsTheWeightsOnTheDisc)
{
  ShadingChain chain(capScene(5));
  chain.levels->SetLayers("handle 0.4 0.25");
  const std::vector<double> w = chain.weights();
  vtkNew<vtkOversketchTextureToWeight> read;
  read->SetInputConnection(chain.field->GetOutputPort());
  read->SetImageConnection(chain.levels->GetOutputPort(1));
  read->Update();
  ASSERT_EQ(read->GetErrorCode(), 0u);
  const std::vector<double> sampled = pointValues(read->GetOutput(), "EditWeight");
  double worst = 0.0;
  for (std::size_t v = 0; v < w.size(); ++v)
  {
    worst = std::max(worst, std::abs(sampled[v] - w[v]));
    EXPECT_EQ(w[v] == 0.0, chain.scene.labels[v] != 2) << v;
  }
  EXPECT_LT(worst, 0.03);
  EXPECT_GT(worst, 0.0);
}

TEST(B7_4, ThreeHandlesAndOneDragged)
{
  const Drawn drawn = hill(60);
  ShadingChain chain(sceneOf(drawn));
  chain.levels->SetLayers("handle 0.2 0.2; handle 0.4 0.4; handle 0.8 0.8");
  expectNear(boundariesShown(chain), { 0.2, 0.4, 0.6, 0.8 }, 0.005);
  chain.levels->SetLayers("handle 0.2 0.2; handle 0.8 0.8; handle 0.4 0.5");
  expectNear(boundariesShown(chain), { 0.2, 0.5, 0.65, 0.8 }, 0.005);
  chain.levels->SetLayers("handle 0.2 0.2; handle 0.4 0.4; handle 0.8 0.9");
  expectNear(boundariesShown(chain), { 0.2, 0.4, 0.65, 0.9 }, 0.005);
  // A hand that drags anything anywhere: never more layers than there are levels.
  std::mt19937 random(4);
  const auto any = [&] { return std::to_string(-0.5 + static_cast<double>(random() % 1000) / 500.0); };
  std::size_t most = 0, least = 9;
  for (int i = 0; i < 60; ++i)
  {
    chain.levels->SetLayers(
      ("handle 0.2 " + any() + "; handle 0.8 " + any() + "; handle 0.4 " + any()).c_str());
    const std::vector<double> greys = chain.greys();
    ASSERT_EQ(chain.levels->GetErrorCode(), 0u);
    const std::size_t shown = std::set<double>(greys.begin(), greys.end()).size();
    EXPECT_LE(shown, 5u);
    most = std::max(most, shown);
    least = std::min(least, shown);
  }
  EXPECT_EQ(most, 5u);
  EXPECT_LT(least, 5u);
  fact("B7_4",
    "three handles, one dragged: the display's layers end at 0.2, 0.5, 0.65, 0.8 and 0.2, 0.4, 0.65, 0.9 "
    "within 0.005; "
    "dragged at random they are " +
      std::to_string(least) + " to " + std::to_string(most) + " of 5");
}

TEST(B7_5, WhatIsOutsideASelectionKeepsItsBits)
{
  ShadingChain chain(capScene(5));
  chain.select({ star({ 0.1, 0.1 }, 0.8) });
  chain.levels->SetLayers("handle 0.5 0.45");
  const std::vector<double> before = chain.weights(), greys = chain.greys();
  chain.levels->SetLayers("handle 0.5 0.45; area 0 9; handle 0.3 0.6");
  const std::vector<double> after = chain.weights(), own = chain.greys();
  const std::vector<char> within = selected(chain);
  int outside = 0, changed = 0, inside = 0;
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    if (within[v])
    {
      inside += chain.scene.labels[v] == 2;
      changed += before[v] != after[v];
    }
    else
    {
      ASSERT_EQ(before[v], after[v]) << v;
      outside += chain.scene.labels[v] == 2;
    }
  }
  EXPECT_GT(outside, 1000);
  EXPECT_GT(inside, 100);
  EXPECT_GT(changed, inside * 9 / 10);
  vtkDataArray* mask = chain.fill->GetMaskOutput()->GetPointData()->GetScalars();
  std::set<double> shown;
  for (std::size_t i = 0; i < greys.size(); ++i)
  {
    if (mask->GetComponent(static_cast<vtkIdType>(i), 0) == 0.0)
      ASSERT_EQ(greys[i], own[i]) << i;
    else
      shown.insert(own[i]);
  }
  EXPECT_GT(shown.size(), 5u) << "nine levels inside";
  EXPECT_LE(shown.size(), 9u);
  fact("B7_5",
    "a pentagram lassoed, nine levels and a handle in it: " + std::to_string(outside) +
      " vertices outside keep their bits, " + std::to_string(changed) + " of " + std::to_string(inside) +
      " inside change");
}

TEST(ShadingLevelsFilter, AnAreaIsACliffAsPublishedAlone)
{
  ShadingChain chain(capScene(6));
  chain.select({ { { -0.6, -0.6 }, { 0.6, -0.6 }, { 0.6, 0.6 }, { -0.6, 0.6 } } });
  const double whole = largestEdgeStep(chain.scene, chain.weights());
  chain.levels->SetLayers("area 0; handle 0.5 0.9");
  chain.levels->SetFeather(0.2);
  const double soft = largestEdgeStep(chain.scene, chain.weights());
  chain.levels->SetFeather(0.05);
  const double blended = largestEdgeStep(chain.scene, chain.weights());
  chain.levels->SetFeather(0.0);
  const double cliff = largestEdgeStep(chain.scene, chain.weights());
  chain.levels->SetFeather(0.05);
  chain.levels->AsPublishedOn();
  EXPECT_GT(largestEdgeStep(chain.scene, chain.weights()), 0.35);
  EXPECT_GT(cliff, 0.5);
  EXPECT_LT(blended, 0.6 * cliff);
  EXPECT_LT(soft, 0.4 * cliff);
  EXPECT_LT(whole, soft);
}

TEST(ShadingLevelsFilter, TheLastAreaWinsAndEmptyOnesFollowTheWhole)
{
  ShadingChain chain(capScene(4));
  const std::vector<Vector2> left{ { -0.8, -0.5 }, { 0.2, -0.5 }, { 0.2, 0.5 }, { -0.8, 0.5 } },
    right{ { -0.2, -0.5 }, { 0.8, -0.5 }, { 0.8, 0.5 }, { -0.2, 0.5 } };
  chain.select({ left, right });
  chain.levels->SetFeather(0.0);
  const std::vector<double> plain = chain.weights();
  chain.levels->SetLayers("area 0; handle 0.5 0.2");
  const std::vector<double> first = chain.weights();
  chain.levels->SetLayers("area 1; handle 0.5 0.8");
  const std::vector<double> second = chain.weights();
  // By their numbers, whatever the order in the text.
  chain.levels->SetLayers("area 1; handle 0.5 0.8; area 0; handle 0.5 0.2");
  const std::vector<double> both = chain.weights();
  const std::vector<char> inLeft = selected(chain, 0), inRight = selected(chain, 1);
  int shared = 0;
  for (std::size_t v = 0; v < both.size(); ++v)
  {
    EXPECT_EQ(both[v], inRight[v] ? second[v] : inLeft[v] ? first[v] : plain[v]) << v;
    shared += inLeft[v] && inRight[v];
  }
  EXPECT_GT(shared, 20);
  // An area without handles has the whole's, whatever its levels.
  chain.levels->SetLayers("handle 0.5 0.3");
  const std::vector<double> handled = chain.weights();
  chain.levels->SetLayers("handle 0.5 0.3; area 0 7; area 1");
  EXPECT_EQ(chain.weights(), handled);
}

TEST(B13_1, ALayerRunsNoSolve)
{
  ShadingChain chain(capScene(4));
  chain.select({ star({ 0.0, 0.2 }, 0.5) });
  chain.levels->Update();
  std::map<std::string, int> runs;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&runs);
  count->SetCallback([](vtkObject* caller, unsigned long, void* to, void*)
    { ++(*static_cast<std::map<std::string, int>*>(to))[caller->GetClassName()]; });
  const std::initializer_list<vtkAlgorithm*> filters{ chain.flatten, chain.field, chain.fill, chain.levels };
  for (vtkAlgorithm* filter : filters)
    filter->AddObserver(vtkCommand::StartEvent, count);
  const auto ran = [&]
  {
    runs.clear();
    chain.levels->Update();
    return runs;
  };
  using Runs = std::map<std::string, int>;
  const Runs shading{ { "vtkOversketchShadingLevels", 1 } };
  EXPECT_EQ(ran(), Runs{});
  chain.levels->SetLevels(9);
  EXPECT_EQ(ran(), shading);
  chain.levels->SetLayers("handle 0.4 0.3");
  EXPECT_EQ(ran(), shading);
  chain.levels->SetLayers("handle 0.4 0.3; area 0 3; handle 0.4 0.5");
  EXPECT_EQ(ran(), shading);
  EXPECT_EQ(ran(), Runs{});
  chain.select({ star({ 0.1, 0.2 }, 0.5) });
  EXPECT_EQ(ran(), (Runs{ { "vtkOversketchShadingLevels", 1 }, { "vtkOversketchScanFill", 1 } }));
  EXPECT_EQ(chain.levels->GetTexelCount(), 1);
  EXPECT_EQ(chain.levels->GetShadeCount(), 5);
  // Another curve measures anew and flattens nothing.
  chain.scene.reference.pop_back();
  const auto shorter = toChain(chain.scene.mesh, chain.scene.reference);
  chain.flatten->SetReferenceData(shorter);
  chain.field->SetReferenceData(shorter);
  chain.levels->Update();
  EXPECT_EQ(chain.flatten->GetFlattenCount(), 1);
  EXPECT_EQ(chain.field->GetFieldCount(), 2);
  EXPECT_EQ(chain.levels->GetTexelCount(), 2);
  // What was asked before is answered by the same array.
  vtkDataArray* const last = chain.levels->GetOutput()->GetPointData()->GetArray("EditWeight");
  chain.levels->Modified();
  chain.levels->Update();
  EXPECT_EQ(chain.levels->GetOutput()->GetPointData()->GetArray("EditWeight"), last);
  fact("B13_1",
    "levels, a handle or an area's layers changed: shading alone runs, no disc, field or mask; a second "
    "update runs nothing; "
    "another curve flattens nothing");
}

TEST(ShadingLevelsFilter, AnImageFilterTakesTheImages)
{
  ShadingChain chain(capScene(3));
  vtkNew<vtkImageShiftScale> weights, greys;
  weights->SetInputConnection(chain.levels->GetOutputPort(1));
  greys->SetInputConnection(chain.levels->GetOutputPort(2));
  chain.select({ star({ 0.1, 0.2 }, 0.5) });
  chain.levels->SetLayers("area 0 8");
  for (const int resolution : { 64, 512, 100 })
  {
    chain.levels->SetResolution(resolution);
    chain.fill->SetResolution(resolution / 2);
    weights->Update();
    greys->Update();
    EXPECT_EQ(weights->GetOutput()->GetDimensions()[0], resolution);
    EXPECT_EQ(greys->GetOutput()->GetDimensions()[1], resolution);
    EXPECT_GT(weights->GetOutput()->GetScalarRange()[1], 0.9);
    EXPECT_EQ(greys->GetOutput()->GetScalarRange()[1], 255.0);
  }
  EXPECT_NEAR(weights->GetOutput()->GetBounds()[0], 0.01 - 1.0, 1e-12);
}

TEST(ShadingLevelsFilter, OneAndTwoThreadsGiveTheSameBits)
{
  const auto made = [](int threads)
  {
    vtkSMPTools::Initialize(threads);
    auto chain = std::make_unique<ShadingChain>(capScene(4));
    chain->select({ star({ 0.1, 0.2 }, 0.5), star({ -0.1, 0.1 }, 0.3) });
    chain->levels->SetLayers("handle 0.3 0.4; area 0 7; handle 0.4 0.2; area 1");
    chain->levels->Update();
    return chain;
  };
  const auto one = made(1), two = made(2);
  vtkSMPTools::Initialize();
  EXPECT_TRUE(sameBits(one->levels->GetOutput()->GetPointData()->GetArray("EditWeight"),
    two->levels->GetOutput()->GetPointData()->GetArray("EditWeight")));
  EXPECT_TRUE(sameBits(one->levels->GetWeightsOutput()->GetPointData()->GetScalars(),
    two->levels->GetWeightsOutput()->GetPointData()->GetScalars()));
  EXPECT_TRUE(sameBits(one->levels->GetDisplayOutput()->GetPointData()->GetScalars(),
    two->levels->GetDisplayOutput()->GetPointData()->GetScalars()));
}

TEST(ShadingLevelsFilter, RefusesAndCancels)
{
  ShadingChain chain(capScene(3));
  const auto levels = chain.levels.Get();
  const auto refused = [&](const char* layers, const char* words)
  {
    levels->SetLayers(layers);
    expectRefusal(levels, Failure::BadStroke, words);
    EXPECT_EQ(levels->GetWeightsOutput()->GetNumberOfPoints(), 0);
    levels->SetLayers("");
  };
  refused("handle 0.4", "Layers says \"handle 0.4\"");
  refused("handle nan 0.2", "Layer handle 0 is not finite");
  refused("handle 0.4 inf", "Layer handle 0 is not finite");
  refused("handle 1 0.2", "lies on the reference or boundary curve");
  refused("handle 0.4 0.2; handle 0.4005 0.3", "Layer handle 1 is too near to another one");
  refused("area 0", "Layers names area 0, but there are 0");
  for (const double bad : { -0.1, 1.5, std::nan("") })
  {
    levels->SetFeather(bad);
    refused("", "Feather is not within 0 and 1");
    levels->SetFeather(0.05);
  }
  chain.select({ star({ 0, 0 }, 0.5) });
  refused("area 1 5", "Layers names area 1, but there are 1");
  refused("area -1", "Layers names area -1");
  refused("area 0 1", "1 levels are asked for");
  refused("area 0 300", "300 levels are asked for");
  refused("area 0; handle 0.4 0.2; handle 0.4 0.3", "too near");
  levels->SetLevels(1);
  EXPECT_EQ(levels->GetLevels(), 2);

  vtkNew<vtkImageData> areas;
  areas->SetDimensions(4, 3, 1);
  areas->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  levels->SetAreasData(areas);
  refused("area 0", "not square");
  areas->SetDimensions(3, 3, 2);
  areas->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  areas->Modified();
  refused("area 0", "several slices");
  areas->SetDimensions(20000, 20000, 1);
  areas->GetPointData()->Initialize();
  areas->Modified();
  refused("area 0", "larger than 4096");
  areas->SetDimensions(1, 1, 1);
  areas->AllocateScalars(VTK_FLOAT, 1);
  areas->GetPointData()->GetScalars()->Fill(1.0);
  areas->Modified();
  levels->SetLayers("area 0; handle 0.4 0.2");
  levels->Update();
  EXPECT_EQ(levels->GetErrorCode(), 0u) << "one texel is the whole disc";
  levels->SetInputConnection(2, nullptr);
  levels->SetLayers("");

  const auto without = [&](vtkPolyData* mesh, vtkPolyData* disc, Failure failure, const char* words)
  {
    vtkNew<vtkOversketchShadingLevels> filter;
    filter->SetInputData(mesh);
    filter->SetDiscData(disc);
    expectRefusal(filter, failure, words);
  };
  levels->Update();
  vtkNew<vtkPolyData> mesh, disc;
  mesh->DeepCopy(chain.field->GetOutput());
  disc->DeepCopy(chain.flatten->GetDiscOutput());
  without(chain.flatten->GetOutput(), disc, Failure::MissingArray, "no array CurveDistance");
  without(mesh, mesh, Failure::MissingArray, "no array VertexId");
  mesh->GetPointData()
    ->GetArray("CurveDistance")
    ->SetComponent(static_cast<vtkIdType>(disc->GetPointData()->GetArray("VertexId")->GetComponent(3, 0)),
      0,
      std::nan(""));
  without(mesh, disc, Failure::BadMesh, "is not within 0 and 1");
  without(mesh, toPolyData(icosphere(1)), Failure::MissingArray, "no array VertexId");
  disc->GetPointData()->GetArray("VertexId")->SetComponent(0, 0, 1e9);
  without(mesh, disc, Failure::BadMesh, "Point 0 of the disc names no vertex of the mesh");
  levels->SetLevels(6);
  expectCancel(levels);
  levels->Update();
  EXPECT_GT(levels->GetDisplayOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkPolyData> nothing;
  levels->SetInputData(nothing);
  Ear ear(levels);
  levels->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(levels->GetWeightsOutput()->GetNumberOfPoints(), 0);
}
