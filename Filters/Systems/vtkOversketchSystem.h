/**
 * @class vtkOversketchSystem
 * @brief base of every paper's system: named steps, run one after the other, and what hosts ask of it
 *
 * A system is one filter over many: it owns its steps, connects them, runs them by name and makes its output
 * of what they made. This base knows no step. It runs them, hears their errors and warnings, adds up their
 * progress, passes a cancel in, takes their times and finds their outputs.
 *
 * Before, during and after a run a host may ask for more: Prepare, Preview, GetHold, GetRegion, Figures,
 * Drag. A system that has nothing to say to one of them leaves it as it is here.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): one message, that of the step that failed, with its
 * failure; output empty. After AbortExecute the output is empty and the error code Cancelled; call Modified()
 * before the next Update.
 *
 * @sa vtkOversketchOneStroke vtkOversketchForEach
 */
#ifndef vtkOversketchSystem_h
#define vtkOversketchSystem_h

#include "OversketchFiltersSystemsModule.h" // For export macro
#include "vtkOversketchBackendFilter.h"

#include "Mesh/message.h" // for Remark

#include <functional> // for RunSystem
#include <set>        // for Warnings
#include <string>     // for Stage
#include <utility>    // for FigureList
#include <variant>    // for Figure
#include <vector>     // for Stages

class vtkPoints;

class OVERSKETCHFILTERSSYSTEMS_EXPORT vtkOversketchSystem : public vtkOversketchBackendFilter
{
public:
  vtkAbstractTypeMacro(vtkOversketchSystem, vtkOversketchBackendFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Where the last run ran: OpenCL or Host.
   */
  int GetBackendUsed() override { return Host; }

  /**
   * Computes what no stroke changes, so that the next Update need not: to be called while the hand is busy.
   * Reports progress and honours AbortExecute like a run; leaves the output as it is. Returns false where
   * there is nothing to compute, when it was stopped, or when the mesh cannot be used; then the error code
   * tells which (the next Update says it in words).
   */
  virtual bool Prepare() { return false; }

  /**
   * Finds what a stroke would take hold of, for a pen that is still down: on a mesh and a stroke of its own,
   * a polyline on the mesh. What it makes of mesh and view is kept, also for the next Update; a stroke of one
   * sample makes that alone. The output and the inputs stay as they are. False, and `hold` empty, where there
   * is nothing to take hold of or the call was stopped; the error code tells why.
   */
  virtual bool Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold);

  ///@{
  /**
   * Give what the last run took hold of, a polyline on the mesh that came in, and the triangles that it
   * moved, where they are now, as a mesh of its own without arrays. Empty after a run that failed, or where
   * the system has none.
   */
  virtual void GetHold(vtkPolyData* hold);
  virtual void GetRegion(vtkPolyData* region);
  ///@}

  /**
   * Remark on the last result because it is not as drawn, in words and figures; empty where there
   * is nothing to say and after a run that failed. A warning said the same during the run.
   * RemarkMessage has it as data.
   */
  const char* GetRemark() { return this->RemarkText.c_str(); }
  const oversketch::Message& RemarkMessage() const { return this->Remark; }

  /**
   * Figures that the system counted and measured of its last run, by names with dots where several belong
   * together ("match.points"): a switch, a count, a number (NaN where there is none), or a list of words.
   * Empty after a run that failed.
   */
  using Figure = std::variant<bool, vtkIdType, double, std::vector<std::string>>;
  using FigureList = std::vector<std::pair<std::string, Figure>>;
  virtual FigureList Figures() { return {}; }

  /**
   * Gives one figure of the last run as a number, by its name ("match.points"); NaN where it is no number or
   * absent, as after a run that failed.
   */
  double GetFigure(const char* name);

  /**
   * The output for a stroke moved by one vector [world], a preview: writes places into `points`, which are a
   * copy of the last output's points (same number, float or double). Neither the output nor the pipeline
   * changes: to keep the place, move the stroke and Update. False after a run that failed, where `points` do
   * not fit (both with an error), or where the system cannot be dragged.
   */
  virtual bool Drag(const double translation[3], vtkPoints* points);

  /**
   * Gives back what the last run computed and no other mesh can use, where that is much: factors, meshes
   * between the steps. The output stays; GetHold, GetRegion and Drag answer again after the next Update,
   * which makes the same anew. What Prepare and Preview made of mesh and view is kept.
   */
  virtual void ReleaseWork() {}

  ///@{
  /**
   * The names of all steps in their order, and a step by its name, to set parameters that the system does not
   * repeat or to read its counters; null for an unknown name.
   */
  int GetNumberOfStages() const { return static_cast<int>(this->Stages.size()); }
  const char* GetStage(int index) const;
  vtkAlgorithm* GetStep(const char* name);
  ///@}

  ///@{
  /**
   * The outputs of inner steps after the last run, by name; null when there is no such step, empty for steps
   * that did not run. Steps that repeat another one are not among the names. Not to be changed.
   */
  int GetNumberOfInnerOutputs() const;
  const char* GetInnerOutputName(int index) const;
  virtual vtkPolyData* GetInnerOutput(const char* name) { return this->StageOutput(name); }
  ///@}

  /**
   * Seconds that a step took in the last run, however often it executed, 0 where it did not.
   */
  double GetStageTime(const char* name) const;

  /**
   * Name of the running step, for progress displays; empty outside a run.
   */
  const char* GetStageName() const { return this->Running ? this->Running->Name.c_str() : ""; }

  /**
   * Includes the steps: a parameter set through GetStep makes the system run again.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkOversketchSystem() = default;
  ~vtkOversketchSystem() override = default;

  // To be called by heirs, which own their steps: in the order of the steps, with the share of the run that a
  // step takes, for progress. A step that repeats another one is no inner output of its own.
  enum class Listed
  {
    Yes,
    No
  };
  void AddStage(const char* name, vtkAlgorithm* step, double share, Listed listed = Listed::Yes);

  // The body of a RequestData: times and progress begin anew; see oversketch::RunFilter.
  int RunSystem(const std::function<void()>& body);
  // The same of a system that makes a mesh of the one on port 0; nothing where that has no points.
  using MeshBody = std::function<void(vtkPolyData* mesh, vtkPolyData* output)>;
  int RunOnMesh(vtkInformationVector** inputs, vtkInformationVector* outputs, const MeshBody& body);
  // Says of what the run makes that it is not as drawn, and tells it as a warning; an empty one says nothing.
  void SetRemark(const oversketch::Message& remark);
  // Runs a body outside a run: without an error event. Returns whether body returned true; where it threw,
  // the error code tells why.
  bool Try(const std::function<bool()>& body);
  // The same of Prepare, with the mesh of input 0, and of Preview; false where the mesh has no points.
  bool TryPrepare(const std::function<void(vtkPolyData* mesh)>& body);
  bool TryPreview(vtkPolyData* mesh,
    vtkPolyData* stroke,
    vtkPolyData* hold,
    const std::function<bool()>& body);
  // Wording of a step's error or warning as the system tells it.
  virtual oversketch::Message Said(const oversketch::Message& message) { return message; }
  // Says that the run goes through the steps so often; each time then counts for its part of the progress.
  void SetPasses(std::size_t passes) { this->Passes = passes; }
  // Runs a step, or does with it what is given. Throws its first error, or Cancelled.
  void RunStage(const char* name, const std::function<void()>& work = nullptr);
  // The output of a step by its own name.
  vtkPolyData* StageOutput(const char* name);
  // Data that an input port is given, brought up to date outside a run; null where that is nothing.
  vtkDataObject* UpdatedInput(int port);
  // The triangles of a mesh that have so many chosen corners at least, as GetRegion gives them.
  static void PutTriangles(vtkPolyData* mesh,
    const std::vector<char>& chosen,
    int corners,
    vtkPolyData* region);
  // The share of the run that is done [0 to 1].
  double GetDone() const { return this->Done; }

private:
  struct Stage
  {
    std::string Name;
    vtkAlgorithm* Step;
    double Share;
    Listed IsListed;
    double Seconds = 0.0;
  };
  const Stage* Find(const char* name) const;
  const Stage* FindListed(int index) const;

  std::vector<Stage> Stages;
  const Stage* Running = nullptr;
  double Done = 0.0;
  std::size_t Passes = 1;
  bool Timed = false;                     // in a run, not while something is prepared
  std::set<oversketch::Message> Warnings; // of this run
  oversketch::Message Remark;
  std::string RemarkText;
};

#endif
