#include "vtkOversketchForEach.h"

#include "vtkOversketchFilterTools.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>
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

// Throws unless both collections have their leaves at the same places.
void RequireSamePlaces(const std::vector<Leaf>& models, const std::vector<Leaf>& strokes)
{
  std::ostringstream message;
  if (models.size() != strokes.size())
  {
    message << "There are " << models.size() << " models and " << strokes.size() << " strokes";
  }
  else
  {
    const auto differ = std::mismatch(models.begin(),
      models.end(),
      strokes.begin(),
      [](const Leaf& a, const Leaf& b) { return a.flatIndex == b.flatIndex; });
    if (differ.first == models.end())
    {
      return;
    }
    message << "Leaf " << differ.first->flatIndex << " of the models has no stroke at its place";
  }
  message << "; give one stroke, or a collection of strokes of the same structure.";
  throw Error(Failure::BadStroke, message.str());
}

// Runs a filter on one pair after the other: hears its errors instead of letting them be printed, passes its
// progress on and a cancel in.
class Driver
{
public:
  Driver(vtkAlgorithm* filter, vtkAlgorithm* self)
    : Filter(filter)
    , Self(self)
  {
    this->Observer->SetClientData(this);
    this->Observer->SetCallback([](vtkObject*, unsigned long event, void* client, void* data)
      { static_cast<Driver*>(client)->Hear(event, data); });
    for (const unsigned long event :
      { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
    {
      this->Filter->AddObserver(event, this->Observer);
    }
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  }
  ~Driver()
  {
    this->Filter->RemoveObserver(this->Observer);
    this->Filter->GetExecutive()->RemoveObserver(this->Observer);
    this->Filter->SetInputDataObject(0, nullptr);
    this->Filter->SetInputDataObject(1, nullptr);
  }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  // What the filter makes of the pair, or a null pointer: then FirstError says why. Progress goes from a
  // share of the whole to another; warnings are passed on with the name of the model.
  vtkSmartPointer<vtkDataObject> Run(const std::string& name,
    vtkDataObject* model,
    vtkDataObject* stroke,
    double from,
    double to)
  {
    this->FirstError.clear();
    this->Name = name;
    this->From = from;
    this->To = to;
    this->Filter->SetInputDataObject(0, model);
    this->Filter->SetInputDataObject(1, stroke);
    this->Filter->SetAbortExecute(0);
    this->Filter->Modified(); // after a refusal, the next run would otherwise be taken for done
    this->Filter->Update();
    if (this->Self->GetAbortExecute())
    {
      this->Filter->Modified();
      throw Error(Failure::Cancelled, "cancelled");
    }
    vtkDataObject* made = this->Filter->GetOutputDataObject(0);
    if (!this->FirstError.empty())
    {
      return nullptr;
    }
    auto result = vtkSmartPointer<vtkDataObject>::Take(made->NewInstance());
    result->ShallowCopy(made);
    return result;
  }

  std::string FirstError;

private:
  void Hear(unsigned long event, const void* data)
  {
    if (event == vtkCommand::ProgressEvent)
    {
      this->Self->UpdateProgress(this->From + (this->To - this->From) * this->Filter->GetProgress());
      if (this->Self->GetAbortExecute())
      {
        this->Filter->SetAbortExecute(1);
      }
    }
    else if (event == vtkCommand::WarningEvent)
    {
      vtkWarningWithObjectMacro(this->Self, << this->Name << ": " << MessageOf(data));
    }
    else if (this->FirstError.empty()) // the executive of a failed filter adds an error of its own
    {
      this->FirstError = MessageOf(data);
    }
  }

  vtkAlgorithm* Filter;
  vtkAlgorithm* Self;
  vtkNew<vtkCallbackCommand> Observer;
  std::string Name;
  double From = 0.0;
  double To = 1.0;
};

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
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  }
  return 1;
}

void vtkOversketchForEach::SetFilter(vtkAlgorithm* filter)
{
  if (filter != this->Filter)
  {
    this->Filter = filter;
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

vtkSmartPointer<vtkDataObject> vtkOversketchForEach::Broadcast(vtkDataObject* stroke)
{
  auto* lines = vtkPolyData::SafeDownCast(stroke);
  const bool here = lines && lines->GetNumberOfCells() > 0;
  const int ranks = this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
  if (ranks == 1)
  {
    return here ? stroke : nullptr;
  }
  const int rank = this->Controller->GetLocalProcessId();
  const int mine = here ? rank : ranks;
  int owner = ranks;
  this->Controller->AllReduce(&mine, &owner, 1, vtkCommunicator::MIN_OP);
  if (owner == ranks)
  {
    return nullptr;
  }
  vtkSmartPointer<vtkDataObject> all = rank == owner ? stroke : vtkSmartPointer<vtkPolyData>::New();
  if (!this->Controller->Broadcast(all.Get(), owner))
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
      vtkDataObject* strokes = vtkDataObject::GetData(inputs[1]);
      auto* strokeTree = vtkDataObjectTree::SafeDownCast(strokes);
      // First of all, for the other ranks wait for it: no refusal may come before.
      const auto stroke = strokeTree ? nullptr : this->Broadcast(strokes);
      if (!this->Filter || this->Filter->GetNumberOfInputPorts() != 2 ||
          this->Filter->GetNumberOfOutputPorts() < 1)
      {
        throw Error(Failure::Unexpected,
          this->Filter ? "The filter to drive does not take two inputs; set one that takes model and stroke."
                       : "There is no filter to drive; set one that takes model and stroke.");
      }
      output->CopyStructure(models);
      output->GetFieldData()->PassData(models->GetFieldData());
      const std::vector<Leaf> pairs = ListOf(models);
      const std::vector<Leaf> theirs = strokeTree ? ListOf(strokeTree) : std::vector<Leaf>();
      const auto held = static_cast<double>(
        std::count_if(pairs.begin(), pairs.end(), [](const Leaf& leaf) { return leaf.data != nullptr; }));
      if (held == 0)
      {
        return;
      }
      if (strokeTree)
      {
        RequireSamePlaces(pairs, theirs);
      }
      else if (!stroke)
      {
        throw Error(Failure::BadStroke, "There is no stroke: the stroke input holds no polyline.");
      }

      Driver driver(this->Filter, this);
      const auto place = LeavesOf(output);
      const bool several = this->Controller && this->Controller->GetNumberOfProcesses() > 1;
      const std::string rank =
        several ? "rank " + std::to_string(this->Controller->GetLocalProcessId()) + ", " : "";
      unsigned long firstCode = vtkErrorCode::NoError;
      std::size_t i = 0;
      double done = 0.0;
      // The structures are equal, so both are walked in step.
      for (place->InitTraversal(); !place->IsDoneWithTraversal(); place->GoToNextItem(), ++i)
      {
        const Leaf& model = pairs[i];
        if (!model.data)
        {
          continue;
        }
        const std::string name = rank + model.title;
        vtkSmartPointer<vtkDataObject> made;
        unsigned long code = vtkErrorCode::UserError + static_cast<unsigned long>(Failure::BadStroke);
        if (strokeTree && !theirs[i].data)
        {
          driver.FirstError = "There is no stroke for it.";
        }
        else
        {
          vtkDataObject* drawn = strokeTree ? theirs[i].data : stroke;
          made = driver.Run(name, model.data, drawn, done / held, (done + 1.0) / held);
          code = this->Filter->GetErrorCode();
        }
        done += 1.0;
        if (!made)
        {
          vtkErrorMacro(<< name << ": " << driver.FirstError);
          if (this->NumberOfFailures++ == 0)
          {
            firstCode = code != vtkErrorCode::NoError
                          ? code
                          : vtkErrorCode::UserError + static_cast<unsigned long>(Failure::InnerStep);
          }
          vtkDataObject* type = this->Filter->GetOutputDataObject(0);
          made = vtkSmartPointer<vtkDataObject>::Take((type ? type : model.data.Get())->NewInstance());
        }
        output->SetDataSetFrom(place, made);
        this->UpdateProgress(done / held);
      }
      this->SetErrorCode(firstCode);
    });
}

void vtkOversketchForEach::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Filter: " << (this->Filter ? this->Filter->GetClassName() : "(none)") << "\n";
  os << indent << "Controller: " << (this->Controller ? this->Controller->GetClassName() : "(none)") << "\n";
  os << indent << "NumberOfFailures: " << this->NumberOfFailures << "\n";
}
