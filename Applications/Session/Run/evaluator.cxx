#include "evaluator.h"

#include "drawing_lines.h"
#include "files.h"
#include "heights.h"
#include "models.h"
#include "parts.h"
#include "picture_skin.h"
#include "system_runner.h"
#include "texture.h"

#include "vtkOversketchSystem.h"

#include "Mesh/context.h"

#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace oversketch_session
{

namespace
{

using Ports = std::map<int, std::set<int>>;

// The output ports that steps refer to, by the ids of those that they are of.
Ports portsOf(const Model& model)
{
  Ports ports;
  for (const Node& node : model.nodes)
  {
    for (const auto& named : node.step->inputs)
    {
      if (const auto* output = std::get_if<StepOutput>(&named.second))
      {
        ports[output->step].insert(output->port);
      }
    }
  }
  return ports;
}

bool isElsewhere(const Node& node, const Outcome& outcome)
{
  if (!node.committed || !outcome.section)
  {
    return false;
  }
  const Point &a = node.committed->middle, &b = outcome.section->middle;
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) >
         0.5 * std::min(node.committed->length, outcome.section->length);
}

// Whether two steps make the same thing, wherever it is put then.
bool isSameWork(const Step& a, const Step& b)
{
  const auto isSame = [](const auto& x, const auto& y)
  {
    const auto *xLines = std::get_if<Lines>(&x.second), *yLines = std::get_if<Lines>(&y.second);
    const auto *xImage = std::get_if<Image>(&x.second), *yImage = std::get_if<Image>(&y.second);
    return x.first == y.first && ((xLines && yLines && xLines->identity() == yLines->identity()) ||
                                   (xImage && yImage && xImage->bytes == yImage->bytes));
  };
  return a.system == b.system && a.values == b.values &&
         std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(), isSame);
}

} // namespace

struct Evaluator::Run
{
  const Model& model;
  const Watch& watch;
  std::vector<Outcome>& outcomes; // of the nodes up to the one that is run
  Ports ports;
  std::uint64_t mesh = 0; // the number of the outcome that comes to the node

  // The node that is run: what its step takes, what number its outcome has, and the output ports that it has
  // and others refer to.
  Inputs inputs = {};
  std::uint64_t number = 0;
  std::set<int> needed = {};
  std::size_t index() const { return this->outcomes.size() - 1; }
  const Node& node() const { return this->model.nodes[this->index()]; }
  Outcome& outcome() const { return this->outcomes.back(); }
  bool hasNeeded(const Outcome& made) const
  {
    const auto has = [&](int port) { return made.outputs.count(port) > 0; };
    return std::all_of(this->needed.begin(), this->needed.end(), has);
  }
};

struct Evaluator::Runner
{
  explicit Runner(const SystemRow& row)
    : steps(std::make_unique<SystemRunner>(row))
  {
  }

  std::unique_ptr<SystemRunner> steps;
  std::uint64_t last = 0; // the number of the last outcome, 0 where it did nothing
  // A runner that is prepared for a mesh, where that is not to take the place of what the last step computed.
  std::unique_ptr<SystemRunner> prepared;
  vtkSmartPointer<vtkPolyData> preparedFor;
  // Takes it up where a step is given that mesh.
  void adoptPrepared(const Inputs& inputs)
  {
    const auto isPreparedFor = [this](const auto& input) { return input.second == this->preparedFor; };
    if (this->prepared && std::any_of(inputs.begin(), inputs.end(), isPreparedFor))
    {
      this->steps = std::move(this->prepared);
      this->preparedFor = nullptr;
    }
  }
  // The last lines of each input, and whose they are.
  std::map<std::string, std::pair<std::weak_ptr<const void>, vtkSmartPointer<vtkPolyData>>> lines;
};

Evaluator::Evaluator(std::size_t bytes, const std::vector<SystemRow>& rows)
  : Rows(rows)
  , Budget(bytes)
{
}

Evaluator::~Evaluator() = default;

Evaluator::Runner* Evaluator::runner(const std::string& name)
{
  const SystemRow* row = findSystem(name, this->Rows);
  if (!row)
  {
    return nullptr;
  }
  auto& runner = this->Runners[name];
  if (!runner)
  {
    runner = std::make_unique<Runner>(*row);
  }
  return runner.get();
}

vtkOversketchSystem* Evaluator::system(const std::string& name)
{
  Runner* runner = this->runner(name);
  return runner ? runner->steps->system() : nullptr;
}

vtkSmartPointer<vtkImageData> Evaluator::imageOf(const Image& image, SystemInput::Kind kind)
{
  auto& made = this->Pictures[image.bytes][kind];
  if (!made && kind == SystemInput::Kind::Heights)
  {
    try
    {
      made = oversketch_files::parseHeights(image.name, *image.bytes);
    }
    catch (const oversketch_files::Failed&)
    {
      return nullptr;
    }
  }
  else if (!made)
  {
    made = oversketch_files::pictureOf(*image.bytes);
  }
  return made;
}

std::string Evaluator::resolve(Run& run, std::vector<std::uint64_t>& numbers)
{
  const auto& nodes = run.model.nodes;
  const Step& step = *run.node().step;
  Inputs& inputs = run.inputs;
  for (const SystemInput& input : findSystem(step.system, this->Rows)->inputs)
  {
    const std::string what = "its input '" + input.name + "' ";
    const auto given = step.inputs.find(input.name);
    if (given == step.inputs.end())
    {
      if (input.kind == SystemInput::Kind::Mesh && !input.optional && run.outcome().mesh)
      {
        inputs[input.name] = run.outcome().mesh;
        numbers.push_back(run.mesh);
      }
      else if (input.kind == SystemInput::Kind::Mesh && !input.optional)
      {
        return "there is no mesh yet that it could act on";
      }
      else if (isNeeded(input, step.values))
      {
        return what + "is missing";
      }
    }
    else if (const auto* lines = std::get_if<Lines>(&given->second))
    {
      // Lines that are those of last time are the same data, so that the steps keep what they made of them.
      auto& [identity, data] = this->runner(step.system)->lines[input.name];
      if (!data || identity.owner_before(lines->identity()) || lines->identity().owner_before(identity))
      {
        identity = lines->identity();
        data = strokesThatAreOn(lines->own());
      }
      inputs[input.name] = data;
    }
    else if (const auto* image = std::get_if<Image>(&given->second))
    {
      inputs[input.name] = this->imageOf(*image, input.kind);
      if (!inputs[input.name])
      {
        return what + "is the picture '" + image->name + "', which cannot be read";
      }
    }
    else
    {
      const StepOutput& output = std::get<StepOutput>(given->second);
      const int row = rowOf(nodes, output.step);
      if (row < 0)
      {
        return what + "is of a step that is no longer there";
      }
      const auto at = static_cast<std::size_t>(row);
      const Node& node = nodes[at];
      const std::string whose = what + "is of '" + node.name + "', which ";
      if (at >= run.index())
      {
        return whose + (at == run.index() ? "is itself" : "comes after it");
      }
      const Outcome& outcome = run.outcomes[at];
      if (!node.on || !outcome.failure.empty())
      {
        return whose + (node.on ? "did nothing" : "is off");
      }
      const auto port = outcome.outputs.find(output.port);
      if (output.port != 0 && port == outcome.outputs.end())
      {
        return whose + "has no output " + std::to_string(output.port);
      }
      inputs[input.name] = output.port == 0 ? vtkSmartPointer<vtkDataObject>(outcome.mesh) : port->second;
      numbers.push_back(outcome.number);
    }
  }
  return {};
}

bool Evaluator::make(Run& run)
{
  const Step& step = *run.node().step;
  Outcome& outcome = run.outcome();
  Runner& runner = *this->runner(step.system);
  if (run.watch.details && !this->finish(runner, run.watch.cancelled))
  {
    return false;
  }
  Listener listener;
  listener.cancelled = run.watch.cancelled;
  if (run.watch.progress)
  {
    listener.progress = [&](const std::string& stage, double share)
    { run.watch.progress(run.index(), stage, share); };
  }
  runner.adoptPrepared(run.inputs);
  ++this->Runs;
  runner.last = 0;
  if (!runner.steps->run(step, run.inputs, run.model.backend, run.needed, listener, outcome))
  {
    return false;
  }
  if (outcome.failure.empty())
  {
    const auto decoded = [&](const std::string& name)
    { return vtkImageData::SafeDownCast(run.inputs.at(name).Get()); };
    wearPictures(step, *findSystem(step.system, this->Rows), decoded, outcome.mesh);
  }
  runner.last = outcome.failure.empty() ? run.number : 0;
  return true;
}

bool Evaluator::makePart(Run& run)
{
  const Node& node = run.node();
  Outcome& outcome = run.outcome();
  const vtkSmartPointer<vtkPolyData> came = outcome.mesh;
  const auto kept = this->Parts.find(node.id);
  if (kept != this->Parts.end() && kept->second.backend == run.model.backend &&
      isSameWork(kept->second.step, *node.step) && run.hasNeeded(kept->second.outcome))
  {
    outcome = kept->second.outcome;
  }
  else
  {
    if (!this->make(run))
    {
      return false;
    }
    this->Parts[node.id] = { *node.step, run.model.backend, outcome };
  }
  const vtkSmartPointer<vtkPolyData> made = outcome.failure.empty() ? outcome.mesh : nullptr;
  outcome.mesh = came || !made ? came : made;
  if (made && made->GetNumberOfPoints() > 0)
  {
    try
    {
      outcome.mesh = withPart(came, made, *node.step->part);
    }
    catch (const oversketch::Error& error)
    {
      outcome.failure = error.message();
    }
  }
  return true;
}

bool Evaluator::runNode(Run& run)
{
  const std::shared_ptr<const Step>& step = run.node().step;
  Outcome& outcome = run.outcome();
  run.inputs.clear();
  run.needed.clear();
  std::vector<std::uint64_t> numbers;
  outcome.failure = faultOf(*step, this->Rows);
  if (outcome.failure.empty())
  {
    outcome.failure = this->resolve(run, numbers);
  }
  if (!outcome.failure.empty())
  {
    return true;
  }
  if (step->part && outcome.mesh)
  {
    numbers.push_back(run.mesh);
  }
  run.number = this->numberOf({ step, numbers, run.model.backend });
  Kept& kept = this->Outcomes.at(run.number);
  for (const int port : run.ports[run.node().id])
  {
    if (port > 0 && port < this->system(step->system)->GetNumberOfOutputPorts())
    {
      run.needed.insert(port);
    }
  }
  if (kept.outcome && (!kept.outcome->failure.empty() || run.hasNeeded(*kept.outcome)))
  {
    outcome = *kept.outcome;
  }
  else
  {
    if (!(step->part ? this->makePart(run) : this->make(run)))
    {
      return false;
    }
    outcome.number = outcome.failure.empty() ? run.number : 0;
    outcome.details = kept.outcome ? kept.outcome->details : outcome.details;
    kept.outcome = outcome;
    kept.bytes = bytesOf(outcome);
  }
  if (outcome.failure.empty())
  {
    run.mesh = run.number;
  }
  return true;
}

bool Evaluator::run(const Model& model, const Watch& watch, std::vector<Outcome>& outcomes)
{
  outcomes.clear();
  this->forget();
  ++this->RunCount;
  Run run{ model, watch, outcomes, portsOf(model) };
  for (auto it = this->Parts.begin(); it != this->Parts.end();)
  {
    it = rowOf(model.nodes, it->first) >= 0 ? std::next(it) : this->Parts.erase(it);
  }
  run.mesh = model.mesh ? this->numberOf({ model.mesh.identity(), {}, 0 }) : 0;
  vtkSmartPointer<vtkPolyData> mesh = model.mesh.own();
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
  {
    outcomes.emplace_back();
    outcomes[i].mesh = mesh;
    if (model.nodes[i].on && !this->runNode(run))
    {
      outcomes.pop_back();
      return false;
    }
    outcomes[i].elsewhere = isElsewhere(model.nodes[i], outcomes[i]);
    mesh = outcomes[i].mesh;
  }
  this->giveUp();
  return true;
}

bool Evaluator::finish(Runner& runner, const std::function<bool()>& cancelled)
{
  const auto kept = this->Outcomes.find(runner.last);
  if (kept == this->Outcomes.end() || !kept->second.outcome || kept->second.outcome->details)
  {
    return true;
  }
  Outcome& outcome = *kept->second.outcome;
  outcome.details = runner.steps->details(outcome.mesh, cancelled);
  kept->second.bytes = bytesOf(outcome);
  return outcome.details != nullptr;
}

bool Evaluator::details(std::vector<Outcome>& outcomes, const Watch& watch)
{
  bool done = true;
  for (const auto& named : this->Runners)
  {
    done = done && this->finish(*named.second, watch.cancelled);
  }
  for (Outcome& outcome : outcomes)
  {
    const auto kept = this->Outcomes.find(outcome.number);
    if (kept != this->Outcomes.end() && kept->second.outcome)
    {
      outcome.details = kept->second.outcome->details;
    }
  }
  this->giveUp();
  return done;
}

void Evaluator::releaseWork()
{
  for (const auto& named : this->Runners)
  {
    named.second->steps->releaseWork();
    named.second->last = 0;
  }
}

void Evaluator::prepare(const SystemRow& row, vtkPolyData* mesh, int backend, const Watch& watch)
{
  Listener listener;
  listener.cancelled = watch.cancelled;
  Runner& runner = *this->runner(row.name);
  if (!row.previewsEdits)
  {
    runner.steps->prepare(mesh, backend, listener);
    return;
  }
  if (!runner.prepared || runner.preparedFor != mesh)
  {
    runner.prepared = std::make_unique<SystemRunner>(row); // a fresh one holds nothing of other meshes
    runner.preparedFor = mesh;
  }
  runner.prepared->prepare(mesh, backend, listener);
}

vtkPolyData* resultOf(const Model& model, const std::vector<Outcome>& outcomes)
{
  return outcomes.empty() ? model.mesh.Get() : outcomes.back().mesh.Get();
}

int backendUsedBy(const std::vector<Outcome>& outcomes)
{
  const bool onDevice = std::any_of(outcomes.begin(),
    outcomes.end(),
    [](const Outcome& outcome) { return outcome.backendUsed == vtkOversketchSystem::OpenCL; });
  return onDevice ? vtkOversketchSystem::OpenCL : vtkOversketchSystem::Host;
}

} // namespace oversketch_session
