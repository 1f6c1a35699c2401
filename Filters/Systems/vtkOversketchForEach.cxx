#include "vtkOversketchForEach.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchStepRunner.h"

#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataObjectTypes.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace oversketch;

namespace
{

// A place of a collection, whether something is there or not.
struct Leaf
{
  unsigned int flatIndex;
  vtkSmartPointer<vtkDataObject> data;
  std::string title; // what it is called in messages
};

vtkSmartPointer<vtkDataObjectTreeIterator> LeavesOf(vtkDataObjectTree* tree)
{
  auto it = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  it->SkipEmptyNodesOff();
  it->VisitOnlyLeavesOn();
  it->TraverseSubTreeOn();
  return it;
}

std::vector<Leaf> ListOf(vtkDataObjectTree* tree)
{
  std::vector<Leaf> leaves;
  const auto it = LeavesOf(tree);
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    const char* name =
      it->HasCurrentMetaData() ? it->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) : nullptr;
    const unsigned int index = it->GetCurrentFlatIndex();
    const std::string title = "leaf " + std::to_string(index) + (name ? " (" + std::string(name) + ")" : "");
    leaves.push_back({ index, it->GetCurrentDataObject(), title });
  }
  return leaves;
}

// Data that one of the filter's further ports gets: the same for all models, or a leaf for each of them.
struct Given
{
  int port;
  bool each = false;
  std::vector<Leaf> leaves;              // where each model has its own
  vtkSmartPointer<vtkDataObject> single; // else; null where there is none

  // In messages: the second input of a filter that takes models is a stroke as a rule.
  std::string name() const { return this->port == 1 ? "stroke" : "input " + std::to_string(this->port); }
  vtkDataObject* of(std::size_t model) const { return this->each ? this->leaves[model].data : this->single; }
};

// Throws unless both collections have their leaves at the same places.
void RequireSamePlaces(const std::vector<Leaf>& models, const Given& given)
{
  const std::string name = given.name();
  if (models.size() != given.leaves.size())
  {
    throw Error(Failure::BadStroke,
      given.port == 1 ? "There are %1 models and %2 strokes; give one %3, or a collection of the same "
                        "structure as the models'."
                      : "There are %1 models and %2 leaves on %3; give one %3, or a collection of the same "
                        "structure as the models'.",
      models.size(),
      given.leaves.size(),
      name);
  }
  const auto differ = std::mismatch(models.begin(),
    models.end(),
    given.leaves.begin(),
    [](const Leaf& a, const Leaf& b) { return a.flatIndex == b.flatIndex; });
  if (differ.first != models.end())
  {
    throw Error(Failure::BadStroke,
      "Leaf %1 of the models has no %2 at its place; give one %2, or a collection of the same structure as "
      "the "
      "models'.",
      differ.first->flatIndex,
      name);
  }
}

bool Needs(vtkAlgorithm* filter, int port)
{
  vtkInformation* info = filter->GetInputPortInformation(port);
  return !info->Has(vtkAlgorithm::INPUT_IS_OPTIONAL()) || info->Get(vtkAlgorithm::INPUT_IS_OPTIONAL()) == 0;
}

bool HoldsAnything(vtkDataObject* data)
{
  return data && data->GetNumberOfElements(vtkDataObject::CELL) > 0;
}

// Throws where the filter would get nothing on a port that it needs, whatever the model.
void RequireGiven(vtkAlgorithm* filter, const std::vector<Leaf>& models, const std::vector<Given>& given)
{
  for (const Given& one : given)
  {
    if (one.each)
    {
      RequireSamePlaces(models, one);
    }
    else if (!one.single && Needs(filter, one.port))
    {
      throw Error(Failure::BadStroke,
        one.port == 1 ? "There is no stroke: the stroke input holds no polyline."
                      : "There is nothing on " + one.name() + ", which the filter needs.");
    }
  }
}

// Connects the filter to one model after the other, and takes its inputs away at the end.
class Inputs
{
public:
  Inputs(vtkAlgorithm* filter, const std::vector<Leaf>& models, const std::vector<Given>& given)
    : Filter(filter)
    , Models(models)
    , Others(given)
  {
  }
  ~Inputs()
  {
    for (int port = 0; port < this->Filter->GetNumberOfInputPorts(); ++port)
    {
      this->Filter->SetInputDataObject(port, nullptr);
    }
  }
  Inputs(const Inputs&) = delete;
  Inputs& operator=(const Inputs&) = delete;

  void Connect(std::size_t model)
  {
    this->Filter->SetInputDataObject(0, this->Models[model].data);
    for (const Given& one : this->Others)
    {
      vtkDataObject* data = one.of(model);
      if (!data && Needs(this->Filter, one.port))
      {
        throw Error(Failure::BadStroke, "There is no %1 for it.", one.name());
      }
      this->Filter->SetInputDataObject(one.port, data);
    }
  }

private:
  vtkAlgorithm* Filter;
  const std::vector<Leaf>& Models;
  const std::vector<Given>& Others;
};

struct Refusals
{
  int count = 0;
  unsigned long firstCode = vtkErrorCode::NoError;
};

// Runs the filter on every model that is there and puts what it makes into the output, whose structure is the
// models'. A model that it refuses is told of by self, with the beginning of its title.
Refusals DriveAll(vtkAlgorithm* filter,
  vtkAlgorithm* self,
  const std::vector<Leaf>& models,
  const std::vector<Given>& given,
  const std::string& beginning,
  vtkDataObjectTree* output)
{
  const auto held = static_cast<double>(
    std::count_if(models.begin(), models.end(), [](const Leaf& leaf) { return leaf.data != nullptr; }));
  double done = 0.0;
  std::string name;
  StepRunner::Listener listener;
  listener.progress = [&](double share) { self->UpdateProgress((done + share) / held); };
  listener.warning = [&](const Message& message) { Warn(self, { "%1: %2", name, message }); };
  listener.cancelled = [self] { return self->GetAbortExecute() != 0; };
  StepRunner runner(filter, listener);
  Inputs inputs(filter, models, given);
  Refusals refused;
  const auto place = LeavesOf(output);
  std::size_t i = 0;
  // The structures are equal, so both are walked in step.
  for (place->InitTraversal(); !place->IsDoneWithTraversal(); place->GoToNextItem(), ++i)
  {
    if (!models[i].data)
    {
      continue;
    }
    name = beginning + models[i].title;
    vtkDataObject* made = nullptr;
    try
    {
      inputs.Connect(i);
      runner.Run();
      made = filter->GetOutputDataObject(0);
    }
    catch (const Error& error)
    {
      if (error.failure() == Failure::Cancelled)
      {
        throw;
      }
      vtkErrorWithObjectMacro(self, << name << ": " << error.what());
      if (refused.count++ == 0)
      {
        refused.firstCode = vtkErrorCode::UserError + static_cast<unsigned long>(error.failure());
      }
    }
    vtkDataObject* type = filter->GetOutputDataObject(0);
    auto result = vtkSmartPointer<vtkDataObject>::Take((type ? type : models[i].data.Get())->NewInstance());
    if (made)
    {
      result->ShallowCopy(made);
    }
    output->SetDataSetFrom(place, result);
    done += 1.0;
    self->UpdateProgress(done / held);
  }
  return refused;
}

} // namespace

vtkStandardNewMacro(vtkOversketchForEach);

vtkOversketchForEach::vtkOversketchForEach()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
  this->SetNumberOfInputPorts(2);
}

vtkOversketchForEach::~vtkOversketchForEach() = default;

int vtkOversketchForEach::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataObjectTree" : "vtkDataObject");
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // the driven filter tells what it needs
  }
  return 1;
}

void vtkOversketchForEach::SetFilter(vtkAlgorithm* filter)
{
  if (filter != this->Filter)
  {
    this->Filter = filter;
    this->SetNumberOfInputPorts(filter ? std::max(2, filter->GetNumberOfInputPorts()) : 2);
    this->Modified();
  }
}

void vtkOversketchForEach::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkOversketchForEach::GetController() const
{
  return this->Controller;
}

vtkMTimeType vtkOversketchForEach::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Filter ? std::max(own, this->Filter->GetMTime()) : own;
}

vtkSmartPointer<vtkDataObject> vtkOversketchForEach::Broadcast(vtkDataObject* single)
{
  const bool here = HoldsAnything(single);
  const int ranks = this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
  if (ranks == 1)
  {
    return here ? single : nullptr;
  }
  const int rank = this->Controller->GetLocalProcessId();
  const int mine = here ? rank : ranks;
  int owner = ranks;
  this->Controller->AllReduce(&mine, &owner, 1, vtkCommunicator::MIN_OP);
  if (owner == ranks)
  {
    return nullptr;
  }
  int type = here ? single->GetDataObjectType() : 0;
  const bool told = this->Controller->Broadcast(&type, 1, owner) != 0;
  const auto all = rank == owner
                     ? vtkSmartPointer<vtkDataObject>(single)
                     : vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type));
  if (!told || !this->Controller->Broadcast(all.Get(), owner))
  {
    throw Error(Failure::Unexpected, "The stroke could not be sent to the other ranks.");
  }
  return all;
}

int vtkOversketchForEach::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      this->NumberOfFailures = 0;
      vtkDataObjectTree* models = vtkDataObjectTree::GetData(inputs[0]);
      vtkDataObjectTree* output = vtkDataObjectTree::GetData(outputs);
      std::vector<Given> given;
      for (int port = 1; port < this->GetNumberOfInputPorts(); ++port)
      {
        vtkDataObject* data = vtkDataObject::GetData(inputs[port]);
        auto* tree = vtkDataObjectTree::SafeDownCast(data);
        Given one{ port, tree != nullptr, {}, nullptr };
        if (tree)
        {
          one.leaves = ListOf(tree);
        }
        else
        {
          one.single = this->Broadcast(data); // the other ranks wait for it: no refusal may come before
        }
        given.push_back(std::move(one));
      }
      if (!this->Filter || this->Filter->GetNumberOfInputPorts() < 1 ||
          this->Filter->GetNumberOfOutputPorts() < 1)
      {
        throw Error(Failure::Unexpected,
          this->Filter ? "The filter to drive does not take a model and give another; set one that does."
                       : "There is no filter to drive; set one that takes model and stroke.");
      }
      given.resize(std::min<std::size_t>(given.size(), this->Filter->GetNumberOfInputPorts() - 1));
      output->CopyStructure(models);
      output->GetFieldData()->PassData(models->GetFieldData());
      const std::vector<Leaf> places = ListOf(models);
      if (std::any_of(places.begin(), places.end(), [](const Leaf& leaf) { return leaf.data != nullptr; }))
      {
        RequireGiven(this->Filter, places, given);
        const bool several = this->Controller && this->Controller->GetNumberOfProcesses() > 1;
        const std::string rank =
          several ? "rank " + std::to_string(this->Controller->GetLocalProcessId()) + ", " : "";
        const Refusals refused = DriveAll(this->Filter, this, places, given, rank, output);
        this->NumberOfFailures = refused.count;
        this->SetErrorCode(refused.firstCode);
      }
    });
}

void vtkOversketchForEach::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Filter: " << (this->Filter ? this->Filter->GetClassName() : "(none)") << "\n";
  os << indent << "Controller: " << (this->Controller ? this->Controller->GetClassName() : "(none)") << "\n";
  os << indent << "NumberOfFailures: " << this->NumberOfFailures << "\n";
}
