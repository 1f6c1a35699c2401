// The first augmentation of a model, nothing known before: its time, and the memory of the process at its
// peak. Each size wants a process of its own.
#include "process_status.h"
#include "surface_stroke.h"

#include "vtkOversketchAugment.h"

#include <fstream>
#include <malloc.h>

namespace oversketch_bench
{

namespace
{

struct First
{
  vtkSmartPointer<vtkPolyData> mesh, stroke;
  vtkSmartPointer<vtkOversketchAugment> system;
  double before = 0.0;
};

} // namespace

void jobs()
{
  // Large blocks go back to the system when they are freed, so that the resident size follows what is in use.
  mallopt(M_MMAP_THRESHOLD, 1 << 16);
  for (const std::string& size : sizes({ "5k", "30k", "180k", "1M" }))
  {
    auto state = std::make_shared<First>();
    Job job;
    job.job = "first augmentation";
    job.size = size;
    job.who = "ours";
    job.prepare = [=]
    {
      if (!state->mesh)
      {
        state->mesh = model(size).polyData;
        state->stroke = surfaceStroke();
      }
      state->system = nullptr;
      // The mesh as if it were new: what filters share of a mesh is known by its modified time.
      state->mesh->GetPoints()->Modified();
      state->mesh->GetPolys()->Modified();
      malloc_trim(0);
      std::ofstream("/proc/self/clear_refs") << 5; // the peak counts from here
      state->before = status("VmRSS");
    };
    job.run = [=]
    {
      state->system = vtkSmartPointer<vtkOversketchAugment>::New();
      state->system->SetInputData(0, state->mesh);
      state->system->SetStrokesData(state->stroke);
      state->system->Update();
    };
    job.figures = [=]
    {
      const double peak = status("VmHWM"), triangles = static_cast<double>(state->mesh->GetNumberOfPolys());
      malloc_trim(0);
      return std::map<std::string, double>{ { "all_peak", (peak - state->before) / triangles },
        { "all_kept", (status("VmRSS") - state->before) / triangles },
        { "process_gib", peak / (1 << 30) } };
    };
    add(job);
  }
}

} // namespace oversketch_bench
