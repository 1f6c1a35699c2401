// What the inner pipeline of vtkOversketchOneStroke has made of a mesh, judged stage by stage.
#include "vtkOversketchOneStrokePipeline.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <algorithm>

using namespace oversketch;

std::vector<char> vtkOversketchOneStroke::Pipeline::RegionOf(const char* stage)
{
  vtkPolyData* mesh = this->Self->StageOutput(stage);
  return LabelsOf(
    RequireArray(mesh->GetPointData(), "Region", 1, mesh->GetNumberOfPoints(), "mesh", "a step made it"));
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

const MeshPart& vtkOversketchOneStroke::Pipeline::PartOf(const char* stage)
{
  MadeMesh& made = this->Made(stage);
  for (const auto& [name, other] : this->MadeMeshes)
  {
    if (!made.Part && other.Part && other.Data->HasLinksOf(*made.Data))
    {
      made.Part = other.Part; // deformed, with the same region
    }
  }
  if (!made.Part)
  {
    made.Part = std::make_shared<MeshPart>(made.Data->Surface(), this->RegionOf(stage), ThreadsOnly());
  }
  made.Part->place(made.Data->Surface());
  return *made.Part;
}

int vtkOversketchOneStroke::Pipeline::Folds(const char* stage)
{
  MadeMesh& made = this->Made(stage);
  if (!made.Folds)
  {
    const MeshPart& part = this->PartOf(stage);
    made.Folds = foldedEdges(part.mesh, part.adjacency, part.region, ThreadsOnly());
  }
  return *made.Folds;
}

const Roughness& vtkOversketchOneStroke::Pipeline::Rough(const char* stage)
{
  MadeMesh& made = this->Made(stage);
  if (!made.Rough)
  {
    const MeshPart& part = this->PartOf(stage);
    made.Rough = roughness(part.mesh, part.adjacency, part.region, ThreadsOnly());
  }
  return *made.Rough;
}

double vtkOversketchOneStroke::Pipeline::Back(const char* stage)
{
  MadeMesh& made = this->Made(stage);
  if (!made.Back)
  {
    made.Back = backShare(made.Data->Surface(), ViewOf(this->Stroke), ThreadsOnly());
  }
  return *made.Back;
}

double vtkOversketchOneStroke::Pipeline::NewBack(const char* stage)
{
  // Of most results nothing shows its back, and then it does not matter what did before.
  const double after = this->Back(stage);
  return after > 0.0 ? std::max(0.0, after - this->Back("RegionBorder")) : 0.0;
}

int vtkOversketchOneStroke::Pipeline::Crossings(const char* stage)
{
  MadeMesh& made = this->Made(stage);
  if (!made.Crossings)
  {
    const oversketch::Mesh& mesh = made.Data->Surface();
    const std::vector<char> region = this->RegionOf(stage);
    std::vector<char> changed(mesh.triangles.size());
    std::transform(mesh.triangles.begin(),
      mesh.triangles.end(),
      changed.begin(),
      [&region](const Triangle& t) { return region[t[0]] || region[t[1]] || region[t[2]]; });
    made.Crossings = static_cast<int>(crossingFaces(mesh, changed, ThreadsOnly()).size());
  }
  return *made.Crossings;
}

int vtkOversketchOneStroke::Pipeline::NewCrossings(const char* stage)
{
  const int after = this->Crossings(stage);
  return after > 0 ? std::max(0, after - this->Crossings("RegionBorder")) : 0;
}

const std::vector<OutlineLoop>& vtkOversketchOneStroke::Pipeline::Contours(const char* stage)
{
  MadeMesh& made = this->Made(stage);
  vtkDataArray* connection = this->Match->GetOutput()->GetFieldData()->GetArray("Candidate");
  if (!made.Contours && connection && connection->GetComponent(0, 0) == 0.0)
  {
    made.Contours = this->ContoursOf(stage);
  }
  else if (!made.Contours)
  {
    made.Contours.emplace(); // the section is of the outline
  }
  return *made.Contours;
}

std::vector<OutlineLoop> vtkOversketchOneStroke::Pipeline::ContoursOf(const char* stage)
{
  const std::shared_ptr<const MeshData> data = this->Made(stage).Data;
  return regionContours(
    data->Surface(), data->Neighbours(), data->Normals(), this->RegionOf(stage), ViewOf(this->Stroke));
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
  return { *made.OutlineMissed, this->Folds(stage) - foldsBefore };
}

StrokeEffect vtkOversketchOneStroke::Pipeline::EffectOf(const char* before, const char* stage)
{
  const Judgement judged = this->Judged(stage, this->Folds("RegionBorder"));
  StrokeEffect effect;
  effect.outline = judged.outline;
  effect.folds = judged.folds;
  effect.after = this->Rough(stage);
  effect.before = this->Rough("RegionBorder");
  effect.remeshed = this->Self->Remeshed;
  const oversketch::View view = ViewOf(this->Stroke);
  const Polyline stroke = StrokeOf(this->Match->GetOutput(1));
  vtkPolyData* match = this->Self->StageOutput("Match");
  Polyline section(static_cast<std::size_t>(match->GetNumberOfPoints()));
  vtkDataArray* displays = match->GetPointData()->GetArray("Display");
  for (std::size_t i = 0; displays && i < section.size(); ++i)
  {
    displays->GetTuple(static_cast<vtkIdType>(i), section[i].data());
  }
  effect.outlineBack = outlineBack(this->OutlineOf(stage), this->Contours(stage));
  if (!remarks(effect).empty())
  {
    // A limb before another part of the model makes no outline there; its own silhouette is what was drawn.
    const std::vector<OutlineLoop> own = this->ContoursOf(stage);
    effect.outline = outlineError(this->OutlineOf(stage), own);
    effect.outlineBack = std::min(effect.outlineBack, outlineBack(this->OutlineOf(stage), own));
  }
  measureMovement(this->Made(before).Data->Surface(),
    this->Made(this->Deformation).Data->Surface(),
    this->RegionOf(before),
    view,
    stroke,
    section,
    effect,
    ThreadsOnly());
  return effect;
}

double vtkOversketchOneStroke::Pipeline::Missed(const StrokeEffect& effect)
{
  // The match makes another stroke of one that was closed.
  if (this->Match->GetOutput(1)->GetPoints() == this->Self->StageOutput("Stroke")->GetPoints())
  {
    return effect.outline.worst;
  }
  return missedBeside(this->OutlineOf(this->Self->Remeshed ? "Restore" : this->Deformation));
}
