#include "session_state.h"

#include "files.h"
#include "large_mesh.h"
#include "parts.h"
#include "point_normals.h"
#include "systems.h"
#include "texture.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace oversketch_session
{

using oversketch_files::Failed;

namespace
{

bool isSameNode(const Node& a, const Node& b)
{
  return a.id == b.id && a.step == b.step && a.on == b.on;
}

void requireRunnable(const Step& step)
{
  if (const std::string fault = faultOf(step); !fault.empty())
  {
    throw Failed(fault);
  }
}

// The model takes such steps, as in the window.
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

Node nodeOf(const Step& step, const Model& model)
{
  Node node;
  node.id = freshId(model);
  node.step = std::make_shared<Step>(step);
  node.name = findSystem(step.system)->title + " " + std::to_string(model.nodes.size() + 1);
  return node;
}

Session begunWith(const std::shared_ptr<const Step>& step, const std::string& name)
{
  requireRunnable(*step);
  Session session;
  session.meshName = name;
  session.nodes = { nodeOf(*step, session) };
  return session;
}

void SessionState::begin(Session session, std::optional<Look> look)
{
  this->Changes = History(std::move(session));
  this->Changes.markSaved();
  this->Seen = std::move(look);
  this->Given.clear();
  this->turn(nullptr);
}

void SessionState::commit(Session next)
{
  requireTakes(next);
  if (next.nodes != this->now().nodes)
  {
    this->Changes.commit(std::move(next));
  }
}

void SessionState::edit(int id, const std::function<void(Session&, std::size_t row)>& edit)
{
  const int row = rowOf(this->now().nodes, id);
  if (row < 0)
  {
    throw Failed("there is no step " + std::to_string(id));
  }
  Session next = this->now();
  edit(next, static_cast<std::size_t>(row));
  this->commit(std::move(next));
}

void SessionState::change(int id, const std::function<Step(const Step&)>& change, bool takesHoldAnew)
{
  const auto replace = [&](Session& next, std::size_t row)
  {
    Node& node = next.nodes[row];
    Step step = change(*node.step);
    requireRunnable(step);
    node.step = std::make_shared<Step>(std::move(step));
    node.committed = takesHoldAnew ? std::nullopt : node.committed;
  };
  this->edit(id, replace);
}

void SessionState::goTo(bool back)
{
  if (!(back ? this->Changes.canUndo() : this->Changes.canRedo()))
  {
    throw Failed(back ? "there is nothing to undo" : "there is nothing to redo");
  }
  const Session before = this->now();
  back ? this->Changes.undo() : this->Changes.redo();
  this->turnFrom(before);
}

void SessionState::choose(std::size_t place)
{
  if (place >= modelCount(this->now()))
  {
    throw Failed(
      "there is no such model; their places are 0 to " + std::to_string(modelCount(this->now()) - 1));
  }
  if (!this->isCurrent())
  {
    this->run();
  }
  const Session before = this->now();
  const Worker::Result& made = this->Shown;
  this->Changes.amend(withChosen(before,
    place,
    { made.mesh, made.display, made.parts, made.mesh ? this->digest() : "", made.backendUsed }));
  this->turnFrom(before);
}

// Another model is worked on, as it rested; what runs is of the one before.
void SessionState::turn(const RestingModel* resting)
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

void SessionState::turnFrom(const Session& before)
{
  const int place = this->now().id == before.id ? -1 : placeOfModel(before, this->now().id);
  if (place >= 0)
  {
    this->turn(restingAt(before, static_cast<std::size_t>(place)));
  }
}

void SessionState::show(Worker::Result result)
{
  this->Shown = std::move(result);
  this->Mesh = nullptr;
  this->Digest.clear();
  this->Pieces.reset();
  this->Pictures.clear();
}

void SessionState::start()
{
  this->Asked = this->now();
  this->Background.start(this->Asked);
}

void SessionState::run()
{
  this->start();
  this->Background.wait();
  this->poll();
}

bool SessionState::poll()
{
  std::optional<Worker::Result> result = this->Background.take();
  if (!result || result->ticket < this->First)
  {
    return false;
  }
  this->show(std::move(*result));
  this->Ran = this->Asked; // with more steps at its end, where the result is of the one before
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

bool SessionState::isCurrent() const
{
  const std::vector<Node>& nodes = this->now().nodes;
  return this->Shown.ticket != 0 && this->Shown.nodes.size() == nodes.size() &&
         std::equal(nodes.begin(), nodes.end(), this->Ran.nodes.begin(), this->Ran.nodes.end(), isSameNode);
}

const Worker::NodeState* SessionState::stateOf(const Node& node) const
{
  const auto row = static_cast<std::size_t>(rowOf(this->Ran.nodes, node.id));
  const bool isThere = row < this->Shown.nodes.size() && isSameNode(this->Ran.nodes[row], node);
  return isThere ? &this->Shown.nodes[row] : nullptr;
}

vtkPolyData* SessionState::mesh()
{
  if (!this->Mesh && this->shown())
  {
    this->Mesh = deepCopyOf(this->shown()); // steps go on with their own
  }
  return this->Mesh;
}

const std::string& SessionState::digest()
{
  if (this->Digest.empty() && this->shown())
  {
    this->Digest = digestOf(this->shown());
  }
  return this->Digest;
}

const std::vector<oversketch_files::Piece>& SessionState::pieces()
{
  if (!this->Pieces)
  {
    this->Pieces.emplace();
    if (this->shown())
    {
      auto display = this->Shown.display ? deepCopyOf(this->Shown.display)
                                         : oversketch_files::withPointNormals(deepCopyOf(this->shown()));
      this->Pieces = oversketch_files::piecesOf(
        oversketch_files::withoutParts(display, hiddenOf(this->now(), this->Shown.parts)));
    }
  }
  return *this->Pieces;
}

vtkImageData* SessionState::picture(int piece)
{
  auto known = this->Pictures.find(piece);
  if (known == this->Pictures.end())
  {
    const std::string& bytes = this->pieces().at(static_cast<std::size_t>(piece)).picture;
    known = this->Pictures.emplace(piece, bytes.empty() ? nullptr : oversketch_files::pictureOf(bytes)).first;
  }
  return known->second;
}

SessionFile SessionState::file()
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

vtkSmartPointer<vtkPolyData> SessionState::whole() const
{
  const SharedData& whole = this->now().whole;
  const SharedData& made = whole && !this->Shown.mesh ? whole : this->shown();
  return whole && this->Shown.mesh ? exactOf(withOwnPolys(whole), withOwnPolys(made))
         : made                    ? withOwnPolys(made)
                                   : nullptr;
}

} // namespace oversketch_session
