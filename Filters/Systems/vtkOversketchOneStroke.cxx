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

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchOneStroke);

vtkOversketchOneStroke::vtkOversketchOneStroke()
  : Inner(new Pipeline(this))
{
  this->SetNumberOfInputPorts(2);
}

vtkOversketchOneStroke::~vtkOversketchOneStroke() = default;

void vtkOversketchOneStroke::SetStrokeData(vtkPolyData* stroke)
{
  this->SetInputData(1, stroke);
}

int vtkOversketchOneStroke::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  Pipeline& inner = *this->Inner;
  inner.Done = 0.0;
  inner.Running = nullptr;
  inner.Following.reset();
  this->Remeshed = false;
  for (Pipeline::Stage& stage : inner.Stages)
  {
    stage.seconds = 0.0;
  }
  return RunFilter(this,
    [&]
    {
      vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      if (mesh->GetNumberOfPoints() == 0)
      {
        return;
      }
      inner.FeedStroke(vtkPolyData::GetData(inputs[1]));
      inner.FeedMesh(mesh);
      inner.Run("Stroke");
      inner.RunCurves();
      for (const char* name : { "Match", "Targets", "ShapeDiameter", "MixtureRegion", "RegionBorder" })
      {
        inner.Run(name);
      }
      if (this->Remesh != RemeshOn)
      {
        inner.Run("Deform");
        inner.Deformation = inner.Corrected("Deform", "Correction", "DeformCorrected");
      }
      const bool automatic = this->Remesh == RemeshAuto && !this->AsPublished;
      if (this->Remesh == RemeshOn || (automatic && inner.WantsRemeshing()))
      {
        inner.Run("Stretch");
        inner.Run("DeformRemeshed");
        const char* remeshed =
          inner.Corrected("DeformRemeshed", "CorrectionRemeshed", "DeformRemeshedCorrected");
        inner.Restore->SetInputConnection(0, inner.Find(remeshed)->step->GetOutputPort());
        inner.Run("Restore");
        this->Remeshed = this->Remesh == RemeshOn || inner.RemeshingKept();
        if (this->Remeshed)
        {
          inner.Deformation = remeshed;
        }
      }
      if (this->Remeshed)
      {
        inner.Following = std::make_unique<Followers>(output,
          inner.Welding->Transfer(mesh, { inner.Output("Stretch"), inner.Output("Restore") }, output),
          inner.Output(inner.Deformation),
          inner.Output("Restore"));
      }
      else
      {
        inner.Welding->Move(mesh, inner.Output(inner.Deformation), output);
        inner.Following =
          std::make_unique<Followers>(output, *inner.Welding, inner.Output(inner.Deformation));
      }
    });
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
  this->SetAbortExecute(0);
  try
  {
    this->Inner->Done = 0.0;
    this->Inner->FeedMesh(mesh);
    this->Inner->Run("ShapeDiameter");
    return true;
  }
  catch (const std::exception&)
  {
    return false;
  }
}

bool vtkOversketchOneStroke::MatchSection(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* section)
{
  Pipeline& inner = *this->Inner;
  section->Initialize();
  if (!mesh || !stroke || mesh->GetNumberOfPoints() == 0)
  {
    return false;
  }
  this->SetAbortExecute(0);
  try
  {
    inner.Done = 0.0;
    inner.FeedStroke(stroke);
    inner.FeedMesh(mesh);
    inner.RunCurves();
    if (stroke->GetNumberOfPoints() < 2)
    {
      return false;
    }
    inner.Run("Stroke");
    inner.Run("Match");
    section->ShallowCopy(inner.Output("Match"));
    return section->GetNumberOfPoints() > 0;
  }
  catch (const std::exception&)
  {
    return false;
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
  vtkPolyData* mesh = this->Inner->Output(this->Remeshed ? "Restore" : this->Inner->Deformation);
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

void vtkOversketchOneStroke::SetBackend(int backend)
{
  backend = std::clamp<int>(backend, Auto, Host);
  if (backend != this->Backend)
  {
    this->Backend = backend;
    this->Inner->ShapeDiameter->SetBackend(backend);
    this->Inner->MixtureRegion->SetBackend(backend);
    this->Inner->Visibility->SetBackend(backend);
    this->Modified();
  }
}

int vtkOversketchOneStroke::GetBackendUsed() const
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

int vtkOversketchOneStroke::GetNumberOfInnerOutputs() const
{
  // The last four stages repeat others, and Deform stands for all four deformations.
  return static_cast<int>(this->Inner->Stages.size()) - 4;
}

const char* vtkOversketchOneStroke::GetInnerOutputName(int index) const
{
  if (index < 0 || index >= this->GetNumberOfInnerOutputs())
  {
    return nullptr;
  }
  return this->Inner->Stages[static_cast<std::size_t>(index)].name;
}

vtkPolyData* vtkOversketchOneStroke::GetInnerOutput(const char* name)
{
  if (name && std::strcmp(name, "Deform") == 0)
  {
    name = this->Inner->Deformation;
  }
  vtkAlgorithm* step = this->GetStep(name);
  return step ? vtkPolyData::SafeDownCast(step->GetOutputDataObject(0)) : nullptr;
}

vtkAlgorithm* vtkOversketchOneStroke::GetStep(const char* name)
{
  const Pipeline::Stage* stage = this->Inner->Find(name);
  return stage ? stage->step : nullptr;
}

const char* vtkOversketchOneStroke::GetDeformationName() const
{
  return this->Inner->Deformation;
}

double vtkOversketchOneStroke::GetStageTime(const char* name) const
{
  const Pipeline::Stage* stage = this->Inner->Find(name);
  return stage ? stage->seconds : 0.0;
}

const char* vtkOversketchOneStroke::GetStageName() const
{
  return this->Inner->Running ? this->Inner->Running->name : "";
}

vtkMTimeType vtkOversketchOneStroke::GetMTime()
{
  vtkMTimeType latest = this->Superclass::GetMTime();
  for (const Pipeline::Stage& stage : this->Inner->Stages)
  {
    latest = std::max(latest, stage.step->GetMTime());
  }
  return latest;
}

void vtkOversketchOneStroke::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Backend: " << this->Backend << "\n";
  os << indent << "BackendUsed: " << this->GetBackendUsed() << "\n";
  os << indent << "Remesh: " << this->Remesh << "\n";
  os << indent << "AdjustNormals: " << this->GetAdjustNormals() << "\n";
  os << indent << "CorrectOutline: " << this->CorrectOutline << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "Remeshed: " << this->Remeshed << "\n";
}
