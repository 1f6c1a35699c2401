#include "worker.h"

#include "session_file.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSystem.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <chrono>
#include <malloc.h>

namespace oversketch_session
{

namespace
{

// Whoever shows a mesh first needs the processors: what comes after it waits so long, or until it is seen.
constexpr std::chrono::milliseconds detailsAfter{ 150 };
constexpr std::chrono::milliseconds prepareAfter{ 150 };
// Of so many triangles a step's work is not kept for a stroke over the same place, which then makes it anew:
// it takes some 400 bytes each.
constexpr vtkIdType largeMesh = 500000;

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

// The mesh with the same points, cells and arrays. Filters make new ones and change none that they have put
// out.
vtkSmartPointer<vtkPolyData> shared(vtkPolyData* mesh)
{
  auto own = vtkSmartPointer<vtkPolyData>::New();
  own->ShallowCopy(mesh);
  return own;
}

// True where `next` is `session` with steps added at its end.
bool continues(const Session& session, const Session& next)
{
  return session.mesh.identity() == next.mesh.identity() && session.backend == next.backend &&
         session.nodes.size() <= next.nodes.size() &&
         std::equal(session.nodes.begin(),
           session.nodes.end(),
           next.nodes.begin(),
           [](const Node& a, const Node& b) { return a.id == b.id && a.step == b.step && a.on == b.on; });
}

// The system that the next step is most likely of; null where there is none.
const SystemRow* nextOf(const Session& session)
{
  if (session.nodes.empty())
  {
    return systems().empty() ? nullptr : &systems().front();
  }
  return findSystem(session.nodes.back().step->system);
}

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* mesh)
{
  auto shown = vtkSmartPointer<vtkPolyData>::New();
  shown->ShallowCopy(mesh);
  if (!mesh->GetPointData()->GetNormals())
  {
    vtkNew<vtkTriangleFilter> triangles; // of a mesh of quads; points stay
    triangles->SetInputData(mesh);
    triangles->Update();
    const oversketch::Mesh surface = oversketch::MeshOf(triangles->GetOutput());
    const std::vector<oversketch::Vector3> normals =
      oversketch::vertexNormals(surface, oversketch::trianglesAround(surface), oversketch::ThreadsOnly());
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
  : Report(std::move(listener))
  , Thread([this] { this->work(); })
{
}

Worker::~Worker()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stop = true;
    this->Wanted = 0;
  }
  this->Wake.notify_one();
  this->Thread.join();
}

std::uint64_t Worker::submit(Session session)
{
  std::uint64_t replaced = 0, ticket = 0;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    replaced = this->Next ? this->Ticket : 0;
    ticket = ++this->Ticket;
    if (this->Wanted == 0 || !this->Running || !continues(*this->Running, session))
    {
      this->Wanted = ticket;
    }
    this->Next = std::move(session);
    this->Waiting = true;
  }
  this->Wake.notify_one();
  if (replaced && this->Report.cancelled)
  {
    this->Report.cancelled(replaced);
  }
  return ticket;
}

void Worker::seen(std::uint64_t ticket)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Seen = std::max(this->Seen, ticket);
  }
  this->Wake.notify_one();
}

void Worker::cancel()
{
  std::uint64_t waiting = 0;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    waiting = this->Next ? this->Ticket : 0;
    this->Next.reset();
    this->Waiting = false;
    this->Wanted = 0;
  }
  this->Wake.notify_one();
  if (waiting && this->Report.cancelled)
  {
    this->Report.cancelled(waiting);
  }
}

void Worker::work()
{
  for (;;)
  {
    Session session;
    std::uint64_t ticket = 0;
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Wake.wait(lock, [this] { return this->Stop || this->Next; });
      if (this->Stop)
      {
        return;
      }
      session = std::move(*this->Next);
      this->Running = session;
      this->Next.reset();
      this->Waiting = false;
      ticket = this->Ticket;
      this->Wanted = ticket;
    }
    this->runOne(ticket, session);
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Running.reset();
  }
}

std::vector<Worker::NodeState> Worker::statesOf(const Session& session, const std::vector<Outcome>& outcomes)
{
  std::map<std::uint64_t, NodeState> copies;
  std::vector<NodeState> states;
  for (const Outcome& outcome : outcomes)
  {
    const auto known = this->Copied.find(outcome.number);
    NodeState state = known == this->Copied.end() ? NodeState() : known->second;
    if (outcome.hold && !state.hold)
    {
      state.hold = copied(outcome.hold);
    }
    if (outcome.details && !state.region)
    {
      state.region = copied(outcome.details->region);
      state.following = outcome.details->following;
    }
    state.failure = outcome.failure;
    state.remark = outcome.remark;
    state.section = outcome.section;
    state.elsewhere = outcome.elsewhere;
    if (outcome.number != 0)
    {
      copies[outcome.number] = state;
    }
    states.push_back(std::move(state));
  }
  this->Copied = std::move(copies);
  this->addInputs(session, outcomes, states);
  return states;
}

void Worker::addInputs(const Session& session,
  const std::vector<Outcome>& outcomes,
  std::vector<NodeState>& states)
{
  const auto& nodes = session.nodes;
  const auto last = std::find_if(nodes.rbegin(), nodes.rend(), [](const Node& node) { return node.on; });
  const SystemRow* row = last == nodes.rend() ? nullptr : findSystem(last->step->system);
  if (!row || !row->changedOverInput)
  {
    this->Came = nullptr;
    this->CopyOfCame = {};
    return;
  }
  const auto at = static_cast<std::size_t>(nodes.rend() - last) - 1;
  const vtkSmartPointer<vtkPolyData> came = at > 0 ? outcomes[at - 1].mesh : nullptr;
  if (came && came != this->Came)
  {
    this->CopyOfCame = shared(came);
  }
  this->Came = came;
  states[at].before = at > 0 ? this->CopyOfCame : session.mesh;
  for (const auto& [name, input] : last->step->inputs)
  {
    const auto* of = std::get_if<StepOutput>(&input);
    for (std::size_t i = 0; of && i < at; ++i)
    {
      const auto output = outcomes[i].outputs.find(of->port);
      if (nodes[i].id == of->step && output != outcomes[i].outputs.end())
      {
        states[at].given[name] = copied(vtkPolyData::SafeDownCast(output->second));
      }
    }
  }
}

void Worker::runOne(std::uint64_t ticket, const Session& session)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Evaluator::Watch watch;
  watch.details = true;
  watch.cancelled = [&] { return this->Wanted != ticket; };
  watch.progress = [&](std::size_t node, const std::string& stage, double share)
  {
    if (this->Report.progress)
    {
      this->Report.progress(ticket, node, stage, share);
    }
  };
  std::vector<Outcome> outcomes;
  if (!this->Runner.run(session, watch, outcomes) || watch.cancelled())
  {
    if (this->Report.cancelled)
    {
      this->Report.cancelled(ticket);
    }
    return;
  }
  vtkPolyData* shown = resultOf(session, outcomes);
  Result result;
  result.ticket = ticket;
  result.nodes = this->statesOf(session, outcomes);
  result.backendUsed = backendUsedBy(outcomes);
  if (shown)
  {
    result.mesh = shared(shown);
    result.display = withNormals(result.mesh);
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (this->Report.done)
  {
    this->Report.done(std::move(result)); // this thread keeps nothing of it
  }
  if (shown)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Wake.wait_for(lock,
      detailsAfter,
      [&] { return this->Stop || this->Waiting || this->Seen >= ticket || watch.cancelled(); });
  }
  if (!this->Runner.details(outcomes, watch) || watch.cancelled())
  {
    return;
  }
  if (this->Report.detailed)
  {
    this->Report.detailed(
      { ticket, this->statesOf(session, outcomes), shown ? digestOf(shown) : std::string() });
  }
  if (shown && shown->GetNumberOfPolys() > largeMesh)
  {
    this->Runner.releaseWork();
    malloc_trim(0); // what was freed in pieces goes back as well
  }
  watch.cancelled = [&] { return this->Wanted != ticket || this->Waiting; };
  std::unique_lock<std::mutex> lock(this->Mutex);
  if (this->Wake.wait_for(lock, prepareAfter, [&] { return this->Stop || watch.cancelled(); }))
  {
    return;
  }
  lock.unlock();
  if (const SystemRow* next = shown ? nextOf(session) : nullptr)
  {
    this->Runner.prepare(*next, shown, session.backend, watch);
  }
}

} // namespace oversketch_session
