#include "Stellar/crossings.h"

namespace oversketch
{

void CrossingFinder::add(int f, int i, std::vector<EdgeCrossing>& found) const
{
  const Forest::Face& face = this->Mesh.faces[f];
  const int first = face.v[(i + 1) % 3], second = face.v[(i + 2) % 3];
  const Vector3& a = this->Mesh.vertices[first].position;
  const Vector3& c = this->Mesh.vertices[second].position;
  const Vector3 edge = c - a;
  const double squared = edge.squaredNorm(), half = 0.5 * std::sqrt(squared);
  Vector3 normal = this->Mesh.facetNormal(f);
  if (face.n[i] >= 0)
  {
    normal += this->Mesh.facetNormal(face.n[i]);
  }
  const double length = normal.norm();
  if (!(squared > 0.0) || !(length > 0.0))
  {
    return;
  }
  normal /= length;
  const Vector3 across = normal.cross(edge), up = half * normal;
  Eigen::AlignedBox3d box(a + up);
  box.extend(a - up).extend(c + up).extend(c - up);
  const FeatureCurves& curves = this->Search.curves();
  for (int k = 0; k < static_cast<int>(curves.size()); ++k)
  {
    const FeatureCurve& curve = curves[k];
    this->Search.meet(k,
      box,
      [&](int s)
      {
        const int next = curve.segmentEnd(s);
        const Vector3 from = curve.points[s] - a, to = curve.points[next] - a;
        const double left = across.dot(from), right = across.dot(to);
        if ((left >= 0.0) == (right >= 0.0))
        {
          return false;
        }
        const double w = left / (left - right);
        const Vector3 place = from + w * (to - from);
        const double u = place.dot(edge) / squared;
        const bool facing =
          curve.normals.empty() || ((1.0 - w) * curve.normals[s] + w * curve.normals[next]).dot(normal) > 0.0;
        if (u > 0.0 && u < 1.0 && std::abs(place.dot(normal)) <= half && facing)
        {
          const double end = next == 0 ? curve.length : curve.arc[next];
          found.push_back({ { first, second }, k, u, curve.arc[s] + w * (end - curve.arc[s]) });
        }
        return false;
      });
  }
}

bool CrossingFinder::near(int f) const
{
  const Forest::Face& face = this->Mesh.faces[f];
  Eigen::AlignedBox3d box;
  for (const int v : face.v)
  {
    box.extend(this->Mesh.vertices[v].position);
  }
  // Half the longest edge, which is no longer than the box's diagonal.
  const Vector3 margin = Vector3::Constant(0.5 * box.diagonal().norm());
  box.min() -= margin;
  box.max() += margin;
  for (int k = 0; k < static_cast<int>(this->Search.curves().size()); ++k)
  {
    if (this->Search.meet(k, box, [](int) { return true; }))
    {
      return true;
    }
  }
  return false;
}

} // namespace oversketch
