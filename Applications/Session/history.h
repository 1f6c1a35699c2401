// Undo and redo without limit over values that share what they have in common.
#ifndef oversketch_history_h
#define oversketch_history_h

#include "session.h"

#include <utility>
#include <vector>

namespace oversketch_session
{

class History
{
public:
  explicit History(Session start)
    : states_{ std::move(start) }
  {
  }

  const Session& now() const { return this->states_[this->at_]; }
  bool canUndo() const { return this->at_ > 0; }
  bool canRedo() const { return this->at_ + 1 < this->states_.size(); }

  // What was undone before is given up, as everywhere.
  void commit(Session next)
  {
    this->states_.resize(this->at_ + 1);
    this->states_.push_back(std::move(next));
    ++this->at_;
  }
  // Learned after the commit, such as where a stroke took hold: no step of its own.
  void amend(Session next) { this->states_[this->at_] = std::move(next); }
  void undo() { this->at_ -= this->canUndo() ? 1 : 0; }
  void redo() { this->at_ += this->canRedo() ? 1 : 0; }

private:
  std::vector<Session> states_;
  std::size_t at_ = 0;
};

} // namespace oversketch_session
#endif
