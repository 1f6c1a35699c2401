// The history of a document as a list: its order, what of it is shown.
#include "document.h"
#include "step_order.h"

namespace oversketch_studio
{

using namespace oversketch_session;

const Node* Document::nodeAt(int row) const
{
  const bool isThere = this->isOpen() && row >= 0 && indexOf(row) < this->session().nodes.size();
  return isThere ? &this->session().nodes[indexOf(row)] : nullptr;
}

bool Document::isOf(int row, const std::string& system) const
{
  const Node* node = this->nodeAt(row);
  return node && node->step->system == system;
}

void Document::remove(int index)
{
  Session next = this->session();
  if (this->Last == next.nodes[indexOf(index)].id)
  {
    this->Last = index > 0 ? next.nodes[indexOf(index) - 1].id : 0;
  }
  next.nodes.erase(next.nodes.begin() + index);
  this->commit(std::move(next));
}

void Document::move(int from, int to)
{
  if (from == to || faultOfMove(this->session(), indexOf(from), indexOf(to)))
  {
    return;
  }
  const int shown = this->shownTo();
  Session next = this->session();
  next.nodes = moved(std::move(next.nodes), indexOf(from), indexOf(to));
  if (this->Last) // as many as before, but for one that comes from the other side
  {
    const int count = shown + (from >= shown && to < shown) - (from < shown && to >= shown);
    this->Last = count > 0 ? next.nodes[indexOf(count) - 1].id : 0;
  }
  this->commit(std::move(next));
}

void Document::duplicate(int index)
{
  Session next = this->session();
  Node node = next.nodes[indexOf(index)];
  const int id = node.id;
  node.id = freshId(next);
  node.name = tr("%1 again").arg(QString::fromStdString(node.name)).toStdString();
  // A step of its own: where it is taken hold of depends on what comes before.
  node.step = std::make_shared<Step>(*node.step);
  node.committed.reset();
  next.nodes.insert(next.nodes.begin() + index + 1, node);
  this->Last = this->Last == id ? std::optional<int>(node.id) : this->Last;
  this->commit(std::move(next));
}

int Document::shownTo() const
{
  const std::vector<Node>& nodes = this->session().nodes;
  const int last = this->Last ? rowOf(nodes, *this->Last) : -1;
  if (last < 0) // also where it was undone
  {
    return this->Last == 0 ? 0 : static_cast<int>(nodes.size());
  }
  return last + 1;
}

void Document::showTo(int count)
{
  const std::vector<Node>& nodes = this->session().nodes;
  if (count == this->shownTo())
  {
    return;
  }
  this->Last.reset();
  if (indexOf(count) < nodes.size())
  {
    this->Last = count > 0 ? nodes[indexOf(count) - 1].id : 0;
  }
  this->submit();
  emit this->changed(Change::Edited);
}

} // namespace oversketch_studio
