// How the faces of a forest are shaped, for tests. Header-only.
#ifndef oversketch_testing_harness_face_quality_h
#define oversketch_testing_harness_face_quality_h

#include "Stellar/quality.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace oversketch_test
{

struct FaceQuality
{
  double smallestAngle = 60.0; // [degrees], of all faces
  int degenerate = 0;          // faces with an angle under 0.05 degrees
};

inline FaceQuality faceQuality(const oversketch::Forest& forest)
{
  double narrowest = 0.75; // of an equilateral triangle
  const double limit = oversketch::squaredSine(0.05);
  FaceQuality quality;
  for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
  {
    if (forest.isFace(f))
    {
      const int* v = forest.faces[f].v;
      const double sine = oversketch::narrowness(
        forest.vertices[v[0]].position, forest.vertices[v[1]].position, forest.vertices[v[2]].position);
      narrowest = std::min(narrowest, sine);
      quality.degenerate += sine < limit ? 1 : 0;
    }
  }
  quality.smallestAngle = std::asin(std::sqrt(narrowest)) * 180.0 / std::acos(-1.0);
  return quality;
}

// How many leaves have normals that turned over 90 degrees while vertices moved; `before` and `after` hold
// positions of the vertex slots. Of faces that had no area nothing is said.
inline int flippedFaces(const oversketch::Forest& forest,
  const std::vector<oversketch::Vector3>& before,
  const std::vector<oversketch::Vector3>& after)
{
  int flipped = 0;
  for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
  {
    if (forest.isFace(f))
    {
      const int* v = forest.faces[f].v;
      const oversketch::Vector3 old = (before[v[1]] - before[v[0]]).cross(before[v[2]] - before[v[0]]);
      const oversketch::Vector3 now = (after[v[1]] - after[v[0]]).cross(after[v[2]] - after[v[0]]);
      flipped += old.dot(now) < 0.0 ? 1 : 0;
    }
  }
  return flipped;
}

} // namespace oversketch_test
#endif
