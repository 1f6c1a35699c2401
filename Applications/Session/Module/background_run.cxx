#include "background_run.h"

#include <algorithm>
#include <utility>

namespace oversketch_session
{

BackgroundRun::BackgroundRun()
  : Runner(this->listener())
{
}

Worker::Listener BackgroundRun::listener()
{
  Worker::Listener listener;
  listener.done = [this](Worker::Result result)
  {
    const std::uint64_t ticket = result.ticket;
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Came = std::move(result);
    }
    this->answer(ticket);
  };
  listener.cancelled = [this](std::uint64_t ticket) { this->answer(ticket); };
  listener.progress = [this](std::uint64_t, std::size_t node, const std::string& stage, double share)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Now = { node, stage, share };
  };
  return listener;
}

void BackgroundRun::answer(std::uint64_t ticket)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Answered = std::max(this->Answered, ticket);
  }
  this->Answer.notify_all();
}

std::uint64_t BackgroundRun::start(const Model& model)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Now = {};
  }
  this->Ticket = this->Runner.submit(model);
  return this->Ticket;
}

bool BackgroundRun::isRunning() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Answered < this->Ticket;
}

std::optional<Worker::Result> BackgroundRun::take()
{
  std::optional<Worker::Result> came;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    came = std::exchange(this->Came, std::nullopt);
  }
  if (came)
  {
    this->Runner.seen(came->ticket);
  }
  return came;
}

void BackgroundRun::wait()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Answer.wait(lock, [this] { return this->Answered >= this->Ticket; });
}

BackgroundRun::Progress BackgroundRun::progress() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Now;
}

} // namespace oversketch_session
