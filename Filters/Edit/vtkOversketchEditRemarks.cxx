#include "vtkOversketchEditRemarks.h"

#include "Intersection/crossing_faces.h"
#include "Matrix/logarithm.h"
#include "Ray/surface_rays.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchEditTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace oversketch
{

namespace
{

constexpr double foldCosine = -0.5; // of 120 degrees
constexpr double leastSeen = 0.5;   // of a ring
constexpr double leastInward = 0.5; // cosine: what goes in more nearly along the surface may leave it again
constexpr double rounding = 1e-6;   // of the diagonal

// The place of a polyline's points at a value of an array that rises along it.
Vector3 placeAt(vtkPolyData* line, vtkDataArray* values, double value)
{
  const vtkIdType count = line->GetNumberOfPoints();
  vtkIdType after = 1;
  while (after + 1 < count && values->GetComponent(after, 0) < value)
  {
    ++after;
  }
  const double from = values->GetComponent(after - 1, 0), to = values->GetComponent(after, 0);
  const double share = to > from ? std::clamp((value - from) / (to - from), 0.0, 1.0) : 0.0;
  return (1.0 - share) * Vector3(line->GetPoint(after - 1)) + share * Vector3(line->GetPoint(after));
}

// Whether a flat place lies on the inner side of a flat section, whose outside is up.
bool isInward(vtkPolyData* section, const double* place)
{
  bool inward = false;
  for (vtkIdType i = 1; i < section->GetNumberOfPoints(); ++i)
  {
    const Vector3 p(section->GetPoint(i - 1)), q(section->GetPoint(i));
    if ((p[0] <= place[0]) != (q[0] <= place[0]))
    {
      const double y = p[1] + (place[0] - p[0]) / (q[0] - p[0]) * (q[1] - p[1]);
      inward = inward != (y > place[1]);
    }
  }
  return inward;
}

} // namespace

int FoldsIn(vtkPolyData* mesh)
{
  vtkDataArray* region = mesh->GetPointData()->GetArray("EditRegion");
  const auto data = SharedMesh(mesh); // whose mesh goes with the last who holds it
  const Mesh& surface = data->Surface();
  std::vector<char> isNear(surface.points.size());
  for (std::size_t v = 0; v < isNear.size(); ++v)
  {
    isNear[v] = region->GetComponent(static_cast<vtkIdType>(v), 0) > 0.0;
  }
  std::vector<std::tuple<int, int, int>> sides; // of an edge its ends and a triangle
  for (int t = 0; t < surface.triangleCount(); ++t)
  {
    const Triangle& c = surface.triangles[t];
    for (int k = 0; k < 3 && (isNear[c[0]] || isNear[c[1]] || isNear[c[2]]); ++k)
    {
      const auto [a, b] = std::minmax(c[k], c[(k + 1) % 3]);
      sides.emplace_back(a, b, t);
    }
  }
  std::sort(sides.begin(), sides.end());
  const auto isOne = [&](std::size_t i, std::size_t j)
  {
    return j < sides.size() && std::get<0>(sides[i]) == std::get<0>(sides[j]) &&
           std::get<1>(sides[i]) == std::get<1>(sides[j]);
  };
  int folds = 0;
  for (std::size_t i = 0, next = 1; i < sides.size(); i = next)
  {
    for (next = i + 1; isOne(i, next); ++next)
    {
    }
    folds +=
      next - i == 2 &&
      facetNormal(surface, std::get<2>(sides[i])).dot(facetNormal(surface, std::get<2>(sides[i + 1]))) <
        foldCosine;
  }
  return folds;
}

int CrossingsIn(vtkPolyData* mesh, const Context& context)
{
  vtkDataArray* region = mesh->GetPointData()->GetArray("EditRegion");
  const auto data = SharedMesh(mesh);
  const Mesh& surface = data->Surface();
  std::vector<char> changed(surface.triangles.size());
  std::transform(surface.triangles.begin(),
    surface.triangles.end(),
    changed.begin(),
    [region](const Triangle& t)
    {
      return static_cast<char>(std::any_of(
        t.begin(), t.end(), [region](int v) { return region->GetComponent(v, 0) == EditLabel::Inside; }));
    });
  return static_cast<int>(crossingFaces(surface, changed, context).size());
}

double DepthInThickness(vtkPolyData* section, vtkPolyData* drawn, vtkPolyData* ground, const Context& context)
{
  vtkDataArray* places = section->GetPointData()->GetArray("CurveT");
  vtkDataArray* sources = drawn->GetPointData()->GetArray("SourceT");
  if (!places || !sources || section->GetNumberOfPoints() < 2)
  {
    return 0.0;
  }
  const Matrix4 toWorld = ReadMatrix(section->GetFieldData(), "ProfileMatrix", "profile", "cut it anew");
  const auto data = SharedMesh(ground);
  const auto rays = sharedRays(data->KeptSurface(), context);
  const auto inWorld = [&](const Vector3& flat) { return Vector3((toWorld * flat.homogeneous()).head<3>()); };
  double deepest = 0.0;
  for (vtkIdType i = 0; i < drawn->GetNumberOfPoints(); ++i)
  {
    if (!isInward(section, drawn->GetPoint(i)))
    {
      continue;
    }
    const Vector3 from = inWorld(placeAt(section, places, sources->GetComponent(i, 0)));
    const Vector3 way = inWorld(Vector3(drawn->GetPoint(i))) - from;
    const SurfaceHit start =
      rays->closest(from); // the section is fitted, and lies a little beside the surface
    if (!start.found())
    {
      continue;
    }
    const Vector3 inward = -facetNormal(rays->mesh(), start.at.triangle);
    const double depth = inward.dot(way);
    if (!(depth > leastInward * way.norm())) // outward, or along it
    {
      continue;
    }
    for (const SurfaceHit& hit : rays->all({ start.position, inward }))
    {
      if (hit.distance > rounding * rays->diagonal() &&
          facetNormal(rays->mesh(), hit.at.triangle).dot(inward) > 0.0)
      {
        deepest = std::max(deepest, depth / hit.distance);
        break;
      }
    }
  }
  return deepest > 1.0 ? deepest : 0.0;
}

Message RemarkOf(const EditFigures& figures)
{
  std::vector<Message> said;
  if (figures.depth > 0.0)
  {
    said.emplace_back(
      "The profile is drawn %1 times as deep as the model is thick there, and comes out on the far "
      "side: draw it less deep.",
      std::round(10.0 * figures.depth) / 10.0);
  }
  const Message remedy = figures.isProfile ? "draw the profile nearer to the section, or the ring wider"
                                           : "drag less far, or draw the ring wider";
  if (figures.crossings > 0)
  {
    said.emplace_back(figures.crossings == 1
                        ? "The edit makes the model pass through itself, in %1 pair of triangles: %2."
                        : "The edit makes the model pass through itself, in %1 pairs of triangles: %2.",
      figures.crossings,
      remedy);
  }
  if (figures.folds > 0)
  {
    said.emplace_back(figures.folds == 1 ? "The edit folds the model along %1 edge: %2."
                                         : "The edit folds the model along %1 edges: %2.",
      figures.folds,
      remedy);
  }
  if (figures.shareSeen < leastSeen)
  {
    said.emplace_back("Only %1 % of the ring lies where it was drawn, the rest on what is hidden there: see "
                      "whether that is meant, or draw the ring where the model is seen.",
      std::lround(100.0 * figures.shareSeen));
  }
  return Message::joined(said);
}

} // namespace oversketch
