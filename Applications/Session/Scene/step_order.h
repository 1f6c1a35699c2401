// Which order the steps of a model can have: one that takes what another makes comes after it.
#ifndef oversketch_applications_session_scene_step_order_h
#define oversketch_applications_session_scene_step_order_h

#include "session.h"

#include <cstddef>
#include <vector>

namespace oversketch_session
{

// A step that would stand before one that it needs, by their places in the list; both -1 where there is none.
// The one that it needs is a step whose output it takes, or, in a model that began without a mesh, the first
// step, which made one.
struct OrderFault
{
  int step = -1, needed = -1;
  explicit operator bool() const { return this->step >= 0; }
};

// The history with the step at `from` at `to`; those between move by one.
std::vector<Node> moved(std::vector<Node> nodes, std::size_t from, std::size_t to);

// Tells what would be wrong with that; places are those of the history as it is.
OrderFault faultOfMove(const Model& model, std::size_t from, std::size_t to);

} // namespace oversketch_session
#endif
