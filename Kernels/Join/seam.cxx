#include "Join/seam.h"

#include "Join/slivers.h"
#include "Mesh/nearest.h"
#include "Relax/relax.h"
#include "Remesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace oversketch
{

namespace
{

constexpr double degrees = 180.0 / 3.14159265358979323846;
constexpr double sharp = 50.0;    // [degrees] edges of the parts that remeshing keeps
constexpr double smooth = 11.0;   // [degrees] that edges of the seam are to bend by at most
constexpr double triangles = 8.0; // over the width
constexpr int mostRounds = 2;
constexpr double mostSharp = 0.002; // of the seam's edges, by noise of the parts

// A mesh whose triangles are of parts.
struct Parted
{
  const Mesh& mesh;
  const Adjacency& adjacency;
  const std::vector<int>& parts; // per triangle
};

bool isCrease(const Parted& of, int edge)
{
  const auto at = of.adjacency.trianglesAt(edge);
  return at.end() - at.begin() == 2 && of.parts[at.begin()[0]] != of.parts[at.begin()[1]];
}

double bend(const Mesh& mesh, const Adjacency& adjacency, int edge)
{
  const auto at = adjacency.trianglesAt(edge);
  const Vector3 a = facetNormal(mesh, at.begin()[0]), b = facetNormal(mesh, at.begin()[1]);
  return degrees * std::atan2(a.cross(b).norm(), a.dot(b));
}

// How far vertices are from the crease, by ways over the surface straight to the nearest piece of it;
// infinity beyond the limit.
std::vector<double> distancesToCrease(const Parted& of, double limit)
{
  const auto& edges = of.adjacency.edges;
  std::vector<double> distance(of.mesh.points.size(), std::numeric_limits<double>::infinity());
  std::vector<int> nearest(distance.size(), -1); // crease edge
  std::vector<std::vector<int>> creasesAt(distance.size());
  using Entry = std::tuple<double, int, int>; // distance, vertex, edge
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (int e = 0; e < static_cast<int>(edges.size()); ++e)
  {
    if (isCrease(of, e))
    {
      creasesAt[edges[e].v0].push_back(e);
      creasesAt[edges[e].v1].push_back(e);
      queue.emplace(0.0, edges[e].v0, e);
      queue.emplace(0.0, edges[e].v1, e);
    }
  }
  while (!queue.empty())
  {
    const auto [way, v, e] = queue.top();
    queue.pop();
    if (nearest[v] >= 0)
    {
      continue;
    }
    nearest[v] = e;
    distance[v] = way;
    for (const int n : of.adjacency.vertexVertices[v])
    {
      if (nearest[n] >= 0)
      {
        continue;
      }
      Entry best{ limit, n, -1 };
      const auto consider = [&](int edge)
      {
        const Vector3 &a = of.mesh.points[edges[edge].v0], &b = of.mesh.points[edges[edge].v1];
        best = std::min(best, Entry{ distanceToSegment(of.mesh.points[n], a, b), n, edge });
      };
      for (const int end : { edges[e].v0, edges[e].v1 })
      {
        for (const int edge : creasesAt[end])
        {
          consider(edge);
        }
      }
      if (std::get<2>(best) >= 0)
      {
        queue.push(best);
      }
    }
  }
  return distance;
}

// Asks that of each part something is left beyond the seam.
void requireRoom(const Parted& of, const std::vector<double>& distance, double width)
{
  const int count = 1 + *std::max_element(of.parts.begin(), of.parts.end());
  std::vector<char> there(static_cast<std::size_t>(std::max(0, count)), 0), beyond(there);
  for (std::size_t t = 0; t < of.parts.size(); ++t)
  {
    if (of.parts[t] == bridgePart)
    {
      continue;
    }
    there[of.parts[t]] = 1;
    for (const int v : of.mesh.triangles[t])
    {
      beyond[of.parts[t]] |= distance[v] >= width / 2.0;
    }
  }
  for (int part = 0; part < count; ++part)
  {
    if (there[part] && !beyond[part])
    {
      const std::vector<double> all = distancesToCrease(of, std::numeric_limits<double>::infinity());
      double most = 0.0;
      for (std::size_t t = 0; t < of.parts.size(); ++t)
      {
        for (const int v : of.mesh.triangles[t])
        {
          most = of.parts[t] == part && std::isfinite(all[v]) ? std::max(most, all[v]) : most;
        }
      }
      throw Error(Failure::BadRegion,
        "A seam %1 wide reaches all over what is left of part %2; give a width below %3, or move the parts.",
        width,
        part + 1,
        2.0 * most);
    }
  }
}

// The mean edge of the input's triangles round each vertex.
std::vector<double> ownLengths(const JoinInput& input, const Mesh& mesh, const std::vector<int>& source)
{
  std::vector<double> sum(mesh.points.size(), 0.0), count(mesh.points.size(), 0.0);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& of = input.mesh.triangles[source[t]];
    double length = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      length += (input.mesh.points[of[(k + 1) % 3]] - input.mesh.points[of[k]]).norm() / 3.0;
    }
    for (const int v : mesh.triangles[t])
    {
      sum[v] += length;
      count[v] += 1.0;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
  {
    sum[v] /= std::max(1.0, count[v]);
  }
  return sum;
}

// Lays the thin plate over the free vertices; the others stay. At sharp ones of those the surface need not go
// on as beyond: there is no one way in which it does.
void fair(Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& free,
  const std::vector<char>& isSharp,
  double width,
  const Context& context)
{
  // The ring round them is solved for with a weight that holds it: it says how the surface goes on.
  std::vector<char> region = free;
  for (const int v : marked(free))
  {
    for (const int n : adjacency.vertexVertices[v])
    {
      region[n] = 1;
    }
  }
  RelaxBand band{ MeshPart(mesh, region, context), {}, {}, {}, false };
  for (const int v : band.part.vertices)
  {
    band.share.push_back(free[v] ? 1.0 : 0.0);
    band.weight.push_back(free[v] ? 0.0 : 1e9);
    band.scale.push_back(isSharp[v] && !free[v] ? 0.0 : width / 2.0);
  }
  const std::vector<Vector3> places = relaxed(band, context);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (free[band.part.vertices[i]])
    {
      mesh.points[band.part.vertices[i]] = places[i];
    }
  }
}

// A place on a body as one on what it was made of.
SurfacePoint placeOn(const Body& body, const SurfacePoint& at)
{
  const Vector3 w = body.weightsAt(at.triangle, { at.weights[0], at.weights[1], at.weights[2] });
  return { body.source[at.triangle], { w[0], w[1], w[2] } };
}

} // namespace

Joined asJoined(United united)
{
  const Body& body = united.body;
  Joined joined;
  joined.corners.resize(body.weights.size());
  for (int t = 0; t < body.mesh.triangleCount(); ++t)
  {
    for (int k = 0; k < 3 && !body.isWhole(t); ++k)
    {
      joined.corners[body.cut[t]][k] = placeOn(body, wholeTriangle(t)[k]);
    }
  }
  joined.mesh = std::move(united.body.mesh);
  joined.source = std::move(united.body.source);
  joined.cut = std::move(united.body.cut);
  return joined;
}

Joined roundSeam(const JoinInput& input, const United& creased, double width, const Context& context)
{
  United united = creased;
  double finest = width / triangles;
  const auto lengthsOf = [&](const Mesh& mesh, const std::vector<int>& source)
  {
    std::vector<double> lengths = ownLengths(input, mesh, source);
    for (double& length : lengths)
    {
      length = std::min(length, finest);
    }
    return lengths;
  };
  coarsenCrease(united, lengthsOf(united.body.mesh, united.body.source));
  const Body& body = united.body;
  const Adjacency adjacency = buildAdjacency(body.mesh, context);
  const Parted whole{ body.mesh, adjacency, body.part };
  const std::vector<double> distance = distancesToCrease(whole, width / 2.0);
  requireRoom(whole, distance, width);

  // Triangles with a corner in the seam are divided; corners beyond stay.
  std::vector<char> region(body.mesh.points.size(), 0);
  for (const Triangle& t : body.mesh.triangles)
  {
    if (distance[t[0]] < width / 2.0 || distance[t[1]] < width / 2.0 || distance[t[2]] < width / 2.0)
    {
      region[t[0]] = region[t[1]] = region[t[2]] = 1;
    }
  }
  std::vector<Binding> held;
  for (const int v : marked(region))
  {
    if (distance[v] >= width / 2.0)
    {
      held.push_back(Binding::vertex(v));
    }
  }
  const std::vector<int> charts = valuesAt(input.charts, body.source);
  Joined joined;
  for (;; ++joined.rounds)
  {
    RemeshInput remeshing{ body.mesh, region, lengthsOf(body.mesh, body.source), charts, held };
    RemeshResult made = remesh(remeshing, context);
    joined.source.clear();
    joined.cut.clear();
    joined.corners.clear();
    std::vector<int> parts;
    for (int t = 0; t < made.mesh.triangleCount(); ++t)
    {
      const int of = made.triangleSource[t];
      const bool isWhole = t < made.outsideTriangles && body.isWhole(of);
      joined.source.push_back(body.source[of]);
      joined.cut.push_back(isWhole ? -1 : static_cast<int>(joined.corners.size()));
      parts.push_back(body.part[of]);
      if (!isWhole)
      {
        const std::array<SurfacePoint, 3> at = made.corners(t);
        joined.corners.push_back({ placeOn(body, at[0]), placeOn(body, at[1]), placeOn(body, at[2]) });
      }
    }
    joined.mesh = std::move(made.mesh);
    const Adjacency now = buildAdjacency(joined.mesh, context);
    const Parted parted{ joined.mesh, now, parts };
    const std::vector<double> ways = distancesToCrease(parted, width / 2.0);
    std::vector<char> free(ways.size()), isSharp(ways.size(), 0), isRough(ways.size(), 0);
    for (std::size_t v = 0; v < ways.size(); ++v)
    {
      free[v] = ways[v] < width / 2.0;
    }
    for (int e = 0; e < static_cast<int>(now.edges.size()); ++e)
    {
      const MeshEdge& edge = now.edges[e];
      const double bends = isCrease(parted, e) ? 0.0 : bend(joined.mesh, now, e);
      isSharp[edge.v0] |= bends > sharp;
      isSharp[edge.v1] |= bends > sharp;
      isRough[edge.v0] |= bends > smooth;
      isRough[edge.v1] |= bends > smooth;
    }
    fair(joined.mesh, now, free, isSharp, width, context);
    const double before = joined.rounds == 0 ? 180.0 : joined.sharpest;
    joined.sharpest = 0.0;
    int edges = 0, sharpEdges = 0;
    for (int e = 0; e < static_cast<int>(now.edges.size()); ++e)
    {
      const MeshEdge& edge = now.edges[e];
      if ((free[edge.v0] || free[edge.v1]) && !isRough[edge.v0] && !isRough[edge.v1])
      {
        const double bends = bend(joined.mesh, now, e);
        joined.sharpest = std::max(joined.sharpest, bends);
        ++edges;
        sharpEdges += bends > smooth;
      }
    }
    if (sharpEdges <= mostSharp * edges || joined.sharpest > 0.95 * before || joined.rounds == mostRounds)
    {
      return joined;
    }
    finest *= std::clamp(0.95 * smooth / joined.sharpest, 0.5, 0.7);
  }
}

} // namespace oversketch
