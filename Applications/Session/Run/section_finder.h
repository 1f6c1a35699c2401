// Finds what a stroke takes hold of while it is still being drawn, on a thread of its own, so that the pen
// never waits: the newest stroke wins.
#ifndef oversketch_applications_session_run_section_finder_h
#define oversketch_applications_session_run_section_finder_h

#include "systems.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace oversketch_session
{

class SectionFinder
{
public:
  // The section that the system's Preview gives, bit for bit, with its back end Host; empty where there is
  // nothing to take hold of.
  struct Found
  {
    std::uint64_t ticket = 0;
    vtkSmartPointer<vtkPolyData> section; // a copy that nobody else touches
    vtkSmartPointer<vtkPolyData> crest;   // the same, of what else the look gave
  };
  // How a system is asked: a mesh and a stroke, what it takes hold of, and lines of what it would make.
  using Look = std::function<void(vtkOversketchSystem* system,
    vtkPolyData* mesh,
    vtkPolyData* stroke,
    vtkPolyData* section,
    vtkPolyData* crest)>;

  // For strokes of a system. `found` is called on the finder's thread when there is something to take; so is
  // `look`, where a Preview is not all that is to be seen.
  SectionFinder(const SystemRow& system, std::function<void()> found, Look look = {});
  // Cancels what runs and waits for it.
  ~SectionFinder();

  // The newest answer, once. A stroke that a newer one replaced before it was looked at has none.
  std::optional<Found> take();

  // The mesh that strokes are drawn over from here on; its points and triangles are shared and must not be
  // changed. What runs on the last one is cancelled and not answered.
  void setMesh(vtkPolyData* mesh);
  // Looks for a stroke with its view, which is copied. One sample makes the curves of its view ready, for all
  // that come after. What runs for a stroke in another view is cancelled; in the same view it is finished and
  // answered, for its curves serve this one too. The values are those of the step that the stroke would be.
  // Returns the ticket, one more than the last.
  std::uint64_t find(vtkPolyData* stroke, const Values& values = {});

private:
  // View, projection and size of the window that the stroke was drawn in; zeros where it carries none.
  using ViewKey = std::array<double, 34>;
  // VTK collects its garbage without a lock, so what goes to another thread is moved there: by emplace, since
  // VTK 9.1's smart pointers copy where they are assigned and would leave a reference behind.
  struct Request
  {
    std::uint64_t ticket = 0;
    ViewKey view{};
    vtkSmartPointer<vtkPolyData> stroke;
    Values values;
  };
  static ViewKey viewOf(vtkPolyData* stroke);
  void work();

  const SystemRow& System;
  std::function<void()> WhenFound;
  Look LookFor;
  std::mutex Mutex;
  std::condition_variable Wake;
  std::optional<vtkSmartPointer<vtkPolyData>> Mesh; // until the thread takes it
  std::optional<Request> Next;
  std::optional<Found> Answer;
  ViewKey RunningView{};
  std::uint64_t Ticket = 0;               // of the newest stroke
  std::atomic<std::uint64_t> Oldest{ 0 }; // what was asked before this one is cancelled
  bool Stop = false;
  std::thread Thread;
};

} // namespace oversketch_session
#endif
