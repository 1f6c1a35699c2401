#include "vtkOversketchPose.h"

#include "Matrix/moving_patch.h"
#include "Pose/pose.h"
#include "Stroke/stroke.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchPolylines.h"
#include "vtkOversketchWeldedInput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

using namespace oversketch;

namespace
{

constexpr double mostOfModel = 1.0 / 3.0; // of its points: a limb is less
constexpr double mostBeside = 0.2;        // of the bone
constexpr const char* boneRefused = "The bone cannot be used: %1";
constexpr const char* poseRefused = "The pose cannot be used: %1";

// A line without jitter, and its view.
struct DrawnBone
{
  Polyline line;
  View view;
};

DrawnBone drawnBoneOf(vtkPolyData* stroke, const char* refusal)
{
  try
  {
    const Polyline samples = StrokeOf(stroke);
    StrokeRules rules;
    rules.refuseClosed = false;
    Polyline line;
    for (const Blend& place : cleanStroke(samples, rules))
    {
      line.push_back(place.of(samples));
    }
    return { line, ViewOf(stroke) };
  }
  catch (const Error& error)
  {
    throw Error(error.failure(), refusal, error.message());
  }
}

bool isAbsent(vtkPolyData* stroke)
{
  return !stroke || (stroke->GetNumberOfPoints() == 0 && stroke->GetNumberOfCells() == 0);
}

void putHold(const Bone& bone, vtkPolyData* hold)
{
  Polylines lines;
  lines.Add(bone.seen);
  lines.Put(hold);
}

Message remarkOf(vtkIdType folds, double share, double beside)
{
  std::vector<Message> said;
  if (beside > mostBeside)
  {
    said.emplace_back(
      "%1 % of the bone lie beside the model and count for nothing: draw it over the limb, from "
      "the joint that stays to the tip.",
      std::lround(100.0 * beside));
  }
  if (share > mostOfModel)
  {
    said.emplace_back("The bone takes %1 % of the model with it: begin it where the limb leaves the body, if "
                      "that is not meant.",
      std::lround(100.0 * share));
  }
  if (folds > 0)
  {
    said.emplace_back(folds == 1
                        ? "The pose folds the model along %1 edge: bend it less, or with more {Softness}."
                        : "The pose folds the model along %1 edges: bend it less, or with more {Softness}.",
      folds);
  }
  return Message::joined(said);
}

} // namespace

struct vtkOversketchPose::Inner
{
  WeldedInput Input;

  // The bone, what goes with it, and the part of the mesh that this changes.
  struct Grip
  {
    Bone Line;
    Limb Part;
    std::shared_ptr<MovingPatch> Patch;
  };
  const Grip* Held = nullptr; // of the last bone
  void FeedBone(vtkPolyData* stroke, const Context& context, vtkIdType& count)
  {
    this->Held = nullptr;
    this->Held = &this->Grips.Provide(StepKey({ this->Input.Key(), WholeKey(stroke) }, {}),
      [&]
      {
        ++count;
        const DrawnBone drawn = drawnBoneOf(stroke, boneRefused);
        const MeshData& data = this->Input.Data();
        Grip grip;
        grip.Line = boneUnder(this->Input.Rays(context), drawn.view, drawn.line, context);
        grip.Part = limbOf(data.Surface(), data.Neighbours(), grip.Line, context);
        grip.Patch = std::make_shared<MovingPatch>(data.Surface(), data.Neighbours(), grip.Part.vertices);
        return grip;
      });
  }

  struct Counts
  {
    vtkIdType Moved = 0, Joints = 0, Folds = 0;
    double Bend = 0.0;
  };
  Counts Figures; // of what is kept

  struct Result
  {
    vtkNew<vtkPolyData> Output, Hold;
    std::vector<char> Moves; // by point of the output: those of a limb that moves
    double Share = 0.0;      // the limb's, of the welded points
    Counts Figures;
  };
  std::unique_ptr<Result> Made; // null after a run that failed

  // Leaves the limb's points where they are as far as they are masked.
  void HoldMasked(vtkPolyData* mesh, std::vector<Vector3>& places)
  {
    const std::vector<double> mask = this->Input.MaskOfVertices(mesh);
    for (std::size_t i = 0; !mask.empty() && i < places.size(); ++i)
    {
      const int v = this->Held->Part.vertices[i];
      const Vector3& rest = this->Input.Data().Surface().points[v];
      places[i] = mask[v] == 0.0 ? places[i] : Vector3(rest + (1.0 - mask[v]) * (places[i] - rest));
    }
  }

  void Move(vtkPolyData* mesh, const Posed& made, vtkPolyData* result)
  {
    this->Input.Move(mesh, this->Held->Part.vertices, made.places, result);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      this->Figures.Moved += Vector3(mesh->GetPoint(i)) != Vector3(result->GetPoint(i));
    }
  }

  void Keep(vtkPolyData* output)
  {
    auto made = std::make_unique<Result>();
    const std::vector<char> isLimb =
      marksAt(this->Held->Part.vertices, this->Input.Data().Surface().points.size());
    made->Moves.assign(static_cast<std::size_t>(output->GetNumberOfPoints()), 0);
    for (std::size_t i = 0; this->Figures.Moved > 0 && i < made->Moves.size(); ++i)
    {
      made->Moves[i] = isLimb[this->Input.VertexOf(static_cast<vtkIdType>(i))];
    }
    made->Share = static_cast<double>(this->Held->Part.vertices.size()) / static_cast<double>(isLimb.size());
    made->Output->ShallowCopy(output);
    made->Figures = this->Figures;
    putHold(this->Held->Line, made->Hold);
    this->Made = std::move(made);
  }

private:
  KeptValue<Grip> Grips;
};

vtkStandardNewMacro(vtkOversketchPose);

vtkOversketchPose::vtkOversketchPose()
{
  this->SetNumberOfInputPorts(3);
  DeclareInput(this, 2, { Port::Optional });
}

int vtkOversketchPose::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  Inner& inner = this->Kept<Inner>();
  inner.Made = nullptr;
  Message remark;
  const int done = this->RunOnMesh(inputs,
    outputs,
    [&](vtkPolyData* mesh, vtkPolyData* output)
    {
      vtkPolyData* bone = vtkPolyData::GetData(inputs[1]);
      this->PutPosed(mesh, bone, vtkPolyData::GetData(inputs[2]), output);
      inner.Keep(output);
      remark = remarkOf(inner.Made->Figures.Folds, inner.Made->Share, inner.Held->Line.beside);
    });
  this->SetRemark(remark);
  return done;
}

void vtkOversketchPose::PutPosed(vtkPolyData* mesh, vtkPolyData* bone, vtkPolyData* pose, vtkPolyData* output)
{
  Inner& inner = this->Kept<Inner>();
  RequireFinite(this->Softness, "Softness");
  if (isAbsent(bone))
  {
    throw Error(
      Failure::BadStroke, "There is no bone; draw one along a limb, from the joint that stays to the tip.");
  }
  inner.Input.Feed(mesh);
  inner.Input.Rays(ContextOf(this, 0.0, 0.3));
  inner.FeedBone(bone, ContextOf(this, 0.3, 0.6), this->LimbCount);
  const Inner::Grip& grip = *inner.Held;
  const MeshKey course = isAbsent(pose) ? MeshKey() : WholeKey(pose);
  const StepKey key(
    { WholeKey(mesh), WholeKey(bone), course }, { this->Softness, this->Stretch ? 1.0 : 0.0 });
  this->Kept<KeptOutput>().Provide(key,
    output,
    [&](vtkPolyData* result)
    {
      inner.Figures = Inner::Counts();
      if (isAbsent(pose))
      {
        result->ShallowCopy(mesh);
        return;
      }
      const DrawnBone drawn = drawnBoneOf(pose, poseRefused);
      Posed made = posed(grip.Patch->rest(),
        grip.Part,
        grip.Line,
        drawn.view,
        drawn.line,
        { this->Softness, this->Stretch },
        ContextOf(this, 0.6, 0.8));
      inner.HoldMasked(mesh, made.places);
      inner.Move(mesh, made, result);
      inner.Figures.Joints = made.joints;
      inner.Figures.Bend = made.bend;
      inner.Figures.Folds =
        grip.Patch->shapeAt(made.places, MovingPatch::Normals::None, ContextOf(this, 0.8, 1.0)).foldedEdges;
    });
}

bool vtkOversketchPose::PreviewPose(vtkPolyData* preview)
{
  return this->Try(
    [&]
    {
      auto* mesh = vtkPolyData::SafeDownCast(this->UpdatedInput(0));
      auto* bone = vtkPolyData::SafeDownCast(this->UpdatedInput(1));
      auto* pose = vtkPolyData::SafeDownCast(this->UpdatedInput(2));
      if (!mesh || mesh->GetNumberOfPoints() == 0 || isAbsent(bone) || isAbsent(pose))
      {
        return false;
      }
      vtkNew<vtkPolyData> made;
      this->PutPosed(mesh, bone, pose, made);
      preview->ShallowCopy(made);
      return true;
    });
}

bool vtkOversketchPose::Prepare()
{
  return this->TryPrepare(
    [this](vtkPolyData* mesh)
    {
      WeldedInput& input = this->Kept<Inner>().Input;
      input.Feed(mesh);
      input.Rays(ContextOf(this));
      input.Data().Neighbours();
    });
}

bool vtkOversketchPose::Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold)
{
  return this->TryPreview(mesh,
    stroke,
    hold,
    [&]
    {
      WeldedInput& input = this->Kept<Inner>().Input;
      input.Feed(mesh);
      const SurfaceRays& rays = input.Rays(ContextOf(this, 0.0, 0.5));
      if (stroke->GetNumberOfPoints() < 2)
      {
        return false;
      }
      const DrawnBone drawn = drawnBoneOf(stroke, boneRefused);
      putHold(boneUnder(rays, drawn.view, drawn.line, ContextOf(this, 0.5, 1.0)), hold);
      return true;
    });
}

void vtkOversketchPose::GetHold(vtkPolyData* hold)
{
  hold->Initialize();
  if (this->Kept<Inner>().Made)
  {
    hold->ShallowCopy(this->Kept<Inner>().Made->Hold);
  }
}

void vtkOversketchPose::GetRegion(vtkPolyData* region)
{
  region->Initialize();
  if (this->Kept<Inner>().Made)
  {
    PutTriangles(this->Kept<Inner>().Made->Output, this->Kept<Inner>().Made->Moves, 1, region);
  }
}

vtkOversketchSystem::FigureList vtkOversketchPose::Figures()
{
  if (!this->Kept<Inner>().Made)
  {
    return {};
  }
  const auto& figures = this->Kept<Inner>().Made->Figures;
  return { { "moved", figures.Moved },
    { "joints", figures.Joints },
    { "bend", figures.Bend },
    { "folded_edges", figures.Folds },
    { "share", this->Kept<Inner>().Made->Share } };
}

void vtkOversketchPose::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Softness: " << this->Softness << "\n";
  os << indent << "Stretch: " << this->Stretch << "\n";
  os << indent << "LimbCount: " << this->LimbCount << "\n";
}
