#include "edit_ground.h"

#include "document.h"
#include "edit_step.h"

#include <algorithm>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

int placeOf(const std::vector<Node>& nodes, int id)
{
  const auto at = std::find_if(nodes.begin(), nodes.end(), [&](const Node& node) { return node.id == id; });
  return at == nodes.end() ? -1 : static_cast<int>(at - nodes.begin());
}

} // namespace

EditGround::EditGround(const Document* document, QObject* parent)
  : QObject(parent)
  , OpenDocument(document)
{
  connect(document,
    &Document::grounded,
    this,
    [this](std::uint64_t number, const Worker::Ground& ground)
    {
      if (number == this->Number)
      {
        this->Number = 0;
        this->Came = ground;
        emit this->came();
      }
    });
  connect(document,
    &Document::opened,
    this,
    [this]
    {
      this->Asked = {};
      this->Came = {};
    });
}

const Worker::Ground* EditGround::of(int id)
{
  const Session& session = this->OpenDocument->session();
  const int at = placeOf(session.nodes, id);
  if (at < 0)
  {
    return nullptr;
  }
  const auto begin = session.nodes.begin();
  Place place{ session.mesh, { begin, begin + at + 1 }, session.backend };
  if (this->Number == 0 && this->isSame(place))
  {
    return &this->Came;
  }
  this->Asked = std::move(place); // also once more: the last asking may have been passed over
  this->Number = this->OpenDocument->askGround(at);
  return nullptr;
}

// Of the last step only what it takes of others matters.
bool EditGround::isSame(const Place& place) const
{
  const auto& known = this->Asked.nodes;
  if (known.size() != place.nodes.size() || known.back().id != place.nodes.back().id ||
      this->Asked.mesh.identity() != place.mesh.identity() || this->Asked.backend != place.backend)
  {
    return false;
  }
  const auto isSameNode = [](const Node& a, const Node& b)
  { return a.id == b.id && a.step == b.step && a.on == b.on; };
  const auto isSameTaken = [&](const SystemInput& input)
  {
    const auto taken = [&](const Node& node)
    {
      const auto one = node.step->inputs.find(input.name);
      return one != node.step->inputs.end() && std::holds_alternative<StepOutput>(one->second);
    };
    const Node &a = known.back(), &b = place.nodes.back();
    return taken(a) == taken(b) && (!taken(a) || isSameInput(*a.step, *b.step, input.name));
  };
  return std::equal(known.begin(), known.end() - 1, place.nodes.begin(), isSameNode) &&
         std::all_of(editRow().inputs.begin(), editRow().inputs.end(), isSameTaken);
}

QStringList EditGround::lost(int id) const
{
  QStringList names;
  const auto& nodes = this->OpenDocument->session().nodes;
  const auto& states = this->OpenDocument->result().nodes;
  const int at = placeOf(nodes, id);
  for (std::size_t i = indexOf(at + 1); at >= 0 && i < std::min(states.size(), nodes.size()); ++i)
  {
    if (nodes[i].on && (!states[i].failure.empty() || states[i].elsewhere))
    {
      names << QString::fromStdString(nodes[i].name);
    }
  }
  return names;
}

} // namespace oversketch_studio
