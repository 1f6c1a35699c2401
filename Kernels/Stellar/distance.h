// Distances of vertices from feature curves, over the surface or through space.
#ifndef oversketch_kernels_stellar_distance_h
#define oversketch_kernels_stellar_distance_h

#include "Stellar/forest.h"

#include <vector>

namespace oversketch
{

struct Context;

enum class CurveDistance
{
  Straight, // through space, to the nearest segment
  Geodesic  // the length of a front's way over the surface, never less than that
};

struct ReachOptions
{
  double radius = 0.0; // [model length], above 0; only what is nearer is reached
  CurveDistance kind = CurveDistance::Straight;
  // Straight alone: reach only what is joined to the curve by edges whose ends are both reached. A front is
  // always joined.
  bool connectedOnly = true;

  bool operator==(const ReachOptions& other) const
  {
    return this->radius == other.radius && this->kind == other.kind &&
           this->connectedOnly == other.connectedOnly;
  }
};

struct Reached
{
  int vertex;
  double distance;  // 0 for a vertex that is snapped to the curve
  double parameter; // arc length of the nearest point in space; of a snapped vertex its own
};

// The vertices that one curve reaches. Holds numbers for each vertex, so keep it for all curves of a forest,
// and for later states of it in which no vertex has been moved or snapped: each is measured once, and where
// it is told what was split, what was reached is not gone over again.
class CurveReach
{
public:
  // `follows`: follow() will tell of all that happens to the forest.
  CurveReach(const Forest& forest, const CurveSearch& search, bool follows = false);

  // `faces`: that the curve passes through, see CrossedFaces. Ascending by vertex; valid until the next call.
  const std::vector<Reached>& find(int curve,
    const std::vector<int>& faces,
    const ReachOptions& options,
    const Context& context);

  // Tells of faces that were split, before the next find().
  void follow(const std::vector<Forest::Birth>& births);

  // Distance of a vertex from the last curve, infinite where it is not reached.
  double distance(int vertex) const;

private:
  // Measures of one curve in its last search, in any order, and what it found while another one is
  // searched. isWhole: that hangs together, and but for those `born` the forest is as it was.
  struct Memory
  {
    ReachOptions options;
    std::vector<Reached> straight, found;
    bool isWhole = false;
    std::vector<Forest::Birth> born;
  };
  void recall(int curve, const ReachOptions& options);
  void remember(const Reached& measured);
  void put(const Reached& reached);
  void forget();
  std::vector<Reached> measured(const std::vector<int>& vertices, const Context& context);
  void spread(const std::vector<int>& from, const Context& context);
  bool hangsTogether() const;
  bool grow(const std::vector<int>& faces, const Context& context);
  Reached straight(int vertex) const;
  void everywhere(const Context& context);
  void flood(const std::vector<int>& faces, const Context& context);
  void front(const std::vector<int>& faces, const Context& context);

  const Forest& Mesh;
  const CurveSearch& Search;
  const bool Follows;
  int Curve = -1;
  ReachOptions Options;
  std::vector<Reached> Found;
  std::vector<int> Place; // per vertex, in Found; -1
  std::vector<int> Known; // per vertex, in the memory of this curve; -1
  std::vector<Memory> Memories;
};

// A front's distance behind an edge of length c: at a point (vx, vy), vy >= 0, where the edge's ends (0, 0)
// and (c, 0) are da and db from the source; infinite where the straight way does not cross the edge, or no
// source is so far from both.
double unfoldedDistance(double da, double db, double c, double vx, double vy);

// A front's distance at a triangle's third corner, from two at distances da and db (infinite where it has not
// passed b): unfolded, else along the shorter edge. to: the others seen from a.
double frontStep(double da, double db, const Vector3& toB, const Vector3& toV);

} // namespace oversketch
#endif
