// What a simplified surface was: from a place on it to the original surface and back.
#ifndef oversketch_stellar_parametrisation_h
#define oversketch_stellar_parametrisation_h

#include "Mesh/place.h"
#include "Stellar/pairing.h"

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

// The original surface for a forest that was made of a simplified one. `faces`: of the parametrisation, one
// for each triangle of the mesh that was paired. Refers to both.
Source sourceOf(const Parametrisation& original,
  const std::vector<int>& faces,
  const BaseMesh& base,
  const Mesh& simplified);

// Puts the points that pairing added, which are middles of chords, on the source.
void putOnSource(Forest& forest, const Source& source);

} // namespace oversketch
#endif
