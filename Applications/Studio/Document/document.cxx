#include "document.h"

#include "files.h"
#include "heights.h"
#include "long_work.h"
#include "mesh_file.h"
#include "models.h"
#include "picture_files.h"
#include "system_strings.h"
#include "systems.h"
#include "terrain_start.h"
#include "up_axis.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace oversketch_studio
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

const char* const sessionExtension = ".oversketch";

// Those that the window shows at once: behind the model, worn, and on the pad.
std::vector<SharedPicture> picturesOf(const Session& session)
{
  std::vector<SharedPicture> pictures = decodedOf(session.mesh);
  const auto add = [&pictures](const std::vector<SharedPicture>& more)
  { pictures.insert(pictures.end(), more.begin(), more.end()); };
  for (const auto& picture : session.pictures)
  {
    add({ decoded(picture->image.bytes) });
  }
  for (const auto& other : session.others)
  {
    add(decodedOf(other->made.display));
  }
  const Step* first = session.mesh || session.nodes.empty() ? nullptr : session.nodes.front().step.get();
  const Image* over = first ? pictureUnder(*first) : nullptr;
  if (over)
  {
    add({ decoded(over->bytes) });
  }
  return pictures;
}

} // namespace

Document::Document(QObject* parent)
  : QObject(parent)
  , Saver(autosaveRoot())
{
  // The threads of worker and autosave post to this object's; what arrives after a newer change is left aside
  // there.
  const auto post = [this](auto act)
  { QMetaObject::invokeMethod(this, std::move(act), Qt::QueuedConnection); };
  Worker::Listener listener;
  listener.done = [this, post](Worker::Result result)
  {
    auto worn = decodedOf(result.display); // here, so that the window's thread need not
    post([this, made = std::move(result), pictures = std::move(worn)] { this->take(made, pictures); });
  };
  listener.detailed = [this, post](Worker::Details details)
  { post([this, made = std::move(details)] { this->takeDetails(made); }); };
  listener.cancelled = [this, post](std::uint64_t ticket)
  {
    post(
      [this, ticket]
      {
        this->Detailed = std::max(this->Detailed, ticket); // nothing will come
        this->answered(ticket);
      });
  };
  listener.traced = [this, post](std::uint64_t ticket, std::vector<SharedData> lines)
  {
    post(
      [this, ticket, made = std::move(lines)]
      {
        if (ticket == this->Result.ticket)
        {
          this->Traces = made;
          emit this->traced();
        }
      });
  };
  listener.pictured = [this, post](
                        std::uint64_t ticket, std::size_t node, std::shared_ptr<const Thumbnail> picture)
  {
    post(
      [this, ticket, node, made = std::move(picture)]
      {
        if (ticket == this->Result.ticket)
        {
          this->Result.nodes[node].picture = made;
          emit this->pictured(static_cast<int>(node));
        }
      });
  };
  listener.progress = [this, post](std::uint64_t, std::size_t node, const std::string& stage, double share)
  {
    const QString name = QString::fromStdString(stage);
    post([this, at = static_cast<int>(node), name, share] { emit this->progressed(at, name, share); });
  };
  listener.evaluatedAside = [this, post](const SharedData& mesh)
  { post([this, mesh] { emit this->beforeCame(mesh); }); };
  this->Background = std::make_unique<Worker>(std::move(listener));
  this->Saver.onKept([this, post] { post([this] { emit this->kept(); }); });
}

Document::~Document() = default;

Document::Opened Document::read(const QString& path, int backend, vtkIdType most)
{
  const std::string file = path.toStdString(), extension = extensionOf(file);
  Opened opened;
  Session& session = opened.session;
  if (extension == sessionExtension || QFileInfo(path).isDir())
  {
    SessionFile saved = readSession(file);
    opened.path = path;
    opened.look = saved.look;
    opened.upAxis = saved.look ? saved.look->upAxis : 1;
    session = std::move(saved.session);
    makeProxies(session, most, progressOfWork());
    makeResting(session);
    opened.pictures = picturesOf(session);
    return opened;
  }
  Notes said;
  if (!isHeightsExtension(extension) && !isMeshExtension(extension))
  {
    throw Failed(tr("%1 is no model, session or height grid.").arg(QFileInfo(path).fileName()).toStdString());
  }
  if (isHeightsExtension(extension) && findSystem("Terrain"))
  {
    session.nodes = { firstNode(terrainOf(file)) };
    opened.upAxis = 2;
  }
  else
  {
    session.mesh = readMesh(file, said);
    makeProxies(session, most, progressOfWork());
    const bool isGltf = extension == ".gltf" || extension == ".glb"; // the standard says y
    opened.upAxis = isGltf ? 1 : upAxisOf(session.mesh);
  }
  session.meshName = QFileInfo(path).fileName().toStdString();
  session.backend = backend;
  opened.pictures = picturesOf(session);
  opened.notes = listOf(said);
  return opened;
}

void Document::open(Opened opened)
{
  this->start(std::move(opened), true);
  emit this->opened();
}

void Document::recover(const LeftBehind& left, Opened read)
{
  read.path = QString::fromStdString(left.path);
  this->start(std::move(read), false);
  // The old folder goes only when the new one is on the disk.
  if (this->Saver.wait().empty())
  {
    removeLeftBehind(left);
  }
  emit this->opened();
}

void Document::start(Opened opened, bool saved)
{
  this->Path = opened.path;
  this->Seen = opened.look;
  this->Up = opened.upAxis;
  this->Worn = { { opened.session.id, std::move(opened.pictures) } };
  this->Changes = std::make_unique<History>(std::move(opened.session));
  this->holdWorn();
  if (saved)
  {
    this->Changes->markSaved();
  }
  this->Result = {};
  this->Digest.clear();
  this->Traces.clear();
  this->Last.reset();
  this->Wanted = 0;
  this->First = this->Ticket + 1;
  this->run(Change::Edited);
  emit this->begun();
}

void Document::requestBefore(int node)
{
  Session before = this->session();
  before.nodes.resize(std::min(before.nodes.size(), indexOf(node)));
  this->Background->evaluateAside(std::move(before));
}

void Document::save(const QString& path)
{
  writeSession(path.toStdString(), this->toSave());
  this->saved(path);
}

SessionFile Document::toSave()
{
  if (!this->isBusy() && this->Digest.empty() && this->Result.mesh)
  {
    this->Digest = digestOf(this->Result.mesh); // it is on its way
  }
  return this->file();
}

void Document::saved(const QString& path)
{
  this->Path = path;
  this->Changes->markSaved();
  this->keep();
  emit this->changed(Change::Saved);
}

vtkSmartPointer<vtkPolyData> Document::shownMesh() const
{
  return this->shownData().own();
}

QString Document::name() const
{
  if (!this->isOpen())
  {
    return {};
  }
  return this->Path.isEmpty() ? QString::fromStdString(this->session().meshName)
                              : QFileInfo(this->Path).fileName();
}

SessionFile Document::file() const
{
  SessionFile file;
  file.session = this->session();
  const bool isWhole = this->Result.nodes.size() == file.session.nodes.size();
  // A proxy's digest is no result's.
  if (!this->isBusy() && !this->Digest.empty() && isWhole && !file.session.whole)
  {
    file.origin = originHere(this->Result.backendUsed);
    file.digest = this->Digest;
  }
  for (const auto& other : file.session.others)
  {
    const bool isLarge = other->own.whole;
    file.others.push_back(
      { originHere(other->made.backendUsed), isLarge ? std::string() : other->made.digest });
  }
  file.look = this->LookNow && this->Result.mesh ? this->LookNow() : this->Seen;
  return file;
}

std::optional<MirrorPlane> Document::mirrorPlane(int choice) const
{
  // Where the first step makes the model it is what has been made by now.
  const SharedData model = this->session().mesh ? this->session().mesh : this->Result.mesh;
  if (choice == 0 || !this->isOpen() || !model || model->GetNumberOfPoints() == 0)
  {
    return std::nullopt;
  }
  double box[6];
  model->GetBounds(box);
  const int axis = choice - 1;
  const double middle = 0.5 * (box[2 * axis] + box[2 * axis + 1]);
  // Models are made about the origin, and their two sides seldom reach equally far.
  const bool aside = std::abs(middle) > 0.1 * (box[2 * axis + 1] - box[2 * axis]);
  return MirrorPlane{ axis, aside ? middle : 0.0 };
}

void Document::add(const Step& step)
{
  Session next = this->session();
  Node node;
  node.id = freshId(next);
  node.step = std::make_shared<Step>(step);
  node.name = tr("%1 %2").arg(titleOf(step.system)).arg(next.nodes.size() + 1).toStdString();
  next.nodes.insert(next.nodes.begin() + this->shownTo(), node);
  this->Last = this->Last ? std::optional<int>(node.id) : std::nullopt;
  this->commit(std::move(next), Change::Drawn);
}

Session Document::withStep(int index, const Step& step) const
{
  Session next = this->session();
  next.nodes[indexOf(index)].step = std::make_shared<Step>(step);
  return next;
}

void Document::redraw(int index, const Step& drawn)
{
  Step step = *this->nodeAt(index)->step;
  step.inputs = drawn.inputs;
  this->remake(index, step);
}

void Document::remake(int index, const Step& made)
{
  Step step = *this->nodeAt(index)->step;
  step.inputs = made.inputs;
  step.values = made.values;
  Session next = this->withStep(index, step);
  next.nodes[indexOf(index)].committed.reset(); // it takes hold anew
  this->commit(std::move(next), Change::Drawn);
}

void Document::setStrokes(int index, const std::vector<DrawnStroke>& strokes)
{
  const Step& step = *this->nodeAt(index)->step;
  const SystemInput* input = findInput(*findSystem(step.system), SystemInput::Kind::Stroke);
  this->redraw(index, withDrawing(step, drawingOf(strokes, linesOf(step, input->name))));
}

void Document::setParameters(int index, const Values& values, const std::optional<MirrorPlane>& mirror)
{
  Step step = *this->nodeAt(index)->step;
  step.values = values;
  step.mirror = mirror;
  this->commit(this->withStep(index, step));
}

void Document::setValues(int index, const Values& values, bool mergesIntoLast)
{
  Step step = *this->nodeAt(index)->step;
  step.values = values;
  this->setStep(index, step, mergesIntoLast);
}

void Document::setPlacement(int index, const PartPlace& place, bool mergesIntoLast)
{
  Step step = *this->nodeAt(index)->step;
  step.part = place;
  this->setStep(index, step, mergesIntoLast);
}

// A change by a hand that goes on.
void Document::setStep(int index, const Step& step, bool mergesIntoLast)
{
  Session next = this->withStep(index, step);
  const int id = next.nodes[indexOf(index)].id;
  if (mergesIntoLast && this->Shaped == id && this->takes(next))
  {
    this->Changes->mergeIntoLast(std::move(next));
    this->run(Change::Drawn);
  }
  else
  {
    this->commit(std::move(next), Change::Drawn);
  }
  this->Shaped = id;
}

void Document::setOn(int index, bool on)
{
  Session next = this->session();
  next.nodes[indexOf(index)].on = on;
  this->commit(std::move(next));
}

void Document::rename(int index, const QString& name)
{
  Session next = this->session();
  next.nodes[indexOf(index)].name = name.toStdString();
  this->commit(std::move(next));
}

void Document::addPicture(const Picture& picture)
{
  Pictures pictures = this->session().pictures;
  pictures.push_back(std::make_shared<Picture>(picture));
  this->commitPictures(std::move(pictures));
}

void Document::setPicture(int index, const Picture& picture)
{
  Pictures pictures = this->session().pictures;
  pictures[indexOf(index)] = std::make_shared<Picture>(picture);
  this->commitPictures(std::move(pictures));
}

void Document::removePicture(int index)
{
  Pictures pictures = this->session().pictures;
  pictures.erase(pictures.begin() + index);
  this->commitPictures(std::move(pictures));
}

// The mesh does not depend on them: nothing is run.
void Document::commitPictures(Pictures pictures)
{
  Session next = this->session();
  next.pictures = std::move(pictures);
  this->commitScene(std::move(next));
}

void Document::commitScene(Session session)
{
  this->Shaped = 0; // what a hand shapes from here on is a change after this one
  this->Changes->commit(std::move(session));
  this->keep();
  emit this->changed(Change::Pictures);
}

void Document::setBackend(int backend)
{
  const bool chosen = backend != this->Backend;
  this->Backend = backend;
  if (chosen && this->isOpen() && this->session().backend != backend)
  {
    Session next = this->session();
    next.backend = backend;
    this->commit(std::move(next));
  }
}

void Document::undo()
{
  const Session before = this->session();
  this->Changes->undo();
  this->turnFrom(before);
}

void Document::redo()
{
  const Session before = this->session();
  this->Changes->redo();
  this->turnFrom(before);
}

void Document::cancel()
{
  if (this->isBusy())
  {
    this->Wanted = 0;
    this->Background->cancel();
    if (this->canUndo())
    {
      this->undo();
    }
  }
}

void Document::commit(Session session, Change change)
{
  if (this->takes(session))
  {
    this->Changes->commit(std::move(session));
    this->run(change);
  }
}

void Document::run(Change change)
{
  this->submit();
  this->keep(); // before its result is there, so that no crash can take the stroke
  emit this->changed(change);
}

void Document::submit()
{
  this->Shaped = 0;
  Session shown = this->session();
  shown.nodes.resize(indexOf(this->shownTo()));
  this->Ticket = this->Background->submit(std::move(shown));
}

void Document::keep()
{
  // Pictures that only undo brings back are decoded anew then.
  for (auto it = this->Worn.begin(); it != this->Worn.end();)
  {
    it = placeOfModel(this->session(), it->first) >= 0 ? std::next(it) : this->Worn.erase(it);
  }
  if (!this->Discarded)
  {
    this->Saver.keep(this->file(), { this->Path.toStdString(), this->isModified() });
  }
}

void Document::discardAutosave()
{
  this->Discarded = true;
  this->Saver.discard();
}

void Document::answered(std::uint64_t ticket)
{
  const bool before = this->isBusy();
  this->Answered = std::max(this->Answered, ticket);
  if (before && !this->isBusy())
  {
    emit this->idle();
    this->choose(); // where nothing follows
  }
}

void Document::take(const Worker::Result& result, const std::vector<SharedPicture>& worn)
{
  if (result.ticket < this->First ||
      (result.ticket < this->Ticket && result.nodes.size() > this->session().nodes.size()))
  {
    this->answered(result.ticket); // of a history that was left
    return;
  }
  this->Result = result;
  this->Worn[this->session().id] = worn;
  this->Digest.clear();
  this->Traces.clear();
  this->answered(result.ticket);
  emit this->shown();
  this->Background->seen(result.ticket);
}

void Document::takeDetails(const Worker::Details& details)
{
  if (details.ticket != this->Result.ticket)
  {
    return; // a newer result has been taken
  }
  this->Result.nodes = details.nodes;
  this->Digest = details.digest;
  this->Detailed = details.ticket;
  if (details.ticket == this->Ticket)
  {
    // Learn where new strokes took hold, so that later ones can be told from it.
    Session learned = this->session();
    for (std::size_t i = 0; i < details.nodes.size(); ++i)
    {
      if (!learned.nodes[i].committed)
      {
        learned.nodes[i].committed = details.nodes[i].section;
      }
    }
    this->Changes->amend(std::move(learned));
    this->keep();
  }
  emit this->detailed();
  this->choose();
  if (!this->Saver.failure().empty())
  {
    emit this->autosaveFailed(QString::fromStdString(this->Saver.failure()));
  }
}

} // namespace oversketch_studio
