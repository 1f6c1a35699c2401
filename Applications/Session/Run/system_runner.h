// One system, and the steps that it runs one after the other.
#ifndef oversketch_applications_session_run_system_runner_h
#define oversketch_applications_session_run_system_runner_h

#include "outcome.h"
#include "systems.h"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

class vtkOversketchMirror;

namespace oversketch_session
{

class MirrorImage;

// Who wants to know of a run; each may be absent.
struct Listener
{
  std::function<bool()> cancelled;                                      // polled while it runs; true ends it
  std::function<void(const std::string& stage, double share)> progress; // share of the step [0 to 1]
};

class SystemRunner
{
public:
  explicit SystemRunner(const SystemRow& row);
  ~SystemRunner();

  // Data of the row's inputs, by their names.
  using Data = std::map<std::string, vtkSmartPointer<vtkDataObject>>;

  // Runs a step. Fills in mesh or failure, place, those output ports and back end of the outcome, whose mesh
  // is the one that came. False when cancelled: nothing is filled in.
  //
  // A step with a mirror plane, of a system that takes several strokes, runs once on each stroke and the same
  // in the mirror; where the first one lies over the plane itself, on the strokes alone. Of a system that
  // says so (Mirroring::TwoRuns) it runs on one side and then on the other, as below. Of another one it runs
  // with the values that keep points' ids (SystemRow::keepingPoints), and points on the other side follow
  // their partners (vtkOversketchMirror). Where a point that moved has none, or that run fails, the step runs
  // with its own values, and once more on the other side, as if its strokes had been
  // drawn in the mirror. That run works on the mesh's mirror image with what the step is given as it is, and
  // what comes of it is mirrored back: the same thing, but strokes, their views and pictures over them need
  // not be turned round, and the two sides do not differ by what has a handedness inside (the rays' spiral,
  // the direction of curves).
  // - Where the system moved points alone, and none on both sides, both runs start from the mesh that came:
  //   the one does not see what the other did, and sides that are alike come out alike. Else the other side
  //   is run on what the first one made, where its stroke then ends up as it was drawn.
  // - A stroke over the plane itself acts once (crossesMirrorPlane, two_sides.h), and so does one that in the
  // mirror
  //   takes hold of the same place (isSamePlace).
  // - The place and the ports are those of the side that was drawn on. A failure of the other one is the
  //   step's; its message, as a warning's, begins with that side ("mirrored to x < 0: ").
  bool run(const Step& step,
    const Data& inputs,
    int backend,
    const std::set<int>& ports,
    const Listener& listener,
    Outcome& outcome);

  // Region and following of the last step that was run, whose mesh that is. Null when cancelled.
  std::shared_ptr<const Details> details(vtkPolyData* made, const std::function<bool()>& cancelled);

  // Computes what the next step on this mesh will need whatever it is, until cancelled. Nothing depends on it
  // but time.
  void prepare(vtkPolyData* mesh, int backend, const Listener& listener);

  // Gives back what no other mesh can use of the last step's work; there are no details of it any more.
  void releaseWork();

  vtkOversketchSystem* system() { return this->System; }

private:
  // All that a run is given.
  struct Task
  {
    const Step& step;
    const Data& inputs;
    int backend;
    const std::set<int>& ports;
    const Listener& listener;
  };
  // Runs the side that was drawn on alone, with those values. False when cancelled, as the others.
  bool runOnce(const Task& task, const Values& values, double from, double to, Outcome& outcome);
  bool runTwice(const Task& task, Outcome& outcome);
  bool runReflected(const Task& task, Outcome& outcome);
  // Runs the mesh's image in the mirror.
  bool runImage(const Task& task, const MirrorImage& image, Outcome& outcome);
  // Gives the outcome's mesh the other side by points' partners; false where they have none.
  bool followPartners(const Task& task, Outcome& outcome);

  void feed(const Values& values, const Data& inputs);
  std::shared_ptr<const Following> following(vtkPolyData* made, const std::function<bool()>& cancelled);

  const SystemRow& Row;
  vtkSmartPointer<vtkOversketchSystem> System;
  // Memory of the last step: what points follow their partners by, or what either side made; at most one of
  // both.
  vtkSmartPointer<vtkOversketchMirror> Mirror;
  struct TwoSides;
  std::unique_ptr<TwoSides> Sides;
  std::unique_ptr<SystemRunner> Image; // runs the other sides, with an instance of its own
};

} // namespace oversketch_session
#endif
