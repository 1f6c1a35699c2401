// Sixty pairs of closed bodies joined: closed, oriented, of the right Euler number and volume, without faces
// that go through each other, kept points bit for bit.
#include "Harness/data.h"
#include "Harness/shipped.h"
#include "Intersection/crossing_faces.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchInflateDrawing.h"
#include "vtkOversketchJoin.h"

#include "vtkCleanPolyData.h"
#include "vtkOBJReader.h"
#include "vtkSTLReader.h"

#ifdef OVERSKETCH_CGAL
#include "Harness/cgal_surface.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#endif

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

struct Pair
{
  std::string name;
  std::function<Mesh()> a, b;
  bool touches = false; // within the distance at which parts meet
};

Mesh welded(vtkPolyData* data)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(data);
  clean->SetTolerance(0.0);
  clean->PointMergingOn();
  clean->Update();
  return MeshOf(clean->GetOutput());
}

Mesh read(const std::string& name)
{
  const auto of = [](auto reader, const std::string& path)
  {
    reader->SetFileName(path.c_str());
    reader->Update();
    return welded(reader->GetOutput());
  };
  if (name.find('.') == std::string::npos)
  {
    return welded(shippedModel(name));
  }
  const std::string path = sharedData("meshes/" + name), end = name.substr(name.size() - 3);
  if (path.empty())
  {
    return {};
  }
  return end == "ply"   ? of(vtkSmartPointer<vtkPLYReader>::New(), path)
         : end == "obj" ? of(vtkSmartPointer<vtkOBJReader>::New(), path)
                        : of(vtkSmartPointer<vtkSTLReader>::New(), path);
}

Mesh inflated(const std::string& drawing)
{
  vtkNew<vtkXMLPolyDataReader> strokes;
  strokes->SetFileName((OVERSKETCH_DATA_FOLDER "/Drawings/" + drawing + ".vtp").c_str());
  vtkNew<vtkOversketchInflateDrawing> system;
  system->SetInputConnection(0, strokes->GetOutputPort());
  system->Update();
  return welded(system->GetOutput());
}

// The middle at the origin, a box of diagonal 1.
Mesh normalised(Mesh mesh)
{
  const Eigen::AlignedBox3d box = boxRound(mesh.points);
  for (Vector3& p : mesh.points)
  {
    p = (p - box.center()) / box.diagonal().norm();
  }
  return mesh;
}

Mesh placed(Mesh mesh, double scale, double turn, const Vector3& shift)
{
  const Eigen::Matrix3d by =
    scale * Eigen::AngleAxisd(turn, Vector3(0.3, 1.0, 0.2).normalized()).toRotationMatrix();
  for (Vector3& p : mesh.points)
  {
    p = by * p + shift;
  }
  return mesh;
}

Mesh bar(const Vector3& size, const Vector3& low, int parts = 1)
{
  Mesh mesh = box(low, low + size);
  for (int i = 0; i < parts; ++i) // each triangle in four
  {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int p, int q)
    {
      const auto added = middles.emplace(std::minmax(p, q), mesh.vertexCount());
      if (added.second)
      {
        mesh.points.push_back((mesh.points[p] + mesh.points[q]) / 2.0);
      }
      return added.first->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh.triangles)
    {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      finer.insert(finer.end(), { { t[0], ab, ca }, { t[1], bc, ab }, { t[2], ca, bc }, { ab, bc, ca } });
    }
    mesh.triangles = finer;
  }
  return mesh;
}

std::vector<Pair> sixtyPairs()
{
  std::vector<Pair> pairs;
  // Models, the second one smaller, its middle at a point of the first one.
  const std::vector<std::string> names{ "bear",
    "armadillo_29k.obj",
    "dinosaur",
    "bunny_30k.ply",
    "dog",
    "capsule_figure.obj",
    "hand",
    "cow_nc.stl",
    "octopus",
    "hand_closed.obj",
    "person",
    "knot_trefoil.ply",
    "bear",
    "koala.stl",
    "dog",
    "man.ply",
    "dinosaur",
    "penguin.obj",
    "hand",
    "scorpion.ply",
    "octopus",
    "spot_5k9.obj",
    "person",
    "wingnut.stl" };
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::string one = names[i], two = names[(i + 1) % names.size()];
    pairs.push_back({ one + " and " + two,
      [one] { return normalised(read(one)); },
      [one, two, i]
      {
        const Mesh at = normalised(read(one));
        return placed(
          normalised(read(two)), 0.6, 0.7 * static_cast<double>(i), at.points[7919 * i % at.points.size()]);
      } });
  }
  // Inflated parts.
  for (const auto& [one, two] : std::vector<std::pair<std::string, std::string>>{
         { "fish", "fish" }, { "padlock", "heron" }, { "figure_body", "figure_head" }, { "mug", "leaf" } })
  {
    pairs.push_back({ one + " and " + two + ", inflated",
      [one] { return normalised(inflated(one)); },
      [two] {
        return placed(normalised(inflated(two)), 0.8, 0.6, { 0.11, 0.07, 0.03 });
      } });
  }
  // The same mesh again, and by a hair beside itself.
  for (const auto& [name, shift] : std::vector<std::pair<std::string, double>>{ { "bear", 0.0 },
         { "bear", 1e-9 },
         { "dinosaur", 1e-9 },
         { "hand", 1e-12 },
         { "octopus", 1e-7 },
         { "person", 1e-6 },
         { "knot_trefoil.ply", 1e-9 },
         { "dog", 1e-5 } })
  {
    pairs.push_back({ name + " shifted by " + std::to_string(shift),
      [name] { return normalised(read(name)); },
      [name, shift] { return placed(normalised(read(name)), 1.0, 0.0, Vector3(1.0, 0.3, 0.7) * shift); } });
  }
  // Faces in one plane, points on faces, edges on edges.
  const auto cube = [](int parts) { return [parts] { return bar({ 2, 2, 2 }, { 0, 0, 0 }, parts); }; };
  const std::vector<std::pair<Vector3, Vector3>> sizes{ { { 2, 2, 2 }, { 2, 0, 0 } },
    { { 1, 1, 1 }, { 0.5, 0.25, 2 } },
    { { 1, 4, 2 }, { 0.5, -1, 0 } },
    { { 1, 1, 1 }, { 0, 0, 0 } },
    { { 2, 2, 1 }, { 0, 0, 1 } },
    { { 1, 1, 3 }, { 0.5, 0.5, 1 } } };
  for (const auto& [size, low] : sizes)
  {
    for (const int parts : { 0, 2 })
    {
      pairs.push_back({ "boxes " + std::to_string(pairs.size()),
        cube(parts),
        [size = size, low = low, parts] { return bar(size, low, parts); } });
    }
  }
  // A bar through a torus, a ring in a ring.
  for (const double turn : { 0.0, 0.3, 1.1 })
  {
    pairs.push_back({ "bar through a torus " + std::to_string(turn),
      [] { return torus(1.0, 0.3, 80, 30); },
      [turn] {
        return placed(bar({ 3.2, 0.2, 0.3 }, { -1.6, -0.1, -0.15 }, 1), 1.0, turn, Vector3::Zero());
      } });
  }
  pairs.push_back({ "ring in ring",
    [] { return torus(1.0, 0.3, 80, 30); },
    [] {
      return placed(torus(1.0, 0.28, 70, 30), 1.0, 1.4, { 0.9, 0.1, 0.0 });
    } });
  // Balls that all but touch, at a point of theirs.
  for (const double gap : { 1e-9, 0.0, -1e-9, -1e-6, -1e-4 })
  {
    pairs.push_back({ "balls with a gap of " + std::to_string(gap),
      [] { return icosphere(4); },
      [gap] { return placed(icosphere(4), 1.0, 0.0, (2.0 + gap) * icosphere(4).points[0].normalized()); },
      gap >= 0.0 });
  }
  // 100,000 triangles each.
  pairs.push_back({ "large balls",
    [] { return icosphere(6); },
    [] {
      return placed(icosphere(6), 1.0, 0.4, { 0.9, 0.3, 0.2 });
    } });
  pairs.push_back({ "large rabbits",
    [] { return normalised(read("bunny_180k.ply")); },
    [] {
      return placed(normalised(read("bunny_180k.ply")), 0.9, 0.8, { 0.1, 0.1, 0.15 });
    } });
  pairs.push_back({ "large torus and ball",
    [] { return torus(1.0, 0.3, 400, 125); },
    [] {
      return placed(icosphere(6), 0.5, 0.4, { 0.9, 0.3, 0.2 });
    } });
  return pairs;
}

struct Truth
{
  double volume = 0.0;
  int euler = 0;
};

// By CGAL's corefinement, where it can.
std::optional<Truth> truthOf(const Mesh& a, const Mesh& b)
{
#ifdef OVERSKETCH_CGAL
  try
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    CgalSurface one = cgalSurface(a), two = cgalSurface(b), out;
    if (PMP::corefine_and_compute_union(one, two, out, CGAL::parameters::throw_on_self_intersection(true)))
    {
      return Truth{ CGAL::to_double(PMP::volume(out)), eulerNumber(out) };
    }
  }
  catch (const std::exception&)
  {
  }
#endif
  return std::nullopt;
}

double volumeOf(const Mesh& mesh)
{
  double six = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    six += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]]));
  }
  return six / 6.0;
}

std::array<double, 3> keyOf(const Vector3& p)
{
  return { p[0], p[1], p[2] };
}

// Points whose triangles touch the other body's box nowhere stay: they are in the result, or the triangles
// are inside the other one as a whole.
void expectKept(const Mesh& of, const Mesh& other, const std::set<std::array<double, 3>>& points)
{
  const Eigen::AlignedBox3d room = boxRound(other.points);
  int lost = 0;
  for (const Vector3& p : of.points)
  {
    lost += room.exteriorDistance(p) > 0.1 && points.count(keyOf(p)) == 0;
  }
  EXPECT_EQ(lost, 0);
}

TEST(Join, SixtyPairs)
{
  const bool full = std::getenv("OVERSKETCH_FULL") != nullptr;
  const std::vector<Pair> pairs = sixtyPairs();
  ASSERT_EQ(pairs.size(), 60u);
  int joined = 0, refused = 0, compared = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    if (!full && i % 12 != 1)
    {
      continue;
    }
    SCOPED_TRACE(pairs[i].name);
    const Mesh a = pairs[i].a(), b = a.points.empty() ? Mesh() : pairs[i].b();
    if (b.points.empty()) // models that are not shipped are absent
    {
      std::cout << pairs[i].name << ": skipped, a model is absent" << std::endl;
      continue;
    }
    vtkNew<vtkOversketchJoin> join;
    join->SetInputData(0, toPolyData(a));
    join->SetInputData(1, toPolyData(b));
    Ear ear(join);
    join->Update();
    if (join->GetErrorCode() != 0)
    {
      ASSERT_EQ(ear.errors.size(), 1u);
      std::cout << pairs[i].name << ": " << ear.errors[0] << std::endl;
      ++refused;
      continue;
    }
    ++joined;
    const Mesh made = MeshOf(join->GetOutput());
    const Adjacency edges = buildAdjacency(made);
    int open = 0, turned = 0;
    for (int e = 0; e < static_cast<int>(edges.edges.size()); ++e)
    {
      const MeshEdge& edge = edges.edges[e];
      const auto at = edges.trianglesAt(e);
      open += edge.triangleCount != 2;
      turned += edge.triangleCount == 2 && runsAlong(made.triangles[at.begin()[0]], edge.v0, edge.v1) ==
                                             runsAlong(made.triangles[at.begin()[1]], edge.v0, edge.v1);
    }
    EXPECT_EQ(open, 0);
    EXPECT_EQ(turned, 0);
    const std::size_t before = crossingFaces(a, {}).size() + crossingFaces(b, {}).size();
    EXPECT_LE(crossingFaces(made, {}).size(), before);
    std::set<std::array<double, 3>> points;
    for (const Vector3& p : made.points)
    {
      points.insert(keyOf(p));
    }
    expectKept(a, b, points);
    expectKept(b, a, points);
    if (const auto truth = truthOf(a, b))
    {
      ++compared;
      EXPECT_NEAR(volumeOf(made), truth->volume, 0.005 * truth->volume);
      const int euler = made.vertexCount() - static_cast<int>(edges.edges.size()) + made.triangleCount();
      if (pairs[i].touches) // CGAL joins none, or in a point; ours do meet
      {
        EXPECT_EQ(euler, 2);
      }
      else
      {
        EXPECT_EQ(euler, truth->euler);
      }
    }
  }
  std::cout << joined << " joined, " << refused << " refused, " << compared << " beside CGAL" << std::endl;
  EXPECT_LE(refused, full ? 6 : 1);
  EXPECT_GE(joined, full ? 40 : 3);
}

} // namespace
