#include "vtkOversketchOneStrokePipeline.h"

#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchMaskArray.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using namespace oversketch;

namespace
{

// Of a larger one vtkOversketchOutline may see a part only: that round the first stroke in the view [px].
constexpr int widestViewport = 4092;

// A stroke without any outline so near was drawn in the void [px].
constexpr double farthestOutline = 60.0;

// Sections that are tried where the one that fits best turns a limb inside out, that one among them.
constexpr int mostCandidates = 4;

// The factor of a region with so many vertices takes some hundred MiB: it is kept no longer than a run needs
// it. What following a hand takes of it is a number for each vertex.
constexpr vtkIdType manyVertices = 30000;

void releaseLargeFactor(vtkAlgorithm* step)
{
  auto* deform = vtkOversketchLaplacianDeform::SafeDownCast(step);
  if (deform->GetMovableCount() > manyVertices)
  {
    deform->ReleaseFactor();
  }
}

} // namespace

vtkOversketchOneStroke::Pipeline::Pipeline(vtkOversketchOneStroke* self)
  : Self(self)
{
  this->Silhouette->SetInputData(0, this->Mesh);
  this->Silhouette->SetInputData(1, this->View);
  this->Snake->SetInputConnection(0, this->Silhouette->GetOutputPort());
  this->Snake->SetInputData(1, this->Mesh);
  this->Snake->SetInputData(2, this->View);
  this->Visibility->SetInputConnection(0, this->Snake->GetOutputPort());
  this->Visibility->SetInputData(1, this->Mesh);
  this->Visibility->SetInputData(2, this->View);
  this->Outline->SetInputData(0, this->Mesh);
  this->Outline->SetInputData(1, this->View);
  this->Outline->SetInputConnection(2, this->Visibility->GetOutputPort());
  this->StrokeStep->SetInputData(0, this->Stroke);
  this->Match->SetInputConnection(1, this->StrokeStep->GetOutputPort());
  this->Targets->SetInputConnection(0, this->Match->GetOutputPort());
  this->Targets->SetInputConnection(1, this->Match->GetOutputPort(1));
  this->Targets->SetInputData(2, this->Mesh);
  this->ShapeDiameter->SetInputData(0, this->Mesh);
  this->MixtureRegion->SetInputConnection(0, this->ShapeDiameter->GetOutputPort());
  this->MixtureRegion->SetInputConnection(1, this->Targets->GetOutputPort());
  this->RegionBorder->SetInputConnection(0, this->MixtureRegion->GetOutputPort());
  this->Deform->SetInputConnection(0, this->RegionBorder->GetOutputPort());
  this->Deform->SetInputConnection(1, this->Targets->GetOutputPort());
  this->Stretch->SetStageToStretch();
  this->Stretch->SourcesOfAllOff();
  this->Restore->SourcesOfAllOff();
  this->Stretch->SetInputConnection(0, this->RegionBorder->GetOutputPort());
  this->Stretch->SetInputConnection(1, this->Targets->GetOutputPort());
  this->DeformRemeshed->SetInputConnection(0, this->Stretch->GetOutputPort(0));
  this->DeformRemeshed->SetInputConnection(1, this->Stretch->GetOutputPort(1));
  this->Restore->SetStageToRestore();
  this->Restore->SetInputConnection(0, this->DeformRemeshed->GetOutputPort());
  this->Correction->SetInputConnection(0, this->Targets->GetOutputPort());
  this->Correction->SetInputConnection(2, this->Deform->GetOutputPort());
  this->Correction->SetInputConnection(3, this->RegionBorder->GetOutputPort());
  this->DeformCorrected->SetInputConnection(0, this->RegionBorder->GetOutputPort());
  this->DeformCorrected->SetInputConnection(1, this->Correction->GetOutputPort());
  this->CorrectionRemeshed->SetInputConnection(0, this->Stretch->GetOutputPort(1));
  this->CorrectionRemeshed->SetInputConnection(2, this->DeformRemeshed->GetOutputPort());
  this->CorrectionRemeshed->SetInputConnection(3, this->Stretch->GetOutputPort(0));
  this->DeformRemeshedCorrected->SetInputConnection(0, this->Stretch->GetOutputPort(0));
  this->DeformRemeshedCorrected->SetInputConnection(1, this->CorrectionRemeshed->GetOutputPort());
  for (vtkOversketchCorrection* step : { this->Correction.Get(), this->CorrectionRemeshed.Get() })
  {
    step->SetInputConnection(1, this->Match->GetOutputPort(1));
  }

  const auto stage = [self](const char* name, vtkAlgorithm* step, double share)
  { self->AddStage(name, step, share); };
  stage("Stroke", this->StrokeStep, 0.01);
  stage("Silhouette", this->Silhouette, 0.02);
  stage("Snake", this->Snake, 0.03);
  stage("Visibility", this->Visibility, 0.04);
  stage("Outline", this->Outline, 0.04);
  stage("Match", this->Match, 0.01);
  stage("Targets", this->Targets, 0.01);
  stage("ShapeDiameter", this->ShapeDiameter, 0.12);
  stage("MixtureRegion", this->MixtureRegion, 0.24);
  stage("RegionBorder", this->RegionBorder, 0.01);
  stage("Deform", this->Deform, 0.08);
  stage("Correction", this->Correction, 0.02);
  stage("Stretch", this->Stretch, 0.12);
  stage("Restore", this->Restore, 0.12);
  // These repeat others.
  self->AddStage("DeformCorrected", this->DeformCorrected, 0.06, Listed::No);
  self->AddStage("DeformRemeshed", this->DeformRemeshed, 0.06, Listed::No);
  self->AddStage("CorrectionRemeshed", this->CorrectionRemeshed, 0.02, Listed::No);
  self->AddStage("DeformRemeshedCorrected", this->DeformRemeshedCorrected, 0.06, Listed::No);
  this->SetAmendments(true);
}

void vtkOversketchOneStroke::Pipeline::SetAmendments(bool on)
{
  this->Match->RemoveAllInputConnections(0);
  this->Match->AddInputConnection(0, this->Visibility->GetOutputPort());
  if (on)
  {
    this->Match->AddInputConnection(0, this->Outline->GetOutputPort());
  }
  this->StrokeStep->SetMaximumLength(on ? 8.0 : 0.0);
  this->StrokeStep->SetRefuseClosed(!on); // the match opens them
  this->Match->SetAmendedScore(on);
  this->Match->SetCompareShapes(on);
  this->Match->SetMaximumGap(on ? farthestOutline : 0.0);
  this->Targets->SetSingleLayer(on);
  this->ShapeDiameter->SetTurnCones(on);
  this->ShapeDiameter->SetOnDemand(on); // published samples are drawn and scaled over all
  this->MixtureRegion->SetSeedMargin(on ? 0.1 : 0.0);
  this->MixtureRegion->SetFillIslands(on);
  this->MixtureRegion->SetLimitRunaway(on);
  this->MixtureRegion->SetCutAtJunction(on);
  this->MixtureRegion->SetReachEnds(on);
  this->MixtureRegion->SetConfineToSection(on);
  this->MixtureRegion->SetEvenSamples(on);
  this->MixtureRegion->SetIgnoreNoise(on);
  this->RegionBorder->SetConfine(on);
  for (vtkOversketchRemesh* step : { this->Stretch.Get(), this->Restore.Get() })
  {
    step->SetLimitByDiameter(on);
    step->SetProtectSection(on);
    step->SetKeepSmooth(on);
  }
}

void vtkOversketchOneStroke::Pipeline::FeedMesh(vtkPolyData* mesh)
{
  // Welding asks for the attributes too: they tell seams from points that were split for nothing.
  const auto key = [this, mesh]
  {
    std::vector<vtkDataArray*> arrays;
    arrays.reserve(static_cast<std::size_t>(mesh->GetPointData()->GetNumberOfArrays()));
    for (int a = 0; a < mesh->GetPointData()->GetNumberOfArrays(); ++a)
    {
      arrays.push_back(mesh->GetPointData()->GetArray(a));
    }
    const bool welded = this->Welding->Welded()->GetPoints() != mesh->GetPoints();
    return welded ? MeshKey(mesh, arrays) : MeshKey(mesh);
  };
  if (!this->Welding || key() != this->MeshKeySeen)
  {
    this->Welding = std::make_unique<oversketch::Weld>(mesh);
    this->MeshKeySeen = key();
    this->Mesh->ShallowCopy(this->Welding->Welded());
    this->MaskSeen = { nullptr, 0 };
  }
  this->FeedMask(mesh);
}

void vtkOversketchOneStroke::Pipeline::FeedMask(vtkPolyData* mesh)
{
  vtkDataArray* mask = mesh->GetPointData()->GetArray(maskName);
  const std::pair<const vtkDataArray*, vtkMTimeType> seen{ mask, mask ? mask->GetMTime() : 0 };
  if (seen != this->MaskSeen)
  {
    this->Welding->PutMask(mesh, this->Mesh);
    this->MaskSeen = seen;
  }
}

void vtkOversketchOneStroke::Pipeline::FeedStroke(vtkPolyData* stroke)
{
  if (stroke == this->StrokeSeen.first && stroke->GetMTime() == this->StrokeSeen.second)
  {
    return;
  }
  const oversketch::View view = ViewOf(stroke);
  this->Stroke->ShallowCopy(stroke);
  this->StrokeSeen = { stroke, stroke->GetMTime() };
  std::vector<double> seen(view.viewTransform().data(), view.viewTransform().data() + 16);
  seen.insert(seen.end(), view.projectionTransform().data(), view.projectionTransform().data() + 16);
  seen.push_back(view.width());
  seen.push_back(view.height());
  if (seen == this->ViewSeen)
  {
    return;
  }
  this->ViewSeen = seen;
  this->View->DeepCopy(stroke);
  if (std::max(view.width(), view.height()) <= widestViewport)
  {
    vtkNew<vtkPoints> corners;
    corners->InsertNextPoint(0.0, 0.0, 0.0);
    corners->InsertNextPoint(view.width(), view.height(), 0.0);
    vtkNew<vtkCellArray> diagonal;
    diagonal->InsertNextCell({ 0, 1 });
    this->View->SetPoints(corners);
    this->View->SetLines(diagonal);
    this->View->GetPointData()->Initialize();
  }
}

void vtkOversketchOneStroke::Pipeline::RunCurves()
{
  for (const char* name : { "Silhouette", "Snake", "Visibility" })
  {
    this->Self->RunStage(name);
  }
  if (this->Match->GetNumberOfInputConnections(0) > 1)
  {
    this->Self->RunStage("Outline");
  }
}

bool vtkOversketchOneStroke::Pipeline::WantsRemeshing()
{
  const oversketch::Mesh before = this->PartOf("RegionBorder").mesh;
  const MeshPart& part = this->PartOf(this->Deformation);
  return wantsRemeshing(before, part.mesh, part.region);
}

const char* vtkOversketchOneStroke::Pipeline::Corrected(const char* before,
  const char* deform,
  const char* correction,
  const char* again)
{
  if (!this->Self->CorrectOutline)
  {
    return deform;
  }
  this->Made(deform); // for the correction, too
  this->Self->RunStage(correction);
  vtkAlgorithm* step = this->Self->GetStep(correction);
  const auto handlesAdded = this->Self->StageOutput(correction)->GetNumberOfPoints() -
                            vtkPolyData::SafeDownCast(step->GetInputDataObject(0, 0))->GetNumberOfPoints();
  const int folds = this->Folds(before);
  const Judgement plain = this->Judged(deform, folds);
  auto* other = vtkOversketchLaplacianDeform::SafeDownCast(this->Self->GetStep(again));
  const double weight =
    vtkOversketchLaplacianDeform::SafeDownCast(this->Self->GetStep(deform))->GetHandleWeight();
  Judgement judged = plain;
  if (handlesAdded > 0 || judged.folds > Judgement::tolerableFolds)
  {
    releaseLargeFactor(this->Self->GetStep(deform));
  }
  if (handlesAdded > 0)
  {
    other->SetHandleWeight(weight);
    this->MadeMeshes.erase(again);
    this->Self->RunStage(again);
    judged = this->Judged(again, folds);
  }
  if (judged.folds > Judgement::tolerableFolds)
  {
    // Handles that pull less fold less, and still reach the stroke within a fraction of a pixel.
    other->SetHandleWeight(0.2 * weight);
    this->MadeMeshes.erase(again);
    this->Self->RunStage(again);
    judged = this->Judged(again, folds);
  }
  return judged.betterThan(plain) ? again : deform;
}

void vtkOversketchOneStroke::Pipeline::RunDeformation(const char* stage)
{
  try
  {
    this->Self->RunStage(stage);
  }
  catch (const Error& error)
  {
    if (error.failure() != Failure::BadRegion || MaskedPointsOf(this->Mesh).empty())
    {
      throw;
    }
    throw Error(Failure::BadRegion,
      "So much of what the stroke was drawn beside is masked that nothing may follow it; free more of it, or "
      "draw beside a part that is free.");
  }
}

bool vtkOversketchOneStroke::Pipeline::RemeshingKept()
{
  const int folds = this->Folds("RegionBorder");
  Judgement restored = this->Judged("Restore", folds), plain = this->Judged(this->Deformation, folds);
  restored.roughness = this->Rough("Restore");
  plain.roughness = this->Rough(this->Deformation);
  restored.back = this->NewBack("Restore");
  plain.back = restored.back > 0.0 ? this->NewBack(this->Deformation) : 0.0;
  if (!restored.keptAgainst(plain))
  {
    return false;
  }
  const int crossings = this->NewCrossings("Restore");
  return crossings <= StrokeEffect::tolerableCrossings || crossings <= this->NewCrossings(this->Deformation);
}

bool vtkOversketchOneStroke::Pipeline::BeyondHelp()
{
  // What it asks for is seldom so, and costs a look at the whole mesh.
  constexpr double near = 5.0; // px
  const std::vector<char> region = this->RegionOf("RegionBorder");
  const auto chosen = std::count_if(region.begin(), region.end(), [](char inside) { return inside != 0; });
  const bool mayBe = this->Judged(this->Deformation, this->Folds("RegionBorder")).outline.mean > near ||
                     2 * static_cast<std::size_t>(chosen) > region.size();
  return mayBe && beyondHelp(this->EffectOf("RegionBorder", this->Deformation));
}

StrokeEffect vtkOversketchOneStroke::Pipeline::Run(int candidate)
{
  vtkOversketchOneStroke* const self = this->Self;
  this->MadeMeshes.clear();
  self->Remeshed = false;
  this->Match->SetCandidate(candidate);
  for (const char* name : { "Match", "Targets", "ShapeDiameter", "MixtureRegion", "RegionBorder" })
  {
    self->RunStage(name);
  }
  if (self->Remesh != RemeshOn)
  {
    this->RunDeformation("Deform");
    this->Deformation = this->Corrected("RegionBorder", "Deform", "Correction", "DeformCorrected");
  }
  const bool automatic = self->Remesh == RemeshAuto && !self->AsPublished;
  if (self->Remesh == RemeshOn || (automatic && this->WantsRemeshing() && !this->BeyondHelp()))
  {
    this->RunRemeshed();
  }
  const char* const made = self->Remeshed ? "Restore" : this->Deformation;
  StrokeEffect effect = this->EffectOf(self->Remeshed ? "Stretch" : "RegionBorder", made);
  effect.back = this->NewBack(made);
  effect.crossings = this->NewCrossings(made);
  return effect;
}

void vtkOversketchOneStroke::Pipeline::RunBest()
{
  const int asked = this->Self->Candidate;
  StrokeEffect effect = this->Run(asked);
  const bool mayChoose = asked == 1 && !this->Self->AsPublished;
  // Where most of the model moved, another section does no better, and each costs as much.
  const bool wrecked =
    effect.movedShare <= StrokeEffect::tornShare &&
    (effect.back > Judgement::tolerableBack || beyondHelp(effect) || crossesWrongly(effect));
  if (mayChoose && wrecked)
  {
    const int last = std::min(this->Match->GetNumberOfCandidates(), mostCandidates);
    bool found = false;
    for (int candidate = 2; candidate <= last && !found; ++candidate)
    {
      try
      {
        effect = this->Run(candidate);
        found = remarks(effect).empty();
      }
      catch (const Error& error)
      {
        if (error.failure() == Failure::Cancelled)
        {
          throw;
        }
      }
    }
    if (!found && last > 1)
    {
      effect = this->Run(asked);
    }
  }
  this->Hold->ShallowCopy(this->Self->StageOutput("Match"));
  this->Judge(effect);
}

void vtkOversketchOneStroke::Pipeline::Judge(const StrokeEffect& effect)
{
  const Message torn = tornBy(effect);
  if (!torn.empty() && !this->Self->AllowTorn && !this->Self->AsPublished)
  {
    throw Error(Failure::Torn,
      "The stroke would tear the mesh: %1. Draw it nearer to the outline that it is to replace, of one limb "
      "alone, or, if that is meant, {AllowTorn on}.",
      torn);
  }
  this->Effect = effect;
  StrokeEffect told = effect;
  told.missed = this->Missed(effect);
  std::vector<Message> said = remarks(told);
  if (!torn.empty() && std::find(said.begin(), said.end(), torn) == said.end())
  {
    said.insert(said.begin(), torn);
  }
  const double wanted = std::max(this->Stretch->GetTrianglesWanted(), this->Restore->GetTrianglesWanted());
  if (this->Self->Remeshed && wanted > 0.0)
  {
    said.emplace_back(
      "new triangles are larger than those round them, as %1 would have been needed", std::llround(wanted));
  }
  if (!said.empty())
  {
    this->Remark = { "The result is not as drawn: %1.", said };
  }
}

void vtkOversketchOneStroke::Pipeline::RunRemeshed()
{
  releaseLargeFactor(this->Deform);
  releaseLargeFactor(this->DeformCorrected);
  this->Self->RunStage("Stretch");
  this->RunDeformation("DeformRemeshed");
  const char* remeshed =
    this->Corrected("Stretch", "DeformRemeshed", "CorrectionRemeshed", "DeformRemeshedCorrected");
  releaseLargeFactor(this->DeformRemeshed);
  releaseLargeFactor(this->DeformRemeshedCorrected);
  this->Restore->SetInputConnection(0, this->Self->GetStep(remeshed)->GetOutputPort());
  this->Restore->TakeOutFoldsOff();
  this->Self->RunStage("Restore");
  if (!this->Self->AsPublished &&
      this->Folds("Restore") - this->Folds("RegionBorder") > Judgement::tolerableFolds)
  {
    this->Restore->TakeOutFoldsOn();
    this->MadeMeshes.erase("Restore");
    this->Self->RunStage("Restore");
  }
  this->Self->Remeshed = this->Self->Remesh == RemeshOn || this->RemeshingKept();
  if (this->Self->Remeshed)
  {
    this->Deformation = remeshed;
  }
}

void vtkOversketchOneStroke::Pipeline::PutOutput(vtkPolyData* mesh, vtkPolyData* output)
{
  vtkPolyData* deformed = this->Self->StageOutput(this->Deformation);
  if (this->Self->Remeshed)
  {
    vtkPolyData* restored = this->Self->StageOutput("Restore");
    this->Following = std::make_unique<Followers>(output,
      this->Welding->Transfer(mesh, { this->Self->StageOutput("Stretch"), restored }, output),
      deformed,
      restored);
    DropHierarchy(output);
  }
  else
  {
    this->Welding->Move(mesh, deformed, output);
    this->Following = std::make_unique<Followers>(output, *this->Welding, deformed);
  }
}
