#include "vtkOversketchOneStroke.h"

#include "vtkOversketchOneStrokePipeline.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstring>
#include <string>

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
  const int done = this->RunSystem(
    [&]
    {
      vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      if (mesh->GetNumberOfPoints() == 0)
      {
        return;
      }
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
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return false;
  }
  vtkAlgorithmOutput* source = this->GetInputConnection(0, 0);
  source->GetProducer()->Update(source->GetIndex());
  auto* mesh = vtkPolyData::SafeDownCast(this->GetInputDataObject(0, 0));
  if (!mesh || mesh->GetNumberOfPoints() == 0)
  {
    return false;
  }
  return this->Try(
    [&]
    {
      this->Inner->FeedMesh(mesh);
      this->RunStage("ShapeDiameter");
      return true;
    });
}

bool vtkOversketchOneStroke::Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold)
{
  hold->Initialize();
  if (!mesh || !stroke || mesh->GetNumberOfPoints() == 0)
  {
    return false;
  }
  return this->Try(
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
  if (!this->Inner->Following)
  {
    return;
  }
  vtkPolyData* mesh = this->StageOutput(this->Remeshed ? "Restore" : this->Inner->Deformation);
  const std::vector<char> inside = LabelsOf(mesh->GetPointData()->GetArray("Region"));
  std::vector<vtkIdType> number(inside.size(), -1);
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    if (!inside[ids->GetId(0)] || !inside[ids->GetId(1)] || !inside[ids->GetId(2)])
    {
      continue;
    }
    triangles->InsertNextCell(3);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      vtkIdType& id = number[ids->GetId(k)];
      id = id >= 0 ? id : points->InsertNextPoint(mesh->GetPoint(ids->GetId(k)));
      triangles->InsertCellPoint(id);
    }
  }
  region->SetPoints(points);
  region->SetPolys(triangles);
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

double vtkOversketchOneStroke::GetOutlineDistance() const
{
  return this->Inner->Effect.outline.mean;
}

double vtkOversketchOneStroke::GetWorstOutlineDistance() const
{
  return this->Inner->Effect.outline.worst;
}

double vtkOversketchOneStroke::GetOutlineBackDistance() const
{
  return this->Inner->Effect.outlineBack;
}

int vtkOversketchOneStroke::GetNewFolds() const
{
  return this->Inner->Effect.folds;
}

double vtkOversketchOneStroke::GetInsideOut() const
{
  return this->Inner->Effect.back;
}

int vtkOversketchOneStroke::GetNewCrossings() const
{
  return this->Inner->Effect.crossings;
}

double vtkOversketchOneStroke::GetStretch() const
{
  return this->Inner->Effect.stretch;
}

double vtkOversketchOneStroke::GetRoughnessBefore() const
{
  return this->Inner->Effect.before.meanAngle;
}

double vtkOversketchOneStroke::GetRoughness() const
{
  return this->Inner->Effect.after.meanAngle;
}

double vtkOversketchOneStroke::GetMovedShare() const
{
  return this->Inner->Effect.movedShare;
}

double vtkOversketchOneStroke::GetStrayDistance() const
{
  return this->Inner->Effect.strayDistance;
}

double vtkOversketchOneStroke::GetStrayMovement() const
{
  return this->Inner->Effect.strayMovement;
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
