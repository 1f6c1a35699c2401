#include "vtkOversketchOneStrokePipeline.h"

#include "vtkOversketchHierarchy.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

using namespace oversketch;

namespace
{

// Of a larger one vtkOversketchOutline may see a part only: that round the first stroke in the view [px].
constexpr int widestViewport = 4092;

// A stroke without any outline so near was drawn in the void [px].
constexpr double farthestOutline = 60.0;

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

// One byte per point of a mesh that a step made.
std::vector<char> RegionOf(vtkPolyData* mesh)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  return LabelsOf(RequireArray(mesh->GetPointData(), "Region", 1, count, "mesh", "a step made it"));
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
  stage("ShapeDiameter", this->ShapeDiameter, 0.30);
  stage("MixtureRegion", this->MixtureRegion, 0.06);
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
  if (this->Welding && key() == this->MeshKeySeen)
  {
    return;
  }
  this->Welding = std::make_unique<oversketch::Weld>(mesh);
  this->MeshKeySeen = key();
  this->Mesh->ShallowCopy(this->Welding->Welded());
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
  return wantsRemeshing(this->Made("RegionBorder").Data->Surface(),
    this->Made(this->Deformation).Data->Surface(),
    RegionOf(this->Self->StageOutput("RegionBorder")));
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

vtkOversketchOneStroke::Pipeline::MadeMesh& vtkOversketchOneStroke::Pipeline::Made(const char* stage)
{
  MadeMesh& made = this->MadeMeshes[stage];
  if (!made.Data)
  {
    made.Data = SharedMesh(this->Self->StageOutput(stage));
  }
  return made;
}

void vtkOversketchOneStroke::Pipeline::JudgeSurface(MadeMesh& made, const char* stage)
{
  if (made.Folds)
  {
    return;
  }
  const std::vector<char> region = RegionOf(this->Self->StageOutput(stage));
  const auto judge =
    [&made](const oversketch::Mesh& mesh, const Adjacency& adjacency, const std::vector<char>& inside)
  {
    // Side by side: most of either is a walk over the mesh that is not threaded.
    const auto one = [&](int which)
    {
      if (which == 0)
      {
        made.Folds = foldedEdges(mesh, adjacency, inside, ThreadsOnly());
      }
      else
      {
        made.Rough = roughness(mesh, adjacency, inside, ThreadsOnly());
      }
    };
    ThreadsOnly().parallelFor(2,
      [&one](int begin, int end)
      {
        for (int which = begin; which < end; ++which)
        {
          one(which);
        }
      });
  };
  if (this->Self->GetStep(stage) == this->Restore)
  {
    // No other step asks for the links of this mesh.
    const JudgedPart part(made.Data->Surface(), region, ThreadsOnly());
    judge(part.mesh, part.adjacency, part.region);
  }
  else
  {
    judge(made.Data->Surface(), made.Data->Neighbours(), region);
  }
}

int vtkOversketchOneStroke::Pipeline::Folds(const char* stage)
{
  MadeMesh& made = this->Made(stage);
  this->JudgeSurface(made, stage);
  return *made.Folds;
}

const Roughness& vtkOversketchOneStroke::Pipeline::Rough(const char* stage)
{
  MadeMesh& made = this->Made(stage);
  this->JudgeSurface(made, stage);
  return *made.Rough;
}

const std::vector<OutlineLoop>& vtkOversketchOneStroke::Pipeline::Contours(const char* stage)
{
  MadeMesh& made = this->Made(stage);
  vtkDataArray* connection = this->Match->GetOutput()->GetFieldData()->GetArray("Candidate");
  if (!made.Contours && connection && connection->GetComponent(0, 0) == 0.0)
  {
    made.Contours = regionContours(made.Data->Surface(),
      made.Data->Neighbours(),
      made.Data->Normals(),
      RegionOf(this->Self->StageOutput(stage)),
      ViewOf(this->Stroke));
  }
  else if (!made.Contours)
  {
    made.Contours.emplace(); // the section is of the outline
  }
  return *made.Contours;
}

const StrokeOutline& vtkOversketchOneStroke::Pipeline::OutlineOf(const char* stage)
{
  MadeMesh& made = this->Made(stage);
  if (!made.Outline)
  {
    made.Outline.emplace(made.Data->Surface(),
      ViewOf(this->Stroke),
      StrokeOf(this->Match->GetOutput(1)),
      ContextOf(this->Self, this->Self->GetDone(), this->Self->GetDone()));
  }
  return *made.Outline;
}

Judgement vtkOversketchOneStroke::Pipeline::Judged(const char* stage, int foldsBefore)
{
  MadeMesh& made = this->Made(stage);
  if (!made.OutlineMissed)
  {
    made.OutlineMissed = outlineError(this->OutlineOf(stage), this->Contours(stage));
  }
  return { *made.OutlineMissed, this->Folds(stage) - foldsBefore, this->Rough(stage) };
}

bool vtkOversketchOneStroke::Pipeline::RemeshingKept()
{
  const int folds = this->Folds("RegionBorder");
  return this->Judged("Restore", folds).keptAgainst(this->Judged(this->Deformation, folds));
}

void vtkOversketchOneStroke::Pipeline::JudgeEffect()
{
  const char* const before = this->Self->Remeshed ? "Stretch" : "RegionBorder"; // of the deformation
  const char* const made = this->Self->Remeshed ? "Restore" : this->Deformation;
  const Judgement judged = this->Judged(made, this->Folds("RegionBorder"));
  StrokeEffect effect;
  effect.outline = judged.outline;
  effect.folds = judged.folds;
  effect.after = judged.roughness;
  effect.before = this->Rough("RegionBorder");
  const oversketch::View view = ViewOf(this->Stroke);
  const Polyline stroke = StrokeOf(this->Match->GetOutput(1));
  vtkPolyData* match = this->Self->StageOutput("Match");
  Polyline section(static_cast<std::size_t>(match->GetNumberOfPoints()));
  vtkDataArray* displays = match->GetPointData()->GetArray("Display");
  for (std::size_t i = 0; displays && i < section.size(); ++i)
  {
    displays->GetTuple(static_cast<vtkIdType>(i), section[i].data());
  }
  effect.outlineBack = outlineBack(this->OutlineOf(made), this->Contours(made));
  measureMovement(this->Made(before).Data->Surface(),
    this->Made(this->Deformation).Data->Surface(),
    RegionOf(this->Self->StageOutput(before)),
    view,
    stroke,
    section,
    effect,
    ThreadsOnly());
  const std::string torn = tornBy(effect);
  if (!torn.empty() && !this->Self->AllowTorn && !this->Self->AsPublished)
  {
    throw Error(Failure::Torn,
      "The stroke would tear the mesh: " + torn +
        ". Draw it nearer to the outline that it is to replace, or, if that is meant, turn AllowTorn on.");
  }
  this->Effect = effect;
  std::vector<std::string> said = remarks(effect);
  if (!torn.empty())
  {
    said.insert(said.begin(), torn);
  }
  for (const std::string& one : said)
  {
    this->Remark += (this->Remark.empty() ? "" : "; ") + one;
  }
  if (!this->Remark.empty())
  {
    this->Remark = "The result is not as drawn: " + this->Remark + ".";
  }
}

void vtkOversketchOneStroke::Pipeline::RunRemeshed()
{
  releaseLargeFactor(this->Deform);
  releaseLargeFactor(this->DeformCorrected);
  this->Self->RunStage("Stretch");
  this->Self->RunStage("DeformRemeshed");
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
