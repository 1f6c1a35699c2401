// What the augmentation system refuses, how it is cancelled, and the user's arrays and seams.
#include "AugmentTools.h"

#include "Harness/data.h"
#include "Mesh/weld.h"

#include "vtkOversketchStellarBase.h"
#include "vtkOversketchStellarRefine.h"

#include "vtkCallbackCommand.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkOBJReader.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

using namespace oversketch_test;
using oversketch::Failure;

namespace
{

// Points in single precision, as VTK's reader makes them up to 9.2; later ones read them in double.
vtkSmartPointer<vtkPolyData> objModel(const std::string& name)
{
  const std::string path = sharedData("meshes/" + name);
  if (path.empty())
  {
    std::cout << name << " is absent: set OVERSKETCH_DATA\n";
    return nullptr;
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_FLOAT);
  points->DeepCopy(reader->GetOutput()->GetPoints());
  reader->GetOutput()->SetPoints(points);
  return reader->GetOutput();
}

// In double precision, of an .obj of triangles alone or an .off; empty, saying so, where it is absent.
oversketch::Mesh exactModel(const std::string& name)
{
  oversketch::Mesh mesh;
  std::ifstream file(sharedData("meshes/" + name));
  if (!file)
  {
    std::cout << name << " is absent: set OVERSKETCH_DATA\n";
  }
  const bool off = name.find(".off") != std::string::npos;
  std::string line;
  for (int header = off ? 2 : 0; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string kind = off ? "" : "#";
    Vector3 p;
    oversketch::Triangle t;
    if (header > 0)
    {
      --header;
    }
    else if (off && line.rfind("3 ", 0) == 0 && words >> kind >> t[0] >> t[1] >> t[2])
    {
      mesh.triangles.push_back(t);
    }
    else if (off || (words >> kind && kind == "v"))
    {
      words >> p[0] >> p[1] >> p[2];
      mesh.points.push_back(p);
    }
    else if (kind == "f" && words >> t[0] >> t[1] >> t[2])
    {
      mesh.triangles.push_back({ t[0] - 1, t[1] - 1, t[2] - 1 });
    }
  }
  return mesh;
}

// A sphere whose texture is cut along half a meridian and whose triangles are two patches of colour.
vtkSmartPointer<vtkPolyData> seamed()
{
  const oversketch::Mesh ball = icosphere(4);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> texture;
  texture->SetName("TCoords");
  texture->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIntArray> patch;
  patch->SetName("Patch");
  std::map<std::pair<int, float>, vtkIdType> known;
  for (const oversketch::Triangle& t : ball.triangles)
  {
    const Vector3 middle = (ball.points[t[0]] + ball.points[t[1]] + ball.points[t[2]]) / 3.0;
    polys->InsertNextCell(3);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3& p = ball.points[t[k]];
      // Over the front, z > 0, the texture jumps at x = 0.
      const double u = p[0] + (middle[0] > 0.0 && middle[2] > 0.0 ? 4.0 : 0.0);
      const auto [at, isNew] =
        known.emplace(std::make_pair(t[k], static_cast<float>(u)), points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(p.data());
        texture->InsertNextTuple2(u, p[1]);
      }
      polys->InsertCellPoint(at->second);
    }
    patch->InsertNextValue(middle[1] > 0.0);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  mesh->GetPointData()->SetTCoords(texture);
  mesh->GetCellData()->AddArray(patch);
  return mesh;
}

// The same with one point a place, in the order of its first points.
oversketch::Mesh weldedSphere(vtkPolyData* mesh)
{
  oversketch::Mesh split;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    split.points.push_back(pointOf(mesh, i));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    mesh->GetPolys()->GetCellAtId(f, ids);
    split.triangles.push_back(
      { static_cast<int>(ids->GetId(0)), static_cast<int>(ids->GetId(1)), static_cast<int>(ids->GetId(2)) });
  }
  return oversketch::weldedMesh(split, oversketch::weldPoints(split.points));
}

} // namespace

TEST(AugmentPromises, RefusesStrokesAndNumbersThatAreNone)
{
  System s(shippedModel("bear"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  s.run();
  const auto refuse = [&](const char* words) { expectRefusal(s.filter, Failure::BadStroke, words); };
  vtkNew<vtkPolyData> none;
  s.filter->SetStrokesData(none);
  refuse("no stroke");
  s.filter->SetStrokesData(strokesOf({ { { 5, 5 }, { 40, 5 } } }, s.view));
  refuse("draw it over the model");
  s.filter->SetStrokesData(strokesOf({ { { 380, 300 }, { nan, 300 }, { 440, 300 } } }, s.view));
  refuse("troke");
  s.filter->SetStrokesData(strokesOf({ { { 380, 300 } } }, s.view));
  refuse("troke");
  s.filter->SetStrokesData(s.strokes);
  for (const double radius : { nan, std::numeric_limits<double>::infinity(), 0.0 })
  {
    s.filter->SetRadius(radius);
    refuse("adius");
  }
  s.filter->SetRadius(-1.0);
  s.filter->SetHeight(nan);
  refuse("Height");
  s.filter->SetHeight(0.0);
  s.filter->SetSharpness(-1.0);
  refuse("harpness");
  s.filter->SetSharpness(1.5);
  for (const char* profile : { "0 1, 0.6 0.5, 0.4 0.2, 1 0", "cat", "0 1" })
  {
    s.filter->SetProfile(profile);
    refuse("rofile");
  }
  s.filter->SetProfile("");
  auto viewless = copyOf(s.strokes);
  viewless->GetCellData()->RemoveArray("ViewTransform");
  s.filter->SetStrokesData(viewless);
  expectRefusal(s.filter, Failure::MissingArray, "ViewTransform");
  s.filter->SetStrokesData(s.strokes);
  EXPECT_GT(s.run()->GetNumberOfPoints(), 0);
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
  {
    auto blind = copyOf(s.strokes);
    blind->GetCellData()->GetArray(name)->SetComponent(0, 1, nan);
    s.filter->SetStrokesData(blind);
    refuse(name == std::string("ViewportSize") ? "positive" : "finite");
  }
  s.filter->SetStrokesData(s.strokes);
  // Edges that would take more triangles than memory holds.
  auto* refine = vtkOversketchStellarRefine::SafeDownCast(s.filter->GetStep("Refine"));
  refine->SetMaximumGeneration(62);
  refine->SetMaximumFaces(100000);
  s.filter->SetTargetEdgeLength(1e-12);
  expectRefusal(s.filter, Failure::BadRegion, "100000");
  s.filter->SetTargetEdgeLength(0.0);
  refine->SetMaximumGeneration(16);
  refine->SetMaximumFaces(4000000);
  // Radii that reach over everything, and that reach nothing.
  s.filter->SetRadius(10.0 * s.diagonal());
  EXPECT_GT(s.run()->GetNumberOfPoints(), 0);
  s.filter->SetRadius(1e-300);
  s.filter->Update();
  EXPECT_TRUE(s.filter->GetErrorCode() == 0u || s.filter->GetErrorCode() >= vtkErrorCode::UserError);
  vtkNew<vtkPolyData> empty;
  s.filter->SetInputData(0, empty);
  s.filter->SetRadius(-1.0);
  s.run();
  EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Rings, scribbles, many samples, into the air and back: a mesh whose 4-8 arrays hold, or one refusal.
TEST(AugmentPromises, AnyStrokeMakesASoundMeshOrOneMessage)
{
  std::vector<std::vector<Vector2>> strokes(5);
  for (int i = 0; i < 100000; ++i)
  {
    const double a = 2.0 * pi * i / 100000.0;
    strokes[0].emplace_back(400.0 + 40.0 * std::cos(a), 300.0 + 30.0 * std::sin(a));
  }
  for (int i = 0; i <= 200; ++i)
  {
    const double a = i / 20.0;
    strokes[1].emplace_back(
      400.0 + 60.0 * std::sin(3.1 * a), 300.0 + 50.0 * std::sin(4.3 * a)); // through itself
    strokes[2].emplace_back(50.0 + 3.5 * i, 300.0 + 20.0 * std::sin(a));   // over the edges
    strokes[3].emplace_back(400.0 + i % 2, 300.0);
    strokes[4].emplace_back(i % 3 ? 400.0 : 100.0, 250.0 + i % 7);
  }
  for (const std::vector<Vector2>& stroke : strokes)
  {
    System s(shippedModel("bear"), { stroke });
    Ear ear(s.filter);
    s.filter->Update();
    if (s.filter->GetErrorCode() != 0u)
    {
      EXPECT_EQ(ear.errors.size(), 1u);
      continue;
    }
    const auto output = copyOf(s.filter->GetOutput());
    vtkNew<vtkOversketchStellarBase> base;
    base->SetInputData(output);
    base->Update();
    EXPECT_EQ(base->GetBaseCount(), 0); // it goes through
    EXPECT_GT(output->GetNumberOfPolys(), s.mesh->GetNumberOfPolys());
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      ASSERT_TRUE(pointOf(output, i).allFinite());
    }
  }
}

// The same triangles however large the model is and wherever it stands.
TEST(AugmentPromises, SizeAndPlaceDoNotMatter)
{
  vtkIdType home = 0;
  for (const auto& [scale, shift] : { std::make_pair(1.0, 0.0),
         std::make_pair(std::ldexp(1.0, -60), 0.0),
         std::make_pair(std::ldexp(1.0, 30), 0.0),
         std::make_pair(1.0, 1024.0) })
  {
    auto mesh = copyOf(shippedModel("bear"));
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = scale * pointOf(mesh, i) + Vector3::Constant(shift);
      points->InsertNextPoint(p.data());
    }
    mesh->SetPoints(points);
    System s(mesh);
    const vtkIdType faces = s.run()->GetNumberOfPolys();
    home = home == 0 ? faces : home;
    EXPECT_EQ(faces, home) << scale << " " << shift;
  }
}

// Models as they come: a ten-millionth in size, and millions of lengths away.
TEST(AugmentPromises, TinyAndFarModelsBecomeWhatTheyDoAtHome)
{
  for (const auto& [name, scale, shift] : { std::make_tuple("dirty_tiny_scale.off", 1e7, Vector3(0, 0, 0)),
         std::make_tuple("dirty_far_from_origin.obj", 1.0, Vector3(-5e6, 3e6, -1e6)) })
  {
    const oversketch::Mesh model = exactModel(name);
    if (model.triangles.empty())
    {
      GTEST_SKIP() << "no shared data";
    }
    ASSERT_EQ(model.points.size(), 829u) << name;
    ASSERT_EQ(model.triangles.size(), 1654u) << name;
    oversketch::Mesh home = model;
    for (Vector3& p : home.points)
    {
      p = scale * (p + shift);
    }
    System there(toPolyData(model), { vein(200) }), here(toPolyData(home), { vein(200) });
    vtkPolyData *away = there.run(), *near = here.run();
    EXPECT_GT(near->GetNumberOfPolys(), 1654);
    EXPECT_EQ(away->GetNumberOfPolys(), near->GetNumberOfPolys()) << name;
    ASSERT_EQ(away->GetNumberOfPoints(), near->GetNumberOfPoints()) << name;
    double worst = 0.0;
    for (vtkIdType i = 0; i < away->GetNumberOfPoints(); ++i)
    {
      worst = std::max(worst, (scale * (pointOf(away, i) + shift) - pointOf(near, i)).norm());
    }
    EXPECT_LT(worst, 1e-6 * here.diagonal()) << name;
  }
}

TEST(AugmentPromises, ADirtyMeshIsRefusedByNameOrMadeASoundOne)
{
  const std::map<std::string, const char*> refused{ { "nonmanifold_edges.obj", "edge" },
    { "inside_out.obj", nullptr },
    { "holes.obj", nullptr },
    { "far_from_origin.obj", "without area" },
    { "klein_bottle.obj", "" } };
  for (const auto& [name, words] : refused)
  {
    const std::string path = sharedData("meshes/dirty_" + name);
    if (path.empty())
    {
      GTEST_SKIP() << "no shared data";
    }
    System s(objModel("dirty_" + name), { vein(200) });
    if (words)
    {
      expectRefusal(s.filter, Failure::BadMesh, words);
    }
    else
    {
      EXPECT_GT(s.run()->GetNumberOfPolys(), s.mesh->GetNumberOfPolys()) << name;
    }
  }
}

TEST(AugmentPromises, CancelledInAnyStageTheNextRunIsWhole)
{
  for (const int mode : { vtkOversketchAugment::Surface, vtkOversketchAugment::Silhouette })
  {
    System whole(shippedModel("dog"));
    if (mode == vtkOversketchAugment::Silhouette)
    {
      whole.strokes = strokesOf({ overTheTop(whole) }, whole.view);
      whole.filter->SetStrokesData(whole.strokes);
      whole.filter->SetSketchMode(vtkOversketchAugment::Silhouette);
    }
    whole.run();
    std::set<std::string> stopped;
    for (int i = 0; i < whole.filter->GetNumberOfStages(); ++i)
    {
      System s(whole.mesh);
      s.filter->SetStrokesData(whole.strokes);
      s.filter->SetSketchMode(mode);
      std::string stage = s.filter->GetStage(i);
      vtkNew<vtkCallbackCommand> stop;
      stop->SetClientData(&stage);
      stop->SetCallback(
        [](vtkObject* caller, unsigned long, void* name, void*)
        {
          auto* filter = static_cast<vtkOversketchAugment*>(caller);
          if (*static_cast<std::string*>(name) == filter->GetStageName())
          {
            filter->AbortExecuteOn();
          }
        });
      const unsigned long tag = s.filter->AddObserver(vtkCommand::ProgressEvent, stop);
      Ear ear(s.filter);
      s.filter->Update();
      EXPECT_TRUE(ear.errors.empty());
      if (s.filter->GetErrorCode() == codeOf(Failure::Cancelled))
      {
        stopped.insert(stage);
        EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
      }
      s.filter->RemoveObserver(tag);
      s.filter->AbortExecuteOff();
      s.filter->Modified();
      expectSame(whole.filter->GetOutput(), s.run());
    }
    for (const char* stage : { "Base", "Refine", "Snap", "Displace" })
    {
      EXPECT_TRUE(stopped.count(stage)) << stage;
    }
  }
}

// Of the two sides of a seam each keeps its texture, also under a stroke that runs across and along it; what
// the output says of itself as a 4-8 mesh holds, so a second stroke goes on from it.
TEST(AugmentPromises, TextureSeamsKeepTheirSides)
{
  vtkSmartPointer<vtkPolyData> mesh = seamed();
  std::vector<Vector2> wave;
  for (int i = 0; i <= 60; ++i)
  {
    wave.emplace_back(400.0 + 30.0 * std::sin(i / 6.0), 200.0 + 200.0 * i / 60.0);
  }
  System s(mesh, { wave });
  vtkSmartPointer<vtkPolyData> first = copyOf(s.run());
  System next(first);
  next.filter->SetStrokesData(strokesOf({ { { 320, 300 }, { 480, 310 } } }, s.view));
  vtkSmartPointer<vtkPolyData> second = copyOf(next.run());
  EXPECT_EQ(vtkOversketchStellarBase::SafeDownCast(next.filter->GetStep("Base"))->GetBaseCount(), 0);
  System chain(mesh, { wave, { { 320, 300 }, { 480, 310 } } });
  chain.filter->OneByOneOn();
  EXPECT_TRUE(identical(second, chain.run())); // textures are mixed once instead of twice
  vtkDataArray* once = chain.filter->GetOutput()->GetPointData()->GetTCoords();
  vtkDataArray* twice = second->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(twice->GetComponent(i, 0), once->GetComponent(i, 0), 1e-3);
    EXPECT_NEAR(twice->GetComponent(i, 1), once->GetComponent(i, 1), 1e-3);
  }
  for (vtkPolyData* output : { first.Get(), second.Get(), chain.filter->GetOutput() })
  {
    EXPECT_TRUE(output->GetCellData()->GetArray("StellarPath"));
    vtkDataArray* texture = output->GetPointData()->GetTCoords();
    vtkDataArray* patch = output->GetCellData()->GetArray("Patch");
    ASSERT_TRUE(texture && patch);
    EXPECT_FALSE(output->GetPointData()->GetArray("Place"));
    vtkNew<vtkIdList> ids;
    for (vtkIdType f = 0; f < output->GetNumberOfPolys(); ++f)
    {
      output->GetPolys()->GetCellAtId(f, ids);
      int right = 0;
      for (vtkIdType k = 0; k < 3; ++k)
      {
        // No corner lies between the sides.
        const double u = texture->GetComponent(ids->GetId(k), 0);
        EXPECT_LT(std::min(std::abs(u), std::abs(u - 4.0)), 1.1);
        right += u > 2.0;
        // A point that rose by h still shows what lay under it.
        const Vector3 p = pointOf(output, ids->GetId(k));
        EXPECT_NEAR(texture->GetComponent(ids->GetId(k), 1), p[1] / p.norm(), 0.05);
      }
      EXPECT_TRUE(right == 0 || right == 3) << f;
    }
  }
  // Points that repeat a place stand last.
  std::set<std::vector<double>> places;
  bool repeats = false;
  for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = pointOf(first, i);
    const bool isNew = places.insert({ p[0], p[1], p[2] }).second;
    EXPECT_FALSE(isNew && repeats) << i;
    repeats = repeats || !isNew;
  }
  EXPECT_TRUE(repeats);
}

using SeamEdges = std::vector<std::pair<vtkIdType, vtkIdType>>;

// Edges between cells of different charts.
SeamEdges seamEdges(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, double> seen;
  vtkDataArray* charts = mesh->GetCellData()->GetArray("Chart");
  SeamEdges seams;
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; charts && f < mesh->GetNumberOfPolys(); ++f)
  {
    mesh->GetPolys()->GetCellAtId(f, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const vtkIdType a = ids->GetId(k), b = ids->GetId((k + 1) % 3);
      const auto [other, isNew] = seen.emplace(std::minmax(a, b), charts->GetComponent(f, 0));
      if (!isNew && other->second != charts->GetComponent(f, 0))
      {
        seams.push_back(other->first);
      }
    }
  }
  return seams;
}

// What lies on a seam stays on its line, so the texture beside it is that of the place: no point of one side
// is drawn over the other.
TEST(AugmentPromises, SeamsStayWhereTheyAre)
{
  std::vector<Vector2> wave;
  for (int i = 0; i <= 60; ++i)
  {
    wave.emplace_back(400.0 + 12.0 * std::sin(i / 6.0), 200.0 + 200.0 * i / 60.0);
  }
  System s(seamed(), { wave });
  vtkPolyData* output = s.run();
  vtkPolyData *base = s.filter->GetInnerOutput("Base"), *even = s.filter->GetInnerOutput("Smooth");
  vtkDataArray* curve = even->GetPointData()->GetArray("CurveId");
  ASSERT_TRUE(curve);
  const SeamEdges before = seamEdges(base), after = seamEdges(even);
  EXPECT_GT(after.size(), before.size());
  std::set<vtkIdType> onSeam;
  for (const auto& [a, b] : after)
  {
    onSeam.insert(a);
    onSeam.insert(b);
  }
  int snapped = 0;
  for (const vtkIdType point : onSeam)
  {
    snapped += curve->GetComponent(point, 0) >= 0.0;
    const Vector3 p = pointOf(even, point);
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : before)
    {
      const Vector3 from = pointOf(base, a), along = pointOf(base, b) - from;
      const double share = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - from - share * along).norm());
    }
    EXPECT_LE(nearest, 1e-12) << p.transpose();
  }
  EXPECT_GT(snapped, 3);
  // The first points of the output are those of the steps; the texture is x, and 4 more on one side.
  vtkDataArray* texture = output->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < even->GetNumberOfPoints(); ++i)
  {
    const double u = texture->GetComponent(i, 0);
    EXPECT_NEAR(u > 2.0 ? u - 4.0 : u, pointOf(even, i)[0], 2e-3) << i;
  }
}

// Welding the output gives what the mesh with the same charts and no texture becomes, points, cells and
// Stellar arrays.
TEST(AugmentPromises, WeldedTheOutputIsThatOfTheMeshWithoutSeams)
{
  System split(seamed());
  vtkPolyData* output = split.run();
  const oversketch::Mesh sphere = weldedSphere(split.mesh);
  System bare(toPolyData(sphere));
  vtkNew<vtkIntArray> charts;
  charts->SetName("Chart");
  for (const oversketch::Triangle& t : sphere.triangles)
  {
    const Vector3 middle = (sphere.points[t[0]] + sphere.points[t[1]] + sphere.points[t[2]]) / 3.0;
    charts->InsertNextValue(middle[0] > 0.0 && middle[2] > 0.0);
  }
  bare.mesh->GetCellData()->AddArray(charts);
  vtkPolyData* single = bare.run();
  ASSERT_GT(output->GetNumberOfPoints(), single->GetNumberOfPoints());
  ASSERT_EQ(output->GetNumberOfPolys(), single->GetNumberOfPolys());
  std::map<std::vector<double>, vtkIdType> vertices; // by place
  const auto vertexAt = [&](const Vector3& p)
  {
    return vertices.emplace(std::vector<double>{ p[0], p[1], p[2] }, static_cast<vtkIdType>(vertices.size()))
      .first->second;
  };
  vtkDataArray* moved = output->GetPointData()->GetArray("StellarMoved");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const vtkIdType v = vertexAt(pointOf(output, i));
    EXPECT_TRUE(i >= single->GetNumberOfPoints() || v == i);
    EXPECT_EQ(pointOf(output, i), pointOf(single, v));
    EXPECT_EQ(
      moved->GetComponent(i, 0), single->GetPointData()->GetArray("StellarMoved")->GetComponent(v, 0));
  }
  vtkNew<vtkIdList> a, b;
  for (vtkIdType f = 0; f < output->GetNumberOfPolys(); ++f)
  {
    output->GetPolys()->GetCellAtId(f, a);
    single->GetPolys()->GetCellAtId(f, b);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      EXPECT_EQ(vertexAt(pointOf(output, a->GetId(k))), b->GetId(k));
    }
  }
  for (const char* name : { "StellarRoot", "StellarPath", "StellarGen" })
  {
    EXPECT_TRUE(sameArray(output->GetCellData()->GetArray(name), single->GetCellData()->GetArray(name)));
  }
}

TEST(AugmentPromises, AModelsTextureStaysOnIt)
{
  vtkSmartPointer<vtkPolyData> spot = objModel("spot_uv.obj");
  if (!spot)
  {
    GTEST_SKIP();
  }
  System s(spot);
  const double r = 0.03 * s.diagonal();
  vtkPolyData* output = s.run();
  ASSERT_GT(output->GetNumberOfPolys(), spot->GetNumberOfPolys());
  vtkDataArray* before = spot->GetPointData()->GetTCoords();
  vtkDataArray* after = output->GetPointData()->GetTCoords();
  ASSERT_TRUE(before && after);
  // Every pair of place and texture of the model away from the stroke is there.
  std::set<std::vector<double>> there;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = pointOf(output, i);
    there.insert({ p[0], p[1], p[2], after->GetComponent(i, 0), after->GetComponent(i, 1) });
  }
  vtkPolyData* curves = s.filter->GetInnerOutput("Curves");
  for (vtkIdType i = 0; i < spot->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = pointOf(spot, i);
    double away = HUGE_VAL;
    for (vtkIdType c = 0; c < curves->GetNumberOfPoints(); ++c)
    {
      away = std::min(away, (pointOf(curves, c) - p).norm());
    }
    if (away > 1.5 * r)
    {
      EXPECT_TRUE(there.count({ p[0], p[1], p[2], before->GetComponent(i, 0), before->GetComponent(i, 1) }))
        << i;
    }
  }
}
