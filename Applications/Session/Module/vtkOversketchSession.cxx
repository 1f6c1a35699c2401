#include "vtkOversketchSession.h"

#include "background_run.h"
#include "drawing_lines.h"
#include "files.h"
#include "heights.h"
#include "history.h"
#include "image_file.h"
#include "large_mesh.h"
#include "mesh_file.h"
#include "models.h"
#include "node_json.h"
#include "parts.h"
#include "point_normals.h"
#include "session_file.h"
#include "step_order.h"
#include "step_values.h"
#include "terrain_start.h"
#include "texture.h"

#include "vtkImageData.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace oversketch_files;
using namespace oversketch_session;

vtkStandardNewMacro(vtkOversketchSession);

namespace
{

constexpr const char* sessionExtension = ".oversketch";

std::string orEmpty(const char* text)
{
  return text ? text : "";
}

std::string numbered(const std::string& what, int number)
{
  return what + " " + std::to_string(number);
}

// What VTK says of a file is said by an error of the reader's; the terminal is others'.
class QuietHere
{
public:
  QuietHere() { catchMessages(); }
  ~QuietHere()
  {
    vtkOutputWindow::SetInstance(this->Before);
    vtkLogger::SetStderrVerbosity(this->Verbosity);
  }
  QuietHere(const QuietHere&) = delete;
  QuietHere& operator=(const QuietHere&) = delete;

private:
  vtkSmartPointer<vtkOutputWindow> Before = vtkOutputWindow::GetInstance();
  vtkLogger::Verbosity Verbosity = vtkLogger::GetCurrentVerbosityCutoff();
};

bool isSame(const Node& a, const Node& b)
{
  return a.id == b.id && a.step == b.step && a.on == b.on;
}

Node nodeOf(const Step& step, const Session& session)
{
  Node node;
  node.id = freshId(session);
  node.step = std::make_shared<Step>(step);
  node.name = numbered(findSystem(step.system)->title, static_cast<int>(session.nodes.size()) + 1);
  return node;
}

Session begunWith(const std::shared_ptr<const Step>& step, const std::string& name)
{
  if (const std::string fault = faultOf(*step); !fault.empty())
  {
    throw Failed(fault);
  }
  Session session;
  session.meshName = name;
  session.nodes = { nodeOf(*step, session) };
  return session;
}

// Why the model takes no such steps, as in the window.
void requireTakes(const Session& next)
{
  for (const Node& node : next.nodes)
  {
    const SystemRow* row = node.on ? findSystem(node.step->system) : nullptr;
    if (node.on && next.locked)
    {
      throw Failed(next.meshName + " is locked and takes no steps; unlock it in the window");
    }
    if (row && next.whole && !row->moves)
    {
      throw Failed(next.meshName + " is shown by fewer triangles than it has, and " + row->name +
                   " would change those alone; open a coarser copy of it");
    }
  }
}

} // namespace

struct vtkOversketchSession::Internals
{
  History Changes{ Session() };
  std::optional<Look> Seen;
  std::map<std::string, GivenInput> Given;
  std::string Message, Texts, Stage;
  // The newest result, and the steps that it is of, which may have been changed since.
  Worker::Result Shown;
  Model Asked, Ran;
  std::uint64_t First = 0; // ticket of the chosen model; what comes before is of another
  // Made of that result when it is asked for.
  vtkSmartPointer<vtkPolyData> Mesh, StepLines;
  std::string Digest;
  std::optional<std::vector<Piece>> Pieces;
  std::map<int, vtkSmartPointer<vtkImageData>> Pictures;
  BackgroundRun Background;

  const Session& now() const { return this->Changes.now(); }

  const SharedData& shown() const { return this->Shown.mesh ? this->Shown.mesh : this->now().mesh; }

  std::size_t rowOf(int id) const
  {
    const int row = oversketch_session::rowOf(this->now().nodes, id);
    if (row < 0)
    {
      throw Failed(numbered("there is no step", id));
    }
    return static_cast<std::size_t>(row);
  }

  // What the result that is shown has of a step; null where it is of another.
  const Worker::NodeState* stateOf(const Node& node) const
  {
    const auto row = static_cast<std::size_t>(oversketch_session::rowOf(this->Ran.nodes, node.id));
    return row < this->Shown.nodes.size() && isSame(this->Ran.nodes[row], node) ? &this->Shown.nodes[row]
                                                                                : nullptr;
  }

  // Whether the result is that of the steps as they are.
  bool isCurrent() const
  {
    const std::vector<Node>& nodes = this->now().nodes;
    return this->Shown.ticket != 0 && this->Shown.nodes.size() == nodes.size() &&
           std::equal(nodes.begin(), nodes.end(), this->Ran.nodes.begin(), this->Ran.nodes.end(), isSame);
  }

  void show(Worker::Result result)
  {
    this->Shown = std::move(result);
    this->Mesh = nullptr;
    this->Digest.clear();
    this->Pieces.reset();
    this->Pictures.clear();
  }

  // Another model is worked on; what runs is of the one before.
  void turn(const RestingModel* resting)
  {
    Worker::Result rested;
    if (resting)
    {
      rested.mesh = resting->made.mesh;
      rested.display = resting->made.display;
      rested.parts = resting->made.parts;
      rested.backendUsed = resting->made.backendUsed;
    }
    this->Background.cancel();
    this->First = this->Background.ticket() + 1;
    this->Ran = {};
    this->show(std::move(rested));
  }

  void turnFrom(const Session& before)
  {
    const int place = this->now().id == before.id ? -1 : placeOfModel(before, this->now().id);
    if (place >= 0)
    {
      this->turn(restingAt(before, static_cast<std::size_t>(place)));
    }
  }

  void begin(Session session, std::optional<Look> look = {})
  {
    this->Changes = History(std::move(session));
    this->Changes.markSaved();
    this->Seen = std::move(look);
    this->Given.clear();
    this->turn(nullptr);
  }

  void commit(Session next)
  {
    requireTakes(next);
    this->Changes.commit(std::move(next));
  }

  // The step with that id is another.
  template <typename Change>
  void change(int id, const Change& change, bool takesHoldAnew = false)
  {
    Session next = this->now();
    Node& node = next.nodes[this->rowOf(id)];
    Step step = change(*node.step);
    if (const std::string fault = faultOf(step); !fault.empty())
    {
      throw Failed(fault);
    }
    node.step = std::make_shared<Step>(std::move(step));
    node.committed = takesHoldAnew ? std::nullopt : node.committed;
    this->commit(std::move(next));
  }

  const std::string& digest()
  {
    if (this->Digest.empty() && this->shown())
    {
      this->Digest = digestOf(this->shown());
    }
    return this->Digest;
  }

  SessionFile file()
  {
    SessionFile file;
    file.session = this->now();
    if (this->isCurrent() && this->Shown.mesh && !this->now().whole) // a proxy's digest is no result's
    {
      file.origin = originHere(this->Shown.backendUsed);
      file.digest = this->digest();
    }
    for (const auto& other : this->now().others)
    {
      file.others.push_back(
        { originHere(other->made.backendUsed), other->own.whole ? std::string() : other->made.digest });
    }
    file.look = this->Seen;
    return file;
  }

  bool poll()
  {
    std::optional<Worker::Result> result = this->Background.take();
    if (!result || result->ticket < this->First)
    {
      return false;
    }
    this->show(std::move(*result));
    this->Ran = this->Asked;
    // Learn where new steps took hold.
    Session learned = this->now();
    for (Node& node : learned.nodes)
    {
      const Worker::NodeState* state = node.committed ? nullptr : this->stateOf(node);
      node.committed = state ? state->section : node.committed;
    }
    this->Changes.amend(std::move(learned));
    return true;
  }

  void start()
  {
    this->Asked = this->now();
    this->Background.start(this->Asked);
  }

  void run()
  {
    this->start();
    this->Background.wait();
    this->poll();
  }

  const std::vector<Piece>& pieces()
  {
    if (!this->Pieces)
    {
      const SharedData& display = this->Shown.display;
      const auto whole = display         ? deepCopyOf(display)
                         : this->shown() ? withPointNormals(deepCopyOf(this->shown()))
                                         : vtkSmartPointer<vtkPolyData>();
      this->Pieces = whole ? piecesOf(withoutParts(whole, hiddenOf(this->now(), this->Shown.parts)))
                           : std::vector<Piece>();
    }
    return *this->Pieces;
  }

  const Piece* piece(int number)
  {
    const std::vector<Piece>& all = this->pieces();
    return number >= 0 && number < static_cast<int>(all.size()) ? &all[static_cast<std::size_t>(number)]
                                                                : nullptr;
  }
};

vtkOversketchSession::vtkOversketchSession()
  : Held(std::make_unique<Internals>())
{
  this->Held->Changes.markSaved();
}

vtkOversketchSession::~vtkOversketchSession() = default;

template <typename Act>
bool vtkOversketchSession::Try(Act act)
{
  this->Held->Message.clear();
  try
  {
    const QuietHere quiet;
    act(*this->Held);
    this->Modified();
    return true;
  }
  catch (const std::exception& error)
  {
    this->Held->Message = error.what();
    return false;
  }
}

const char* vtkOversketchSession::GetMessage()
{
  return this->Held->Message.c_str();
}

bool vtkOversketchSession::Open(const char* path)
{
  return this->Try(
    [file = orEmpty(path)](Internals& held)
    {
      const std::string extension = extensionOf(file);
      if (extension == sessionExtension || std::filesystem::is_directory(file))
      {
        SessionFile saved = readSession(file);
        makeProxies(saved.session, mostTriangles, {});
        makeResting(saved.session);
        held.begin(std::move(saved.session), saved.look);
        return;
      }
      Session session;
      Notes said;
      const std::string name = std::filesystem::path(file).filename().string();
      if (isHeightsExtension(extension))
      {
        session = begunWith(terrainOf(file), name);
      }
      else
      {
        session.mesh = readMesh(file, said);
        session.meshName = name;
        makeProxies(session, mostTriangles, {});
      }
      held.begin(std::move(session));
      for (const std::string& note : said)
      {
        held.Message += (held.Message.empty() ? "" : "\n") + note;
      }
    });
}

bool vtkOversketchSession::Save(const char* path)
{
  return this->Try(
    [file = orEmpty(path)](Internals& held)
    {
      if (extensionOf(file) != sessionExtension)
      {
        throw Failed(file + ": the name of a session's file ends in " + sessionExtension);
      }
      writeSession(file, held.file());
      held.Changes.markSaved();
    });
}

bool vtkOversketchSession::Export(const char* path)
{
  return this->Try(
    [file = orEmpty(path)](Internals& held)
    {
      if (!held.shown())
      {
        throw Failed("there is no mesh yet; run the steps first");
      }
      const SharedData& whole = held.now().whole;
      const auto mesh = whole && held.Shown.mesh ? exactOf(withOwnPolys(whole), withOwnPolys(held.shown()))
                                                 : withOwnPolys(whole ? whole : held.shown());
      Notes said;
      writeMesh(mesh, file, said);
      for (const std::string& note : said)
      {
        held.Message += (held.Message.empty() ? "" : "\n") + note;
      }
    });
}

bool vtkOversketchSession::SetMesh(vtkPolyData* mesh, const char* name)
{
  return this->Try(
    [mesh, text = orEmpty(name)](Internals& held)
    {
      if (!mesh)
      {
        throw Failed("there is no mesh; give a vtkPolyData");
      }
      Session session;
      session.mesh = parseMesh(text, bytesOf(mesh)); // as its file will give it back
      session.meshName = text;
      makeProxies(session, mostTriangles, {});
      held.begin(std::move(session));
    });
}

bool vtkOversketchSession::NewDrawing(const char* picturePath)
{
  return this->Try(
    [path = orEmpty(picturePath)](Internals& held)
    {
      const Image picture = readImage(path, SystemInput::Kind::Picture);
      held.begin(begunWith(drawingOver(picture), picture.name));
    });
}

bool vtkOversketchSession::NewCanvas(double width, double height)
{
  return this->Try(
    [width, height](Internals& held)
    {
      if (!(width > 0.0 && height > 0.0 && std::isfinite(width) && std::isfinite(height)))
      {
        throw Failed("a canvas needs a width and a height above 0");
      }
      held.begin(begunWith(drawingOn(width, height), "Drawing"));
    });
}

void vtkOversketchSession::SetInput(const char* name, vtkPolyData* lines)
{
  this->Held->Given[orEmpty(name)] = lines ? deepCopyOf(lines) : nullptr;
}

void vtkOversketchSession::SetInputFile(const char* name, const char* path)
{
  this->Held->Given[orEmpty(name)] = orEmpty(path);
}

void vtkOversketchSession::SetInputStep(const char* name, int step, int port)
{
  this->Held->Given[orEmpty(name)] = StepOutput{ step, port };
}

int vtkOversketchSession::AddStep(const char* system, const char* values)
{
  int id = 0;
  const auto add = [&](Internals& held)
  {
    const auto given = std::exchange(held.Given, {});
    Session next = held.now();
    Step step;
    step.system = orEmpty(system);
    next.nodes.push_back(nodeOf(withGiven(step, orEmpty(values), given, next), next));
    const int fresh = next.nodes.back().id;
    held.commit(std::move(next));
    id = fresh;
  };
  this->Try(add);
  return id;
}

bool vtkOversketchSession::ChangeStep(int id, const char* values)
{
  return this->Try(
    [&](Internals& held)
    {
      const auto given = std::exchange(held.Given, {});
      const auto changed = [&](const Step& step)
      { return withGiven(step, orEmpty(values), given, held.now()); };
      held.change(id, changed, !given.empty());
    });
}

bool vtkOversketchSession::AddStroke(int id, vtkPolyData* line)
{
  const auto withLine = [&](const Step& step)
  {
    const auto drawing = step.system == drawingSystem ? linesOf(step, strokesInput) : nullptr;
    if (!drawing || !line)
    {
      throw Failed(line ? numbered("step", id) + " is no drawing" : "there is no line");
    }
    std::vector<DrawnStroke> strokes = strokesOf(drawing);
    const std::vector<DrawnStroke> more = strokesOf(soundLines("the line", line));
    strokes.insert(strokes.end(), more.begin(), more.end());
    return withDrawing(step, drawingOf(strokes, drawing));
  };
  return this->Try([&](Internals& held) { held.change(id, withLine, true); });
}

bool vtkOversketchSession::SetStepOn(int id, bool on)
{
  return this->Try(
    [&](Internals& held)
    {
      Session next = held.now();
      next.nodes[held.rowOf(id)].on = on;
      held.commit(std::move(next));
    });
}

bool vtkOversketchSession::RemoveStep(int id)
{
  return this->Try(
    [&](Internals& held)
    {
      Session next = held.now();
      next.nodes.erase(next.nodes.begin() + static_cast<std::ptrdiff_t>(held.rowOf(id)));
      held.commit(std::move(next));
    });
}

bool vtkOversketchSession::MoveStep(int id, int place)
{
  return this->Try(
    [&](Internals& held)
    {
      Session next = held.now();
      const std::size_t from = held.rowOf(id), to = static_cast<std::size_t>(place);
      if (to >= next.nodes.size())
      {
        throw Failed(numbered("there is no place", place) + " in the list; its places are 0 to " +
                     std::to_string(next.nodes.size() - 1));
      }
      if (const OrderFault fault = faultOfMove(next, from, to))
      {
        const auto idAt = [&](int row) { return next.nodes[static_cast<std::size_t>(row)].id; };
        throw Failed(numbered("step", idAt(fault.step)) +
                     numbered(" would stand before step", idAt(fault.needed)) + ", which it needs");
      }
      next.nodes = moved(std::move(next.nodes), from, to);
      held.commit(std::move(next));
    });
}

bool vtkOversketchSession::SetMirror(int id, int axis, double offset)
{
  const auto mirrored = [&](Step step)
  {
    if (axis < 0 || axis > 2 || !std::isfinite(offset))
    {
      throw Failed("a mirror plane needs an axis, 0, 1 or 2, and an offset");
    }
    step.mirror = MirrorPlane{ axis, offset };
    return step;
  };
  return this->Try([&](Internals& held) { held.change(id, mirrored); });
}

bool vtkOversketchSession::ClearMirror(int id)
{
  const auto cleared = [](Step step)
  {
    step.mirror.reset();
    return step;
  };
  return this->Try([&](Internals& held) { held.change(id, cleared); });
}

bool vtkOversketchSession::Undo()
{
  return this->Try(
    [](Internals& held)
    {
      if (!held.Changes.canUndo())
      {
        throw Failed("there is nothing to undo");
      }
      const Session before = held.now();
      held.Changes.undo();
      held.turnFrom(before);
    });
}

bool vtkOversketchSession::Redo()
{
  return this->Try(
    [](Internals& held)
    {
      if (!held.Changes.canRedo())
      {
        throw Failed("there is nothing to redo");
      }
      const Session before = held.now();
      held.Changes.redo();
      held.turnFrom(before);
    });
}

bool vtkOversketchSession::GetCanUndo()
{
  return this->Held->Changes.canUndo();
}

bool vtkOversketchSession::GetCanRedo()
{
  return this->Held->Changes.canRedo();
}

bool vtkOversketchSession::GetSaved()
{
  return this->Held->Changes.isSaved();
}

const char* vtkOversketchSession::GetSteps()
{
  const EntryWriter none{ [](const Lines&) { return ""; }, [](const Image&) { return ""; } };
  Json::Value list(Json::arrayValue);
  for (const Node& node : this->Held->now().nodes)
  {
    Json::Value json = jsonOf2(node, systems(), none);
    const Worker::NodeState* state = this->Held->stateOf(node);
    json["title"] = findSystem(node.step->system)->title;
    json["failure"] = state ? state->failure.text() : "";
    json["remarks"] = Json::arrayValue;
    if (state && !state->remark.empty())
    {
      json["remarks"].append(state->remark.text());
    }
    json["elsewhere"] = state && state->elsewhere;
    json["section"]; // null where they are absent
    json["mirror"];
    list.append(json);
  }
  this->Held->Texts = textOf(list);
  return this->Held->Texts.c_str();
}

vtkPolyData* vtkOversketchSession::GetStepInput(int id, const char* name)
{
  const std::vector<Node>& nodes = this->Held->now().nodes;
  const int row = rowOf(nodes, id);
  this->Held->StepLines = row < 0 ? nullptr : linesOf(*nodes[static_cast<std::size_t>(row)].step, orEmpty(name));
  return this->Held->StepLines;
}

const char* vtkOversketchSession::GetSystems()
{
  static const std::string text = systemsAsJson();
  return text.c_str();
}

bool vtkOversketchSession::Update()
{
  return this->Try(
    [](Internals& held)
    {
      held.run();
      if (!held.isCurrent())
      {
        throw Failed("cancelled");
      }
      for (const Node& node : held.now().nodes)
      {
        const Worker::NodeState* state = held.stateOf(node);
        if (state && !state->failure.empty())
        {
          throw Failed("'" + node.name + "' did nothing: " + state->failure.text());
        }
      }
    });
}

void vtkOversketchSession::Start()
{
  this->Held->start();
}

bool vtkOversketchSession::IsRunning()
{
  return this->Held->Background.isRunning();
}

bool vtkOversketchSession::Poll()
{
  const bool came = this->Held->poll();
  came ? this->Modified() : void();
  return came;
}

void vtkOversketchSession::Cancel()
{
  this->Held->Background.cancel();
}

double vtkOversketchSession::GetProgress()
{
  const BackgroundRun::Progress progress = this->Held->Background.progress();
  const auto count = static_cast<double>(std::max<std::size_t>(this->Held->Asked.nodes.size(), 1));
  return this->IsRunning() ? std::min((static_cast<double>(progress.node) + progress.share) / count, 1.0)
                           : 1.0;
}

const char* vtkOversketchSession::GetStage()
{
  const BackgroundRun::Progress progress = this->Held->Background.progress();
  const std::vector<Node>& nodes = this->Held->Asked.nodes;
  const bool isKnown = this->IsRunning() && progress.node < nodes.size();
  this->Held->Stage = isKnown ? nodes[progress.node].name + ": " + progress.stage : "";
  return this->Held->Stage.c_str();
}

vtkPolyData* vtkOversketchSession::GetMesh()
{
  if (!this->Held->Mesh && this->Held->shown())
  {
    this->Held->Mesh = deepCopyOf(this->Held->shown()); // steps go on with their own
  }
  return this->Held->Mesh;
}

const char* vtkOversketchSession::GetDigest()
{
  return this->Held->digest().c_str();
}

int vtkOversketchSession::GetNumberOfPieces()
{
  return static_cast<int>(this->Held->pieces().size());
}

vtkPolyData* vtkOversketchSession::GetPieceMesh(int piece)
{
  const Piece* found = this->Held->piece(piece);
  return found ? found->mesh.Get() : nullptr;
}

vtkImageData* vtkOversketchSession::GetPiecePicture(int piece)
{
  const Piece* found = this->Held->piece(piece);
  if (found && !found->picture.empty() && this->Held->Pictures.count(piece) == 0)
  {
    this->Held->Pictures[piece] = pictureOf(found->picture);
  }
  return found && !found->picture.empty() ? this->Held->Pictures[piece].Get() : nullptr;
}

bool vtkOversketchSession::GetLook(vtkCamera* camera)
{
  const bool isKnown = camera && this->Held->Seen;
  isKnown ? lookAs(*this->Held->Seen, camera) : void();
  return isKnown;
}

void vtkOversketchSession::SetLook(vtkCamera* camera, int width, int height)
{
  const int upAxis = this->Held->Seen ? this->Held->Seen->upAxis : 1;
  this->Held->Seen = camera ? std::optional<Look>(lookOf(camera)) : std::nullopt;
  if (camera)
  {
    this->Held->Seen->size = { std::max(width, 1), std::max(height, 1) };
    this->Held->Seen->upAxis = upAxis;
  }
}

int vtkOversketchSession::GetNumberOfModels()
{
  return static_cast<int>(modelCount(this->Held->now()));
}

int vtkOversketchSession::GetModel()
{
  return static_cast<int>(this->Held->now().place);
}

bool vtkOversketchSession::SetModel(int place)
{
  return place == this->GetModel() ||
         this->Try(
           [place](Internals& held)
           {
             if (place < 0 || static_cast<std::size_t>(place) >= modelCount(held.now()))
             {
               throw Failed(numbered("there is no model", place) + " in the scene");
             }
             if (!held.isCurrent())
             {
               held.run();
             }
             const Session before = held.now();
             const Worker::Result& made = held.Shown;
             held.Changes.amend(withChosen(before,
               static_cast<std::size_t>(place),
               { made.mesh, made.display, made.parts, made.mesh ? held.digest() : "", made.backendUsed }));
             held.turnFrom(before);
           });
}

void vtkOversketchSession::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Steps: " << this->Held->now().nodes.size() << "\n";
  os << indent << "NumberOfModels: " << this->GetNumberOfModels() << "\n";
  os << indent << "Model: " << this->GetModel() << "\n";
  os << indent << "Message: " << this->Held->Message << "\n";
}
