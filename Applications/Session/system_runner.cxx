#include "system_runner.h"

#include "vtkOversketchMirror.h"
#include "vtkOversketchStepRunner.h"
#include "vtkOversketchSystem.h"

#include "Mesh/context.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>

namespace oversketch_session
{

namespace
{

double between(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The middle and the length of the first line of a polydata.
std::optional<Section> sectionOf(vtkPolyData* hold)
{
  vtkNew<vtkIdList> ids;
  if (hold->GetNumberOfLines() > 0)
  {
    hold->GetLines()->GetCellAtId(0, ids);
  }
  if (ids->GetNumberOfIds() < 2)
  {
    return std::nullopt;
  }
  std::vector<Point> points(static_cast<std::size_t>(ids->GetNumberOfIds()));
  Section section;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    hold->GetPoint(ids->GetId(static_cast<vtkIdType>(i)), points[i].data());
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

template <typename Data>
vtkSmartPointer<Data> shared(Data* data)
{
  auto copy = vtkSmartPointer<Data>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}

// Runs work with a system or a filter that is heard meanwhile. Empty where it went well, else the reason.
// Throws Error where it was cancelled.
std::string failureOf(vtkAlgorithm* algorithm,
  const oversketch::StepRunner::Listener& listener,
  const std::function<void()>& work)
{
  try
  {
    oversketch::StepRunner(algorithm, listener).Run(work);
  }
  catch (const oversketch::Error& error)
  {
    if (error.failure() == oversketch::Failure::Cancelled)
    {
      throw;
    }
    return error.what();
  }
  return {};
}

oversketch::StepRunner::Listener listenerOf(vtkOversketchSystem* system, const Listener& listener)
{
  oversketch::StepRunner::Listener made;
  made.cancelled = listener.cancelled;
  made.warning = listener.warning;
  if (listener.progress)
  {
    made.progress = [system, progress = listener.progress](double share)
    { progress(system->GetStageName(), share); };
  }
  return made;
}

} // namespace

SystemRunner::SystemRunner(const SystemRow& row)
  : Row(row)
  , System(row.make())
{
}

SystemRunner::~SystemRunner() = default;

void SystemRunner::feed(const Step& step, const Data& inputs)
{
  for (const SystemInput& input : this->Row.inputs)
  {
    const auto given = inputs.find(input.name);
    this->System->SetInputDataObject(input.port, given == inputs.end() ? nullptr : given->second.Get());
  }
  this->setValues(step);
}

void SystemRunner::setValues(const Step& step)
{
  for (const Parameter& one : this->Row.parameters)
  {
    const Value* value = &valueOf(step, one);
    if (step.mirror)
    {
      const auto instead = this->Row.mirrored->find(one.property);
      value = instead == this->Row.mirrored->end() ? value : &instead->second;
    }
    if (one.get(this->System) != *value)
    {
      one.set(this->System, *value);
    }
  }
}

bool SystemRunner::run(const Step& step,
  const Data& inputs,
  int backend,
  const std::set<int>& ports,
  const Listener& listener,
  Outcome& outcome)
{
  this->Mirror = nullptr;
  this->feed(step, inputs);
  this->System->SetBackend(backend);
  vtkSmartPointer<vtkPolyData> made = this->System->GetOutput();
  std::string failure;
  std::optional<Section> section;
  vtkNew<vtkPolyData> hold;
  try
  {
    // Modified, since a run that failed before would report an empty success.
    this->System->Modified();
    failure = failureOf(this->System, listenerOf(this->System, listener), [this] { this->System->Update(); });
    if (failure.empty() && made->GetNumberOfPolys() == 0)
    {
      failure = "no mesh came of it";
    }
    if (failure.empty())
    {
      this->System->GetHold(hold);
      section = sectionOf(hold);
    }
    if (failure.empty() && step.mirror)
    {
      oversketch::StepRunner::Listener quiet;
      quiet.cancelled = listener.cancelled;
      this->Mirror = vtkSmartPointer<vtkOversketchMirror>::New();
      this->setMirror(*step.mirror, inputs, section);
      failure = failureOf(this->Mirror, quiet, [this] { this->Mirror->Update(); });
      made = this->Mirror->GetOutput();
    }
  }
  catch (const oversketch::Error&)
  {
    return false;
  }
  outcome.failure = failure;
  if (failure.empty())
  {
    outcome.mesh = shared(made.Get());
    outcome.section = section;
    outcome.hold = shared(hold.Get());
    outcome.backendUsed = this->System->GetBackendUsed();
    for (const int port : ports)
    {
      outcome.outputs[port] = shared(this->System->GetOutputDataObject(port));
    }
  }
  return true;
}

void SystemRunner::setMirror(const MirrorPlane& plane,
  const Data& inputs,
  const std::optional<Section>& section)
{
  const SystemInput* before = findInput(this->Row, SystemInput::Kind::Mesh);
  this->Mirror->SetInputDataObject(0, inputs.at(before->name));
  this->Mirror->SetInputData(1, this->System->GetOutput());
  this->Mirror->SetAxis(plane.axis);
  this->Mirror->SetOffset(plane.offset);
  if (section)
  {
    const bool below = section->middle[static_cast<std::size_t>(plane.axis)] < plane.offset;
    this->Mirror->SetSide(below ? vtkOversketchMirror::Below : vtkOversketchMirror::Above);
  }
}

std::shared_ptr<const Details> SystemRunner::details(vtkPolyData* made,
  const std::function<bool()>& cancelled)
{
  auto details = std::make_shared<Details>();
  details->region = vtkSmartPointer<vtkPolyData>::New();
  this->System->GetRegion(details->region);
  try
  {
    details->following = this->following(made, cancelled);
  }
  catch (const oversketch::Error&)
  {
    return nullptr;
  }
  return details;
}

std::shared_ptr<const Following> SystemRunner::following(vtkPolyData* made,
  const std::function<bool()>& cancelled)
{
  vtkPoints* rest = made->GetPoints();
  auto following = std::make_shared<Following>();
  following->count = rest->GetNumberOfPoints();
  vtkSmartPointer<vtkPoints> moved[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (cancelled && cancelled())
    {
      throw oversketch::Error(oversketch::Failure::Cancelled, "cancelled");
    }
    double unit[3] = { 0.0, 0.0, 0.0 };
    unit[axis] = 1.0;
    moved[axis] = vtkSmartPointer<vtkPoints>::New();
    moved[axis]->SetDataTypeToDouble();
    moved[axis]->DeepCopy(this->System->GetOutput()->GetPoints());
    if (!this->System->Drag(unit, moved[axis]))
    {
      return nullptr;
    }
    if (this->Mirror)
    {
      vtkNew<vtkPolyData> side;
      side->ShallowCopy(this->System->GetOutput());
      side->SetPoints(moved[axis]);
      this->Mirror->SetInputData(1, side);
      this->Mirror->Update();
      moved[axis] = this->Mirror->GetOutput()->GetPoints();
    }
    if (moved[axis]->GetNumberOfPoints() != following->count)
    {
      return nullptr;
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

void SystemRunner::prepare(vtkPolyData* mesh, int backend, const Listener& listener)
{
  const SystemInput* input = findInput(this->Row, SystemInput::Kind::Mesh);
  if (!input)
  {
    return;
  }
  this->System->SetBackend(backend);
  this->System->SetInputDataObject(input->port, shared(mesh));
  try
  {
    // What keeps it from preparing, the next run tells.
    failureOf(this->System, listenerOf(this->System, listener), [this] { this->System->Prepare(); });
  }
  catch (const oversketch::Error&)
  {
    return; // cancelled
  }
}

} // namespace oversketch_session
