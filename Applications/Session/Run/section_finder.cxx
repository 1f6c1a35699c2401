#include "section_finder.h"

#include "shared_data.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchStepRunner.h"
#include "vtkOversketchSystem.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace oversketch_session
{

SectionFinder::SectionFinder(const SystemRow& system, std::function<void()> found, Look look)
  : System(system)
  , WhenFound(std::move(found))
  , LookFor(std::move(look))
  , Thread([this] { this->work(); })
{
}

SectionFinder::~SectionFinder()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stop = true;
    this->Oldest = std::numeric_limits<std::uint64_t>::max();
  }
  this->Wake.notify_one();
  this->Thread.join();
}

void SectionFinder::setMesh(vtkPolyData* mesh)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  if (mesh->GetPoints())
  {
    copy->SetPoints(mesh->GetPoints());
    copy->SetPolys(mesh->GetPolys());
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Mesh.emplace(std::move(copy));
  this->Next.reset();
  this->Answer.reset();
  this->Oldest = this->Ticket + 1;
}

SectionFinder::ViewKey SectionFinder::viewOf(vtkPolyData* stroke)
{
  ViewKey key{};
  try
  {
    const oversketch::View view = oversketch::ViewOf(stroke);
    std::copy_n(view.viewTransform().data(), 16, key.begin());
    std::copy_n(view.projectionTransform().data(), 16, key.begin() + 16);
    key[32] = view.width();
    key[33] = view.height();
  }
  catch (const oversketch::Error&)
  {
    return {}; // nothing will be found for it
  }
  return key;
}

std::uint64_t SectionFinder::find(vtkPolyData* stroke, const Values& values)
{
  Request request;
  request.values = values;
  request.view = viewOf(stroke);
  request.stroke = deepCopyOf(stroke);
  std::uint64_t ticket = 0;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    ticket = request.ticket = ++this->Ticket;
    if (request.view != this->RunningView)
    {
      this->Oldest = ticket;
    }
    this->Next.emplace(std::move(request));
  }
  this->Wake.notify_one();
  return ticket;
}

std::optional<SectionFinder::Found> SectionFinder::take()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::exchange(this->Answer, std::nullopt);
}

void SectionFinder::work()
{
  const vtkSmartPointer<vtkOversketchSystem> system = this->System.make();
  // The curves do not wait for a device that a stroke is being run on.
  system->SetBackendToHost();
  vtkSmartPointer<vtkPolyData> mesh;
  for (;;)
  {
    std::optional<Request> next;
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Wake.wait(lock, [this] { return this->Stop || this->Next; });
      if (this->Stop)
      {
        return;
      }
      if (this->Mesh)
      {
        mesh = *this->Mesh;
        this->Mesh.reset();
      }
      next.swap(this->Next);
      this->RunningView = next->view;
    }
    const Request& request = *next;
    const auto cancelled = [&] { return request.ticket < this->Oldest; };
    vtkNew<vtkPolyData> section, crest;
    try
    {
      for (const Parameter& parameter : this->System.parameters)
      {
        const auto it = request.values.find(parameter.property);
        parameter.set(system, it == request.values.end() ? parameter.initial : it->second);
      }
      oversketch::StepRunner(system, { {}, {}, cancelled })
        .Run(
          [&]
          {
            if (this->LookFor)
            {
              this->LookFor(system, mesh, request.stroke, section, crest);
            }
            else
            {
              system->Preview(mesh, request.stroke, section);
            }
          });
    }
    catch (const oversketch::Error&)
    {
      section->Initialize();
      crest->Initialize();
    }
    Found made{ request.ticket, deepCopyOf(section), deepCopyOf(crest) }; // the system goes on with its own
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (cancelled())
      {
        continue;
      }
      this->Answer.emplace(std::move(made));
    }
    this->WhenFound();
  }
}

} // namespace oversketch_session
