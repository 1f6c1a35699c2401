// Relocation of edge snaxels, eight at a time, as far as that takes no search. A part of the snake.
#ifndef oversketch_kernels_silhouette_relocation_h
#define oversketch_kernels_silhouette_relocation_h

#include "Silhouette/edge_smoothness.h"

#include <cstdint>

namespace oversketch
{

// Share of an edge: nearer to its end is on the vertex. A curve can creep up to a vertex for ever; much
// nearer, rounding, and so how the model is turned, would decide when it arrives.
constexpr double endTolerance = 1e-4;

// A place on an edge at t from its first end.
struct EdgePoint
{
  double weight; // of the first end
  Triple position, normal;
  double squared; // length of the normal before it was made a unit

  EdgePoint(double t, const Triple& p0, const Triple& p1, const Triple& n0, const Triple& n1)
    : weight(1.0 - t)
    , position(this->weight * p0 + (1.0 - this->weight) * p1)
    , normal(this->weight * n0 + (1.0 - this->weight) * n1)
    , squared(this->normal.dot(this->normal))
  {
    this->normal = (1.0 / (this->squared > 0.0 ? std::sqrt(this->squared) : 1.0)) * this->normal;
  }
};

// Moves of up to eight snaxels, each between neighbours that stay. One visit has to wait for the one
// before it along a curve; those of several parts of it wait together.
class Relocations
{
public:
  static constexpr int lanes = 8;

  struct Vectors
  {
    double x[lanes] = {}, y[lanes] = {}, z[lanes] = {};

    Triple operator[](int i) const { return { this->x[i], this->y[i], this->z[i] }; }
    template <typename Vector>
    void set(int i, const Vector& v)
    {
      const Triple t(v);
      this->x[i] = t.x;
      this->y[i] = t.y;
      this->z[i] = t.z;
    }
  };

  // Input: the snaxels.
  Vectors before, after;                    // the neighbours' places
  Vectors at, normal;                       // their own
  Vectors ends[2], endNormals[2];           // of their edges
  double low[lanes] = {}, high[lanes] = {}; // the part of the edge with E_geo < epsilon

  // Result.
  enum Verdict : std::int64_t
  {
    Stays,
    Moves, // to where the curve is straight
    Unclear
  };
  struct Found
  {
    Verdict verdict[lanes] = {};
    double weight[lanes] = {}; // of the edge's first end
    Vectors position, normal;
  } found;

  // d(v) = towards - share v.
  void find(const Triple& towards, double share, double epsilon);
};

} // namespace oversketch
#endif
