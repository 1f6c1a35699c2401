// The work that the window shows and changes: a session with its history, kept on the disk and run in the
// background.
#ifndef oversketch_applications_studio_document_document_h
#define oversketch_applications_studio_document_document_h

#include "autosave.h"
#include "drawing_lines.h"
#include "history.h"
#include "large_mesh.h"
#include "opened_file.h"
#include "worker.h"

#include <QObject>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace oversketch_studio
{

// Qt's lists count in int.
inline std::size_t indexOf(int row)
{
  return static_cast<std::size_t>(row);
}

class Document : public QObject
{
  Q_OBJECT

public:
  // Throws Failed where autosaves cannot be kept.
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  using Opened = OpenedFile;
  // On any thread. Models of more triangles are worked on by proxies (Model::whole). Throws Failed.
  static Opened read(const QString& path, int backend, vtkIdType most = oversketch_session::mostTriangles);
  int backend() const { return this->Backend; }
  // Shows it, instead of what was there.
  void open(Opened opened);
  // Adds its models to those that are there (readModels); the first of them is chosen. Throws
  // oversketch_files::Failed where they are too many.
  static Opened readModels(const QString& path,
    int backend,
    vtkIdType most = oversketch_session::mostTriangles);
  void addModels(const Opened& opened);
  // The models of the scene, by their places in its list: document_models.cxx. The chosen one is worked on;
  // another is once nothing is computed any more. The only one cannot be removed.
  void chooseModel(int place);
  void removeModel(int place);
  void setModel(int place, bool shown, bool locked);
  // A part of the chosen one, by its number (cell array PartId) in what is shown of it now.
  void setPart(int number, bool shown);
  // Why the chosen one takes no steps, or none of a system, in words; empty where it does.
  QString whyNoSteps(const std::string& system = {}) const;
  // Begins a session whose first step makes a mesh of what will be drawn: over a picture, which readDrawing
  // has read on any thread; on an empty canvas. Reading throws Failed for what is no picture.
  using SharedStep = std::shared_ptr<const oversketch_session::Step>;
  using ReadDrawing = OpenedDrawing;
  static ReadDrawing readDrawing(const QString& picture);
  bool beginDrawing(SharedStep step, const QString& name, const std::function<bool()>& mayLeave);
  bool beginDrawing(const std::function<bool()>& mayLeave);
  // A function that reads, on any thread, a further part of the model for add(): a drawing over a picture,
  // before the middle of the model as it is now. Its longer side is at most that of the first picture; on a
  // model that was opened it is the model's. Throws Failed for what is no picture.
  std::function<ReadDrawing()> partReader(const QString& picture) const;
  // Opens what a crash left behind, read from its folder, as a session that is not saved.
  void recover(const oversketch_session::LeftBehind& left, Opened read);
  // Saves the session, as it is looked at. Throws Failed.
  void save(const QString& path);
  // In two halves, of which the first may run on any thread.
  oversketch_session::SessionFile toSave();
  void saved(const QString& path);
  // The mesh that an export writes; null where there is no mesh yet.
  vtkSmartPointer<vtkPolyData> shownMesh() const;

  const oversketch_session::Session& session() const { return this->Changes->now(); }
  bool isOpen() const { return this->Changes != nullptr; }
  // A row of the history, null where it is not there; whether there is one of a system's step.
  const oversketch_session::Node* nodeAt(int row) const;
  bool isOf(int row, const std::string& system) const;
  // The file that Save writes to; empty until the session has one.
  const QString& path() const { return this->Path; }
  // The name for titles: the session's file, or the mesh that was opened.
  QString name() const;
  // Whether anything is not in the session's file, or not as the model was opened.
  bool isModified() const { return this->Changes && !this->Changes->isSaved(); }
  // How the model was looked at when the session was saved.
  const std::optional<oversketch_session::Look>& look() const { return this->Seen; }
  // The world's axis that was up when it was opened: as the session says, else as the mesh seems to stand.
  int upAxis() const { return this->Up; }
  // Tells how it is looked at now.
  void setLook(std::function<std::optional<oversketch_session::Look>()> look)
  {
    this->LookNow = std::move(look);
  }
  bool canUndo() const { return this->Changes && this->Changes->canUndo(); }
  bool canRedo() const { return this->Changes && this->Changes->canRedo(); }
  // The newest result; its mesh stays while the next is computed. What moved, how it follows a hand and the
  // digest come after the mesh has been shown.
  const oversketch_session::Worker::Result& result() const { return this->Result; }
  // digestOf(result().mesh); empty before it is known.
  const std::string& digest() const { return this->Digest; }
  // The strokes on the mesh that is shown; none before they are known.
  const std::vector<oversketch_session::SharedData>& traces() const { return this->Traces; }
  bool isBusy() const { return this->Ticket != this->Answered; }
  // Nothing is computed, and all is there that follows on the mesh.
  bool isSettled() const { return !this->isBusy() && this->Detailed == this->Ticket; }

  // The plane that an interface offers: 0 none, 1 to 3 across x, y, z. It goes through the origin, or through
  // the middle of the model where that lies elsewhere.
  std::optional<oversketch_session::MirrorPlane> mirrorPlane(int choice) const;

  // Changes of the history, each one step of undo. A step that the hand has made; what it has made of a step
  // that is there: the inputs of another.
  void add(const oversketch_session::Step& step);
  void redraw(int node, const oversketch_session::Step& step);
  // Its inputs and values.
  void remake(int node, const oversketch_session::Step& step);
  // The strokes of a step that was given several: one is another, off, gone.
  void setStrokes(int node, const std::vector<oversketch_session::DrawnStroke>& strokes);
  void setParameters(int node,
    const oversketch_session::Values& values,
    const std::optional<oversketch_session::MirrorPlane>& mirror);
  // Sets values by a hand that sees the mesh follow. A change that merges into the last such change of the
  // step is one step of undo with it.
  void setValues(int node, const oversketch_session::Values& values, bool mergesIntoLast);
  // Puts a part elsewhere, as setValues().
  void setPlacement(int node, const oversketch_session::PartPlace& place, bool mergesIntoLast);
  void setOn(int node, bool on);
  void rename(int node, const QString& name);
  void remove(int node);
  // No step may stand before one that it needs (faultOfMove): then nothing happens.
  void move(int from, int to);
  // Puts the same step once more after it.
  void duplicate(int node);

  // The model is shown as of that many steps; the others are kept. How the history is looked at, no change of
  // it: no step of undo, and not in the file. What is drawn meanwhile comes after those that are shown.
  void showTo(int count);
  int shownTo() const;
  // A picture in the scene: added, shown in another way, taken away.
  void addPicture(const oversketch_session::Picture& picture);
  void setPicture(int index, const oversketch_session::Picture& picture);
  void removePicture(int index);
  void undo();
  void redo();
  // Stops the computing and goes back to the history that is shown (Redo brings the change back).
  void cancel();

  // Makes the mesh that comes to a node's step, for beforeCame().
  void requestBefore(int node);

  // Keeps no steps' work of larger models (Worker::keepWorkUpTo).
  void keepWorkUpTo(vtkIdType triangles) { this->Background->keepWorkUpTo(triangles); }

  // Where models compute (vtkOversketchSystem::BackendType): the open one from here on, where this is
  // another choice than the last, as a change of its history; those that are opened later. A session that is
  // opened keeps its own until then.
  void setBackend(int backend);

  // Ends the autosave: the work is saved or not wanted.
  void discardAutosave();

  // The kinds of change: what the hand has just drawn, the history otherwise, pictures alone, or the file
  // that it is saved in.
  enum class Change
  {
    Drawn,
    Edited,
    Pictures,
    Saved
  };

signals:
  // Another model is worked on: of another session (begun), or of the same.
  void begun();
  void opened();
  // A step that the chosen model does not take has been left aside (whyNoSteps).
  void refused(const QString& why);
  // The document changed. The result of what was drawn or edited follows with shown(), and what comes after
  // the mesh with detailed().
  void changed(Change change);
  void shown();
  void detailed();
  // The mesh that was asked for, with normals; null where there is none.
  void beforeCame(const oversketch_session::SharedData& mesh);
  // Each step's stroke on the surface has come (Worker::Listener::traced); a step's picture has.
  void traced();
  void pictured(int node);
  void progressed(int node, const QString& stage, double share);
  // Nothing is computed any more.
  void idle();
  void autosaveFailed(const QString& why);
  // The session as it is now lies on the disk.
  void kept();

private:
  void start(Opened opened, bool saved);
  void commit(oversketch_session::Session session, Change change = Change::Edited);
  void commitPictures(oversketch_session::Pictures pictures);
  void commitScene(oversketch_session::Session session);
  bool takes(const oversketch_session::Session& next);
  void choose(); // the wanted one, as soon as it can be
  void turnFrom(const oversketch_session::Session& before);
  oversketch_session::Session chosen(int place) const;
  oversketch_session::Session withStep(int node, const oversketch_session::Step& step) const;
  void setStep(int node, const oversketch_session::Step& step, bool mergesIntoLast);
  void run(Change change);
  void submit(); // what is shown
  void keep();
  void take(const oversketch_session::Worker::Result& result, const std::vector<SharedPicture>& worn);
  void holdWorn(); // what models at rest wear
  void takeDetails(const oversketch_session::Worker::Details& details);
  void answered(std::uint64_t ticket);
  oversketch_session::SessionFile file() const;
  const oversketch_session::SharedData& shownData() const
  {
    return this->Result.mesh ? this->Result.mesh : this->session().mesh;
  }

  std::unique_ptr<oversketch_session::History> Changes;
  QString Path;
  int Backend = 0, Up = 1;
  std::optional<oversketch_session::Look> Seen;
  std::function<std::optional<oversketch_session::Look>()> LookNow;
  int Shaped = 0;         // the id of the step that the last change was a setValues() or setPlacement() of
  bool Discarded = false; // what comes after the end is not to be kept
  oversketch_session::Worker::Result Result;
  // Pictures that each model wears, by its id, so that nothing is decoded when it is seen again.
  std::map<int, std::vector<SharedPicture>> Worn;
  std::string Digest; // of its mesh
  std::vector<oversketch_session::SharedData> Traces;
  std::optional<int> Last; // the id of the last step that is shown, 0 none is; absent: all are
  std::uint64_t Ticket = 0, Answered = 0, Detailed = 0;
  std::uint64_t First = 0; // of the chosen model; what comes before is of another
  int Wanted = 0;          // the id of the model to be chosen; 0: none
  oversketch_session::Autosave Saver;
  // Last, so that it ends first: it calls the rest.
  std::unique_ptr<oversketch_session::Worker> Background;
};

} // namespace oversketch_studio
#endif
