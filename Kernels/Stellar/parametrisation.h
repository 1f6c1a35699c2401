// The original of a simplified surface: from a place on it to the original surface and back.
#ifndef oversketch_kernels_stellar_parametrisation_h
#define oversketch_kernels_stellar_parametrisation_h

#include "Mesh/place.h"
#include "Stellar/pairing.h"

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace oversketch
{

// One record for each operation that put new faces in the place of old ones, with the vertices of both laid
// flat (after Lee and others' MAPS). Plain lists, so that they can travel as arrays.
struct Parametrisation
{
  struct Record
  {
    int firstFlat, flatCount; // in flatVertex and flat
    int firstOld, oldCount;   // in oldFaces
    int firstNew, newCount;   // in faces
  };

  std::vector<Vector3> points; // of the original
  std::vector<Triangle> faces; // the original triangles, then all that were made; corners are in points
  std::vector<int> madeBy,
    goneBy;                   // per face: a record, or -1 for an original one and one that is still there
  std::vector<int> removedBy; // per point: a record, or -1
  std::vector<Record> records;
  std::vector<int> flatVertex;
  std::vector<Vector2> flat;
  std::vector<int> oldFaces;

  Parametrisation() = default;
  explicit Parametrisation(const Mesh& original);

  // Appends an operation. `removed`: the vertex that is gone with it, or -1. Returns the first new face.
  int add(const std::vector<int>& old,
    const std::vector<std::pair<int, Vector2>>& flattened,
    const std::vector<Triangle>& made,
    int removed);

  // Where a place on any face, given by weights of its corners, was on the original.
  SurfacePoint original(int face, const Vector3& weights) const;
  Vector3 sample(int face, const Vector3& weights) const;
  // A point of the original as a place on a face that is still there.
  std::pair<int, Vector3> place(int point) const;

private:
  Vector2 flatOf(const Record& record, int vertex) const;
  std::pair<int, Vector3> containing(const Record& record,
    const int* candidates,
    int count,
    const Vector2& q) const;
  Vector2 flatten(const Record& record, int face, const Vector3& weights) const;
};

// A triangle of a simplified surface, or a third of one, that became a root of a forest.
struct SourceRoot
{
  int face;                   // of the parametrisation
  std::array<int, 3> corners; // which corner of the face each corner of the root is; 3: its middle
};

// `faces`: of the parametrisation, one for each triangle of the mesh that was paired.
std::vector<SourceRoot> sourceRoots(const std::vector<int>& faces,
  const BaseMesh& base,
  const Mesh& simplified);

// The roots of a forest before the simplification.
struct OriginalSurface
{
  Parametrisation records;
  std::vector<SourceRoot> roots;

  SurfacePoint at(const SourcePlace& place) const; // where on the original
};

// Throws, when asked about a root that there is not, Error(BadMesh).
Source sourceOf(const std::shared_ptr<const OriginalSurface>& surface);

// The parametrisation again from lists that travelled as arrays. `made`: the faces behind the original ones.
// `counts`: of each record the flattened vertices, old and new faces. Throws Error(BadMesh) naming the array
// of vtkOversketchStellarBase that contradicts the others.
Parametrisation readRecords(const Mesh& original,
  const std::vector<Triangle>& made,
  const std::vector<std::array<int, 3>>& counts,
  const std::vector<int>& oldFaces,
  const std::vector<int>& flatVertex,
  const std::vector<Vector2>& flat);
// Checks the roots, which are faces that are still there.
void checkRoots(const OriginalSurface& surface);

// Puts the points that pairing added, which are middles of chords, on the source.
void putOnSource(Forest& forest, const Source& source);

} // namespace oversketch
#endif
