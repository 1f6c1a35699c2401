#include "worker.h"

#include "drawing_lines.h"
#include "models.h"
#include "point_normals.h"
#include "session_file.h"
#include "step_lines.h"

#include "Mesh/context.h"
#include "Stroke/canvas.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSystem.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <malloc.h>
#include <utility>

namespace oversketch_session
{

namespace
{

// Whoever shows a mesh first needs the processors: what comes after it waits so long, or until it is seen.
constexpr std::chrono::milliseconds detailsAfter{ 150 };
constexpr std::chrono::milliseconds prepareAfter{ 150 };
constexpr std::size_t mostPictures = 1000; // some 50 MB
constexpr double traceReach = 0.1;         // of the model's diagonal, from a stroke to the surface

// True where `next` is `model` with steps added at its end.
bool continues(const Model& model, const Model& next)
{
  return model.mesh.identity() == next.mesh.identity() && model.backend == next.backend &&
         model.nodes.size() <= next.nodes.size() &&
         std::equal(model.nodes.begin(),
           model.nodes.end(),
           next.nodes.begin(),
           [](const Node& a, const Node& b) { return a.id == b.id && a.step == b.step && a.on == b.on; });
}

// The system that the next step is most likely of; null where there is none.
const SystemRow* nextOf(const Model& model)
{
  if (model.nodes.empty())
  {
    return systems().empty() ? nullptr : &systems().front();
  }
  return findSystem(model.nodes.back().step->system);
}

double areaOf(vtkPolyData* mesh)
{
  double area = 0.0, p[3][3];
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetPolys()->GetNumberOfCells(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    mesh->GetPoint(ids->GetId(0), p[0]);
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
    {
      mesh->GetPoint(ids->GetId(i - 1), p[1]);
      mesh->GetPoint(ids->GetId(i), p[2]);
      area += vtkTriangle::TriangleArea(p[0], p[1], p[2]);
    }
  }
  return area;
}

// Copies what a step takes of other steps.
std::map<std::string, SharedData> givenTo(const Model& model,
  const std::vector<Outcome>& outcomes,
  std::size_t at)
{
  std::map<std::string, SharedData> given;
  for (const auto& [name, input] : model.nodes[at].step->inputs)
  {
    const auto* of = std::get_if<StepOutput>(&input);
    const int row = of ? rowOf(model.nodes, of->step) : -1;
    if (row < 0 || row >= static_cast<int>(at))
    {
      continue;
    }
    const auto& outputs = outcomes[static_cast<std::size_t>(row)].outputs;
    if (const auto output = outputs.find(of->port); output != outputs.end())
    {
      vtkPolyData* data = vtkPolyData::SafeDownCast(output->second);
      given[name] = data ? deepCopyOf(data) : nullptr;
    }
  }
  return given;
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

std::uint64_t Worker::submit(Model model)
{
  std::uint64_t replaced = 0, ticket = 0;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    replaced = this->Next ? this->Ticket : 0;
    ticket = ++this->Ticket;
    if (this->Wanted == 0 || !this->Running || !continues(*this->Running, model))
    {
      this->Wanted = ticket;
    }
    this->Next = std::move(model);
    this->Aside.reset();
    this->Waiting = true;
  }
  this->Wake.notify_one();
  if (replaced)
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
    this->Aside.reset();
    this->Waiting = false;
    this->Wanted = 0;
  }
  this->Wake.notify_one();
  if (waiting)
  {
    this->Report.cancelled(waiting);
  }
}

void Worker::evaluateAside(Model model)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Next)
    {
      return;
    }
    this->Aside = std::move(model);
    this->Waiting = true;
  }
  this->Wake.notify_one();
}

void Worker::work()
{
  for (;;)
  {
    std::optional<Model> model;
    std::uint64_t ticket = 0;
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Wake.wait(lock, [this] { return this->Stop || this->Next || this->Aside; });
      if (this->Stop)
      {
        return;
      }
      model = std::exchange(this->Next, std::nullopt);
      if (model)
      {
        this->Running = model;
        this->Waiting = false;
      }
      ticket = this->Ticket;
      this->Wanted = ticket;
    }
    model ? this->runOne(ticket, *model) : this->runAside(ticket);
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Running.reset();
  }
}

std::vector<Worker::NodeState> Worker::statesOf(const Model& model, const std::vector<Outcome>& outcomes)
{
  std::map<std::uint64_t, NodeState> copies;
  std::vector<NodeState> states;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
  {
    const Outcome& outcome = outcomes[i];
    const auto known = this->Copied.find(outcome.number);
    const bool isKnown = known != this->Copied.end();
    NodeState state = isKnown ? known->second : NodeState();
    if (!isKnown)
    {
      state.before =
        i == 0 ? model.mesh
               : SharedData(outcomes[i - 1].mesh ? shallowCopyOf(outcomes[i - 1].mesh.Get()) : nullptr);
      state.given = givenTo(model, outcomes, i);
    }
    if (outcome.hold && !state.hold)
    {
      state.hold = deepCopyOf(outcome.hold);
    }
    if (outcome.details && !state.region)
    {
      state.region = deepCopyOf(outcome.details->region);
      state.following = outcome.details->following;
      const double whole = areaOf(outcome.mesh);
      state.share = whole > 0.0 ? areaOf(state.region) / whole : 0.0;
    }
    state.failure = outcome.failure;
    // A host that computes is no flaw of a result; the window says elsewhere what computes.
    std::vector<oversketch::Message> remarks;
    std::copy_if(outcome.remarks.begin(),
      outcome.remarks.end(),
      std::back_inserter(remarks),
      [](const oversketch::Message& remark) { return remark.id() != oversketch::noDeviceText; });
    state.remark = oversketch::Message::joined(remarks);
    state.section = outcome.section;
    state.elsewhere = outcome.elsewhere;
    const auto drawn = this->Pictures.find(outcome.number);
    state.picture = drawn == this->Pictures.end() ? nullptr : drawn->second;
    if (outcome.number != 0)
    {
      copies[outcome.number] = state;
    }
    states.push_back(std::move(state));
  }
  this->Copied = std::move(copies);
  return states;
}

void Worker::runAside(std::uint64_t ticket)
{
  std::optional<Model> model;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    model = std::exchange(this->Aside, std::nullopt);
    this->Waiting = this->Next.has_value();
  }
  if (!model)
  {
    return;
  }
  Evaluator::Watch watch;
  watch.cancelled = [&] { return this->Wanted != ticket; };
  std::vector<Outcome> outcomes;
  if (this->Report.evaluatedAside && this->Runner.run(*model, watch, outcomes) && !watch.cancelled())
  {
    vtkPolyData* made = resultOf(*model, outcomes);
    SharedData display;
    if (made)
    {
      display = oversketch_files::withPointNormals(shallowCopyOf(made));
    }
    this->Report.evaluatedAside(std::move(display));
  }
}

// Keeps what was made of a mesh that is the last one, to the bit.
void Worker::show(vtkPolyData* mesh, Result& result)
{
  if (!this->Shown || !isShallowCopy(mesh, this->Shown))
  {
    this->Display = nullptr; // before the next one is made
    this->Shown = shallowCopyOf(mesh);
    this->Display = oversketch_files::withPointNormals(this->Shown);
  }
  result.mesh = shallowCopyOf(this->Shown.Get());
  result.display = shallowCopyOf(this->Display.Get());
}

void Worker::runOne(std::uint64_t ticket, const Model& model)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Evaluator::Watch watch;
  watch.details = true;
  watch.cancelled = [&] { return this->Wanted != ticket; };
  watch.progress = [&](std::size_t node, const std::string& stage, double share)
  { this->Report.progress(ticket, node, stage, share); };
  std::vector<Outcome> outcomes;
  if (!this->Runner.run(model, watch, outcomes) || watch.cancelled())
  {
    this->Report.cancelled(ticket);
    return;
  }
  vtkPolyData* shown = resultOf(model, outcomes);
  Result result;
  result.ticket = ticket;
  result.nodes = this->statesOf(model, outcomes);
  result.backendUsed = backendUsedBy(outcomes);
  if (shown)
  {
    this->show(shown, result);
    result.parts = sourcesOf(model, outcomes);
  }
  else
  {
    this->Shown = this->Display = nullptr;
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  this->Report.done(std::move(result)); // this thread keeps the meshes of it alone
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
  if (shown && shown->GetNumberOfPolys() > this->MostKept)
  {
    this->Runner.releaseWork();
    malloc_trim(0); // what was freed in pieces goes back as well
  }
  this->Report.detailed({ ticket, this->statesOf(model, outcomes), shown ? digestOf(shown) : std::string() });
  // The rest, between what is asked for aside.
  watch.cancelled = [&] { return this->Wanted != ticket || this->Waiting; };
  const SystemRow* next = shown ? nextOf(model) : nullptr;
  bool isTraced = false;
  for (bool goesOn = true; goesOn; goesOn = watch.cancelled())
  {
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Wake.wait_for(lock, prepareAfter, [&] { return this->Stop || watch.cancelled(); });
      if (this->Stop || this->Next || this->Wanted != ticket)
      {
        return;
      }
    }
    this->runAside(ticket);
    if (next)
    {
      this->Runner.prepare(*next, shown, model.backend, watch);
      next = watch.cancelled() ? next : nullptr;
    }
    if (shown && !watch.cancelled())
    {
      if (!std::exchange(isTraced, true))
      {
        this->trace(ticket, model, outcomes, shown);
      }
      this->picture(ticket, model, outcomes, watch.cancelled);
    }
  }
}

void Worker::trace(std::uint64_t ticket,
  const Model& model,
  const std::vector<Outcome>& outcomes,
  vtkPolyData* shown)
{
  const auto isSeen = [](const Outcome& outcome)
  { return outcome.number != 0 && outcome.hold && outcome.hold->GetNumberOfPoints() > 0; };
  if (!this->Report.traced || std::none_of(outcomes.begin(), outcomes.end(), isSeen))
  {
    return;
  }
  const auto surface = withOwnPolys(shown); // a locator keeps what it makes in the data
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  std::vector<SharedData> lines;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
  {
    const auto stroke = isSeen(outcomes[i]) ? strokeOf(model, *model.nodes[i].step) : nullptr;
    lines.emplace_back(
      stroke ? strokeOn(locator, stroke, outcomes[i].hold, traceReach * shown->GetLength()) : nullptr);
  }
  this->Report.traced(ticket, std::move(lines));
}

namespace
{

// The stroke where the part that it made has been put, as its view shows that.
vtkSmartPointer<vtkPolyData> strokeOfPart(vtkPolyData* stroke, const Step& step)
{
  if (!stroke || !step.part || step.system != drawingSystem)
  {
    return stroke;
  }
  try
  {
    const oversketch::View view = oversketch::ViewOf(stroke);
    const std::array<double, 4> canvas = canvasOf(step), &box = step.part->box;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < stroke->GetNumberOfPoints(); ++i)
    {
      const double* sample = stroke->GetPoint(i);
      const auto on = oversketch::ontoCanvas(view, oversketch::Vector2(sample[0], sample[1]));
      if (!on)
      {
        return stroke;
      }
      const auto along = [&](std::size_t axis)
      {
        const double share =
          ((*on)[static_cast<int>(axis)] - canvas[axis]) / (canvas[axis + 2] - canvas[axis]);
        return box[axis] + share * (box[axis + 2] - box[axis]);
      };
      const oversketch::Vector3 seen = view.toDisplay({ along(0), along(1), step.part->depth });
      points->InsertNextPoint(seen[0], seen[1], 0.0);
    }
    auto placed = shallowCopyOf(stroke);
    placed->SetPoints(points);
    return placed;
  }
  catch (const oversketch::Error&)
  {
    return stroke; // of no one view: it is seen from the front, without its line
  }
}

} // namespace

void Worker::picture(std::uint64_t ticket,
  const Model& model,
  const std::vector<Outcome>& outcomes,
  const std::function<bool()>& cancelled)
{
  for (std::size_t i = outcomes.size(); i-- > 0 && this->Report.pictured;) // what was drawn last is looked at
  {
    const Outcome& outcome = outcomes[i];
    if (outcome.number == 0 || !outcome.mesh || this->Pictures.count(outcome.number) > 0)
    {
      continue;
    }
    const auto made = thumbnailOf(outcome.mesh,
      outcome.details ? outcome.details->region.Get() : nullptr,
      strokeOfPart(strokeOf(model, *model.nodes[i].step), *model.nodes[i].step),
      cancelled);
    if (!made)
    {
      return;
    }
    if (this->Pictures.size() >= mostPictures)
    {
      this->Pictures.erase(this->Pictures.begin()); // the oldest
    }
    this->Pictures[outcome.number] = made;
    this->Report.pictured(ticket, i, made);
  }
}

} // namespace oversketch_session
