// The faces of a 4-8 mesh that feature curves pass through.
#ifndef oversketch_stellar_passage_h
#define oversketch_stellar_passage_h

#include "Stellar/forest.h"

#include <vector>

namespace oversketch
{

struct Context;

// A curve is a chain of chords that lies on the facets but for rounding, or near them where the surface moved
// since it was drawn. It passes through a face where one of its segments meets the face, seen along the
// face's normal, and is no farther from it than half the face's longest edge; if it is so far from all faces,
// than as much more as it takes. A curve with normals passes only through faces that they look out of.
class Passage
{
public:
  // For each curve: the faces that are nearest to its samples, and from there those joined edge to edge that
  // it passes through. Looks at each leaf once.
  Passage(const Forest& forest, const CurveSearch& search, const Context& context);

  // Goes on to the children of faces that were split since.
  void follow(const std::vector<Forest::Birth>& births);

  // Ascending.
  const std::vector<int>& faces(int curve) const { return this->Faces[curve]; }

private:
  // `gap`: how far the curve may be from the face.
  bool passes(int face, int curve, double gap) const;
  std::vector<int> touched(int curve, double widening, const Context& context) const;
  std::vector<int> joined(int curve, double widening, const std::vector<int>& touched) const;

  const Forest& Mesh;
  const CurveSearch& Search;
  std::vector<std::vector<int>> Faces;
  std::vector<std::vector<double>> Gaps; // of the faces that these are pieces of
};

} // namespace oversketch
#endif
