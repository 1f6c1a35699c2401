// Runs models on a thread of its own, so that an interface never waits: the newest wins.
#ifndef oversketch_applications_session_run_worker_h
#define oversketch_applications_session_run_worker_h

#include "evaluator.h"
#include "parts.h"
#include "session.h"
#include "thumbnail.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace oversketch_session
{

class Worker
{
public:
  // The deeds of one node, for the history.
  struct NodeState
  {
    SharedData before;                       // the mesh that comes to it; null where there is none
    std::map<std::string, SharedData> given; // what it takes of other steps, by its inputs' names
    oversketch::Message failure, remark;     // see Outcome
    std::optional<Section> section;
    SharedData hold; // the place itself, a polyline; null where it did nothing
    bool elsewhere = false;
    // The part that it moved, and how that follows while the stroke is moved by hand; null where it did
    // nothing, and before the details have come.
    SharedData region;
    std::shared_ptr<const Following> following;
    double share = 0.0; // of its mesh's area that it moved
    // The model after it; null where it did nothing, and before it was drawn (Listener::pictured).
    std::shared_ptr<const Thumbnail> picture;
  };
  // The result of a model. The worker goes on with the meshes' points and cells, and changes none.
  struct Result
  {
    std::uint64_t ticket = 0;
    std::vector<NodeState> nodes;
    SharedData mesh;      // that the model shows; null where it has made none yet
    SharedData display;   // the same with point normals, computed where it has none
    PartSources parts;    // of it
    int backendUsed = 0;  // vtkOversketchSystem::BackendType
    double seconds = 0.0; // that the run took
  };
  // The details that come after it, while the mesh is being shown.
  struct Details
  {
    std::uint64_t ticket = 0;
    std::vector<NodeState> nodes; // those of the result, whole
    std::string digest;           // digestOf(mesh); empty where there is no mesh
  };
  // Called on the worker's thread. Each model is answered once: done, or cancelled where a newer one
  // replaced it or it was cancelled. Details follow on done once it has been seen, or after a while, unless
  // something newer is to be run first.
  struct Listener
  {
    std::function<void(Result)> done = [](const Result&) {};
    std::function<void(Details)> detailed = [](const Details&) {};
    std::function<void(std::uint64_t ticket)> cancelled = [](std::uint64_t) {};
    std::function<void(std::uint64_t ticket, std::size_t node, const std::string& stage, double share)>
      progress = [](std::uint64_t, std::size_t, const std::string&, double) {};
    // The mesh of a model that was only looked at, as Result::display; null where it makes none.
    std::function<void(SharedData)> evaluatedAside;
    // While nothing else is to be run, after all that: each step's stroke on the mesh that the model shows
    // (strokeOn; null where there is none), and, one by one, the pictures that are missing.
    std::function<void(std::uint64_t ticket, std::vector<SharedData> lines)> traced;
    std::function<void(std::uint64_t ticket, std::size_t node, std::shared_ptr<const Thumbnail>)> pictured;
  };

  explicit Worker(Listener listener);
  // Cancels what runs and waits for it.
  ~Worker();

  // Runs it as soon as it can, instead of what runs or waits; then prepares its result for the next step.
  // The model's data must not be changed afterwards. Returns the ticket, one more than the last.
  std::uint64_t submit(Model model);
  // The result of a ticket is on screen: what comes after it may take the processors.
  void seen(std::uint64_t ticket);
  // Stops what runs or waits, if anything does.
  void cancel();
  // Sets the number of triangles above which a step's work is not kept for a stroke over the same place,
  // which then makes it anew: it takes some 400 bytes each. For the next model; 500,000 by default.
  void keepWorkUpTo(vtkIdType triangles) { this->MostKept = triangles; }
  // Makes the mesh of another model, once nothing else is to be done, and nothing more: of the steps of the
  // last one it is there. The newest such asking wins, and what is submitted before it.
  void evaluateAside(Model model);

private:
  void work();
  void runOne(std::uint64_t ticket, const Model& model);
  void runAside(std::uint64_t ticket);
  // Fills in both meshes.
  void show(vtkPolyData* mesh, Result& result);
  // Copies the outcomes; of those that were copied for the last model the same ones.
  std::vector<NodeState> statesOf(const Model& model, const std::vector<Outcome>& outcomes);
  // Makes what is shown of the steps beside the mesh, until something else is to be done.
  void trace(std::uint64_t ticket,
    const Model& model,
    const std::vector<Outcome>& outcomes,
    vtkPolyData* shown);
  void picture(std::uint64_t ticket,
    const Model& model,
    const std::vector<Outcome>& outcomes,
    const std::function<bool()>& cancelled);

  Listener Report;
  Evaluator Runner;
  std::map<std::uint64_t, NodeState> Copied; // by the outcomes' numbers
  // Likewise, also of steps that are off or undone for now.
  std::map<std::uint64_t, std::shared_ptr<const Thumbnail>> Pictures;
  vtkSmartPointer<vtkPolyData> Shown, Display; // the last mesh, and the same with normals
  std::mutex Mutex;
  std::condition_variable Wake;
  std::optional<Model> Next, Running, Aside;
  std::uint64_t Ticket = 0;                  // of the newest model
  std::uint64_t Seen = 0;                    // of the newest result that was
  std::atomic<std::uint64_t> Wanted{ 0 };    // the ticket that may run; all others are to stop
  std::atomic<bool> Waiting{ false };        // a model does, so nothing is to be prepared
  std::atomic<vtkIdType> MostKept{ 500000 }; // triangles
  bool Stop = false;
  std::thread Thread;
};

} // namespace oversketch_session
#endif
