// The inside of vtkOversketchSession: a session with its history, what runs it, and the result that is shown.
#ifndef oversketch_applications_session_module_session_state_h
#define oversketch_applications_session_module_session_state_h

#include "background_run.h"
#include "history.h"
#include "models.h"
#include "pieces.h"
#include "session_file.h"
#include "step_values.h"

#include "vtkImageData.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace oversketch_session
{

// Begins with a step that makes a mesh. Throws oversketch_files::Failed where this build cannot run it.
Session begunWith(const std::shared_ptr<const Step>& step, const std::string& name);
// A new step at the end of those of a model.
Node nodeOf(const Step& step, const Model& model);

// All that throws throws Failed, and nothing is changed then.
class SessionState
{
public:
  SessionState() { this->Changes.markSaved(); }

  const Session& now() const { return this->Changes.now(); }

  void begin(Session session, std::optional<Look> look = {});
  // One step of undo, where it changes steps.
  void commit(Session next);
  // Changes the step with that id, by its place, as one step of undo; it becomes another.
  void edit(int id, const std::function<void(Session& next, std::size_t row)>& edit);
  void change(int id, const std::function<Step(const Step&)>& change, bool takesHoldAnew = false);
  // Goes one step of undo back, or forth.
  void goTo(bool back);
  void choose(std::size_t place);

  void start();
  void run();
  // Takes a result that has come.
  bool poll();
  // Tells whether the result is that of the steps as they are.
  bool isCurrent() const;
  // The deeds of a step as they are shown; null where it is another by now.
  const Worker::NodeState* stateOf(const Node& node) const;

  // The mesh that is shown, and what is made of it when it is asked for.
  const SharedData& shown() const { return this->Shown.mesh ? this->Shown.mesh : this->now().mesh; }
  vtkPolyData* mesh();
  const std::string& digest();
  const std::vector<oversketch_files::Piece>& pieces();
  vtkImageData* picture(int piece);

  SessionFile file();
  // Gives what an export writes; null where there is none yet.
  vtkSmartPointer<vtkPolyData> whole() const;

  History Changes{ Session() };
  std::optional<Look> Seen;
  std::map<std::string, GivenInput> Given; // for the next step
  Model Asked;                             // that was started last
  BackgroundRun Background;
  // Texts and lines that the last call has handed out.
  std::string Message, Steps, Stage;
  vtkSmartPointer<vtkPolyData> StepLines;

private:
  void show(Worker::Result result);
  void turn(const RestingModel* resting);
  void turnFrom(const Session& before);

  Worker::Result Shown;    // the newest
  Model Ran;               // of which it is
  std::uint64_t First = 0; // ticket of the chosen model; what comes before is of another
  vtkSmartPointer<vtkPolyData> Mesh;
  std::string Digest;
  std::optional<std::vector<oversketch_files::Piece>> Pieces;
  std::map<int, vtkSmartPointer<vtkImageData>> Pictures;
};

} // namespace oversketch_session
#endif
