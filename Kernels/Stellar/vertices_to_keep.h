// Vertices of a 4-8 mesh that feature curves need, which simplification keeps.
#ifndef oversketch_kernels_stellar_vertices_to_keep_h
#define oversketch_kernels_stellar_vertices_to_keep_h

#include "Stellar/crossed_faces.h"
#include "Stellar/distance.h"

#include <vector>

namespace oversketch
{

struct Context;

struct VerticesToKeep
{
  enum Why : char
  {
    Within = 1, // the radius of a curve
    Passed = 2  // of a face that a curve passes through
  };
  std::vector<char> why;                                // per vertex, a sum
  std::vector<std::vector<int>> passed, touched, parts; // per curve, see CrossedFaces

  VerticesToKeep() = default;
  explicit VerticesToKeep(const Forest& forest)
    : why(forest.vertices.size(), 0)
  {
  }
  // Adds what the next curve needs.
  void add(const Forest& forest,
    int curve,
    double radius,
    const std::vector<Reached>& reached,
    const CrossedFaces& crossed);
};

// The needs of all curves; `options`: for those without a radius of their own.
VerticesToKeep verticesToKeep(const Forest& forest,
  const FeatureCurves& curves,
  const ReachOptions& options,
  const Context& context);

// Whether curves need of `after`, its vertices put back, what they need of `before`, which it was before a
// displacement wrote the vertices `changing`; `faces`: round those. Looks only at what is not as it was to
// the bit; false also where that does not tell.
bool stillNeeded(const Forest& before,
  const VerticesToKeep& needed,
  const Forest& after,
  const std::vector<int>& changing,
  const std::vector<int>& faces,
  const FeatureCurves& curves,
  const ReachOptions& options,
  const Context& context);

} // namespace oversketch
#endif
