// 4-8 meshes and feature curves with known answers, for tests of Kernels/Stellar. Header-only.
#ifndef oversketch_test_features_h
#define oversketch_test_features_h

#include "Harness/shapes.h"
#include "Stellar/forest.h"

#include <random>

namespace oversketch_test
{

// The unit square as n x n quads of two triangles each, split from lower left to upper right; inner points
// are moved by up to `jitter` of a quad's side.
inline Forest squareForest(int n, double jitter = 0.0, unsigned seed = 1)
{
  Forest forest;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-jitter / n, jitter / n);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
    {
      Forest::Vertex vertex;
      const double dx = move(random), dy = move(random);
      vertex.position = {
        double(i) / n + (i > 0 && i < n ? dx : 0.0), double(j) / n + (j > 0 && j < n ? dy : 0.0), 0.0
      };
      forest.vertices.push_back(vertex);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
    {
      const int a = j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
      const int root = static_cast<int>(forest.faces.size());
      forest.faces.push_back({ 1, { b, c, a }, { -1, -1, -1 }, root, 0 });
      forest.faces.push_back({ 1, { d, a, c }, { -1, -1, -1 }, root + 1, 0 });
    }
  forest.rootCount = 2 * n * n;
  forest.connect();
  return forest;
}

inline FeatureCurve featureCurve(const std::vector<Vector3>& points, bool closed = false)
{
  FeatureCurve curve;
  curve.points = points;
  curve.closed = closed;
  curve.measure();
  return curve;
}

inline std::vector<Vector3> positionsOf(const Forest& forest)
{
  std::vector<Vector3> points;
  for (const Forest::Vertex& v : forest.vertices)
    points.push_back(v.position);
  return points;
}

} // namespace oversketch_test
#endif
