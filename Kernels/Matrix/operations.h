// Operations on handles along a curve: drags of a handle's axes, and operations written as text and as rows
// that a hand changes one by one.
#ifndef oversketch_kernels_matrix_operations_h
#define oversketch_kernels_matrix_operations_h

#include "Matrix/frames.h"
#include "Matrix/logarithm.h"

#include <functional>
#include <string>
#include <vector>

namespace oversketch
{

enum class HandleAxis
{
  Along,
  Side,
  Outward
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 3.5 and chapter 7: a
// handle's frame is moved along one of its axes, scaled along it or turned about it, about the frame's
// origin. The thesis prints T(-c) T S R T(c) with T(c) moving to the origin; what is meant is T(c) T S R
// T(-c), in the frame's axes.
//
// Each is one elementary transformation, so that it has a logarithm: several at once are their logarithms'
// sum. A scaling by 4 after a turn by 150 degrees has none. All throw Error(Failure::BadStroke) for a number
// that is not finite.
Matrix4 movedAlong(const CurveFrame& frame, HandleAxis axis, double length);
// A factor above 0; from 0.05 to 20 what a drag gives.
Matrix4 scaledAlong(const CurveFrame& frame, HandleAxis axis, double factor);
// Counter-clockwise seen from the axis's tip; less than 180 degrees either way.
Matrix4 turnedAbout(const CurveFrame& frame, HandleAxis axis, double degrees);

enum class Verb
{
  Move,
  Scale,
  Rotate,
  Pin,
  Drag // of the curve as a whole
};

struct Operation
{
  Verb verb = Verb::Pin;
  double t = 0.0;      // share of the curve's length
  int axis = 0;        // t, w, n
  double amount = 0.0; // length, factor or degrees; of a drag to the right [px]
  double up = 0.0;     // of a drag [px]
};

inline constexpr const char* verbNames[] = { "move", "scale", "rotate", "pin", "drag" };
inline constexpr const char* axisNames = "twn";

// A handle at a share t of the curve's length, and what was made of it there.
struct PlacedHandle
{
  double t = 0.0;
  CurveFrame frame; // at its place
  Matrix4 matrix = Matrix4::Identity();
};

// "move 0.5 n 0.1; rotate 0.7 t 30; scale 0.3 w 1.5; pin 0.2", apart by semicolons: of the handle at that
// share of the curve's length the length along, the degrees about, the factor along one of its axes, t along
// the curve, w beside it, n outward. A pin does nothing, and so ends what its neighbours do. One handle for
// each operation, in their order; several may be at one place. "drag 12 -5" moves the curve as a whole, so
// many pixels to the right and up in the view that it was drawn in; it is no handle.
//
// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", chapters 4 and 7. The text
// is ours.
//
// frameAt: the curve's frame at a share of its length. shiftOf: what a drag [px] is in the world; null where
// the curve has no view. Throws Error(Failure::BadStroke), which names the operation by number and text, and
// the remedy, for what cannot be read, a share outside [0, 1], a drag without a view, and what movedAlong,
// scaledAlong and turnedAbout refuse.
struct OperatedHandles
{
  std::vector<PlacedHandle> handles;
  Vector3 shift = Vector3::Zero(); // the sum of all drags [world]
};
OperatedHandles handlesOf(const std::string& operations,
  const std::function<CurveFrame(double t)>& frameAt,
  const std::function<Vector3(const Vector2& pixels)>& shiftOf = nullptr);

// Operations as the text says them; throws alike, but for what frames and views refuse. And the text of some,
// numbers to six digits.
std::vector<Operation> operationsOf(const std::string& text);
std::string operationText(const std::vector<Operation>& rows);
// Words for one of them: "moved outward 0.1", "turned 54°".
std::string operationWords(const Operation& row);

// The row of a handle's axis by a further amount: the same axis again changes its row, another one makes one,
// which takes the place of the handle's pin. A length and an angle add up, a factor multiplies; within what
// is allowed: 179 degrees, factors from 0.05 to 20.
void operate(std::vector<Operation>& rows, Verb verb, double t, int axis, double amount);

// The places of handles, ascending, each once; a drag has none.
std::vector<double> handlePlaces(const std::vector<Operation>& rows);

// Adds what moves all of the curve alike: what falls from 1 at each handle's place to 0 at its neighbours'
// sums up to 1 everywhere, so one handle with the shift at each place, at the middle where there is none.
void shiftAll(std::vector<PlacedHandle>& handles,
  const Vector3& shift,
  const std::function<CurveFrame(double t)>& frameAt);

// A transformation given in the frame's own coordinates (along, side, outward, from its origin), in the
// world's.
Matrix4 inWorld(const CurveFrame& frame, const Matrix4& local);

// The frame as the transformation from its coordinates to the world's.
Matrix4 matrixOf(const CurveFrame& frame);

} // namespace oversketch
#endif
