#include "section_finder.h"

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

SectionFinder::SectionFinder(const SystemRow& system, std::function<void()> found)
  : system_(system)
  , found_(std::move(found))
  , thread_([this] { this->work(); })
{
}

SectionFinder::~SectionFinder()
{
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    this->stop_ = true;
    this->oldest_ = std::numeric_limits<std::uint64_t>::max();
  }
  this->wake_.notify_one();
  this->thread_.join();
}

void SectionFinder::setMesh(vtkPolyData* mesh)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  if (mesh->GetPoints())
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(mesh->GetPoints()->GetDataType());
    points->DeepCopy(mesh->GetPoints());
    copy->SetPoints(points);
    vtkNew<vtkCellArray> triangles;
    triangles->DeepCopy(mesh->GetPolys());
    copy->SetPolys(triangles);
  }
  const std::lock_guard<std::mutex> lock(this->mutex_);
  this->mesh_ = std::move(copy);
  this->next_.reset();
  this->answer_.reset();
  this->oldest_ = this->ticket_ + 1;
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

std::uint64_t SectionFinder::find(vtkPolyData* stroke)
{
  Request request;
  request.view = viewOf(stroke);
  request.stroke = vtkSmartPointer<vtkPolyData>::New();
  request.stroke->DeepCopy(stroke);
  std::uint64_t ticket = 0;
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    ticket = request.ticket = ++this->ticket_;
    if (request.view != this->runningView_)
    {
      this->oldest_ = ticket;
    }
    this->next_ = std::move(request);
  }
  this->wake_.notify_one();
  return ticket;
}

std::optional<SectionFinder::Found> SectionFinder::take()
{
  const std::lock_guard<std::mutex> lock(this->mutex_);
  return std::exchange(this->answer_, std::nullopt);
}

void SectionFinder::work()
{
  const vtkSmartPointer<vtkOversketchSystem> system = this->system_.make();
  // The curves do not wait for a device that a stroke is being run on.
  system->SetBackendToHost();
  vtkSmartPointer<vtkPolyData> mesh;
  for (;;)
  {
    Request request;
    {
      std::unique_lock<std::mutex> lock(this->mutex_);
      this->wake_.wait(lock, [this] { return this->stop_ || this->next_; });
      if (this->stop_)
      {
        return;
      }
      if (this->mesh_)
      {
        mesh = this->mesh_;
        this->mesh_ = nullptr;
      }
      request = std::move(*this->next_);
      this->next_.reset();
      this->runningView_ = request.view;
    }
    const auto cancelled = [&] { return request.ticket < this->oldest_; };
    vtkNew<vtkPolyData> section;
    try
    {
      oversketch::StepRunner(system, { {}, {}, cancelled })
        .Run([&] { system->Preview(mesh, request.stroke, section); });
    }
    catch (const oversketch::Error&)
    {
      section->Initialize();
    }
    auto copy = vtkSmartPointer<vtkPolyData>::New(); // the system goes on with its own
    copy->DeepCopy(section);
    {
      const std::lock_guard<std::mutex> lock(this->mutex_);
      if (cancelled())
      {
        continue;
      }
      this->answer_ = Found{ request.ticket, std::move(copy) };
    }
    this->found_();
  }
}

} // namespace oversketch_session
