// The caller of a running kernel: threads, a progress sink, a way to be cancelled; errors that say why it
// could not do its work; and back ends.
#ifndef oversketch_kernels_mesh_context_h
#define oversketch_kernels_mesh_context_h

#include "message.h"

#include <functional>
#include <stdexcept>

namespace oversketch
{

// Why a step could not do its work. A filter's error code is one of these values added to
// vtkErrorCode::UserError.
enum class Failure : int
{
  BadMesh = 1,      // not triangles, non-finite points, an id out of range
  MissingArray = 2, // an input array is absent or has the wrong shape
  BadStroke = 3,    // a stroke that must be refused: closed, too short, non-finite, two views
  NoMatch = 4,      // no silhouette section fits the stroke
  BadRegion = 5,    // the region is empty or reaches the whole mesh
  NoDevice = 6,     // the requested device is not there
  SolveFailed = 7,  // a linear system could not be factored
  Cancelled = 8,    // the caller asked to stop
  InnerStep = 9,    // a step inside a system failed
  Unexpected = 10,  // out of memory or a fault of a library
  Torn = 11         // the result is a wreck, and was not asked for all the same
};

// Thrown by kernels and filters. The message names the array, cell or point and the remedy.
class Error : public std::runtime_error
{
public:
  template <typename... Arguments>
  Error(Failure failure, const char* text, const Arguments&... arguments)
    : Error(failure, Message(text, arguments...))
  {
  }
  Error(Failure failure, const Message& message)
    : std::runtime_error(message.text())
    , Fail(failure)
    , What(message)
  {
  }
  Failure failure() const { return this->Fail; }
  const Message& message() const { return this->What; }

private:
  Failure Fail;
  Message What;
};

// A default-constructed context runs serially and cannot be cancelled.
struct Context
{
  using Body = std::function<void(int begin, int end)>;

  // Calls body on disjoint ranges that cover [0, count), on as many threads as the caller likes. A body
  // writes only to places that its own indices name, so results do not depend on the number of threads,
  // and it does not throw: it stops early when cancelled() is true.
  std::function<void(int count, const Body& body)> parallelFor = [](int count, const Body& body)
  {
    if (count > 0)
      body(0, count);
  };

  // Calls body(i) for each i in [0, count) in the same way.
  template <typename Each>
  void each(int count, const Each& body) const
  {
    this->parallelFor(count,
      [&body](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          body(i);
        }
      });
  }
  // Calls body(i) for each i where that takes long: for no more of them once cancelled() is true.
  template <typename Each>
  void eachUntilCancelled(int count, const Each& body) const
  {
    this->parallelFor(count,
      [this, &body](int begin, int end)
      {
        for (int i = begin; i < end && !this->cancelled(); ++i)
        {
          body(i);
        }
      });
  }

  // Takes progress in [0, 1]. Called by the kernel's own thread only.
  std::function<void(double)> progress = [](double) {};

  // True once the caller wants to stop. Cheap, callable from any thread.
  std::function<bool()> cancelled = [] { return false; };

  // Reports progress and throws Error(Failure::Cancelled) if the caller wants to stop.
  void checkpoint(double done) const
  {
    this->progress(done);
    if (this->cancelled())
    {
      throw Error(Failure::Cancelled, "cancelled");
    }
  }
};

// Auto and OpenCL mean the OpenCL device; where there is none, or it fails, the host stands in with a
// warning.
enum class Backend : int
{
  Auto = 0,
  OpenCL = 1,
  Host = 2
};

// The warning where there is none.
constexpr const char* noDeviceText = "There is no OpenCL device; the host computes instead.";

} // namespace oversketch
#endif
