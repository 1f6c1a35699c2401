// Feature curves C on a mesh, and the search for what is nearest on them.
#ifndef oversketch_kernels_stellar_curves_h
#define oversketch_kernels_stellar_curves_h

#include "Mesh/place.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace oversketch
{

// One stroke on the surface; lengths are model lengths. Its index among its fellows is its CurveId.
struct FeatureCurve
{
  std::vector<Vector3> points; // the first is not repeated at the end of a closed curve
  std::vector<double> arc;     // length from the first point, see measure()
  double length = 0.0;         // of the whole, a closed one's last segment included
  bool closed = false;
  int stroke = 0;               // StrokeId
  std::vector<Vector3> normals; // of the surface, or empty
  std::vector<double> pressure; // of the pen, or empty
  // How far the surface goes down and up before it meets another part [model length], or empty.
  std::vector<std::array<double, 2>> room;
  std::vector<int> cells;       // of the mesh that the stroke was projected on, or empty
  std::vector<Binding> places;  // within those cells, or empty
  std::optional<double> radius; // these go before the properties of a filter
  std::optional<double> height;
  std::optional<double> sharpness;

  int segmentCount() const { return static_cast<int>(this->points.size()) - (this->closed ? 0 : 1); }
  int segmentEnd(int segment) const
  {
    return segment + 1 < static_cast<int>(this->points.size()) ? segment + 1 : 0;
  }

  // Fills arc and length from the points.
  void measure();
  // The segment that holds an arc length, and how far along it (0 to 1). An open curve ends at its ends, a
  // closed one goes round.
  std::pair<int, double> at(double parameter) const;
  Vector3 position(double parameter) const;
  // Linear between samples.
  double pressureAt(double parameter) const; // 1 where there is none
  // Share of the width that a feature has there, which ends in points: from 0 at an open curve's ends it
  // rises as a sine to 1 within `taper` of them, or half the curve where that is shorter. 1 with a taper of
  // 0, and of a closed curve. The height has its square, so that flanks are flat at the point.
  double taperAt(double parameter, double taper) const;
  // Per point how far a feature may go, down (up false) or up; empty: as far as it likes. That is roomShare
  // of the room there, which in a round limb ends before the axis, and rises along the curve by no more
  // than the way.
  std::vector<double> limits(bool up) const;
  static constexpr double roomShare = 0.4;
  // How far apart two parameters are, round a closed curve the shorter way; and what lies half-way.
  double apart(double s, double t) const;
  double between(double s, double t) const;
};

using FeatureCurves = std::vector<FeatureCurve>;

// Throws Error(BadStroke) where a curve has fewer than two points, a number that is not finite, a list of a
// wrong length, a radius that is not positive or a negative sharpness.
void checkCurves(const FeatureCurves& curves);
// Throws Error(BadStroke) where the radius of curves without their own is not positive.
void checkRadius(const FeatureCurves& curves, double radius);

// A hash of the points of all curves, for CurveDigest.
std::uint64_t digest(const FeatureCurves& curves);

struct NearestOnCurve
{
  double distance = std::numeric_limits<double>::infinity();
  double parameter = 0.0; // arc length
  Vector3 point = Vector3::Zero();
  int segment = -1; // -1: nothing within the limit
};

// Boxes round segments that are near each other, one tree a curve. Keeps a reference to the curves.
class CurveSearch
{
public:
  explicit CurveSearch(const FeatureCurves& curves);

  // The nearest point of one curve that is nearer than the limit; equally near: the lower segment.
  NearestOnCurve nearest(int curve,
    const Vector3& point,
    double limit = std::numeric_limits<double>::infinity()) const;

  // Segments of a curve that may meet a box, in any order; stops where visit(segment) returns true, and says
  // whether it did.
  template <class Visit>
  bool meet(int curve, const Eigen::AlignedBox3d& box, const Visit& visit) const
  {
    const Tree& tree = this->Trees[curve];
    return !tree.boxes.empty() && this->meet(tree, 0, 0, static_cast<int>(tree.order.size()), box, visit);
  }

  const Eigen::AlignedBox3d& box(int curve) const { return this->Trees[curve].boxes[0]; }
  const FeatureCurves& curves() const { return this->Curves; }

private:
  struct Segment
  {
    Vector3 from, to, along;
    double square;     // of its length
    double begin, end; // arc lengths
  };
  // A node stands for segments order[begin], …, order[end - 1] and is halved; children of node i are 2 i + 1
  // and 2 i + 2.
  struct Tree
  {
    std::vector<int> order;
    std::vector<Segment> segments; // in that order
    std::vector<Eigen::AlignedBox3d> boxes;
  };
  static constexpr int leafSize = 4;

  template <class Visit>
  bool meet(const Tree& tree,
    int node,
    int begin,
    int end,
    const Eigen::AlignedBox3d& box,
    const Visit& visit) const
  {
    if (!tree.boxes[node].intersects(box))
    {
      return false;
    }
    if (end - begin <= leafSize)
    {
      return std::any_of(tree.order.begin() + begin, tree.order.begin() + end, visit);
    }
    const int middle = (begin + end) / 2;
    return this->meet(tree, 2 * node + 1, begin, middle, box, visit) ||
           this->meet(tree, 2 * node + 2, middle, end, box, visit);
  }
  void search(int curve, int node, int begin, int end, const Vector3& point, NearestOnCurve& best) const;
  void build(int curve, int node, int begin, int end);

  const FeatureCurves& Curves;
  std::vector<Tree> Trees;
};

} // namespace oversketch
#endif
