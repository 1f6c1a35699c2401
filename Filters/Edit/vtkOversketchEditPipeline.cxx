#include "vtkOversketchEditPipeline.h"

#include "Shading/layer_list.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchEditCurves.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchSources.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

using namespace oversketch;

vtkOversketchEdit::Pipeline::Pipeline(vtkOversketchEdit* self)
  : Self(self)
{
  this->MeanEdge->SetInputData(0, this->Start);
  for (Drawn* drawn : { &this->Reference, &this->Boundary })
  {
    drawn->Fit->SetInputData(0, drawn->Input);
    for (vtkOversketchProjectCurve* project : { drawn->Place.Get(), drawn->Project.Get() })
    {
      project->SetInputConnection(0, drawn->Fit->GetOutputPort());
    }
    drawn->Place->SetMeshConnection(this->MeanEdge->GetOutputPort());
  }
  this->Refine->SetInputConnection(0, this->MeanEdge->GetOutputPort());
  this->Reference.Name = "Reference";
  this->Reference.Project->SetMeshData(this->Ground);
  this->Reference.Insert->SetInputData(0, this->Ground);
  this->Boundary.Name = "Boundary";
  this->Boundary.Fit->ClosedOn();
  this->Boundary.Project->SetMeshData(this->Reference.Made.Mesh);
  this->Boundary.Insert->SetInputData(0, this->Reference.Made.Mesh);
  this->Boundary.Insert->SetStoredData(this->Reference.Made.Curve);
  this->Resketch->SetStrokeConnection(this->Refit->GetOutputPort());

  vtkPolyData* boundary = this->Boundary.Made.Curve;
  vtkPolyData* reference = this->Boundary.Made.Stored;
  this->Enclose->SetInputData(0, this->Boundary.Made.Mesh);
  this->Enclose->SetReferenceData(reference);
  this->Enclose->SetBoundaryData(boundary);
  this->Flatten->SetInputConnection(0, this->Enclose->GetOutputPort());
  this->Flatten->SetReferenceData(reference);
  this->Distance->SetInputConnection(0, this->Flatten->GetOutputPort());
  this->Distance->SetReferenceData(reference);
  vtkAlgorithmOutput* region = this->Distance->GetOutputPort();
  this->Areas->SetInputData(0, this->AreasInput);
  this->Shading->SetInputConnection(0, region);
  this->Shading->SetDiscConnection(this->Flatten->GetOutputPort(1));
  this->Texture->SetInputConnection(0, region);
  this->Texture->SetImageData(this->ImageInput);
  this->Handles->SetInputConnection(0, region);
  this->Handles->SetReferenceData(reference);
  this->Deform->SetInputData(0, this->Weighted);
  this->Deform->SetHandlesConnection(this->Handles->GetOutputPort());
  this->Planes->SetInputConnection(0, region);
  this->Planes->SetReferenceData(reference);
  this->Section->SetInputConnection(0, region);
  this->Section->SetBoundaryData(boundary);
  this->Section->SetPlanesConnection(this->Planes->GetOutputPort());
  this->Bend->SetInputData(0, this->Weighted);
  this->Bend->SetReferenceData(reference);
  this->Bend->SetProfileConnection(this->Section->GetOutputPort());
  this->Bend->SetDrawnData(this->DrawnProfile);
  this->Retriangulate->SetInputData(0, this->Bare);
  this->Retriangulate->SetReferenceData(reference);
  this->Retriangulate->SetBoundaryData(boundary);

  self->AddStage("MeanEdge", this->MeanEdge, 0.01);
  self->AddStage("ReferenceFit", this->Reference.Fit, 0.01);
  self->AddStage("ReferencePlace", this->Reference.Place, 0.01, Listed::No);
  self->AddStage("BoundaryPlace", this->Boundary.Place, 0.01, Listed::No);
  self->AddStage("Refine", this->Refine, 0.02);
  self->AddStage("ReferenceProject", this->Reference.Project, 0.06);
  self->AddStage("ReferenceInsert", this->Reference.Insert, 0.08);
  self->AddStage("BoundaryFit", this->Boundary.Fit, 0.01);
  self->AddStage("BoundaryProject", this->Boundary.Project, 0.06);
  self->AddStage("BoundaryInsert", this->Boundary.Insert, 0.08);
  self->AddStage("Refit", this->Refit, 0.0);
  self->AddStage("Resketch", this->Resketch, 0.0);
  self->AddStage("Reproject", this->Reproject, 0.0);
  self->AddStage("Reinsert", this->Reinsert, 0.0);
  self->AddStage("Enclose", this->Enclose, 0.03);
  self->AddStage("Flatten", this->Flatten, 0.20);
  self->AddStage("Distance", this->Distance, 0.10);
  self->AddStage("Areas", this->Areas, 0.01);
  self->AddStage("Shading", this->Shading, 0.05);
  self->AddStage("Texture", this->Texture, 0.01);
  self->AddStage("Handles", this->Handles, 0.01);
  self->AddStage("Deform", this->Deform, 0.02);
  self->AddStage("Planes", this->Planes, 0.01);
  self->AddStage("Section", this->Section, 0.01);
  self->AddStage("Redraw", this->Redraw, 0.01);
  self->AddStage("Bend", this->Bend, 0.02);
  self->AddStage("Retriangulate", this->Retriangulate, 0.17);
  this->SetAmendments(true);
}

void vtkOversketchEdit::Pipeline::SetAmendments(bool on)
{
  for (vtkOversketchNurbsFit* step :
    { this->Reference.Fit.Get(), this->Boundary.Fit.Get(), this->Refit.Get() })
  {
    step->SetFitSpace(on ? vtkOversketchNurbsFit::Picture : vtkOversketchNurbsFit::World);
  }
  // Control points cut a ring's corners by some px; a line they keep smooth, whose frames turn with it, and
  // these are near enough to each other for its bends.
  this->Boundary.Fit->SetInterpolate(on);
  this->Reference.Fit->SetSpacing(on ? 7.0 : 10.0);
  this->Refine->SetEdges(on ? 7.0 : 0.0); // six at least
  this->Boundary.Fit->SetPeriodic(on);
  this->Boundary.Fit->SetCutLoops(on);
  for (vtkOversketchProjectCurve* step :
    { this->Reference.Project.Get(), this->Boundary.Project.Get(), this->Reproject.Get() })
  {
    step->SetSpacing(on ? 0.0 : 4.0);
  }
  for (vtkOversketchInsertCurve* step :
    { this->Reference.Insert.Get(), this->Boundary.Insert.Get(), this->Reinsert.Get() })
  {
    step->SetSnap(on);
    step->SetBridge(on);
    step->SetJoinRuns(!on);
    step->SetClean(on);
  }
  this->Flatten->SetAsPublished(!on);
  this->Distance->SetAsPublished(!on);
  this->Shading->SetAsPublished(!on);
  this->Planes->SetFrame(on ? vtkOversketchProfilePlanes::Surface : vtkOversketchProfilePlanes::Fitted);
  this->Section->SetEnds(on ? vtkOversketchCrossSection::Nearest : vtkOversketchCrossSection::Outermost);
  this->Section->SetWalk(on ? vtkOversketchCrossSection::Across : vtkOversketchCrossSection::Centre);
  for (vtkOversketchResketch* step : { this->Resketch.Get(), this->Redraw.Get() })
  {
    step->SetMiddle(on ? vtkOversketchResketch::ArcLength : vtkOversketchResketch::Closest);
    step->SetRawTangents(!on);
  }
}

void vtkOversketchEdit::Pipeline::SetParameters()
{
  const vtkOversketchEdit* self = this->Self;
  this->Shading->SetLevels(self->Levels);
  this->Shading->SetLayers(self->GetLayers());
  this->Shading->SetFalloff(self->Falloff);
  this->Shading->SetFeather(self->Feather);
  this->Planes->SetT(self->ProfileAt);
  this->Bend->SetUseTexture(self->UseTexture);
  this->Retriangulate->SetRule(self->Rule == Curvature || self->AsPublished
                                 ? vtkOversketchRetriangulate::Curvature
                                 : vtkOversketchRetriangulate::Edit);
}

vtkOversketchEdit::Pipeline::Inputs vtkOversketchEdit::Pipeline::InputsOf(vtkInformationVector** inputs)
{
  return { vtkPolyData::GetData(inputs[0]),
    vtkPolyData::GetData(inputs[1]),
    vtkPolyData::GetData(inputs[2]),
    vtkPolyData::GetData(inputs[3]),
    vtkPolyData::GetData(inputs[4]),
    vtkImageData::GetData(inputs[5]),
    vtkPolyData::GetData(inputs[6]) };
}

bool vtkOversketchEdit::Pipeline::Outside(const std::function<bool(const Inputs& inputs)>& work)
{
  vtkDataObject* data[7] = {};
  for (int port = 0; port < 7; ++port)
  {
    data[port] = this->Self->UpdatedInput(port);
  }
  const auto lines = [&data](int port) { return vtkPolyData::SafeDownCast(data[port]); };
  const Inputs inputs{
    lines(0), lines(1), lines(2), lines(3), lines(4), vtkImageData::SafeDownCast(data[5]), lines(6)
  };
  return inputs.Mesh && inputs.Mesh->GetNumberOfPoints() > 0 && this->Self->Try([&] { return work(inputs); });
}

bool vtkOversketchEdit::Pipeline::Show(const std::string& operations, vtkPolyData* edited)
{
  return this->Outside(
    [&](const Inputs& inputs)
    {
      if (!inputs.Reference || !inputs.Boundary || !edited)
      {
        return false;
      }
      this->FeedMesh(inputs.Mesh);
      this->FeedEdit(inputs, operations);
      this->RunToWeights(inputs);
      this->RunDeform();
      this->PutPreview(edited);
      return true;
    });
}

void vtkOversketchEdit::Pipeline::Feed(vtkDataObject* from, vtkDataObject* to)
{
  const std::pair<const vtkDataObject*, vtkMTimeType> key{ from, from ? from->GetMTime() : 0 };
  const auto [known, isNew] = this->Seen.emplace(to, key);
  if (isNew || known->second != key)
  {
    to->Initialize();
    if (from)
    {
      to->ShallowCopy(from);
    }
    known->second = key;
  }
}

void vtkOversketchEdit::Pipeline::FeedMesh(vtkPolyData* mesh)
{
  const MeshKey key = WholeKey(mesh);
  if (this->Welding && key == this->MeshSeen)
  {
    return;
  }
  this->Welding = nullptr;
  this->Plain->ShallowCopy(mesh);
  DropHierarchy(this->Plain);
  this->Welding = std::make_unique<Weld>(this->Plain);
  this->Start->Initialize();
  this->Start->ShallowCopy(this->Welding->Welded());
  AddPlaces(this->Start);
  this->Welding->PutMask(mesh, this->Start);
  if (vtkDataArray* meanEdge = mesh->GetFieldData()->GetArray("MeanEdge"))
  {
    this->Start->GetFieldData()->AddArray(meanEdge);
  }
  this->MeshSeen = key;
}

void vtkOversketchEdit::Pipeline::FeedEdit(const Inputs& inputs, const std::string& operations)
{
  this->Feed(inputs.Profile, this->ProfileInput);
  this->Feed(inputs.Areas, this->AreasInput);
  this->Feed(inputs.Handles, this->HandlesInput);
  this->Feed(inputs.Weights, this->ImageInput);
  this->HasImage = inputs.Weights != nullptr;
  this->Handles->SetOperations(operations.c_str());
  this->Shading->SetAreasConnection(
    this->AreasInput->GetNumberOfPoints() > 0 ? this->Areas->GetOutputPort(1) : nullptr);
  this->Handles->SetHandlesData(
    this->HandlesInput->GetNumberOfPoints() > 0 ? this->HandlesInput.Get() : nullptr);
  this->Bend->SetHandlesConnection(
    this->HandlesInput->GetNumberOfPoints() > 0 ? this->Handles->GetOutputPort() : nullptr);
  if (this->HasProfile() && !operations.empty())
  {
    throw Error(Failure::BadStroke,
      "A profile and operations cannot be in one edit; make them in one after the other.");
  }
}

void vtkOversketchEdit::Pipeline::RunRegion()
{
  for (const char* name : { "Enclose", "Flatten", "Distance" })
  {
    this->Self->RunStage(name);
  }
}

void vtkOversketchEdit::Pipeline::RunWeights()
{
  if (!this->HasImage && this->AreasInput->GetNumberOfPoints() > 0)
  {
    this->RequireOwnView(this->AreasInput, "An area", "the disc");
    this->Self->RunStage("Areas");
  }
  this->Self->RunStage(this->WeightName());
}

vtkPolyData* vtkOversketchEdit::Pipeline::MaskedWeights()
{
  vtkPolyData* weights = this->Self->StageOutput(this->WeightName());
  const std::vector<double> mask = MaskOf(weights);
  if (mask.empty())
  {
    return weights;
  }
  const StepKey key({ WholeKey(weights) }, {});
  if (this->Masked->GetNumberOfPoints() == 0 || this->MaskedSeen != key)
  {
    std::vector<char> region = ReadEditRegion(weights);
    vtkDataArray* before = weights->GetPointData()->GetArray("EditWeight");
    std::vector<double> weight(mask.size());
    for (std::size_t v = 0; v < mask.size(); ++v)
    {
      weight[v] = (1.0 - mask[v]) * before->GetComponent(static_cast<vtkIdType>(v), 0);
      region[v] = mask[v] >= 1.0 && region[v] == EditLabel::Inside ? EditLabel::Rim : region[v];
    }
    if (std::find(region.begin(), region.end(), EditLabel::Inside) == region.end())
    {
      throw Error(Failure::BadRegion,
        "All that the ring encloses is masked, so nothing may move; free a part of it, or draw the ring "
        "wider.");
    }
    this->Masked->ShallowCopy(weights);
    this->Masked->GetPointData()->AddArray(ArrayOf<vtkUnsignedCharArray>("EditRegion", region));
    this->Masked->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("EditWeight", weight));
    this->MaskedSeen = key;
  }
  return this->Masked;
}

// Tells what turns with the surface: normals of the welded mesh, which has none of its own.
void vtkOversketchEdit::Pipeline::AddNormals()
{
  const StepKey ofMesh({ MeshKey(this->Boundary.Made.Mesh) }, {});
  if (!this->RestNormals || this->NormalsSeen != ofMesh)
  {
    const auto data = SharedMesh(this->Boundary.Made.Mesh);
    const auto normals = NewArray<vtkFloatArray>("Normals", 3, this->Boundary.Made.Mesh->GetNumberOfPoints());
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
    {
      normals->SetTuple(i, data->Normals()[static_cast<std::size_t>(i)].data());
    }
    this->RestNormals = normals;
    this->NormalsSeen = ofMesh;
  }
  vtkPolyData* weights = this->MaskedWeights();
  const StepKey key({ WholeKey(weights) }, {});
  if (this->Weighted->GetNumberOfPoints() == 0 || this->WeightedSeen != key)
  {
    this->Weighted->ShallowCopy(weights);
    this->Weighted->GetPointData()->SetNormals(this->RestNormals);
    this->WeightedSeen = key;
  }
}

void vtkOversketchEdit::Pipeline::RunDeform()
{
  this->AddNormals();
  if (!this->HasProfile() || this->HandlesInput->GetNumberOfPoints() > 0)
  {
    this->Self->RunStage("Handles");
  }
  if (this->HasProfile())
  {
    this->Self->RunStage("Planes");
    this->Self->RunStage("Section");
    this->RunProfile();
  }
  this->Self->RunStage(this->DeformName());
}

void vtkOversketchEdit::Pipeline::RunToWeights(const Inputs& inputs)
{
  this->SetParameters();
  this->RunGround(inputs.Reference, inputs.Boundary);
  this->RunReference(inputs.Reference);
  this->RunEnclosed(inputs.Boundary);
  this->RunRegion();
  this->RunWeights();
}

int vtkOversketchEdit::Pipeline::Moved()
{
  return this->HasProfile() ? this->Bend->GetMovedPoints() : this->Deform->GetMovedPoints();
}

std::shared_ptr<const Motion> vtkOversketchEdit::Pipeline::FindMotion()
{
  vtkPolyData* mesh = this->MaskedWeights();
  const bool isLinear = this->Self->AsPublished || this->Self->Falloff == Linear;
  WeightOfShare weight;
  if (!this->HasImage)
  {
    weight = [layers = oversketch::Layers(this->Self->Levels, layerList(this->Self->Layers).handles),
               falloff = isLinear ? oversketch::Falloff::Linear : oversketch::Falloff::Smooth](double share)
    { return layers.weight(share, falloff); };
  }
  std::vector<double> numbers{ this->HasImage ? 1.0 : 0.0,
    isLinear ? 1.0 : 0.0,
    this->HasProfile() ? 1.0 : 0.0,
    this->Self->UseTexture ? 1.0 : 0.0 };
  AddText(numbers, this->Self->Layers);
  vtkPolyData* handles = this->Self->StageOutput("Handles");
  const bool limits = this->HandlesInput->GetNumberOfPoints() > 0;
  std::vector<MeshKey> inputs{ WholeKey(mesh) };
  if (!this->HasProfile() || limits)
  {
    inputs.push_back(WholeKey(handles));
  }
  if (this->HasProfile())
  {
    inputs.push_back(WholeKey(this->Self->StageOutput("Section")));
    inputs.push_back(WholeKey(this->DrawnProfile));
  }
  const StepKey key(inputs, numbers);
  if (!this->Motion || this->MotionSeen != key)
  {
    this->Motion =
      std::make_shared<const oversketch::Motion>(this->HasProfile() ? MotionOfProfile(mesh,
                                                                        this->Boundary.Made.Stored,
                                                                        this->Self->StageOutput("Section"),
                                                                        this->DrawnProfile,
                                                                        limits ? handles : nullptr,
                                                                        this->Self->UseTexture,
                                                                        weight)
                                                                    : MotionOfHandles(mesh, handles, weight));
    this->MotionSeen = key;
  }
  return this->Motion;
}

void vtkOversketchEdit::Pipeline::RunTriangles()
{
  if (!this->Retriangulates() || this->Moved() == 0)
  {
    return;
  }
  const bool isByEdit = this->Retriangulate->GetRule() == vtkOversketchRetriangulate::Edit;
  this->Retriangulate->SetMotion(isByEdit ? this->FindMotion() : nullptr);
  vtkPolyData* moved = this->Self->StageOutput(this->DeformName());
  const StepKey key({ WholeKey(moved) }, {});
  if (this->Bare->GetNumberOfPoints() == 0 || this->BareSeen != key)
  {
    this->Bare->ShallowCopy(moved);
    this->Bare->GetPointData()->SetNormals(nullptr);
    this->Bare->GetPointData()->RemoveArray(this->RestNormals->GetName());
    this->BareSeen = key;
  }
  this->Retriangulate->SetRestConnection(
    this->HasImage ? this->Texture->GetOutputPort() : this->Shading->GetOutputPort());
  this->Self->RunStage("Retriangulate");
}
