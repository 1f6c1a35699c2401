// Undo and redo without limit. What is kept of a change is what it changed.
#ifndef oversketch_applications_session_scene_history_h
#define oversketch_applications_session_scene_history_h

#include "session.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace oversketch_session
{

class History
{
public:
  explicit History(Session start)
    : Now(std::move(start))
  {
  }

  const Session& now() const { return this->Now; }
  bool canUndo() const { return this->At > 0; }
  bool canRedo() const { return this->At < this->Edits.size(); }
  // The session as it is now is on the disk. Undo and redo lead away from it and back to it.
  void markSaved() { this->SavedAt = this->At; }
  bool isSaved() const { return this->SavedAt == this->At; }

  // Changes that were undone before are given up, as everywhere.
  void commit(Session next)
  {
    if (this->SavedAt && *this->SavedAt > this->At)
    {
      this->SavedAt.reset();
    }
    this->Edits.resize(this->At);
    this->Edits.push_back(between(this->Now, next));
    this->Now = std::move(next);
    ++this->At;
  }
  // One step of undo with the last change.
  void mergeIntoLast(Session next)
  {
    if (this->isSaved())
    {
      this->SavedAt.reset();
    }
    this->amend(std::move(next));
  }
  // Learned after the commit, such as where a stroke took hold: no step of its own.
  void amend(Session next)
  {
    if (this->canUndo())
    {
      Edit& last = this->Edits[this->At - 1];
      last = between(applied(this->Now, last.first, last.after, last.before), next);
    }
    if (this->canRedo())
    {
      Edit& following = this->Edits[this->At];
      following = between(next, applied(this->Now, following.first, following.before, following.after));
    }
    this->Now = std::move(next);
  }
  void undo()
  {
    if (this->canUndo())
    {
      const Edit& edit = this->Edits[--this->At];
      this->Now = applied(std::move(this->Now), edit.first, edit.after, edit.before);
    }
  }
  void redo()
  {
    if (this->canRedo())
    {
      const Edit& edit = this->Edits[this->At++];
      this->Now = applied(std::move(this->Now), edit.first, edit.before, edit.after);
    }
  }

private:
  // Two sessions, each with only those nodes, from the place `first` on, that the other has not.
  struct Edit
  {
    std::size_t first = 0;
    Session before, after;
  };

  static Edit between(const Session& before, const Session& after)
  {
    const auto &a = before.nodes, &b = after.nodes;
    const std::size_t most = std::min(a.size(), b.size());
    std::size_t first = 0, last = 0; // nodes that both begin and end with
    while (first < most && a[first] == b[first])
    {
      ++first;
    }
    while (first + last < most && a[a.size() - 1 - last] == b[b.size() - 1 - last])
    {
      ++last;
    }
    const auto part = [&](Session of)
    {
      of.nodes = { of.nodes.begin() + static_cast<std::ptrdiff_t>(first),
        of.nodes.end() - static_cast<std::ptrdiff_t>(last) };
      return of;
    };
    return { first, part(before), part(after) };
  }

  static Session applied(Session to, std::size_t first, const Session& gone, const Session& come)
  {
    const auto at = to.nodes.begin() + static_cast<std::ptrdiff_t>(first);
    const auto place = to.nodes.erase(at, at + static_cast<std::ptrdiff_t>(gone.nodes.size()));
    to.nodes.insert(place, come.nodes.begin(), come.nodes.end());
    std::vector<Node> nodes = std::move(to.nodes);
    to = come;
    to.nodes = std::move(nodes);
    return to;
  }

  Session Now;
  std::vector<Edit> Edits; // the first At of them lead here
  std::size_t At = 0;
  std::optional<std::size_t> SavedAt; // of At
};

} // namespace oversketch_session
#endif
