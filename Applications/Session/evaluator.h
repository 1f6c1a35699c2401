// Runs a session: the mesh goes through the strokes that are on, one after the other.
#ifndef oversketch_evaluator_h
#define oversketch_evaluator_h

#include "session.h"

#include <array>
#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <vector>

class vtkOversketchOneStroke;

namespace oversketch_session
{

// How a node's mesh follows while its stroke is moved by hand, a preview: point points[i] goes by the sum of
// the vector's x, y, z [world] times the three vectors of moves[i].
struct Following
{
  vtkIdType count = 0; // of the mesh's points
  std::vector<vtkIdType> points;
  std::vector<std::array<float, 9>> moves;
};

// What a node made.
struct Outcome
{
  vtkSmartPointer<vtkPolyData> mesh; // where the node is off or failed: the mesh as it came to it
  std::string failure;               // why it did nothing; empty when it acted or is off
  // Where it took hold, with the polyline itself; absent where it did nothing.
  std::optional<Section> section;
  vtkSmartPointer<vtkPolyData> matched;
  // The part of the mesh that it moved, as a mesh of its own, and how it follows; null where it did nothing.
  vtkSmartPointer<vtkPolyData> region;
  std::shared_ptr<const Following> following;
  // True when that is another place than when it was committed: its middle is further from the committed one
  // than half the length of the shorter of both.
  bool elsewhere = false;
};

class Evaluator
{
public:
  // Keeps outcomes of strokes that someone still holds (a session, a history), up to a sum of about that many
  // bytes, the least recently used go first; those of the session being run stay in any case.
  explicit Evaluator(std::size_t bytes = std::size_t(2) << 30);
  ~Evaluator();
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  struct Watch
  {
    // Polled while a stroke runs; true ends the run.
    std::function<bool()> cancelled;
    // Node, stage and share done of the node [0 to 1].
    std::function<void(std::size_t node, const std::string& stage, double share)> progress;
  };

  // One outcome a node. A node that fails is passed by, with its reason; the rest goes on. What was run
  // before for the same strokes in the same order on the same mesh is not run again. The same session gives
  // the same bits, whatever is kept. Returns false when it was cancelled: outcomes are those of the nodes
  // before.
  bool run(const Session& session, const Watch& watch, std::vector<Outcome>& outcomes);

  // Computes what the next stroke on this mesh will need whatever it is, until cancelled. Nothing depends on
  // it but time.
  void prepare(vtkPolyData* mesh, const Watch& watch);

  // Strokes run since the start, to see what was kept.
  std::size_t runs() const { return this->runs_; }
  // The system that runs them, for what is shown of the last stroke: its inner outputs.
  vtkOversketchOneStroke* system();

private:
  // What an outcome depends on: the actions up to it that are on.
  struct Key
  {
    SharedData mesh;
    int backend = 0;
    std::vector<std::weak_ptr<const Action>> actions;

    bool operator==(const Key& other) const;
    bool canComeAgain() const; // nobody makes an action twice
  };
  struct Kept
  {
    Key key;
    Outcome outcome;
    std::size_t bytes = 0;
  };

  const Outcome* find(const Key& key);
  // Gives up the least recently used beyond the budget, but not the first inUse.
  void keep(const Key& key, const Outcome& outcome, std::size_t inUse);
  bool runOne(const Action& action,
    vtkPolyData* mesh,
    std::size_t node,
    const Watch& watch,
    Outcome& outcome);

  vtkSmartPointer<vtkOversketchOneStroke> system_;
  std::list<Kept> kept_; // the most recently used first
  std::size_t budget_;
  std::size_t runs_ = 0;
};

// The mesh that a session shows: what its last node made.
vtkPolyData* resultOf(const Session& session, const std::vector<Outcome>& outcomes);

} // namespace oversketch_session
#endif
