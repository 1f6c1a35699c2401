#include "Print/print_check.h"

#include "Intersection/crossing_faces.h"
#include "Mesh/weld.h"
#include "Ray/surface_rays.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace oversketch
{

namespace
{

// Points that are joined, a number for each group: that of one of them.
using Groups = boost::disjoint_sets_with_storage<>;

void checkEdges(const Mesh& mesh, const Adjacency& adjacency, PrintCheck& check)
{
  Groups rims(mesh.points.size());
  for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
  {
    const MeshEdge& edge = adjacency.edges[e];
    const int* around = adjacency.trianglesBegin(e);
    const auto forward = [&](int t) { return runsAlong(mesh.triangles[t], edge.v0, edge.v1); };
    std::uint8_t fault = 0;
    if (edge.triangleCount == 1)
    {
      fault = OpenFault;
      ++check.openEdges;
      rims.union_set(edge.v0, edge.v1);
    }
    else if (edge.triangleCount > 2)
    {
      fault = CrowdedFault;
      ++check.crowdedEdges;
    }
    else if (forward(around[0]) == forward(around[1]))
    {
      fault = TurnedFault;
      ++check.turnedEdges;
    }
    for (const int t : adjacency.trianglesAt(e))
    {
      check.faults[t] |= fault;
    }
  }
  std::vector<double> lengths(mesh.points.size(), 0.0);             // of holes
  std::vector<Vector3> places(mesh.points.size(), Vector3::Zero()); // times lengths
  for (const MeshEdge& edge : adjacency.edges)
  {
    if (edge.triangleCount == 1)
    {
      const Vector3 &a = mesh.points[edge.v0], &b = mesh.points[edge.v1];
      const std::size_t hole = rims.find_set(edge.v0);
      check.holes += lengths[hole] == 0.0;
      lengths[hole] += (b - a).norm();
      places[hole] += 0.5 * (b - a).norm() * (a + b);
    }
  }
  if (check.holes > 0)
  {
    const auto longest = std::max_element(lengths.begin(), lengths.end());
    check.holeLength = *longest;
    check.holePlace = places[longest - lengths.begin()] / *longest;
  }
}

// The body of each face; -1 for one that counts as none.
std::vector<int> findBodies(const Mesh& mesh, const Adjacency& adjacency, PrintCheck& check)
{
  Groups joined(mesh.points.size());
  for (const MeshEdge& edge : adjacency.edges)
  {
    joined.union_set(edge.v0, edge.v1);
  }
  std::vector<int> bodies(mesh.triangles.size(), -1), numbers(mesh.points.size(), -1);
  std::vector<Vector3> origins; // so that volumes far from the origin are exact
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    if (adjacency.triangleEdges[t][0] < 0)
    {
      continue;
    }
    const Triangle& corners = mesh.triangles[t];
    int& number = numbers[joined.find_set(corners[0])];
    if (number < 0)
    {
      number = static_cast<int>(check.bodies.size());
      check.bodies.emplace_back();
      origins.push_back(mesh.points[corners[0]]);
    }
    bodies[t] = number;
    PrintBody& body = check.bodies[number];
    const Vector3& origin = origins[number];
    ++body.faces;
    body.isOpen |= (check.faults[t] & OpenFault) != 0;
    body.volume += (mesh.points[corners[0]] - origin)
                     .dot((mesh.points[corners[1]] - origin).cross(mesh.points[corners[2]] - origin)) /
                   6.0;
  }
  return bodies;
}

// Source: Jacobson, Kavan and Sorkine-Hornung, "Robust Inside-Outside Segmentation using Generalized Winding
// Numbers" (2013), eq. 5 and 6: how often the faces of other bodies go round a point.
double windingRound(const Vector3& point, const Mesh& mesh, const std::vector<int>& bodies, int butBody)
{
  double sum = 0.0;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    if (bodies[t] >= 0 && bodies[t] != butBody)
    {
      const Triangle& corners = mesh.triangles[t];
      const Vector3 a = mesh.points[corners[0]] - point, b = mesh.points[corners[1]] - point,
                    c = mesh.points[corners[2]] - point;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
  }
  return sum / (2.0 * static_cast<double>(EIGEN_PI));
}

// Tells hollows from bodies that are inside out.
void judgeBodies(const Mesh& mesh, const std::vector<int>& bodies, PrintCheck& check, const Context& context)
{
  std::vector<int> first(check.bodies.size(), -1), negative;
  for (int t = mesh.triangleCount() - 1; t >= 0; --t)
  {
    if (bodies[t] >= 0)
    {
      first[bodies[t]] = t;
    }
  }
  for (int i = 0; i < static_cast<int>(check.bodies.size()); ++i)
  {
    if (check.bodies[i].volume < 0.0 && !check.bodies[i].isOpen)
    {
      negative.push_back(i);
    }
  }
  context.eachUntilCancelled(static_cast<int>(negative.size()),
    [&](int i)
    {
      PrintBody& body = check.bodies[negative[i]];
      const Vector3& point = mesh.points[mesh.triangles[first[negative[i]]][0]];
      body.isHollow = windingRound(point, mesh, bodies, negative[i]) > 0.5;
      body.isInsideOut = !body.isHollow;
    });
  for (const PrintBody& body : check.bodies)
  {
    check.hollows += body.isHollow;
    check.insideOut += body.isInsideOut;
    check.volume += body.volume;
  }
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    if (bodies[t] >= 0 && check.bodies[bodies[t]].isInsideOut)
    {
      check.faults[t] |= InsideOutFault;
    }
  }
}

void measureWalls(const std::shared_ptr<const Mesh>& mesh,
  const std::vector<int>& bodies,
  PrintCheck& check,
  const Context& context,
  const Context& silent)
{
  const SurfaceRays surface(mesh, silent);
  context.checkpoint(0.6);
  const double nothing = 1e-12 * surface.diagonal(); // how far a sheet of no thickness is off
  const auto bounds = [&](int own, int other)
  { return other >= 0 && (other == own || check.bodies[own].isHollow || check.bodies[other].isHollow); };
  const auto measure = [&](int t)
  {
    const Triangle& corners = mesh->triangles[t];
    const Vector3 inward = -facetNormal(*mesh, t);
    if (bodies[t] < 0 || inward.isZero())
    {
      return;
    }
    const Vector3 middle =
      (mesh->points[corners[0]] + mesh->points[corners[1]] + mesh->points[corners[2]]) / 3.0;
    for (const SurfaceHit& hit : surface.all({ middle, inward }))
    {
      if (hit.distance >= -nothing && bounds(bodies[t], bodies[hit.at.triangle]) &&
          facetNormal(*mesh, hit.at.triangle).dot(inward) > 0.0)
      {
        check.walls[t] = hit.distance > nothing ? hit.distance : 0.0;
        return;
      }
    }
  };
  constexpr int block = 100000; // faces between two looks for a cancel
  for (int begin = 0; begin < mesh->triangleCount(); begin += block)
  {
    context.each(std::min(block, mesh->triangleCount() - begin), [&](int i) { measure(begin + i); });
    context.checkpoint(0.6 + 0.4 * std::min(1.0, (begin + block) / double(mesh->triangleCount())));
  }
  for (const double wall : check.walls)
  {
    const bool isLess = wall >= 0.0 && (check.leastWall < 0.0 || wall < check.leastWall);
    check.leastWall = isLess ? wall : check.leastWall;
  }
}

} // namespace

PrintCheck checkPrint(const Mesh& given, const Context& context)
{
  Context silent = context; // of parts that would begin again
  silent.progress = [](double) {};
  const std::vector<int> vertices = weldPoints(given.points);
  const auto mesh = std::make_shared<const Mesh>(vertices.empty() ? given : weldedMesh(given, vertices));
  const Adjacency adjacency = buildAdjacency(*mesh, silent);
  PrintCheck check;
  check.faults.assign(mesh->triangles.size(), 0);
  check.walls.assign(mesh->triangles.size(), -1.0);
  Eigen::AlignedBox3d box;
  for (int t = 0; t < mesh->triangleCount(); ++t)
  {
    check.areas.push_back(facetArea(*mesh, t));
    for (const int v : mesh->triangles[t])
    {
      box.extend(mesh->points[v]);
    }
  }
  if (box.isEmpty())
  {
    return check;
  }
  check.size = box.sizes();
  checkEdges(*mesh, adjacency, check);
  const std::vector<int> bodies = findBodies(*mesh, adjacency, check);
  judgeBodies(*mesh, bodies, check, context);
  context.checkpoint(0.2);
  const std::vector<FacePair> pairs = crossingFaces(*mesh, {}, silent);
  context.checkpoint(0.4);
  check.crossings = static_cast<int>(pairs.size());
  for (const FacePair& pair : pairs)
  {
    check.faults[pair[0]] |= CrossingFault;
    check.faults[pair[1]] |= CrossingFault;
  }
  measureWalls(mesh, bodies, check, context, silent);
  return check;
}

double PrintCheck::thinArea(double wall) const
{
  double sum = 0.0;
  for (std::size_t t = 0; t < this->walls.size(); ++t)
  {
    const double thick = this->walls[t];
    sum += thick == 0.0 || (thick > 0.0 && thick < wall) ? this->areas[t] : 0.0;
  }
  return sum;
}

bool PrintCheck::isReady(double wall) const
{
  return !this->bodies.empty() && this->thinArea(wall) == 0.0 &&
         std::all_of(this->faults.begin(), this->faults.end(), [](std::uint8_t bits) { return bits == 0; });
}

} // namespace oversketch
