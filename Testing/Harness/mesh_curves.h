// Strokes as curves of mesh edges, by the kernels alone, and what to measure of them. Header-only.
#ifndef oversketch_testing_harness_mesh_curves_h
#define oversketch_testing_harness_mesh_curves_h

#include "Harness/edges.h"
#include "Mesh/context.h"
#include "Ray/curve_projection.h"
#include "Remesh/insert_curves.h"
#include "Stroke/fit.h"

#include <map>
#include <memory>
#include <set>

namespace oversketch_test
{

// A stroke as fitted, projected and inserted.
struct DrawnCurve
{
  FittedStroke fitted;
  Polyline picture; // of the fitted curve [px]
  std::vector<SurfaceCurve> runs;
  NewCurve curve;
};

inline DrawnCurve drawnCurve(const Mesh& mesh,
  const View& view,
  const Polyline& samples,
  bool closed,
  const CurveRules& rules = {},
  const FitRules& fit = {})
{
  DrawnCurve drawn;
  drawn.fitted = fitStroke(samples, closed, fit);
  for (const SplinePlace& place : drawn.fitted.places)
  {
    drawn.picture.push_back(place.of(drawn.fitted.controls));
  }
  const SurfaceRays surface(std::make_shared<const Mesh>(mesh));
  drawn.runs = projectCurve(surface, view, drawn.picture, closed, rules);
  drawn.curve.closed = closed;
  drawn.curve.view = &view;
  for (const SurfaceCurve& run : drawn.runs)
  {
    CurveRun taken;
    taken.closed = run.closed;
    for (const SurfaceSample& sample : run.samples)
    {
      taken.places.push_back(sample.at);
      taken.parameters.push_back(sample.along / static_cast<double>(drawn.picture.size()));
    }
    drawn.curve.runs.push_back(taken);
  }
  return drawn;
}

inline Polyline circleOf(const Vector2& centre, double radius, int count = 120)
{
  Polyline samples;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * pi * i / count;
    samples.emplace_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return samples;
}

inline double areaOf(const Mesh& mesh, const Triangle& t)
{
  return 0.5 * (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).norm();
}

inline double areaOf(const Mesh& mesh)
{
  double area = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    area += areaOf(mesh, t);
  }
  return area;
}

using Edge = std::pair<int, int>;

inline std::set<Edge> edgesOf(const MeshCurve& curve)
{
  std::set<Edge> edges;
  for (int i = 0; i < curve.segments(); ++i)
  {
    const int a = curve.vertices[i], b = curve.vertices[curve.next(i)];
    edges.emplace(std::min(a, b), std::max(a, b));
  }
  return edges;
}

// Segments of the curve that are no edge of the mesh.
inline int looseSegments(const Mesh& mesh, const MeshCurve& curve)
{
  std::set<Edge> edges;
  for (const Triangle& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.emplace(std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]));
    }
  }
  int loose = 0;
  for (const Edge& edge : edgesOf(curve))
  {
    loose += static_cast<int>(edges.count(edge) == 0);
  }
  return loose;
}

// Whether a curve is one: no vertex twice, parameters rising from 0 to 1.
inline bool soundCurve(const MeshCurve& curve)
{
  bool sound = curve.parameters.size() == curve.vertices.size() && curve.parameters.front() == 0.0 &&
               (curve.closed ? curve.parameters.back() < 1.0 : curve.parameters.back() == 1.0) &&
               std::set<int>(curve.vertices.begin(), curve.vertices.end()).size() == curve.vertices.size();
  for (std::size_t i = 1; i < curve.parameters.size(); ++i)
  {
    sound = sound && curve.parameters[i] > curve.parameters[i - 1];
  }
  return sound;
}

inline std::vector<Triangle> trianglesAlong(const Mesh& mesh, const MeshCurve& curve)
{
  std::vector<char> on(mesh.points.size(), 0);
  for (const int v : curve.vertices)
  {
    on[v] = 1;
  }
  std::vector<Triangle> along;
  for (const Triangle& t : mesh.triangles)
  {
    if (on[t[0]] || on[t[1]] || on[t[2]])
    {
      along.push_back(t);
    }
  }
  return along;
}

// Smallest angles of the triangles with a vertex on the curve, ascending [degrees].
inline std::vector<double> anglesAlong(const Mesh& mesh, const MeshCurve& curve)
{
  std::vector<double> angles;
  for (const Triangle& t : trianglesAlong(mesh, curve))
  {
    angles.push_back(smallestAngle(mesh, t));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

inline double share(const std::vector<double>& ascending, double part)
{
  return ascending[static_cast<std::size_t>(part * static_cast<double>(ascending.size() - 1))];
}

// The triangles on the side of a closed curve where the given one is.
inline std::vector<Triangle> sideOf(const Mesh& mesh, const MeshCurve& curve, int seed)
{
  const std::set<Edge> walls = edgesOf(curve);
  std::map<Edge, std::vector<int>> at;
  const auto edge = [&](int t, int k)
  {
    const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
    return Edge(std::min(a, b), std::max(a, b));
  };
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      at[edge(t, k)].push_back(t);
    }
  }
  std::vector<char> reached(mesh.triangles.size(), 0);
  std::vector<int> open{ seed };
  reached[seed] = 1;
  std::vector<Triangle> side;
  while (!open.empty())
  {
    const int t = open.back();
    open.pop_back();
    side.push_back(mesh.triangles[t]);
    for (int k = 0; k < 3; ++k)
    {
      for (const int next : walls.count(edge(t, k)) ? std::vector<int>() : at[edge(t, k)])
      {
        if (!reached[next])
        {
          reached[next] = 1;
          open.push_back(next);
        }
      }
    }
  }
  return side;
}

// The triangle that is seen at a place of the picture, -1 where none is.
inline int seenAt(const Mesh& mesh, const View& view, const Vector2& display)
{
  const SurfaceRays surface(std::make_shared<const Mesh>(mesh));
  return surface.nearest(lineOfSight(view, display, surface)).at.triangle;
}

} // namespace oversketch_test
#endif
