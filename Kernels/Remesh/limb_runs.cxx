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

} // namespace

std::vector<char> runsOnLimb(const Mesh& mesh,
  const Lists& vertexVertices,
  const View& view,
  const std::vector<Vector2>& ring,
  const std::vector<int>& seeds,
  const std::vector<RunOnMesh>& runs)
{
  const std::vector<Vector2> polygon = coarsened(ring);
  std::vector<char> reached(mesh.points.size(), 0);
  std::vector<int> open;
  const auto reach = [&](int v)
  {
    if (!reached[v] && view.inFront(mesh.points[v]) &&
        isInside(polygon, view.toDisplay(mesh.points[v]).head<2>()))
    {
      reached[v] = 1;
      open.push_back(v);
    }
  };
  for (const int t : seeds)
  {
    for (const int v : mesh.triangles[t])
    {
      reach(v);
    }
  }
  while (!open.empty())
  {
    const int v = open.back();
    open.pop_back();
    std::for_each(vertexVertices.begin(v), vertexVertices.end(v), reach);
  }
  std::vector<char> told;
  for (const RunOnMesh& run : runs)
  {
    told.push_back(std::any_of(run.triangles.begin(),
      run.triangles.end(),
      [&](int t)
      {
        const Triangle& c = mesh.triangles[t];
        return reached[c[0]] || reached[c[1]] || reached[c[2]];
      }));
  }
  return std::any_of(told.begin(), told.end(), [](char one) { return one != 0; })
           ? told
           : std::vector<char>(runs.size(), 1);
}

} // namespace oversketch
