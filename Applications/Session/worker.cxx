#include "worker.h"

#include "session_file.h"

#include "vtkOversketchOneStroke.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <chrono>

namespace oversketch_session
{

namespace
{

vtkSmartPointer<vtkPolyData> copied(vtkPolyData* data)
{
  if (!data)
  {
    return nullptr;
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

} // namespace

Worker::Worker(Listener listener)
  : listener_(std::move(listener))
  , thread_([this] { this->work(); })
{
}

Worker::~Worker()
{
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    this->stop_ = true;
    this->wanted_ = 0;
  }
  this->wake_.notify_one();
  this->thread_.join();
}

std::uint64_t Worker::submit(Session session)
{
  std::uint64_t replaced = 0, ticket = 0;
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    replaced = this->next_ ? this->ticket_ : 0;
    this->next_ = std::move(session);
    ticket = ++this->ticket_;
    this->wanted_ = ticket;
  }
  this->wake_.notify_one();
  if (replaced && this->listener_.cancelled)
  {
    this->listener_.cancelled(replaced);
  }
  return ticket;
}

void Worker::cancel()
{
  std::uint64_t waiting = 0;
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    waiting = this->next_ ? this->ticket_ : 0;
    this->next_.reset();
    this->wanted_ = 0;
  }
  if (waiting && this->listener_.cancelled)
  {
    this->listener_.cancelled(waiting);
  }
}

void Worker::work()
{
  for (;;)
  {
    Session session;
    std::uint64_t ticket = 0;
    {
      std::unique_lock<std::mutex> lock(this->mutex_);
      this->wake_.wait(lock, [this] { return this->stop_ || this->next_; });
      if (this->stop_)
      {
        return;
      }
      session = std::move(*this->next_);
      this->next_.reset();
      ticket = this->ticket_;
    }
    this->runOne(ticket, session);
  }
}

void Worker::runOne(std::uint64_t ticket, const Session& session)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Evaluator::Watch watch;
  watch.cancelled = [&] { return this->wanted_ != ticket; };
  watch.progress = [&](std::size_t node, const std::string& stage, double share)
  {
    if (this->listener_.progress)
    {
      this->listener_.progress(ticket, node, stage, share);
    }
  };
  std::vector<Outcome> outcomes;
  if (!this->evaluator_.run(session, watch, outcomes) || watch.cancelled())
  {
    if (this->listener_.cancelled)
    {
      this->listener_.cancelled(ticket);
    }
    return;
  }
  Result result;
  result.ticket = ticket;
  for (const Outcome& outcome : outcomes)
  {
    result.nodes.push_back({ outcome.failure, outcome.section, outcome.elsewhere });
    result.matched = outcome.matched ? outcome.matched : result.matched;
  }
  vtkPolyData* shown = resultOf(session, outcomes);
  result.mesh = copied(shown);
  result.matched = copied(result.matched);
  result.digest = digestOf(shown);
  result.backendUsed = this->evaluator_.system()->GetBackendUsed();
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (this->listener_.done)
  {
    this->listener_.done(result);
  }
  this->evaluator_.prepare(shown, watch);
}

} // namespace oversketch_session
