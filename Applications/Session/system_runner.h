// One system, and the steps that it runs one after the other.
#ifndef oversketch_system_runner_h
#define oversketch_system_runner_h

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

// Who wants to know of a run; each may be absent.
struct Listener
{
  std::function<bool()> cancelled;                                      // polled while it runs; true ends it
  std::function<void(const std::string& stage, double share)> progress; // share of the step [0 to 1]
  std::function<void(const std::string& message)> warning;
};

class SystemRunner
{
public:
  explicit SystemRunner(const SystemRow& row);
  ~SystemRunner();
  SystemRunner(const SystemRunner&) = delete;
  SystemRunner& operator=(const SystemRunner&) = delete;

  // What the row's inputs hold, by their names.
  using Data = std::map<std::string, vtkSmartPointer<vtkDataObject>>;

  // Runs a step. Fills in mesh or failure, place, those output ports and back end of the outcome, whose mesh
  // is the one that came. False when cancelled: nothing is filled in.
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

  vtkOversketchSystem* system() { return this->System; }

private:
  void feed(const Step& step, const Data& inputs);
  void setValues(const Step& step);
  void setMirror(const MirrorPlane& plane, const Data& inputs, const std::optional<Section>& section);
  std::shared_ptr<const Following> following(vtkPolyData* made, const std::function<bool()>& cancelled);

  const SystemRow& Row;
  vtkSmartPointer<vtkOversketchSystem> System;
  vtkSmartPointer<vtkOversketchMirror> Mirror; // of the last step, where it has one
};

} // namespace oversketch_session
#endif
