// Runs a model: the mesh goes through the steps that are on, one after the other.
#ifndef oversketch_applications_session_run_evaluator_h
#define oversketch_applications_session_run_evaluator_h

#include "outcome.h"
#include "systems.h"

#include "vtkImageData.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace oversketch_session
{

class Evaluator
{
public:
  // Keeps outcomes of steps that someone still holds (a session, a history), up to a sum of about that many
  // bytes, the least recently used go first; those of the model being run stay in any case. Steps name
  // systems of that list, which must outlive it.
  explicit Evaluator(std::size_t bytes = std::size_t(2) << 30,
    const std::vector<SystemRow>& rows = systems());
  ~Evaluator();

  struct Watch
  {
    // Polled while a step runs; true ends the run.
    std::function<bool()> cancelled;
    // Node, stage and share done of the node [0 to 1].
    std::function<void(std::size_t node, const std::string& stage, double share)> progress;
    // Whether details() will be called for all nodes.
    bool details = false;
  };

  // One outcome a node. A node that fails is passed by, with its reason; the rest goes on. What was run
  // before for the same steps in the same order on the same mesh is not run again. The same model gives the
  // same bits, whatever is kept. Returns false when it was cancelled: outcomes are those of the nodes before.
  bool run(const Model& model, const Watch& watch, std::vector<Outcome>& outcomes);

  // Fills in after the meshes the details of those outcomes of the last run that acted. Where the
  // run was not watched for them, only of the last that each system ran. Returns false when it was cancelled:
  // some are missing, and come with the next call for this model.
  bool details(std::vector<Outcome>& outcomes, const Watch& watch);

  // Gives back the work of the last steps, which their outcomes and another mesh do not need. To be called
  // once their details are there.
  void releaseWork();

  // Computes what the next step of a system on this mesh will need whatever it is, until cancelled. Nothing
  // depends on it but time.
  void prepare(const SystemRow& row, vtkPolyData* mesh, int backend, const Watch& watch);

  // Steps run since the start, to see what was kept.
  std::size_t runs() const { return this->Runs; }
  // The instance that runs a system's steps, for what is shown of the last one: its inner outputs. Null where
  // the list has no such system.
  vtkOversketchSystem* system(const std::string& name);

private:
  // The things that an outcome depends on. Numbers are those of outcomes.
  struct Place
  {
    std::weak_ptr<const void> made;    // the step, or the mesh that was opened; nobody makes one twice
    std::vector<std::uint64_t> inputs; // what it takes: the mesh before it and what it refers to
    int backend = 0;

    bool operator<(const Place& other) const;
  };
  struct Kept
  {
    Place place;
    std::optional<Outcome> outcome; // absent where it was given up: the number is known
    std::size_t bytes = 0;
    std::uint64_t used = 0; // by which run
  };
  // A run on its way.
  struct Run;
  // Who runs a system's steps, and whose outcome its last one is.
  struct Runner;
  // The mesh that the step of a part made, before it was put at its place.
  struct UnplacedPart
  {
    Step step;
    int backend = 0;
    Outcome outcome;
  };
  using Inputs = std::map<std::string, vtkSmartPointer<vtkDataObject>>;

  Runner* runner(const std::string& name);
  std::uint64_t numberOf(const Place& place);
  static std::size_t bytesOf(const Outcome& outcome);
  void forget(); // what cannot come again
  void giveUp(); // what is beyond the budget
  bool runNode(Run& run);
  // Runs the node's step and fills in its outcome. False when cancelled.
  bool make(Run& run);
  // Makes that of a part, beside the mesh that came. What was made of the same drawing is not made again when
  // the part is put elsewhere or that mesh changes.
  bool makePart(Run& run);
  // Why the node's step cannot be run, or empty, with its inputs, and the numbers of the outcomes that they
  // are.
  std::string resolve(Run& run, std::vector<std::uint64_t>& numbers);
  // Makes the details of the last that it ran, where they are missing; false when cancelled.
  bool finish(Runner& runner, const std::function<bool()>& cancelled);
  vtkSmartPointer<vtkImageData> imageOf(const Image& image, SystemInput::Kind kind);

  const std::vector<SystemRow>& Rows;
  std::map<std::string, std::unique_ptr<Runner>> Runners; // by system
  std::map<int, UnplacedPart> Parts;                      // by node
  std::map<std::uint64_t, Kept> Outcomes;                 // what an outcome takes comes before it
  std::map<Place, std::uint64_t> Numbers;
  using Images = std::map<SystemInput::Kind, vtkSmartPointer<vtkImageData>>;
  std::map<std::weak_ptr<const std::string>, Images, std::owner_less<>> Pictures;
  std::size_t Budget;
  std::uint64_t Last = 0, RunCount = 0;
  std::size_t Runs = 0;
};

// The mesh that a model shows: what its last node made. Null where there is none yet.
vtkPolyData* resultOf(const Model& model, const std::vector<Outcome>& outcomes);

// Where it was made: OpenCL where any step ran there, else Host (vtkOversketchSystem::BackendType).
int backendUsedBy(const std::vector<Outcome>& outcomes);

} // namespace oversketch_session
#endif
