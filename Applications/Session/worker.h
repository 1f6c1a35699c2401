// Runs sessions on a thread of its own, so that an interface never waits: the newest session wins.
#ifndef oversketch_worker_h
#define oversketch_worker_h

#include "evaluator.h"
#include "session.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace oversketch_session
{

class Worker
{
public:
  // What one node did, for the history.
  struct NodeState
  {
    std::string failure;
    std::optional<Section> section;
    SharedData matched; // the place itself, a polyline; null where it did nothing
    bool elsewhere = false;
    // What it moved, and how that follows while the stroke is moved by hand; null where it did nothing.
    SharedData region;
    std::shared_ptr<const Following> following;
  };
  // What a session made. Meshes are copies that nobody else touches.
  struct Result
  {
    std::uint64_t ticket = 0;
    std::vector<NodeState> nodes;
    SharedData mesh;      // that the session shows
    SharedData display;   // the same with point normals, computed where it has none
    std::string digest;   // digestOf(mesh)
    int backendUsed = 0;  // vtkOversketchOneStroke::BackendType
    double seconds = 0.0; // that the run took
  };
  // Called on the worker's thread. A session that a newer one replaced, or that was cancelled, calls
  // cancelled.
  struct Listener
  {
    std::function<void(Result)> done;
    std::function<void(std::uint64_t ticket)> cancelled;
    std::function<void(std::uint64_t ticket, std::size_t node, const std::string& stage, double share)>
      progress;
  };

  explicit Worker(Listener listener);
  // Cancels what runs and waits for it.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Runs it as soon as it can, instead of what runs or waits; then prepares its result for the next stroke.
  // The session's data must not be changed afterwards. Returns the ticket, one more than the last.
  std::uint64_t submit(Session session);
  // Stops what runs or waits, if anything does.
  void cancel();

private:
  void work();
  void runOne(std::uint64_t ticket, const Session& session);

  Listener listener_;
  Evaluator evaluator_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Session> next_;
  Session running_;
  std::uint64_t ticket_ = 0;               // of the newest session
  std::atomic<std::uint64_t> wanted_{ 0 }; // the ticket that may run; all others are to stop
  std::atomic<bool> waiting_{ false };     // a session does, so nothing is to be prepared
  bool stop_ = false;
  std::thread thread_;
};

} // namespace oversketch_session
#endif
