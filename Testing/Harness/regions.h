// Meshes with a region round a reference curve, and the arrays that a region's filters make. Header-only.
#ifndef oversketch_testing_harness_regions_h
#define oversketch_testing_harness_regions_h

#include "Harness/edges.h"
#include "Mesh/context.h"
#include "Shading/fields.h"
#include "Shading/flatten.h"
#include "Shading/layers.h"

#include <random>
#include <vector>

namespace oversketch_test
{

struct EditScene
{
  Mesh mesh;
  std::vector<int> reference, boundary; // chains of vertices, the second one closed, its first not repeated
  std::vector<int> region;              // EditRegion: 2 inside, 1 on the boundary or beside it, 0 elsewhere
  std::vector<double> distance, parameter, side,
    weight; // CurveDistance, CurveParameter, CurveSide, EditWeight

  double meanEdge() const
  {
    double sum = 0.0;
    int count = 0;
    for (const MeshEdge& e : buildAdjacency(this->mesh).edges)
    {
      if (this->region[e.v0] == 2 || this->region[e.v1] == 2)
      {
        sum += (this->mesh.points[e.v0] - this->mesh.points[e.v1]).norm();
        ++count;
      }
    }
    return sum / count;
  }
};

// On which side of a chain a point lies: 1 to the left of its way, seen from outside.
inline double sideOf(const Mesh& mesh,
  const std::vector<int>& chain,
  const std::vector<Vector3>& normals,
  const Vector3& point)
{
  double least = std::numeric_limits<double>::infinity(), side = 1.0;
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    const Vector3 from = mesh.points[chain[i - 1]], step = mesh.points[chain[i]] - from;
    const double share = std::clamp((point - from).dot(step) / step.squaredNorm(), 0.0, 1.0);
    const Vector3 way = point - from - share * step;
    if (way.squaredNorm() < least)
    {
      least = way.squaredNorm();
      side = way.dot((normals[chain[i - 1]] + normals[chain[i]]).cross(step)) < 0.0 ? -1.0 : 1.0;
    }
  }
  return side;
}

// inside: of each vertex, whether it is within the boundary or on it; the faces of three such are the region.
inline EditScene editScene(const Mesh& mesh,
  const std::vector<char>& inside,
  const std::vector<int>& reference)
{
  EditScene scene;
  scene.mesh = mesh;
  scene.reference = reference;
  Mesh patch;
  std::vector<int> number(mesh.points.size(), -1), back;
  for (const Triangle& t : mesh.triangles)
  {
    if (inside[t[0]] && inside[t[1]] && inside[t[2]])
    {
      Triangle& mine = patch.triangles.emplace_back();
      for (int k = 0; k < 3; ++k)
      {
        if (number[t[k]] < 0)
        {
          number[t[k]] = patch.vertexCount();
          patch.points.push_back(mesh.points[t[k]]);
          back.push_back(t[k]);
        }
        mine[k] = number[t[k]];
      }
    }
  }
  std::vector<int> chain;
  chain.reserve(reference.size());
  for (const int v : reference)
  {
    chain.push_back(number[v]);
  }
  const CurveFields fields = curveFields(patch, chain, {}, {});
  const std::vector<Vector3> normals = vertexNormals(mesh);
  const Layers layers;
  scene.region.assign(mesh.points.size(), 0);
  scene.distance.assign(mesh.points.size(), 1.0);
  scene.parameter.assign(mesh.points.size(), 0.0);
  scene.side.assign(mesh.points.size(), 1.0);
  scene.weight.assign(mesh.points.size(), 0.0);
  for (const int v : discBorder(patch, buildAdjacency(patch)))
  {
    scene.boundary.push_back(back[v]);
  }
  for (const Triangle& t : mesh.triangles)
  {
    if (number[t[0]] >= 0 || number[t[1]] >= 0 || number[t[2]] >= 0)
    {
      scene.region[t[0]] = scene.region[t[1]] = scene.region[t[2]] = 1;
    }
  }
  for (int v = 0; v < patch.vertexCount(); ++v)
  {
    const int at = back[v];
    scene.region[at] = 2;
    scene.distance[at] = fields.share[v];
    scene.parameter[at] = fields.parameter[v];
    scene.side[at] = sideOf(mesh, reference, normals, mesh.points[at]);
    scene.weight[at] = layers.weight(fields.share[v]);
  }
  for (const int v : scene.boundary)
  {
    scene.region[v] = 1;
    scene.weight[v] = 0.0;
  }
  return scene;
}

// The unit sphere in rings and sectors round the z axis, the boundary on the ring at 60 degrees from the pole
// (z = 0.5) or where `reach` of the angle round the axis has it, as a share of that; the reference curve in y
// = 0 over the pole, from -x to +x, as far as 45 degrees on either side. uneven: vertices off the curves are
// moved within the surface by so much of a ring's distance.
inline EditScene sphereScene(
  int rings,
  int sectors,
  double uneven = 0.0,
  const std::function<double(double)>& reach = [](double) { return 1.0; })
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  const auto clean = [](double x) { return std::abs(x) < 1e-15 ? 0.0 : x; }; // in planes of symmetry
  Mesh mesh;
  mesh.points.emplace_back(0.0, 0.0, 1.0);
  std::vector<char> inside{ 1 };
  const int all = 3 * rings;
  for (int r = 1; r < all; ++r)
  {
    for (int s = 0; s < sectors; ++s)
    {
      // The boundary's share fades to the south.
      const double round = 2.0 * pi * s / sectors, share = std::min(1.0, (all - r) / (2.0 * rings));
      double down = pi / 3.0 * r / rings * (1.0 + share * (reach(round) - 1.0)), turn = round;
      const bool held = r == rings || s == 0 || s == sectors / 2;
      if (!held && uneven > 0.0)
      {
        const double step = uneven * std::min(pi / (3.0 * rings), 2.0 * pi / sectors * std::sin(down));
        down += step * value(random);
        turn += step / std::sin(down) * value(random);
      }
      mesh.points.emplace_back(
        clean(std::sin(down) * std::cos(turn)), clean(std::sin(down) * std::sin(turn)), std::cos(down));
      inside.push_back(r <= rings);
    }
  }
  mesh.points.emplace_back(0.0, 0.0, -1.0);
  inside.push_back(0);
  const Rings net{ all, sectors };
  mesh.triangles = net.triangles();
  return editScene(mesh, inside, net.overPole(rings * 3 / 4));
}

// A hill of side x side quads over [-1, 1]^2, bent so that the reference curve, along its middle, is an S.
inline EditScene letterScene(int side)
{
  Mesh mesh = gridSurface(side,
    side,
    false,
    false,
    [](double u, double v)
    {
      const double x = 2.0 * u - 1.0, y = 2.0 * v - 1.0 + 0.3 * std::sin(2.0 * pi * u);
      return Vector3(x, y, 0.5 * std::exp(-2.0 * (x * x + y * y)));
    });
  std::vector<char> inside;
  std::vector<int> reference;
  const int margin = side / 10, end = side / 4;
  for (int j = 0; j <= side; ++j)
  {
    for (int i = 0; i <= side; ++i)
    {
      inside.push_back(std::min({ i, j, side - i, side - j }) >= margin);
      if (j == side / 2 && i >= end && i <= side - end)
      {
        reference.push_back(static_cast<int>(inside.size()) - 1);
      }
    }
  }
  return editScene(mesh, inside, reference);
}

// A mesh's shortest path along its edges between the vertices nearest to two places, and the region within so
// far of it.
inline EditScene pathScene(const Mesh& mesh, const Vector3& from, const Vector3& to, double reach)
{
  const std::vector<int> chain = edgeWay(mesh, nearestVertex(mesh, from), nearestVertex(mesh, to));
  const std::vector<double> distance = edgeDistances(mesh, buildAdjacency(mesh), chain, reach);
  std::vector<char> inside;
  inside.reserve(distance.size());
  for (const double d : distance)
  {
    inside.push_back(d <= reach ? 1 : 0);
  }
  return editScene(mesh, inside, chain);
}

} // namespace oversketch_test
#endif
