#include "Remesh/limb_runs.h"

#include <algorithm>

namespace oversketch
{

namespace
{

constexpr std::size_t mostCorners = 256; // of the ring as it is looked at

std::vector<Vector2> coarsened(const std::vector<Vector2>& ring)
{
  const std::size_t step = ring.size() / mostCorners + 1;
  std::vector<Vector2> corners;
  for (std::size_t i = 0; i < ring.size(); i += step)
  {
    corners.push_back(ring[i]);
  }
  return corners;
}

// Whether a line from a place to the right crosses a closed polygon an odd number of times.
bool isInside(const std::vector<Vector2>& polygon, const Vector2& p)
{
  bool inside = false;
  for (std::size_t i = 0, before = polygon.size() - 1; i < polygon.size(); before = i++)
  {
    const Vector2 &a = polygon[i], &b = polygon[before];
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
    {
      inside = !inside;
    }
  }
  return inside;
}

constexpr double mostLeap = 1.5; // lengths of a run, to those before and after together
constexpr double edgeOn = 0.02;  // cosine between normal and view, under which a vertex faces nobody

// How long a run is, and how far two of a ring are apart.
double lengthOf(const RunOnMesh& run)
{
  double length = 0.0;
  for (std::size_t i = 1; i < run.points.size(); ++i)
  {
    length += (run.points[i] - run.points[i - 1]).norm();
  }
  return length;
}

double leapOf(const RunOnMesh& from, const RunOnMesh& to)
{
  return (to.points.front() - from.points.back()).norm();
}

// Vertices that the seeds reach over edges whose vertices all pass, a flag for each of the mesh.
template <class Passes>
std::vector<char> reachedFrom(const std::vector<int>& seeds,
  const Mesh& mesh,
  const Lists& vertexVertices,
  const Passes& passes)
{
  std::vector<char> reached(mesh.points.size(), 0);
  std::vector<int> open;
  const auto reach = [&](int v)
  {
    if (!reached[v] && passes(v))
    {
      reached[v] = 1;
      open.push_back(v);
    }
  };
  for (const int t : seeds)
  {
    std::for_each(mesh.triangles[t].begin(), mesh.triangles[t].end(), reach);
  }
  while (!open.empty())
  {
    const int v = open.back();
    open.pop_back();
    std::for_each(vertexVertices.begin(v), vertexVertices.end(v), reach);
  }
  return reached;
}

} // namespace

std::vector<char> runsOnLimb(const Mesh& mesh,
  const std::vector<Vector3>& normals,
  const Lists& vertexVertices,
  const View& view,
  const std::vector<Vector2>& ring,
  const std::vector<int>& seeds,
  const std::vector<RunOnMesh>& runs)
{
  const std::vector<Vector2> polygon = coarsened(ring);
  const auto facing = [&](int v) { return normals[v].dot(view.towardsViewer(mesh.points[v]).normalized()); };
  double side = 0.0; // of the line: of a mesh that is inside out it is below 0
  for (const int t : seeds)
  {
    for (const int v : mesh.triangles[t])
    {
      side += facing(v);
    }
  }
  const auto isWithin = [&](int v)
  { return view.inFront(mesh.points[v]) && isInside(polygon, view.toDisplay(mesh.points[v]).head<2>()); };
  const std::vector<char> joined = reachedFrom(seeds, mesh, vertexVertices, isWithin);
  const auto isOnSide = [&](int v) { return joined[v] && (side < 0.0 ? -facing(v) : facing(v)) > edgeOn; };
  const std::vector<char> shown = reachedFrom(seeds, mesh, vertexVertices, isOnSide);
  const auto touches = [&](const RunOnMesh& run, const std::vector<char>& reached)
  {
    return std::any_of(run.triangles.begin(),
      run.triangles.end(),
      [&](int t)
      {
        const Triangle& c = mesh.triangles[t];
        return reached[c[0]] || reached[c[1]] || reached[c[2]];
      });
  };
  const std::size_t count = runs.size();
  std::vector<char> told;
  for (std::size_t k = 0; k < count; ++k)
  {
    const RunOnMesh& run = runs[k];
    const double leaps = leapOf(runs[(k + count - 1) % count], run) + leapOf(run, runs[(k + 1) % count]);
    told.push_back(touches(run, joined) && (touches(run, shown) || mostLeap * lengthOf(run) >= leaps));
  }
  return std::any_of(told.begin(), told.end(), [](char one) { return one != 0; })
           ? told
           : std::vector<char>(count, 1);
}

double shareOutside(const Mesh& mesh,
  const std::vector<char>& inside,
  const View& view,
  const std::vector<Vector2>& ring)
{
  const std::vector<Vector2> polygon = coarsened(ring);
  double outside = 0.0, whole = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    if (!inside[t[0]] && !inside[t[1]] && !inside[t[2]])
    {
      continue;
    }
    const Vector3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Vector3 middle = (a + b + c) / 3.0;
    const double area = (b - a).cross(c - a).norm();
    whole += area;
    if (!view.inFront(middle) || !isInside(polygon, view.toDisplay(middle).head<2>()))
    {
      outside += area;
    }
  }
  return whole > 0.0 ? outside / whole : 0.0;
}

} // namespace oversketch
