// Patches with known answers, for the tests of this folder. Header-only.
#ifndef oversketch_shading_patches_h
#define oversketch_shading_patches_h

#include "Harness/shapes.h"

#include <functional>

namespace oversketch_test
{

// The triangles whose corners all are where `inside` says, with their vertices numbered anew.
inline Mesh patchOf(const Mesh& mesh, const std::function<bool(const Vector3&)>& inside)
{
  Mesh patch;
  std::vector<int> number(mesh.points.size(), -1);
  for (const Triangle& t : mesh.triangles)
  {
    if (inside(mesh.points[t[0]]) && inside(mesh.points[t[1]]) && inside(mesh.points[t[2]]))
    {
      Triangle& mine = patch.triangles.emplace_back();
      for (int k = 0; k < 3; ++k)
      {
        if (number[t[k]] < 0)
        {
          number[t[k]] = patch.vertexCount();
          patch.points.push_back(mesh.points[t[k]]);
        }
        mine[k] = number[t[k]];
      }
    }
  }
  return patch;
}

inline Mesh cap(int levels, double height = 0.5)
{
  return patchOf(icosphere(levels), [=](const Vector3& p) { return p[2] > height; });
}

// A limb's tip: a sphere drawn out, above its middle.
inline Mesh limb(int levels, double length)
{
  Mesh mesh = patchOf(icosphere(levels), [](const Vector3& p) { return p[2] > -0.2; });
  for (Vector3& p : mesh.points)
  {
    p[2] *= p[2] > 0.0 ? length : 1.0;
  }
  return mesh;
}

} // namespace oversketch_test
#endif
