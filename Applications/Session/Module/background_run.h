// A worker for an owner who asks instead of being told, on one thread of its own.
#ifndef oversketch_applications_session_module_background_run_h
#define oversketch_applications_session_module_background_run_h

#include "worker.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

namespace oversketch_session
{

class BackgroundRun
{
public:
  BackgroundRun();

  // Runs a model instead of what runs. Returns its ticket.
  std::uint64_t start(const Model& model);
  // Ticket of the last model that was started.
  std::uint64_t ticket() const { return this->Ticket; }
  bool isRunning() const;
  // The newest result that has come since the last call.
  std::optional<Worker::Result> take();
  void wait();
  void cancel() { this->Runner.cancel(); }

  struct Progress
  {
    std::size_t node = 0;
    std::string stage;
    double share = 0.0; // of the node [0 to 1]
  };
  Progress progress() const;

private:
  Worker::Listener listener();
  void answer(std::uint64_t ticket);

  mutable std::mutex Mutex;
  std::condition_variable Answer;
  std::optional<Worker::Result> Came;
  Progress Now;
  std::uint64_t Ticket = 0, Answered = 0;
  // Last, so that it ends first: it calls the rest.
  Worker Runner;
};

} // namespace oversketch_session
#endif
