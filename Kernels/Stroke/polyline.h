// Polylines in the image plane: lengths, places on them, the nearest place, uniform sampling.
#ifndef oversketch_kernels_stroke_polyline_h
#define oversketch_kernels_stroke_polyline_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

using Polyline = std::vector<Vector2>;

// Whether all of them are finite, and whether two of them differ.
bool allFinite(const Polyline& points);
bool differs(const Polyline& points);

// The place (1 - t) from + t to between two points of a polyline; from == to names a point itself.
struct Blend
{
  int from = 0, to = 0;
  double t = 0.0;

  static Blend point(int i) { return { i, i, 0.0 }; }
  template <typename Value>
  Value of(const std::vector<Value>& values) const
  {
    return (1.0 - this->t) * values[this->from] + this->t * values[this->to];
  }
};

// Length from the first point to each point; a closed polyline (its first point not repeated) has one entry
// more, its whole length.
template <typename Point>
std::vector<double> arcLengths(const std::vector<Point>& points, bool closed = false)
{
  std::vector<double> lengths;
  lengths.reserve(points.size() + 1);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    lengths.push_back(i == 0 ? 0.0 : lengths.back() + (points[i] - points[i - 1]).norm());
  }
  if (closed && !points.empty())
  {
    lengths.push_back(lengths.back() + (points.front() - points.back()).norm());
  }
  return lengths;
}

// Whether the line from a place to the right passes between two others: it does so an odd number of times
// with the sides of a polygon that holds the place.
inline bool passesRight(const Vector2& place, const Vector2& a, const Vector2& b)
{
  return (a[1] > place[1]) != (b[1] > place[1]) &&
         place[0] < a[0] + (b[0] - a[0]) * (place[1] - a[1]) / (b[1] - a[1]);
}

// The place at a length along the polyline, clamped to its ends. lengths comes from arcLengths.
Blend placeAt(const std::vector<double>& lengths, int pointCount, double length);
// Those at i / steps of the whole length, i from 0 to steps.
std::vector<Blend> evenPlaces(const std::vector<double>& lengths, int pointCount, int steps);

// Places at equal lengths, as near to spacing as an integer number of steps allows; both ends are among them.
std::vector<Blend> uniformPlaces(const Polyline& points, double spacing);
Polyline uniformPolyline(const Polyline& points, double spacing);

// Answers which place of a polyline is nearest to a point. Segments are kept in blocks of consecutive ones
// with their bounding boxes, since neighbours on a curve are neighbours in the plane: most blocks are ruled
// out by their box.
class NearestPlace
{
public:
  struct Answer
  {
    int segment = -1;      // from point `segment` to the next
    double t = 0.0;        // in [0, 1] along it
    double distance = 0.0; // infinite for an empty polyline
    Vector2 place = Vector2::Zero();

    // Length up to it; lengths comes from arcLengths.
    double along(const std::vector<double>& lengths) const
    {
      return lengths[this->segment] + this->t * (lengths[this->segment + 1] - lengths[this->segment]);
    }
  };

  explicit NearestPlace(const Polyline& points, bool closed = false);
  // Takes the first along the polyline of several nearest places; no place farther than `limit` is found
  // (segment -1).
  Answer operator()(const Vector2& point, double limit = std::numeric_limits<double>::infinity()) const;
  // Mean distance of the points to the polyline.
  double meanDistance(const Polyline& points) const;

private:
  struct Block
  {
    Eigen::AlignedBox2d box;
    int begin, end; // segments
  };
  std::vector<Vector2> Starts, Steps;
  std::vector<Block> Blocks;
};

} // namespace oversketch
#endif
