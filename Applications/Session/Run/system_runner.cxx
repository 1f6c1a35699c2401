#include "system_runner.h"

#include "mirror_image.h"
#include "two_sides.h"

#include "vtkOversketchMirror.h"
#include "vtkOversketchStepRunner.h"
#include "vtkOversketchSystem.h"

#include "Mesh/context.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace oversketch_session
{

namespace
{

// Shares of the progress of a step with a mirror plane: what is done when it is known whether points have
// partners, when the side that was drawn on is done, and when the other one is found to need another run.
constexpr double oneSide = 0.5, twoSides = 0.6, lastSide = 0.8;

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

// Runs work with a system or a filter that is heard meanwhile. Empty where it went well, else the reason.
// Throws Error where it was cancelled.
oversketch::Message failureOf(vtkAlgorithm* algorithm,
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
    return error.message();
  }
  return {};
}

// Progress is that of a part of the step.
oversketch::StepRunner::Listener listenerOf(vtkOversketchSystem* system,
  const Listener& listener,
  double from = 0.0,
  double to = 1.0)
{
  oversketch::StepRunner::Listener made;
  made.cancelled = listener.cancelled;
  if (listener.progress)
  {
    made.progress = [=, progress = listener.progress](double share)
    { progress(system->GetStageName(), from + share * (to - from)); };
  }
  return made;
}

} // namespace

struct SystemRunner::TwoSides
{
  vtkSmartPointer<vtkPolyData> first, second;
  std::unique_ptr<const MirrorImage> image; // of which the second is
  vtkSmartPointer<vtkPolyData> inImage;     // that, before it came back
};

SystemRunner::SystemRunner(const SystemRow& row)
  : Row(row)
  , System(row.make())
{
}

SystemRunner::~SystemRunner() = default;

void SystemRunner::feed(const Values& values, const Data& inputs)
{
  for (const SystemInput& input : this->Row.inputs)
  {
    const auto given = inputs.find(input.name);
    this->System->SetInputDataObject(input.port, given == inputs.end() ? nullptr : given->second.Get());
  }
  for (const Parameter& one : this->Row.parameters)
  {
    const auto given = values.find(one.property);
    const Value& value = given == values.end() ? one.initial : given->second;
    if (one.get(this->System) != value)
    {
      one.set(this->System, value);
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
  const Task task{ step, inputs, backend, ports, listener };
  this->Mirror = nullptr;
  this->Sides = nullptr;
  if (!step.mirror)
  {
    return this->runOnce(task, step.values, 0.0, 1.0, outcome);
  }
  if (this->Row.mirroring == Mirroring::Strokes)
  {
    return this->runReflected(task, outcome);
  }
  if (this->Row.mirroring == Mirroring::TwoRuns)
  {
    return this->runTwice(task, outcome);
  }
  Values kept = this->Row.keepingPoints;
  kept.insert(step.values.begin(), step.values.end());
  Outcome made = outcome;
  if (!this->runOnce(task, kept, 0.0, oneSide, made))
  {
    return false;
  }
  bool follows = false;
  try
  {
    follows = made.failure.empty() && this->followPartners(task, made);
  }
  catch (const oversketch::Error&)
  {
    return false;
  }
  if (!follows)
  {
    return this->runTwice(task, outcome);
  }
  outcome = made;
  return true;
}

bool SystemRunner::runOnce(const Task& task, const Values& values, double from, double to, Outcome& outcome)
{
  this->feed(values, task.inputs);
  this->System->SetBackend(task.backend);
  vtkSmartPointer<vtkPolyData> made = this->System->GetOutput();
  try
  {
    // Modified, since a run that failed before would report an empty success.
    this->System->Modified();
    auto listener = listenerOf(this->System, task.listener, from, to);
    listener.warning = [&outcome](const oversketch::Message& message) { outcome.remarks.push_back(message); };
    outcome.failure = failureOf(this->System, listener, [this] { this->System->Update(); });
  }
  catch (const oversketch::Error&)
  {
    return false;
  }
  if (outcome.failure.empty() && made->GetNumberOfPolys() == 0)
  {
    outcome.failure = "no mesh came of it";
  }
  if (outcome.failure.empty())
  {
    vtkNew<vtkPolyData> hold;
    this->System->GetHold(hold);
    outcome.mesh = shallowCopyOf(made.Get());
    outcome.section = sectionOf(hold);
    outcome.hold = shallowCopyOf(hold.Get());
    outcome.backendUsed = this->System->GetBackendUsed();
    for (const int port : task.ports)
    {
      outcome.outputs[port] = shallowCopyOf(this->System->GetOutputDataObject(port));
    }
  }
  return true;
}

bool SystemRunner::runReflected(const Task& task, Outcome& outcome)
{
  const MirrorPlane& plane = *task.step.mirror;
  const auto mesh = task.inputs.find(findInput(this->Row, SystemInput::Kind::Mesh)->name);
  const auto drawn = task.inputs.find(findInput(this->Row, SystemInput::Kind::Stroke)->name);
  vtkPolyData* strokes = drawn == task.inputs.end() ? nullptr : vtkPolyData::SafeDownCast(drawn->second);
  Data inputs = task.inputs;
  if (strokes)
  {
    this->feed(task.step.values, task.inputs);
    vtkPolyData* under = vtkPolyData::SafeDownCast(mesh->second);
    vtkNew<vtkPolyData> hold;
    this->System->Preview(under, strokes, hold);
    if (!crossesMirrorPlane(hold, plane, under))
    {
      inputs[drawn->first] = withReflections(strokes, plane);
    }
  }
  return this->runOnce(
    { task.step, inputs, task.backend, task.ports, task.listener }, task.step.values, 0.0, 1.0, outcome);
}

bool SystemRunner::followPartners(const Task& task, Outcome& outcome)
{
  const MirrorPlane& plane = *task.step.mirror;
  auto mirror = vtkSmartPointer<vtkOversketchMirror>::New();
  mirror->SetInputDataObject(0, task.inputs.at(findInput(this->Row, SystemInput::Kind::Mesh)->name));
  mirror->SetInputData(1, this->System->GetOutput());
  mirror->SetAxis(plane.axis);
  mirror->SetOffset(plane.offset);
  if (outcome.section)
  {
    const bool below = outcome.section->middle[static_cast<std::size_t>(plane.axis)] < plane.offset;
    mirror->SetSide(below ? vtkOversketchMirror::Below : vtkOversketchMirror::Above);
  }
  oversketch::StepRunner::Listener quiet;
  quiet.cancelled = task.listener.cancelled;
  if (!failureOf(mirror, quiet, [&] { mirror->Update(); }).empty())
  {
    return false;
  }
  outcome.mesh = shallowCopyOf(mirror->GetOutput());
  this->Mirror = mirror;
  return true;
}

bool SystemRunner::runTwice(const Task& task, Outcome& outcome)
{
  const MirrorPlane& plane = *task.step.mirror;
  const auto came = task.inputs.find(findInput(this->Row, SystemInput::Kind::Mesh)->name);
  vtkPolyData* before = vtkPolyData::SafeDownCast(came->second);
  Outcome one = outcome;
  if (!this->runOnce(task, task.step.values, oneSide, twoSides, one))
  {
    return false;
  }
  if (!one.failure.empty() || crossesMirrorPlane(one.hold, plane, before))
  {
    outcome = one;
    return true;
  }
  auto sides = std::make_unique<TwoSides>();
  sides->first = one.mesh;
  vtkSmartPointer<vtkPolyData> made;
  std::vector<oversketch::Message> others;
  const std::string whose = mirroredTo(one.section, plane);
  for (vtkPolyData* under : { before, one.mesh.Get() })
  {
    if (made || (under == before && !sameCells(before, one.mesh)))
    {
      continue;
    }
    Listener listener = task.listener;
    if (listener.progress)
    {
      const double from = under == before ? twoSides : lastSide, to = under == before ? lastSide : 1.0;
      listener.progress = [&task, from, to](const std::string& stage, double share)
      { task.listener.progress(stage, from + share * (to - from)); };
    }
    sides->image = std::make_unique<MirrorImage>(under, plane);
    Outcome two;
    if (!this->runImage({ task.step, task.inputs, task.backend, task.ports, listener }, *sides->image, two))
    {
      return false;
    }
    if (!two.failure.empty())
    {
      outcome.failure = { "%1: %2", whose, two.failure };
      return true;
    }
    if (isSamePlace(one.section, two.section, plane))
    {
      outcome = one;
      return true;
    }
    others = two.remarks;
    sides->inImage = two.mesh;
    sides->second = sides->image->back(two.mesh);
    made = under == before ? joined(before, one.mesh, sides->second) : sides->second;
  }
  outcome = one;
  outcome.mesh = made;
  for (const oversketch::Message& other : others)
  {
    outcome.remarks.emplace_back("%1: %2", whose, other);
  }
  this->Sides = std::move(sides);
  return true;
}

bool SystemRunner::runImage(const Task& task, const MirrorImage& image, Outcome& outcome)
{
  if (!this->Image)
  {
    this->Image = std::make_unique<SystemRunner>(this->Row);
  }
  Data inputs = task.inputs;
  const SystemInput* changed = findInput(this->Row, SystemInput::Kind::Mesh);
  for (const SystemInput& input : this->Row.inputs)
  {
    const auto given = inputs.find(input.name);
    vtkPolyData* data = given == inputs.end() ? nullptr : vtkPolyData::SafeDownCast(given->second);
    // The output of an earlier step lies on the mesh, whatever else the input may be.
    const bool isInWorld = input.kind == SystemInput::Kind::Mesh || input.kind == SystemInput::Kind::Curves ||
                           (data && data->GetPointData()->HasArray("VertexId"));
    if (&input == changed)
    {
      given->second = image.get();
    }
    else if (isInWorld && data)
    {
      given->second = MirrorImage(data, *task.step.mirror).get();
    }
  }
  Step step = task.step;
  step.mirror.reset();
  return this->Image->run(step, inputs, task.backend, {}, task.listener, outcome);
}

std::shared_ptr<const Details> SystemRunner::details(vtkPolyData* made,
  const std::function<bool()>& cancelled)
{
  auto details = std::make_shared<Details>();
  details->region = vtkSmartPointer<vtkPolyData>::New();
  this->System->GetRegion(details->region);
  try
  {
    details->following = this->following(this->Sides ? this->Sides->first.Get() : made, cancelled);
  }
  catch (const oversketch::Error&)
  {
    return nullptr;
  }
  if (!this->Sides)
  {
    return details;
  }
  const TwoSides& sides = *this->Sides;
  const std::shared_ptr<const Details> inImage = this->Image->details(sides.inImage, cancelled);
  return inImage
           ? joined(
               made, { sides.first, details }, { sides.second, sides.image->back(sides.inImage, *inImage) })
           : nullptr;
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
      const auto side = shallowCopyOf(this->System->GetOutput());
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

void SystemRunner::releaseWork()
{
  this->System->ReleaseWork();
  this->Mirror = nullptr;
  this->Sides.reset();
  if (this->Image)
  {
    this->Image->releaseWork();
  }
}

void SystemRunner::prepare(vtkPolyData* mesh, int backend, const Listener& listener)
{
  const SystemInput* input = findInput(this->Row, SystemInput::Kind::Mesh);
  if (!input)
  {
    return;
  }
  this->System->SetInputDataObject(input->port, shallowCopyOf(mesh));
  this->System->SetBackend(backend);
  try
  {
    // The next run tells what keeps it from preparing.
    failureOf(this->System, listenerOf(this->System, listener), [this] { this->System->Prepare(); });
  }
  catch (const oversketch::Error&)
  {
    // cancelled
  }
}

} // namespace oversketch_session
