#include "Region/enclose.h"

#include "Mesh/disc.h"
#include "Region/grow.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace oversketch
{
namespace
{

constexpr double largestShare = 0.8; // of the area of the part of the mesh that a region lies on

// The edges of the boundary.
std::vector<char> walls(const Adjacency& adjacency, const std::vector<int>& boundary)
{
  if (boundary.size() < 4 || boundary.front() != boundary.back())
  {
    throw Error(Failure::BadStroke,
      "{The boundary curve} is not closed round at least one face: draw it back to where it began.");
  }
  std::vector<char> wall(adjacency.edges.size(), 0);
  for (std::size_t i = 0; i + 1 < boundary.size(); ++i)
  {
    const int edge = adjacency.findEdge(boundary[i], boundary[i + 1]);
    if (edge < 0)
    {
      throw Error(Failure::BadStroke,
        "{The boundary curve} leaves the edges of the mesh between its vertices %1 and %2, where the region "
        "would leak out: insert it with its segments as edges.",
        boundary[i],
        boundary[i + 1]);
    }
    wall[edge] = 1;
  }
  return wall;
}

// A face at the middle of the reference curve.
int seedOf(const Mesh& mesh, const Adjacency& adjacency, const std::vector<int>& reference)
{
  if (reference.size() < 2)
  {
    throw Error(Failure::BadStroke, "{The reference curve} has fewer than two vertices: draw a longer one.");
  }
  std::vector<double> lengths{ 0.0 };
  for (std::size_t i = 1; i < reference.size(); ++i)
  {
    lengths.push_back(lengths.back() + (mesh.points[reference[i]] - mesh.points[reference[i - 1]]).norm());
  }
  const double half = 0.5 * lengths.back();
  const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, half);
  const std::size_t i = static_cast<std::size_t>(next - lengths.begin());
  const int a = reference[i - 1], b = reference[i];
  const int edge = adjacency.findEdge(a, b);
  if (edge >= 0)
  {
    return *adjacency.trianglesBegin(edge);
  }
  const int nearer = half - lengths[i - 1] <= lengths[i] - half ? a : b;
  if (adjacency.vertexTriangles.size(nearer) == 0)
  {
    throw Error(Failure::BadStroke,
      "Vertex %1 of {the reference curve} is at no face of the mesh: draw the curve anew on this mesh.",
      nearer);
  }
  return *adjacency.vertexTriangles.begin(nearer);
}

void grow(const Adjacency& adjacency,
  const std::vector<char>& wall,
  int seed,
  std::vector<char>& faces,
  const Context& context)
{
  constexpr std::size_t checkEvery = 65536; // faces between two looks at whether to stop
  std::vector<int> front{ seed };
  faces[seed] = 2;
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    if (i % checkEvery == 0)
    {
      context.checkpoint(static_cast<double>(i) / static_cast<double>(faces.size()));
    }
    for (const int edge : adjacency.triangleEdges[front[i]])
    {
      if (edge < 0 || wall[edge])
      {
        continue;
      }
      for (const int t : adjacency.trianglesAt(edge))
      {
        if (faces[t] == 0)
        {
          faces[t] = 2;
          front.push_back(t);
        }
      }
    }
  }
}

void requireInside(const std::vector<int>& reference, const Enclosed& enclosed)
{
  for (std::size_t i = 0; i < reference.size(); ++i)
  {
    if (enclosed.vertices[reference[i]] != 2)
    {
      throw Error(Failure::BadRegion,
        "{The reference curve} is not all inside {the boundary}: its point %1, vertex %2 of the mesh, lies "
        "on "
        "{the boundary} or beyond; draw {the boundary} round the whole reference curve.",
        i,
        reference[i]);
    }
  }
}

// Whether there is so much area next to the region, over edges. faces: as Enclosed has them.
bool hasNextToIt(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& faces,
  int seed,
  double area)
{
  std::vector<char> reached(faces.size(), 0);
  std::vector<int> front{ seed };
  reached[seed] = 1;
  double found = 0.0;
  for (std::size_t i = 0; i < front.size() && !(found >= area); ++i)
  {
    for (const int edge : adjacency.triangleEdges[front[i]])
    {
      for (const int t : edge < 0 ? Lists::Range() : adjacency.trianglesAt(edge))
      {
        if (reached[t] == 0)
        {
          found += faces[t] == 2 ? 0.0 : facetArea(mesh, t);
          reached[t] = 1;
          front.push_back(t);
        }
      }
    }
  }
  return found >= area;
}

void requireRoomOutside(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& faces,
  const Mesh& inside,
  int seed)
{
  const std::vector<double> areas = vertexAreas(inside);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  // A small region shows it without a look at the whole mesh.
  if (area > 0.0 && std::isfinite(area) &&
      hasNextToIt(mesh, adjacency, faces, seed, 1.01 * area * (1.0 - largestShare) / largestShare))
  {
    return;
  }
  const MeshParts parts = findParts(mesh, adjacency);
  const double share = area / parts.partAreas[parts.of[mesh.triangles[seed][0]]];
  if (!(share <= largestShare))
  {
    const int percent = std::isfinite(share) ? static_cast<int>(std::lround(100.0 * share)) : 100;
    throw Error(Failure::BadRegion,
      "The region takes %1 % of the surface that it lies on, over 80 %, so nothing would hold it: draw a "
      "smaller boundary, one that closes round {the reference curve}.",
      percent);
  }
}

} // namespace

Enclosed enclose(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& reference,
  const std::vector<int>& boundary,
  const Context& context)
{
  const std::vector<char> wall = walls(adjacency, boundary);
  const int seed = seedOf(mesh, adjacency, reference);
  Enclosed enclosed;
  enclosed.faces.assign(mesh.triangles.size(), 0);
  grow(adjacency, wall, seed, enclosed.faces, context);

  enclosed.vertices.assign(mesh.points.size(), 0);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int k = 0; enclosed.faces[t] == 2 && k < 3; ++k)
    {
      enclosed.vertices[mesh.triangles[t][k]] = 2;
    }
  }
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangles[t];
    const bool beside = std::any_of(c.begin(), c.end(), [&](int v) { return enclosed.vertices[v] == 2; });
    enclosed.faces[t] = enclosed.faces[t] == 0 && beside ? 1 : enclosed.faces[t];
  }
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int k = 0; enclosed.faces[t] == 1 && k < 3; ++k)
    {
      enclosed.vertices[mesh.triangles[t][k]] = 1;
    }
  }
  for (const int v : boundary)
  {
    enclosed.vertices[v] = 1;
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    enclosed.vertices[v] = enclosed.vertices[v] == 2 && adjacency.borderVertex[v] ? 1 : enclosed.vertices[v];
  }

  requireInside(reference, enclosed);
  const Mesh inside = extractFaces(mesh, enclosed.faces, 2).mesh;
  requireRoomOutside(mesh, adjacency, enclosed.faces, inside, seed);
  discBorder(inside, buildAdjacency(inside, context));
  return enclosed;
}

Extract extractFaces(const Mesh& mesh, const std::vector<char>& flags, char least)
{
  Extract extract;
  std::vector<int> number(mesh.points.size(), -1);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    if (flags[t] >= least)
    {
      extract.triangles.push_back(t);
      for (const int v : mesh.triangles[t])
      {
        number[v] = 0;
      }
    }
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (number[v] == 0)
    {
      number[v] = extract.mesh.vertexCount();
      extract.mesh.points.push_back(mesh.points[v]);
      extract.vertices.push_back(v);
    }
  }
  for (const int t : extract.triangles)
  {
    const Triangle& c = mesh.triangles[t];
    extract.mesh.triangles.push_back({ number[c[0]], number[c[1]], number[c[2]] });
  }
  return extract;
}

} // namespace oversketch
