#include "vtkOversketchSession.h"

#include "drawing_lines.h"
#include "files.h"
#include "heights.h"
#include "image_file.h"
#include "large_mesh.h"
#include "mesh_file.h"
#include "models.h"
#include "node_json.h"
#include "session_state.h"
#include "step_order.h"
#include "step_values.h"
#include "systems.h"
#include "terrain_start.h"

#include "vtkImageData.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
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

// Silences VTK: an error of the reader's says what is wrong with a file, and the terminal is others'.
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

std::string lineEach(const Notes& notes)
{
  std::string lines;
  for (const std::string& note : notes)
  {
    lines += (lines.empty() ? "" : "\n") + note;
  }
  return lines;
}

} // namespace

vtkOversketchSession::vtkOversketchSession()
  : Held(std::make_unique<SessionState>())
{
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
    [file = orEmpty(path)](SessionState& held)
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
      held.Message = lineEach(said);
    });
}

bool vtkOversketchSession::Save(const char* path)
{
  return this->Try(
    [file = orEmpty(path)](SessionState& held)
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
    [file = orEmpty(path)](SessionState& held)
    {
      const auto mesh = held.whole();
      if (!mesh)
      {
        throw Failed("there is no mesh yet; run the steps first");
      }
      Notes said;
      writeMesh(mesh, file, said);
      held.Message = lineEach(said);
    });
}

bool vtkOversketchSession::SetMesh(vtkPolyData* mesh, const char* name)
{
  return this->Try(
    [mesh, text = orEmpty(name)](SessionState& held)
    {
      if (!mesh)
      {
        throw Failed("there is no mesh; give a vtkPolyData");
      }
      Session session;
      session.mesh = parseMesh("the mesh", bytesOf(mesh)); // as its file will give it back
      session.meshName = text;
      makeProxies(session, mostTriangles, {});
      held.begin(std::move(session));
    });
}

bool vtkOversketchSession::NewDrawing(const char* picturePath)
{
  return this->Try(
    [path = orEmpty(picturePath)](SessionState& held)
    {
      const Image picture = readImage(path, SystemInput::Kind::Picture);
      held.begin(begunWith(drawingOver(picture), picture.name));
    });
}

bool vtkOversketchSession::NewCanvas(double width, double height)
{
  return this->Try(
    [width, height](SessionState& held)
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
  const auto add = [&](SessionState& held)
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
  const auto change = [&](SessionState& held)
  {
    const auto given = std::exchange(held.Given, {});
    const auto changed = [&](const Step& step)
    { return withGiven(step, orEmpty(values), given, held.now()); };
    held.change(id, changed, !given.empty());
  };
  return this->Try(change);
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
  return this->Try([&](SessionState& held) { held.change(id, withLine, true); });
}

bool vtkOversketchSession::SetStepOn(int id, bool on)
{
  const auto change = [on](Session& next, std::size_t row) { next.nodes[row].on = on; };
  return this->Try([&](SessionState& held) { held.edit(id, change); });
}

bool vtkOversketchSession::RemoveStep(int id)
{
  const auto change = [](Session& next, std::size_t row)
  { next.nodes.erase(next.nodes.begin() + static_cast<std::ptrdiff_t>(row)); };
  return this->Try([&](SessionState& held) { held.edit(id, change); });
}

bool vtkOversketchSession::MoveStep(int id, int place)
{
  const auto change = [place](Session& next, std::size_t from)
  {
    const auto to = static_cast<std::size_t>(place);
    if (to >= next.nodes.size())
    {
      throw Failed(numbered("there is no place", place) +
                   numbered(" in the list; its places are 0 to", static_cast<int>(next.nodes.size()) - 1));
    }
    if (const OrderFault fault = faultOfMove(next, from, to))
    {
      const auto idAt = [&](int row) { return next.nodes[static_cast<std::size_t>(row)].id; };
      throw Failed(numbered("step", idAt(fault.step)) +
                   numbered(" would stand before step", idAt(fault.needed)) + ", which it needs");
    }
    next.nodes = moved(std::move(next.nodes), from, to);
  };
  return this->Try([&](SessionState& held) { held.edit(id, change); });
}

bool vtkOversketchSession::SetMirror(int id, int axis, double offset)
{
  const auto mirrored = [=](Step step)
  {
    if (axis < 0 || axis > 2 || !std::isfinite(offset))
    {
      throw Failed("a mirror plane needs an axis, 0, 1 or 2, and an offset");
    }
    step.mirror = MirrorPlane{ axis, offset };
    return step;
  };
  return this->Try([&](SessionState& held) { held.change(id, mirrored); });
}

bool vtkOversketchSession::ClearMirror(int id)
{
  const auto cleared = [](Step step)
  {
    step.mirror.reset();
    return step;
  };
  return this->Try([&](SessionState& held) { held.change(id, cleared); });
}

bool vtkOversketchSession::Undo()
{
  return this->Try([](SessionState& held) { held.goTo(true); });
}

bool vtkOversketchSession::Redo()
{
  return this->Try([](SessionState& held) { held.goTo(false); });
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
  this->Held->Steps = textOf(list);
  return this->Held->Steps.c_str();
}

vtkPolyData* vtkOversketchSession::GetStepInput(int id, const char* name)
{
  const std::vector<Node>& nodes = this->Held->now().nodes;
  const int row = rowOf(nodes, id);
  this->Held->StepLines =
    row < 0 ? nullptr : linesOf(*nodes[static_cast<std::size_t>(row)].step, orEmpty(name));
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
    [](SessionState& held)
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
  return this->Held->mesh();
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
  const bool isThere = piece >= 0 && piece < this->GetNumberOfPieces();
  return isThere ? this->Held->pieces()[static_cast<std::size_t>(piece)].mesh.Get() : nullptr;
}

vtkImageData* vtkOversketchSession::GetPiecePicture(int piece)
{
  return this->GetPieceMesh(piece) ? this->Held->picture(piece) : nullptr;
}

bool vtkOversketchSession::GetLook(vtkCamera* camera)
{
  const bool isKnown = camera && this->Held->Seen;
  isKnown ? lookAs(*this->Held->Seen, camera) : void();
  return isKnown;
}

void vtkOversketchSession::SetLook(vtkCamera* camera, int width, int height)
{
  const std::optional<Look> before = std::exchange(this->Held->Seen, std::nullopt);
  if (camera)
  {
    Look look = lookOf(camera);
    look.size = { std::max(width, 1), std::max(height, 1) };
    look.upAxis = before ? before->upAxis : look.upAxis;
    this->Held->Seen = look;
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
         this->Try([place](SessionState& held) { held.choose(static_cast<std::size_t>(place)); });
}

void vtkOversketchSession::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Steps: " << this->Held->now().nodes.size() << "\n";
  os << indent << "NumberOfModels: " << this->GetNumberOfModels() << "\n";
  os << indent << "Model: " << this->GetModel() << "\n";
  os << indent << "Message: " << this->Held->Message << "\n";
}
