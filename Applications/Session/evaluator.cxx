#include "evaluator.h"

#include "vtkOversketchMirror.h"
#include "vtkOversketchOneStroke.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace oversketch_session
{

namespace
{

double between(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The middle and the length of the first line of a polydata.
std::optional<Section> sectionOf(vtkPolyData* matched)
{
  vtkNew<vtkIdList> ids;
  if (matched && matched->GetNumberOfCells() > 0)
  {
    matched->GetCellPoints(0, ids);
  }
  if (ids->GetNumberOfIds() < 2)
  {
    return std::nullopt;
  }
  std::vector<Point> points(static_cast<std::size_t>(ids->GetNumberOfIds()));
  Section section;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    matched->GetPoint(ids->GetId(static_cast<vtkIdType>(i)), points[i].data());
    section.length += i > 0 ? between(points[i - 1], points[i]) : 0.0;
  }
  section.middle = points.back();
  double left = 0.5 * section.length;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const double step = between(points[i - 1], points[i]);
    if (step >= left && step > 0.0)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        section.middle[k] = points[i - 1][k] + left / step * (points[i][k] - points[i - 1][k]);
      }
      break;
    }
    left -= step;
  }
  return section;
}

// Keeps the first error that a VTK object tells: "ERROR: In file, line n\nclass (address): message\n\n".
void hearError(const void* data, std::string& first)
{
  if (first.empty())
  {
    first = static_cast<const char*>(data);
    const std::size_t colon = first.find("): ");
    first.erase(0, colon == std::string::npos ? 0 : colon + 3);
    first.erase(first.find_last_not_of(" \n") + 1);
  }
}

// Of the mesh that was made of the system's output, with the mirror where there is one.
std::shared_ptr<const Following> followingOf(vtkOversketchOneStroke* system,
  vtkPolyData* made,
  vtkOversketchMirror* mirror)
{
  vtkPoints* rest = made->GetPoints();
  auto following = std::make_shared<Following>();
  following->count = rest->GetNumberOfPoints();
  vtkSmartPointer<vtkPoints> moved[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    double unit[3] = { 0.0, 0.0, 0.0 };
    unit[axis] = 1.0;
    moved[axis] = vtkSmartPointer<vtkPoints>::New();
    moved[axis]->SetDataTypeToDouble();
    moved[axis]->SetNumberOfPoints(following->count);
    if (!system->Drag(unit, moved[axis]))
    {
      return nullptr;
    }
    if (mirror)
    {
      vtkNew<vtkPolyData> side;
      side->ShallowCopy(system->GetOutput());
      side->SetPoints(moved[axis]);
      mirror->SetInputData(1, side);
      mirror->Update();
      moved[axis] = mirror->GetOutput()->GetPoints();
      if (mirror->GetOutput()->GetNumberOfPoints() != following->count)
      {
        return nullptr;
      }
    }
  }
  for (vtkIdType i = 0; i < following->count; ++i)
  {
    std::array<float, 9> moves{};
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int k = 0; k < 3; ++k)
      {
        moves[3 * static_cast<std::size_t>(axis) + static_cast<std::size_t>(k)] =
          static_cast<float>(moved[axis]->GetPoint(i)[k] - rest->GetPoint(i)[k]);
      }
    }
    if (moves != std::array<float, 9>{})
    {
      following->points.push_back(i);
      following->moves.push_back(moves);
    }
  }
  return following;
}

// Hears the system while it runs.
class Ear
{
public:
  Ear(vtkOversketchOneStroke* system, std::size_t node, const Evaluator::Watch& watch)
    : System(system)
    , Node(node)
    , Watch(watch)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long event, void* self, void* data)
      { static_cast<Ear*>(self)->hear(event, data); });
    for (const unsigned long event :
      { vtkCommand::ProgressEvent, vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
    {
      system->AddObserver(event, this->Command);
    }
    // Its executive repeats a failure in words of its own.
    system->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~Ear()
  {
    this->System->RemoveObserver(this->Command);
    this->System->GetExecutive()->RemoveObserver(this->Command);
  }
  Ear(const Ear&) = delete;
  Ear& operator=(const Ear&) = delete;

  std::string Failure;

private:
  void hear(unsigned long event, void* data)
  {
    if (event == vtkCommand::ProgressEvent)
    {
      if (this->Watch.cancelled && this->Watch.cancelled())
      {
        this->System->AbortExecuteOn();
      }
      if (this->Watch.progress)
      {
        this->Watch.progress(this->Node, this->System->GetStageName(), *static_cast<double*>(data));
      }
    }
    else if (event == vtkCommand::ErrorEvent)
    {
      hearError(data, this->Failure);
    }
  }

  vtkOversketchOneStroke* System;
  std::size_t Node;
  const Evaluator::Watch& Watch;
  vtkNew<vtkCallbackCommand> Command;
};

vtkSmartPointer<vtkPolyData> shared(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(data);
  return copy;
}

} // namespace

Evaluator::Evaluator(std::size_t bytes)
  : system_(vtkSmartPointer<vtkOversketchOneStroke>::New())
  , budget_(bytes)
{
}

Evaluator::~Evaluator() = default;

vtkOversketchOneStroke* Evaluator::system()
{
  return this->system_;
}

bool Evaluator::Key::operator==(const Key& other) const
{
  using Held = std::weak_ptr<const Action>;
  return this->mesh == other.mesh && this->backend == other.backend &&
         std::equal(this->actions.begin(),
           this->actions.end(),
           other.actions.begin(),
           other.actions.end(),
           [](const Held& a, const Held& b) { return !a.owner_before(b) && !b.owner_before(a); });
}

bool Evaluator::Key::canComeAgain() const
{
  return std::none_of(this->actions.begin(),
    this->actions.end(),
    [](const std::weak_ptr<const Action>& action) { return action.expired(); });
}

const Outcome* Evaluator::find(const Key& key)
{
  const auto it =
    std::find_if(this->kept_.begin(), this->kept_.end(), [&](const Kept& kept) { return kept.key == key; });
  if (it == this->kept_.end())
  {
    return nullptr;
  }
  this->kept_.splice(this->kept_.begin(), this->kept_, it);
  return &this->kept_.front().outcome;
}

void Evaluator::keep(const Key& key, const Outcome& outcome, std::size_t inUse)
{
  // A mesh passed by is another outcome's.
  const std::size_t bytes =
    outcome.failure.empty()
      ? std::size_t(1024) * (outcome.mesh->GetActualMemorySize() + outcome.region->GetActualMemorySize()) +
          (outcome.following ? outcome.following->points.size() * (sizeof(vtkIdType) + sizeof(float) * 9) : 0)
      : 0;
  this->kept_.push_front({ key, outcome, bytes });
  std::size_t sum = 0;
  std::size_t count = 0;
  for (auto it = this->kept_.begin(); it != this->kept_.end(); ++it, ++count)
  {
    sum += it->bytes;
    if (sum > this->budget_ && count >= inUse)
    {
      this->kept_.erase(it, this->kept_.end());
      return;
    }
  }
}

bool Evaluator::runOne(const Action& action,
  vtkPolyData* mesh,
  std::size_t node,
  const Watch& watch,
  Outcome& outcome)
{
  ++this->runs_;
  vtkOversketchOneStroke* system = this->system_;
  system->SetInputData(0, mesh);
  system->SetStrokeData(action.stroke.own());
  if (system->GetAsPublished() != action.parameters.asPublished)
  {
    system->SetAsPublished(action.parameters.asPublished);
  }
  // The halves of a mirrored mesh are told by the points' ids, which remeshing does not keep.
  system->SetRemesh(action.mirror ? int(vtkOversketchOneStroke::RemeshOff) : action.parameters.remesh);
  system->SetAdjustNormals(action.parameters.adjustNormals);
  std::string failure;
  {
    Ear ear(system, node, watch);
    system->Modified(); // a run that failed before would report an empty success
    system->Update();
    failure = ear.Failure;
  }
  if (watch.cancelled && watch.cancelled())
  {
    return false;
  }
  vtkNew<vtkOversketchMirror> mirror;
  vtkSmartPointer<vtkPolyData> made = system->GetOutput();
  if (failure.empty() && made->GetNumberOfPolys() == 0)
  {
    failure = "the deformation gave no mesh";
  }
  outcome.section = failure.empty() ? sectionOf(system->GetInnerOutput("Match")) : std::nullopt;
  if (failure.empty() && action.mirror)
  {
    mirror->SetInputData(0, mesh);
    mirror->SetInputData(1, made);
    mirror->SetAxis(action.mirror->axis);
    mirror->SetOffset(action.mirror->offset);
    if (outcome.section)
    {
      mirror->SetSide(
        outcome.section->middle[static_cast<std::size_t>(action.mirror->axis)] < action.mirror->offset
          ? vtkOversketchMirror::Below
          : vtkOversketchMirror::Above);
    }
    vtkNew<vtkCallbackCommand> ear;
    ear->SetClientData(&failure);
    ear->SetCallback([](vtkObject*, unsigned long, void* first, void* data)
      { hearError(data, *static_cast<std::string*>(first)); });
    mirror->AddObserver(vtkCommand::ErrorEvent, ear);
    mirror->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, ear);
    mirror->Update();
    made = mirror->GetOutput();
  }
  outcome.failure = failure;
  outcome.mesh = failure.empty() ? shared(made) : vtkSmartPointer<vtkPolyData>(mesh);
  outcome.matched = failure.empty() ? shared(system->GetInnerOutput("Match")) : nullptr;
  if (failure.empty())
  {
    outcome.region = vtkSmartPointer<vtkPolyData>::New();
    system->GetRegion(outcome.region);
    outcome.following = followingOf(system, outcome.mesh, action.mirror ? mirror.Get() : nullptr);
  }
  return true;
}

bool Evaluator::run(const Session& session, const Watch& watch, std::vector<Outcome>& outcomes)
{
  outcomes.clear();
  this->kept_.remove_if([](const Kept& kept) { return !kept.key.canComeAgain(); });
  this->system_->SetBackend(session.backend);
  vtkSmartPointer<vtkPolyData> mesh = session.mesh.own();
  Key key{ session.mesh, session.backend, {} };
  for (std::size_t i = 0; i < session.nodes.size(); ++i)
  {
    const Node& node = session.nodes[i];
    Outcome outcome;
    outcome.mesh = mesh;
    if (node.on)
    {
      key.actions.push_back(node.action);
      if (const Outcome* kept = this->find(key))
      {
        outcome = *kept;
      }
      else if (this->runOne(*node.action, mesh, i, watch, outcome))
      {
        this->keep(key, outcome, i + 1);
      }
      else
      {
        return false;
      }
      // What a failed stroke leaves is the mesh before it, and so is what comes after.
      if (!outcome.failure.empty())
      {
        key.actions.pop_back();
      }
      outcome.elsewhere = node.committed && outcome.section &&
                          between(node.committed->middle, outcome.section->middle) >
                            0.5 * std::min(node.committed->length, outcome.section->length);
    }
    mesh = outcome.mesh;
    outcomes.push_back(outcome);
  }
  return true;
}

void Evaluator::prepare(vtkPolyData* mesh, const Watch& watch)
{
  const Ear ear(this->system_, 0, watch);
  this->system_->SetInputData(0, shared(mesh));
  this->system_->Prepare();
}

vtkPolyData* resultOf(const Session& session, const std::vector<Outcome>& outcomes)
{
  return outcomes.empty() ? session.mesh.Get() : outcomes.back().mesh.Get();
}

} // namespace oversketch_session
