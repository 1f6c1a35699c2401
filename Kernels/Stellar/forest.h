// The 4-8 mesh: the leaves of a forest of binary trees of triangles, refined and coarsened by edge splits and
// their inverse, always conforming (Velho and Zorin's 4-8 meshes, Velho's stellar operators).
#ifndef oversketch_kernels_stellar_forest_h
#define oversketch_kernels_stellar_forest_h

#include "Stellar/curves.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace oversketch
{

struct Context;
struct Staying;

// A point of the base mesh for a source that knows the original surface: weights of the root's corners.
struct SourcePlace
{
  int root = -1;
  Vector3 weights = Vector3::Zero();
  Vector3 position = Vector3::Zero(); // where the forest has it
};

// Where the original surface is at a place.
using Source = std::function<Vector3(const SourcePlace&)>;

// The rule for a new vertex, which follows, in this order: its edge, where both ends stay; the curve that
// both ends are snapped to; the source, if both ends lie on it; else the middle of its edge.
struct MidpointRule
{
  const FeatureCurves* curves = nullptr; // that the vertices' curveId means
  Source source;
  double sourceTolerance = 0.0;     // [model length] how near is "on it"; the spec has 1e-9 diagonals
  const Staying* staying = nullptr; // null: none stays
};

class Forest
{
public:
  // One leaf. v: corners, counter-clockwise, the newest first; the refinement edge is (v[1], v[2]).
  // n[i]: the leaf opposite v[i], -1 on the boundary. path: 1 for a root, 2 path + i for child i.
  struct Face
  {
    std::uint64_t path = 1;
    int v[3] = { -1, -1, -1 };
    int n[3] = { -1, -1, -1 };
    int root = -1; // -1: an unused slot
    std::uint8_t gen = 0;
  };

  enum Moved : std::uint8_t
  {
    Placed = 1, // snapped or smoothed
    Displaced = 2,
    Crest = 4 // snapped in an earlier stroke
  };

  struct Vertex
  {
    Vector3 position = Vector3::Zero();
    Vector3 baseNormal = Vector3::Zero(); // meaningful while hasBaseNormals
    double curveParam = 0.0;              // arc length on curve curveId
    int parents[2] = { -1, -1 }; // ends of the edge that it split; -1 for base vertices and barycentres
    int face = -1;               // one of its star; -1: of no face
    int curveId = -1;            // that it is snapped to
    std::uint8_t level = 0;      // 0 base, 1 barycentre, else 1 + generation of the split edge
    std::uint8_t moved = 0;      // a sum of Moved
  };

  static constexpr std::uint8_t unusedLevel = 255; // of an unused slot
  static constexpr int maximumDepth = 62;          // of splits below a root: what a path holds

  // Slots, some of which are unused after a weld; the next split takes them. A split leaves child 0 in its
  // parent's slot, a weld leaves the parent in child 0's; canonical() packs and orders them.
  std::vector<Face> faces;
  std::vector<Vertex> vertices;
  int rootCount = 0;
  bool hasBaseNormals = false;
  bool closed = false; // known to have no boundary, which no split or weld makes
  // The way that the last displacement moved each vertex, and its feature value; empty where there was none.
  std::vector<Vector3> displacement;
  std::vector<double> feature;

  // A copy with room for so many splits, which are quick where memory need not move; else for what a stroke
  // needs.
  Forest roomyCopy(std::size_t splits) const;
  Forest roomyCopy() const { return this->roomyCopy(this->faces.size() / 8 + 512); }

  bool isFace(int f) const { return this->faces[f].root >= 0; }
  bool isVertex(int v) const { return this->vertices[v].level != unusedLevel; }
  int faceCount() const { return static_cast<int>(this->faces.size() - this->FreeFaces.size()); }
  int vertexCount() const { return static_cast<int>(this->vertices.size() - this->FreeVertices.size()); }

  // Which corner of a face a vertex is.
  int corner(int f, int v) const
  {
    const Face& face = this->faces[f];
    return face.v[0] == v ? 0 : face.v[1] == v ? 1 : 2;
  }

  // The first face of a star: any inside, on the boundary the one with no neighbour clockwise. -1: none.
  int firstFace(int v) const;

  // Calls visit(face, corner) counter-clockwise. The vertex is the face's corner `corner`; the link runs from
  // v[(corner + 1) % 3] to v[(corner + 2) % 3].
  template <class Visit>
  void star(int v, const Visit& visit) const
  {
    const int first = this->firstFace(v);
    for (int f = first; f >= 0;)
    {
      const int i = this->corner(f, v), next = this->faces[f].n[(i + 1) % 3];
      visit(f, i);
      f = next == first ? -1 : next;
    }
  }

  // Whether the edge of a face opposite its corner i lies between roots of different parts. `parts`: a number
  // per root, or empty: all are one part.
  bool isSeam(int f, int i, const std::vector<int>& parts) const
  {
    const int n = this->faces[f].n[i];
    return !parts.empty() && n >= 0 && parts[this->faces[f].root] != parts[this->faces[n].root];
  }
  // Whether a vertex is on such an edge.
  bool onSeam(int v, const std::vector<int>& parts) const
  {
    bool found = false;
    if (!parts.empty())
    {
      this->star(v,
        [&](int f, int i)
        { found = found || this->isSeam(f, (i + 1) % 3, parts) || this->isSeam(f, (i + 2) % 3, parts); });
    }
    return found;
  }

  // Calls visit(vertex) for the link, counter-clockwise; on the boundary from end to end.
  template <class Visit>
  void link(int v, const Visit& visit) const
  {
    int last = -1, lastCorner = 0;
    this->star(v,
      [&](int f, int i)
      {
        visit(this->faces[f].v[(i + 1) % 3]);
        last = f;
        lastCorner = i;
      });
    if (last >= 0 && this->faces[last].n[(lastCorner + 1) % 3] < 0)
    {
      visit(this->faces[last].v[(lastCorner + 2) % 3]);
    }
  }

  bool onBoundary(int v) const;
  // The face that has the edge from a to b, counter-clockwise, or else from b to a; -1: no such edge.
  int faceWithEdge(int a, int b) const;

  // A split of one face, for those who keep lists of faces: child 0 is in `parent`'s slot, child 1 in
  // `child`. The new vertex is on the edge opposite `apex`.
  struct Birth
  {
    int parent, child, vertex, apex;
  };

  // Splits the refinement edge of a face, whose neighbour there is absent or has the same refinement edge.
  // Returns the new vertex.
  int split(int f, const MidpointRule& rule, std::vector<Birth>* births = nullptr);
  // Splits a face and, before that, those coarser neighbours that keep the mesh from conforming. Returns the
  // new vertex on the refinement edge of f.
  int refine(int f, const MidpointRule& rule, std::vector<Birth>* births = nullptr);
  // Refines until the edge from a to b is split. Returns the new vertex; -1: no such edge.
  int refineEdge(int a, int b, const MidpointRule& rule, std::vector<Birth>* births = nullptr);

  // A vertex with parents whose star is only what its split made (4 faces, 2 on the boundary).
  bool weldable(int w) const;
  // Undoes the split that made w.
  void weld(int w);

  // The corners of a face as weights of its root's corners.
  void rootWeights(int f, Vector3 weights[3]) const;
  // A vertex for a source: in the lowest root that it touches.
  SourcePlace place(int v) const;

  // The face of a star that a place is over, or is the least beside, and the weights of its corners there;
  // face -1 where none has area.
  struct FacePlace
  {
    int face = -1;
    Vector3 weights = Vector3::Zero();
  };
  FacePlace inStar(int v, const Vector3& place) const;

  const Vector3& cornerOf(int f, int i) const { return this->vertices[this->faces[f].v[i]].position; }
  Vector3 facetNormal(int f) const; // unit, zero for a face without area
  // Unit normal of a star, each face weighted by its angle at the vertex; zero for a star without area.
  Vector3 vertexNormal(int v) const;
  double diagonal() const; // of the box round the vertices that have faces

  // Fills n and the vertices' face from the corners; no slot may be unused. Throws Error(BadMesh) where an
  // edge has more than two faces or two with the same direction.
  void connect(const Context& context);

  // Tells what is wrong with the mesh's structure, or an empty string: edges, generations, levels, stars.
  std::string broken() const;

private:
  void putVertex(int m, const MidpointRule& rule);
  int newFace();
  int newVertex();
  void replaceNeighbour(int f, int before, int after);
  int restore(int child0);

  std::vector<int> FreeFaces, FreeVertices;
};

static_assert(sizeof(Forest::Face) == 40 && sizeof(Forest::Vertex) == 80, "kept small for speed");

// Fills baseNormal with angle-weighted normals of the leaves, where the forest has none.
void needBaseNormals(Forest& forest, const Context& context);

} // namespace oversketch
#endif
