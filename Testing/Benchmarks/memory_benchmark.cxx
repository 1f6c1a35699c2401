// The first stroke on a model, nothing known before: its time, and the memory that each stage takes for a
// while (peak) and holds from then on (kept), in bytes a triangle of the model.
#include "bunny_stroke.h"
#include "process_status.h"

#include "vtkOversketchOneStroke.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <array>
#include <fstream>
#include <malloc.h>

namespace oversketch_bench
{

namespace
{

struct FirstStroke
{
  void run()
  {
    this->system = vtkSmartPointer<vtkOversketchOneStroke>::New();
    this->system->SetRemesh(vtkOversketchOneStroke::RemeshOn);
    this->system->SetInputData(0, this->mesh);
    this->system->SetStrokeData(this->stroke);
    vtkNew<vtkCallbackCommand> observer;
    observer->SetClientData(this);
    observer->SetCallback([](vtkObject* step, unsigned long event, void* self, void*)
      { static_cast<FirstStroke*>(self)->see(step, event); });
    for (const char* name : names)
    {
      this->system->GetStep(name)->AddObserver(vtkCommand::StartEvent, observer);
      this->system->GetStep(name)->AddObserver(vtkCommand::EndEvent, observer);
    }
    this->system->Update();
    for (const char* name : names)
    {
      this->system->GetStep(name)->RemoveObserver(observer);
    }
  }

  void see(vtkObject* step, unsigned long event)
  {
    if (event == vtkCommand::StartEvent)
    {
      malloc_trim(0);
      std::ofstream("/proc/self/clear_refs") << 5; // the peak counts from here
      this->before = status("VmRSS");
      return;
    }
    for (const char* name : names)
    {
      if (this->system->GetStep(name) == step)
      {
        this->figures[std::string(name) + "_peak"] = this->each(status("VmHWM") - this->before);
        malloc_trim(0);
        this->figures[std::string(name) + "_kept"] = this->each(status("VmRSS") - this->before);
      }
    }
    this->process = std::max(this->process, status("VmHWM"));
  }

  double each(double bytes) const
  {
    return std::max(0.0, bytes) / static_cast<double>(this->mesh->GetNumberOfPolys());
  }

  static constexpr std::array<const char*, 14> names = { "Silhouette",
    "Snake",
    "Visibility",
    "Outline",
    "Match",
    "Targets",
    "ShapeDiameter",
    "MixtureRegion",
    "RegionBorder",
    "Stretch",
    "DeformRemeshed",
    "CorrectionRemeshed",
    "DeformRemeshedCorrected",
    "Restore" };
  vtkSmartPointer<vtkPolyData> mesh, stroke;
  vtkSmartPointer<vtkOversketchOneStroke> system;
  std::map<std::string, double> figures;
  double before = 0.0, process = 0.0;
};

} // namespace

void jobs()
{
  // Large blocks go back to the system when they are freed, so that the resident size follows what is in use.
  mallopt(M_MMAP_THRESHOLD, 1 << 16);
  for (const std::string& size : sizes({ "5k", "30k", "180k", "1M" }))
  {
    auto state = std::make_shared<FirstStroke>();
    Job job;
    job.job = "first stroke";
    job.size = size;
    job.who = "ours";
    job.prepare = [=]
    {
      if (!state->mesh)
      {
        state->mesh = model(size).polyData;
        state->stroke = earStroke(state->mesh);
      }
      state->system = nullptr;
      // The mesh as if it were new: what filters share of a mesh is known by its modified time.
      state->mesh->GetPoints()->Modified();
      state->mesh->GetPolys()->Modified();
    };
    job.run = [state] { state->run(); };
    job.figures = [state]
    {
      auto figures = state->figures;
      figures["process_gib"] = state->process / (1 << 30);
      return figures;
    };
    add(job);
  }
}

} // namespace oversketch_bench
