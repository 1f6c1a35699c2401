// A document's drawings: begun over a picture or on an empty canvas, or a further part of the model.
#include "document.h"

#include "picture_files.h"
#include "row_texts.h"

#include <array>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr double canvasSize[2] = { 1024.0, 768.0 }; // of an empty one

} // namespace

Document::ReadDrawing Document::readDrawing(const QString& picture)
{
  const ReadPicture read = readPicture(picture);
  return { drawingOver(read.image), read.decoded };
}

bool Document::beginDrawing(const std::function<bool()>& mayLeave)
{
  return this->beginDrawing(drawingOn(canvasSize[0], canvasSize[1]), tr("Drawing"), mayLeave);
}

std::function<Document::ReadDrawing()> Document::partReader(const QString& picture) const
{
  // Before the model; where there is none yet, over what is drawn on.
  std::optional<Point> place;
  SharedStep first;
  if (this->Result.mesh && this->Result.mesh->GetNumberOfPoints() > 0)
  {
    double box[6];
    this->Result.mesh->GetBounds(box);
    place = { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), box[5] };
  }
  else if (!this->session().nodes.empty())
  {
    first = this->session().nodes.front().step;
  }
  return [picture, place, first]
  {
    const auto canvas = first ? canvasOf(*first) : std::array<double, 4>{};
    const Point middle{ 0.5 * (canvas[0] + canvas[2]), 0.5 * (canvas[1] + canvas[3]), 0.0 };
    const ReadPicture read = readPicture(picture);
    return ReadDrawing{ partOver(read.image, place ? *place : middle), read.decoded };
  };
}

bool Document::beginDrawing(SharedStep step, const QString& name, const std::function<bool()>& mayLeave)
{
  if (!mayLeave())
  {
    return false;
  }
  Session session;
  Node node;
  node.id = 1;
  node.name = titleOf(step->system).toStdString();
  node.step = std::move(step);
  session.nodes = { node };
  session.meshName = name.toStdString();
  session.backend = this->Backend;
  this->Path.clear();
  this->Seen.reset();
  this->start(std::move(session), true, {});
  emit this->opened();
  return true;
}

} // namespace oversketch_studio
