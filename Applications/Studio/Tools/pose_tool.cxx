#include "pose_tool.h"

#include "document.h"
#include "point_normals.h"
#include "systems.h"
#include "viewport.h"

#include "Mesh/view.h"
#include "Stroke/polyline.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchPose.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr const char* poseSystem = "Pose";
constexpr const char* boneInput = "Bone";
constexpr const char* courseInput = "Pose";

constexpr double nearOfLength =
  1.0 / 3.0;                           // of the bone's: a line that begins so near to its joint is its course
constexpr double leastNear = 20.0;     // px as Qt counts them
constexpr vtkIdType mostLive = 300000; // triangles of a mesh that follows while the pen moves

} // namespace

PoseTool::PoseTool(Viewport* viewport, const Document* document)
  : HeldStrokeTool(poseSystem, viewport, document)
{
  this->setObjectName("pose");
}

PoseTool::~PoseTool() = default;

// A limb's bone, and where it goes.
QPainterPath PoseTool::icon() const
{
  QPainterPath path;
  path.addEllipse(2, 16, 5, 5);
  path.moveTo(7, 18.5);
  path.lineTo(22, 18.5);
  path.moveTo(6, 16.5);
  path.lineTo(15, 4);
  path.moveTo(15.5, 8.5);
  path.lineTo(15, 4);
  path.lineTo(10.8, 5.6);
  return path;
}

QVector<QPair<QString, QString>> PoseTool::keys() const
{
  return {
    { tr("Left drag"), tr("draw a bone, then from its joint on where it is to go") },
  };
}

QString PoseTool::advice(const Situation& situation) const
{
  if (situation.redraws)
  {
    return tr("Redraw the selected bone, then where it is to go. T leaves it as it is.");
  }
  if (!this->Offered)
  {
    return tr("Draw a bone along a limb, from the joint that stays to the tip. The middle button turns the "
              "model, F1 lists the keys.");
  }
  return this->Offered->step.inputs.count(courseInput) == 0
           ? tr("Now draw where the bone is to go, from the same joint on: the limb bends with it. Return "
                "leaves the bone.")
           : tr("Draw from the joint on again, where the bone is to go. Return leaves it, for the next bone. "
                "Ctrl+Z undoes.");
}

void PoseTool::offer(const Step& step, const Worker::NodeState& state, const Point& place)
{
  HeldStrokeTool::offer(step, state, place);
  if (state.before && linesOf(step, boneInput))
  {
    this->Offered = Held{ step, state.before, place };
  }
}

void PoseTool::offerNothing()
{
  this->Offered.reset();
  HeldStrokeTool::offerNothing();
}

bool PoseTool::isAtJoint(vtkPolyData* line) const
{
  const vtkSmartPointer<vtkPolyData> bone = linesOf(this->Offered->step, boneInput);
  try
  {
    const oversketch::View drawn = oversketch::ViewOfStroke(bone, 0), now = oversketch::ViewOfStroke(line, 0);
    const Point& place = this->Offered->place;
    const double depth = drawn.depth({ place[0], place[1], place[2] });
    const std::vector<oversketch::Vector2> samples = oversketch::StrokeOf(bone);
    const double length = oversketch::arcLengths(samples).back();
    const oversketch::Vector3 joint = now.toDisplay(drawn.toWorld(samples.front(), depth));
    const double away = (joint.head<2>() - oversketch::Vector3(line->GetPoint(0)).head<2>()).norm();
    return away <= std::max(leastNear * this->viewport()->devicePixelRatioF(), nearOfLength * length);
  }
  catch (const oversketch::Error&)
  {
    return false; // a step of a file may have lines that are none
  }
}

bool PoseTool::takesLine(vtkPolyData* line)
{
  if (!this->Offered || !this->isAtJoint(line))
  {
    return false;
  }
  this->Posing = this->Offered;
  this->feedLive();
  return true;
}

void PoseTool::feedLive()
{
  const Held& held = *this->Posing;
  this->Rest = nullptr;
  if (held.before->GetNumberOfPolys() > mostLive)
  {
    return;
  }
  try
  {
    this->Live->SetInputData(0, oversketch_files::withPointNormals(held.before.own()));
  }
  catch (const oversketch::Error&)
  {
    return; // the step tells what is wrong with the mesh
  }
  this->Live->SetBoneData(linesOf(held.step, boneInput));
  for (const Parameter& one : findSystem(poseSystem)->parameters)
  {
    one.set(this->Live, valueOf(held.step, one));
  }
  this->Rest = this->viewport()->mesh();
}

bool PoseTool::follow(vtkPolyData* line)
{
  vtkNew<vtkPolyData> course;
  course->DeepCopy(line);
  this->Live->SetPoseData(course);
  if (!this->Rest || !this->Live->PreviewPose(this->Shown))
  {
    return false;
  }
  this->viewport()->showPreview(this->Shown);
  return true;
}

// The document runs it; until then what was seen last stays.
void PoseTool::lineWhole(vtkPolyData* line)
{
  if (!this->Posing)
  {
    return;
  }
  this->follow(line);
  this->Rest = nullptr;
  Step step = std::exchange(this->Posing, std::nullopt)->step;
  step.inputs[courseInput] = Lines(line);
  emit this->remade(step);
}

void PoseTool::lineEnds()
{
  if (this->Rest && this->viewport()->mesh() == this->Shown.Get())
  {
    this->viewport()->showPreview(this->Rest);
  }
}

} // namespace oversketch_studio
