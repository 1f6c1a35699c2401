#include "section_finder.h"

#include "vtkOversketchOneStroke.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <limits>
#include <utility>

namespace oversketch_session
{

namespace
{

// VTK's commands carry one pointer.
struct Watch
{
  const std::atomic<std::uint64_t>& oldest;
  std::uint64_t ticket = 0;

  bool cancelled() const { return this->ticket < this->oldest; }
};

} // namespace

SectionFinder::SectionFinder(std::function<void()> found)
  : found_(std::move(found))
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
  std::size_t at = 0;
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
  {
    vtkDataArray* values = stroke->GetCellData()->GetArray(name);
    for (int c = 0;
         values && values->GetNumberOfTuples() > 0 && c < values->GetNumberOfComponents() && at < key.size();
         ++c)
    {
      key[at++] = values->GetComponent(0, c);
    }
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
  vtkNew<vtkOversketchOneStroke> system;
  // The curves do not wait for a device that a stroke is being run on.
  system->SetBackendToHost();
  Watch watch{ this->oldest_ };
  vtkNew<vtkCallbackCommand> ear;
  ear->SetClientData(&watch);
  ear->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void*)
    {
      if (static_cast<Watch*>(client)->cancelled())
      {
        static_cast<vtkOversketchOneStroke*>(caller)->AbortExecuteOn();
      }
    });
  system->AddObserver(vtkCommand::ProgressEvent, ear);
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
    watch.ticket = request.ticket;
    vtkNew<vtkPolyData> section;
    system->Preview(mesh, request.stroke, section);
    auto copy = vtkSmartPointer<vtkPolyData>::New(); // the system goes on with its own
    copy->DeepCopy(section);
    {
      const std::lock_guard<std::mutex> lock(this->mutex_);
      if (watch.cancelled())
      {
        continue;
      }
      this->answer_ = Found{ request.ticket, std::move(copy) };
    }
    this->found_();
  }
}

} // namespace oversketch_session
