#include "vtkOversketchOneStroke.h"

#include "vtkOversketchOneStrokePipeline.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstring>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchOneStroke);

vtkOversketchOneStroke::vtkOversketchOneStroke()
  : Inner(new Pipeline(this))
{
  this->SetNumberOfInputPorts(2);
}

vtkOversketchOneStroke::~vtkOversketchOneStroke() = default;

int vtkOversketchOneStroke::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  Pipeline& inner = *this->Inner;
  inner.Following.reset();
  inner.Hold->Initialize();
  inner.Effect = StrokeEffect();
  inner.Remark = {};
  this->Remeshed = false;
  const int done = this->RunOnMesh(inputs,
    outputs,
    [&](vtkPolyData* mesh, vtkPolyData* output)
    {
      inner.MixtureRegion->SetReach(this->Reach);
      vtkPolyData* stroke = vtkPolyData::GetData(inputs[1]);
      if (stroke->GetNumberOfLines() > 1)
      {
        throw Error(Failure::BadStroke,
          "The stroke input holds %1 polylines, and one deforms the mesh: give them one after the other.",
          stroke->GetNumberOfLines());
      }
      inner.FeedStroke(stroke);
      inner.FeedMesh(mesh);
      this->RunStage("Stroke");
      inner.RunCurves();
      inner.RunBest();
      inner.PutOutput(mesh, output);
    });
  this->SetRemark(done ? inner.Remark : Message());
  inner.MadeMeshes.clear();
  return done;
}

bool vtkOversketchOneStroke::Prepare()
{
  return this->TryPrepare(
    [this](vtkPolyData* mesh)
    {
      this->Inner->FeedMesh(mesh);
      this->RunStage("ShapeDiameter");
      this->RunStage("MixtureRegion", [this] { this->Inner->MixtureRegion->Prepare(); });
    });
}

bool vtkOversketchOneStroke::Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold)
{
  return this->TryPreview(mesh,
    stroke,
    hold,
    [&]
    {
      this->Inner->Match->SetCandidate(this->Candidate);
      this->Inner->FeedStroke(stroke);
      this->Inner->FeedMesh(mesh);
      this->Inner->RunCurves();
      if (stroke->GetNumberOfPoints() < 2)
      {
        return false;
      }
      this->RunStage("Stroke");
      this->RunStage("Match");
      hold->ShallowCopy(this->StageOutput("Match"));
      return hold->GetNumberOfPoints() > 0;
    });
}

void vtkOversketchOneStroke::GetHold(vtkPolyData* hold)
{
  hold->Initialize();
  if (this->Inner->Following)
  {
    hold->ShallowCopy(this->Inner->Hold);
  }
}

bool vtkOversketchOneStroke::Drag(const double translation[3], vtkPoints* points)
{
  if (!this->Inner->Following)
  {
    vtkErrorMacro("There is nothing to drag yet: Update() first.");
    return false;
  }
  if (!points || !this->Inner->Following->Fits(points))
  {
    vtkErrorMacro("The points to drag do not fit; give a copy of the output's points, float or double.");
    return false;
  }
  auto* step = vtkOversketchLaplacianDeform::SafeDownCast(this->GetStep(this->Inner->Deformation));
  return this->Inner->Following->Place(
    [step](const double by[3], vtkPoints* places) { return step->Drag(by, places); }, translation, points);
}

void vtkOversketchOneStroke::GetRegion(vtkPolyData* region)
{
  region->Initialize();
  if (this->Inner->Following)
  {
    vtkPolyData* mesh = this->StageOutput(this->Remeshed ? "Restore" : this->Inner->Deformation);
    PutTriangles(mesh, LabelsOf(mesh->GetPointData()->GetArray("Region")), 3, region);
  }
}

void vtkOversketchOneStroke::ReleaseWork()
{
  Pipeline& inner = *this->Inner;
  inner.Following.reset();
  for (vtkOversketchLaplacianDeform* step : { inner.Deform.Get(),
         inner.DeformCorrected.Get(),
         inner.DeformRemeshed.Get(),
         inner.DeformRemeshedCorrected.Get() })
  {
    step->ReleaseWork();
  }
  inner.Stretch->ReleaseWork();
  inner.Restore->ReleaseWork();
  this->Modified();
}

void vtkOversketchOneStroke::BackendChanged()
{
  this->Inner->ShapeDiameter->SetBackend(this->GetBackend());
  this->Inner->MixtureRegion->SetBackend(this->GetBackend());
  this->Inner->Visibility->SetBackend(this->GetBackend());
}

int vtkOversketchOneStroke::GetBackendUsed()
{
  return this->Inner->ShapeDiameter->GetBackendUsed();
}

void vtkOversketchOneStroke::SetAdjustNormals(bool adjust)
{
  for (vtkOversketchLaplacianDeform* step : { this->Inner->Deform.Get(),
         this->Inner->DeformCorrected.Get(),
         this->Inner->DeformRemeshed.Get(),
         this->Inner->DeformRemeshedCorrected.Get() })
  {
    step->SetAdjustNormals(adjust);
  }
}

bool vtkOversketchOneStroke::GetAdjustNormals() const
{
  return this->Inner->Deform->GetAdjustNormals();
}

void vtkOversketchOneStroke::SetAsPublished(bool published)
{
  if (published != this->AsPublished)
  {
    this->AsPublished = published;
    this->CorrectOutline = !published;
    this->Inner->SetAmendments(!published);
    this->Modified();
  }
}

int vtkOversketchOneStroke::GetNumberOfCandidates() const
{
  return this->Inner->Match->GetNumberOfCandidates();
}

vtkOversketchSystem::FigureList vtkOversketchOneStroke::Figures()
{
  Pipeline& inner = *this->Inner;
  if (!inner.Following)
  {
    return {};
  }
  const std::vector<char> region = inner.RegionOf("RegionBorder");
  const auto data = SharedMesh(this->StageOutput("RegionBorder"));
  const oversketch::Mesh& mesh = data->Surface();
  double inside = 0.0, all = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    const Vector3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    all += area;
    inside += region[t[0]] && region[t[1]] && region[t[2]] ? area : 0.0;
  }
  auto* deform = vtkOversketchLaplacianDeform::SafeDownCast(this->GetStep(inner.Deformation));
  const StrokeEffect& effect = inner.Effect;
  return { { "remeshed", this->Remeshed },
    { "match.points", this->StageOutput("Match")->GetNumberOfPoints() },
    { "targets.handles", this->StageOutput("Targets")->GetNumberOfPoints() },
    { "region.vertices", std::count_if(region.begin(), region.end(), [](char in) { return in != 0; }) },
    { "region.of_vertices", mesh.vertexCount() },
    { "region.area_share", inside / all },
    { "effect.outline_px", effect.outline.mean },
    { "effect.worst_outline_px", effect.outline.worst },
    { "effect.outline_back_px", effect.outlineBack },
    { "effect.new_folds", effect.folds },
    { "effect.inside_out", effect.back },
    { "effect.new_crossings", effect.crossings },
    { "effect.stretch", effect.stretch },
    { "effect.roughness_before", effect.before.meanAngle },
    { "effect.roughness", effect.after.meanAngle },
    { "effect.moved_share", effect.movedShare },
    { "effect.stray_distance_px", effect.strayDistance },
    { "effect.stray_movement_px", effect.strayMovement },
    { "deformation.movable_vertices", deform->GetMovableCount() },
    { "deformation.active_handles", deform->GetActiveHandleCount() },
    { "deformation.mean_handle_residual", deform->GetMeanHandleResidual() },
    { "deformation.maximum_handle_residual", deform->GetMaximumHandleResidual() } };
}

vtkPolyData* vtkOversketchOneStroke::GetInnerOutput(const char* name)
{
  return this->StageOutput(name && std::strcmp(name, "Deform") == 0 ? this->Inner->Deformation : name);
}

const char* vtkOversketchOneStroke::GetDeformationName() const
{
  return this->Inner->Deformation;
}

void vtkOversketchOneStroke::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Remesh: " << this->Remesh << "\n";
  os << indent << "AdjustNormals: " << this->GetAdjustNormals() << "\n";
  os << indent << "CorrectOutline: " << this->CorrectOutline << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "Candidate: " << this->Candidate << "\n";
  os << indent << "Reach: " << this->Reach << "\n";
  os << indent << "AllowTorn: " << this->AllowTorn << "\n";
  os << indent << "Remeshed: " << this->Remeshed << "\n";
}
