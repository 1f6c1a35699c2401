// The models of a document's scene: one is worked on, the others rest beside it.
#include "document.h"

#include "files.h"
#include "models.h"
#include "systems.h"

#include <algorithm>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

Document::Opened Document::readModels(const QString& path, int backend, vtkIdType most)
{
  Opened opened = Document::read(path, backend, most);
  Session scene;
  scene.others = modelsOf(opened.session);
  scene.pictures = opened.session.pictures;
  for (const auto& model : scene.others)
  {
    for (const SharedPicture& picture : decodedOf(model->made.display))
    {
      opened.pictures.push_back(picture);
    }
  }
  opened.session = std::move(scene);
  return opened;
}

void Document::addModels(const Opened& opened)
{
  const Session& more = opened.session;
  if (modelCount(this->session()) + more.others.size() > mostModels)
  {
    throw oversketch_files::Failed(
      tr("A scene has at most %1 models. Remove some first.").arg(mostModels).toStdString());
  }
  const std::size_t first = modelCount(this->session());
  Session next = withModels(this->session(), more.others);
  next.pictures.insert(next.pictures.end(), more.pictures.begin(), more.pictures.end());
  this->commitScene(std::move(next));
  this->holdWorn();
  this->chooseModel(static_cast<int>(first));
}

void Document::holdWorn()
{
  for (const auto& other : this->session().others)
  {
    if (this->Worn.count(other->own.id) == 0)
    {
      this->Worn[other->own.id] = decodedOf(other->made.display);
    }
  }
}

void Document::chooseModel(int place)
{
  this->Wanted = modelAt(this->session(), indexOf(place)).id;
  this->choose();
}

void Document::choose()
{
  const Session before = this->session();
  const int place = placeOfModel(before, this->Wanted);
  if (place < 0 || place == static_cast<int>(before.place))
  {
    this->Wanted = 0;
    return;
  }
  // It rests with what all of its steps make.
  this->showTo(static_cast<int>(before.nodes.size()));
  if (!this->isSettled())
  {
    return;
  }
  if (this->Result.ticket != this->Ticket) // its steps were cancelled
  {
    this->submit();
    return;
  }
  this->Wanted = 0;
  this->Changes->amend(this->chosen(place)); // what is looked at: no step of undo
  this->turnFrom(before);
}

Session Document::chosen(int place) const
{
  return withChosen(this->session(),
    indexOf(place),
    { this->Result.mesh, this->Result.display, this->Result.parts, this->Digest, this->Result.backendUsed });
}

// Where that brings another model, it is shown as it rested until its steps have run.
void Document::turnFrom(const Session& before)
{
  const int id = this->session().id;
  if (id == before.id)
  {
    this->run(Change::Edited);
    return;
  }
  this->Result = {};
  this->Digest.clear();
  this->Traces.clear();
  this->Last.reset();
  this->First = this->Ticket + 1;
  const auto& others = before.others;
  const auto same =
    std::find_if(others.begin(), others.end(), [id](const auto& other) { return other->own.id == id; });
  if (same != others.end())
  {
    this->Result.mesh = (*same)->made.mesh;
    this->Result.display = (*same)->made.display;
    this->Result.parts = (*same)->made.parts;
    this->Result.backendUsed = (*same)->made.backendUsed;
  }
  this->run(Change::Edited);
  emit this->opened();
  emit this->shown();
}

void Document::removeModel(int place)
{
  const Session before = this->session();
  const auto count = static_cast<int>(modelCount(before));
  if (count < 2 || place >= count)
  {
    return;
  }
  if (place != static_cast<int>(before.place))
  {
    this->commitScene(withoutModel(before, indexOf(place)));
    return;
  }
  this->Changes->commit(
    withoutModel(this->chosen(place + 1 < count ? place + 1 : place - 1), indexOf(place)));
  this->turnFrom(before);
}

void Document::setModel(int place, bool shown, bool locked)
{
  const Model& now = modelAt(this->session(), indexOf(place));
  if (now.shown != shown || now.locked != locked)
  {
    this->commitScene(withModelSeen(this->session(), indexOf(place), shown, locked));
  }
}

void Document::setPart(int number, bool shown)
{
  this->commitScene(withPartSeen(this->session(), sourceOf(this->Result.parts, number), shown));
}

QString Document::whyNoSteps(const std::string& system) const
{
  const Session& scene = this->session();
  const QString name = QString::fromStdString(this->session().meshName);
  const SystemRow* row = findSystem(system);
  return scene.locked   ? tr("%1 is locked and takes no strokes. Unlock it in the list Scene.").arg(name)
         : !scene.shown ? tr("%1 is hidden and takes no strokes. Tick it in the list Scene.").arg(name)
         : scene.whole && row && !row->moves ? tr("%1 is shown by fewer triangles than it has, and this "
                                                  "would change those alone. Open a coarser "
                                                  "copy of it.")
                                                 .arg(name)
                                             : QString();
}

bool Document::takes(const Session& next)
{
  QString why = this->whyNoSteps();
  for (std::size_t i = 0; why.isEmpty() && i < next.nodes.size(); ++i)
  {
    why = next.nodes[i].on ? this->whyNoSteps(next.nodes[i].step->system) : why;
  }
  if (why.isEmpty() || next.nodes == this->session().nodes)
  {
    return true;
  }
  emit this->refused(why);
  return false;
}

} // namespace oversketch_studio
