// The outcome of a step of a session.
#ifndef oversketch_applications_session_run_outcome_h
#define oversketch_applications_session_run_outcome_h

#include "session.h"

#include "Mesh/message.h"

#include "vtkDataObject.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace oversketch_session
{

// How a step's mesh follows while its stroke is moved by hand, a preview: point points[i] goes by the sum of
// the vector's x, y, z [world] times the three vectors of moves[i].
struct Following
{
  vtkIdType count = 0; // of the mesh's points
  std::vector<vtkIdType> points;
  std::vector<std::array<float, 9>> moves;
};

// The things that an interface shows of a step besides its mesh.
struct Details
{
  vtkSmartPointer<vtkPolyData> region;        // the part of the mesh that it moved, as a mesh of its own
  std::shared_ptr<const Following> following; // null where the system cannot be dragged
};

struct Outcome
{
  // Where the step is off or failed: the mesh as it came to it, which is null before there is one.
  vtkSmartPointer<vtkPolyData> mesh;
  // The output ports but 0 that later steps of the session refer to.
  std::map<int, vtkSmartPointer<vtkDataObject>> outputs;
  oversketch::Message failure; // why it did nothing; empty when it acted or is off
  // Warnings of its system, with the one of a result that is not as drawn (vtkOversketchSystem::GetRemark).
  std::vector<oversketch::Message> remarks;
  // Where it took hold, with the polyline itself; absent where it did nothing, or its system takes hold of
  // nothing.
  std::optional<Section> section;
  vtkSmartPointer<vtkPolyData> hold;
  // True when that is another place than when it was committed: its middle is further from the committed one
  // than half the length of the shorter of both.
  bool elsewhere = false;
  int backendUsed = 0; // vtkOversketchSystem::BackendType; 0 where it did nothing
  // Equal numbers, equal outcomes; 0 where it did nothing.
  std::uint64_t number = 0;
  std::shared_ptr<const Details> details; // see Evaluator::details
};

} // namespace oversketch_session
#endif
