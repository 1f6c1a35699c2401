#include "Join/bridge.h"

#include "Intersection/face_tree.h"
#include "Join/seam.h"
#include "Mesh/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oversketch
{

namespace
{

// A place of a body: a triangle of it, and weights of that one's corners.
struct Foot
{
  int triangle = -1;
  Vector3 weights = Vector3::Zero();
  Vector3 point = Vector3::Zero();
};

// The place of a body that is nearest to one of some points, and that point.
std::pair<Foot, int> nearestFoot(const Body& body, const std::vector<Vector3>& points, const Context& context)
{
  std::vector<BoxedFace> faces;
  for (int t = 0; t < body.mesh.triangleCount(); ++t)
  {
    faces.push_back({ t, boxOf(body.mesh, t) });
  }
  const FaceTree tree(faces, context);
  Foot best;
  int from = 0;
  double distance = (body.mesh.points.front() - points.front()).norm() * (1.0 + 1e-9);
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
  {
    const Vector3 reach = Vector3::Constant(distance);
    tree.facesAt({ points[i] - reach, points[i] + reach },
      [&](int t)
      {
        const Triangle& of = body.mesh.triangles[t];
        const Vector3 &a = body.mesh.points[of[0]], &b = body.mesh.points[of[1]],
                      &c = body.mesh.points[of[2]];
        const std::array<double, 3> w = closestWeights(a, b, c, points[i]);
        const Vector3 place = w[0] * a + w[1] * b + w[2] * c;
        if ((place - points[i]).norm() < distance)
        {
          distance = (place - points[i]).norm();
          best = { t, { w[0], w[1], w[2] }, place };
          from = i;
        }
      });
  }
  return { best, from };
}

} // namespace

Body barBetween(const Body& first, const Body& second, double thickness, const Context& context)
{
  const auto [onFirst, from] = nearestFoot(first, second.mesh.points, context);
  const Foot onSecond = nearestFoot(second, { onFirst.point }, context).first;
  const Vector3 along = (onSecond.point - onFirst.point).normalized(), side = along.unitOrthogonal(),
                up = along.cross(side);
  const double radius = thickness / 2.0, length = (onSecond.point - onFirst.point).norm() + 2.0 * thickness;
  constexpr int around = 48;
  const int rings = 2 + static_cast<int>(std::min(1000.0, std::ceil(length / (radius * 0.13))));
  Body bar;
  for (int ring = 0; ring < rings; ++ring)
  {
    const Vector3 middle = onFirst.point + (length * ring / (rings - 1) - thickness) * along;
    for (int k = 0; k < around; ++k)
    {
      const double angle = 2.0 * 3.14159265358979323846 * k / around;
      bar.mesh.points.push_back(middle + radius * (std::cos(angle) * side + std::sin(angle) * up));
    }
  }
  const int ends[2] = { bar.mesh.vertexCount(), bar.mesh.vertexCount() + 1 };
  bar.mesh.points.push_back(onFirst.point - thickness * along);
  bar.mesh.points.push_back(onSecond.point + thickness * along);
  const auto add = [&](const Triangle& t, bool ofSecond)
  {
    const Body& body = ofSecond ? second : first;
    const Foot& foot = ofSecond ? onSecond : onFirst;
    const Vector3 at = body.weightsAt(foot.triangle, foot.weights);
    bar.add(t, body.source[foot.triangle], bridgePart, { at, at, at });
  };
  for (int k = 0; k < around; ++k)
  {
    const int next = (k + 1) % around, last = (rings - 1) * around;
    add({ ends[0], next, k }, false);
    for (int ring = 0; ring + 1 < rings; ++ring)
    {
      const int a = ring * around + k, b = ring * around + next;
      add({ a, b, b + around }, 2 * ring + 1 > rings);
      add({ a, b + around, a + around }, 2 * ring + 1 > rings);
    }
    add({ ends[1], last + k, last + next }, true);
  }
  return bar;
}

} // namespace oversketch
