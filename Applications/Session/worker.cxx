#include "worker.h"

#include "session_file.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchOneStroke.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
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

// True where `next` is `session` with strokes added at its end.
bool continues(const Session& session, const Session& next)
{
  return session.mesh == next.mesh && session.backend == next.backend &&
         session.nodes.size() <= next.nodes.size() &&
         std::equal(session.nodes.begin(),
           session.nodes.end(),
           next.nodes.begin(),
           [](const Node& a, const Node& b) { return a.action == b.action && a.on == b.on; });
}

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* mesh)
{
  auto shown = vtkSmartPointer<vtkPolyData>::New();
  shown->ShallowCopy(mesh);
  if (!mesh->GetPointData()->GetNormals())
  {
    const std::vector<oversketch::Vector3> normals = oversketch::vertexNormals(oversketch::MeshOf(mesh));
    vtkNew<vtkFloatArray> array;
    array->SetName("Normals");
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(mesh->GetNumberOfPoints());
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      array->SetTuple(static_cast<vtkIdType>(i), normals[i].data());
    }
    shown->GetPointData()->SetNormals(array);
  }
  return shown;
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
    ticket = ++this->ticket_;
    if (this->wanted_ == 0 || !this->running_.mesh || !continues(this->running_, session))
    {
      this->wanted_ = ticket;
    }
    this->next_ = std::move(session);
    this->waiting_ = true;
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
    this->waiting_ = false;
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
      this->running_ = session;
      this->next_.reset();
      this->waiting_ = false;
      ticket = this->ticket_;
      this->wanted_ = ticket;
    }
    this->runOne(ticket, session);
    const std::lock_guard<std::mutex> lock(this->mutex_);
    this->running_ = Session();
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
    result.nodes.push_back({ outcome.failure,
      outcome.section,
      copied(outcome.matched),
      outcome.elsewhere,
      copied(outcome.region),
      outcome.following });
  }
  vtkPolyData* shown = resultOf(session, outcomes);
  result.mesh = copied(shown);
  result.display = withNormals(result.mesh);
  result.digest = digestOf(shown);
  result.backendUsed = this->evaluator_.system()->GetBackendUsed();
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (this->listener_.done)
  {
    this->listener_.done(std::move(result)); // this thread keeps nothing of it
  }
  watch.cancelled = [&] { return this->wanted_ != ticket || this->waiting_; };
  this->evaluator_.prepare(shown, watch);
}

} // namespace oversketch_session
