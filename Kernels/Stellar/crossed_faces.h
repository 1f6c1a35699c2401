// The faces of a 4-8 mesh that feature curves pass through.
#ifndef oversketch_kernels_stellar_crossed_faces_h
#define oversketch_kernels_stellar_crossed_faces_h

#include "Stellar/forest.h"

#include <vector>

namespace oversketch
{

struct Context;

// A curve is a chain of chords that lies on the facets but for rounding, or near them where the surface moved
// since it was drawn. It passes through a face where one of its segments meets the face, seen along the
// face's normal, and is no farther from it than half the face's longest edge; if it is so far from all faces,
// than as much more as it takes. A curve with normals passes only through faces that they look out of.
class CrossedFaces
{
public:
  // For each curve: the faces that are nearest to its samples, and from there those joined edge to edge that
  // it passes through. Looks at each leaf once.
  CrossedFaces(const Forest& forest, const CurveSearch& search, const Context& context);

  // Goes on to the children of faces that were split since.
  void follow(const std::vector<Forest::Birth>& births);

  // Ascending.
  const std::vector<int>& faces(int curve) const { return this->Faces[curve]; }
  // All faces that the curve touches, ascending; empty where they had to be looked for farther off.
  const std::vector<int>& touched(int curve) const { return this->Touched[curve]; }
  // By a number for each of those, the parts in which they hang together.
  const std::vector<int>& parts(int curve) const { return this->Parts[curve]; }

private:
  // `gap`: how far the curve may be from the face.
  bool passes(int face, int curve, double gap) const;
  std::vector<int> touching(int curve, double widening, const Context& context) const;

  const Forest& Mesh;
  const CurveSearch& Search;
  std::vector<std::vector<int>> Faces, Touched, Parts;
  std::vector<std::vector<double>> Gaps; // of the faces that these are pieces of
};

// Where a vertex was before the last displacement, but for rounding.
inline Vector3 putBack(const Forest& forest, int v)
{
  const Vector3& at = forest.vertices[v].position;
  const bool moved = !forest.displacement.empty() && forest.displacement[v] != Vector3::Zero();
  return moved ? Vector3(at - forest.displacement[v]) : at;
}

// Whether a curve touches a face with these corners: meets it, seen along its normal, no farther off than
// half its longest edge.
bool touches(const CurveSearch& search, int curve, const Vector3& a, const Vector3& b, const Vector3& c);

// Finds CrossedFaces::faces of a forest whose vertices are put back, of which all touched faces are known.
std::vector<int> passedPutBack(const Forest& forest,
  const CurveSearch& search,
  int curve,
  const std::vector<int>& touched,
  const std::vector<int>& parts);

} // namespace oversketch
#endif
