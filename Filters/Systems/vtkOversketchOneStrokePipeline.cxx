#include "vtkOversketchOneStrokePipeline.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <chrono>
#include <cstring>

using namespace oversketch;

namespace
{

// Of a larger one vtkOversketchOutline may see a part only: that round the first stroke in the view [px].
constexpr int widestViewport = 4092;

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
  this->Targets->SetInputConnection(1, this->StrokeStep->GetOutputPort());
  this->Targets->SetInputData(2, this->Mesh);
  this->ShapeDiameter->SetInputData(0, this->Mesh);
  this->MixtureRegion->SetInputConnection(0, this->ShapeDiameter->GetOutputPort());
  this->MixtureRegion->SetInputConnection(1, this->Targets->GetOutputPort());
  this->RegionBorder->SetInputConnection(0, this->MixtureRegion->GetOutputPort());
  this->Deform->SetInputConnection(0, this->RegionBorder->GetOutputPort());
  this->Deform->SetInputConnection(1, this->Targets->GetOutputPort());
  this->Stretch->SetStageToStretch();
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
    step->SetInputConnection(1, this->StrokeStep->GetOutputPort());
  }

  this->Stages = { { "Stroke", this->StrokeStep, 0.01 },
    { "Silhouette", this->Silhouette, 0.02 },
    { "Snake", this->Snake, 0.03 },
    { "Visibility", this->Visibility, 0.04 },
    { "Outline", this->Outline, 0.04 },
    { "Match", this->Match, 0.01 },
    { "Targets", this->Targets, 0.01 },
    { "ShapeDiameter", this->ShapeDiameter, 0.30 },
    { "MixtureRegion", this->MixtureRegion, 0.06 },
    { "RegionBorder", this->RegionBorder, 0.01 },
    { "Deform", this->Deform, 0.08 },
    { "Correction", this->Correction, 0.02 },
    { "Stretch", this->Stretch, 0.12 },
    { "Restore", this->Restore, 0.12 },
    { "DeformCorrected", this->DeformCorrected, 0.06 },
    { "DeformRemeshed", this->DeformRemeshed, 0.06 },
    { "CorrectionRemeshed", this->CorrectionRemeshed, 0.02 },
    { "DeformRemeshedCorrected", this->DeformRemeshedCorrected, 0.06 } };

  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject* caller, unsigned long event, void* client, void* data)
    {
      auto* pipeline = static_cast<Pipeline*>(client);
      vtkOversketchOneStroke* system = pipeline->Self;
      auto* step = vtkAlgorithm::SafeDownCast(caller);
      if (event == vtkCommand::ErrorEvent)
      {
        // The executive of a failed step adds an error of its own, after the step's.
        if (pipeline->FirstError.empty())
        {
          pipeline->FirstError = MessageOf(data);
        }
      }
      else if (event == vtkCommand::WarningEvent)
      {
        vtkWarningWithObjectMacro(system, << MessageOf(data));
      }
      else if (event == vtkCommand::ProgressEvent && step && pipeline->Running)
      {
        system->UpdateProgress(pipeline->Done + step->GetProgress() * pipeline->Running->share);
        if (system->GetAbortExecute())
        {
          step->SetAbortExecute(1);
        }
      }
    });
  for (Stage& stage : this->Stages)
  {
    for (const unsigned long event :
      { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
    {
      stage.step->AddObserver(event, this->Observer);
    }
    stage.step->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  }
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
  this->Match->SetAmendedScore(on);
  this->Targets->SetSingleLayer(on);
  this->MixtureRegion->SetSeedMargin(on ? 0.1 : 0.0);
  this->MixtureRegion->SetFillIslands(on);
  this->MixtureRegion->SetLimitRunaway(on);
  this->MixtureRegion->SetCutAtJunction(on);
  this->MixtureRegion->SetReachEnds(on);
  this->RegionBorder->SetConfine(on);
  for (vtkOversketchRemesh* step : { this->Stretch.Get(), this->Restore.Get() })
  {
    step->SetLimitByDiameter(on);
    step->SetProtectSection(on);
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

vtkOversketchOneStroke::Pipeline::Stage* vtkOversketchOneStroke::Pipeline::Find(const char* name)
{
  for (Stage& stage : this->Stages)
  {
    if (name && std::strcmp(stage.name, name) == 0)
    {
      return &stage;
    }
  }
  return nullptr;
}

void vtkOversketchOneStroke::Pipeline::Run(const char* name)
{
  if (this->Self->GetAbortExecute())
  {
    throw Error(Failure::Cancelled, "cancelled");
  }
  Stage& stage = *this->Find(name);
  this->FirstError.clear();
  this->Running = &stage;
  stage.step->SetAbortExecute(0); // set after its work was done, it would stop the next run
  const auto start = std::chrono::steady_clock::now();
  stage.step->Update();
  stage.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  this->Running = nullptr;
  this->Done += stage.share;
  if (this->Self->GetAbortExecute())
  {
    // The step may have stopped half-way; make it run again next time.
    stage.step->Modified();
    throw Error(Failure::Cancelled, "cancelled");
  }
  if (!this->FirstError.empty())
  {
    const auto code =
      static_cast<long>(stage.step->GetErrorCode()) - static_cast<long>(vtkErrorCode::UserError);
    stage.step->Modified();
    throw Error(code > 0 ? static_cast<Failure>(code) : Failure::InnerStep, this->FirstError);
  }
}

void vtkOversketchOneStroke::Pipeline::RunCurves()
{
  for (const char* name : { "Silhouette", "Snake", "Visibility" })
  {
    this->Run(name);
  }
  if (this->Match->GetNumberOfInputConnections(0) > 1)
  {
    this->Run("Outline");
  }
}

bool vtkOversketchOneStroke::Pipeline::WantsRemeshing()
{
  vtkPolyData* before = this->Output("RegionBorder");
  return wantsRemeshing(MeshOf(before), MeshOf(this->Output(this->Deformation)), RegionOf(before));
}

const char* vtkOversketchOneStroke::Pipeline::Corrected(const char* deform,
  const char* correction,
  const char* again)
{
  if (!this->Self->CorrectOutline)
  {
    return deform;
  }
  this->Run(correction);
  vtkAlgorithm* step = this->Find(correction)->step;
  const auto handlesAdded = this->Output(correction)->GetNumberOfPoints() -
                            vtkPolyData::SafeDownCast(step->GetInputDataObject(0, 0))->GetNumberOfPoints();
  auto* before = vtkPolyData::SafeDownCast(step->GetInputDataObject(3, 0));
  const int folds = foldedEdges(MeshOf(before), RegionOf(before));
  const Judgement plain = this->Judged(deform, folds);
  auto* other = vtkOversketchLaplacianDeform::SafeDownCast(this->Find(again)->step);
  const double weight =
    vtkOversketchLaplacianDeform::SafeDownCast(this->Find(deform)->step)->GetHandleWeight();
  Judgement judged = plain;
  if (handlesAdded > 0)
  {
    other->SetHandleWeight(weight);
    this->Run(again);
    judged = this->Judged(again, folds);
  }
  if (judged.folds > Judgement::tolerableFolds)
  {
    // Handles that pull less fold less, and still reach the stroke within a fraction of a pixel.
    other->SetHandleWeight(0.2 * weight);
    this->Run(again);
    judged = this->Judged(again, folds);
  }
  return judged.betterThan(plain) ? again : deform;
}

Judgement vtkOversketchOneStroke::Pipeline::Judged(const char* stage, int foldsBefore)
{
  const oversketch::Mesh mesh = MeshOf(this->Output(stage));
  return { outlineError(mesh,
             ViewOf(this->Stroke),
             StrokeOf(this->Output("Stroke")),
             ContextOf(this->Self, this->Done, this->Done)),
    foldedEdges(mesh, RegionOf(this->Output(stage))) - foldsBefore };
}

bool vtkOversketchOneStroke::Pipeline::RemeshingKept()
{
  vtkPolyData* before = this->Output("RegionBorder");
  const int folds = foldedEdges(MeshOf(before), RegionOf(before));
  return this->Judged("Restore", folds).keptAgainst(this->Judged(this->Deformation, folds));
}
