// Drawings that nobody should draw: system C makes a closed mesh, or says in one message which stroke it is
// and what to do. Random ones: 15; OVERSKETCH_DRAWINGS=1000 and OVERSKETCH_FIRST_DRAWING=NUMBER ask for
// others, a drawing is made of its number.
#include "DrawingRuns.h"

#include "Harness/sequences.h"

#include <cstdlib>
#include <ctime>
#include <random>
#include <regex>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr double slowest = 60.0; // s of the processor

int asked(const char* name, int otherwise)
{
  const char* value = std::getenv(name);
  return value ? std::atoi(value) : otherwise;
}

struct Outcomes
{
  int made = 0, refused = 0;
  double longest = 0.0; // s
};

bool isSaid(const std::string& text)
{
  static const std::regex named("([Ss]troke \"?[0-9A-Za-z]|[Nn]o stroke).*[;:] *\\S");
  return std::regex_search(text, named) && text.find("nexpected") == std::string::npos;
}

int objectsOf(vtkPolyData* mesh)
{
  vtkDataArray* ids = mesh->GetCellData()->GetArray("ObjectId");
  std::set<double> objects;
  for (vtkIdType face = 0; ids && face < mesh->GetNumberOfPolys(); ++face)
  {
    objects.insert(ids->GetComponent(face, 0));
  }
  return static_cast<int>(objects.size());
}

// Whatever it is: a mesh of finite points, closed, manifold, with its faces outwards and a ball for each
// object where nothing is cut out, or one message of a stroke and a remedy and nothing put out.
void expectSound(vtkOversketchInflateDrawing* filter, Outcomes& outcomes)
{
  Ear ear(filter);
  const std::clock_t began = std::clock();
  filter->Update();
  const double took = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  outcomes.longest = std::max(outcomes.longest, took);
  EXPECT_LT(took, slowest);
  vtkPolyData* mesh = filter->GetOutput();
  if (filter->GetErrorCode() != 0)
  {
    ++outcomes.refused;
    ASSERT_EQ(ear.errors.size(), 1u);
    EXPECT_TRUE(isSaid(ear.errors[0])) << ear.errors[0];
    EXPECT_EQ(mesh->GetNumberOfPoints(), 0);
    return;
  }
  ++outcomes.made;
  EXPECT_TRUE(ear.errors.empty());
  for (const std::string& warning : ear.warnings)
  {
    EXPECT_TRUE(isSaid(warning)) << warning;
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    ASSERT_TRUE(Vector3(mesh->GetPoint(i)).allFinite());
  }
  ASSERT_GT(mesh->GetNumberOfPoints(), 0) << "neither a mesh nor a word";
  const Topology topology = topologyOf(mesh);
  EXPECT_TRUE(topology.closed);
  EXPECT_TRUE(topology.manifold) << "a vertex holds two fans of faces together";
  EXPECT_GT(volumeOf(mesh), 0.0);
  EXPECT_EQ(topology.pieces, objectsOf(mesh));
  EXPECT_EQ(topology.chi, 2 * topology.pieces);
}

Line polar(const Vector2& centre, const std::function<double(double)>& radius, int count, double turns = 1.0)
{
  Line line;
  line.closed = turns == 1.0;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * pi * turns * i / count;
    line.points.push_back(centre + radius(angle) * Vector2(std::cos(angle), std::sin(angle)));
  }
  return line;
}

Line open(std::vector<Vector2> points)
{
  return { std::move(points), false };
}

struct Case
{
  const char* name;
  std::vector<Line> lines;
  const char* says;     // of a refusal; null where a mesh is made
  const char* arranged; // the same with strokes arranged
};

std::vector<Case> cases()
{
  const Line eight = polar(
    { 400, 300 }, [](double a) { return 200.0 * std::cos(2.0 * a); }, 400);
  const Line spiral = polar(
    { 400, 300 }, [](double a) { return 20.0 + 6.0 * a; }, 1200, 5.0);
  const Line star = polar(
    { 400, 300 }, [](double a) { return 200.0 + 60.0 * std::cos(64.0 * a); }, 2000);
  std::vector<Line> nested, many{ circle(400, 300, 280) };
  for (int i = 0; i < 8; ++i)
  {
    nested.push_back(circle(400, 300, 280 - 32 * i));
  }
  for (int i = 0; i < 199; ++i)
  {
    const int row = i / 15;
    const Vector2 at(240.0 + 22.0 * (i % 15), 170.0 + 20.0 * row);
    many.push_back(i % 2 ? circle(at[0], at[1], 9) : open({ at, at + Vector2(6, 4), at + Vector2(9, -3) }));
  }
  const Line body = circle(400, 300, 200);
  return {
    { "one point", { open({ { 100, 100 } }) }, "stroke", "stroke" },
    { "NaN", { body, open({ { 400, 300 }, { std::nan(""), 310 }, { 420, 300 } }) }, "finite", "finite" },
    { "off the canvas", { open({ { 100, 100 }, { 900, 700 } }) }, "bounds an object", "bounds an object" },
    { "an outline off the canvas", { circle(700, 300, 200) }, "bounds an object", "bounds an object" },
    { "on the canvas's edge",
      { { { { 0, 0 }, { 800, 0 }, { 800, 600 }, { 0, 600 } }, true } },
      nullptr,
      nullptr },
    { "the same twice", { body, body }, "crosses", nullptr },
    { "figure eight", { eight }, "crosses itself", "hang together" },
    { "spiral", { spiral }, "closed", "closed" },
    { "spiral inside", { circle(400, 300, 280), spiral }, nullptr, nullptr },
    { "64 spikes", { star }, nullptr, nullptr },
    { "8 nested", nested, nullptr, nullptr },
    { "200 strokes", many, nullptr, nullptr },
    { "under 9 px", { body, circle(400, 300, 1.0) }, nullptr, nullptr },
    { "under 9 px alone", { circle(400, 300, 1.0) }, "bounds an object", "bounds an object" },
  };
}

} // namespace

TEST(HostileDrawings, WhatIsAskedOfAMeshSeesItsFaults)
{
  // Two tetrahedra that share a vertex: closed, but no surface there.
  vtkNew<vtkPoints> points;
  for (const Vector3& p : std::vector<Vector3>{
         { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } })
  {
    points->InsertNextPoint(p.data());
  }
  const std::vector<std::array<vtkIdType, 3>> one = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  const std::vector<std::array<vtkIdType, 3>> other = { { 0, 4, 5 }, { 0, 6, 4 }, { 0, 5, 6 }, { 4, 6, 5 } };
  const auto meshOf = [&](std::vector<std::array<vtkIdType, 3>> faces, bool turned = false)
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkCellArray> cells;
    for (std::array<vtkIdType, 3>& face : faces)
    {
      if (turned)
      {
        std::swap(face[0], face[1]);
      }
      cells->InsertNextCell(3, face.data());
    }
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    return mesh;
  };
  const auto ball = meshOf(one);
  EXPECT_TRUE(topologyOf(ball).closed && topologyOf(ball).manifold);
  EXPECT_EQ(topologyOf(ball).chi, 2);
  EXPECT_EQ(topologyOf(ball).pieces, 1);
  EXPECT_NEAR(volumeOf(ball), 1.0 / 6.0, 1e-12);
  EXPECT_NEAR(volumeOf(meshOf(one, true)), -1.0 / 6.0, 1e-12);
  EXPECT_FALSE(topologyOf(meshOf({ one[0], one[1], one[2] })).closed);
  EXPECT_FALSE(topologyOf(meshOf({ one[0], one[1], one[2] })).manifold);
  std::vector<std::array<vtkIdType, 3>> both = one;
  both.insert(both.end(), other.begin(), other.end());
  const auto pinched = meshOf(both);
  EXPECT_TRUE(topologyOf(pinched).closed);
  EXPECT_FALSE(topologyOf(pinched).manifold);
  EXPECT_EQ(topologyOf(pinched).chi, 3);
  EXPECT_TRUE(isSaid("Stroke 3 crosses itself; draw it anew."));
  EXPECT_FALSE(isSaid("Stroke 3 crosses itself."));
  EXPECT_FALSE(isSaid("It crosses itself; draw it anew."));
}

TEST(HostileDrawings, EachIsAMeshOrOneMessage)
{
  for (const Case& one : cases())
  {
    for (const bool arranged : { false, true })
    {
      SCOPED_TRACE(std::string(one.name) + (arranged ? ", arranged" : ""));
      vtkNew<vtkOversketchInflateDrawing> filter;
      filter->SetInputData(0, drawn(one.lines));
      filter->SetArrange(arranged);
      filter->SetLevels(2);
      const char* says = arranged ? one.arranged : one.says;
      Outcomes outcomes;
      expectSound(filter, outcomes);
      EXPECT_EQ(outcomes.made, says ? 0 : 1);
      EXPECT_EQ(outcomes.refused, says ? 1 : 0);
      if (!says)
      {
        EXPECT_EQ(objectsOf(filter->GetOutput()), 1) << "one body, whatever is drawn in it";
      }
      else
      {
        filter->Modified();
        expectRefusal(filter, Failure::BadStroke, says);
      }
    }
  }
}

TEST(HostileDrawings, HolesThatAreNone)
{
  System system(drawn({ circle(400, 300, 250), circle(400, 300, 150), circle(400, 300, 60) }));
  system.filter->SetLevels(2);
  system.filter->SetHoles("0");
  expectRefusal(system.filter, Failure::BadStroke, "Holes names stroke 0");
  // A hole in a hole goes with it, anything else in it is an island.
  system.filter->SetHoles("1 2");
  EXPECT_EQ(topologyOf(system.mesh()).chi, 0);
  const vtkIdType faces = system.filter->GetOutput()->GetNumberOfPolys();
  system.filter->SetHoles("1");
  EXPECT_EQ(topologyOf(system.mesh()).chi, 0 + 2);
  EXPECT_TRUE(topologyOf(system.filter->GetOutput()).closed);
  EXPECT_GT(system.filter->GetOutput()->GetNumberOfPolys(), faces);
  system.filter->SetTunnels("1");
  expectRefusal(system.filter, Failure::BadStroke, "name it once");
}

TEST(HostileDrawings, CanvasesOfAnySizeAndPlace)
{
  vtkIdType faces = 0;
  for (const auto& [corner, size] :
    { std::pair<double, double>(0.0, 1.0), { 0.0, 1e-6 }, { 5e6, 1.0 }, { -5e6, 1e4 } })
  {
    SCOPED_TRACE(corner);
    const View view = viewOver({ corner, corner }, { size, 0.75 * size }, 800, 600);
    vtkNew<vtkAppendPolyData> all;
    all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    for (const Line& line : { circle(400, 300, 200), circle(420, 310, 60) })
    {
      std::vector<Vector2> points = line.points;
      points.push_back(points[0]);
      all->AddInputData(toStroke(points, view));
    }
    all->Update();
    System system(all->GetOutput());
    system.filter->SetHoles("1");
    system.filter->SetLevels(2);
    const Topology topology = topologyOf(system.mesh());
    EXPECT_TRUE(topology.closed);
    EXPECT_EQ(topology.chi, 0);
    const auto box = boxOf(system.filter->GetOutput());
    EXPECT_NEAR(box[1] - box[0], 0.5 * size, 0.01 * size);
    EXPECT_GT(box[5], 0.05 * size);
    faces = faces > 0 ? faces : system.filter->GetOutput()->GetNumberOfPolys();
    EXPECT_NEAR(static_cast<double>(system.filter->GetOutput()->GetNumberOfPolys()),
      static_cast<double>(faces),
      0.3 * static_cast<double>(faces));
  }
}

TEST(HostileDrawings, ViewsThatGiveNoCanvas)
{
  // Two views, and one askew: without a picture nothing says where the canvas is.
  const View facing = viewOver({ 0.0, 0.0 }, { 800.0, 600.0 }, 800, 600);
  const View other = viewOver({ 100.0, 0.0 }, { 400.0, 300.0 }, 800, 600);
  const View askew = perspectiveView({ 300, -900, 900 }, { 0, 1, 0 }, 40);
  const auto strokesIn = [](const View& one, const View& two)
  {
    vtkNew<vtkAppendPolyData> all;
    all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    const View* views[] = { &one, &two };
    for (const int i : { 0, 1 })
    {
      std::vector<Vector2> points = circle(200, 150, i == 0 ? 100 : 30).points;
      points.push_back(points[0]);
      all->AddInputData(toStroke(points, *views[i]));
    }
    all->Update();
    return vtkSmartPointer<vtkPolyData>(all->GetOutput());
  };
  for (const auto& strokes : { strokesIn(facing, other), strokesIn(askew, askew) })
  {
    System system(strokes);
    expectRefusal(system.filter, Failure::BadStroke, "anvas");
  }
  // With a picture each is laid where its own view shows it.
  const auto image = picture(800, 600, 1, [](int, int, int) { return 100; });
  System system(strokesIn(facing, other));
  system.filter->SetInputData(1, image);
  Outcomes outcomes;
  expectSound(system.filter, outcomes);
  EXPECT_EQ(outcomes.made, 1);
}

TEST(HostileDrawings, RandomOnesAreMadeOrNamed)
{
  Outcomes outcomes;
  const int first =
              asked("OVERSKETCH_FIRST_DRAWING", static_cast<int>(oversketch_test::firstOfTheDay(30, 1000))),
            count = asked("OVERSKETCH_DRAWINGS", 15);
  for (int run = first; run < first + count; ++run)
  {
    SCOPED_TRACE("drawing " + std::to_string(run));
    std::mt19937 random(static_cast<unsigned>(run));
    const auto in = [&](double least, double most)
    { return least + (most - least) * static_cast<double>(random()) / 4294967296.0; };
    const int strokes = 1 + static_cast<int>(random() % 12);
    const bool wild = run % 4 == 3; // anywhere, else features in a body
    std::vector<Line> lines;
    for (int s = 0; s < strokes; ++s)
    {
      const bool isBody = s == 0 && !wild;
      const Vector2 middle = isBody ? Vector2(400, 300)
                             : wild ? Vector2(in(50, 750), in(50, 550))
                                    : Vector2(in(250, 550), in(180, 420));
      const double size = isBody ? in(150, 230) : wild ? in(5, 250) : in(2, 45);
      const double depth = in(0.0, isBody ? 0.3 : 0.5), shift = in(0.0, 6.28);
      const int waves = 2 + static_cast<int>(random() % 7);
      const bool closed = isBody || random() % 2 == 0;
      Line line = polar(
        middle,
        [&](double a) { return size * (1.0 + depth * std::cos(waves * a + shift)); },
        80 + static_cast<int>(random() % 150),
        closed ? 1.0 : in(0.1, 0.7));
      for (Vector2& p : line.points)
      {
        p += Vector2(in(-0.6, 0.6), in(-0.6, 0.6)); // a hand
      }
      lines.push_back(std::move(line));
    }
    vtkNew<vtkOversketchInflateDrawing> filter;
    filter->SetInputData(0, drawn(lines));
    filter->SetArrange(run % 2 == 1);
    filter->SetQuads(run % 5 == 4);
    filter->SetExtrudeDepth(run % 7 == 6 ? 20.0 : 0.0);
    filter->SetLevels(1 + run % 3);
    expectSound(filter, outcomes);
  }
  std::cout << outcomes.made << " made, " << outcomes.refused << " refused, the longest took "
            << outcomes.longest << " s\n";
  EXPECT_GT(outcomes.made, count / 4);
  EXPECT_GT(outcomes.refused, 0);
}
