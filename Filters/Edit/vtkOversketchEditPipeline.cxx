#include "vtkOversketchEditPipeline.h"

#include "Shading/layer_list.h"
#include "vtkOversketchEditCurves.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchHierarchy.h"
#include "vtkOversketchSources.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchToldRetriangulate);

void vtkOversketchToldRetriangulate::Tell(std::shared_ptr<const Motion> motion)
{
  if (motion != this->Known)
  {
    this->Known = std::move(motion);
    this->Modified();
  }
}

vtkOversketchEdit::Pipeline::Pipeline(vtkOversketchEdit* self)
  : Self(self)
{
  this->MeanEdge->SetInputData(0, this->Start);
  this->ReferenceFit->SetInputData(0, this->ReferenceInput);
  this->ReferenceProject->SetInputConnection(0, this->ReferenceFit->GetOutputPort());
  this->ReferenceProject->SetMeshConnection(this->MeanEdge->GetOutputPort());
  this->ReferenceInsert->SetInputConnection(0, this->MeanEdge->GetOutputPort());
  this->BoundaryFit->SetInputData(0, this->BoundaryInput);
  this->BoundaryFit->ClosedOn();
  this->BoundaryProject->SetInputConnection(0, this->BoundaryFit->GetOutputPort());
  this->BoundaryProject->SetMeshConnection(this->ReferenceInsert->GetOutputPort());
  this->BoundaryInsert->SetInputConnection(0, this->ReferenceInsert->GetOutputPort());
  this->BoundaryInsert->SetStoredConnection(this->ReferenceInsert->GetOutputPort(1));

  vtkAlgorithmOutput* mesh = this->BoundaryInsert->GetOutputPort();
  vtkAlgorithmOutput* boundary = this->BoundaryInsert->GetOutputPort(1);
  vtkAlgorithmOutput* reference = this->BoundaryInsert->GetOutputPort(2);
  this->Enclose->SetInputConnection(0, mesh);
  this->Enclose->SetReferenceConnection(reference);
  this->Enclose->SetBoundaryConnection(boundary);
  this->Flatten->SetInputConnection(0, this->Enclose->GetOutputPort());
  this->Flatten->SetReferenceConnection(reference);
  this->Distance->SetInputConnection(0, this->Flatten->GetOutputPort());
  this->Distance->SetReferenceConnection(reference);
  vtkAlgorithmOutput* region = this->Distance->GetOutputPort();
  this->Areas->SetInputData(0, this->AreasInput);
  this->Shading->SetInputConnection(0, region);
  this->Shading->SetDiscConnection(this->Flatten->GetOutputPort(1));
  this->Texture->SetInputConnection(0, region);
  this->Texture->SetImageData(this->ImageInput);
  this->Handles->SetInputConnection(0, region);
  this->Handles->SetReferenceConnection(reference);
  this->Deform->SetHandlesConnection(this->Handles->GetOutputPort());
  this->Planes->SetInputConnection(0, region);
  this->Planes->SetReferenceConnection(reference);
  this->Section->SetInputConnection(0, region);
  this->Section->SetBoundaryConnection(boundary);
  this->Section->SetPlanesConnection(this->Planes->GetOutputPort());
  this->Redraw->SetInputConnection(0, this->Section->GetOutputPort());
  this->Redraw->SetStrokeData(this->DrawnInput);
  this->Bend->SetReferenceConnection(reference);
  this->Bend->SetProfileConnection(this->Section->GetOutputPort());
  this->Bend->SetDrawnConnection(this->Redraw->GetOutputPort());
  this->Retriangulate->SetReferenceConnection(reference);
  this->Retriangulate->SetBoundaryConnection(boundary);

  self->AddStage("MeanEdge", this->MeanEdge, 0.01);
  self->AddStage("ReferenceFit", this->ReferenceFit, 0.01);
  self->AddStage("ReferenceProject", this->ReferenceProject, 0.08);
  self->AddStage("ReferenceInsert", this->ReferenceInsert, 0.08);
  self->AddStage("BoundaryFit", this->BoundaryFit, 0.01);
  self->AddStage("BoundaryProject", this->BoundaryProject, 0.08);
  self->AddStage("BoundaryInsert", this->BoundaryInsert, 0.08);
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
  this->BoundaryFit->SetPeriodic(on);
  this->BoundaryFit->SetCutLoops(on);
  this->ReferenceProject->SetSpacing(on ? 0.0 : 4.0);
  this->BoundaryProject->SetSpacing(on ? 0.0 : 4.0);
  for (vtkOversketchInsertCurve* step : { this->ReferenceInsert.Get(), this->BoundaryInsert.Get() })
  {
    step->SetSnap(on);
    step->SetBridge(on);
    step->SetClean(on);
  }
  this->Flatten->SetAsPublished(!on);
  this->Distance->SetAsPublished(!on);
  this->Shading->SetAsPublished(!on);
  this->Planes->SetFrame(on ? vtkOversketchProfilePlanes::Surface : vtkOversketchProfilePlanes::Fitted);
  this->Section->SetEnds(on ? vtkOversketchCrossSection::Nearest : vtkOversketchCrossSection::Outermost);
  this->Section->SetWalk(on ? vtkOversketchCrossSection::Across : vtkOversketchCrossSection::Centre);
  this->Redraw->SetMiddle(on ? vtkOversketchResketch::ArcLength : vtkOversketchResketch::Closest);
  this->Redraw->SetRawTangents(!on);
}

void vtkOversketchEdit::Pipeline::SetParameters()
{
  const vtkOversketchEdit* self = this->Self;
  this->Shading->SetLevels(self->Levels);
  this->Shading->SetLayers(self->GetLayers());
  this->Shading->SetFalloff(self->Falloff);
  this->Shading->SetFeather(self->Feather);
  this->Handles->SetOperations(self->GetOperations());
  this->Planes->SetT(self->ProfileAt);
  this->Bend->SetUseTexture(self->UseTexture);
  this->Retriangulate->SetRule(self->Rule == Curvature || self->AsPublished
                                 ? vtkOversketchRetriangulate::Curvature
                                 : vtkOversketchRetriangulate::Edit);
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
  if (vtkDataArray* meanEdge = mesh->GetFieldData()->GetArray("MeanEdge"))
  {
    this->Start->GetFieldData()->AddArray(meanEdge);
  }
  this->MeshSeen = key;
}

void vtkOversketchEdit::Pipeline::FeedEdit(vtkPolyData* profile,
  vtkPolyData* areas,
  vtkImageData* image,
  vtkPolyData* handles)
{
  this->Feed(profile, this->ProfileInput);
  this->Feed(areas, this->AreasInput);
  this->Feed(handles, this->HandlesInput);
  this->Feed(image, this->ImageInput);
  this->HasImage = image != nullptr;
  this->Shading->SetAreasConnection(
    this->AreasInput->GetNumberOfPoints() > 0 ? this->Areas->GetOutputPort(1) : nullptr);
  this->Handles->SetHandlesData(
    this->HandlesInput->GetNumberOfPoints() > 0 ? this->HandlesInput.Get() : nullptr);
  this->Bend->SetHandlesConnection(
    this->HandlesInput->GetNumberOfPoints() > 0 ? this->Handles->GetOutputPort() : nullptr);
  if (this->HasProfile())
  {
    if (!this->Self->Operations.empty())
    {
      throw Error(Failure::BadStroke,
        "A profile and operations cannot be in one edit; make them in one after the other.");
    }
    const StepKey key({ WholeKey(this->ProfileInput) }, {});
    if (this->DrawnInput->GetNumberOfPoints() == 0 || this->DrawnSeen != key)
    {
      LayInPlane(this->ProfileInput, this->DrawnInput);
      this->DrawnSeen = key;
    }
  }
}

void vtkOversketchEdit::Pipeline::RunCurve(const std::string& name,
  vtkPolyData* curve,
  vtkPolyData* input,
  vtkPolyData* laid)
{
  const bool isRing = name == "Boundary";
  vtkOversketchInsertCurve* insert = isRing ? this->BoundaryInsert : this->ReferenceInsert;
  vtkOversketchProjectCurve* project = isRing ? this->BoundaryProject : this->ReferenceProject;
  RequireOneCurve(curve, isRing ? "boundary" : "reference");
  if (IsCurveOfEdit(curve))
  {
    vtkPolyData* mesh = this->Self->StageOutput(isRing ? "ReferenceInsert" : "MeanEdge");
    StepKey& seen = isRing ? this->BoundarySeen : this->ReferenceSeen;
    const StepKey key({ WholeKey(curve), MeshKey(mesh) }, {});
    if (laid->GetNumberOfPoints() == 0 || seen != key)
    {
      LayOnMesh(
        curve, mesh, isRing, ContextOf(this->Self, this->Self->GetDone(), this->Self->GetDone()), laid);
      seen = key;
    }
    insert->SetCurvesData(laid);
  }
  else
  {
    this->Feed(curve, input);
    this->Self->RunStage((name + "Fit").c_str());
    this->Self->RunStage((name + "Project").c_str());
    insert->SetCurvesConnection(project->GetOutputPort());
  }
  this->Self->RunStage((name + "Insert").c_str());
}

void vtkOversketchEdit::Pipeline::RunCurves(vtkPolyData* reference, vtkPolyData* boundary)
{
  this->Self->RunStage("MeanEdge");
  this->RunCurve("Reference", reference, this->ReferenceInput, this->ReferenceLaid);
  this->RunCurve("Boundary", boundary, this->BoundaryInput, this->BoundaryLaid);
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
    this->Self->RunStage("Areas");
  }
  this->Self->RunStage(this->WeightName());
}

void vtkOversketchEdit::Pipeline::RunDeform()
{
  vtkAlgorithmOutput* weights =
    this->HasImage ? this->Texture->GetOutputPort() : this->Shading->GetOutputPort();
  if (!this->HasProfile() || this->HandlesInput->GetNumberOfPoints() > 0)
  {
    this->Self->RunStage("Handles");
  }
  if (this->HasProfile())
  {
    this->Bend->SetInputConnection(0, weights);
    for (const char* name : { "Planes", "Section", "Redraw", "Bend" })
    {
      this->Self->RunStage(name);
    }
  }
  else
  {
    this->Deform->SetInputConnection(0, weights);
    this->Self->RunStage("Deform");
  }
}

int vtkOversketchEdit::Pipeline::Moved()
{
  return this->HasProfile() ? this->Bend->GetMovedPoints() : this->Deform->GetMovedPoints();
}

int vtkOversketchEdit::Pipeline::Folded()
{
  return this->HasProfile() ? this->Bend->GetFoldedEdges() : this->Deform->GetFoldedEdges();
}

std::shared_ptr<const Motion> vtkOversketchEdit::Pipeline::FindMotion()
{
  vtkPolyData* mesh = this->Self->StageOutput(this->WeightName());
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
    inputs.push_back(WholeKey(this->Self->StageOutput("Redraw")));
  }
  const StepKey key(inputs, numbers);
  if (!this->Motion || this->MotionSeen != key)
  {
    this->Motion = std::make_shared<const oversketch::Motion>(this->HasProfile()
                                                                ? MotionOfProfile(mesh,
                                                                    this->BoundaryInsert->GetStoredOutput(),
                                                                    this->Self->StageOutput("Section"),
                                                                    this->Self->StageOutput("Redraw"),
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
  const bool isTold = this->Retriangulate->GetRule() == vtkOversketchRetriangulate::Edit;
  this->Retriangulate->Tell(isTold ? this->FindMotion() : nullptr);
  this->Retriangulate->SetInputConnection(
    0, this->HasProfile() ? this->Bend->GetOutputPort() : this->Deform->GetOutputPort());
  this->Retriangulate->SetRestConnection(
    this->HasImage ? this->Texture->GetOutputPort() : this->Shading->GetOutputPort());
  this->Self->RunStage("Retriangulate");
}

namespace
{

// A curve with other numbers for its vertices, by numbers of the mesh that it came from; -1 without them. Of
// moved its places.
void PutCurve(vtkPolyData* curve,
  vtkPolyData* moved,
  const std::vector<vtkIdType>& numbers,
  vtkPolyData* output)
{
  output->ShallowCopy(curve);
  vtkDataArray* before = curve->GetPointData()->GetArray("VertexId");
  vtkNew<vtkIdTypeArray> vertices;
  vertices->SetName("VertexId");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
  {
    const auto vertex = static_cast<vtkIdType>(before->GetComponent(i, 0));
    vertices->InsertNextValue(numbers.empty() ? -1 : numbers[static_cast<std::size_t>(vertex)]);
    points->InsertNextPoint(moved->GetPoint(vertex));
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(vertices);
}

} // namespace

void vtkOversketchEdit::Pipeline::PutOutput(vtkPolyData* mesh,
  vtkPolyData* output,
  vtkPolyData* reference,
  vtkPolyData* boundary)
{
  auto made = std::make_unique<Result>();
  made->MovedPoints = this->Moved();
  made->FoldedEdges = this->Folded();
  made->Bridges = this->BoundaryInsert->GetBridgeCount();
  made->Reference->ShallowCopy(this->BoundaryInsert->GetStoredOutput());
  vtkPolyData* line = this->BoundaryInsert->GetStoredOutput();
  vtkPolyData* ring = this->BoundaryInsert->GetCurvesOutput();
  vtkPolyData* last = this->Self->StageOutput(this->DeformName());
  if (made->MovedPoints == 0)
  {
    output->ShallowCopy(mesh);
    PutCurve(line, last, {}, reference);
    PutCurve(ring, last, {}, boundary);
    made->Moved.assign(static_cast<std::size_t>(output->GetNumberOfPoints()), 0);
  }
  else
  {
    if (this->Retriangulates())
    {
      last = this->Self->StageOutput("Retriangulate");
      line = this->Retriangulate->GetReferenceOutput();
      ring = this->Retriangulate->GetBoundaryOutput();
    }
    vtkNew<vtkPolyData> sourced;
    sourced->ShallowCopy(last);
    const double done = this->Self->GetDone();
    AddSources(this->Start, sourced, ContextOf(this->Self, done, done));
    const std::vector<int> vertices = this->Welding->Transfer(this->Plain, { sourced.Get() }, output);
    output->GetFieldData()->AddArray(last->GetFieldData()->GetArray("MeanEdge"));
    vtkDataArray* region = last->GetPointData()->GetArray("EditRegion");
    std::vector<vtkIdType> numbers(static_cast<std::size_t>(last->GetNumberOfPoints()), -1);
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      vtkIdType& first = numbers[static_cast<std::size_t>(vertices[i])];
      first = first < 0 ? static_cast<vtkIdType>(i) : first;
      made->Moved.push_back(region->GetComponent(vertices[i], 0) == 2.0);
    }
    PutCurve(line, last, numbers, reference);
    PutCurve(ring, last, numbers, boundary);
  }
  made->Output->ShallowCopy(output);
  this->Made = std::move(made);
}

void vtkOversketchEdit::Pipeline::PutRegion(vtkPolyData* region)
{
  vtkPolyData* mesh = this->Made->Output;
  std::vector<vtkIdType> number(this->Made->Moved.size(), -1);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    if (std::any_of(ids->begin(),
          ids->end(),
          [this](vtkIdType id) { return this->Made->Moved[static_cast<std::size_t>(id)] != 0; }))
    {
      triangles->InsertNextCell(3);
      for (const vtkIdType point : *ids)
      {
        vtkIdType& id = number[static_cast<std::size_t>(point)];
        id = id >= 0 ? id : points->InsertNextPoint(mesh->GetPoint(point));
        triangles->InsertCellPoint(id);
      }
    }
  }
  region->SetPoints(points);
  region->SetPolys(triangles);
}
